//! Constructions and distances.

use asbuilt_core::Result;
use asbuilt_core::uncertain::distance::{self, Distance};
use asbuilt_core::uncertain::{foot, intersect, join};

use super::line::line;
use super::plane::plane;
use super::point::point;
use super::ret;
use crate::pg::{Field, SqlValue, sql_functions};

fn row(d: &Distance) -> Result<SqlValue> {
    Ok(SqlValue::Row(vec![Field::F64(d.distance), Field::F64(d.sd)]))
}

sql_functions! {
    fn ab_midpoint_points(args) { ret(&join::midpoint(&point(args, 0), &point(args, 1))) }

    fn ab_intersection_planes(args) { ret(&intersect::planes(&plane(args, 0), &plane(args, 1))?) }
    fn ab_intersection_three(args) {
        ret(&intersect::three_planes([&plane(args, 0), &plane(args, 1), &plane(args, 2)])?)
    }
    fn ab_intersection_line_plane(args) { ret(&intersect::line_plane(&line(args, 0), &plane(args, 1))?) }

    fn ab_foot_plane(args) { ret(&foot::on_plane(&point(args, 0), &plane(args, 1))) }
    fn ab_foot_line(args) { ret(&foot::on_line(&point(args, 0), &line(args, 1))) }

    fn ab_distance_points(args) { row(&distance::points(&point(args, 0), &point(args, 1))) }
    fn ab_distance_plane(args) { row(&distance::point_plane(&point(args, 0), &plane(args, 1))) }
    fn ab_distance_line(args) { row(&distance::point_line(&point(args, 0), &line(args, 1))) }
    fn ab_distance_lines(args) { row(&distance::lines(&line(args, 0), &line(args, 1))) }
}
