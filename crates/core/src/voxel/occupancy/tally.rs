//! How many voxels of each state, overall or inside an object.

use super::value::Occupancy;
use crate::voxel::lattice::bits::{common, count};
use crate::voxel::model::{Region, VoxelSet};
use crate::{Interrupt, Result, poll_now_and_then};

/// Voxels of each state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StateTally {
    /// Voxels that are occupied and were not passed.
    pub occupied: u64,
    /// Voxels that are occupied and were passed too.
    pub ambiguous: u64,
    /// Voxels that were passed alone.
    pub empty: u64,
}

impl Occupancy {
    /// Counts the voxels of every state, overall or inside a set.
    pub fn tally(&self, threshold: u8, set: Option<&VoxelSet>, interrupt: Interrupt) -> Result<StateTally> {
        let region = Region::new(set, 0.0, self.grid.voxel);
        let mut out = StateTally::default();
        for (round, (key, block)) in self.known.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            let counted = region.of(key, self.span.of_block(key));
            let hit = common(&block.occupied(threshold), &counted);
            let passed = common(&block.traversed(), &counted);
            let both = count(&common(&hit, &passed));
            out.occupied += count(&hit) - both;
            out.ambiguous += both;
            out.empty += count(&passed) - both;
        }
        Ok(out)
    }
}
