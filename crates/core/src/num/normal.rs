//! The standard normal distribution.

use std::f64::consts::SQRT_2;

/// Φ(x), the standard normal cumulative distribution function.
pub fn cdf(x: f64) -> f64 {
    0.5 * libm::erfc(-x / SQRT_2)
}

/// φ(x), the standard normal density.
pub fn pdf(x: f64) -> f64 {
    (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt()
}

/// Φ⁻¹(p) for 0 < p < 1; ±∞ at the ends.
///
/// Acklam's rational start (relative error 1e-9), polished by two Halley steps to double precision.
pub fn quantile(p: f64) -> f64 {
    if p.is_nan() || !(0.0..=1.0).contains(&p) {
        return f64::NAN;
    }
    if p == 0.0 || p == 1.0 {
        return if p == 0.0 { f64::NEG_INFINITY } else { f64::INFINITY };
    }
    // The lower tail carries full relative precision; mirror the upper one.
    if p > 0.5 {
        return -quantile_lower(1.0 - p);
    }
    quantile_lower(p)
}

fn quantile_lower(p: f64) -> f64 {
    let mut x = acklam(p);
    for _ in 0..2 {
        let e = cdf(x) - p;
        let u = e / pdf(x);
        x -= u / (1.0 + 0.5 * x * u);
    }
    x
}

/// P. J. Acklam, "An algorithm for computing the inverse normal cumulative distribution function" (2003), p ≤ 1/2.
fn acklam(p: f64) -> f64 {
    const A: [f64; 6] = [
        -3.969683028665376e+01,
        2.209460984245205e+02,
        -2.759285104469687e+02,
        1.38357751867269e+02,
        -3.066479806614716e+01,
        2.506628277459239e+00,
    ];
    const B: [f64; 5] = [
        -5.447609879822406e+01,
        1.615858368580409e+02,
        -1.556989798598866e+02,
        6.680131188771972e+01,
        -1.328068155288572e+01,
    ];
    const C: [f64; 6] = [
        -7.784894002430293e-03,
        -3.223964580411365e-01,
        -2.400758277161838e+00,
        -2.549732539343734e+00,
        4.374664141464968e+00,
        2.938163982698783e+00,
    ];
    const D: [f64; 4] = [7.784695709041462e-03, 3.224671290700398e-01, 2.445134137142996e+00, 3.754408661907416e+00];
    let horner = |c: &[f64], x: f64| c.iter().fold(0.0, |acc, &k| acc * x + k);
    if p < 0.02425 {
        let q = (-2.0 * p.ln()).sqrt();
        horner(&C, q) / (horner(&D, q) * q + 1.0)
    } else {
        let q = p - 0.5;
        let r = q * q;
        horner(&A, r) * q / (horner(&B, r) * r + 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantile_inverts_cdf() {
        let mut worst: f64 = 0.0;
        for i in 1..2000 {
            let p = i as f64 / 2000.0;
            worst = worst.max((cdf(quantile(p)) - p).abs());
        }
        assert!(worst < 1e-15, "{worst}");
        for e in [1e-5, 1e-12, 1e-100, 1e-300] {
            assert!((cdf(quantile(e)) / e - 1.0).abs() < 1e-11, "{e}");
        }
    }

    #[test]
    fn known_values() {
        // Abramowitz & Stegun, Table 26.1 and 26.5.
        assert!((cdf(1.0) - 0.841344746068543).abs() < 1e-15);
        assert!((quantile(0.975) - 1.959963984540054).abs() < 1e-14);
        assert_eq!(quantile(0.0), f64::NEG_INFINITY);
        assert!(quantile(1.5).is_nan());
    }
}
