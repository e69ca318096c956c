//! `&&` between everything that has a box; only headers are read.

use asbuilt_core::Result;
use asbuilt_core::geometry::{Aabb, Solid};
use asbuilt_core::scan::Header;

use super::box_from;
use crate::pg::{Args, Ret, sql_functions};

fn of_box(args: &Args, i: usize) -> Result<Aabb> {
    Ok(box_from(&args.fixed(i)))
}

/// The box of a solid.
pub fn of_solid(args: &Args, i: usize) -> Result<Aabb> {
    Ok(Solid::header(args.prefix(i, Solid::HEADER_LEN))?.bounds)
}

/// For a scan the box that counts is the hull of its beams, origin included.
pub fn of_scan(args: &Args, i: usize) -> Result<Aabb> {
    Ok(Header::read(args.prefix(i, Header::LEN))?.hull)
}

type BoxOf = fn(&Args, usize) -> Result<Aabb>;

fn overlaps(args: &Args, left: BoxOf, right: BoxOf) -> Result<Ret> {
    Ok(Ret::Bool(left(args, 0)?.overlaps(&right(args, 1)?)))
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
}
