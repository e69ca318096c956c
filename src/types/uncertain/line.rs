//! `ab_line`: constructors and accessors.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::uncertain::{Line, join};

use super::point::point;
use super::{ret, value};
use crate::pg::{Args, Field, SqlValue, sql_functions};

pub(super) fn line(args: &Args, i: usize) -> Line {
    value(args, i)
}

sql_functions! {
    /// ab_line(start, end, covariance)
    fn ab_line_make(args) {
        if args.is_null(0) || args.is_null(1) {
            return Ok(SqlValue::Null);
        }
        let (start, end) = (args.vector::<3>(0, "the start of the line")?, args.vector::<3>(1, "the end of the line")?);
        let covariance = match args.is_null(2) {
            true => nalgebra::Matrix6::zeros(),
            false => args.square::<6>(2, "the covariance of the line")?,
        };
        ret(&Line::new(start.into(), end.into(), &covariance)?)
    }

    fn ab_line_join(args) { ret(&join::line_through(&point(args, 0), &point(args, 1))?) }

    fn ab_line_start(args) { ret(&line(args, 0).at(0.0)) }
    fn ab_line_end(args) { ret(&line(args, 0).at(1.0)) }
    fn ab_midpoint_line(args) { ret(&line(args, 0).at(0.5)) }
    fn ab_line_direction(args) { Ok(SqlValue::vector(line(args, 0).direction())) }
    fn ab_line_covariance(args) { Ok(SqlValue::matrix(&line(args, 0).covariance)) }

    fn ab_line_plucker(args) {
        let reference = Vec3::from(args.vector::<3>(1, "the reference point")?);
        if let Some(c) = reference.iter().find(|c| !c.is_finite()) {
            return Err(asbuilt_core::Error::argument("the reference point", "finite", c));
        }
        let (l, covariance) = line(args, 0).plucker(&reference);
        Ok(SqlValue::Row(vec![
            Field::Array(l.iter().copied().collect(), vec![6]),
            Field::Array(covariance.iter().copied().collect(), vec![6, 6]),
        ]))
    }
}
