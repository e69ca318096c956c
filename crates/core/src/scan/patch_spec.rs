//! What the beams of a patch have in common.

use super::origins::Origins;
use super::spacing::Spacing;
use crate::geometry::Vec3;

/// What the beams of a patch have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchSpec {
    /// Where the beams start.
    pub origins: Origins,
    /// The scanner position's number, as the user keeps it.
    pub station: i64,
    /// The one origin of the beams, or a reference point near them; world metres.
    pub origin: Vec3,
    /// How far neighbouring beams are apart.
    pub spacing: Spacing,
    /// Unit of the packed coordinates, metres.
    pub quantum: f64,
}
