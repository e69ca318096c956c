//! `ab_plane`: constructors and accessors.

use asbuilt_core::Error;
use asbuilt_core::uncertain::{Plane, join};

use super::line::line;
use super::point::point;
use super::{ret, value};
use crate::pg::{Args, SqlValue, sql_functions};

pub(super) fn plane(args: &Args, i: usize) -> Plane {
    value(args, i)
}

sql_functions! {
    /// ab_plane(point, normal, sd_offset, sd_tilt, covariance)
    fn ab_plane_make(args) {
        if (0..4).any(|i| args.is_null(i)) {
            return Ok(SqlValue::Null);
        }
        let at = args.vector::<3>(0, "the point of the plane")?.into();
        let normal = args.vector::<3>(1, "the normal of the plane")?.into();
        if args.is_null(4) {
            return ret(&Plane::tilted(at, normal, args.f64(2), args.f64(3))?);
        }
        if args.f64(2) != 0.0 || args.f64(3) != 0.0 {
            return Err(Error::argument("sd_offset and sd_tilt", "left out where a covariance is given", "given"));
        }
        ret(&Plane::new(at, normal, &args.square::<4>(4, "the covariance of the plane")?)?)
    }

    fn ab_plane_join(args) { ret(&join::plane_through(&point(args, 0), &point(args, 1), &point(args, 2))?) }
    fn ab_plane_join_line(args) { ret(&join::plane_through_line(&line(args, 0), &point(args, 1))?) }

    fn ab_plane_position(args) { Ok(SqlValue::vector(plane(args, 0).point)) }
    fn ab_plane_normal(args) { Ok(SqlValue::vector(plane(args, 0).normal)) }
    fn ab_plane_covariance(args) { Ok(SqlValue::matrix(&plane(args, 0).covariance)) }
}
