//! Rules of combination for two sources.
//!
//! On the frame {occupied, empty} any two contradicting focal sets are occupied and empty themselves, and their union
//! is "unknown": Dubois and Prade's rule is then Yager's, also for more than two sources.

use super::Mass;
use crate::error::{Error, Result};

/// How two bodies of evidence become one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CombinationRule {
    /// Dempster 1967: conflict is divided out. For distinct, reliable sources. Associative.
    Dempster,
    /// Smets 1990 (TBM): conflict stays, as mass of the empty set. Associative.
    Conjunctive,
    /// Dubois & Prade 1986: at least one source is reliable. Associative.
    Disjunctive,
    /// Yager 1987: conflict becomes ignorance. Not associative; all sources at once do not depend on their order.
    Yager,
    /// Dubois & Prade 1988: conflict goes to the union of the contradicting sets. The same as Yager's on this frame.
    DuboisPrade,
    /// Smarandache & Dezert (PCR5, for two sources equal to Martin & Osswald's PCR6, 2006): conflict goes back to those
    /// who caused it, in proportion. Not associative.
    Pcr6,
    /// Murphy 2000: the average, combined with itself by Dempster as often as there are sources. Not associative; all
    /// at once do not depend on their order.
    Murphy,
    /// Denœux 2008, normalised: the least committed of the sources' weights. For sources that are not distinct; it is
    /// idempotent. Associative. Needs some ignorance in every source.
    Cautious,
}

impl CombinationRule {
    /// All rules.
    pub const ALL: [Self; 8] = [
        Self::Dempster,
        Self::Conjunctive,
        Self::Disjunctive,
        Self::Yager,
        Self::DuboisPrade,
        Self::Pcr6,
        Self::Murphy,
        Self::Cautious,
    ];

    /// SQL name.
    pub fn name(self) -> &'static str {
        ["dempster", "conjunctive", "disjunctive", "yager", "dubois_prade", "pcr6", "murphy", "cautious"][self as usize]
    }

    /// Reads a SQL name.
    pub fn parse(text: &str) -> Result<Self> {
        let expected = "one of dempster, conjunctive, disjunctive, yager, dubois_prade, pcr6, murphy, cautious";
        Self::ALL
            .into_iter()
            .find(|r| r.name() == text)
            .ok_or_else(|| Error::argument("the rule of combination", expected, format!("'{text}'")))
    }

    /// Combines two sources.
    pub fn combine(self, a: &Mass, b: &Mass) -> Result<Mass> {
        match self {
            Self::Dempster => a.combine(b),
            Self::Conjunctive => Ok(a.conjunctive(b)),
            Self::Disjunctive => Ok(disjunctive(a, b)),
            Self::Yager | Self::DuboisPrade => Ok(a.conjunctive(b).with_conflict_unknown()),
            Self::Pcr6 => Ok(pcr5(a, b)),
            Self::Murphy => {
                let mean = |f: fn(&Mass) -> f64| 0.5 * (f(a) + f(b));
                let m = Mass { occupied: mean(|m| m.occupied), empty: mean(|m| m.empty), unknown: mean(|m| m.unknown) };
                m.combine(&m)
            }
            Self::Cautious => {
                let (x, y) = (Weights::of(a)?, Weights::of(b)?);
                x.least(&y).mass()
            }
        }
    }
}

fn disjunctive(a: &Mass, b: &Mass) -> Mass {
    let (none_a, none_b) = (a.contradiction(), b.contradiction());
    let both = |x: f64, y: f64| x * y + x * none_b + none_a * y;
    let (occupied, empty) = (both(a.occupied, b.occupied), both(a.empty, b.empty));
    Mass { occupied, empty, unknown: (1.0 - occupied - empty - none_a * none_b).max(0.0) }
}

fn pcr5(a: &Mass, b: &Mass) -> Mass {
    let mut m = a.conjunctive(b);
    for (o, e) in [(a.occupied, b.empty), (b.occupied, a.empty)] {
        if o + e > 0.0 {
            let share = o * e / (o + e);
            m.occupied += share * o;
            m.empty += share * e;
        }
    }
    m
}

