//! From the echoes of a footprint to a range.

use rand::Rng;
use rand_distr::{Distribution, StandardNormal};

use crate::optics::Echo;

/// How a scanner turns light into ranges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Receiver {
    /// Echoes nearer to each other than this along the beam are one, metres: half the length of the pulse.
    pub resolution_m: f64,
    /// Standard deviation of a range however bright the echo, metres.
    pub sigma_floor_m: f64,
    /// Standard deviation that the signal adds where its power is `reference_power`, metres; it goes with the root of
    /// the power's inverse, as the noise of light does.
    pub sigma_signal_m: f64,
    /// Power (see [`crate::optics`]) for which `sigma_signal_m` is stated.
    pub reference_power: f64,
    /// Weakest echo that is found.
    pub min_power: f64,
}

impl Receiver {
    /// Power of a white surface (reflectivity 0.8) at 10 m, perpendicular: the reference of data sheets.
    pub const WHITE_AT_10_M: f64 = 0.008;

    /// Standard deviation of a range, metres, by the power of its echo.
    pub fn sigma(&self, power: f64) -> f64 {
        self.sigma_floor_m.hypot(self.sigma_signal_m * (self.reference_power / power).sqrt())
    }

    /// The echo that is reported, with the noise of its range: the strongest, with those that fall into one with it;
    /// `None` where all are too weak.
    pub fn range(&self, echoes: &mut [Echo], rng: &mut impl Rng) -> Option<Echo> {
        let merged = self.strongest(echoes)?;
        let noise: f64 = StandardNormal.sample(rng);
        let range = merged.range + self.sigma(merged.power) * noise;
        (merged.power >= self.min_power).then_some(Echo { range, ..merged })
    }

    /// The strongest group of echoes that are one to the receiver: their power and their centre of mass; it is said to
    /// be of the owner of the strongest of them.
    fn strongest(&self, echoes: &mut [Echo]) -> Option<Echo> {
        echoes.sort_unstable_by(|a, b| a.range.total_cmp(&b.range));
        let mut best: Option<Echo> = None;
        let mut start = 0;
        while start < echoes.len() {
            let end = start + echoes[start..].partition_point(|e| e.range <= echoes[start].range + self.resolution_m);
            let group = &echoes[start..end];
            let power: f64 = group.iter().map(|e| e.power).sum();
            let range = group.iter().map(|e| e.power * e.range).sum::<f64>() / power;
            if power > best.map_or(0.0, |b| b.power) {
                let main = group.iter().max_by(|a, b| a.power.total_cmp(&b.power));
                best = main.map(|main| Echo { range, power, owner: main.owner });
            }
            start = end;
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;

    const RECEIVER: Receiver = Receiver {
        resolution_m: 0.5,
        sigma_floor_m: 0.001,
        sigma_signal_m: 0.001,
        reference_power: Receiver::WHITE_AT_10_M,
        min_power: 3e-5,
    };

    fn echo(range: f64, power: f64) -> Echo {
        Echo { range, power, owner: 0 }
    }

    #[test]
    fn noise_is_as_stated_and_grows_with_range() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(2);
        for (range, cos) in [(5.0, 1.0), (10.0, 1.0), (10.0, 0.2), (40.0, 1.0)] {
            let power = 0.8 * cos / (range * range);
            let errors: Vec<f64> = (0..20_000)
                .map(|_| RECEIVER.range(&mut [echo(range, power)], &mut rng).unwrap().range - range)
                .collect();
            let sd = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
            let mean = errors.iter().sum::<f64>() / errors.len() as f64;
            assert!((sd / RECEIVER.sigma(power) - 1.0).abs() < 0.02 && mean.abs() < 0.03 * sd, "{range}: {sd}");
        }
        assert!((RECEIVER.sigma(Receiver::WHITE_AT_10_M) - 0.001 * 2f64.sqrt()).abs() < 1e-12);
        assert_eq!(RECEIVER.range(&mut [echo(50.0, 1e-5)], &mut rng), None);
    }

    #[test]
    fn near_echoes_mix_and_far_ones_do_not() {
        let near = [echo(4.0, 3.0), echo(4.4, 1.0)];
        let mixed = RECEIVER.strongest(&mut near.clone()).unwrap();
        assert!((mixed.range - 4.1).abs() < 1e-12 && mixed.power == 4.0);
        let far = [echo(4.6, 1.0), echo(4.0, 3.0)];
        assert_eq!(RECEIVER.strongest(&mut far.clone()).unwrap(), far[1]);
    }
}
