//! Belief masses on the frame {occupied, empty}.

use crate::error::{Error, Result};
use crate::num::text::{number, numbers};

/// A basic belief assignment: mass on occupied, on empty, and on their union ("unknown").
///
/// Sums to 1, except for unnormalised masses (the conjunctive rule of the transferable belief model, Smets 1990): what
/// is missing there is [`Mass::contradiction`], the mass of the empty set.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Mass {
    /// m({occupied}).
    pub occupied: f64,
    /// m({empty}).
    pub empty: f64,
    /// m(Θ): explicit ignorance.
    pub unknown: f64,
}

/// An element of the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hypothesis {
    /// Something is there.
    Occupied,
    /// Nothing is there.
    Empty,
}

/// Masses sum to 1 within this.
const ROUNDING: f64 = 1e-9;

impl Hypothesis {
    /// Reads `occupied` or `empty`.
    pub fn parse(text: &str) -> Result<Self> {
        match text {
            "occupied" => Ok(Self::Occupied),
            "empty" => Ok(Self::Empty),
            _ => Err(Error::argument("the hypothesis", "'occupied' or 'empty'", format!("'{text}'"))),
        }
    }
}

impl Mass {
    /// Knowing nothing: neutral under Dempster's rule.
    pub const VACUOUS: Self = Self { occupied: 0.0, empty: 0.0, unknown: 1.0 };

    /// A mass from its two committed parts; the rest is unknown.
    pub fn new(occupied: f64, empty: f64) -> Result<Self> {
        let share = |what, x: f64| {
            if (0.0..=1.0).contains(&x) { Ok(x) } else { Err(Error::argument(what, "between 0 and 1", x)) }
        };
        let (occupied, empty) = (share("the mass of occupied", occupied)?, share("the mass of empty", empty)?);
        let sum = occupied + empty;
        if sum > 1.0 + 1e-12 {
            return Err(Error::argument("the sum of the masses of occupied and empty", "at most 1", sum));
        }
        Ok(Self { occupied, empty, unknown: (1.0 - sum).max(0.0) })
    }

    /// bel(h): what is committed to `h` (Meyer (2022), eqs. 5.20 and 5.22). Between 0 and 1.
    pub fn belief(&self, h: Hypothesis) -> f64 {
        match h {
            Hypothesis::Occupied => self.occupied,
            Hypothesis::Empty => self.empty,
        }
    }

    /// pl(h): what does not speak against `h` (Meyer (2022), eqs. 5.21 and 5.23). Between 0 and 1.
    pub fn plausibility(&self, h: Hypothesis) -> f64 {
        self.belief(h) + self.unknown
    }

    /// The mass discounted by the source's reliability α in [0, 1] (Shafer): the rest goes to unknown.
    pub fn discounted(&self, alpha: f64) -> Self {
        let unknown = (alpha * self.unknown + (1.0 - alpha)).clamp(0.0, 1.0);
        Self { occupied: alpha * self.occupied, empty: alpha * self.empty, unknown }
    }

    /// [`Mass::discounted`] by an unchecked number.
    pub fn discount(&self, reliability: f64) -> Result<Self> {
        if (0.0..=1.0).contains(&reliability) {
            Ok(self.discounted(reliability))
        } else {
            Err(Error::argument("the reliability", "between 0 and 1", reliability))
        }
    }

    /// The conjunctive rule: Dempster's before conflict is divided out.
    pub(super) fn conjunctive(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        Self {
            occupied: a.occupied * (b.occupied + b.unknown) + a.unknown * b.occupied,
            empty: a.empty * (b.empty + b.unknown) + a.unknown * b.empty,
            unknown: a.unknown * b.unknown,
        }
    }

    /// Dempster's rule (Meyer (2022), eqs. 5.14 to 5.18) for distinct sources; [`Error::TotalConflict`] when they
    /// exclude each other.
    pub fn combine(&self, other: &Self) -> Result<Self> {
        let Self { occupied, empty, unknown } = self.conjunctive(other);
        let sum = occupied + empty + unknown;
        if sum <= 0.0 {
            return Err(Error::TotalConflict);
        }
        Ok(Self { occupied: occupied / sum, empty: empty / sum, unknown: unknown / sum })
    }

    /// Mass that two sources put on contradictory hypotheses: Shafer's conflict K.
    pub fn conflict(&self, other: &Self) -> f64 {
        self.occupied * other.empty + self.empty * other.occupied
    }

    /// m(∅): what contradicting sources put on nothing at all. Less than 1e-9 is rounding and counts as none.
    /// Between 0 and 1.
    pub fn contradiction(&self) -> f64 {
        let rest = 1.0 - (self.occupied + self.empty + self.unknown);
        if rest > ROUNDING { rest } else { 0.0 }
    }