impl Mass {
    /// Yager's transfer: contradicting mass becomes unknown.
    pub(super) fn with_conflict_unknown(self) -> Self {
        Self { unknown: (1.0 - self.occupied - self.empty).max(0.0), ..self }
    }
}

/// Weights of the conjunctive decomposition (Denœux 2008, eq. 12) on the two hypotheses: w({occupied}) =
/// q(Θ)/q({occupied}) and likewise for empty; 1 says nothing, 0 is certainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weights {
    pub(super) occupied: f64,
    pub(super) empty: f64,
}

impl Weights {
    /// The weights of a vacuous mass.
    pub(super) const NONE: Self = Self { occupied: 1.0, empty: 1.0 };

    /// The weights of a mass with some ignorance.
    pub(super) fn of(m: &Mass) -> Result<Self> {
        if m.unknown > 0.0 {
            Ok(Self { occupied: m.unknown / (m.occupied + m.unknown), empty: m.unknown / (m.empty + m.unknown) })
        } else {
            Err(Error::argument(
                "a mass of the cautious rule",
                "one with some unknown mass (discount it first)",
                m.to_text(),
            ))
        }
    }

    /// The least committed of both.
    pub(super) fn least(&self, o: &Self) -> Self {
        Self { occupied: self.occupied.min(o.occupied), empty: self.empty.min(o.empty) }
    }

