//! `ab_point`: constructor, accessors, confidence regions, search.

use asbuilt_core::Error;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::uncertain::{Line, Point};

use super::{ret, value};
use crate::pg::{Args, Field, Rows, SqlValue, sql_functions};
use crate::types::box_bytes;
use crate::types::overlap::INDEX_SIGMAS;

pub(super) fn point(args: &Args, i: usize) -> Point {
    value(args, i)
}

fn sd(p: &Point) -> [f64; 3] {
    [0, 1, 2].map(|i| p.covariance[(i, i)].max(0.0).sqrt())
}

sql_functions! {
    /// ab_point(x, y, z, sd, covariance)
    fn ab_point_make(args) {
        if (0..4).any(|i| args.is_null(i)) {
            return Ok(SqlValue::Null);
        }
        let position = Vec3::new(args.f64(0), args.f64(1), args.f64(2));
        if args.is_null(4) {
            return ret(&Point::isotropic(position, args.f64(3))?);
        }
        if args.f64(3) != 0.0 {
            return Err(Error::argument("sd", "left out where a covariance is given", args.f64(3)));
        }
        ret(&Point::new(position, &args.square::<3>(4, "the covariance of the point")?)?)
    }

    fn ab_point_x(args) { Ok(SqlValue::F64(point(args, 0).position.x)) }
    fn ab_point_y(args) { Ok(SqlValue::F64(point(args, 0).position.y)) }
    fn ab_point_z(args) { Ok(SqlValue::F64(point(args, 0).position.z)) }
    fn ab_point_position(args) { Ok(SqlValue::vector(point(args, 0).position)) }
    fn ab_point_sd(args) { Ok(SqlValue::vector(sd(&point(args, 0)))) }
    fn ab_point_covariance(args) { Ok(SqlValue::matrix(&point(args, 0).covariance)) }

    fn ab_point_ellipsoid(args) {
        let mut rows = Rows::new(args)?;
        for (half_axis, direction) in point(args, 0).ellipsoid(args.f64(1))? {
            rows.push(&[Field::F64(half_axis), Field::Vector(direction.into())]);
        }
        Ok(SqlValue::Null)
    }

    fn ab_point_box(args) {
        let factor = asbuilt_core::uncertain::covariance::confidence_factor(args.f64(1), 3)?;
        Ok(SqlValue::Fixed(box_bytes(&point(args, 0).bounds(factor))))
    }

    fn ab_line_box(args) {
        let factor = asbuilt_core::uncertain::covariance::confidence_factor(args.f64(1), 3)?;
        Ok(SqlValue::Fixed(box_bytes(&value::<Line, 27>(args, 0).bounds(factor))))
    }

    fn ab_point_mahalanobis(args) { Ok(SqlValue::F64(point(args, 0).mahalanobis(&point(args, 1)))) }

    fn ab_point_reach(args) {
        let sigmas = args.f64(1);
        if !(0.0..=INDEX_SIGMAS).contains(&sigmas) {
            return Err(Error::argument("the number of standard deviations", "between 0 and 5", sigmas));
        }
        Ok(SqlValue::Fixed(box_bytes(&point(args, 0).bounds(sigmas))))
    }
}
