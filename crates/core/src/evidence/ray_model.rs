//! What one laser beam says about one point, as published in Meyer (2022), eqs. 5.4 to 5.10.

use super::Mass;
use crate::error::{Error, Result};
use crate::geometry::Vec3;

/// Parameters of the published ray model `meyer2022`.
///
/// Errata of the source: eqs. 5.4, 5.5 and eqs. 5.9, 5.10 exchange occupied and empty and print `1/(e^…)` for
/// `1/(1+e^…)`; the form here is a valid mass and draws Figs 5.6 and 6.4.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayModel {
    /// Decay across the ray, 1/m²: ln 2 / spacing² lets the kernel halve one point spacing away.
    pub kappa: f64,
    /// Steepness of the transitions along the ray, 1/m.
    pub lambda: f64,
    /// Half-width of the occupied band in units of 1/λ.
    pub c: f64,
}

impl RayModel {
    /// The published setting for a terrestrial laser scanner (σ of a point 2.5 mm; Meyer (2022), Table 7.7).
    pub const LASER: Self = Self { kappa: 20_000.0, lambda: 600.0, c: 3.0 };

    /// Checks that all three are positive and finite. κ in 1/m², λ in 1/m, c without unit.
    pub fn new(kappa: f64, lambda: f64, c: f64) -> Result<Self> {
        for (what, x) in [("kappa", kappa), ("lambda", lambda), ("c", c)] {
            if !(x > 0.0 && x.is_finite()) {
                return Err(Error::argument(what, "positive and finite", x));
            }
        }
        Ok(Self { kappa, lambda, c })
    }

    /// Mass at `query` from a beam between `origin` and `point`; vacuous behind the sensor.
    pub fn mass(&self, origin: &Vec3, point: &Vec3, query: &Vec3) -> Mass {
        let along = point - origin;
        let range = along.norm();
        if range == 0.0 {
            return Mass::VACUOUS;
        }
        let offset = query - point;
        let dx = offset.dot(&along) / range;
        let dy_squared = (offset.norm_squared() - dx * dx).max(0.0);
        self.mass_at(dx, dy_squared, range)
    }

    /// The same from the query's place along the beam (`dx`, + behind the return) and its squared distance across.
    /// Metres, and m² for the square.
    pub fn mass_at(&self, dx: f64, dy_squared: f64, range: f64) -> Mass {
        if dx < -range {
            return Mass::VACUOUS;
        }
        let across = (-self.kappa * dy_squared).exp();
        let front = logistic(self.lambda * dx + self.c);
        let back = logistic(self.lambda * dx - self.c);
        let occupied = (front - back) * across;
        // 1 − L(x) = L(−x) without cancellation.
        let empty = logistic(-self.lambda * dx - self.c) * across;
        Mass { occupied, empty, unknown: (1.0 - occupied - empty).max(0.0) }
    }

    /// Distance across the beam, metres, beyond which every mass is below `least`.
    pub fn reach(&self, least: f64) -> f64 {
        (-least.ln() / self.kappa).sqrt()
    }
}

/// L(x) = 1/(1+e⁻ˣ).
fn logistic(x: f64) -> f64 {
    1.0 / (1.0 + (-x).exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hand_computed_masses() {
        let (s, p) = (Vec3::zeros(), Vec3::new(10.0, 0.0, 0.0));
        let m = |x: f64, y: f64| RayModel::LASER.mass(&s, &p, &Vec3::new(x, y, 0.0));
        // At the return: L(3)−L(−3) = tanh(3/2).
        assert!((m(10.0, 0.0).occupied - 1.5f64.tanh()).abs() < 1e-12);
        assert!((m(10.0, 0.0).empty - 1.0 / (1.0 + 3f64.exp())).abs() < 1e-12);
        // 5 mm before it: L(0)−L(−6), empty L(0)=1/2.
        let before = m(9.995, 0.0);
        assert!((before.occupied - (0.5 - 1.0 / (1.0 + 6f64.exp()))).abs() < 1e-11);
        assert!((before.empty - 0.5).abs() < 1e-11);
        // 5 mm aside: times exp(−20000·25e−6) = e^−½.
        assert!((m(10.0, 0.005).occupied - 1.5f64.tanh() * (-0.5f64).exp()).abs() < 1e-12);
        // Well before: empty; well behind: unknown; behind the sensor: vacuous.
        assert!(m(5.0, 0.0).empty > 0.999_999 && m(11.0, 0.0).unknown > 0.999_999);
        assert_eq!(m(-1.0, 0.0), Mass::VACUOUS);
    }

    #[test]
    fn is_a_mass_everywhere() {
        for i in -200..200 {
            let m = RayModel::LASER.mass_at(f64::from(i) * 1e-3, 0.0, 10.0);
            assert!(m.occupied >= 0.0 && m.empty >= 0.0 && m.unknown >= 0.0);
            assert!((m.occupied + m.empty + m.unknown - 1.0).abs() < 1e-12);
        }
        assert!(RayModel::new(-1.0, 600.0, 3.0).is_err());
    }
}
