//! The box by which each type is indexed, and `&&` between them; only headers are read.

use asbuilt_core::Result;
use asbuilt_core::geometry::{Aabb, Solid};
use asbuilt_core::scan::{Header, JOIN_MARGIN_M};
use asbuilt_core::uncertain::{Line, Point};
use asbuilt_core::voxel::TileHeader;

use super::{box_from, uncertain};
use crate::pg::{Args, SqlValue, sql_functions};

/// Standard deviations by which a point or line is grown: searches within up to this many are served by an index.
pub const INDEX_SIGMAS: f64 = 5.0;

/// A box itself.
pub fn of_box(args: &Args, i: usize) -> Result<Aabb> {
    Ok(box_from(&args.fixed(i)))
}

/// The box of a solid.
pub fn of_solid(args: &Args, i: usize) -> Result<Aabb> {
    Ok(Solid::header(args.prefix(i, Solid::HEADER_LEN))?.bounds)
}

/// The box within which a point may belong to a solid.
pub fn near_solid(args: &Args, i: usize) -> Result<Aabb> {
    Ok(of_solid(args, i)?.expanded(JOIN_MARGIN_M))
}

/// For a scan, the hull of its beams, origin included.
pub fn of_scan(args: &Args, i: usize) -> Result<Aabb> {
    Ok(Header::read(args.prefix(i, Header::LEN))?.hull)
}

/// A point grown by [`INDEX_SIGMAS`].
pub fn of_point(args: &Args, i: usize) -> Result<Aabb> {
    Ok(uncertain::value::<Point, 9>(args, i).bounds(INDEX_SIGMAS))
}

/// A point at its coordinates, however uncertain.
pub fn place(args: &Args, i: usize) -> Result<Aabb> {
    let at = uncertain::value::<Point, 9>(args, i).position.into();
    Ok(Aabb { min: at, max: at })
}

/// A line grown by [`INDEX_SIGMAS`].
pub fn of_line(args: &Args, i: usize) -> Result<Aabb> {
    Ok(uncertain::value::<Line, 27>(args, i).bounds(INDEX_SIGMAS))
}

/// The blocks of an occupancy or a change about which something is known; if there are none, the tile, or the origin
/// where the tile is unbounded.
pub fn of_tile(args: &Args, i: usize) -> Result<Aabb> {
    tile_box(args.prefix(i, TileHeader::LEN))
}

/// The same from the value's first bytes.
pub fn tile_box(prefix: &[u8]) -> Result<Aabb> {
    let header = TileHeader::read(prefix)?;
    let tile = if header.grid.is_bounded() { header.grid.tile } else { Aabb { min: [0.0; 3], max: [0.0; 3] } };
    Ok(header.bounds().unwrap_or(tile))
}

/// How to find the box of an argument.
pub type BoxOf = fn(&Args, usize) -> Result<Aabb>;

fn overlaps(args: &Args, left: BoxOf, right: BoxOf) -> Result<SqlValue> {
    Ok(SqlValue::Bool(left(args, 0)?.overlaps(&right(args, 1)?)))
}

sql_functions! {
    fn ab_overlaps_box_box(args) { overlaps(args, of_box, of_box) }
    fn ab_overlaps_box_solid(args) { overlaps(args, of_box, of_solid) }
    fn ab_overlaps_box_scan(args) { overlaps(args, of_box, of_scan) }
    fn ab_overlaps_solid_box(args) { overlaps(args, of_solid, of_box) }
    fn ab_overlaps_solid_solid(args) { overlaps(args, of_solid, of_solid) }
    fn ab_overlaps_solid_scan(args) { overlaps(args, of_solid, of_scan) }
    fn ab_overlaps_scan_box(args) { overlaps(args, of_scan, of_box) }
    fn ab_overlaps_scan_solid(args) { overlaps(args, of_scan, of_solid) }
    fn ab_overlaps_scan_scan(args) { overlaps(args, of_scan, of_scan) }

    fn ab_overlaps_solid_point(args) { overlaps(args, near_solid, of_point) }
    fn ab_overlaps_point_solid(args) { overlaps(args, of_point, near_solid) }
    fn ab_overlaps_point_box(args) { overlaps(args, of_point, of_box) }
    fn ab_overlaps_point_point(args) { overlaps(args, of_point, of_point) }
    fn ab_overlaps_line_box(args) { overlaps(args, of_line, of_box) }
    fn ab_overlaps_box_point(args) { overlaps(args, of_box, of_point) }
    fn ab_overlaps_box_line(args) { overlaps(args, of_box, of_line) }

    fn ab_overlaps_tile_box(args) { overlaps(args, of_tile, of_box) }
    fn ab_overlaps_box_tile(args) { overlaps(args, of_box, of_tile) }
    fn ab_overlaps_tile_solid(args) { overlaps(args, of_tile, of_solid) }
    fn ab_overlaps_solid_tile(args) { overlaps(args, of_solid, of_tile) }
}
