//! GiST support for everything that has a box. Keys are `ab_box`; `&&` is answered by the key alone.

use asbuilt_core::geometry::split::{penalty, split};
use asbuilt_core::geometry::{Aabb, Solid, hilbert};
use asbuilt_core::scan::Header;
use asbuilt_core::uncertain::{Line, Point, Stored};
use asbuilt_core::voxel::TileHeader;

use crate::pg::{Args, KeyVector, PickSplit, Place, SqlValue, sorted_by, sql_functions};
use crate::types::overlap::{INDEX_SIGMAS, near_solid, of_box, of_point, of_scan, of_solid, of_tile, place, tile_box};
use crate::types::{BOX_LEN, box_bytes, box_from};

/// Strategy numbers: `&&` with each right-hand type, the same in every opclass.
const OVERLAPS_BOX: i16 = 1;
const OVERLAPS_SOLID: i16 = 2;
const OVERLAPS_SCAN: i16 = 3;
const OVERLAPS_POINT: i16 = 4;
const POINT_OVERLAPS_SOLID: i16 = 5;
const OVERLAPS_OCCUPANCY: i16 = 6;
const OVERLAPS_CHANGE: i16 = 7;
/// `@>`, `<@` and `~=` with a box; the key decides on inner pages, the operator itself on leaves (recheck).
const CONTAINS: i16 = 10;
const CONTAINED: i16 = 11;
const SAME: i16 = 12;
/// `<->` with a box (13) or a point.
const DISTANCE_TO_POINT: i16 = 14;

fn key(args: &Args, i: usize) -> Aabb {
    box_from(&args.entry_key::<BOX_LEN>(i))
}

fn query(args: &Args, strategy: i16) -> asbuilt_core::Result<Aabb> {
    match strategy {
        OVERLAPS_BOX | CONTAINS | CONTAINED | SAME => of_box(args, 1),
        OVERLAPS_SOLID => of_solid(args, 1),
        OVERLAPS_SCAN => of_scan(args, 1),
        OVERLAPS_POINT => of_point(args, 1),
        POINT_OVERLAPS_SOLID => near_solid(args, 1),
        OVERLAPS_OCCUPANCY | OVERLAPS_CHANGE => of_tile(args, 1),
        other => Err(asbuilt_core::Error::argument("the GiST strategy", "1 to 7 or 10 to 12", other)),
    }
}

fn nearest(args: &Args, recheck: bool) -> asbuilt_core::Result<SqlValue> {
    args.set_flag(4, recheck);
    let query = match args.i16(2) {
        DISTANCE_TO_POINT => place(args, 1)?,
        _ => of_box(args, 1)?,
    };
    Ok(SqlValue::F64(key(args, 0).distance(&query)))
}

/// Keys of a sorted build lie along a Hilbert curve.
struct Curve;

impl Place<BOX_LEN> for Curve {
    fn of(key: &[u8; BOX_LEN]) -> u64 {
        hilbert(&box_from(key))
    }
}

sql_functions! {
    fn ab_gist_sort(args) { Ok(sorted_by::<Curve, BOX_LEN>(args)) }

    /// consistent(entry, query, strategy, subtype, recheck)
    fn ab_gist_consistent(args) {
        let strategy = args.i16(2);
        args.set_flag(4, strategy >= CONTAINS);
        let (key, query) = (key(args, 0), query(args, strategy)?);
        Ok(SqlValue::Bool(match strategy {
            CONTAINS | SAME => key.contains(&query),
            _ => key.overlaps(&query),
        }))
    }

    /// distance(entry, query, strategy, subtype, recheck): to the key, which contains everything below it. Boxes and
    /// solids are as near as their keys.
    fn ab_gist_distance(args) { nearest(args, false) }

    /// The same where the operator measures to something smaller than the key: the returns of a patch, the place of a
    /// point.
    fn ab_gist_distance_lossy(args) { nearest(args, true) }

    /// union(vector, size)
    fn ab_gist_union(args) {
        let keys = KeyVector::arg(args, 0);
        let union = (0..keys.len()).fold(Aabb::EMPTY, |u, i| u.union(&box_from(&keys.key(i))));
        args.set_size(1, BOX_LEN);
        Ok(SqlValue::Fixed(box_bytes(&union)))
    }

    fn ab_gist_scan_compress(args) {
        args.compressed(Header::LEN, |bytes| Ok(box_bytes(&Header::read(bytes)?.hull)))
    }

    fn ab_gist_solid_compress(args) {
        args.compressed(Solid::HEADER_LEN, |bytes| Ok(box_bytes(&Solid::header(bytes)?.bounds)))
    }

    fn ab_gist_tile_compress(args) {
        args.compressed(TileHeader::LEN, |bytes| Ok(box_bytes(&tile_box(bytes)?)))
    }

    fn ab_gist_point_compress(args) {
        args.compressed_fixed(|n: &[f64; 9]| box_bytes(&Point::from_stored(n).bounds(INDEX_SIGMAS)))
    }

    fn ab_gist_line_compress(args) {
        args.compressed_fixed(|n: &[f64; 27]| box_bytes(&Line::from_stored(n).bounds(INDEX_SIGMAS)))
    }

    /// penalty(key entry, new entry, result)
    fn ab_gist_penalty(args) {
        args.set_f32(2, penalty(&key(args, 0), &key(args, 1)));
        Ok(SqlValue::Raw(args.pointer(2)))
    }

    /// picksplit(vector, result); entries count from 1.
    fn ab_gist_picksplit(args) {
        let keys = KeyVector::arg(args, 0);
        let boxes: Vec<Aabb> = (1..keys.len()).map(|i| box_from(&keys.key(i))).collect();
        let (left, right) = split(&boxes);
        let side = |group: &[usize]| {
            let union = group.iter().fold(Aabb::EMPTY, |u, &i| u.union(&boxes[i]));
            (group.iter().map(|&i| i as u16 + 1).collect::<Vec<u16>>(), box_bytes(&union))
        };
        let (l, r) = (side(&left), side(&right));
        PickSplit::arg(args, 1).set((&l.0, &l.1), (&r.0, &r.1));
        Ok(SqlValue::Raw(args.pointer(1)))
    }

    /// same(key, key, result)
    fn ab_gist_same(args) {
        args.set_flag(2, args.fixed::<BOX_LEN>(0) == args.fixed::<BOX_LEN>(1));
        Ok(SqlValue::Raw(args.pointer(2)))
    }
}