    /// Text form `(occupied,empty,unknown)`, and `(occupied,empty,unknown,contradiction)` where there is one.
    pub fn to_text(&self) -> String {
        let mut text = format!("({},{},{}", number(self.occupied), number(self.empty), number(self.unknown));
        if self.contradiction() > 0.0 {
            text += &format!(",{}", number(self.contradiction()));
        }
        text + ")"
    }

    /// Reads [`Mass::to_text`]'s form; all that is written must sum to 1 within 1e-9.
    pub fn from_text(text: &str) -> Result<Self> {
        let bad = || Error::syntax("ab_mass", text);
        let body = text.trim().strip_prefix('(').and_then(|t| t.strip_suffix(')')).ok_or_else(bad)?;
        let [o, e, u, contradiction] =
            numbers::<4>(body).or_else(|| numbers::<3>(body).map(|[o, e, u]| [o, e, u, 0.0])).ok_or_else(bad)?;
        let m = Self::from_parts(o, e, u)?;
        let sum = o + e + u + contradiction;
        if (sum - 1.0).abs() > ROUNDING {
            return Err(Error::argument("the sum of the masses", "1", sum));
        }
        Ok(m)
    }

    /// A mass from its three parts, kept bit by bit; what they miss of 1 is contradiction.
    pub fn from_parts(occupied: f64, empty: f64, unknown: f64) -> Result<Self> {
        for (what, x) in
            [("the mass of occupied", occupied), ("the mass of empty", empty), ("the unknown mass", unknown)]
        {
            if !(0.0..=1.0).contains(&x) {
                return Err(Error::argument(what, "between 0 and 1", x));
            }
        }
        let sum = occupied + empty + unknown;
        if sum > 1.0 + ROUNDING {
            return Err(Error::argument("the sum of the masses", "at most 1", sum));
        }
        Ok(Self { occupied, empty, unknown })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    pub(super) fn any_mass() -> impl Strategy<Value = Mass> {
        (0.0..1.0f64, 0.0..1.0f64).prop_map(|(a, b)| Mass::new(a * 0.99, (1.0 - a * 0.99) * b * 0.99).unwrap())
    }

    fn close(a: &Mass, b: &Mass, tol: f64) -> bool {
        (a.occupied - b.occupied).abs() < tol && (a.empty - b.empty).abs() < tol && (a.unknown - b.unknown).abs() < tol
    }

    proptest! {
        #[test]
        fn combination_is_commutative_associative_and_has_a_neutral_mass(
            a in any_mass(),
            b in any_mass(),
            c in any_mass(),
        ) {
            prop_assert!(close(&a.combine(&b).unwrap(), &b.combine(&a).unwrap(), 1e-14));
            let left = a.combine(&b).unwrap().combine(&c).unwrap();
            let right = a.combine(&b.combine(&c).unwrap()).unwrap();
            prop_assert!(close(&left, &right, 1e-12));
            prop_assert!(close(&a.combine(&Mass::VACUOUS).unwrap(), &a, 1e-15));
            prop_assert!((left.occupied + left.empty + left.unknown - 1.0).abs() < 1e-12);
        }

        #[test]
        fn text_round_trips(a in any_mass()) {
            prop_assert_eq!(Mass::from_text(&a.to_text()).unwrap(), a);
        }
    }

    #[test]
    fn shafer_by_hand() {
        // (.6,0,.4) with (.5,.2,.3): occupied .6·.8+.4·.5=.68, empty .4·.2=.08, unknown .12, conflict .12.
        let m = Mass::new(0.6, 0.0).unwrap().combine(&Mass::new(0.5, 0.2).unwrap()).unwrap();
        assert!(close(&m, &Mass { occupied: 0.68 / 0.88, empty: 0.08 / 0.88, unknown: 0.12 / 0.88 }, 1e-15));
    }

    #[test]
    fn total_conflict_and_bad_masses_are_errors() {
        let (o, e) = (Mass::new(1.0, 0.0).unwrap(), Mass::new(0.0, 1.0).unwrap());
        assert_eq!(o.combine(&e), Err(Error::TotalConflict));
        assert!(Mass::new(0.7, 0.4).is_err() && Mass::new(f64::NAN, 0.0).is_err() && Mass::new(-0.1, 0.0).is_err());
        for bad in ["", "(1,0)", "(0.5,0.2,0.2)", "(2,-1,0)", "(a,b,c)"] {
            assert!(Mass::from_text(bad).is_err(), "{bad}");
        }
    }
}
