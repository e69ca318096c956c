//! `@>`, `<@`, `~=` and `<->` between anything with a box and an `ab_box`, and `<->` with a point; only headers are
//! read.

use asbuilt_core::Result;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::uncertain::UncertainPoint;

use super::overlap::{TileArg, of_point, of_scan, of_solid, of_tile, place};
use super::scan::ScanArg;
use super::solid::SolidArg;
use crate::pg::{SqlValue, sql_functions};

fn contains(a: Result<Aabb>, b: &Aabb) -> Result<SqlValue> {
    Ok(SqlValue::Bool(a?.contains(b)))
}

fn contained(a: Result<Aabb>, b: &Aabb) -> Result<SqlValue> {
    Ok(SqlValue::Bool(b.contains(&a?)))
}

fn same(a: Result<Aabb>, b: &Aabb) -> Result<SqlValue> {
    Ok(SqlValue::Bool(a? == *b))
}

fn distance(a: Result<Aabb>, b: &Aabb) -> Result<SqlValue> {
    Ok(SqlValue::F64(a?.distance(b)))
}

/// The box of a patch's returns; infinitely far where there are none.
fn returns(patch: &ScanArg) -> Result<Aabb> {
    let header = patch.header()?;
    Ok(if header.returns > 0 { header.points } else { Aabb::EMPTY })
}

sql_functions! {
    fn ab_box_contains(a: Aabb, b: Aabb) { contains(Ok(a), &b) }
    fn ab_box_contained(a: Aabb, b: Aabb) { contained(Ok(a), &b) }
    fn ab_box_distance(a: Aabb, b: Aabb) { distance(Ok(a), &b) }
    fn ab_box_distance_point(a: Aabb, b: UncertainPoint) { distance(Ok(a), &place(&b)) }

    fn ab_solid_contains(a: SolidArg, b: Aabb) { contains(of_solid(&a), &b) }
    fn ab_solid_contained(a: SolidArg, b: Aabb) { contained(of_solid(&a), &b) }
    fn ab_solid_same(a: SolidArg, b: Aabb) { same(of_solid(&a), &b) }
    fn ab_solid_distance(a: SolidArg, b: Aabb) { distance(of_solid(&a), &b) }
    fn ab_solid_distance_point(a: SolidArg, b: UncertainPoint) { distance(of_solid(&a), &place(&b)) }

    fn ab_scan_contains(a: ScanArg, b: Aabb) { contains(of_scan(&a), &b) }
    fn ab_scan_contained(a: ScanArg, b: Aabb) { contained(of_scan(&a), &b) }
    fn ab_scan_same(a: ScanArg, b: Aabb) { same(of_scan(&a), &b) }
    fn ab_scan_distance_box(a: ScanArg, b: Aabb) { distance(returns(&a), &b) }
    fn ab_scan_distance_point(a: ScanArg, b: UncertainPoint) { distance(returns(&a), &place(&b)) }

    fn ab_point_contains(a: UncertainPoint, b: Aabb) { contains(of_point(&a), &b) }
    fn ab_point_contained(a: UncertainPoint, b: Aabb) { contained(of_point(&a), &b) }
    fn ab_point_same(a: UncertainPoint, b: Aabb) { same(of_point(&a), &b) }
    fn ab_point_distance(a: UncertainPoint, b: Aabb) { distance(of_point(&a), &b) }
    fn ab_point_distance_point(a: UncertainPoint, b: UncertainPoint) { distance(Ok(place(&a)), &place(&b)) }

    fn ab_tile_contains(a: TileArg, b: Aabb) { contains(of_tile(&a), &b) }
    fn ab_tile_contained(a: TileArg, b: Aabb) { contained(of_tile(&a), &b) }
    fn ab_tile_same(a: TileArg, b: Aabb) { same(of_tile(&a), &b) }
    fn ab_tile_distance(a: TileArg, b: Aabb) { distance(of_tile(&a), &b) }
    fn ab_tile_distance_point(a: TileArg, b: UncertainPoint) { distance(of_tile(&a), &place(&b)) }
}
