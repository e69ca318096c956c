//! What one observation says at a query point, sensor by sensor. Published forms: Meyer (2022), ch. 5, errata
//! corrected.

use nalgebra::Matrix3;

use super::{Mass, RayModel};
use crate::error::{Error, Result};
use crate::geometry::Vec3;
use crate::num::normal::cdf;

impl RayModel {
    /// Parameters that follow from the sensor: the kernel halves one point spacing (m) away, κ = ln 2/s², and the
    /// occupied band is ±2σ (m) thick, λ = c/2σ.
    pub fn of_sensor(spacing: f64, sigma: f64, c: f64) -> Result<Self> {
        for (what, x) in [("the spacing", spacing), ("sigma", sigma)] {
            if !(x > 0.0 && x.is_finite()) {
                return Err(Error::argument(what, "positive and finite", x));
            }
        }
        Self::new(std::f64::consts::LN_2 / spacing.powi(2), c / (2.0 * sigma), c)
    }

    /// Mass at `query` from a tie point with its covariance (m²), seen from a camera at `origin`: the ray model with
    /// the transitions widened along the ray and the kernel across it as the point's own covariance asks (two σ along
    /// it, one across; never narrower than the parameters).
    pub fn tie_point_mass(&self, origin: &Vec3, point: &Vec3, covariance: &Matrix3<f64>, query: &Vec3) -> Mass {
        let along = point - origin;
        let range = along.norm();
        if range == 0.0 {
            return Mass::VACUOUS;
        }
        let d = along / range;
        let variance_along = d.dot(&(covariance * d)).max(0.0);
        let variance_across = (0.5 * (covariance.trace() - variance_along)).max(0.0);
        let own = Self {
            lambda: self.lambda.min(self.c / (2.0 * variance_along.sqrt())),
            kappa: 1.0 / (1.0 / self.kappa + variance_across / std::f64::consts::LN_2),
            ..*self
        };
        own.mass(origin, point, query)
    }

    /// Mass at `query` from a point of a dense cloud with a unit face normal (Meyer (2022), eqs. 5.12 and 5.13):
    /// occupied or unknown, never empty, for it has no ray.
    pub fn dense_point_mass(&self, point: &Vec3, normal: &Vec3, query: &Vec3) -> Mass {
        let offset = query - point;
        let dx = offset.dot(normal);
        let dy_squared = (offset.norm_squared() - dx * dx).max(0.0);
        let ray = self.mass_at(dx, dy_squared, f64::INFINITY);
        Mass { occupied: ray.occupied, empty: 0.0, unknown: 1.0 - ray.occupied }
    }
}

/// What one station says of a sample (docs/method.md, "surface").
#[derive(Debug, Clone, Copy)]
pub struct SurfaceObservation {
    /// Mean deviation of the surface met, metres, + in front of the face.
    pub deviation: f64,
    /// Its standard deviation, metres.
    pub sd: f64,
    /// How well the beams cover the sample, 0 to 1.
    pub coverage: f64,
    /// Share of the beams that met a surface; the others pierced the face.
    pub hit_share: f64,
}

impl SurfaceObservation {
    /// Mass that the built surface lies within ±`tolerance` metres of the face, from a station of this `reliability`,
    /// and, separately, the belief that a surface stands in front of the face.
    pub fn mass(&self, tolerance: f64, reliability: f64) -> (Mass, f64) {
        let below = |x: f64| cdf((x - self.deviation) / self.sd);
        let (up, down) = (below(tolerance), below(-tolerance));
        let trust = reliability * self.coverage;
        let occupied = trust * self.hit_share * (up - down).max(0.0);
        // 1 − h·Φ((T+d)/σ), with Φ((T+d)/σ) = 1 − Φ((−T−d)/σ).
        let empty = trust * (1.0 - self.hit_share * (1.0 - down));
        let unknown = (1.0 - occupied - empty).max(1.0 - reliability);
        (Mass { occupied, empty, unknown }, trust * self.hit_share * (1.0 - up))
    }

    /// [`SurfaceObservation::mass`] of unchecked numbers.
    pub fn checked_mass(&self, tolerance: f64, reliability: f64) -> Result<Mass> {
        for (what, x) in
            [("the coverage", self.coverage), ("the share of hits", self.hit_share), ("the reliability", reliability)]
        {
            if !(0.0..=1.0).contains(&x) {
                return Err(Error::argument(what, "between 0 and 1", x));
            }
        }
        for (what, x) in [("the standard deviation", self.sd), ("the tolerance", tolerance)] {
            if !(x > 0.0 && x.is_finite()) {
                return Err(Error::argument(what, "positive and finite", x));
            }
        }
        if !self.deviation.is_finite() {
            return Err(Error::argument("the deviation", "finite", self.deviation));
        }
        Ok(self.mass(tolerance, reliability).0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Image rays (M Tab. 7.7).
    const IMAGE: RayModel = RayModel { kappa: 15_000.0, lambda: 800.0, c: 5.0 };
    /// Dense matched points.
    const DENSE: RayModel = RayModel { kappa: 6_000.0, lambda: 1_200.0, c: 5.0 };

    #[test]
    fn parameters_from_a_sensor() {
        let m = RayModel::of_sensor(0.005, 0.0025, 3.0).unwrap();
        // 5 mm spacing is κ 27 726 (M rounds to 25 000); ±2σ with c = 3 is λ = 600.
        assert!((m.kappa - 27_725.9).abs() < 0.1 && (m.lambda - 600.0).abs() < 1e-9);
        assert!(RayModel::of_sensor(0.0, 1.0, 3.0).is_err());
    }

    #[test]
    fn sensors_at_their_own_points() {
        let (s, p) = (Vec3::zeros(), Vec3::new(10.0, 0.0, 0.0));
        let exact = IMAGE.tie_point_mass(&s, &p, &Matrix3::zeros(), &p);
        assert!((exact.occupied - IMAGE.mass(&s, &p, &p).occupied).abs() < 1e-15);
        let wide = Matrix3::from_diagonal(&Vec3::new(0.02f64.powi(2), 0.0, 0.0));
        let before = Vec3::new(9.97, 0.0, 0.0);
        let (narrow, loose) = (IMAGE.mass(&s, &p, &before), IMAGE.tie_point_mass(&s, &p, &wide, &before));
        assert!(narrow.empty > 0.99 && loose.empty < 0.3 && loose.occupied > 0.5, "{loose:?}");
        let dense = DENSE.dense_point_mass(&p, &Vec3::x(), &p);
        assert!((dense.occupied - (2.0 / (1.0 + (-5.0f64).exp()) - 1.0)).abs() < 1e-12 && dense.empty == 0.0);
        assert!(DENSE.dense_point_mass(&p, &Vec3::x(), &before).occupied < 1e-9);
    }

    #[test]
    fn surface_by_hand() {
        let r = SurfaceObservation { deviation: 0.0, sd: 0.001, coverage: 1.0, hit_share: 1.0 };
        let m = r.checked_mass(0.002, 0.99).unwrap();
        assert!((m.occupied - 0.99 * 0.954_499_736_103_642).abs() < 1e-12, "{m:?}");
        let pierced = SurfaceObservation { hit_share: 0.0, ..r }.mass(0.002, 0.99).0;
        assert!((pierced.empty - 0.99).abs() < 1e-15);
        assert!(SurfaceObservation { sd: 0.0, ..r }.checked_mass(0.002, 0.99).is_err());
    }
}
