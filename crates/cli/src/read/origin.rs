//! Whether a scanner can have stood where the file or the user says.
//!
//! Merged clouds are saved with the scanner at zero. Every beam from there would prove the space before it empty,
//! and standing objects come out absent. From a true position hardly a beam passes through a gap between the
//! returns around it that are much nearer; from a wrong one very many do.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::Beam;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::{NO_ROTATION, RawScan, ReadOptions};

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

/// No scanner ranges farther, metres: points beyond it carry a position that is not theirs.
const MAX_RANGE_M: f64 = 50_000.0;
/// Share of beams that pass between nearer returns: of true stations (real-room, hall, pavilion) at most 0.6 %, of the
/// same merged 7.5 to 21 %.
const SUSPICIOUS: f64 = 0.02;
/// From here on a position that was told is not believed either. Trees give some per cent, and a tilting scanner whose
/// centre moves does (OctoMap's own: 5.1 %).
const WRONG: f64 = 0.07;
/// Returns that a scanner at zero is farther from than so many times their own extent are in another frame.
const REMOTE: f64 = 10.0;

/// The scan as it may be believed: without origin where no scanner can have stood there.
pub fn judged(scan: RawScan, options: &ReadOptions) -> RawScan {
    let scan = without_far(scan, options);
    let Some(rotation) = scan.world_from_scan else { return scan };
    let is_identity = options.origin.is_none() && scan.anchor == Vec3::zeros() && is_none(rotation);
    if is_identity && scan.is_list && options.identity_pose == IdentityPose::Auto {
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
    let share = passing_share(&scan.content.beams).unwrap_or(0.0);
    let percent = share * 100.0;
    if is_identity && share > SUSPICIOUS {
        return points(
            scan,
            format!(
                "a merged cloud: {percent:.1} % of the beams from zero, where its scanner would have stood, pass through nearer surfaces"
            ),
        );
    }
    if share > WRONG {
        return points(
            scan,
            format!(
                "no scanner stood at the position told: {percent:.1} % of the beams from there pass through nearer surfaces"
            ),
        );
    }
    let mut scan = scan;
    if share > SUSPICIOUS {
        scan.notes.push(format!("{percent:.1} % of the beams pass between nearer returns: trees and fences do that, and a position that is a little wrong"));
    }
    scan
}

fn is_none(rotation: [f64; 4]) -> bool {
    rotation.iter().zip(NO_ROTATION).all(|(a, b)| (a.abs() - b).abs() < 1e-12)
}

/// Without the points that lie impossibly far; where most do, they have no origin.
fn without_far(mut scan: RawScan, options: &ReadOptions) -> RawScan {
    let is_far = |b: &Beam| b.returned && b.offset.norm() > MAX_RANGE_M;
    let far = scan.content.beams.iter().filter(|b| is_far(b)).count();
    if far == 0 || scan.world_from_scan.is_none() {
        return scan;
    }
    if options.origin.is_none() && 2 * far > scan.content.len() {
        return points(scan, "its points lie impossibly far from the position told".into());
    }
    scan.retain(|b| !is_far(b));
    scan.unusable += far as u64;
    scan
}

/// The scan's points without origin, and why.
fn points(mut scan: RawScan, why: String) -> RawScan {
    scan.retain(|b| b.returned);
    let shift = scan.content.beams.first().map_or_else(Vec3::zeros, |b| b.offset.map(f64::round));
    scan.anchor += shift;
    scan.content.beams.iter_mut().for_each(|b| b.offset -= shift);
    scan.world_from_scan = None;
    scan.notes.push(format!("{why}; loaded as points without origin (--identity-pose scanner believes the position)"));
    scan
}

/// Whether all returns lie in a narrow direction, far away: no scanner is set up like that.
fn is_remote(beams: &[Beam]) -> bool {
    let mut returns = beams.iter().filter(|b| b.returned).map(|b| b.offset).peekable();
    let Some(first) = returns.peek().copied() else { return false };
    let (mut low, mut high, mut nearest) = (first, first, f64::INFINITY);
    for p in returns {
        (low, high, nearest) = (low.inf(&p), high.sup(&p), nearest.min(p.norm()));
    }
    nearest > REMOTE * (high - low).norm().max(1.0)
}

/// Returns that are compared, beams that are tried, neighbours of each.
const COMPARED: usize = 100_000;
const TRIED: usize = 2000;
const NEIGHBOURS: usize = 16;
/// Fewer tell nothing.
const LEAST: usize = 200;
/// A beam passes a return that is nearer than this to it, metres.
const BESIDE_M: f64 = 0.1;
/// Returns closer to a beam than this are echoes of its own pulse, metres.
const SAME_PULSE_M: f64 = 0.002;
/// Nearer than this the scanner sees itself, metres.
const OWN_PLATFORM_M: f64 = 0.3;

type Direction = GeomWithData<[f64; 3], f64>;

/// Share of the beams that pass between much nearer returns on all sides of them; `None` where there are too few.
///
/// Over a surface seen from a true position the range is a function of direction: at its edges the nearer returns
/// lie to one side, and in its hollows they are nearer by little.
fn passing_share(beams: &[Beam]) -> Option<f64> {
    // A scan without many returns gives fewer.
    let some: Vec<Direction> = scattered(beams.len(), COMPARED)
        .filter_map(|i| range(&beams[i]).map(|range| GeomWithData::new((beams[i].offset / range).into(), range)))
        .collect();
    if some.len() < LEAST || are_echoes(beams) {
        return None;
    }
    let tried: Vec<Direction> = scattered(some.len(), TRIED).map(|i| some[i]).collect();
    let tree = RTree::bulk_load(some);
    let (mut counted, mut passing) = (0, 0);
    for beam in &tried {
        if let Some(passes) = passes(&tree, beam) {
            counted += 1;
            passing += u32::from(passes);
        }
    }
    (counted > 0).then(|| f64::from(passing) / f64::from(counted))
}

/// Of a return that is not the scanner itself.
fn range(beam: &Beam) -> Option<f64> {
    let range = beam.offset.norm();
    (beam.returned && range > OWN_PLATFORM_M).then_some(range)
}

/// Whether returns that follow one another lie on one beam, as the echoes of a pulse do: only seen from where the
/// scanner stood. By chance three times as many would lie in the ring about it.
fn are_echoes(beams: &[Beam]) -> bool {
    let (mut pairs, mut on_beam, mut beside_it) = (0, 0, 0);
    for i in scattered(beams.len() - 1, COMPARED) {
        let (Some(a), Some(b)) = (range(&beams[i]), range(&beams[i + 1])) else { continue };
        pairs += 1;
        if a.min(b) >= 0.95 * a.max(b) - 0.05 {
            continue;
        }
        let apart = (beams[i].offset / a - beams[i + 1].offset / b).norm() * a.min(b);
        on_beam += usize::from(apart < SAME_PULSE_M);
        beside_it += usize::from((SAME_PULSE_M..2.0 * SAME_PULSE_M).contains(&apart));
    }
    on_beam * 100 > pairs && on_beam > 2 * beside_it
}

/// Whether a beam passes between nearer returns; `None` for the later echoes of a pulse.
fn passes(tree: &RTree<Direction>, beam: &Direction) -> Option<bool> {
    let (direction, range) = (Vec3::from(*beam.geom()), beam.data);
    let aside = if direction.z.abs() < 0.9 { Vec3::z() } else { Vec3::x() };
    let u = direction.cross(&aside).normalize();
    let v = direction.cross(&u);
    let mut headings = Vec::with_capacity(NEIGHBOURS);
    for other in tree.nearest_neighbor_iter(*beam.geom()).take(NEIGHBOURS + 1) {
        let offset = Vec3::from(*other.geom()) - direction;
        let beside = offset.norm() * other.data;
        if other.data >= 0.95 * range - 0.05 || beside > BESIDE_M {
            continue;
        }
        if beside < SAME_PULSE_M {
            return None;
        }
        headings.push(offset.dot(&v).atan2(offset.dot(&u)));
    }
    Some(surround(&mut headings))
}

/// Whether directions in a plane leave no half of it free.
fn surround(headings: &mut [f64]) -> bool {
    use std::f64::consts::{PI, TAU};
    if headings.len() < 3 {
        return false;
    }
    headings.sort_by(f64::total_cmp);
    let around = headings[0] + TAU - headings[headings.len() - 1];
    headings.windows(2).map(|w| w[1] - w[0]).fold(around, f64::max) < PI
}

/// At most `wanted` of `len` places, scattered so that no grid shows in them.
fn scattered(len: usize, wanted: usize) -> impl Iterator<Item = usize> {
    let every = (len as f64 / wanted as f64).max(1.0);
    let count = if every > 1.0 { wanted } else { len };
    (0..count).map(move |i| {
        // Fibonacci hashing (Knuth 1973, 6.4): an even sequence without a period.
        let jitter = (i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40;
        let within = if every > 1.0 { jitter as f64 / (1u64 << 24) as f64 } else { 0.0 };
        (((i as f64 + within) * every) as usize).min(len - 1)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::Facts;
    use asbuilt_core::scan::Content;

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
        RawScan {
            name: "room".into(),
            sensor: None,
            world_from_scan: Some(NO_ROTATION),
            anchor: origin,
            content: Content::of(beams),
            unusable: 0,
            is_list: false,
            notes: Vec::new(),
            facts: Facts::new(),
        }
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
