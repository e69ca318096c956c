//! The χ² distribution for a whole number of degrees of freedom.

use super::normal;

/// P(χ² > x) with `dof` degrees of freedom; with none, χ² is 0.
///
/// Closed form by the recurrence Q(a+1, y) = Q(a, y) + yᵃe⁻ʸ/Γ(a+1) (Abramowitz & Stegun 6.5.21 with a = dof/2,
/// y = x/2), from erfc for odd and the exponential for even numbers: every term is positive, none cancels.
pub fn survival(x: f64, dof: u32) -> f64 {
    if x.is_nan() {
        return x;
    }
    if dof == 0 || x <= 0.0 {
        return if x > 0.0 { 0.0 } else { 1.0 };
    }
    // Beyond this every term is zero in floating point, or zero times infinity.
    if x > 3e3 {
        return 0.0;
    }
    let y = 0.5 * x;
    let odd = dof % 2 == 1;
    let mut a = if odd { 0.5 } else { 1.0 };
    let mut q = if odd { libm::erfc(y.sqrt()) } else { (-y).exp() };
    // yᵃe⁻ʸ/Γ(a+1)
    let mut term = if odd { 2.0 * (y / std::f64::consts::PI).sqrt() * (-y).exp() } else { y * (-y).exp() };
    while a + 0.5 < 0.5 * f64::from(dof) {
        q += term;
        a += 1.0;
        term *= y / a;
    }
    if q > 1.0 { 1.0 } else { q }
}

/// The x that χ² exceeds with probability 1 − `p`, for 0 < `p` < 1, to full precision by bisection.
pub fn quantile(p: f64, dof: u32) -> f64 {
    // Wilson & Hilferty (1931) gives the neighbourhood.
    let k = f64::from(dof);
    let guess = k * (1.0 - 2.0 / (9.0 * k) + normal::quantile(p) * (2.0 / (9.0 * k)).sqrt()).max(0.01).powi(3);
    let (mut low, mut high) = (0.0, 4.0 * guess + 10.0);
    while survival(high, dof) > 1.0 - p {
        high *= 2.0;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if survival(middle, dof) > 1.0 - p { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Percentage points from tables (NIST/SEMATECH e-Handbook 1.3.6.7.4).
    #[test]
    fn tabulated_points() {
        for (dof, p, x) in [
            (1, 0.95, 3.841),
            (2, 0.95, 5.991),
            (3, 0.95, 7.815),
            (4, 0.99, 13.277),
            (5, 0.90, 9.236),
            (6, 0.999, 22.458),
            (7, 0.975, 16.013),
        ] {
            assert!((survival(x, dof) - (1.0 - p)).abs() < 1e-4, "{dof} {p}");
            assert!((quantile(p, dof) - x).abs() < 6e-4, "{dof} {p}: {}", quantile(p, dof));
        }
        // Integral of the density by Simpson's rule, dof 3.
        let density = |t: f64| (t / std::f64::consts::TAU).sqrt() * (-0.5 * t).exp();
        let (n, x) = (20_000, 5.0);
        let h = (60.0 - x) / f64::from(n);
        let sum: f64 = (0..=n)
            .map(|i| {
                density(x + f64::from(i) * h)
                    * if i == 0 || i == n {
                        1.0
                    } else if i % 2 == 1 {
                        4.0
                    } else {
                        2.0
                    }
            })
            .sum();
        assert!((survival(x, 3) - sum * h / 3.0).abs() < 1e-11);
    }

    #[test]
    fn edges() {
        assert!(survival(f64::NAN, 3).is_nan());
        assert_eq!((survival(0.0, 3), survival(-1.0, 1), survival(0.0, 0), survival(1.0, 0)), (1.0, 1.0, 1.0, 0.0));
        assert!((1..8).all(|dof| survival(1e6, dof) == 0.0 && survival(f64::INFINITY, dof) == 0.0));
        for dof in 1..=7 {
            for p in [1e-6, 0.05, 0.5, 0.95, 0.9999999] {
                assert!((1.0 - survival(quantile(p, dof), dof) - p).abs() < 1e-12);
            }
        }
    }
}
