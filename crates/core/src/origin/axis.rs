//! The axis about which the scanner turned: the line that all planes of scan lines contain.

use std::ops::Range;

use nalgebra::{Matrix2, Matrix4, Vector2, Vector4};

use super::jackknife::Grouped;
use super::sequence::Sequence;
use crate::geometry::Vec3;
use crate::num::scatter::scattered;
use crate::num::stats::{median_and_spread, tukey};

/// Most rounds of fitting the axis.
const ROUNDS: usize = 25;
/// A step of the axis that ends them.
const STILL_M: f64 = 1e-5;
/// Points of a line by which the spread is known.
const COMPARED: usize = 24;
/// Beyond so many spreads a point does not lie in the plane of its line.
const OUTSIDE: f64 = 6.0;
/// Angles have no smaller spread: coordinates are rounded.
const MIN_SPREAD: f64 = 1e-6;
/// Nearer points count as this far away: they are rounded, and a mirror is no point.
const MIN_RANGE_M: f64 = 1.0;

/// A line that stands, perhaps not quite upright.
#[derive(Debug, Clone, Copy)]
pub struct Axis {
    /// Where it passes the height of the third coordinate, metres from the anchor.
    pub at: Vec3,
    /// How far it leans along x and y with each metre of height.
    pub lean: Vector2<f64>,
}

impl Axis {
    /// Unit vector up the axis.
    pub fn up(&self) -> Vec3 {
        Vec3::new(self.lean.x, self.lean.y, 1.0).normalize()
    }

    fn moved(&self, by: &Vector4<f64>) -> Self {
        Self { at: self.at + Vec3::new(by[0], by[1], 0.0), lean: self.lean + Vector2::new(by[2], by[3]) }
    }
}

/// A scan line and its direction seen from above.
pub struct ScanLine {
    pub points: Range<usize>,
    /// Unit vector.
    pub along: Vector2<f64>,
}

impl ScanLine {
    /// The direction in which most of its far points lie from a place.
    pub fn new(points: Sequence, range: Range<usize>, place: &Vector2<f64>) -> Self {
        let mut m = Matrix2::zeros();
        for i in range.clone() {
            let away = points.point(i).xy() - place;
            m += away * away.transpose();
        }
        let angle = 0.5 * (2.0 * m[(0, 1)]).atan2(m[(0, 0)] - m[(1, 1)]);
        let along = Vector2::new(angle.cos(), angle.sin());
        // Where it begins is ahead.
        let first = points.point(range.start).xy() - place;
        Self { points: range, along: if along.dot(&first) < 0.0 { -along } else { along } }
    }

    fn across(&self) -> Vector2<f64> {
        Vector2::new(-self.along.y, self.along.x)
    }
}

/// The axis with what it would be without each group of lines, and how well the points fit.
pub struct AxisFit {
    pub axis: Axis,
    pub without_each: Vec<Axis>,
    /// Spread of the points' angles from the planes of their lines, radians.
    pub spread: f64,
    /// For each line the share of its points within a few spreads.
    pub in_plane: Vec<f64>,
}

/// Fits the axis to the lines, from near it.
pub fn fit(points: Sequence, lines: &mut [ScanLine], start: Axis) -> Option<AxisFit> {
    let (mut axis, mut spread) = (start, 0.03);
    for _ in 0..ROUNDS {
        let sums = sums(points, lines, &axis, spread);
        let step = sums.grouped.solution()?;
        for (line, own) in lines.iter_mut().zip(&sums.own) {
            line.along = (line.along + line.across() * own.turn(line, &step)).normalize();
        }
        axis = axis.moved(&step);
        spread = residual_spread(points, lines, &axis)?.min(spread);
        if step.norm() < STILL_M {
            break;
        }
    }
    let steps = sums(points, lines, &axis, spread).grouped.without_each()?;
    let in_plane = lines.iter().map(|line| share_within(points, line, &axis, OUTSIDE * spread)).collect();
    Some(AxisFit { axis, without_each: steps.iter().map(|s| axis.moved(s)).collect(), spread, in_plane })
}

