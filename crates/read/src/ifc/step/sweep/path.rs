//! The line that a profile follows.

use ifc_lite_geometry::{Point3, Vector3};

/// A turn of this cosine or less is a corner; arcs come in smaller steps.
const CORNER_COS: f64 = 0.94;
/// A turn of this cosine or less goes back on itself.
const BACK_COS: f64 = -0.98;
/// Steps of a rounded corner, per radian.
const STEPS_PER_RADIAN: f64 = 8.0;

/// Its points, without duplicates, in the file's unit.
#[derive(Debug)]
pub struct Path {
    pub points: Vec<Point3<f64>>,
    /// The last point is joined to the first, which is not repeated.
    pub is_closed: bool,
}

impl Path {
    pub fn new(mut points: Vec<Point3<f64>>) -> Option<Self> {
        let size = points.iter().map(|p| (p - points[0]).norm()).fold(0.0, f64::max);
        points.dedup_by(|a, b| (*a - *b).norm() <= 1e-9 * size);
        let is_closed = points.len() > 3 && (points[0] - points[points.len() - 1]).norm() <= 1e-6 * size;
        if is_closed {
            points.pop();
        }
        let is_sound = size > 0.0 && size.is_finite() && points.len() >= 2;
        is_sound.then_some(Self { points, is_closed })
    }

    pub fn segments(&self) -> usize {
        self.points.len() - usize::from(!self.is_closed)
    }

    /// Both ends of a segment.
    pub fn segment(&self, i: usize) -> [Point3<f64>; 2] {
        [self.points[i], self.points[(i + 1) % self.points.len()]]
    }

    /// Unit directions of the segments.
    pub fn tangents(&self) -> Vec<Vector3<f64>> {
        (0..self.segments()).map(|i| self.segment(i)).map(|[a, b]| (b - a).normalize()).collect()
    }

    /// The segments before and after each point where two meet.
    pub fn joints(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let n = self.segments();
        (usize::from(!self.is_closed)..n).map(move |k| ((k + n - 1) % n, k))
    }

    pub fn corners(&self) -> usize {
        let tangents = self.tangents();
        self.joints().filter(|&(a, b)| tangents[a].dot(&tangents[b]) <= CORNER_COS).count()
    }

    /// Whether it goes back on itself, where no profile can follow.
    pub fn goes_back(&self) -> bool {
        let tangents = self.tangents();
        self.joints().any(|(a, b)| tangents[a].dot(&tangents[b]) <= BACK_COS)
    }

    /// The line with rounded corners; `None` where there is no room for the arcs.
    pub fn rounded(self, radius: f64) -> Option<Self> {
        if radius <= 0.0 || self.is_closed {
            return Some(self);
        }
        let (tangents, n) = (self.tangents(), self.points.len());
        let cut = |k: usize| {
            let turn = tangents[k - 1].dot(&tangents[k]).clamp(-1.0, 1.0).acos();
            (turn, radius * (turn / 2.0).tan())
        };
        let lengths: Vec<f64> = (0..n - 1).map(|i| self.segment(i)).map(|[a, b]| (b - a).norm()).collect();
        let cuts: Vec<f64> = (0..n).map(|k| if k == 0 || k == n - 1 { 0.0 } else { cut(k).1 }).collect();
        let has_room = (0..n - 1).all(|i| cuts[i] + cuts[i + 1] <= lengths[i] * (1.0 + 1e-9));
        if !has_room || self.goes_back() {
            return None;
        }
        let mut points = vec![self.points[0]];
        for k in 1..n - 1 {
            let (turn, cut) = cut(k);
            let (from, to) = (tangents[k - 1], tangents[k]);
            let start = self.points[k] - from * cut;
            // Towards the arc's centre; a straight joint has none.
            let Some(inward) = (to - from * from.dot(&to)).try_normalize(1e-9) else {
                points.push(self.points[k]);
                continue;
            };
            let steps = (turn * STEPS_PER_RADIAN).ceil().max(1.0) as usize;
            points.extend((0..=steps).map(|s| {
                let (sin, cos) = (turn * s as f64 / steps as f64).sin_cos();
                start + from * (radius * sin) + inward * (radius * (1.0 - cos))
            }));
        }
        points.push(self.points[n - 1]);
        Self::new(points)
    }
}
