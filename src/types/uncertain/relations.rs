//! Statistical tests: each as a row, and as a boolean at a significance.

use asbuilt_core::uncertain::hypothesis::{self, HypothesisTest};
use asbuilt_core::uncertain::{UncertainLine, UncertainPlane, UncertainPoint};
use asbuilt_core::{Error, Result};

use crate::pg::{RowField, SqlValue, sql_functions};

fn row(t: &HypothesisTest) -> Result<SqlValue> {
    Ok(SqlValue::Row(vec![RowField::F64(t.statistic), RowField::I32(t.dof as i32), RowField::F64(t.p_value)]))
}

fn holds(t: &HypothesisTest, significance: f64) -> Result<SqlValue> {
    if significance > 0.0 && significance < 1.0 {
        Ok(SqlValue::Bool(t.holds(significance)))
    } else {
        Err(Error::argument("the significance", "between 0 and 1, both excluded", significance))
    }
}

/// Declares both SQL functions of each relation: the test as a row, and as a boolean.
macro_rules! relations {
    ($($row:ident, $holds:ident = $test:ident($left:ty, $right:ty);)*) => {
        sql_functions! {
            $(
                fn $row(a: $left, b: $right) { row(&hypothesis::$test(&a, &b)) }
                fn $holds(a: $left, b: $right, significance: f64) { holds(&hypothesis::$test(&a, &b), significance) }
            )*
        }
    };
}

relations! {
    ab_test_same_point, ab_is_same_point = same_point(UncertainPoint, UncertainPoint);
    ab_test_same_plane, ab_is_same_plane = same_plane(UncertainPlane, UncertainPlane);
    ab_test_point_line, ab_is_point_line = point_on_line(UncertainPoint, UncertainLine);
    ab_test_point_plane, ab_is_point_plane = point_on_plane(UncertainPoint, UncertainPlane);
    ab_test_line_plane, ab_is_line_plane = line_in_plane(UncertainLine, UncertainPlane);
    ab_test_parallel_lines, ab_is_parallel_lines = parallel_lines(UncertainLine, UncertainLine);
    ab_test_parallel_planes, ab_is_parallel_planes = parallel_planes(UncertainPlane, UncertainPlane);
    ab_test_parallel_line_plane, ab_is_parallel_line_plane = line_parallel_plane(UncertainLine, UncertainPlane);
    ab_test_orthogonal_lines, ab_is_orthogonal_lines = orthogonal_lines(UncertainLine, UncertainLine);
    ab_test_orthogonal_planes, ab_is_orthogonal_planes = orthogonal_planes(UncertainPlane, UncertainPlane);
    ab_test_orthogonal_line_plane, ab_is_orthogonal_line_plane = line_orthogonal_plane(UncertainLine, UncertainPlane);
    ab_test_coplanar_lines, ab_is_coplanar_lines = coplanar(UncertainLine, UncertainLine);
}
