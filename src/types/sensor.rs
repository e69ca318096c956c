//! What one observation says at a query point.

use asbuilt_core::evidence::{RayModel, SurfaceObservation};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::uncertain::Point;
use asbuilt_core::{Error, Result};

use super::{mass_ret, uncertain};
use crate::pg::{Args, SqlValue, sql_functions};

fn place(args: &Args, i: usize, what: &'static str) -> Result<Vec3> {
    let p = Vec3::from(args.vector::<3>(i, what)?);
    match p.iter().find(|c| !c.is_finite()) {
        Some(c) => Err(Error::argument("a coordinate", "finite", c)),
        None => Ok(p),
    }
}

/// kappa, lambda and c in arguments 3 to 5.
fn rays(args: &Args) -> Result<RayModel> {
    RayModel::new(args.f64(3), args.f64(4), args.f64(5))
}

sql_functions! {
    /// ab_ray_mass(origin, point, query, kappa, lambda, c), also as ab_image_mass
    fn ab_ray_mass(args) {
        let (origin, point) = (place(args, 0, "the origin")?, place(args, 1, "the point")?);
        mass_ret(&rays(args)?.mass(&origin, &point, &place(args, 2, "the query point")?))
    }

    /// ab_tie_point_mass(origin, point, query, kappa, lambda, c)
    fn ab_tie_point_mass(args) {
        let (origin, query) = (place(args, 0, "the origin")?, place(args, 2, "the query point")?);
        let point: Point = uncertain::value(args, 1);
        mass_ret(&rays(args)?.tie_point_mass(&origin, &point.position, &point.covariance, &query))
    }

    /// ab_dense_mass(point, normal, query, kappa, lambda, c)
    fn ab_dense_mass(args) {
        let (point, query) = (place(args, 0, "the point")?, place(args, 2, "the query point")?);
        let normal = place(args, 1, "the normal")?;
        let Some(normal) = normal.try_normalize(1e-12) else {
            return Err(Error::argument("the normal", "a vector with a direction", "(0, 0, 0)"));
        };
        mass_ret(&rays(args)?.dense_point_mass(&point, &normal, &query))
    }

    /// ab_surface_mass(deviation, sd, tolerance, coverage, hit_share, reliability)
    fn ab_surface_mass(args) {
        let [deviation, sd, tolerance, coverage, hit_share, reliability] = [0, 1, 2, 3, 4, 5].map(|i| args.f64(i));
        let seen = SurfaceObservation { deviation, sd, coverage, hit_share };
        mass_ret(&seen.checked_mass(tolerance, reliability)?)
    }

    fn ab_kappa(args) { Ok(SqlValue::F64(RayModel::of_sensor(args.f64(0), 1.0, 1.0)?.kappa)) }
    fn ab_lambda(args) { Ok(SqlValue::F64(RayModel::of_sensor(1.0, args.f64(0), args.f64(1))?.lambda)) }
}
