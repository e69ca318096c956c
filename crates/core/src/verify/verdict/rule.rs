//! What can be said of an object, and what the user asks for before it is.

use super::thresholds::MIN_WITHIN;

/// What can be said of an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Built, within the tolerance.
    Confirmed,
    /// Built, but not where it was drawn.
    Deviating,
    /// Its space was seen empty.
    Absent,
    /// Too little of it was seen to say.
    Unobserved,
    /// Stations contradict each other.
    Conflicting,
}

impl Verdict {
    /// SQL text.
    pub fn name(self) -> &'static str {
        ["confirmed", "deviating", "absent", "unobserved", "conflicting"][self as usize]
    }
}

/// Thresholds of the verdict, all shares of samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerdictRule {
    /// Least share of all samples that must be seen.
    pub min_coverage: f64,
    /// Least share of each well-seen surface that must keep the tolerance (0.75 where less is given), and, up to 0.6,
    /// of what is decided that must be in place.
    pub min_confirmed: f64,
    /// Mean conflict between stations from which nothing else is said.
    pub max_conflict: f64,
}

impl Default for VerdictRule {
    fn default() -> Self {
        Self { min_coverage: 0.02, min_confirmed: 0.6, max_conflict: 0.3 }
    }
}

impl VerdictRule {
    /// Share of a well-seen surface that must keep the tolerance.
    pub(super) fn min_within(&self) -> f64 {
        self.min_confirmed.max(MIN_WITHIN)
    }
}
