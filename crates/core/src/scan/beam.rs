//! One laser beam.

use crate::geometry::Vec3;

/// Most beams of a patch.
pub const MAX_BEAMS: usize = 4096;

/// One laser beam relative to its origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    /// From the origin to the return, metres; for a beam without return any vector along it.
    pub offset: Vec3,
    /// Whether something came back.
    pub returned: bool,
}
