//! Triangles by place.

use std::sync::OnceLock;

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::triangle::TargetTriangle;
use crate::geometry::{Aabb, Vec3};

/// Triangles of one box.
const CHUNK: usize = 32;

/// The boxes of all runs of [`CHUNK`] triangles, made when they are first asked for.
#[derive(Debug, Default)]
pub struct TriangleIndex {
    tree: OnceLock<RTree<GeomWithData<Rectangle<[f64; 3]>, u32>>>,
}

impl TriangleIndex {
    /// The triangles of all runs whose boxes come within `within` metres of a place.
    pub fn around<'a>(
        &'a self,
        triangles: &'a [TargetTriangle],
        place_world: &Vec3,
        within: f64,
    ) -> impl Iterator<Item = &'a TargetTriangle> {
        let boxed = |(i, chunk): (usize, &[TargetTriangle])| {
            let bounds = Aabb::around(chunk.iter().flat_map(|t| &t.corners));
            GeomWithData::new(Rectangle::from_corners(bounds.min, bounds.max), i as u32)
        };
        let all = || RTree::bulk_load(triangles.chunks(CHUNK).enumerate().map(boxed).collect());
        let corner = |sign: f64| place_world.map(|c| c + sign * within).into();
        let chunks =
            self.tree.get_or_init(all).locate_in_envelope_intersecting(&AABB::from_corners(corner(-1.0), corner(1.0)));
        chunks.flat_map(|chunk| triangles.chunks(CHUNK).nth(chunk.data as usize).unwrap_or_default())
    }
}
