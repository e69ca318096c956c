//! A profile: loops of points, and the triangles between them.

use std::ops::Range;

use ifc_lite_geometry::{Point2, Profile2D};

use super::super::profiles::{CIRCLE_CORNERS, ellipse};

/// An area with holes, in the plane of its profile.
#[derive(Debug, Clone)]
pub struct Section {
    pub points: Vec<Point2<f64>>,
    /// The outer loop counter-clockwise, then the holes clockwise.
    pub loops: Vec<Range<usize>>,
    /// Counter-clockwise.
    pub triangles: Vec<[usize; 3]>,
}

impl Section {
    pub fn new(outer: &[Point2<f64>], holes: &[Vec<Point2<f64>>]) -> Option<Self> {
        let turned = |points: &[Point2<f64>], against_clock: bool| {
            let mut points = points.to_vec();
            points.dedup_by(|a, b| a == b);
            if points.len() > 1 && points.first() == points.last() {
                points.pop();
            }
            if (doubled_area(&points) > 0.0) != against_clock {
                points.reverse();
            }
            points
        };
        let mut profile = Profile2D::new(turned(outer, true));
        profile.holes = holes.iter().map(|h| turned(h, false)).collect();
        let filled = profile.triangulate().ok()?;
        let mut loops = Vec::new();
        let mut points = Vec::new();
        for ring in std::iter::once(&profile.outer).chain(&profile.holes) {
            loops.push(points.len()..points.len() + ring.len());
            points.extend_from_slice(ring);
        }
        let mut triangles: Vec<[usize; 3]> = filled.indices.as_chunks::<3>().0.to_vec();
        for t in &mut triangles {
            if doubled_area(&t.map(|i| filled.points[i])) < 0.0 {
                t.swap(1, 2);
            }
        }
        let is_sound = profile.outer.len() >= 3 && !triangles.is_empty() && filled.points == points;
        is_sound.then_some(Self { points, loops, triangles })
    }

    /// The same loops with their points at other places.
    pub fn at(&self, points: &[Point2<f64>]) -> Option<Self> {
        let mut rings = self.loops.iter().map(|range| points[range.clone()].to_vec());
        let outer = rings.next()?;
        Self::new(&outer, &rings.collect::<Vec<_>>()).filter(|s| s.points == points)
    }

    /// A disk, or a ring where it has an inner radius.
    pub fn disk(radius: f64, inner: Option<f64>) -> Option<Self> {
        let circle = |r: f64| Some(ellipse(&[r, r], CIRCLE_CORNERS)?.into_iter().map(Point2::from).collect::<Vec<_>>());
        let holes: Vec<Vec<_>> = inner.and_then(circle).into_iter().collect();
        if inner.is_none_or(|r| r < radius) { Self::new(&circle(radius)?, &holes) } else { None }
    }
}

pub fn doubled_area(points: &[Point2<f64>]) -> f64 {
    let n = points.len();
    (0..n).map(|i| (points[i], points[(i + 1) % n])).map(|(a, b)| a.x * b.y - a.y * b.x).sum()
}
