//! The lattice: voxels, and blocks of eight by eight by eight of them with a bit or a count for each. Read in this
//! order:
//!
//! * [`bits`]: a bit for every voxel of a block;
//! * [`voxel_box`]: voxels from a first to a last one on every axis;
//! * [`grid`]: the voxels of the reference system, and the tile that is looked at;
//! * [`accuracy`]: what a voxel size supports;
//! * [`state`]: what is known of a voxel;
//! * [`block`]: what beams say of the voxels of a block;
//! * [`block_map`]: blocks by their numbers;
//! * [`around`]: the voxels around a voxel;
//! * [`tile_format`]: header and seal of a stored tile;
//! * [`block_bytes`]: numbers and bits of its blocks.

mod accuracy;
mod around;
pub mod bits;
mod block;
pub mod block_bytes;
pub mod block_map;
mod grid;
mod state;
mod tile_format;
mod voxel_box;

pub use accuracy::VoxelAccuracy;
pub use around::{Around, steps_within};
pub use bits::{Bits, EDGE};
pub use block::VoxelBlock;
pub use block_map::BlockMap;
pub use grid::Grid;
pub use state::VoxelState;
pub use tile_format::{TileFormat, TileHeader};
pub use voxel_box::VoxelBox;
