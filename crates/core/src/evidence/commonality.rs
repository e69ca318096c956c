//! Dempster's rule over any number of sources, as a sum.

use super::Mass;

/// Logarithms of the commonalities q(occupied) = o+u, q(empty) = e+u, q(Θ) = u.
///
/// Dempster's rule multiplies commonalities (Shafer 1976, Th. 3.3), so sources add up here in any order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LogCommonality {
    /// ln q(occupied).
    pub occupied: f64,
    /// ln q(empty).
    pub empty: f64,
    /// ln q(Θ).
    pub unknown: f64,
}

impl LogCommonality {
    /// Adds another source.
    pub fn add(&mut self, o: &Self) {
        self.occupied += o.occupied;
        self.empty += o.empty;
        self.unknown += o.unknown;
    }

    /// The combined, normalised mass; `None` in total conflict.
    pub fn mass(&self) -> Option<Mass> {
        let top = self.occupied.max(self.empty);
        if top.is_nan() || top == f64::NEG_INFINITY {
            return None;
        }
        let (qo, qe, qu) = ((self.occupied - top).exp(), (self.empty - top).exp(), (self.unknown - top).exp());
        let n = qo + qe - qu;
        Some(Mass { occupied: ((qo - qu) / n).max(0.0), empty: ((qe - qu) / n).max(0.0), unknown: qu / n })
    }
}

impl Mass {
    /// Its logarithmic commonalities, in which combination is addition. A mass without ignorance gives −∞ in `unknown`;
    /// discount sources first.
    pub fn log_commonality(&self) -> LogCommonality {
        let q = |part: f64| (part + self.unknown).ln();
        LogCommonality { occupied: q(self.occupied), empty: q(self.empty), unknown: self.unknown.ln() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sum_equals_pairwise_rule() {
        let sources = [(0.6, 0.1), (0.2, 0.5), (0.9, 0.05), (0.0, 0.3)].map(|(o, e)| Mass::new(o, e).unwrap());
        let mut sum = LogCommonality::default();
        let mut pairwise = Mass::VACUOUS;
        for m in &sources {
            sum.add(&m.log_commonality());
            pairwise = pairwise.combine(m).unwrap();
        }
        let m = sum.mass().unwrap();
        assert!((m.occupied - pairwise.occupied).abs() < 1e-14 && (m.empty - pairwise.empty).abs() < 1e-14);
    }

    #[test]
    fn very_many_sources_neither_underflow_nor_lose_the_sum() {
        let one = Mass::new(0.3, 0.1).unwrap().log_commonality();
        let many = LogCommonality { occupied: one.occupied * 1e7, empty: one.empty * 1e7, unknown: one.unknown * 1e7 };
        let m = many.mass().unwrap();
        assert!((m.occupied + m.empty + m.unknown - 1.0).abs() < 1e-12 && m.occupied > 0.999);
        assert!(
            LogCommonality { occupied: f64::NEG_INFINITY, empty: f64::NEG_INFINITY, unknown: f64::NEG_INFINITY }
                .mass()
                .is_none()
        );
    }
}
