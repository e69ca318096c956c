//! Whether a scanner can have stood where the file or the user says.
//!
//! Merged clouds are saved with the scanner at zero. Every beam from there would prove the space in front of its return
//! empty, and standing objects would come out absent. From a true position hardly any beam passes through a gap between
//! returns that are much nearer; from a wrong one very many do.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::Beam;

use super::passing::{Passing, passing};
use super::place::{OriginSource, without_origin};
use crate::{NO_ROTATION, Order, RawScan, ReadOptions};

/// What to make of a scanner at zero without rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum IdentityPose {
    /// As the points themselves tell
    #[default]
    Auto,
    /// A scanner stood there; positions told by files and --origin are believed, too
    Scanner,
    /// A merged cloud: no scanner stood there
    Merged,
}

/// No scanner ranges farther, metres: points beyond this have been given a position that is not theirs.
const MAX_RANGE_M: f64 = 50_000.0;
/// Share of beams that pass between nearer returns: for true stations (real-room, hall, pavilion) at most 0.6 %, for
/// the same stations merged 7.5 to 21 %.
const SUSPICIOUS: f64 = 0.02;
/// The same where returns lie within 10 cm of one another, which those of a sample of a large site do not: for true
/// stations at most 2.2 % (real-room), for eight merged stations 24 % on a site of 50 m, 13 % on one of 100 m, 3.3 % on
/// one of 200 m.
const SUSPICIOUS_CLOSE: f64 = 0.03;
/// Beyond this, even a position that was given explicitly is not believed. Trees cause a few per cent, and so does a
/// tilting scanner whose centre moves (OctoMap's own: 5.1 %).
const WRONG: f64 = 0.07;
const WRONG_CLOSE: f64 = 0.15;
/// If a scanner at zero is farther from its returns than this many times their extent, they are in another frame.
const REMOTE: f64 = 3.0;
/// The extent counts as at least this, metres: a single object may be scanned from some way off.
const NARROW_M: f64 = 10.0;
/// Most returns that are examined for this.
const MAX_COMPARED: usize = 10_000;

/// The scan as far as it can be believed: without origin where no scanner can have stood there.
pub fn judged(scan: RawScan, options: &ReadOptions) -> RawScan {
    let scan = without_far(scan);
    let Some(rotation) = scan.world_from_scan else { return without_strays(scan) };
    let is_given = options.origin.is_some() || scan.origin_source != Some(OriginSource::File);
    let is_identity = !is_given && scan.anchor == Vec3::zeros() && is_none(rotation);
    if is_identity && scan.order == Order::List && options.identity_pose == IdentityPose::Auto {
        return points(scan, "a list without rows and columns, as merged clouds are written".into());
    }
    match (options.identity_pose, is_identity) {
        (IdentityPose::Scanner, _) => return scan,
        (IdentityPose::Merged, true) => {
            return points(scan, "taken for a merged cloud (--identity-pose merged)".into());
        }
        _ => {}
    }
    if is_identity && is_remote(&scan.content.beams) {
        return points(scan, "its points are far from zero, where its scanner would have stood: in coordinates of their own, not the scanner's".into());
    }
    let (share, limit, wrong) = match passing(&scan.content.beams) {
        Passing::Echoes => return scan,
        Passing::Shares { overall, .. } if overall > SUSPICIOUS => (overall, SUSPICIOUS, WRONG),
        Passing::Shares { close, .. } => (close, SUSPICIOUS_CLOSE, WRONG_CLOSE),
        // What the file does not claim outright is not believed untried.
        Passing::Unknown if is_identity && scan.order != Order::Measured => {
            let why = "its points lie too far apart to tell whether a scanner stood at zero or the cloud is merged";
            return points(scan, why.into());
        }
        Passing::Unknown => return scan,
    };
    let passing = Doubt { share, limit, wrong };
    passing.held_against(scan, is_identity)
}

/// How many beams pass through nearer surfaces, and how many may: before there is a doubt, and before it is certain.
struct Doubt {
    share: f64,
    limit: f64,
    wrong: f64,
}

