//! `ab_scan`: core's byte form as it is, on disk and on the wire; in hexadecimal as text.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Header, MAX_BEAMS, Patch, mean_step};
use asbuilt_core::{Error, Result};

use super::box_bytes;
use super::hex::{hex_in, hex_out};
use crate::pg::{Args, Ret, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_scan:1:";

/// The header of the patch in argument 0.
pub fn header(args: &Args) -> Result<Header> {
    Header::read(args.prefix(0, Header::LEN))
}

/// ab_scan(origin, points, step, station, quantum)
fn from_arrays(args: &Args) -> Result<Patch> {
    let origin = Vec3::from(args.vector::<3>(0, "the origin")?);
    let points = args.f64_triples(1, "the points")?;
    if points.len() > MAX_BEAMS {
        return Err(Error::Limit {
            what: "the number of beams of a patch",
            value: points.len().to_string(),
            limit: MAX_BEAMS.to_string(),
        });
    }
    let beams: Vec<Beam> =
        points.into_iter().map(|p| Beam { offset: Vec3::from(p) - origin, returned: true }).collect();
    let step = if args.is_null(2) { mean_step(&beams) } else { args.f64(2) };
    Patch::encode(args.i64(3), origin, step, args.f64(4), &beams)
}

sql_functions! {
    fn ab_scan_in(args) {
        let bytes = hex_in(args, "ab_scan", PREFIX)?;
        Ok(Ret::Bytes(Patch::from_bytes(&bytes)?.to_bytes()))
    }

    fn ab_scan_out(args) {
        hex_out(args, PREFIX)
    }

    fn ab_scan_recv(args) {
        Ok(Ret::Bytes(Patch::from_bytes(args.message(0))?.to_bytes()))
    }

    fn ab_scan_send(args) {
        Ok(args.fetched(0))
    }

    fn ab_scan_make(args) {
        if [0, 1, 3, 4].iter().any(|&i| args.is_null(i)) {
            return Ok(Ret::Null);
        }
        Ok(Ret::Bytes(from_arrays(args)?.to_bytes()))
    }

    fn ab_scan_box(args) {
        Ok(Ret::Fixed(box_bytes(&header(args)?.hull)))
    }

    fn ab_scan_point_box(args) {
        Ok(Ret::Fixed(box_bytes(&header(args)?.points)))
    }

    fn ab_scan_count(args) {
        Ok(Ret::I32(header(args)?.beams as i32))
    }

    fn ab_scan_returns(args) {
        Ok(Ret::I32(header(args)?.returns as i32))
    }

    fn ab_scan_origin(args) {
        let h = header(args)?;
        Ok(if h.has_origin() { Ret::vector(h.origin) } else { Ret::Null })
    }

    fn ab_scan_station(args) {
        Ok(Ret::I64(header(args)?.station))
    }
}
