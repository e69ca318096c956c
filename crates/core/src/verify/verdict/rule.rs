//! What can be said of an object, and what the user asks for before it is.

use super::thresholds::{MIN_PRESENT, MIN_WITHIN};

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

/// What a verdict asks of an object beyond its tolerance: shares, without unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerdictRule {
    /// Least share of all samples that must be seen.
    pub min_coverage: f64,
    /// Least share of each well-seen surface that must keep the tolerance.
    pub min_within: f64,
    /// Least share of what is decided that must show the object in place.
    pub min_present: f64,
    /// Mean conflict between stations from which nothing else is said.
    pub max_conflict: f64,
}

impl Default for VerdictRule {
    fn default() -> Self {
        Self { min_coverage: 0.02, min_within: MIN_WITHIN, min_present: MIN_PRESENT, max_conflict: 0.3 }
    }
}

impl VerdictRule {
    /// The rule of the one share that SQL's `min_confirmed` is: above [`MIN_WITHIN`] it is asked of every surface,
    /// below [`MIN_PRESENT`] of what is decided. Without unit.
    pub fn with_min_confirmed(self, share: f64) -> Self {
        Self { min_within: share.max(MIN_WITHIN), min_present: share.min(MIN_PRESENT), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_share_asks_two_things() {
        let asked = |share| {
            let rule = VerdictRule::default().with_min_confirmed(share);
            (rule.min_within, rule.min_present)
        };
        assert_eq!(asked(0.3), (0.95, 0.3));
        assert_eq!(asked(0.6), (0.95, 0.6));
        assert_eq!(asked(0.98), (0.98, 0.6));
    }
}