impl Doubt {
    fn held_against(&self, scan: RawScan, is_identity: bool) -> RawScan {
        let Self { share, limit, wrong } = *self;
        let percent = share * 100.0;
        let beams = "of the beams from there pass through nearer surfaces";
        if is_identity && share > limit {
            let why = format!("a merged cloud: no scanner stood at zero, {percent:.1} % {beams}");
            return points(scan, why);
        }
        // Nobody says so but the points: no doubt is allowed.
        if scan.origin_source == Some(OriginSource::Recovered) && share > limit {
            return points(scan, format!("the position recovered is none: {percent:.1} % {beams}"));
        }
        if share > wrong {
            return points(scan, format!("no scanner stood at the position told: {percent:.1} % {beams}"));
        }
        let mut scan = scan;
        if share > limit {
            scan.notes.push(format!("{percent:.1} % of the beams pass between nearer returns: trees and fences do that, and a position that is a little wrong"));
        }
        scan
    }
}

fn is_none(rotation: [f64; 4]) -> bool {
    rotation.iter().zip(NO_ROTATION).all(|(a, b)| (a.abs() - b).abs() < 1e-12)
}

/// The scan without points that are impossibly far away; where most are, they have no origin.
fn without_far(mut scan: RawScan) -> RawScan {
    let is_far = |b: &Beam| b.returned && b.offset.norm() > MAX_RANGE_M;
    let far = scan.content.beams.iter().filter(|b| is_far(b)).count();
    if far == 0 || scan.world_from_scan.is_none() {
        return scan;
    }
    if 2 * far > scan.content.len() {
        let why =
            "its points lie more than 50 km from the position told, which moved them if they are in another frame";
        return points(scan, why.into());
    }
    scan.retain(|b| !is_far(b));
    scan.unusable += far as u64;
    scan
}

/// Points without origin, except for the few that are impossibly far from all others; they are relative to the median
/// point.
fn without_strays(mut scan: RawScan) -> RawScan {
    let every = scan.content.len().div_ceil(MAX_COMPARED).max(1);
    let middle = [0, 1, 2].map(|k| {
        let mut along: Vec<f64> = scan.content.beams.iter().step_by(every).map(|b| b.offset[k]).collect();
        let half = along.len() / 2;
        if along.is_empty() { 0.0 } else { *along.select_nth_unstable_by(half, f64::total_cmp).1 }
    });
    let middle = Vec3::from(middle).map(f64::round);
    let is_far = |b: &Beam| (b.offset - middle).norm() > MAX_RANGE_M;
    let far = scan.content.beams.iter().filter(|b| is_far(b)).count();
    if far == 0 || 2 * far > scan.content.len() {
        return scan;
    }
    scan.retain(|b| !is_far(b));
    scan.unusable += far as u64;
    scan.notes.push(format!("{far} points lie more than 50 km from the others, and were dropped"));
    scan.content.beams.iter_mut().for_each(|b| b.offset -= middle);
    scan.anchor += middle;
    scan
}

/// The scan's points without origin, and why.
fn points(scan: RawScan, why: String) -> RawScan {
    let mut scan = without_origin(scan);
    scan.notes.push(format!("{why}; loaded as points without origin (--identity-pose scanner believes the position)"));
    without_strays(scan)
}

/// Whether nearly all returns lie far away in a narrow cone: no scanner is set up like that.
fn is_remote(beams: &[Beam]) -> bool {
    // Strays on either side do not count.
    const STRAYS: f64 = 0.02;
    let every = beams.iter().filter(|b| b.returned).count().div_ceil(MAX_COMPARED).max(1);
    let some: Vec<Vec3> = beams.iter().filter(|b| b.returned).step_by(every).map(|b| b.offset).collect();
    let part = |values: &mut Vec<f64>, part: f64| {
        let at = (part * (values.len() - 1) as f64).round() as usize;
        *values.select_nth_unstable_by(at, f64::total_cmp).1
    };
    if some.is_empty() {
        return false;
    }
    let nearest = part(&mut some.iter().map(|p| p.norm()).collect(), STRAYS);
    let extents = [0, 1, 2].map(|k| {
        let mut along: Vec<f64> = some.iter().map(|p| p[k]).collect();
        part(&mut along, 1.0 - STRAYS) - part(&mut along, STRAYS)
    });
    nearest > REMOTE * Vec3::from(extents).norm().max(NARROW_M)
}

#[cfg(test)]
mod tests {
    use super::*;
    use asbuilt_core::scan::Beams;

