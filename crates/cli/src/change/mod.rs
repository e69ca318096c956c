//! What changed between two epochs, or between model and epoch.
//!
//! * [`tiles`]: the comparison, tile by tile, into a temporary table;
//! * [`report`]: objects, components and the whole, printed;
//! * [`export`]: coloured voxels as PLY, LAS or LAZ.

pub mod export;
pub mod report;
pub mod tiles;
