//! Exact geometry of building objects: boxes, meshes, what they enclose and the faces they are seen by. Read in this
//! order:
//!
//! * [`coordinate`]: how large a coordinate may be;
//! * [`perpendicular`]: axes across an axis;
//! * [`aabb`]: boxes along the axes;
//! * [`split`]: boxes divided over two index pages;
//! * [`hilbert`]: boxes along a curve;
//! * [`box_statistics`]: how many boxes overlap, for the planner;
//! * [`weld`]: vertices at one place as one;
//! * [`closedness`]: whether a mesh bounds a volume;
//! * [`orient`]: triangles turned to look outward;
//! * [`parts`]: panes, leaves and the rest of a mesh;
//! * [`solid`]: the mesh of an object;
//! * [`solid_bytes`]: the same, stored;
//! * [`adjacency`]: triangles beside each other;
//! * [`face_kind`]: what stands as drawn, may move, or lets beams pass;
//! * [`face`]: triangles that make a face;
//! * [`triangulate`]: polygons as triangles;
//! * [`ewkb`]: solids as PostGIS writes them.

mod aabb;
mod adjacency;
mod box_statistics;
mod closedness;
mod coordinate;
mod ewkb;
mod face;
mod face_kind;
mod hilbert;
mod orient;
mod parts;
mod perpendicular;
mod solid;
mod solid_bytes;
pub mod split;
mod triangulate;
mod weld;

pub use aabb::Aabb;
pub(crate) use adjacency::Adjacency;
pub use box_statistics::{BoxRelation, BoxStatistics};
pub use closedness::Closedness;
pub(crate) use coordinate::check_coordinates;
pub use ewkb::SurfaceKind;
pub(crate) use face::BLUNT_EDGE_COS;
pub use face::{Faces, group_faces};
pub use face_kind::FaceKind;
pub use hilbert::hilbert;
pub use orient::orient;
pub use parts::{Part, Parts};
pub(crate) use perpendicular::perpendiculars;
pub use solid::Solid;
pub use solid_bytes::SolidHeader;

/// A point or vector in metres.
pub type Vec3 = nalgebra::Vector3<f64>;
