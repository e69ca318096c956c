//! The part of space that is counted.

use super::voxel_set::VoxelSet;
use crate::voxel::lattice::{Bits, steps_within};

/// Everything, or a set of voxels and what lies within some steps of it.
pub struct Region<'a> {
    set: Option<&'a VoxelSet>,
    steps: Vec<[i64; 3]>,
    /// Blocks of the set and their neighbours.
    reach: [[i32; 2]; 3],
}

impl<'a> Region<'a> {
    /// Everything, or a set and what lies within `gap` metres of it, in voxels of an edge of so many.
    pub fn new(set: Option<&'a VoxelSet>, gap: f64, voxel: f64) -> Self {
        let reach = set.map_or([[i32::MIN, i32::MAX]; 3], VoxelSet::reach);
        Self { set, steps: steps_within(gap / voxel), reach }
    }

    /// How much work a voxel is, in steps.
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    /// The voxels of a block that belong to it, of those `among` which they are sought.
    pub fn of(&self, key: [i32; 3], among: Bits) -> Bits {
        match self.set {
            _ if (0..3).any(|i| key[i] < self.reach[i][0] || key[i] > self.reach[i][1]) => [0; 8],
            Some(set) => set.near(key, &among, &self.steps),
            None => among,
        }
    }
}
