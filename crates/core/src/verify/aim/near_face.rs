//! The drawn face that a point without a beam belongs to.

use crate::geometry::Vec3;

/// The drawn face that a point lies nearest to, and where from it.
#[derive(Debug, Clone, Copy)]
pub struct NearFace {
    /// Outward unit normal.
    pub normal: Vec3,
    /// Metres in front of the face's plane.
    pub height: f64,
    /// Metres beside the face's edge; 0 above the face.
    pub beside: f64,
}

impl NearFace {
    /// The distance from the face, metres, positive in front of it.
    pub fn deviation(&self) -> f64 {
        if self.beside == 0.0 { self.height } else { self.height.hypot(self.beside).copysign(self.height) }
    }
}
