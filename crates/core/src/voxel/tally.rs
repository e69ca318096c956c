//! How many voxels of each state or class, overall or inside an object.

use super::blocks::{Bits, steps_within};
use super::change::Change;
use super::class::Class;
use super::mask::Mask;
use super::occupancy::Occupancy;
use crate::{Interrupt, Result, poll_now_and_then};

/// Voxels of each class.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ChangeTally {
    /// In the order of [`Class::ALL`].
    pub voxels: [u64; 5],
}

impl ChangeTally {
    /// Voxels of a class.
    pub fn of(&self, class: Class) -> u64 {
        self.voxels[class as usize - 1]
    }

    /// Voxels that are occupied in either epoch.
    pub fn total(&self) -> u64 {
        self.voxels.iter().sum()
    }
}

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

/// Part of space that is counted: everything, or a mask and what lies within some steps of it.
struct Part<'a> {
    mask: Option<&'a Mask>,
    steps: Vec<[i64; 3]>,
    /// Blocks of the mask and their neighbours.
    reach: [[i32; 2]; 3],
}

impl<'a> Part<'a> {
    fn new(mask: Option<&'a Mask>, gap: f64, voxel: f64) -> Self {
        let reach = mask.map_or([[i32::MIN, i32::MAX]; 3], Mask::reach);
        Self { mask, steps: steps_within(gap / voxel), reach }
    }

    fn of(&self, key: [i32; 3], among: Bits) -> Bits {
        match self.mask {
            _ if (0..3).any(|i| key[i] < self.reach[i][0] || key[i] > self.reach[i][1]) => [0; 8],
            Some(mask) => mask.near(key, &among, &self.steps),
            None => among,
        }
    }
}

impl Change {
    /// Counts the voxels of every class, overall, or those of a mask and within `gap` metres of it.
    pub fn tally(&self, mask: Option<&Mask>, gap: f64, interrupt: Interrupt) -> Result<ChangeTally> {
        let part = Part::new(mask, gap, self.grid.voxel);
        let mut out = ChangeTally::default();
        for (round, (key, classes)) in self.blocks.iter().enumerate() {
            poll_now_and_then(16 * part.steps.len() * round, interrupt)?;
            let counted = part.of(*key, classes.any());
            for class in Class::ALL {
                let own = classes.of(class);
                let n: u32 = (0..8).map(|word| (own[word] & counted[word]).count_ones()).sum();
                out.voxels[class as usize - 1] += u64::from(n);
            }
        }
        Ok(out)
    }
}

impl Occupancy {
    /// Counts the voxels of every state, overall or inside a mask.
    pub fn tally(&self, threshold: u8, mask: Option<&Mask>, interrupt: Interrupt) -> Result<StateTally> {
        let part = Part::new(mask, 0.0, self.grid.voxel);
        let mut out = StateTally::default();
        for (round, (key, block)) in self.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            let counted = part.of(*key, self.span.of_block(*key));
            let occupied = block.occupied(threshold);
            for word in 0..8 {
                let (hit, passed) = (occupied[word] & counted[word], block.traversed[word] & counted[word]);
                out.occupied += u64::from((hit & !passed).count_ones());
                out.ambiguous += u64::from((hit & passed).count_ones());
                out.empty += u64::from((passed & !hit).count_ones());
            }
        }
        Ok(out)
    }
}
