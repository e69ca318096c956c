//! Voxels counted from a near one, so that numbers stay small and exact.

use crate::geometry::Vec3;
use crate::voxel::lattice::{Grid, VoxelBox};

/// An origin is a multiple of this on every axis: slabs and blocks begin there, too.
const MULTIPLE: i64 = 64;

/// A voxel near the patch, from which its coordinates are counted.
#[derive(Debug, Clone, Copy)]
pub struct LocalOrigin(pub [i64; 3]);

impl LocalOrigin {
    /// Near a voxel.
    pub fn at(voxel: [i64; 3]) -> Self {
        Self(voxel.map(|i| i.div_euclid(MULTIPLE) * MULTIPLE))
    }

    /// A point (world metres) in voxels from here.
    pub fn local(&self, grid: &Grid, world: &Vec3) -> Vec3 {
        Vec3::from_fn(|i, _| world[i] / grid.voxel - self.0[i] as f64)
    }

    /// Number on the lattice of the voxel that has the number `local` counted from here.
    pub fn world(&self, local: [i64; 3]) -> [i64; 3] {
        [0, 1, 2].map(|i| local[i] + self.0[i])
    }

    /// Voxels counted from here.
    pub fn span(&self, span: &VoxelBox) -> VoxelBox {
        span.counted_from(self.0)
    }
}
