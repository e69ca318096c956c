//! A model in voxels: the set that a solid fills. Read in this order:
//!
//! * [`fill_rule`]: which voxels a solid fills;
//! * [`voxel_set`]: a set of voxels, a bit each;
//! * [`region`]: everything, or a set and what lies near it, to be counted;
//! * [`columns`]: where columns of voxels pass through a mesh;
//! * [`inside`]: the voxels between such crossings;
//! * [`surface`]: the voxels that a triangle passes through;
//! * [`cover`]: the set of a solid, by one or both of them.

mod columns;
mod cover;
mod fill_rule;
mod inside;
mod region;
mod surface;
mod voxel_set;

pub use fill_rule::FillRule;
pub use region::Region;
pub use voxel_set::VoxelSet;
