//! Beams of patches carved into a tile: where they return, and the voxels that they pass. Read in this order:
//!
//! * [`traverse`]: a segment, voxel by voxel;
//! * [`local_origin`]: voxels counted from a near one;
//! * [`ray`]: a way through empty space;
//! * [`tile`]: the tile that is carved, and one ray through it;
//! * [`line`]: a ray as a line through slabs along an axis;
//! * [`raster`]: cells of nearly equal angle;
//! * [`incidence`]: at which angle rays meet what they hit;
//! * [`fan`]: the space between neighbouring rays of one origin;
//! * [`turn`]: bits turned from the axes of a bundle to those of the lattice;
//! * [`bitmap`]: a slab of voxels in bits;
//! * [`bundle`]: many rays, carved slab by slab;
//! * [`patch`]: all beams of a patch.

mod bitmap;
mod bundle;
mod fan;
mod incidence;
mod line;
mod local_origin;
mod patch;
mod raster;
mod ray;
mod tile;
mod traverse;
mod turn;

pub use patch::{absorb, concerns};
pub use tile::CarvedTile;
pub use traverse::traverse;
