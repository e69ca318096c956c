//! What became of a voxel between two epochs, or between model and epoch.

use crate::error::{Error, Result};

/// ChangeClass of a voxel that is occupied in at least one of two epochs (Meyer, 4.1.2 and 4.1.3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum ChangeClass {
    /// Occupied in both, to the tolerance.
    Confirmed = 1,
    /// Seen empty before, occupied now; against a model: built, but not drawn.
    New = 2,
    /// Occupied before, seen empty now; against a model: drawn, but seen empty.
    Disappeared = 3,
    /// Occupied in one, not seen in the other.
    Unknown = 4,
    /// Occupied in one; in the other beams passed, but some returned nearby, too few for the threshold.
    Ambiguous = 5,
}

impl ChangeClass {
    /// All classes, in the order of Meyer's Table 7.3.
    pub const ALL: [Self; 5] = [Self::Confirmed, Self::New, Self::Disappeared, Self::Unknown, Self::Ambiguous];

    /// SQL text between two epochs.
    pub fn name(self) -> &'static str {
        ["confirmed", "new", "disappeared", "unknown", "ambiguous"][self as usize - 1]
    }

    /// Reads [`ChangeClass::name`]; a change against a model may say `unmodelled` and `absent` or `demolished` too.
    pub fn parse(text: &str) -> Result<Self> {
        match text {
            "unmodelled" => Ok(Self::New),
            "absent" | "demolished" => Ok(Self::Disappeared),
            _ => Self::ALL
                .into_iter()
                .find(|c| c.name() == text)
                .ok_or_else(|| Error::argument("a class", "confirmed, new, disappeared, unknown or ambiguous", text)),
        }
    }
}
