//! Blocks by their numbers, and the way from voxels to them and back.

use rustc_hash::FxBuildHasher;

use super::bits::EDGE;
use crate::num::piece_map::PieceMap;

/// Something for every block that holds anything.
pub type BlockMap<T> = PieceMap<[i32; 3], T, FxBuildHasher>;

/// Number of the block that holds a voxel.
pub fn block_of(voxel: [i64; 3]) -> [i32; 3] {
    voxel.map(|i| i.div_euclid(EDGE) as i32)
}

/// The voxel at a slot of a block.
pub fn voxel_at(key: [i32; 3], slot: usize) -> [i64; 3] {
    let within = [slot % 8, slot / 8 % 8, slot / 64];
    [0, 1, 2].map(|i| i64::from(key[i]) * EDGE + within[i] as i64)
}