    /// The normalised mass of these weights.
    pub(super) fn mass(&self) -> Result<Mass> {
        let (o, e) = (self.empty * (1.0 - self.occupied), self.occupied * (1.0 - self.empty));
        let u = self.occupied * self.empty;
        let n = o + e + u;
        if n > 0.0 { Ok(Mass { occupied: o / n, empty: e / n, unknown: u / n }) } else { Err(Error::TotalConflict) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_mass() -> impl Strategy<Value = Mass> {
        (0.0..1.0f64, 0.0..1.0f64).prop_map(|(a, b)| Mass::new(a * 0.99, (1.0 - a * 0.99) * b * 0.99).unwrap())
    }

    fn off(a: &Mass, b: &Mass) -> f64 {
        (a.occupied - b.occupied).abs().max((a.empty - b.empty).abs()).max((a.unknown - b.unknown).abs())
    }

    proptest! {
        #[test]
        fn laws(a in any_mass(), b in any_mass(), c in any_mass()) {
            for rule in CombinationRule::ALL {
                let f = |x: &Mass, y: &Mass| rule.combine(x, y).unwrap();
                let ab = f(&a, &b);
                prop_assert!(off(&ab, &f(&b, &a)) < 1e-13, "{rule:?} commutes");
                let sum = ab.occupied + ab.empty + ab.unknown + ab.contradiction();
                prop_assert!((sum - 1.0).abs() < 1e-9 && ab.occupied >= 0.0 && ab.empty >= 0.0 && ab.unknown >= 0.0);
                if rule != CombinationRule::Conjunctive {
                    prop_assert!((ab.occupied + ab.empty + ab.unknown - 1.0).abs() < 1e-12, "{rule:?} sums to 1");
                }
                if matches!(
                    rule,
                    CombinationRule::Dempster
                        | CombinationRule::Conjunctive
                        | CombinationRule::Disjunctive
                        | CombinationRule::Cautious
                ) {
                    prop_assert!(off(&f(&ab, &c), &f(&a, &f(&b, &c))) < 1e-12, "{rule:?} associates");
                }
                let neutral = !matches!(rule, CombinationRule::Disjunctive | CombinationRule::Murphy);
                if neutral {
                    prop_assert!(off(&f(&a, &Mass::VACUOUS), &a) < 1e-12, "{rule:?} is not moved by ignorance");
                }
            }
            let twice = CombinationRule::Cautious.combine(&a, &a).unwrap();
            prop_assert!(off(&twice, &a) < 1e-12, "cautious is idempotent");
            let committed = Mass::new(a.occupied, 1.0 - a.occupied).unwrap();
            for m in [a, committed, CombinationRule::Conjunctive.combine(&a, &b).unwrap()] {
                prop_assert_eq!(m.discounted(1.0), m);
                let half = m.discounted(0.5);
                prop_assert!(half.unknown >= 0.0 && (half.contradiction() - 0.5 * m.contradiction()).abs() < 2e-9);
                prop_assert_eq!(Mass::from_text(&half.to_text()).unwrap(), half);
            }
        }
    }

    #[test]
    fn by_hand() {
        let (a, b) = (Mass::new(0.6, 0.1).unwrap(), Mass::new(0.2, 0.5).unwrap());
        // Conjunctive: o = .6·.5+.3·.2 = .36, e = .1·.8+.3·.5 = .23, u = .09, conflict .6·.5+.1·.2 = .32.
        let check = |rule: CombinationRule, o: f64, e: f64, u: f64| {
            let m = rule.combine(&a, &b).unwrap();
            let want = Mass { occupied: o, empty: e, unknown: u };
            assert!(off(&m, &want) < 1e-14, "{rule:?}: {m:?}");
        };
        check(CombinationRule::Dempster, 0.36 / 0.68, 0.23 / 0.68, 0.09 / 0.68);
        check(CombinationRule::Conjunctive, 0.36, 0.23, 0.09);
        assert!((CombinationRule::Conjunctive.combine(&a, &b).unwrap().contradiction() - 0.32).abs() < 1e-14);
        check(CombinationRule::Disjunctive, 0.12, 0.05, 0.83);
        check(CombinationRule::Yager, 0.36, 0.23, 0.41);
        check(CombinationRule::DuboisPrade, 0.36, 0.23, 0.41);
        // PCR: .6·.5 gives .18/1.1·.. to occupied .36·.5/1.1, to empty .6·.25/1.1; .2·.1 gives .04·.1/.3 and .2·.01/.3.
        check(CombinationRule::Pcr6, 0.36 + 0.18 / 1.1 + 0.004 / 0.3, 0.23 + 0.15 / 1.1 + 0.002 / 0.3, 0.09);
        // Average (.4, .3, .3) with itself: o = .16+.24 = .4, e = .09+.18 = .27, u = .09, sum .76.
        check(CombinationRule::Murphy, 0.4 / 0.76, 0.27 / 0.76, 0.09 / 0.76);
        // Weights: w_o = min(.3/.9, .3/.5) = 1/3, w_e = min(.3/.4, .3/.8) = 3/8.
        let n = 0.375 * 2.0 / 3.0 + 0.625 / 3.0 + 0.125;
        check(CombinationRule::Cautious, 0.25 / n, 0.625 / 3.0 / n, 0.125 / n);
    }

    #[test]
    fn contradiction_and_certainty() {
        let (o, e) = (Mass::new(1.0, 0.0).unwrap(), Mass::new(0.0, 1.0).unwrap());
        assert_eq!(CombinationRule::Dempster.combine(&o, &e), Err(Error::TotalConflict));
        assert_eq!(CombinationRule::Conjunctive.combine(&o, &e).unwrap().contradiction(), 1.0);
        assert_eq!(CombinationRule::Yager.combine(&o, &e).unwrap(), Mass::VACUOUS);
        assert_eq!(CombinationRule::Disjunctive.combine(&o, &e).unwrap(), Mass::VACUOUS);
        assert_eq!(CombinationRule::Pcr6.combine(&o, &e).unwrap(), Mass { occupied: 0.5, empty: 0.5, unknown: 0.0 });
        assert!(CombinationRule::Cautious.combine(&o, &e).is_err() && CombinationRule::parse("bayes").is_err());
        let m =
            CombinationRule::Conjunctive.combine(&Mass::new(0.9, 0.0).unwrap(), &Mass::new(0.0, 0.7).unwrap()).unwrap();
        assert_eq!(Mass::from_text(&m.to_text()).unwrap(), m);
    }
}
