//! The box by which each type is indexed, and `&&` between them; only headers are read.

use asbuilt_core::Result;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::scan::JOIN_MARGIN_M;
use asbuilt_core::uncertain::{UncertainLine, UncertainPoint};
use asbuilt_core::voxel::TileHeader;

use super::scan::ScanArg;
use super::solid::SolidArg;
use crate::pg::{AnyTile, SqlValue, Varlena, sql_functions};

/// An occupancy or a change.
pub type TileArg<'a> = Varlena<'a, AnyTile>;

/// Standard deviations by which a point or line is grown: searches within up to this many are served by an index.
pub const INDEX_SIGMAS: f64 = 5.0;

/// The box of a solid.
pub fn of_solid(solid: &SolidArg) -> Result<Aabb> {
    Ok(solid.header()?.bounds)
}

/// The box within which a point may belong to a solid.
pub fn near_solid(solid: &SolidArg) -> Result<Aabb> {
    Ok(of_solid(solid)?.expanded(JOIN_MARGIN_M))
}

/// For a scan, the hull of its beams, origin included.
pub fn of_scan(patch: &ScanArg) -> Result<Aabb> {
    Ok(patch.header()?.hull)
}

/// A point grown by [`INDEX_SIGMAS`].
pub fn of_point(point: &UncertainPoint) -> Result<Aabb> {
    Ok(point.bounds(INDEX_SIGMAS))
}

/// A point at its coordinates, however uncertain.
pub fn place(point: &UncertainPoint) -> Aabb {
    let at = point.position.into();
    Aabb { min: at, max: at }
}

/// A line grown by [`INDEX_SIGMAS`].
pub fn of_line(line: &UncertainLine) -> Result<Aabb> {
    Ok(line.bounds(INDEX_SIGMAS))
}

/// The blocks of an occupancy or a change about which something is known; if there are none, the tile, or the origin
/// where the tile is unbounded.
pub fn of_tile(tile: &TileArg) -> Result<Aabb> {
    tile_box(tile.prefix(TileHeader::LEN))
}

/// The same from the value's first bytes.
pub fn tile_box(prefix: &[u8]) -> Result<Aabb> {
    let header = TileHeader::read(prefix)?;
    let tile = if header.grid.is_bounded() { header.grid.tile } else { Aabb { min: [0.0; 3], max: [0.0; 3] } };
    Ok(header.bounds().unwrap_or(tile))
}

fn overlaps(a: Result<Aabb>, b: Result<Aabb>) -> Result<SqlValue> {
    Ok(SqlValue::Bool(a?.overlaps(&b?)))
}

sql_functions! {
    fn ab_overlaps_box_box(a: Aabb, b: Aabb) { overlaps(Ok(a), Ok(b)) }
    fn ab_overlaps_box_solid(a: Aabb, b: SolidArg) { overlaps(Ok(a), of_solid(&b)) }
    fn ab_overlaps_box_scan(a: Aabb, b: ScanArg) { overlaps(Ok(a), of_scan(&b)) }
    fn ab_overlaps_solid_box(a: SolidArg, b: Aabb) { overlaps(of_solid(&a), Ok(b)) }
    fn ab_overlaps_solid_solid(a: SolidArg, b: SolidArg) { overlaps(of_solid(&a), of_solid(&b)) }
    fn ab_overlaps_solid_scan(a: SolidArg, b: ScanArg) { overlaps(of_solid(&a), of_scan(&b)) }
    fn ab_overlaps_scan_box(a: ScanArg, b: Aabb) { overlaps(of_scan(&a), Ok(b)) }
    fn ab_overlaps_scan_solid(a: ScanArg, b: SolidArg) { overlaps(of_scan(&a), of_solid(&b)) }
    fn ab_overlaps_scan_scan(a: ScanArg, b: ScanArg) { overlaps(of_scan(&a), of_scan(&b)) }

    fn ab_overlaps_solid_point(a: SolidArg, b: UncertainPoint) { overlaps(near_solid(&a), of_point(&b)) }
    fn ab_overlaps_point_solid(a: UncertainPoint, b: SolidArg) { overlaps(of_point(&a), near_solid(&b)) }
    fn ab_overlaps_point_box(a: UncertainPoint, b: Aabb) { overlaps(of_point(&a), Ok(b)) }
    fn ab_overlaps_point_point(a: UncertainPoint, b: UncertainPoint) { overlaps(of_point(&a), of_point(&b)) }
    fn ab_overlaps_line_box(a: UncertainLine, b: Aabb) { overlaps(of_line(&a), Ok(b)) }
    fn ab_overlaps_box_point(a: Aabb, b: UncertainPoint) { overlaps(Ok(a), of_point(&b)) }
    fn ab_overlaps_box_line(a: Aabb, b: UncertainLine) { overlaps(Ok(a), of_line(&b)) }

    fn ab_overlaps_tile_box(a: TileArg, b: Aabb) { overlaps(of_tile(&a), Ok(b)) }
    fn ab_overlaps_box_tile(a: Aabb, b: TileArg) { overlaps(Ok(a), of_tile(&b)) }
    fn ab_overlaps_tile_solid(a: TileArg, b: SolidArg) { overlaps(of_tile(&a), of_solid(&b)) }
    fn ab_overlaps_solid_tile(a: SolidArg, b: TileArg) { overlaps(of_solid(&a), of_tile(&b)) }
}
