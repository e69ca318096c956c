//! The sequence cut into scan lines: within one, the angle to the horizon grows; where it falls back, the next begins.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::Range;

use nalgebra::Vector2;

use super::sequence::Sequence;
use crate::geometry::Vec3;

/// A fall of the angle by this much begins a line. Edges of near things, seen from a place beside the true one,
/// let it fall by less.
const FALL: f64 = 0.3;
/// Lines of fewer points are left out.
pub const MIN_POINTS: usize = 32;

/// Scan lines, each a range of the sequence, as seen from a place (metres from the anchor).
pub fn cut(points: Sequence, centre: &Vec3) -> Vec<Range<usize>> {
    let mut lines = Vec::new();
    let mut cutter = Cutter { ahead: Vector2::x(), start: 0, last: f64::INFINITY };
    for i in 0..points.len() {
        let offset = points.point(i) - centre;
        if cutter.begins(i, &offset) {
            lines.push(cutter.start..i);
            cutter.begin(i, &offset);
        }
    }
    lines.push(cutter.start..points.len());
    lines.retain(|line| line.len() >= MIN_POINTS);
    lines
}

/// The share of points that lie higher than the one before them.
pub fn rising_share(points: Sequence, centre: &Vec3) -> f64 {
    let mut cutter = Cutter { ahead: Vector2::x(), start: 0, last: f64::INFINITY };
    let mut rising = 0;
    for i in 0..points.len() {
        let (offset, before) = (points.point(i) - centre, cutter.last);
        if cutter.begins(i, &offset) {
            cutter.begin(i, &offset);
        } else {
            rising += usize::from(cutter.last > before);
        }
    }
    rising as f64 / points.len().max(1) as f64
}

/// The share of points within lines.
pub fn share_in_lines(points: Sequence, lines: &[Range<usize>]) -> f64 {
    lines.iter().map(ExactSizeIterator::len).sum::<usize>() as f64 / points.len().max(1) as f64
}

struct Cutter {
    /// The horizontal direction in which the line began.
    ahead: Vector2<f64>,
    start: usize,
    /// The angle of the point before.
    last: f64,
}

impl Cutter {
    /// Whether a point begins another line than the one before it; else its angle is kept.
    fn begins(&mut self, i: usize, offset: &Vec3) -> bool {
        if i == 0 {
            self.begin(0, offset);
            return false;
        }
        let angle = self.angle(offset);
        let falls = angle < self.last - FALL;
        self.last = angle;
        falls
    }

    fn begin(&mut self, i: usize, offset: &Vec3) {
        self.start = i;
        self.ahead = offset.xy().try_normalize(1e-9).unwrap_or_else(Vector2::x);
        self.last = self.angle(offset);
    }

    /// Angle above the horizon ahead; beyond the zenith it goes on.
    fn angle(&self, offset: &Vec3) -> f64 {
        let angle = offset.z.atan2(offset.xy().dot(&self.ahead));
        if angle < -FRAC_PI_2 { angle + TAU } else { angle }
    }
}
