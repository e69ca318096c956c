//! The `surface` model's sums, and the moments that they are.

use super::kernel::{BEAMS_IN_KERNEL, WEIGHT};
use super::sums::Sums;

/// Fixed-point unit of a deviation: 1/131072 m, 7.6 µm.
pub const DEVIATION: f64 = 131_072.0;

/// Sums over the beams around a sample, w their weight and d the deviation that they met; fixed point.
#[derive(Debug, Clone, Copy, Default)]
pub struct SurfaceSums {
    /// Σw over the beams that met a surface within the band.
    pub hit: i64,
    /// Σw² over these.
    pub squared: i64,
    /// Σwd.
    pub first: i64,
    /// Σwd², with the points' own variances.
    pub second: i64,
    /// Σw over the beams that passed through the face.
    pub through: i64,
}

impl SurfaceSums {
    /// By name.
    pub fn of(sums: &Sums) -> Self {
        let [hit, squared, first, second, through] = sums.parts();
        Self { hit, squared, first, second, through }
    }

    /// In the order in which they are stored.
    #[inline(always)]
    pub fn parts(self) -> [i64; Sums::PARTS] {
        [self.hit, self.squared, self.first, self.second, self.through]
    }

    /// A beam of weight `w` that met a surface at `d`, with a variance of its own.
    #[inline(always)]
    pub fn met(w: i64, d: i64, variance: i64) -> Self {
        Self { hit: w, squared: (w * w) >> 16, first: w * d, second: w * (d * d + variance), through: 0 }
    }

    /// A beam of weight `w` that passed through the face.
    #[inline(always)]
    pub fn passed(w: i64) -> Self {
        Self { through: w, ..Self::default() }
    }

    /// Adds what one beam of a patch says: 4096 of them stay below half of what the parts hold, as no deviation is more
    /// than a metre.
    #[inline(always)]
    pub fn add(&mut self, beam: Self) {
        self.hit += beam.hit;
        self.squared += beam.squared;
        self.first += beam.first;
        self.second += beam.second;
        self.through += beam.through;
    }

    /// Beams all around a sample that met the face where it is drawn: Σw = π/ln 2, Σw² half of that.
    pub fn full_kernel() -> Sums {
        let hit = (0.5 * BEAMS_IN_KERNEL * WEIGHT) as i64;
        Sums::new(4 * BEAMS_IN_KERNEL as u32, Self { hit, squared: hit / 2, ..Self::default() }.parts())
    }
}

/// What the sums of one station say.
#[derive(Debug, Clone, Copy)]
pub struct SurfaceReading {
    /// Σw over beams that met a surface within the band.
    pub hit: f64,
    /// Σw over beams that passed through the face.
    pub through: f64,
    /// Weighted mean deviation, metres, + towards the scanner.
    pub deviation: f64,
    /// Weighted variance of the deviations, m².
    pub variance: f64,
    /// Effective number of beams (Σw)²/Σw².
    pub effective: f64,
}

impl SurfaceReading {
    /// `None` when no beam was added.
    pub fn of(sums: &Sums) -> Option<Self> {
        let [hit, squared, first, second, through] = SurfaceSums::of(sums).parts().map(|p| p as f64);
        if hit + through <= 0.0 {
            return None;
        }
        let (mut deviation, mut variance, mut effective) = (0.0, 0.0, 0.0);
        if hit > 0.0 {
            deviation = first / hit;
            variance = (second / hit - deviation * deviation).max(0.0) / (DEVIATION * DEVIATION);
            deviation /= DEVIATION;
            effective = hit * hit / (squared * WEIGHT).max(1.0);
        }
        Some(Self { hit: hit / WEIGHT, through: through / WEIGHT, deviation, variance, effective })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_give_weighted_moments() {
        let mut sums = Sums::default();
        let observations = [(0.010, 1.0), (0.012, 0.5), (-0.003, 0.25)];
        for (d, w) in observations {
            sums.add_beam(SurfaceSums::met((w * WEIGHT) as i64, (d * DEVIATION) as i64, 0).parts());
        }
        sums.add_beam(SurfaceSums::passed((0.5 * WEIGHT) as i64).parts());
        let r = SurfaceReading::of(&sums).unwrap();
        let total: f64 = observations.iter().map(|o| o.1).sum();
        let mean = observations.iter().map(|o| o.0 * o.1).sum::<f64>() / total;
        let variance = observations.iter().map(|o| (o.0 - mean).powi(2) * o.1).sum::<f64>() / total;
        let effective = total * total / observations.iter().map(|o| o.1 * o.1).sum::<f64>();
        assert!((r.hit - total).abs() < 1e-4 && (r.through - 0.5).abs() < 1e-4);
        assert!((r.deviation - mean).abs() < 1e-5, "{}", r.deviation);
        assert!((r.variance - variance).abs() < 1e-6 && (r.effective - effective).abs() < 1e-2);
        assert_eq!(sums.beams(), 4);
        assert!(SurfaceReading::of(&Sums::default()).is_none());
    }
}
