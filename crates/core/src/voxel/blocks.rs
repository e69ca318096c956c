//! Blocks by their numbers, and the way from voxels to them and back.

use std::collections::HashMap;

use rustc_hash::FxBuildHasher;

use super::block::{Block, EDGE};
use crate::num::sort::sort;
use crate::{Grow, Interrupt, Result, poll_now_and_then};

/// Something for every block that holds anything.
pub type BlockMap<T> = HashMap<[i32; 3], T, FxBuildHasher>;

/// A bit for every voxel of a block: bit x of byte y of word z.
pub type Bits = [u64; 8];

/// Number of the block that holds a voxel.
pub fn block_of(voxel: [i64; 3]) -> [i32; 3] {
    voxel.map(|i| i.div_euclid(EDGE) as i32)
}

/// The voxel at a slot of a block.
pub fn voxel_at(key: [i32; 3], slot: usize) -> [i64; 3] {
    let within = [slot % 8, slot / 8 % 8, slot / 64];
    [0, 1, 2].map(|i| i64::from(key[i]) * EDGE + within[i] as i64)
}

/// Whether the bit of a slot is set.
pub fn has(bits: &Bits, slot: usize) -> bool {
    bits[slot / 64] >> (slot % 64) & 1 == 1
}

/// Sets the bit of a slot.
pub fn put(bits: &mut Bits, slot: usize) {
    bits[slot / 64] |= 1 << (slot % 64);
}

/// The slots whose bits are set.
pub fn slots(bits: &Bits) -> impl Iterator<Item = usize> {
    bits.iter().enumerate().flat_map(|(word, &bits)| {
        let rest = |b: &u64| Some(b & (b - 1)).filter(|&b| b != 0);
        let left = std::iter::successors(Some(bits).filter(|&b| b != 0), rest);
        left.map(move |b| 64 * word + b.trailing_zeros() as usize)
    })
}

/// The blocks in the order of their numbers.
pub fn in_order<'a, T>(blocks: &'a BlockMap<T>, interrupt: Interrupt) -> Result<Vec<([i32; 3], &'a T)>> {
    let (mut keys, mut all) = (Vec::<[i32; 3]>::new(), Vec::new());
    keys.grow(blocks.len(), interrupt)?;
    keys.extend(blocks.keys());
    sort(&mut keys, interrupt)?;
    all.grow(keys.len(), interrupt)?;
    for (round, key) in keys.into_iter().enumerate() {
        poll_now_and_then(round, interrupt)?;
        all.push((key, &blocks[&key]));
    }
    Ok(all)
}

/// A block and its 26 neighbours: looks beyond its border without asking the map again.
pub struct Around<'a, T>([Option<&'a T>; 27]);

impl<'a, T> Around<'a, T> {
    /// Around the block numbered `key`.
    pub fn new(blocks: &'a BlockMap<T>, key: [i32; 3]) -> Self {
        Self(std::array::from_fn(|i| {
            let step = [i % 3, i / 3 % 3, i / 9];
            blocks.get(&[0, 1, 2].map(|axis| key[axis].saturating_add(step[axis] as i32 - 1)))
        }))
    }

    /// The block that holds a voxel `step` away from the one at `slot`, and its slot there; a step of at most 8 an axis.
    pub fn at(&self, slot: usize, step: [i64; 3]) -> (Option<&'a T>, usize) {
        let within = [slot % 8, slot / 8 % 8, slot / 64];
        let there = [0, 1, 2].map(|i| within[i] as i64 + step[i]);
        let [x, y, z] = there.map(|i| (i.div_euclid(EDGE) + 1) as usize);
        (self.0[(z * 3 + y) * 3 + x], Block::slot(there))
    }
}

impl Around<'_, Bits> {
    /// Whether the bit of the voxel `step` away is set.
    pub fn has(&self, slot: usize, step: [i64; 3]) -> bool {
        let (bits, slot) = self.at(slot, step);
        bits.is_some_and(|b| has(b, slot))
    }
}

/// The steps to voxels whose gap to a voxel is less than `gap` voxels, nearest first; the voxel itself alone for 0.
pub fn steps_within(gap: f64) -> Vec<[i64; 3]> {
    let reach = gap.ceil().clamp(0.0, EDGE as f64) as i64;
    let far = |s: &[i64; 3]| s.map(|i| ((i.abs() - 1).max(0) as f64).powi(2)).iter().sum::<f64>().sqrt();
    let all = -reach..=reach;
    let mut steps: Vec<[i64; 3]> = all
        .clone()
        .flat_map(|x| all.clone().flat_map(move |y| (-reach..=reach).map(move |z| [x, y, z])))
        .filter(|s| *s == [0; 3] || far(s) < gap)
        .collect();
    steps.sort_by_key(|s| s.map(|i| i * i).iter().sum::<i64>());
    steps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_are_found_across_borders() {
        let mut blocks: BlockMap<u8> = BlockMap::default();
        blocks.insert([-1, 0, 0], 1);
        blocks.insert([0, 0, 0], 2);
        blocks.insert([0, 1, 1], 3);
        let around = Around::new(&blocks, [0, 0, 0]);
        let slot = Block::slot([0, 7, 7]);
        assert_eq!(voxel_at([0, 0, 0], slot), [0, 7, 7]);
        assert_eq!(around.at(slot, [0, 0, 0]), (Some(&2), slot));
        assert_eq!(around.at(slot, [-1, 0, 0]), (Some(&1), Block::slot([-1, 7, 7])));
        assert_eq!(around.at(slot, [1, 1, 1]), (Some(&3), Block::slot([1, 8, 8])));
        assert_eq!(around.at(slot, [0, 1, 0]).0, None);
    }

    #[test]
    fn steps_grow_with_the_gap() {
        assert_eq!(steps_within(0.0), [[0; 3]]);
        assert_eq!(steps_within(0.5).len(), 27);
        assert_eq!(steps_within(1.0).len(), 27);
        // Two away along an axis is a gap of one voxel; the corners of the cube of 5 lie further away.
        assert_eq!(steps_within(1.01).len(), 27 + 6 * 9);
        assert_eq!(steps_within(0.5)[0], [0; 3]);
    }

    #[test]
    fn slots_of_bits() {
        let mut bits = [0; 8];
        bits[0] = 1;
        bits[7] = 1 << 63 | 1 << 5;
        assert_eq!(slots(&bits).collect::<Vec<_>>(), [0, 453, 511]);
    }
}
