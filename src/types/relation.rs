//! `@>`, `<@`, `~=` and `<->` between anything with a box and an `ab_box`, and `<->` with a point; only headers are
//! read.

use asbuilt_core::Result;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::scan::Header;

use super::overlap::{BoxOf, of_box, of_point, of_scan, of_solid, of_tile, place};
use crate::pg::{Args, SqlValue, sql_functions};

fn contains(args: &Args, left: BoxOf) -> Result<SqlValue> {
    Ok(SqlValue::Bool(left(args, 0)?.contains(&of_box(args, 1)?)))
}

fn contained(args: &Args, left: BoxOf) -> Result<SqlValue> {
    Ok(SqlValue::Bool(of_box(args, 1)?.contains(&left(args, 0)?)))
}

fn same(args: &Args, left: BoxOf) -> Result<SqlValue> {
    Ok(SqlValue::Bool(left(args, 0)? == of_box(args, 1)?))
}

fn distance(args: &Args, left: BoxOf, right: BoxOf) -> Result<SqlValue> {
    Ok(SqlValue::F64(left(args, 0)?.distance(&right(args, 1)?)))
}

/// The box of a patch's returns; infinitely far where there are none.
fn returns(args: &Args, i: usize) -> Result<Aabb> {
    let header = Header::read(args.prefix(i, Header::LEN))?;
    Ok(if header.returns > 0 { header.points } else { Aabb::EMPTY })
}

sql_functions! {
    fn ab_box_contains(args) { contains(args, of_box) }
    fn ab_box_contained(args) { contained(args, of_box) }
    fn ab_box_distance(args) { distance(args, of_box, of_box) }
    fn ab_box_distance_point(args) { distance(args, of_box, place) }

    fn ab_solid_contains(args) { contains(args, of_solid) }
    fn ab_solid_contained(args) { contained(args, of_solid) }
    fn ab_solid_same(args) { same(args, of_solid) }
    fn ab_solid_distance(args) { distance(args, of_solid, of_box) }
    fn ab_solid_distance_point(args) { distance(args, of_solid, place) }

    fn ab_scan_contains(args) { contains(args, of_scan) }
    fn ab_scan_contained(args) { contained(args, of_scan) }
    fn ab_scan_same(args) { same(args, of_scan) }
    fn ab_scan_distance_box(args) { distance(args, returns, of_box) }
    fn ab_scan_distance_point(args) { distance(args, returns, place) }

    fn ab_point_contains(args) { contains(args, of_point) }
    fn ab_point_contained(args) { contained(args, of_point) }
    fn ab_point_same(args) { same(args, of_point) }
    fn ab_point_distance(args) { distance(args, of_point, of_box) }
    fn ab_point_distance_point(args) { distance(args, place, place) }

    fn ab_tile_contains(args) { contains(args, of_tile) }
    fn ab_tile_contained(args) { contained(args, of_tile) }
    fn ab_tile_same(args) { same(args, of_tile) }
    fn ab_tile_distance(args) { distance(args, of_tile, of_box) }
    fn ab_tile_distance_point(args) { distance(args, of_tile, place) }
}
