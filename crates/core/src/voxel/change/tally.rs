//! How many voxels of each class, overall or inside and around an object.

use super::class::ChangeClass;
use super::value::VoxelChange;
use crate::voxel::lattice::bits::{common, count};
use crate::voxel::model::{Region, VoxelSet};
use crate::{Interrupt, Result, poll_now_and_then};

/// Voxels of each class.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ChangeTally {
    /// In the order of [`ChangeClass::ALL`].
    pub voxels: [u64; 5],
}

impl ChangeTally {
    /// Voxels of a class.
    pub fn of(&self, class: ChangeClass) -> u64 {
        self.voxels[class as usize - 1]
    }

    /// Voxels that are occupied in either epoch.
    pub fn total(&self) -> u64 {
        self.voxels.iter().sum()
    }
}

impl VoxelChange {
    /// Counts the voxels of every class, overall, or those of a set and within `gap` metres of it.
    pub fn tally(&self, set: Option<&VoxelSet>, gap: f64, interrupt: Interrupt) -> Result<ChangeTally> {
        let region = Region::new(set, gap, self.grid.voxel);
        let mut out = ChangeTally::default();
        for (round, (key, classes)) in self.blocks.iter().enumerate() {
            poll_now_and_then(16 * region.steps() * round, interrupt)?;
            let counted = region.of(*key, classes.any());
            for class in ChangeClass::ALL {
                out.voxels[class as usize - 1] += count(&common(&classes.of(class), &counted));
            }
        }
        Ok(out)
    }
}
