//! A point without a beam, as it is met at one sample.

use crate::geometry::Vec3;

/// What a point says at one sample. Local metres.
#[derive(Debug, Clone, Copy)]
pub struct PointTouch {
    /// Kernel weight, 1 at the foot of the point.
    pub weight: f64,
    /// How far in front of the face the point lies, along the outward normal, metres; towards the scanner once it is
    /// ready to be added to the sums of a station with one place.
    pub deviation: f64,
    /// The point's own variance along that normal, m².
    pub variance: f64,
    /// The point.
    pub point_local: Vec3,
    /// The sample, and the outward normal of its face.
    pub sample_local: Vec3,
    pub normal: Vec3,
}