/// Weighted sums of a line by which its own turn follows from a step of the axis.
#[derive(Default, Clone, Copy)]
struct OwnSums {
    tt: f64,
    t: f64,
    th: f64,
    tr: f64,
}

impl OwnSums {
    fn turn(&self, line: &ScanLine, step: &Vector4<f64>) -> f64 {
        let n = line.across();
        let (at, lean) = (n.dot(&step.xy()), n.dot(&Vector2::new(step[2], step[3])));
        if self.tt > 0.0 { (self.tr - self.t * at - self.th * lean) / self.tt } else { 0.0 }
    }
}

struct Sums {
    grouped: Grouped<4>,
    own: Vec<OwnSums>,
}

/// Normal equations for the axis, each line free to turn about it.
fn sums(points: Sequence, lines: &[ScanLine], axis: &Axis, spread: f64) -> Sums {
    let mut out = Sums { grouped: Grouped::new(), own: Vec::with_capacity(lines.len()) };
    for (k, line) in lines.iter().enumerate() {
        let (mut own, mut g, mut c) = (OwnSums::default(), Matrix2::zeros(), Vector2::zeros());
        for i in line.points.clone() {
            let Residual { t, h, r, range } = residual(&points.point(i), line, axis);
            let w = tukey(r / range, spread) / (range * range);
            let x = Vector2::new(1.0, h);
            g += w * x * x.transpose();
            c += w * r * x;
            own.tt += w * t * t;
            own.t += w * t;
            own.th += w * t * h;
            own.tr += w * t * r;
        }
        if own.tt > 0.0 {
            let x = Vector2::new(own.t, own.th);
            g -= x * x.transpose() / own.tt;
            c -= x * own.tr / own.tt;
            let (n, mut a, mut b) = (line.across(), Matrix4::zeros(), Vector4::zeros());
            let nn = n * n.transpose();
            for p in 0..2 {
                for q in 0..2 {
                    a.fixed_view_mut::<2, 2>(2 * p, 2 * q).copy_from(&(nn * g[(p, q)]));
                }
                b.fixed_rows_mut::<2>(2 * p).copy_from(&(n * c[p]));
            }
            out.grouped.add(k, lines.len(), &a, &b);
        }
        out.own.push(own);
    }
    out
}

/// A point as its line sees it: along, above the axis' reference height, across; and its range. Metres.
struct Residual {
    t: f64,
    h: f64,
    r: f64,
    range: f64,
}

fn residual(point: &Vec3, line: &ScanLine, axis: &Axis) -> Residual {
    let away = point - axis.at;
    let flat = away.xy() - axis.lean * away.z;
    let range = away.norm().max(MIN_RANGE_M);
    Residual { t: line.along.dot(&flat), h: away.z, r: line.across().dot(&flat), range }
}

/// Angles of some points of a line from its plane, radians.
fn angles<'a>(points: Sequence<'a>, line: &'a ScanLine, axis: &'a Axis) -> impl Iterator<Item = f64> + 'a {
    scattered(line.points.len(), COMPARED).map(move |i| {
        let Residual { r, range, .. } = residual(&points.point(line.points.start + i), line, axis);
        r / range
    })
}

fn residual_spread(points: Sequence, lines: &[ScanLine], axis: &Axis) -> Option<f64> {
    let mut angles: Vec<f64> = lines.iter().flat_map(|line| angles(points, line, axis)).collect();
    Some(median_and_spread(&mut angles)?.1.max(MIN_SPREAD))
}

fn share_within(points: Sequence, line: &ScanLine, axis: &Axis, most: f64) -> f64 {
    let (within, all) = angles(points, line, axis)
        .fold((0u32, 0u32), |(within, all), angle| (within + u32::from(angle.abs() <= most), all + 1));
    f64::from(within) / f64::from(all.max(1))
}
