//! Probabilities of accuracy classes, beliefs at other accuracies, tolerances, fitness of sensors.

use super::Loa;
use crate::error::{Error, Result};
use crate::num::normal::{cdf, quantile};

/// DIN 18710-1:2010, classes of positional accuracy: bounds of one standard deviation. Not to be mixed with levels of
/// accuracy, which bound two.
pub const DIN_18710: [(&str, f64, f64); 5] = [
    ("L1", 0.050, f64::INFINITY),
    ("L2", 0.015, 0.050),
    ("L3", 0.005, 0.015),
    ("L4", 0.001, 0.005),
    ("L5", 0.0, 0.001),
];

fn positive(what: &'static str, x: f64) -> Result<f64> {
    if x > 0.0 && x.is_finite() { Ok(x) } else { Err(Error::argument(what, "positive and finite", x)) }
}

impl Loa {
    /// Standard deviation of the class, metres: half its upper bound, which is meant at 95 %, 2σ.
    pub fn sigma(self) -> f64 {
        0.5 * self.upper()
    }

    /// Probability that a model of this class lies within ±`within` metres: 2Φ(x/σ)−1 (Meyer (2022), Table 5.2).
    pub fn confidence(self, within: f64) -> Result<f64> {
        Ok(2.0 * cdf(positive("the distance", within)? / self.sigma()) - 1.0)
    }
}

/// What a belief that holds within ±σ_from is worth within ±σ_to, by quantiles: 2Φ(z σ_to/σ_from)−1 with
/// z = Φ⁻¹((1+bel)/2) (Meyer (2022), Table 8.1).
pub fn convert_belief(belief: f64, sigma_from: f64, sigma_to: f64) -> Result<f64> {
    check_belief(belief)?;
    let ratio =
        positive("the standard deviation asked for", sigma_to)? / positive("the standard deviation", sigma_from)?;
    let z = quantile(0.5 * (1.0 + belief)) * ratio;
    // Certainty stays certain however small the ratio, and 0 × ∞ is 0.
    Ok(if belief >= 1.0 {
        1.0
    } else if z.is_nan() {
        0.0
    } else {
        2.0 * cdf(z) - 1.0
    })
}

/// The linear form (Meyer (2022), eq. 5.24), for comparison: bel·(2Φ(σ_to/σ_from)−1)/`divisor`, capped at 1. The source
/// divides by 2Φ(1)−1 in the text and by 0.95 in its Table 5.4. The second value tells whether it was capped.
pub fn convert_belief_linear(belief: f64, sigma_from: f64, sigma_to: f64, divisor: f64) -> Result<(f64, bool)> {
    check_belief(belief)?;
    let ratio =
        positive("the standard deviation asked for", sigma_to)? / positive("the standard deviation", sigma_from)?;
    let linear = belief * (2.0 * cdf(ratio) - 1.0) / positive("the divisor", divisor)?;
    Ok((linear.min(1.0), linear > 1.0))
}

fn check_belief(belief: f64) -> Result<()> {
    if (0.0..=1.0).contains(&belief) { Ok(()) } else { Err(Error::argument("the belief", "between 0 and 1", belief)) }
}

/// Tolerance of one object against another, from theirs: √(T₁²+T₂²), or T₁+T₂ in the worst case (Meyer (2022), eqs. 4.2
/// to 4.5). Metres, as both tolerances.
pub fn relative_tolerance(t1: f64, t2: f64, rule: &str) -> Result<f64> {
    let (t1, t2) = (positive("a tolerance", t1)?, positive("a tolerance", t2)?);
    match rule {
        "squared" => Ok(t1.hypot(t2)),
        "linear" => Ok(t1 + t2),
        _ => Err(Error::argument("the rule of the tolerance", "'squared' or 'linear'", format!("'{rule}'"))),
    }
}

/// Largest standard deviation of a sensor fit for a tolerance: T/5 to tell levels of accuracy, T/15 to prove a
/// tolerance. Metres, as the tolerance.
pub fn largest_sigma(tolerance: f64, purpose: &str) -> Result<f64> {
    let tolerance = positive("the tolerance", tolerance)?;
    match purpose {
        "loa" => Ok(tolerance / 5.0),
        "proof" => Ok(tolerance / 15.0),
        _ => Err(Error::argument("the purpose", "'loa' or 'proof'", format!("'{purpose}'"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn converting_there_and_back() {
        for bel in [0.0, 0.1, 0.5, 0.9, 0.999] {
            let there = convert_belief(bel, 0.0025, 0.004).unwrap();
            assert!((convert_belief(there, 0.004, 0.0025).unwrap() - bel).abs() < 1e-12);
        }
        assert_eq!(convert_belief(1.0, 0.1, 0.001).unwrap(), 1.0);
        // M's own example of an impossible belief: 0.85 at 2 mm gives 1.245 for LOA30.
        let (linear, capped) = convert_belief_linear(0.85, 0.002, Loa::Loa30.sigma(), 2.0 * cdf(1.0) - 1.0).unwrap();
        assert!(linear == 1.0 && capped);
    }

    #[test]
    fn bad_arguments() {
        assert!(convert_belief(1.1, 1.0, 1.0).is_err() && convert_belief(0.5, 0.0, 1.0).is_err());
        assert!(relative_tolerance(0.1, 0.1, "cubed").is_err() && largest_sigma(-1.0, "loa").is_err());
        assert!(Loa::Loa30.confidence(f64::NAN).is_err());
        assert!((relative_tolerance(0.003, 0.004, "squared").unwrap() - 0.005).abs() < 1e-15);
    }
}
