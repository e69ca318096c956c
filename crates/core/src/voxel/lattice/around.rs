//! The voxels around a voxel, beyond the border of its block too.

use super::bits::{Bits, EDGE, holds, slot_of};
use super::block_map::BlockMap;

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

    /// The block that holds a voxel `step` away from the one at `slot`, and its slot there; a step of at most 8 per
    /// axis.
    pub fn at(&self, slot: usize, step: [i64; 3]) -> (Option<&'a T>, usize) {
        let within = [slot % 8, slot / 8 % 8, slot / 64];
        let there = [0, 1, 2].map(|i| within[i] as i64 + step[i]);
        let [x, y, z] = there.map(|i| (i.div_euclid(EDGE) + 1) as usize);
        (self.0[(z * 3 + y) * 3 + x], slot_of(there))
    }
}

impl Around<'_, Bits> {
    /// Whether the bit of the voxel `step` away is set.
    pub fn holds(&self, slot: usize, step: [i64; 3]) -> bool {
        let (bits, slot) = self.at(slot, step);
        bits.is_some_and(|b| holds(b, slot))
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
    use super::super::block_map::voxel_at;
    use super::*;
    use crate::NEVER;

    #[test]
    fn neighbours_are_found_across_borders() {
        let mut blocks: BlockMap<u8> = BlockMap::default();
        blocks.insert([-1, 0, 0], 1, NEVER).unwrap();
        blocks.insert([0, 0, 0], 2, NEVER).unwrap();
        blocks.insert([0, 1, 1], 3, NEVER).unwrap();
        let around = Around::new(&blocks, [0, 0, 0]);
        let slot = slot_of([0, 7, 7]);
        assert_eq!(voxel_at([0, 0, 0], slot), [0, 7, 7]);
        assert_eq!(around.at(slot, [0, 0, 0]), (Some(&2), slot));
        assert_eq!(around.at(slot, [-1, 0, 0]), (Some(&1), slot_of([-1, 7, 7])));
        assert_eq!(around.at(slot, [1, 1, 1]), (Some(&3), slot_of([1, 8, 8])));
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
}
