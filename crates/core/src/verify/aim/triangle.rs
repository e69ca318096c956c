//! One triangle of a solid that beams are aimed at.

use crate::geometry::Vec3;

/// A triangle and its neighbours.
#[derive(Debug)]
pub struct TargetTriangle {
    /// World metres, counter-clockwise from outside.
    pub corners: [Vec3; 3],
    /// Outward unit normal.
    pub normal: Vec3,
    /// Across the edge from each corner to the next; [`TargetTriangle::NONE`] where the surface ends or turns.
    pub neighbours: [u32; 3],
}

impl TargetTriangle {
    /// No neighbour.
    pub const NONE: u32 = u32::MAX;

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
}
