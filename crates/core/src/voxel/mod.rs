//! Space in voxels: which places of an epoch are occupied, empty or unknown, and what changed.
//!
//! A [`Grid`] fixes the lattice (by the reference system, not by the data) and the tile of it that is looked at. Beams of
//! patches become an [`Occupancy`]: per voxel how many returns it holds and whether a beam passed through, in [`Block`]s
//! of 8 × 8 × 8. The state of a voxel is a question to it, with a threshold (Meyer, ch. 4). A solid drawn in voxels is a
//! [`Mask`], and an occupancy of which everything is known. Two occupancies make a [`Change`]; what is new or gone comes
//! in connected [`Component`]s.

mod accuracy;
mod block;
mod block_bytes;
mod blocks;
mod carve;
mod change;
mod change_bytes;
mod class;
mod component;
mod fan;
mod filter;
mod grid;
mod incidence;
mod march;
mod mask;
mod occupancy;
mod occupancy_bytes;
mod raster;
mod slab;
mod slice;
mod surface;
mod tally;

pub use accuracy::VoxelAccuracy;
pub use block::{Block, State};
pub use block_bytes::TileHeader;
pub use change::{Change, Settings};
pub use class::Class;
pub use component::Component;
pub use grid::{Grid, Span};
pub use march::march;
pub use mask::{Mask, Rule};
pub use occupancy::Occupancy;
pub use slice::Slice;
pub use tally::{ChangeTally, StateTally};