    /// Returns from `scanner` on a room of 8 × 6 × 3 m with a column in it, in world coordinates.
    fn room(scanner: Vec3) -> Vec<Vec3> {
        let step = 0.01;
        let directions =
            (-120..120).flat_map(|row| (0..628).map(move |column| (f64::from(row) * step, f64::from(column) * step)));
        directions
            .map(|(el, az)| Vec3::new(el.cos() * az.cos(), el.cos() * az.sin(), el.sin()))
            .map(|d| scanner + d * range(scanner, d))
            .collect()
    }

    fn range(from: Vec3, d: Vec3) -> f64 {
        let (low, high) = (Vec3::new(-4.0, -3.0, -1.5), Vec3::new(4.0, 3.0, 1.5));
        let exit = |i: usize| (if d[i] > 0.0 { high[i] } else { low[i] } - from[i]) / d[i];
        let wall = (0..3).filter(|&i| d[i].abs() > 1e-9).map(exit).fold(f64::INFINITY, f64::min);
        // A column of 0.4 m radius about (1, 1).
        let (o, f) = (Vec3::new(from.x - 1.0, from.y - 1.0, 0.0), Vec3::new(d.x, d.y, 0.0));
        let (a, b, c) = (f.norm_squared(), o.dot(&f), o.norm_squared() - 0.16);
        let root = b * b - a * c;
        let column = if root > 0.0 && b < 0.0 { (-b - root.sqrt()) / a } else { f64::INFINITY };
        wall.min(column)
    }

    fn seen_from(origin: Vec3, world: &[Vec3]) -> RawScan {
        let beams = world.iter().map(|p| Beam { offset: p - origin, returned: true }).collect();
        let content = Beams::of(beams);
        let scan = RawScan { name: "room".into(), anchor: origin, content, ..RawScan::default() };
        RawScan { world_from_scan: Some(NO_ROTATION), origin_source: Some(OriginSource::File), ..scan }
    }

    #[test]
    fn true_stations_are_believed_and_merged_ones_are_not() {
        let (a, b) = (Vec3::new(-1.0, -2.0, 0.2), Vec3::new(2.0, 2.2, 0.0));
        let zero = Vec3::zeros();
        for station in [a, b, zero] {
            let scan = judged(seen_from(station, &room(station)), &ReadOptions::default());
            assert!(scan.world_from_scan.is_some() && scan.notes.is_empty(), "{:?}", scan.notes);
        }
        let merged: Vec<Vec3> = [room(a), room(b)].concat();
        let scan = judged(seen_from(zero, &merged), &ReadOptions::default());
        assert!(scan.world_from_scan.is_none() && scan.notes[0].contains("merged"), "{:?}", scan.notes);
        // The points are where they were.
        let first = scan.anchor + scan.content.beams[0].offset;
        assert!((first - merged[0]).norm() < 1e-9);
        let told = ReadOptions { identity_pose: IdentityPose::Scanner, ..ReadOptions::default() };
        assert!(judged(seen_from(zero, &merged), &told).world_from_scan.is_some());
        // A wrong --origin.
        let given = ReadOptions { origin: Some(a), ..ReadOptions::default() };
        assert!(judged(seen_from(a, &room(b)), &given).world_from_scan.is_none());
    }

    #[test]
    fn echoes_of_a_pulse_are_one_beam() {
        let station = Vec3::new(-1.0, -2.0, 0.2);
        let far = room(station);
        // Every third pulse has an earlier echo on its way, as through leaves.
        let echo = |p: &Vec3| station + (p - station) * 0.6;
        let all: Vec<Vec3> =
            far.iter().enumerate().flat_map(|(i, p)| (i % 3 == 0).then(|| echo(p)).into_iter().chain([*p])).collect();
        assert!(judged(seen_from(station, &all), &ReadOptions::default()).world_from_scan.is_some());
    }

    #[test]
    fn a_cloud_far_from_zero_has_no_scanner_there() {
        let world: Vec<Vec3> = (0..60)
            .map(|i| Vec3::new(1001.5, 2004.0 + f64::from(i % 8) * 0.4, 99.0 + f64::from(i / 8) * 0.4))
            .collect();
        let scan = judged(seen_from(Vec3::zeros(), &world), &ReadOptions::default());
        assert!(scan.world_from_scan.is_none());
        let scan = judged(seen_from(Vec3::new(1000.0, 2004.0, 100.0), &world), &ReadOptions::default());
        assert!(scan.world_from_scan.is_some());
    }
}
