//! Constructions and distances.

use asbuilt_core::Result;
use asbuilt_core::uncertain::distance::{self, Distance};
use asbuilt_core::uncertain::{Line, Plane, Point, foot, intersect, join};

use super::ret;
use crate::pg::{Field, SqlValue, sql_functions};

fn row(d: &Distance) -> Result<SqlValue> {
    Ok(SqlValue::Row(vec![Field::F64(d.distance), Field::F64(d.sd)]))
}

sql_functions! {
    fn ab_midpoint_points(a: Point, b: Point) { ret(&join::midpoint(&a, &b)) }

    fn ab_intersection_planes(a: Plane, b: Plane) { ret(&intersect::planes(&a, &b)?) }
    fn ab_intersection_three(a: Plane, b: Plane, c: Plane) { ret(&intersect::three_planes([&a, &b, &c])?) }
    fn ab_intersection_line_plane(line: Line, plane: Plane) { ret(&intersect::line_plane(&line, &plane)?) }

    fn ab_foot_plane(point: Point, plane: Plane) { ret(&foot::on_plane(&point, &plane)) }
    fn ab_foot_line(point: Point, line: Line) { ret(&foot::on_line(&point, &line)) }

    fn ab_distance_points(a: Point, b: Point) { row(&distance::points(&a, &b)) }
    fn ab_distance_plane(point: Point, plane: Plane) { row(&distance::point_plane(&point, &plane)) }
    fn ab_distance_line(point: Point, line: Line) { row(&distance::point_line(&point, &line)) }
    fn ab_distance_lines(a: Line, b: Line) { row(&distance::lines(&a, &b)) }
}
