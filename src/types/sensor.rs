//! What one observation says at a query point.

use asbuilt_core::evidence::{RayModel, SurfaceObservation};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::uncertain::UncertainPoint;
use asbuilt_core::{Error, Result};

use super::mass_ret;
use crate::pg::{F64Array, SqlValue, sql_functions};

fn place(array: &F64Array, what: &'static str) -> Result<Vec3> {
    let p = Vec3::from(array.vector::<3>(what)?);
    match p.iter().find(|c| !c.is_finite()) {
        Some(c) => Err(Error::argument("a coordinate", "finite", c)),
        None => Ok(p),
    }
}

sql_functions! {
    /// Also as ab_image_mass.
    fn ab_ray_mass(origin: F64Array, point: F64Array, query: F64Array, kappa: f64, lambda: f64, c: f64) {
        let (origin, point) = (place(&origin, "the origin")?, place(&point, "the point")?);
        mass_ret(&RayModel::new(kappa, lambda, c)?.mass(&origin, &point, &place(&query, "the query point")?))
    }

    fn ab_tie_point_mass(origin: F64Array, point: UncertainPoint, query: F64Array, kappa: f64, lambda: f64, c: f64) {
        let (origin, query) = (place(&origin, "the origin")?, place(&query, "the query point")?);
        mass_ret(&RayModel::new(kappa, lambda, c)?.tie_point_mass(&origin, &point.position, &point.covariance, &query))
    }

    fn ab_dense_mass(point: F64Array, normal: F64Array, query: F64Array, kappa: f64, lambda: f64, c: f64) {
        let (point, query) = (place(&point, "the point")?, place(&query, "the query point")?);
        let normal = place(&normal, "the normal")?;
        let Some(normal) = normal.try_normalize(1e-12) else {
            return Err(Error::argument("the normal", "a vector with a direction", "(0, 0, 0)"));
        };
        mass_ret(&RayModel::new(kappa, lambda, c)?.dense_point_mass(&point, &normal, &query))
    }

    fn ab_surface_mass(
        deviation: f64, sd: f64, tolerance: f64, coverage: f64, hit_share: f64, reliability: f64,
    ) {
        let seen = SurfaceObservation { deviation, sd, coverage, hit_share };
        mass_ret(&seen.checked_mass(tolerance, reliability)?)
    }

    fn ab_kappa(spacing: f64) { Ok(SqlValue::F64(RayModel::of_sensor(spacing, 1.0, 1.0)?.kappa)) }
    fn ab_lambda(sigma: f64, c: f64) { Ok(SqlValue::F64(RayModel::of_sensor(1.0, sigma, c)?.lambda)) }
}
