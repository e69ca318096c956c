//! A layer of voxels as a picture.

use super::value::Occupancy;
use crate::error::{Error, Limited, Result};
use crate::geometry::Vec3;
use crate::voxel::lattice::VoxelState;
use crate::voxel::lattice::block_map::voxel_at;
use crate::{Interrupt, poll_now_and_then};

/// Most voxels of a picture.
const MAX_PIXELS: i64 = 50_000_000;

/// States of a layer of voxels, row by row: 0 unknown, 1 empty, 2 occupied, 3 ambiguous.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slice {
    /// Rows along the later of the other two axes, values along the earlier one.
    pub rows: usize,
    /// Values in a row.
    pub columns: usize,
    /// The states.
    pub states: Vec<i32>,
}

impl Occupancy {
    /// The layer of voxels at a coordinate (metres) on an axis (0 to 2), as far as anything is known.
    pub fn slice(&self, axis: usize, at: f64, threshold: u8, interrupt: Interrupt) -> Result<Slice> {
        let layer = self.grid.index(&Vec3::ith(axis, at))?[axis];
        let [u, v] = [[1, 2], [0, 2], [0, 1]][axis];
        let of_layer = |key: &[i32; 3]| i64::from(key[axis]) == layer.div_euclid(8);
        let blocks: Vec<_> = self.sorted(interrupt)?.into_iter().filter(|(key, _)| of_layer(key)).collect();
        let range = |k: usize| {
            let numbers = || blocks.iter().map(|(key, _)| i64::from(key[k]) * 8);
            numbers().min().zip(numbers().max()).map_or([0, 0], |(a, b)| [a, b + 8])
        };
        let ([u_low, u_end], [v_low, v_end]) = (range(u), range(v));
        let (columns, rows) = (u_end - u_low, v_end - v_low);
        if columns * rows > MAX_PIXELS {
            let value = format!("{columns} x {rows} voxels");
            return Err(Error::Limit { what: Limited::Slice, value, limit: format!("{MAX_PIXELS} voxels") });
        }
        let of_none = if self.is_model() { 1 } else { 0 };
        let mut states = vec![of_none; (columns * rows) as usize];
        for (round, (key, block)) in blocks.into_iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            for slot in 0..512 {
                let voxel = voxel_at(key, slot);
                if voxel[axis] == layer {
                    let place = (voxel[v] - v_low) * columns + voxel[u] - u_low;
                    states[place as usize] = match block.state(slot, threshold) {
                        VoxelState::Unknown => of_none,
                        VoxelState::Empty => 1,
                        VoxelState::Occupied => 2,
                        VoxelState::Ambiguous => 3,
                    };
                }
            }
        }
        Ok(Slice { rows: rows as usize, columns: columns as usize, states })
    }
}
