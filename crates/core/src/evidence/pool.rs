//! Any number of sources combined at once, in any order.

use super::rule::{CombinationRule, Weights};
use super::{Hypothesis, Mass};
use crate::error::{Error, Result};
use crate::num::bytes::{ByteReader, Put};

/// A sum with twice the precision (Knuth's two-sum): of the logarithms of a product's factors, and how many were ln 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct LogProduct {
    high: f64,
    low: f64,
    zeros: u64,
}

impl LogProduct {
    fn multiply(&mut self, factor: f64) {
        if factor > 0.0 { self.add(factor.ln()) } else { self.zeros += 1 }
    }

    fn add(&mut self, x: f64) {
        let sum = self.high + x;
        let part = sum - self.high;
        self.low += (self.high - (sum - part)) + (x - part);
        self.high = sum;
    }

    fn merge(&mut self, o: &Self) {
        self.add(o.high);
        self.low += o.low;
        self.zeros += o.zeros;
    }

    /// The product.
    fn value(&self) -> f64 {
        if self.zeros > 0 { 0.0 } else { (self.high + self.low).exp() }
    }

    /// The quotient of this and another, as a logarithm: the leading parts cancel first, so that ten million terms lose
    /// nothing.
    fn log_ratio(&self, o: &Self) -> f64 {
        match (self.zeros > 0, o.zeros > 0) {
            (false, false) => (self.high - o.high) + (self.low - o.low),
            (true, _) => f64::NEG_INFINITY,
            (false, true) => f64::INFINITY,
        }
    }
}

/// Sources pooled by one rule; two pools of the same rule can be merged.
///
/// The conjunctive family multiplies commonalities (Shafer 1976, Th. 3.3), the disjunctive rule implicabilities: both
/// are kept as sums of logarithms, so that neither order nor number matters. Murphy's rule keeps the sum of masses, the
/// cautious one the least weights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pool {
    rule: CombinationRule,
    count: u64,
    /// Products of q or b of occupied, of empty and of the third set (Θ, or ∅ for the disjunctive rule).
    occupied: LogProduct,
    empty: LogProduct,
    third: LogProduct,
    /// Sums of masses, also with twice the precision.
    sums: [LogProduct; 3],
    weights: Weights,
}

impl Pool {
    /// No source yet. [`CombinationRule::Pcr6`] needs all combinations of its sources, 3ⁿ, and is refused.
    pub fn new(rule: CombinationRule) -> Result<Self> {
        if rule == CombinationRule::Pcr6 {
            let expected = "one that needs no list of its sources (combine two by two, in an order you state)";
            return Err(Error::argument("the rule of an aggregate", expected, "'pcr6'"));
        }
        let none = LogProduct::default();
        Ok(Self { rule, count: 0, occupied: none, empty: none, third: none, sums: [none; 3], weights: Weights::NONE })
    }

    /// The rule.
    pub fn rule(&self) -> CombinationRule {
        self.rule
    }

    /// The error for a group with two rules.
    pub fn other_rule(a: CombinationRule, b: CombinationRule) -> Error {
        let expected = "the same for all rows of a group";
        Error::argument("the rule of combination", expected, format!("{} and {}", a.name(), b.name()))
    }

    /// Adds a source.
    pub fn add(&mut self, m: &Mass) -> Result<()> {
        self.count += 1;
        match self.rule {
            CombinationRule::Murphy => {
                self.sums.iter_mut().zip([m.occupied, m.empty, m.unknown]).for_each(|(sum, x)| sum.add(x));
            }
            CombinationRule::Cautious => self.weights = self.weights.least(&Weights::of(m)?),
            CombinationRule::Disjunctive => {
                let none = m.contradiction();
                self.occupied.multiply(none + m.occupied);
                self.empty.multiply(none + m.empty);
                self.third.multiply(none);
            }
            _ => {
                self.occupied.multiply(m.occupied + m.unknown);
                self.empty.multiply(m.empty + m.unknown);
                self.third.multiply(m.unknown);
            }
        }
        Ok(())
    }

    /// Adds the sources of another pool.
    pub fn merge(&mut self, o: &Self) -> Result<()> {
        if self.rule != o.rule {
            return Err(Self::other_rule(self.rule, o.rule));
        }
        self.count += o.count;
        self.occupied.merge(&o.occupied);
        self.empty.merge(&o.empty);
        self.third.merge(&o.third);
        self.sums.iter_mut().zip(&o.sums).for_each(|(a, b)| a.merge(b));
        self.weights = self.weights.least(&o.weights);
        Ok(())
    }

