//! How uncertain a mass is, and what to decide on it.

use super::{Hypothesis, Mass};
use crate::error::{Error, Result};

/// The measure by which a hypothesis is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Criterion {
    /// Belief: what speaks for it.
    Belief,
    /// Plausibility: what does not speak against it.
    Plausibility,
    /// Pignistic probability: a fair bet.
    Pignistic,
}

impl Criterion {
    /// Reads `belief`, `plausibility` or `pignistic`.
    pub fn parse(text: &str) -> Result<Self> {
        match text {
            "belief" => Ok(Self::Belief),
            "plausibility" => Ok(Self::Plausibility),
            "pignistic" => Ok(Self::Pignistic),
            _ => Err(Error::argument("the criterion", "'belief', 'plausibility' or 'pignistic'", format!("'{text}'"))),
        }
    }

    /// The measure's value with contradiction divided out, so that all three share a scale.
    fn of(self, m: &Mass, h: Hypothesis) -> f64 {
        let whole = 1.0 - m.contradiction();
        match self {
            _ if whole <= 0.0 => 0.0,
            Self::Belief => m.belief(h) / whole,
            Self::Plausibility => m.plausibility(h) / whole,
            Self::Pignistic => m.pignistic(h).unwrap_or(0.0),
        }
    }
}

impl Mass {
    /// The hypothesis whose measure reaches `threshold` and exceeds the other's; `None` where it is undecided.
    /// The threshold lies between 0 and 1.
    pub fn decide(&self, criterion: Criterion, threshold: f64) -> Result<Option<Hypothesis>> {
        if !(0.0..=1.0).contains(&threshold) {
            return Err(Error::argument("the threshold", "between 0 and 1", threshold));
        }
        let (o, e) = (criterion.of(self, Hypothesis::Occupied), criterion.of(self, Hypothesis::Empty));
        Ok(match () {
            () if o >= threshold && o > e => Some(Hypothesis::Occupied),
            () if e >= threshold && e > o => Some(Hypothesis::Empty),
            () => None,
        })
    }

    /// Nonspecificity, bits (Dubois & Prade 1985): Σ m(A) log₂|A|, here the unknown mass.
    pub fn nonspecificity(&self) -> f64 {
        self.unknown
    }

    /// Discord, bits (Klir & Ramer 1990): −Σ m(A) log₂ Σ m(B)|A∩B|/|B|; how much the sources behind it contradict.
    pub fn discord(&self) -> f64 {
        let part = |m: f64, h: Hypothesis| match self.pignistic(h) {
            Some(p) if m > 0.0 => -m * p.log2(),
            _ => 0.0,
        };
        part(self.occupied, Hypothesis::Occupied) + part(self.empty, Hypothesis::Empty)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn belief_pignistic_plausibility(o in 0.0..1.0f64, x in 0.0..1.0f64) {
            let m = Mass::new(o, (1.0 - o) * x).unwrap();
            for h in [Hypothesis::Occupied, Hypothesis::Empty] {
                let p = m.pignistic(h).unwrap();
                prop_assert!(m.belief(h) <= p + 1e-15 && p <= m.plausibility(h) + 1e-15);
            }
            prop_assert!(m.discord() >= 0.0 && m.discord() + m.nonspecificity() <= 1.0 + 1e-12);
        }
    }

    #[test]
    fn by_hand() {
        let coin = Mass::new(0.5, 0.5).unwrap();
        assert_eq!((coin.nonspecificity(), coin.discord()), (0.0, 1.0));
        assert_eq!((Mass::VACUOUS.nonspecificity(), Mass::VACUOUS.discord()), (1.0, 0.0));
        let m = Mass::new(0.6, 0.1).unwrap();
        assert!((m.discord() - (-0.6 * 0.75f64.log2() - 0.1 * 0.25f64.log2())).abs() < 1e-15);
        assert_eq!(m.decide(Criterion::Belief, 0.95).unwrap(), None);
        assert_eq!(m.decide(Criterion::Pignistic, 0.7).unwrap(), Some(Hypothesis::Occupied));
        assert_eq!(m.decide(Criterion::Plausibility, 0.3).unwrap(), Some(Hypothesis::Occupied));
        assert_eq!(Mass::VACUOUS.decide(Criterion::Plausibility, 0.5).unwrap(), None);
        assert!(m.decide(Criterion::Belief, 1.5).is_err() && Criterion::parse("gut").is_err());
    }
}
