//! One laser beam.

use crate::geometry::Vec3;

/// Most beams of a patch.
pub const MAX_BEAMS: usize = 4096;

/// One laser beam relative to where it starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    /// From where the beam starts to its return, metres, along the world's axes; for a beam without return any vector
    /// along it.
    pub offset: Vec3,
    /// Whether something came back.
    pub returned: bool,
}