    /// The combined mass; `None` without a source.
    pub fn mass(&self) -> Result<Option<Mass>> {
        if self.count == 0 {
            return Ok(None);
        }
        Ok(Some(match self.rule {
            CombinationRule::Murphy => return self.murphy().map(Some),
            CombinationRule::Cautious => self.weights.mass()?,
            CombinationRule::Disjunctive => {
                let none = self.third.value();
                let (occupied, empty) = (self.occupied.value() - none, self.empty.value() - none);
                Mass { occupied, empty, unknown: (1.0 - occupied - empty - none).max(0.0) }
            }
            CombinationRule::Dempster => self.normalised()?,
            CombinationRule::Conjunctive => self.conjunctive(),
            _ => self.conjunctive().with_conflict_unknown(),
        }))
    }

    fn conjunctive(&self) -> Mass {
        let unknown = self.third.value();
        let more = |q: &LogProduct| (q.value() - unknown).max(0.0);
        Mass { occupied: more(&self.occupied), empty: more(&self.empty), unknown }
    }

    /// o = q_o − q_u, e = q_e − q_u, u = q_u over their sum, all relative to the larger of q_o and q_e.
    fn normalised(&self) -> Result<Mass> {
        let e_over_o = self.empty.log_ratio(&self.occupied);
        if self.occupied.zeros > 0 && self.empty.zeros > 0 {
            return Err(Error::TotalConflict);
        }
        let (top, ratio) = if e_over_o <= 0.0 { (&self.occupied, e_over_o) } else { (&self.empty, -e_over_o) };
        let log_unknown = self.third.log_ratio(top);
        let unknown = log_unknown.exp();
        // 1 − q_u/q_top without cancellation.
        let (most, least) = (-log_unknown.exp_m1(), (ratio.exp() - unknown).max(0.0));
        let n = most + least + unknown;
        let (most, least, unknown) = (most / n, least / n, unknown / n);
        let (occupied, empty) = if e_over_o <= 0.0 { (most, least) } else { (least, most) };
        Ok(Mass { occupied, empty, unknown })
    }

    fn murphy(&self) -> Result<Mass> {
        let n = self.count as f64;
        let [occupied, empty, unknown] = self.sums.map(|s| (s.high + s.low) / n);
        let mean = Mass { occupied, empty, unknown };
        let mut dempster = Self::new(CombinationRule::Dempster)?;
        dempster.add(&mean)?;
        for q in [&mut dempster.occupied, &mut dempster.empty, &mut dempster.third] {
            q.high *= n;
        }
        dempster.normalised()
    }

    /// Bytes of the form in which parallel workers exchange pools.
    pub const LEN: usize = 4 + 8 + 6 * 24 + 16;

    /// The form for another parallel worker.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(Self::LEN);
        out.put_u32(self.rule as u32);
        out.put_i64(self.count as i64);
        for q in [&self.occupied, &self.empty, &self.third].into_iter().chain(&self.sums) {
            out.put_f64(q.high);
            out.put_f64(q.low);
            out.put_i64(q.zeros as i64);
        }
        out.put_f64(self.weights.occupied);
        out.put_f64(self.weights.empty);
        out
    }

    /// Reads the form from another parallel worker.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        let mut r = ByteReader::new(bytes, "the state of ab_combine_agg");
        let rule = r.u32()?;
        let rule = *CombinationRule::ALL.get(rule as usize).ok_or_else(|| r.bad(format!("unknown rule {rule}")))?;
        let count = r.i64()? as u64;
        let mut product = || Ok(LogProduct { high: r.f64()?, low: r.f64()?, zeros: r.i64()? as u64 });
        let (occupied, empty, third) = (product()?, product()?, product()?);
        let sums = [product()?, product()?, product()?];
        let weights = Weights { occupied: r.f64()?, empty: r.f64()? };
        r.finish()?;
        Ok(Self { rule, count, occupied, empty, third, sums, weights })
    }
}

