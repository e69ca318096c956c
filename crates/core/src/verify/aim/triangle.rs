//! One triangle of a solid that beams are aimed at.

use crate::geometry::{FaceKind, Vec3};

/// A triangle and its neighbours.
#[derive(Debug)]
pub struct TargetTriangle {
    /// World metres, counter-clockwise from outside.
    pub corners: [Vec3; 3],
    /// Outward unit normal.
    pub normal: Vec3,
    /// Across the edge from each corner to the next; [`TargetTriangle::NONE`] where the surface ends or turns.
    pub neighbours: [u32; 3],
    /// The same whatever the edge; [`TargetTriangle::NONE`] where the solid has no triangle there.
    pub across: [u32; 3],
    /// What it belongs to.
    pub kind: FaceKind,
}

impl TargetTriangle {
    /// No neighbour.
    pub const NONE: u32 = u32::MAX;

    /// Whether beams may pass its place although it was built: of a pane or a leaf.
    pub fn is_optional(&self) -> bool {
        self.kind != FaceKind::Fixed
    }

    /// How far before its plane a place lies, metres along the normal, negative in front of it; `None` where it is seen edge
    /// on, or from behind and that counts not.
    pub fn height_of(&self, place_world: &Vec3, two_sided: bool) -> Option<f64> {
        let height = (self.corners[0] - place_world).dot(&self.normal);
        (height < 0.0 || (height > 0.0 && two_sided)).then_some(height)
    }

    /// The foot of a point (world metres) on the triangle's plane.
    pub fn on_plane(&self, point_world: &Vec3) -> Vec3 {
        point_world - self.normal * self.normal.dot(&(point_world - self.corners[0]))
    }

    /// The edge that a point of its plane lies farthest beyond; `None` inside. World metres.
    pub fn crossed_edge(&self, point_world: &Vec3) -> Option<usize> {
        let mut worst = (-1e-9, None);
        for k in 0..3 {
            let (a, b) = (self.corners[k], self.corners[(k + 1) % 3]);
            let e = b - a;
            let inside = e.cross(&(point_world - a)).dot(&self.normal) / e.norm().max(1e-12);
            if inside < worst.0 {
                worst = (inside, Some(k));
            }
        }
        worst.1
    }

    /// The place of edge `k` that is nearest to a point. World metres.
    pub fn on_edge(&self, k: usize, point_world: &Vec3) -> Vec3 {
        let (a, b) = (self.corners[k], self.corners[(k + 1) % 3]);
        let e = b - a;
        a + e * (e.dot(&(point_world - a)) / e.norm_squared().max(1e-24)).clamp(0.0, 1.0)
    }

    /// The distance of a point (world metres) from the triangle, metres.
    pub fn distance(&self, point_world: &Vec3) -> f64 {
        match self.crossed_edge(&self.on_plane(point_world)) {
            None => self.normal.dot(&(point_world - self.corners[0])).abs(),
            // Beyond one edge of an obtuse triangle another one may be nearer.
            Some(_) => {
                (0..3).map(|k| (self.on_edge(k, point_world) - point_world).norm()).fold(f64::INFINITY, f64::min)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector(size: f64) -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(-size..size).prop_map(Vec3::from)
    }

    proptest! {
        /// Against barycentric coordinates and a search along the edges.
        #[test]
        fn inside_beyond_and_nearest(corners in prop::array::uniform3(vector(2.0)), point in vector(3.0)) {
            let [a, b, c] = corners;
            let n = (b - a).cross(&(c - a));
            prop_assume!(n.norm() > 0.05);
            let t = TargetTriangle { corners, normal: n.normalize(), neighbours: [TargetTriangle::NONE; 3], across: [TargetTriangle::NONE; 3], kind: FaceKind::Fixed };
            let foot = t.on_plane(&point);
            prop_assert!((foot - a).dot(&t.normal).abs() < 1e-9);
            prop_assert!((point - foot).cross(&t.normal).norm() < 1e-9);
            // The weight of the corner opposite to each edge.
            let weight = |k: usize| {
                let (p, q) = (corners[k], corners[(k + 1) % 3]);
                (q - p).cross(&(foot - p)).dot(&t.normal) / n.norm()
            };
            let weights = [0, 1, 2].map(weight);
            prop_assume!(weights.iter().all(|w| w.abs() > 1e-6));
            match t.crossed_edge(&foot) {
                None => prop_assert!(weights.iter().all(|w| *w > 0.0)),
                Some(k) => prop_assert!(weights[k] < 0.0),
            }
            for k in 0..3 {
                let (p, q) = (corners[k], corners[(k + 1) % 3]);
                let nearest = (0..=1000).map(|i| (p + (q - p) * (f64::from(i) / 1000.0) - point).norm());
                let found = (t.on_edge(k, &point) - point).norm();
                let brute = nearest.fold(f64::INFINITY, f64::min);
                prop_assert!(found <= brute + 1e-12 && found >= brute - 0.01, "{found} {brute}");
                prop_assert!(t.distance(&point) <= brute + 1e-12);
            }
        }
    }
}
