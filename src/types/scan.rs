//! `ab_scan`: core's byte form as it is, on disk and on the wire; in hexadecimal as text.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Beams, Header, Origins, Patch, PatchSpec, check_count};
use asbuilt_core::{Error, Result};

use super::box_bytes;
use super::hex::{hex_in, hex_out};
use super::planes;
use crate::pg::{Args, SqlValue, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_scan:1:";

/// The header of the patch in argument 0.
pub fn header(args: &Args) -> Result<Header> {
    Header::read(args.prefix(0, Header::LEN))
}

/// ab_scan(origin, points, step, station, quantum, intensity, colour, no_return)
///
/// Directions of beams where nothing came back need an origin; they follow the returns and have neither intensity nor
/// colour.
fn from_arrays(args: &Args) -> Result<Patch> {
    let (origins, starts) = origins(args)?;
    let (origin, station, quantum) = (starts[0], args.i64(3), args.f64(4));
    let points = args.f64_triples(1, "the points")?;
    check_count(points.len())?;
    if origins == Origins::Each && starts.len() != points.len() {
        let given = format!("{} for {} points", starts.len(), points.len());
        return Err(Error::argument("the origins", "one, or one for every point", given));
    }
    let start = |i: usize| if origins == Origins::Each { starts[i] } else { origin };
    let returned = |(i, p): (usize, [f64; 3])| Beam { offset: Vec3::from(p) - start(i), returned: true };
    let mut content = Beams::of(points.into_iter().enumerate().map(returned).collect());
    content.intensity = planes::intensity(args, 5)?;
    content.colour = planes::colour(args, 6)?;
    if origins == Origins::Each {
        content.starts = Some(starts.iter().map(|s| s - origin).collect());
    }
    if args.has(7) {
        let directions = args.f64_triples(7, "the directions without return")?;
        check_count(content.len() + directions.len())?;
        if origins == Origins::Each {
            return Err(Error::argument("beams without return", "of one origin", "of several"));
        }
        content.extend_without_return(directions.into_iter().map(Vec3::from));
    }
    let step = if args.is_null(2) { content.step(origins) } else { args.f64(2) };
    Patch::pack(&PatchSpec { origins, station, origin, step, quantum }, &content)
}

/// One origin, or as many as the array has rows; at least one.
fn origins(args: &Args) -> Result<(Origins, Vec<Vec3>)> {
    let (dims, _) = args.f64_array(0, "the origin")?;
    if dims.len() < 2 {
        return Ok((Origins::One, vec![args.vector::<3>(0, "the origin")?.into()]));
    }
    let starts = args.f64_triples(0, "the origins")?;
    check_count(starts.len())?;
    let starts: Vec<Vec3> = starts.into_iter().map(Vec3::from).collect();
    if starts.is_empty() { Err(Error::Empty { what: "the list of origins" }) } else { Ok((Origins::Each, starts)) }
}

/// ab_cloud(points, spacing, station, quantum, intensity, colour)
fn cloud(args: &Args) -> Result<Patch> {
    let points = args.f64_triples(0, "the points")?;
    check_count(points.len())?;
    let points: Vec<Vec3> = points.into_iter().map(Vec3::from).collect();
    let origin = points.first().map_or_else(Vec3::zeros, |p| p.map(f64::round));
    let mut content = Beams::of(points.iter().map(|p| Beam { offset: p - origin, returned: true }).collect());
    content.intensity = planes::intensity(args, 4)?;
    content.colour = planes::colour(args, 5)?;
    let (origins, station, quantum) = (Origins::Unknown, args.i64(2), args.f64(3));
    let step = if args.is_null(1) { content.step(origins) } else { args.f64(1) };
    Patch::pack(&PatchSpec { origins, station, origin, step, quantum }, &content)
}

sql_functions! {
    fn ab_scan_in(args) {
        let bytes = hex_in(args, "ab_scan", PREFIX)?;
        Ok(SqlValue::Bytes(Patch::from_bytes(&bytes)?.to_bytes()))
    }

    fn ab_scan_out(args) {
        hex_out(args, PREFIX)
    }

    fn ab_scan_recv(args) {
        Ok(SqlValue::Bytes(Patch::from_bytes(args.message(0))?.to_bytes()))
    }

    fn ab_scan_send(args) {
        Ok(args.copied(0))
    }

    fn ab_scan_make(args) {
        if [0, 1, 3, 4].iter().any(|&i| args.is_null(i)) {
            return Ok(SqlValue::Null);
        }
        Ok(SqlValue::Bytes(from_arrays(args)?.to_bytes()))
    }

    fn ab_scan_cloud(args) {
        if [0, 2, 3].iter().any(|&i| args.is_null(i)) {
            return Ok(SqlValue::Null);
        }
        Ok(SqlValue::Bytes(cloud(args)?.to_bytes()))
    }

    fn ab_scan_box(args) {
        Ok(SqlValue::Fixed(box_bytes(&header(args)?.hull)))
    }

    fn ab_scan_point_box(args) {
        Ok(SqlValue::Fixed(box_bytes(&header(args)?.points)))
    }

    fn ab_scan_count(args) {
        Ok(SqlValue::I32(header(args)?.beams as i32))
    }

    fn ab_scan_returns(args) {
        Ok(SqlValue::I32(header(args)?.returns as i32))
    }

    fn ab_scan_origin(args) {
        let h = header(args)?;
        Ok(if h.origins() == Origins::One { SqlValue::vector(h.origin) } else { SqlValue::Null })
    }

    fn ab_scan_station(args) {
        Ok(SqlValue::I64(header(args)?.station))
    }
}
