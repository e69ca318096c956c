//! What is known of a voxel.

use crate::error::{Error, Result};

/// What is known of a voxel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VoxelState {
    /// At least as many returns as the threshold.
    Occupied,
    /// The same, but beams passed through as well: grazed surfaces, voxels that a surface shares with space before it.
    Ambiguous,
    /// Beams passed through, and too few returned.
    Empty,
    /// Nobody looked.
    Unknown,
}

impl VoxelState {
    /// By whether a voxel holds enough returns, and whether a beam passed through.
    pub(crate) fn of(occupied: bool, traversed: bool) -> Self {
        match (occupied, traversed) {
            (true, false) => Self::Occupied,
            (true, true) => Self::Ambiguous,
            (false, true) => Self::Empty,
            (false, false) => Self::Unknown,
        }
    }

    /// SQL text: `occupied`, `ambiguous`, `empty`, `unknown`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Occupied => "occupied",
            Self::Ambiguous => "ambiguous",
            Self::Empty => "empty",
            Self::Unknown => "unknown",
        }
    }

    /// Reads [`VoxelState::name`].
    pub fn parse(text: &str) -> Result<Self> {
        [Self::Occupied, Self::Ambiguous, Self::Empty, Self::Unknown]
            .into_iter()
            .find(|s| s.name() == text)
            .ok_or_else(|| Error::argument("a state", "occupied, ambiguous, empty or unknown", text))
    }
}
