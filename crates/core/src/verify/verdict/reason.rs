//! What decides a verdict.

use super::rule::Verdict;

/// What decides; surfaces by number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// Fewer samples were seen than the rule asks for.
    TooLittleSeen,
    /// Stations contradict each other.
    Contradiction,
    /// Too few of the seen samples say anything.
    TooLittleDecided,
    /// The object's space was seen empty.
    Empty,
    /// It was, and something that no other object explains stands beside it.
    Beside,
    /// More of this face was found elsewhere than of the object at its place.
    Elsewhere(usize),
    /// This surface keeps the tolerance in too few of its places.
    Displaced(usize),
    /// This surface is mostly not there.
    SeenThrough(usize),
    /// Too little of what is decided is in place.
    OutOfPlace,
    /// In place, but not known well enough for the tolerance.
    TooUnsure,
    /// By fewer measurements than can tell.
    TooFewMeasured,
    /// In place.
    InPlace,
}

impl Reason {
    /// The verdict that follows.
    pub fn verdict(self) -> Verdict {
        match self {
            Self::TooLittleSeen | Self::TooLittleDecided | Self::TooUnsure | Self::TooFewMeasured => {
                Verdict::Unobserved
            }
            Self::Contradiction => Verdict::Conflicting,
            Self::Empty => Verdict::Absent,
            Self::Beside | Self::Elsewhere(_) | Self::Displaced(_) | Self::SeenThrough(_) | Self::OutOfPlace => {
                Verdict::Deviating
            }
            Self::InPlace => Verdict::Confirmed,
        }
    }
}
