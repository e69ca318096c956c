//! Order statistics for robust location and spread.

/// Standard deviation of a median against that of a mean, for a normal sample: √(π/2).
pub const MEDIAN_SD: f64 = 1.2533;
/// Tukey's constant for 95 % efficiency at the normal distribution.
const TUKEY: f64 = 4.685;

/// Tukey's biweight of a residual that has this spread (σ).
pub fn tukey(residual: f64, spread: f64) -> f64 {
    let part = residual / (TUKEY * spread);
    if part.abs() < 1.0 { (1.0 - part * part).powi(2) } else { 0.0 }
}

/// Median of `values` (reordered in place); `None` when empty. An even count gives the mean of the middle two.
pub fn median(values: &mut [f64]) -> Option<f64> {
    let n = values.len();
    if n == 0 {
        return None;
    }
    let (below, &mut upper, _) = values.select_nth_unstable_by(n / 2, f64::total_cmp);
    if n % 2 == 1 {
        return Some(upper);
    }
    let lower = below.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Some(0.5 * (lower + upper))
}

/// Median and robust standard deviation (1.4826 × median absolute deviation, consistent for a normal sample).
pub fn median_and_spread(values: &mut [f64]) -> Option<(f64, f64)> {
    let centre = median(values)?;
    for v in values.iter_mut() {
        *v = (*v - centre).abs();
    }
    Some((centre, 1.4826 * median(values)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians() {
        assert_eq!(median(&mut []), None);
        assert_eq!(median(&mut [3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&mut [4.0, 1.0, 2.0, 3.0]), Some(2.5));
        let (m, s) = median_and_spread(&mut [1.0, 2.0, 3.0, 4.0, 100.0]).unwrap();
        assert_eq!((m, s), (3.0, 1.4826));
    }
}
