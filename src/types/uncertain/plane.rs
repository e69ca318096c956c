//! `ab_plane`: constructors and accessors.

use asbuilt_core::Error;
use asbuilt_core::uncertain::{UncertainLine, UncertainPlane, UncertainPoint, join};

use super::ret;
use crate::pg::{F64Array, SqlValue, sql_functions};

sql_functions! {
    fn ab_plane_make(
        point: F64Array, normal: F64Array, sd_offset: f64, sd_tilt: f64, covariance: Option<F64Array>,
    ) {
        let at = point.vector::<3>("the point of the plane")?.into();
        let normal = normal.vector::<3>("the normal of the plane")?.into();
        let Some(covariance) = covariance else {
            return ret(&UncertainPlane::tilted(at, normal, sd_offset, sd_tilt)?);
        };
        if sd_offset != 0.0 || sd_tilt != 0.0 {
            return Err(Error::argument("sd_offset and sd_tilt", "left out where a covariance is given", "given"));
        }
        ret(&UncertainPlane::new(at, normal, &covariance.square::<4>("the covariance of the plane")?)?)
    }

    fn ab_plane_join(a: UncertainPoint, b: UncertainPoint, c: UncertainPoint) { ret(&join::plane_through(&a, &b, &c)?) }
    fn ab_plane_join_line(line: UncertainLine, point: UncertainPoint) { ret(&join::plane_through_line(&line, &point)?) }

    fn ab_plane_position(plane: UncertainPlane) { Ok(SqlValue::vector(plane.point)) }
    fn ab_plane_normal(plane: UncertainPlane) { Ok(SqlValue::vector(plane.normal)) }
    fn ab_plane_covariance(plane: UncertainPlane) { Ok(SqlValue::matrix(&plane.covariance)) }
}
