//! The surface through rings of points.

use std::fmt::Write as _;

use ifc_lite_geometry::{Matrix4, Point3};

use super::super::value::real;
use super::rings::Ring;
use super::section::Section;

/// A closed surface, its triangles counter-clockwise seen from outside.
pub struct Skin {
    pub points: Vec<Point3<f64>>,
    pub triangles: Vec<[usize; 3]>,
}

impl Skin {
    /// The surface through rings from one section to another with the same number of points, capped by the sections
    /// unless the last ring is joined to the first.
    pub fn new([start, end]: [&Section; 2], rings: &[Ring], is_closed: bool) -> Self {
        let (size, count) = (start.points.len(), rings.len());
        let mut triangles = Vec::new();
        for k in 0..count - usize::from(!is_closed) {
            let (low, high) = (k * size, (k + 1) % count * size);
            for range in &start.loops {
                for i in range.clone() {
                    let j = if i + 1 == range.end { range.start } else { i + 1 };
                    triangles.extend([[low + i, low + j, high + j], [low + i, high + j, high + i]]);
                }
            }
        }
        if !is_closed {
            let last = (count - 1) * size;
            triangles.extend(start.triangles.iter().map(|&[a, b, c]| [a, c, b]));
            triangles.extend(end.triangles.iter().map(|t| t.map(|i| last + i)));
        }
        let mut skin = Self { points: rings.concat(), triangles };
        if skin.volume() < 0.0 {
            skin.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        skin
    }

    pub fn volume(&self) -> f64 {
        let zero = self.points.first().copied().unwrap_or_default();
        let six = self.triangles.iter().map(|t| t.map(|i| self.points[i] - zero)).map(|[a, b, c]| a.dot(&b.cross(&c)));
        six.sum::<f64>() / 6.0
    }

    pub fn moved(mut self, by: &Matrix4<f64>) -> Self {
        self.points.iter_mut().for_each(|p| *p = by.transform_point(p));
        self
    }

    /// All surfaces as one IfcTriangulatedFaceSet, and its list of points.
    pub fn text(skins: &[Self], id: u64, list: u64) -> String {
        let (mut points, mut triangles, mut first) = (String::new(), String::new(), 1);
        for skin in skins {
            for p in &skin.points {
                let part = if points.is_empty() { "" } else { "," };
                let [x, y, z] = [p.x, p.y, p.z].map(real);
                let _ = write!(points, "{part}({x},{y},{z})");
            }
            for t in &skin.triangles {
                let part = if triangles.is_empty() { "" } else { "," };
                let [a, b, c] = t.map(|i| i + first);
                let _ = write!(triangles, "{part}({a},{b},{c})");
            }
            first += skin.points.len();
        }
        format!(
            "#{id}=IFCTRIANGULATEDFACESET(#{list},$,.T.,({triangles}),$);\n#{list}=IFCCARTESIANPOINTLIST3D(({points}));"
        )
    }
}
