//! Geometry that carries its covariance (Förstner & Wrobel, *Photogrammetric Computer Vision*, 2016; Heuel 2004).
//!
//! * [`covariance`]: symmetric, positive semi-definite; propagated by Jacobians, asked by quadratic forms;
//! * [`Point`], [`Line`], [`Plane`], [`Pose`]: the values, each stored as plain numbers ([`Stored`]);
//! * [`join`]: lines and planes through points; [`intersect`]; [`foot`] points; [`distance`]s; best [`fit`]s;
//! * [`transform`]: everything through an uncertain pose;
//! * [`test`]: is it the same, incident, parallel, orthogonal, coplanar? χ² tests.
//!
//! All formulae use differences of coordinates, so that projected coordinates lose nothing.

pub mod covariance;
pub mod distance;
pub mod fit;
pub mod foot;
pub mod intersect;
pub mod join;
mod line;
mod plane;
mod point;
mod pose;
mod stored;
pub mod test;
pub mod transform;

pub use line::Line;
pub use plane::Plane;
pub use point::{Point, checked_sd};
pub use pose::{Matrix7, Pose};
pub use stored::Stored;
