//! Where the beams of a patch start.

/// Where the beams of a patch start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origins {
    /// All at the patch's origin: a scanner on a tripod.
    One,
    /// Each at its own place: a moving platform.
    Each,
    /// Nobody knows (dense matching, merged clouds): the points say "occupied", never "empty".
    Unknown,
}
