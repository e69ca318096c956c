//! Constructions and distances.

use asbuilt_core::Result;
use asbuilt_core::uncertain::distance::{self, UncertainDistance};
use asbuilt_core::uncertain::{UncertainLine, UncertainPlane, UncertainPoint, foot, intersect, join};

use super::ret;
use crate::pg::{RowField, SqlValue, sql_functions};

fn row(d: &UncertainDistance) -> Result<SqlValue> {
    Ok(SqlValue::Row(vec![RowField::F64(d.distance), RowField::F64(d.sd)]))
}

sql_functions! {
    fn ab_midpoint_points(a: UncertainPoint, b: UncertainPoint) { ret(&join::midpoint(&a, &b)) }

    fn ab_intersection_planes(a: UncertainPlane, b: UncertainPlane) { ret(&intersect::planes(&a, &b)?) }
    fn ab_intersection_three(a: UncertainPlane, b: UncertainPlane, c: UncertainPlane) {
        ret(&intersect::three_planes([&a, &b, &c])?)
    }
    fn ab_intersection_line_plane(line: UncertainLine, plane: UncertainPlane) {
        ret(&intersect::line_plane(&line, &plane)?)
    }

    fn ab_foot_plane(point: UncertainPoint, plane: UncertainPlane) { ret(&foot::on_plane(&point, &plane)) }
    fn ab_foot_line(point: UncertainPoint, line: UncertainLine) { ret(&foot::on_line(&point, &line)) }

    fn ab_distance_points(a: UncertainPoint, b: UncertainPoint) { row(&distance::points(&a, &b)) }
    fn ab_distance_plane(point: UncertainPoint, plane: UncertainPlane) { row(&distance::point_plane(&point, &plane)) }
    fn ab_distance_line(point: UncertainPoint, line: UncertainLine) { row(&distance::point_line(&point, &line)) }
    fn ab_distance_lines(a: UncertainLine, b: UncertainLine) { row(&distance::lines(&a, &b)) }
}
