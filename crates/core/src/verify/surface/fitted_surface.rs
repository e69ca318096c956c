//! One smooth surface of the object, as built.

use super::compact::CompactDeviation;
use super::observations::SeenSample;
use super::station_shares::StationShares;
use crate::num::normal::cdf;
use crate::verify::model::EvidenceModel;
use crate::{Interrupt, Result, poll_now_and_then};

/// No surface is rougher than this, metres: what lies farther off is clutter.
pub const MAX_ROUGHNESS_M: f64 = 0.015;
/// USIBD: a class holds when this share of the deviations keeps its bound.
const WITHIN: f64 = 0.95;

/// One smooth surface of the object, as built.
#[derive(Debug)]
pub struct FittedSurface {
    /// Most of the seen samples follow one trend.
    pub coherent: bool,
    /// Samples on it.
    pub inliers: u64,
    /// How many independent measurements they are worth.
    pub independent: f64,
    /// 95 % of the deviations are no larger than this, metres.
    pub quantile: f64,
    /// Standard deviation of where it is, metres: registration, the model, and the mean of the samples.
    pub sd: f64,
}

impl FittedSurface {
    /// From its seen samples with their deviations.
    pub fn of(
        coherent: bool,
        seen: &[SeenSample],
        deviations: &[CompactDeviation],
        shares: &StationShares,
        model: &EvidenceModel,
        interrupt: Interrupt,
    ) -> Result<Self> {
        let mut sizes = Vec::with_capacity(deviations.len());
        let mut independent = 0.0;
        for (i, (s, deviation)) in seen.iter().zip(deviations).enumerate() {
            poll_now_and_then(i, interrupt)?;
            if let Some(d) = deviation.get() {
                sizes.push(d.abs());
                independent += f64::from(s.independence);
            }
        }
        let mut quantile = |share: f64| match sizes.len() {
            0 => 0.0,
            n => f64::from(*sizes.select_nth_unstable_by(((n as f64 * share) as usize).min(n - 1), f32::total_cmp).1),
        };
        let (most, half) = (quantile(WITHIN), quantile(0.5));
        let random = half.min(MAX_ROUGHNESS_M).powi(2) / independent.max(1.0);
        let sd = (shares.common_variance(model) + random).sqrt();
        Ok(Self { coherent, inliers: sizes.len() as u64, independent, quantile: most, sd })
    }

    /// How likely the surface keeps ±`tolerance` metres in the sense of USIBD.
    pub fn holds(&self, tolerance: f64) -> f64 {
        within(self.quantile, self.sd, tolerance)
    }

    /// Whether it more likely keeps ±`tolerance` metres than not, by measurements that can tell.
    pub fn is_known_to_hold(&self, tolerance: f64) -> bool {
        self.coherent && 1.96 * self.sd <= tolerance && self.holds(tolerance) >= 0.5
    }
}

/// Probability that what was measured as `deviation` lies within ±`tolerance`.
fn within(deviation: f64, sd: f64, tolerance: f64) -> f64 {
    let below = |x: f64| cdf((x - deviation) / sd.max(1e-9));
    below(tolerance) - below(-tolerance)
}
