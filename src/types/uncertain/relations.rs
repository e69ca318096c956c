//! Statistical tests: each as a row, and as a yes or no at a significance.

use asbuilt_core::uncertain::test::{self, Test};
use asbuilt_core::{Error, Result};

use super::line::line;
use super::plane::plane;
use super::point::point;
use crate::pg::{Args, Field, Ret, sql_functions};

fn row(t: &Test) -> Result<Ret> {
    Ok(Ret::Row(vec![Field::F64(t.statistic), Field::I32(t.dof as i32), Field::F64(t.p_value)]))
}

/// Argument 2 is the significance.
fn holds(args: &Args, t: &Test) -> Result<Ret> {
    let significance = args.f64(2);
    if significance > 0.0 && significance < 1.0 {
        Ok(Ret::Bool(t.holds(significance)))
    } else {
        Err(Error::argument("the significance", "between 0 and 1, both excluded", significance))
    }
}

fn same_point(args: &Args) -> Test {
    test::same_point(&point(args, 0), &point(args, 1))
}

fn same_plane(args: &Args) -> Test {
    test::same_plane(&plane(args, 0), &plane(args, 1))
}

fn point_line(args: &Args) -> Test {
    test::point_on_line(&point(args, 0), &line(args, 1))
}

fn point_plane(args: &Args) -> Test {
    test::point_on_plane(&point(args, 0), &plane(args, 1))
}

fn line_plane(args: &Args) -> Test {
    test::line_in_plane(&line(args, 0), &plane(args, 1))
}

fn parallel_lines(args: &Args) -> Test {
    test::parallel_lines(&line(args, 0), &line(args, 1))
}

fn parallel_planes(args: &Args) -> Test {
    test::parallel_planes(&plane(args, 0), &plane(args, 1))
}

fn parallel_line_plane(args: &Args) -> Test {
    test::line_parallel_plane(&line(args, 0), &plane(args, 1))
}

fn orthogonal_lines(args: &Args) -> Test {
    test::orthogonal_lines(&line(args, 0), &line(args, 1))
}

fn orthogonal_planes(args: &Args) -> Test {
    test::orthogonal_planes(&plane(args, 0), &plane(args, 1))
}

fn orthogonal_line_plane(args: &Args) -> Test {
    test::line_orthogonal_plane(&line(args, 0), &plane(args, 1))
}

fn coplanar_lines(args: &Args) -> Test {
    test::coplanar(&line(args, 0), &line(args, 1))
}

sql_functions! {
    fn ab_test_same_point(args) { row(&same_point(args)) }
    fn ab_is_same_point(args) { holds(args, &same_point(args)) }
    fn ab_test_same_plane(args) { row(&same_plane(args)) }
    fn ab_is_same_plane(args) { holds(args, &same_plane(args)) }
    fn ab_test_point_line(args) { row(&point_line(args)) }
    fn ab_is_point_line(args) { holds(args, &point_line(args)) }
    fn ab_test_point_plane(args) { row(&point_plane(args)) }
    fn ab_is_point_plane(args) { holds(args, &point_plane(args)) }
    fn ab_test_line_plane(args) { row(&line_plane(args)) }
    fn ab_is_line_plane(args) { holds(args, &line_plane(args)) }
    fn ab_test_parallel_lines(args) { row(&parallel_lines(args)) }
    fn ab_is_parallel_lines(args) { holds(args, &parallel_lines(args)) }
    fn ab_test_parallel_planes(args) { row(&parallel_planes(args)) }
    fn ab_is_parallel_planes(args) { holds(args, &parallel_planes(args)) }
    fn ab_test_parallel_line_plane(args) { row(&parallel_line_plane(args)) }
    fn ab_is_parallel_line_plane(args) { holds(args, &parallel_line_plane(args)) }
    fn ab_test_orthogonal_lines(args) { row(&orthogonal_lines(args)) }
    fn ab_is_orthogonal_lines(args) { holds(args, &orthogonal_lines(args)) }
    fn ab_test_orthogonal_planes(args) { row(&orthogonal_planes(args)) }
    fn ab_is_orthogonal_planes(args) { holds(args, &orthogonal_planes(args)) }
    fn ab_test_orthogonal_line_plane(args) { row(&orthogonal_line_plane(args)) }
    fn ab_is_orthogonal_line_plane(args) { holds(args, &orthogonal_line_plane(args)) }
    fn ab_test_coplanar_lines(args) { row(&coplanar_lines(args)) }
    fn ab_is_coplanar_lines(args) { holds(args, &coplanar_lines(args)) }
}
