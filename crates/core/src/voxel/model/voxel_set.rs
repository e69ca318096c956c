//! A set of voxels: what a solid fills.

use crate::voxel::lattice::bits::{self, slot_of, slots};
use crate::voxel::lattice::block_map::block_of;
use crate::voxel::lattice::{Around, Bits, BlockMap, EDGE, VoxelBox};
use crate::{Interrupt, Result, poll_now_and_then};

/// A set of voxels, a bit each.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct VoxelSet {
    blocks: BlockMap<Bits>,
}

impl VoxelSet {
    /// Whether a voxel belongs to it.
    pub fn holds(&self, voxel: [i64; 3]) -> bool {
        self.blocks.get(&block_of(voxel)).is_some_and(|bits| bits::holds(bits, slot_of(voxel)))
    }

    /// Number of its voxels in a box of voxels.
    pub fn len_within(&self, span: &VoxelBox) -> u64 {
        self.blocks.iter().map(|(key, own)| bits::count(&bits::common(own, &span.of_block(*key)))).sum()
    }

    /// Number of voxels.
    pub fn len(&self) -> u64 {
        self.blocks.values().map(bits::count).sum()
    }

    /// Whether it holds no voxel.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Its blocks.
    pub(crate) fn blocks(&self) -> &BlockMap<Bits> {
        &self.blocks
    }

    /// Adds a voxel.
    pub(crate) fn insert(&mut self, voxel: [i64; 3], interrupt: Interrupt) -> Result<()> {
        bits::put(self.blocks.made(block_of(voxel), interrupt)?, slot_of(voxel));
        Ok(())
    }

    /// Adds the voxels of a row along x, from the first up to `end`.
    pub(crate) fn insert_run(&mut self, [first, end]: [i64; 2], [y, z]: [i64; 2], interrupt: Interrupt) -> Result<()> {
        let mut x = first;
        while x < end {
            poll_now_and_then((x.div_euclid(EDGE) & 1023) as usize, interrupt)?;
            let stop = ((x.div_euclid(EDGE) + 1) * EDGE).min(end);
            let slot = slot_of([x, y, z]);
            let run = (u64::MAX >> (64 - (stop - x))) << (slot % 64);
            self.blocks.made(block_of([x, y, z]), interrupt)?[slot / 64] |= run;
            x = stop;
        }
        Ok(())
    }

    /// Puts a block that is not there yet.
    pub(crate) fn insert_block(&mut self, key: [i32; 3], own: Bits, interrupt: Interrupt) -> Result<()> {
        self.blocks.insert(key, own, interrupt)
    }

    /// Adds the voxels of another.
    pub(crate) fn unite(&mut self, other: &Self, interrupt: Interrupt) -> Result<()> {
        for (round, (key, theirs)) in other.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            match self.blocks.get_mut(key) {
                Some(mine) => mine.iter_mut().zip(theirs).for_each(|(a, b)| *a |= b),
                None => self.insert_block(*key, *theirs, interrupt)?,
            }
        }
        Ok(())
    }

    /// Its voxels for which `keep(block, slot)` says so.
    pub(crate) fn filtered(&self, interrupt: Interrupt, keep: impl Fn(&Around<Bits>, usize) -> bool) -> Result<Self> {
        let mut out = Self::default();
        for (round, (key, own)) in self.blocks.iter().enumerate() {
            poll_now_and_then(16 * round, interrupt)?;
            let around = Around::new(&self.blocks, *key);
            let mut kept = *own;
            slots(own).filter(|&slot| !keep(&around, slot)).for_each(|slot| bits::take(&mut kept, slot));
            if kept != [0; 8] {
                out.insert_block(*key, kept, interrupt)?;
            }
        }
        Ok(out)
    }

    /// Its voxels in a box of voxels.
    pub(crate) fn within(&self, span: &VoxelBox, interrupt: Interrupt) -> Result<Self> {
        let mut out = Self::default();
        for (round, (key, own)) in self.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            let kept = bits::common(own, &span.of_block(*key));
            if kept != [0; 8] {
                out.insert_block(*key, kept, interrupt)?;
            }
        }
        Ok(out)
    }

    /// The voxels of a block that are `among` these and belong to it, or lie some of the `steps` away from one that
    /// does.
    pub(crate) fn near(&self, key: [i32; 3], among: &Bits, steps: &[[i64; 3]]) -> Bits {
        let own = self.blocks.get(&key).copied().unwrap_or_default();
        let around = Around::new(&self.blocks, key);
        let mut out = bits::common(&own, among);
        for slot in slots(&std::array::from_fn(|word| among[word] & !own[word])) {
            if steps.iter().any(|&step| around.holds(slot, step)) {
                bits::put(&mut out, slot);
            }
        }
        out
    }

    /// First and last block on every axis, with their neighbours; the first behind the last for none.
    pub(crate) fn reach(&self) -> [[i32; 2]; 3] {
        let none = [[i32::MAX, i32::MIN]; 3];
        self.blocks.keys().fold(none, |reach, key| {
            std::array::from_fn(|i| {
                [reach[i][0].min(key[i].saturating_sub(1)), reach[i][1].max(key[i].saturating_add(1))]
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use proptest::prelude::*;
    use std::collections::HashSet;

    proptest! {
        /// Against a set of the standard library.
        #[test]
        fn is_a_set(
            a in prop::collection::vec(prop::array::uniform3(-9i64..9), 0..60),
            run in (-20i64..20, 0i64..40, -9i64..9),
        ) {
            let (mut set, mut other) = (VoxelSet::default(), VoxelSet::default());
            a.iter().for_each(|&v| set.insert(v, NEVER).unwrap());
            other.insert_run([run.0, run.0 + run.1], [run.2, 3], NEVER).unwrap();
            prop_assert_eq!(other.len() as i64, run.1);
            set.unite(&other, NEVER).unwrap();
            let all: HashSet<[i64; 3]> = a.iter().copied().chain((0..run.1).map(|i| [run.0 + i, run.2, 3])).collect();
            prop_assert_eq!(set.len() as usize, all.len());
            prop_assert!(all.iter().all(|&v| set.holds(v)));
            let half = VoxelBox([[-100, 0], [-100, 100], [-100, 100]]);
            let left = all.iter().filter(|v| v[0] < 0).count();
            prop_assert_eq!(set.within(&half, NEVER).unwrap().len() as usize, left);
            prop_assert_eq!(set.len_within(&half) as usize, left);
        }
    }
}
