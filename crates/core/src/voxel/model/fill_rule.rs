//! Which voxels a solid fills.

use crate::error::{Error, Result};

/// Which voxels a solid fills.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FillRule {
    /// Those whose centre lies inside; a closed solid.
    Centre,
    /// Those that it touches at all; a closed solid.
    Cover,
    /// Those that its surface passes through; open surfaces too.
    Surface,
}

impl FillRule {
    /// Reads `centre`, `cover`, `surface`.
    pub fn parse(text: &str) -> Result<Self> {
        match text {
            "centre" => Ok(Self::Centre),
            "cover" => Ok(Self::Cover),
            "surface" => Ok(Self::Surface),
            _ => Err(Error::argument("the rule", "centre, cover or surface", text)),
        }
    }
}
