//! Blocks by their numbers, and the way from voxels to them and back.

use std::collections::HashMap;

use rustc_hash::FxBuildHasher;

use super::bits::EDGE;
use crate::num::sort::sort;
use crate::{Grow, Interrupt, Result, poll_now_and_then};

/// Something for every block that holds anything.
pub type BlockMap<T> = HashMap<[i32; 3], T, FxBuildHasher>;

/// Number of the block that holds a voxel.
pub fn block_of(voxel: [i64; 3]) -> [i32; 3] {
    voxel.map(|i| i.div_euclid(EDGE) as i32)
}

/// The voxel at a slot of a block.
pub fn voxel_at(key: [i32; 3], slot: usize) -> [i64; 3] {
    let within = [slot % 8, slot / 8 % 8, slot / 64];
    [0, 1, 2].map(|i| i64::from(key[i]) * EDGE + within[i] as i64)
}

/// The blocks in the order of their numbers, as `view` shows them.
pub fn in_order<'a, T, V>(
    blocks: &'a BlockMap<T>,
    interrupt: Interrupt,
    view: impl Fn(&'a T) -> V,
) -> Result<Vec<([i32; 3], V)>> {
    let (mut keys, mut all) = (Vec::<[i32; 3]>::new(), Vec::new());
    keys.grow(blocks.len(), interrupt)?;
    keys.extend(blocks.keys());
    sort(&mut keys, interrupt)?;
    all.grow(keys.len(), interrupt)?;
    for (round, key) in keys.into_iter().enumerate() {
        poll_now_and_then(round, interrupt)?;
        all.push((key, view(&blocks[&key])));
    }
    Ok(all)
}

/// Puts a block that is not there yet.
pub fn insert<T>(blocks: &mut BlockMap<T>, key: [i32; 3], block: T, interrupt: Interrupt) -> Result<()> {
    blocks.grow(1, interrupt)?;
    blocks.insert(key, block);
    Ok(())
}

/// The block numbered `key`, made where it is missing.
pub fn made<'a, T: Default>(blocks: &'a mut BlockMap<T>, key: [i32; 3], interrupt: Interrupt) -> Result<&'a mut T> {
    blocks.grow(1, interrupt)?;
    Ok(blocks.entry(key).or_default())
}
