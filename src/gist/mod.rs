//! GiST support for everything that has a box. Keys are `ab_box`; `&&` is answered by the key alone.

use asbuilt_core::geometry::split::{penalty, split};
use asbuilt_core::geometry::{Aabb, Solid, hilbert};
use asbuilt_core::scan::PatchHeader;
use asbuilt_core::uncertain::{Stored, UncertainLine, UncertainPoint};
use asbuilt_core::voxel::TileHeader;

use crate::pg::{
    Answer, Entry, GistQuery, Internal, KeyVector, Oid, PickSplit, SortKey, SqlValue, sorted_by, sql_functions,
};
use crate::types::overlap::{INDEX_SIGMAS, near_solid, of_point, of_scan, of_solid, of_tile, place, tile_box};
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

fn query(query: &GistQuery, strategy: i16) -> asbuilt_core::Result<Aabb> {
    match strategy {
        OVERLAPS_BOX | CONTAINS | CONTAINED | SAME => query.of(),
        OVERLAPS_SOLID => of_solid(&query.of()?),
        OVERLAPS_SCAN => of_scan(&query.of()?),
        OVERLAPS_POINT => of_point(&query.of()?),
        POINT_OVERLAPS_SOLID => near_solid(&query.of()?),
        OVERLAPS_OCCUPANCY | OVERLAPS_CHANGE => of_tile(&query.of()?),
        other => Err(asbuilt_core::Error::argument("the GiST strategy", "1 to 7 or 10 to 12", other)),
    }
}

fn nearest(entry: &Entry, query: &GistQuery, strategy: i16) -> asbuilt_core::Result<SqlValue> {
    let query = match strategy {
        DISTANCE_TO_POINT => place(&query.of()?),
        _ => query.of()?,
    };
    Ok(SqlValue::F64(entry.key().distance(&query)))
}

/// Keys of a sorted build lie along a Hilbert curve.
struct Curve;

impl SortKey<BOX_LEN> for Curve {
    fn of(key: &[u8; BOX_LEN]) -> u64 {
        hilbert(&box_from(key))
    }
}

sql_functions! {
    fn ab_gist_sort(call: Call; support: Internal) { Ok(sorted_by::<Curve, BOX_LEN>(call)) }

    fn ab_gist_consistent(entry: Entry, value: GistQuery, strategy: i16, subtype: Oid, recheck: Answer<bool>) {
        recheck.set(strategy >= CONTAINS);
        let (key, query) = (entry.key(), query(&value, strategy)?);
        Ok(SqlValue::Bool(match strategy {
            CONTAINS | SAME => key.contains(&query),
            _ => key.overlaps(&query),
        }))
    }

    /// To the key, which contains everything below it. Boxes and solids are as near as their keys.
    fn ab_gist_distance(entry: Entry, query: GistQuery, strategy: i16, subtype: Oid, recheck: Answer<bool>) {
        recheck.set(false);
        nearest(&entry, &query, strategy)
    }

    /// The same where the operator measures to something smaller than the key: the returns of a patch, the place of a
    /// point.
    fn ab_gist_distance_lossy(entry: Entry, query: GistQuery, strategy: i16, subtype: Oid, recheck: Answer<bool>) {
        recheck.set(true);
        nearest(&entry, &query, strategy)
    }

    fn ab_gist_union(keys: KeyVector, size: Answer<i32>) {
        let union = (0..keys.len()).fold(Aabb::EMPTY, |u, i| u.union(&keys.key(i)));
        size.set(BOX_LEN as i32);
        Ok(SqlValue::Fixed(box_bytes(&union)))
    }

    fn ab_gist_scan_compress(entry: Entry) {
        entry.compressed(PatchHeader::LEN, |bytes| Ok(box_bytes(&PatchHeader::read(bytes)?.hull)))
    }

    fn ab_gist_solid_compress(entry: Entry) {
        entry.compressed(Solid::HEADER_LEN, |bytes| Ok(box_bytes(&Solid::header(bytes)?.bounds)))
    }

    fn ab_gist_tile_compress(entry: Entry) {
        entry.compressed(TileHeader::LEN, |bytes| Ok(box_bytes(&tile_box(bytes)?)))
    }

    fn ab_gist_point_compress(entry: Entry) {
        entry.compressed_fixed(|n: &[f64; 9]| box_bytes(&UncertainPoint::from_stored(n).bounds(INDEX_SIGMAS)))
    }

    fn ab_gist_line_compress(entry: Entry) {
        entry.compressed_fixed(|n: &[f64; 27]| box_bytes(&UncertainLine::from_stored(n).bounds(INDEX_SIGMAS)))
    }

    fn ab_gist_penalty(key: Entry, new: Entry, result: Answer<f32>) {
        result.set(penalty(&key.key(), &new.key()));
        Ok(result.ret())
    }

    /// Entries count from 1.
    fn ab_gist_picksplit(keys: KeyVector, result: PickSplit) {
        let boxes: Vec<Aabb> = (1..keys.len()).map(|i| keys.key(i)).collect();
        let (left, right) = split(&boxes);
        let side = |group: &[usize]| {
            let union = group.iter().fold(Aabb::EMPTY, |u, &i| u.union(&boxes[i]));
            (group.iter().map(|&i| i as u16 + 1).collect::<Vec<u16>>(), box_bytes(&union))
        };
        let (l, r) = (side(&left), side(&right));
        result.set((&l.0, &l.1), (&r.0, &r.1));
        Ok(result.ret())
    }

    fn ab_gist_same(a: Aabb, b: Aabb, result: Answer<bool>) {
        result.set(a == b);
        Ok(result.ret())
    }
}
