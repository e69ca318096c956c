//! The scanner's place, where the points prove it.

use nalgebra::Vector2;

use super::axis::{self, Axis, AxisFit, ScanLine};
use super::chords::first_axis;
use super::height::{self, HeightFit};
use super::jackknife::deviation;
use super::lines::{cut, rising_share, share_in_lines};
use super::sequence::Sequence;
use crate::geometry::Vec3;
use crate::num::scatter::scattered;
use crate::num::stats::median;
use crate::scan::Beam;

/// Fewer points tell nothing.
const MIN_POINTS: usize = 5000;
/// Fewer lines have no axis.
const MIN_LINES: usize = 60;
/// The most points that are fitted: of more, some lines.
const MAX_FITTED: usize = 3_000_000;
/// A line is proven to be measured from the place if such a share of its points lies in its plane, and it is even.
const MIN_IN_PLANE: f64 = 0.9;
/// And if such a share of its pairs is even: the lines of another place, where they see walls alone, lie in planes, too.
const MIN_EVEN: f64 = 0.5;
/// Share of the points in proven lines: of whole simulated scans at least 0.998. A second station of more is noticed.
const MIN_PROVEN: f64 = 0.99;
/// The planes of lines are known at least so well.
const MAX_SPREAD: f64 = 2e-3;
/// Share of the pairs between which no point is missing: where most are so, the others stand out and count for nothing.
const MIN_EXACT: f64 = 0.6;
/// An axis that leans more to a metre is no tripod's (3°).
const MAX_LEAN: f64 = 0.05;
/// No place is known better than this: a mirror does not turn exactly in its axis.
const MIN_SD_M: f64 = 1e-3;

/// Where a scanner stood.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecoveredOrigin {
    /// World metres.
    pub position_world: Vec3,
    /// Standard deviation along each axis, of the worst, metres.
    pub sd: f64,
}

/// Why no place is claimed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NotRecovered {
    /// Too few points to tell.
    #[error("{0} points are too few to tell")]
    TooFewPoints(usize),
    /// Points that follow each other do not lie in planes through one standing line.
    #[error("its points are not in the order of one scanner's lines: sorted, thinned, merged, or not from a tripod")]
    NoScanLines,
    /// Too many points are in no scan line that was measured from the same place as the others.
    #[error("{:.1} % of its points are in no scan line from the place of the others: merged, or thinned", 100.0 * .0)]
    OtherPlaces(f64),
    /// The steps along scan lines are no equal angles from anywhere.
    #[error("only {:.0} % of the steps along its scan lines are equal angles: points were taken out, or rounded", 100.0 * .0)]
    UnevenSteps(f64),
}

/// Seeks the place (world metres) from which points without origin were measured: beams from `anchor_world`, in the order
/// of measurement.
pub fn recover(anchor_world: &Vec3, beams: &[Beam]) -> Result<RecoveredOrigin, NotRecovered> {
    if beams.len() < MIN_POINTS {
        return Err(NotRecovered::TooFewPoints(beams.len()));
    }
    let points = Sequence::new(beams);
    let place = first_axis(points).ok_or(NotRecovered::NoScanLines)?;
    let mut heights: Vec<f64> = scattered(points.len(), 10_000).map(|i| points.point(i).z).collect();
    let middle = median(&mut heights).ok_or(NotRecovered::NoScanLines)?;
    let mut centre = Vec3::new(place.x, place.y, middle);
    let points = upward(points, &centre);
    // The second time the lines are cut from where the scanner stood.
    for round in 0..2 {
        let found = located(points, &centre, round == 1)?;
        centre = found.0;
        if let Some(sd) = found.1 {
            return Ok(RecoveredOrigin { position_world: anchor_world + centre, sd });
        }
    }
    Err(NotRecovered::NoScanLines)
}

/// The order in which scan lines go upward.
fn upward<'a>(points: Sequence<'a>, centre: &Vec3) -> Sequence<'a> {
    let other = points.reversed();
    if rising_share(other, centre) > rising_share(points, centre) { other } else { points }
}

/// The place, and where asked for a proof its standard deviation.
fn located(points: Sequence, centre: &Vec3, is_proof: bool) -> Result<(Vec3, Option<f64>), NotRecovered> {
    let ranges = cut(points, centre);
    let in_lines = share_in_lines(points, &ranges);
    if ranges.len() < MIN_LINES || in_lines < 0.5 {
        return Err(NotRecovered::NoScanLines);
    }
    let some = ranges.into_iter().step_by(points.len().div_ceil(MAX_FITTED));
    let mut lines: Vec<ScanLine> = some.map(|r| ScanLine::new(points, r, &centre.xy())).collect();
    let start = Axis { at: *centre, lean: Vector2::zeros() };
    let axis = axis::fit(points, &mut lines, start).ok_or(NotRecovered::NoScanLines)?;
    if axis.spread > MAX_SPREAD || axis.axis.lean.norm() > MAX_LEAN {
        return Err(NotRecovered::NoScanLines);
    }
    let height = height::fit(points, &lines, &axis.axis).ok_or(NotRecovered::UnevenSteps(0.0))?;
    let place = on_axis(&axis.axis, height.height);
    if !is_proof {
        return Ok((place, None));
    }
    if height.exact_share < MIN_EXACT {
        return Err(NotRecovered::UnevenSteps(height.exact_share));
    }
    let proven = in_lines * proven_share(&lines, &axis, &height);
    if proven < MIN_PROVEN {
        return Err(NotRecovered::OtherPlaces(1.0 - proven));
    }
    Ok((place, Some(place_deviation(&axis, &height))))
}

/// The share of the points of lines in those that are proven.
fn proven_share(lines: &[ScanLine], axis: &AxisFit, height: &HeightFit) -> f64 {
    let is_proven = |k: usize| axis.in_plane[k] >= MIN_IN_PLANE && height.even[k] >= MIN_EVEN;
    let all: usize = lines.iter().map(|l| l.points.len()).sum();
    let proven: usize = (0..lines.len()).filter(|k| is_proven(*k)).map(|k| lines[k].points.len()).sum();
    proven as f64 / all.max(1) as f64
}

fn on_axis(axis: &Axis, height: f64) -> Vec3 {
    axis.at + axis.up() * height
}

fn place_deviation(axis: &AxisFit, height: &HeightFit) -> f64 {
    let places: Vec<Vec3> = axis.without_each.iter().zip(&height.without_each).map(|(a, h)| on_axis(a, *h)).collect();
    (0..3).map(|k| deviation(places.iter().map(move |p| p[k]))).fold(MIN_SD_M, f64::max)
}
