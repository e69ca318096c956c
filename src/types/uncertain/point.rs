//! `ab_point`: constructor, accessors, confidence regions, search.

use asbuilt_core::Error;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::uncertain::{UncertainLine, UncertainPoint};

use super::ret;
use crate::pg::{F64Array, RowField, SqlValue, sql_functions};
use crate::types::box_bytes;
use crate::types::overlap::INDEX_SIGMAS;

fn sd(p: &UncertainPoint) -> [f64; 3] {
    [0, 1, 2].map(|i| p.covariance[(i, i)].max(0.0).sqrt())
}

sql_functions! {
    fn ab_point_make(x: f64, y: f64, z: f64, sd: f64, covariance: Option<F64Array>) {
        let position = Vec3::new(x, y, z);
        let Some(covariance) = covariance else {
            return ret(&UncertainPoint::isotropic(position, sd)?);
        };
        if sd != 0.0 {
            return Err(Error::argument("sd", "left out where a covariance is given", sd));
        }
        ret(&UncertainPoint::new(position, &covariance.square::<3>("the covariance of the point")?)?)
    }

    fn ab_point_x(point: UncertainPoint) { Ok(SqlValue::F64(point.position.x)) }
    fn ab_point_y(point: UncertainPoint) { Ok(SqlValue::F64(point.position.y)) }
    fn ab_point_z(point: UncertainPoint) { Ok(SqlValue::F64(point.position.z)) }
    fn ab_point_position(point: UncertainPoint) { Ok(SqlValue::vector(point.position)) }
    fn ab_point_sd(point: UncertainPoint) { Ok(SqlValue::vector(sd(&point))) }
    fn ab_point_covariance(point: UncertainPoint) { Ok(SqlValue::matrix(&point.covariance)) }

    fn ab_point_ellipsoid(rows: Rows; point: UncertainPoint, probability: f64) {
        for (half_axis, direction) in point.ellipsoid(probability)? {
            rows.push(&[RowField::F64(half_axis), RowField::Vector(direction.into())]);
        }
        Ok(SqlValue::Null)
    }

    fn ab_point_box(point: UncertainPoint, probability: f64) {
        let factor = asbuilt_core::uncertain::covariance::confidence_factor(probability, 3)?;
        Ok(SqlValue::Fixed(box_bytes(&point.bounds(factor))))
    }

    fn ab_line_box(line: UncertainLine, probability: f64) {
        let factor = asbuilt_core::uncertain::covariance::confidence_factor(probability, 3)?;
        Ok(SqlValue::Fixed(box_bytes(&line.bounds(factor))))
    }

    fn ab_point_mahalanobis(a: UncertainPoint, b: UncertainPoint) { Ok(SqlValue::F64(a.mahalanobis(&b))) }

    fn ab_point_reach(point: UncertainPoint, sigmas: f64) {
        if !(0.0..=INDEX_SIGMAS).contains(&sigmas) {
            return Err(Error::argument("the number of standard deviations", "between 0 and 5", sigmas));
        }
        Ok(SqlValue::Fixed(box_bytes(&point.bounds(sigmas))))
    }
}
