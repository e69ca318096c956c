//! Range noise that grows as less light comes back.

use crate::error::{Error, Result};

/// Variance of a range ∝ (reference / intensity)^exponent below the reference, where `sigma_range` holds. Shot noise is
/// exponent 1; measured curves lie between 1 and 2 (Wujanz et al. 2017, σ = a Iᵇ + c with b from −0.5 to −1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntensityNoise {
    /// Intensity from which on `sigma_range` holds, in the sensor's own unit, 1 to 65535.
    pub reference: u16,
    /// In 64ths, 1 to 255.
    exponent: u8,
}

/// No beam is worth less than this part of a bright one.
const MIN_SHARE: f32 = 1.0 / 64.0;

impl IntensityNoise {
    /// Checks the range of both. The reference in the sensor's unit, the exponent without unit.
    pub fn new(reference: i32, exponent: f64) -> Result<Self> {
        let in_range = u16::try_from(reference).ok().filter(|r| *r > 0);
        let reference =
            in_range.ok_or_else(|| Error::argument("the reference intensity", "between 1 and 65535", reference))?;
        let in_64ths = (exponent * 64.0).round();
        if !(1.0..=255.0).contains(&in_64ths) {
            return Err(Error::argument("the exponent", "between 0.016 and 3.98", exponent));
        }
        Ok(Self { reference, exponent: in_64ths as u8 })
    }

    /// The exponent, to 1/64. Without unit.
    pub fn exponent(&self) -> f64 {
        f64::from(self.exponent) / 64.0
    }

    /// What a beam of this intensity is worth beside one of the reference: the ratio of the variances.
    pub fn share(&self, intensity: u16) -> f32 {
        let ratio = f32::from(intensity) / f32::from(self.reference);
        if ratio >= 1.0 { 1.0 } else { ratio.powf(self.exponent() as f32).max(MIN_SHARE) }
    }

    /// For the upper three bytes of the model's word; 0 is none.
    pub(super) fn packed(noise: Option<Self>) -> u32 {
        noise.map_or(0, |n| u32::from(n.reference) << 16 | u32::from(n.exponent) << 8)
    }

    pub(super) fn unpacked(word: u32) -> Option<Self> {
        let (reference, exponent) = ((word >> 16) as u16, (word >> 8) as u8);
        (reference > 0 && exponent > 0).then_some(Self { reference, exponent })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dark_beams_weigh_less_and_it_survives_packing() {
        let n = IntensityNoise::new(1000, 1.0).unwrap();
        assert_eq!((n.share(5000), n.share(1000), n.share(500), n.share(0)), (1.0, 1.0, 0.5, MIN_SHARE));
        assert_eq!(IntensityNoise::unpacked(IntensityNoise::packed(Some(n)) | 1), Some(n));
        assert_eq!(IntensityNoise::unpacked(1), None);
        for (reference, exponent) in [(0, 1.0), (70_000, 1.0), (-1, 1.0), (10, 0.0), (10, 5.0), (10, f64::NAN)] {
            assert!(IntensityNoise::new(reference, exponent).is_err());
        }
    }
}
