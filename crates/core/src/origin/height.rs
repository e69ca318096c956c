//! The place on the axis from which the points of a scan line follow each other by equal angles.

use std::f64::consts::PI;

use nalgebra::{Matrix2, Vector2};

use super::axis::{Axis, ScanLine};
use super::jackknife::Grouped;
use super::sequence::Sequence;
use crate::geometry::Vec3;
use crate::num::scatter::scattered;
use crate::num::stats::{median, median_and_spread, tukey};

/// Between the points of a pair there is such a part of a line.
const PARTS_OF_LINE: usize = 16;
/// But no more steps: coordinates are rounded, but points may be missing.
const MAX_LAG: usize = 24;
/// Pairs by which a height is sought.
const SOUGHT: usize = 4000;
/// Most pairs in all.
const MAX_PAIRS: usize = 400_000;
/// Heights that are tried first.
const PLACES: usize = 300;
/// Rounds of trying nearer ones.
const HALVINGS: usize = 24;
/// Most rounds of fitting the height.
const ROUNDS: usize = 20;
/// Between the points of an even pair there are as many steps as there should be, to this share.
const EVEN: f64 = 0.05;

/// Two points of a line in its plane: metres along it and up the axis.
#[derive(Clone, Copy)]
struct Pair {
    line: usize,
    from: Vector2<f64>,
    to: Vector2<f64>,
}

impl Pair {
    /// The angle between them, seen from a height on the axis.
    fn angle(&self, height: f64) -> f64 {
        let seen = |p: &Vector2<f64>| (p.y - height).atan2(p.x);
        let angle = seen(&self.to) - seen(&self.from);
        if angle < -PI {
            angle + 2.0 * PI
        } else if angle > PI {
            angle - 2.0 * PI
        } else {
            angle
        }
    }

    /// How the angle changes with the height, radians a metre.
    fn slope(&self, height: f64) -> f64 {
        let slope = |p: &Vector2<f64>| -p.x / (p.x * p.x + (p.y - height).powi(2)).max(1e-6);
        slope(&self.to) - slope(&self.from)
    }
}

/// The height on the axis with what it would be without each group of lines, metres along the axis from its reference.
pub struct HeightFit {
    pub height: f64,
    pub without_each: Vec<f64>,
    /// Share of the pairs between which no point is missing and none too many.
    pub exact_share: f64,
    /// For each line the share of its pairs that are even.
    pub even: Vec<f64>,
}

/// Seeks the height; `None` where none is better than others.
pub fn fit(points: Sequence, lines: &[ScanLine], axis: &Axis) -> Option<HeightFit> {
    let mut lengths: Vec<f64> = lines.iter().map(|l| l.points.len() as f64).collect();
    let lag = (median(&mut lengths)? as usize / PARTS_OF_LINE).clamp(2, MAX_LAG);
    let pairs = pairs(points, lines, axis, lag)?;
    let (mut height, mut angle, mut spread) = sought(&pairs)?;
    for _ in 0..ROUNDS {
        let step = sums(&pairs, height, angle, spread).solution()?;
        height += step[0];
        angle += step[1];
        let mut residuals: Vec<f64> = pairs.iter().map(|p| p.angle(height) - angle).collect();
        spread = median_and_spread(&mut residuals)?.1.max(1e-7);
        if step[0].abs() < 1e-6 {
            break;
        }
    }
    let without_each = sums(&pairs, height, angle, spread).without_each()?;
    let is_within = |p: &&Pair, share: f64| (p.angle(height) - angle).abs() <= share * angle;
    let exact = pairs.iter().filter(|p| is_within(p, 0.5 / lag as f64)).count();
    let (mut even, mut all) = (vec![0.0; lines.len()], vec![0.0; lines.len()]);
    for pair in &pairs {
        all[pair.line] += 1.0;
        even[pair.line] += f64::from(u8::from(is_within(&pair, EVEN)));
    }
    Some(HeightFit {
        height,
        without_each: without_each.iter().map(|step| height + step[0]).collect(),
        exact_share: exact as f64 / pairs.len() as f64,
        even: even.iter().zip(&all).map(|(even, all)| even / f64::max(*all, 1.0)).collect(),
    })
}

/// Pairs of points in the order of lines.
fn pairs(points: Sequence, lines: &[ScanLine], axis: &Axis, lag: usize) -> Option<Vec<Pair>> {
    let up = axis.up();
    let total: usize = lines.iter().map(|l| l.points.len()).sum();
    let every = lag.div_ceil(2).max(total.div_ceil(MAX_PAIRS));
    let mut out = Vec::with_capacity(total / every + lines.len());
    for (number, line) in lines.iter().enumerate() {
        let flat = Vec3::new(line.along.x, line.along.y, 0.0);
        let ahead = (flat - up * up.dot(&flat)).normalize();
        let place = |i: usize| {
            let away = points.point(i) - axis.at;
            Vector2::new(away.dot(&ahead), away.dot(&up))
        };
        let starts = line.points.clone().take_while(|i| i + lag < line.points.end).step_by(every);
        out.extend(starts.map(|i| Pair { line: number, from: place(i), to: place(i + lag) }));
    }
    (out.len() >= SOUGHT / 8).then_some(out)
}

/// The height from which the angles of pairs spread least, their median, and their spread.
fn sought(pairs: &[Pair]) -> Option<(f64, f64, f64)> {
    let some: Vec<Pair> = scattered(pairs.len(), SOUGHT).map(|i| pairs[i]).collect();
    let mut heights: Vec<f64> = some.iter().map(|p| p.from.y).collect();
    heights.sort_by(f64::total_cmp);
    let (low, high) = (heights[heights.len() / 50] - 1.0, heights[heights.len() - 1 - heights.len() / 50] + 1.0);
    let at = |height: f64| {
        let mut angles: Vec<f64> = some.iter().map(|p| p.angle(height)).collect();
        let (angle, spread) = median_and_spread(&mut angles)?;
        // From far off all angles are small.
        (angle > 0.0).then_some((spread / angle, height, angle, spread))
    };
    let better = |heights: &[f64]| heights.iter().filter_map(|h| at(*h)).min_by(|a, b| a.0.total_cmp(&b.0));
    let mut step = (high - low) / PLACES as f64;
    let tried: Vec<f64> = (0..=PLACES).map(|k| low + step * k as f64).collect();
    let mut best = better(&tried)?;
    for _ in 0..HALVINGS {
        step *= 0.6;
        best = better(&[best.1 - step, best.1, best.1 + step])?;
    }
    Some((best.1, best.2, best.3))
}

/// Normal equations for steps of the height and of the angle between the points of a pair.
fn sums(pairs: &[Pair], height: f64, angle: f64, spread: f64) -> Grouped<2> {
    let mut out = Grouped::new();
    for (i, pair) in pairs.iter().enumerate() {
        let residual = pair.angle(height) - angle;
        let (w, x) = (tukey(residual, spread), Vector2::new(-pair.slope(height), 1.0));
        let a: Matrix2<f64> = w * x * x.transpose();
        out.add(i, pairs.len(), &a, &(w * residual * x));
    }
    out
}
