//! What changed between two epochs, or between model and epoch.
//!
//! * [`classes`]: what became of each object;
//! * [`tiles`]: the comparison, tile by tile;
//! * [`tally`]: voxels of objects, of components and in total;
//! * [`report`]: the same, printed;
//! * [`export`]: coloured voxels as PLY, LAS or LAZ.

pub mod classes;
pub mod export;
pub mod report;
pub mod tally;
pub mod tiles;
