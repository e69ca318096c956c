//! Space in voxels: which places of an epoch are occupied, empty or unknown.
//!
//! A [`Grid`] fixes the lattice (by the reference system, not by the data) and the tile of it that is looked at. Beams of
//! patches become an [`Occupancy`]: per voxel how many returns it holds and whether a beam passed through, in [`Block`]s
//! of 8 × 8 × 8. The state of a voxel is a question to it, with a threshold (Meyer, ch. 4).

mod block;
mod carve;
mod grid;
mod march;
mod occupancy;
mod occupancy_bytes;
mod slab;

pub use block::{Block, State};
pub use grid::{Grid, Span};
pub use march::march;
pub use occupancy::Occupancy;
pub use occupancy_bytes::OccupancyHeader;
