//! Statistical tests: each as a row, and as a boolean at a significance.

use asbuilt_core::uncertain::test::{self, Test};
use asbuilt_core::{Error, Result};

use super::line::line;
use super::plane::plane;
use super::point::point;
use crate::pg::{Args, Field, SqlValue, sql_functions};

fn row(t: &Test) -> Result<SqlValue> {
    Ok(SqlValue::Row(vec![Field::F64(t.statistic), Field::I32(t.dof as i32), Field::F64(t.p_value)]))
}

/// Argument 2 is the significance.
fn holds(args: &Args, t: &Test) -> Result<SqlValue> {
    let significance = args.f64(2);
    if significance > 0.0 && significance < 1.0 {
        Ok(SqlValue::Bool(t.holds(significance)))
    } else {
        Err(Error::argument("the significance", "between 0 and 1, both excluded", significance))
    }
}

/// Declares both SQL functions of each relation: the test as a row, and as a boolean.
macro_rules! relations {
    ($($row:ident, $holds:ident = $test:ident($left:ident, $right:ident);)*) => {
        sql_functions! {
            $(
                fn $row(args) { row(&test::$test(&$left(args, 0), &$right(args, 1))) }
                fn $holds(args) { holds(args, &test::$test(&$left(args, 0), &$right(args, 1))) }
            )*
        }
    };
}

relations! {
    ab_test_same_point, ab_is_same_point = same_point(point, point);
    ab_test_same_plane, ab_is_same_plane = same_plane(plane, plane);
    ab_test_point_line, ab_is_point_line = point_on_line(point, line);
    ab_test_point_plane, ab_is_point_plane = point_on_plane(point, plane);
    ab_test_line_plane, ab_is_line_plane = line_in_plane(line, plane);
    ab_test_parallel_lines, ab_is_parallel_lines = parallel_lines(line, line);
    ab_test_parallel_planes, ab_is_parallel_planes = parallel_planes(plane, plane);
    ab_test_parallel_line_plane, ab_is_parallel_line_plane = line_parallel_plane(line, plane);
    ab_test_orthogonal_lines, ab_is_orthogonal_lines = orthogonal_lines(line, line);
    ab_test_orthogonal_planes, ab_is_orthogonal_planes = orthogonal_planes(plane, plane);
    ab_test_orthogonal_line_plane, ab_is_orthogonal_line_plane = line_orthogonal_plane(line, plane);
    ab_test_coplanar_lines, ab_is_coplanar_lines = coplanar(line, line);
}
