//! Space in voxels: which places of an epoch are occupied, empty or unknown, and what changed.
//!
//! A [`Grid`] fixes the lattice (by the reference system, not by the data) and the tile of it that is looked at. Beams
//! of patches are carved into an [`Occupancy`]: per voxel how many returns it holds and whether a beam passed through.
//! The state of a voxel is a question to it, with a threshold (Meyer, ch. 4). A solid fills a [`VoxelSet`],
//! which makes an occupancy of which everything is known. Two occupancies make a [`VoxelChange`]; what is new or
//! gone comes in connected [`ChangeComponent`]s.
//!
//! Read in this order, the way of the data; each room uses only those above it:
//!
//! * [`lattice`]: voxels, blocks of them, the stored form of a tile;
//! * [`carve`]: beams of patches, carved into the blocks of a tile;
//! * [`model`]: solids, as sets of voxels;
//! * [`occupancy`]: what is known of a tile, by beams or by a model;
//! * [`change`]: what became of it.

mod carve;
mod change;
mod lattice;
mod model;
mod occupancy;

pub use carve::traverse;
pub use change::{ChangeClass, ChangeComponent, ChangeSettings, ChangeTally, VoxelChange};
pub use lattice::{Grid, TileHeader, VoxelAccuracy, VoxelBox, VoxelState};
pub use model::{FillRule, VoxelSet};
pub use occupancy::{KnownBlock, Occupancy, Slice, StateTally};
