//! How near a return lies to any part of the object: it belongs to the nearest one.
//!
//! A beam aimed at the seat of a chair that passes its edge meets the leg: that says nothing of how far off the seat is.

use std::sync::OnceLock;

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::target::{CHUNK, Target};
use crate::geometry::{Aabb, Vec3};

/// The boxes of all chunks of triangles, made when they are first asked for.
#[derive(Debug, Default)]
pub struct PartIndex {
    tree: OnceLock<RTree<GeomWithData<Rectangle<[f64; 3]>, u32>>>,
}

impl Target {
    /// The distance from a return to the nearest triangle that its beam could have met, metres; `None` beyond `within`.
    pub fn distance_to_nearest_part(&self, met_world: &Vec3, direction: &Vec3, within: f64) -> Option<f64> {
        let tree = self.parts.tree.get_or_init(|| {
            let boxed = |(i, chunk): (usize, &[_])| {
                let bounds = Aabb::around(chunk.iter().flat_map(|t: &super::triangle::TargetTriangle| &t.corners));
                GeomWithData::new(Rectangle::from_corners(bounds.min, bounds.max), i as u32)
            };
            RTree::bulk_load(self.triangles.chunks(CHUNK).enumerate().map(boxed).collect())
        });
        let around = AABB::from_corners(met_world.map(|c| c - within).into(), met_world.map(|c| c + within).into());
        let chunks = tree.locate_in_envelope_intersecting(&around);
        let triangles = chunks.flat_map(|chunk| {
            let start = chunk.data as usize * CHUNK;
            &self.triangles[start..(start + CHUNK).min(self.triangles.len())]
        });
        triangles
            .filter(|t| self.two_sided || t.normal.dot(direction) < 0.0)
            .map(|t| t.distance(met_world))
            .filter(|d| *d <= within)
            .min_by(f64::total_cmp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::geometry::Solid;

    /// A bench: of a return at the rear rail the rail is the nearest part, from the front alone.
    #[test]
    fn the_nearest_part_that_a_beam_could_meet() {
        let solid = Solid::cuboid([0.0; 3], [1.0, 0.4, 0.5]).unwrap();
        let target = Target::new(&solid, NEVER).unwrap();
        let near = |p: [f64; 3], d: [f64; 3]| target.distance_to_nearest_part(&p.into(), &d.into(), 0.1);
        assert!((near([-0.02, 0.2, 0.2], [1.0, 0.0, 0.0]).unwrap() - 0.02).abs() < 1e-12);
        assert!((near([-0.03, -0.04, 0.2], [1.0, 1.0, 0.0]).unwrap() - 0.05).abs() < 1e-12);
        assert_eq!(near([-0.02, 0.2, 0.2], [-1.0, 0.0, 0.0]), None);
        assert_eq!(near([-0.2, 0.2, 0.2], [1.0, 0.0, 0.0]), None);
    }
}
