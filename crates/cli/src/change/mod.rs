//! What changed between two epochs, or between model and epoch.
//!
//! * [`tiles`]: the comparison, tile by tile;
//! * [`tally`]: voxels of objects, of components and in total;
//! * [`report`]: the same, printed;
//! * [`export`]: coloured voxels as PLY, LAS or LAZ.

pub mod export;
pub mod report;
pub mod tally;
pub mod tiles;
