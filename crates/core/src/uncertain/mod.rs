//! Geometry that carries its covariance (Förstner & Wrobel, *Photogrammetric Computer Vision*, 2016; Heuel 2004).
//!
//! Read in this order:
//!
//! * [`covariance`]: symmetric, positive semi-definite; propagated by Jacobians, asked by quadratic forms;
//! * [`stored`]: values as plain numbers ([`Stored`]);
//! * [`point`]: a point;
//! * [`line`]: a segment between two;
//! * [`plane`]: a plane about its centroid;
//! * [`pose`]: a rigid or similarity transform;
//! * [`join`]: lines and planes through points;
//! * [`intersect`]: where lines and planes meet;
//! * [`foot`]: nearest points;
//! * [`distance`]: how far apart;
//! * [`fit`]: best lines and planes through many points;
//! * [`transform`]: everything through an uncertain pose;
//! * [`hypothesis`]: is it the same, incident, parallel, orthogonal, coplanar? χ² tests.
//!
//! All formulae use differences of coordinates, so that projected coordinates lose nothing.

pub mod covariance;
pub mod distance;
pub mod fit;
pub mod foot;
pub mod hypothesis;
pub mod intersect;
pub mod join;
mod line;
mod plane;
mod point;
mod pose;
mod stored;
pub mod transform;

pub use line::UncertainLine;
pub use plane::UncertainPlane;
pub use point::{UncertainPoint, checked_sd};
pub use pose::{Matrix7, UncertainPose};
pub use stored::Stored;