impl Mass {
    /// Pignistic probability (Smets 1990): the unknown mass shared out, contradiction divided out. `None` where all is
    /// contradiction.
    pub fn pignistic(&self, h: Hypothesis) -> Option<f64> {
        let sum = self.occupied + self.empty + self.unknown;
        (sum > 0.0).then(|| (self.belief(h) + 0.5 * self.unknown) / sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;
    use num_traits::{One, ToPrimitive, Zero};
    use rand::seq::SliceRandom;
    use rand::{Rng, SeedableRng};

    fn rational(x: f64) -> BigRational {
        BigRational::from_float(x).unwrap()
    }

    /// Dempster over all sources in exact arithmetic, from the definition: every combination of focal sets.
    fn exact(masses: &[Mass]) -> [BigRational; 3] {
        let mut state = [BigRational::zero(), BigRational::zero(), BigRational::one()];
        for m in masses {
            let [o, e, u] = [m.occupied, m.empty, m.unknown].map(rational);
            let [a, b, c] = &state;
            state = [a * (&o + &u) + c * &o, b * (&e + &u) + c * &e, c * &u];
        }
        let n: BigRational = state.iter().sum();
        state.map(|s| s / &n)
    }

    fn pooled(rule: CombinationRule, masses: &[Mass]) -> Mass {
        let mut pool = Pool::new(rule).unwrap();
        masses.iter().for_each(|m| pool.add(m).unwrap());
        pool.mass().unwrap().unwrap()
    }

    /// Masses in 1/1024, which binary holds exactly.
    fn dyadic(rng: &mut impl Rng) -> Mass {
        let o = rng.random_range(0..1000);
        let e = rng.random_range(0..1024 - o);
        Mass::new(f64::from(o) / 1024.0, f64::from(e) / 1024.0).unwrap()
    }

    #[test]
    fn equals_exact_rationals() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        for n in [1, 2, 3, 10, 60] {
            let masses: Vec<Mass> = (0..n).map(|_| dyadic(&mut rng)).collect();
            let (got, want) = (pooled(CombinationRule::Dempster, &masses), exact(&masses));
            for (g, w) in [got.occupied, got.empty, got.unknown].into_iter().zip(want) {
                let off = (rational(g) - &w).to_f64().unwrap().abs();
                assert!(off <= 1e-15 + 1e-12 * w.to_f64().unwrap(), "{n}: {g} is off by {off:e}");
            }
        }
    }

    #[test]
    fn equals_pairwise_for_associative_rules() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(2);
        for rule in [
            CombinationRule::Dempster,
            CombinationRule::Conjunctive,
            CombinationRule::Disjunctive,
            CombinationRule::Cautious,
        ] {
            let masses: Vec<Mass> = (0..7).map(|_| dyadic(&mut rng)).collect();
            let pairwise = masses[1..].iter().fold(masses[0], |a, b| rule.combine(&a, b).unwrap());
            let got = pooled(rule, &masses);
            assert!((got.occupied - pairwise.occupied).abs() < 1e-13, "{rule:?}: {got:?} {pairwise:?}");
            assert!((got.empty - pairwise.empty).abs() < 1e-13, "{rule:?}: {got:?} {pairwise:?}");
        }
        for rule in CombinationRule::ALL.into_iter().filter(|r| *r != CombinationRule::Pcr6) {
            let two = [dyadic(&mut rng), dyadic(&mut rng)];
            let (got, want) = (pooled(rule, &two), rule.combine(&two[0], &two[1]).unwrap());
            assert!((got.occupied - want.occupied).abs().max((got.unknown - want.unknown).abs()) < 1e-14, "{rule:?}");
        }
    }

    /// Two million sources that nearly balance: neither order nor grouping makes a difference.
    #[test]
    fn order_and_grouping_do_not_matter() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(3);
        let half: Vec<Mass> = (0..1_000_000)
            .map(|_| Mass::new(rng.random_range(0.1..0.5), rng.random_range(0.1..0.5)).unwrap())
            .collect();
        let mirrored = half.iter().map(|m| Mass { occupied: m.empty, empty: m.occupied, ..*m });
        let mut all: Vec<Mass> = half.iter().copied().chain(mirrored).collect();
        // They cancel, so that one further source decides.
        all.push(Mass::new(0.6, 0.1).unwrap());
        for rule in [CombinationRule::Dempster, CombinationRule::Murphy] {
            let first = pooled(rule, &all);
            for _ in 0..3 {
                all.shuffle(&mut rng);
                let mut pools: Vec<Pool> = Vec::new();
                for part in all.chunks(rng.random_range(100_000..900_000)) {
                    let mut pool = Pool::new(rule).unwrap();
                    part.iter().for_each(|m| pool.add(m).unwrap());
                    pools.push(Pool::from_bytes(&pool.to_bytes()).unwrap());
                }
                let mut whole = pools.pop().unwrap();
                pools.iter().for_each(|p| whole.merge(p).unwrap());
                let again = whole.mass().unwrap().unwrap();
                let tolerance = 1e-10;
                assert!((again.occupied - first.occupied).abs() < tolerance, "{rule:?}: {first:?} {again:?}");
            }
            if rule == CombinationRule::Dempster {
                // What is left is the last source's odds: (0.6+0.3)/(0.1+0.3).
                assert!((first.occupied / first.empty - 0.9 / 0.4).abs() < 1e-9, "{first:?}");
            }
        }
    }

    #[test]
    fn certainty_conflict_and_nothing() {
        let pool = |masses: &[Mass]| {
            let mut p = Pool::new(CombinationRule::Dempster).unwrap();
            masses.iter().for_each(|m| p.add(m).unwrap());
            p.mass()
        };
        let (o, e) = (Mass::new(1.0, 0.0).unwrap(), Mass::new(0.0, 1.0).unwrap());
        let some = Mass::new(0.2, 0.3).unwrap();
        assert_eq!(pool(&[]).unwrap(), None);
        assert_eq!(pool(&[o, some]).unwrap().unwrap(), o);
        assert_eq!(pool(&[e, some, e]).unwrap().unwrap(), e);
        assert_eq!(pool(&[o, e]), Err(Error::TotalConflict));
        assert!(Pool::new(CombinationRule::Pcr6).is_err());
    }
}
