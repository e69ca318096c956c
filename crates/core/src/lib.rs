//! The mathematics and data layouts of asbuilt, free of PostgreSQL and of I/O.
//!
//! Read in this order; each module uses only those above it:
//!
//! * [`error`]: what a caller can get wrong;
//! * [`budget`]: time and memory that long work may take;
//! * [`num`]: the normal distribution, byte cursors, shortest decimal text;
//! * [`geometry`]: boxes, triangle meshes ([`geometry::Solid`]), their faces;
//! * [`uncertain`]: points, lines, planes and poses with covariance, and tests on them;
//! * [`evidence`]: belief masses, Dempster's rule, the published ray model, levels of accuracy;
//! * [`scan`]: beams from one origin, packed in angular tiles ([`scan::Patch`]);
//! * [`verify`]: what the beams say about a solid ([`verify::Evidence`]) and the verdict;
//! * [`voxel`]: which places are occupied, empty or unknown ([`voxel::Occupancy`]), and what changed.
//!
//! Lengths are metres, angles radians. Whatever a caller can get wrong comes back as [`Error`]; a panic is a bug.

#![forbid(unsafe_code)]
#![deny(missing_docs)]
// Contents pages link to what they hand on, which is not public by itself.
#![allow(rustdoc::private_intra_doc_links)]

pub mod budget;
pub mod error;
pub mod evidence;
pub mod geometry;
pub mod num;
pub mod scan;
pub mod uncertain;
pub mod verify;
pub mod voxel;

pub use budget::{AtOnce, Budget, Grow, Interrupt, NEVER};
pub use error::{Error, Result};

pub(crate) use budget::{poll, poll_now_and_then, room};
