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
//! * [`origin`]: where a scanner stood, from its points alone;
//! * [`verify`]: what the beams say about a solid ([`verify::Evidence`]) and the verdict;
//! * [`voxel`]: which places are occupied, empty or unknown ([`voxel::Occupancy`]), and what changed.
//!
//! # Frames and units
//!
//! Lengths are metres, angles radians, an uncertainty is a standard deviation (σ) and a covariance holds its squares;
//! a name that says otherwise (`_squared`, `variance`, `_cos`) means it. All frames have the axes of the world (the
//! reference system of the model and of the registered scans) and differ only in where they begin:
//!
//! | frame | begins at | what is in it |
//! | --- | --- | --- |
//! | world | the reference system's zero | [`geometry::Solid`], [`geometry::Aabb`], all of [`uncertain`], the `origin`, `points` and `hull` of a [`scan::PatchHeader`], the triangles that beams are aimed at (`verify`'s `Target`), [`verify::StationOrigin`], [`voxel::Grid::tile`]. A [`uncertain::UncertainPose`] leads from a source frame to a target frame, which its user names; its translation and its errors are in the target frame |
//! | local of an object | `reference`: the centre of the solid's box, rounded to whole metres | the samples of [`verify::Evidence`] (`local(i)`, kept in single precision) and what is worked out from them: balls of blocks, points without origin, the points of the built surface |
//! | patch-local | the header's `origin` | where the beams of a [`scan::Beams`] start and end (`start(i)`, `end(i)`) |
//! | scanner-relative | where the beam starts | [`scan::Beam::offset`], directions and ranges of a [`scan::RangeImage`], the `offset` that leads to a sample, the places that beams speak of. For a tripod it is the patch-local frame; a [`scan::RangeImage`] adds image coordinates (u, v) in the plane at unit distance along its cone's axis |
//! | voxels | the lattice's zero, or while beams are carved a voxel near the patch (`LocalOrigin`) | numbers of voxels and of blocks: places divided by the edge of a voxel |
//!
//! Frames that are turned against the world's (a scanner's own, a map's) end where files are read; within a function, a
//! fit may choose axes of its own. A deviation is a length along a unit normal, positive in front of the face: along
//! the outward normal in results; in the sums of a station towards the scanner, or along the normal where the station
//! has no single place.
//!
//! Whatever a caller can get wrong comes back as [`Error`]; a panic is a bug.

#![forbid(unsafe_code)]
#![deny(missing_docs)]
// Contents pages link to what they hand on, which is not public by itself.
#![allow(rustdoc::private_intra_doc_links)]

pub mod budget;
pub mod error;
pub mod evidence;
pub mod geometry;
pub mod num;
pub mod origin;
pub mod scan;
pub mod uncertain;
pub mod verify;
pub mod voxel;

pub use budget::{AtOnce, Budget, Grow, Interrupt, NEVER};
pub use error::{Error, Result};

pub(crate) use budget::{poll, poll_now_and_then, room};
