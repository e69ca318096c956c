//! `ab_line`: constructors and accessors.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::uncertain::{UncertainLine, UncertainPoint, join};

use super::ret;
use crate::pg::{F64Array, RowField, SqlValue, sql_functions};

sql_functions! {
    fn ab_line_make(start: F64Array, end: F64Array, covariance: Option<F64Array>) {
        let (start, end) = (start.vector::<3>("the start of the line")?, end.vector::<3>("the end of the line")?);
        let covariance = match covariance {
            None => nalgebra::Matrix6::zeros(),
            Some(covariance) => covariance.square::<6>("the covariance of the line")?,
        };
        ret(&UncertainLine::new(start.into(), end.into(), &covariance)?)
    }

    fn ab_line_join(a: UncertainPoint, b: UncertainPoint) { ret(&join::line_through(&a, &b)?) }

    fn ab_line_start(line: UncertainLine) { ret(&line.at(0.0)) }
    fn ab_line_end(line: UncertainLine) { ret(&line.at(1.0)) }
    fn ab_midpoint_line(line: UncertainLine) { ret(&line.at(0.5)) }
    fn ab_line_direction(line: UncertainLine) { Ok(SqlValue::vector(line.direction())) }
    fn ab_line_covariance(line: UncertainLine) { Ok(SqlValue::matrix(&line.covariance)) }

    fn ab_line_plucker(line: UncertainLine, reference: F64Array) {
        let reference = Vec3::from(reference.vector::<3>("the reference point")?);
        if let Some(c) = reference.iter().find(|c| !c.is_finite()) {
            return Err(asbuilt_core::Error::argument("the reference point", "finite", c));
        }
        let (l, covariance) = line.plucker(&reference);
        Ok(SqlValue::Row(vec![
            RowField::Array(l.iter().copied().collect(), vec![6]),
            RowField::Array(covariance.iter().copied().collect(), vec![6, 6]),
        ]))
    }
}
