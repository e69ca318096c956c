//! `ab_scan`: core's byte form as it is, on disk and on the wire; in hexadecimal as text.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchHeader, PatchSpec, Spacing, check_count};
use asbuilt_core::{Error, Result};

use super::box_bytes;
use super::hex::{hex_in, hex_out};
use super::planes;
use crate::pg::{F64Array, I32Array, Message, SqlValue, TextInput, Varlena, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_scan:1:";

/// A patch.
pub type ScanArg<'a> = Varlena<'a, Patch>;

impl ScanArg<'_> {
    /// Its header alone.
    pub fn header(&self) -> Result<PatchHeader> {
        PatchHeader::read(self.prefix(PatchHeader::LEN))
    }
}

/// What a patch is made from, beside its points.
struct PatchOptions<'a> {
    station: i64,
    quantum: f64,
    intensity: Option<I32Array<'a>>,
    colour: Option<I32Array<'a>>,
}

/// Directions of beams where nothing came back need an origin; they follow the returns and have neither intensity nor
/// colour.
fn from_arrays(
    origin: &F64Array,
    points: &F64Array,
    step: Option<f64>,
    given: &PatchOptions,
    no_return: Option<F64Array>,
) -> Result<Patch> {
    let (origins, starts) = origins(origin)?;
    let (origin, station, quantum) = (starts[0], given.station, given.quantum);
    check_count(points.rows())?;
    let points = points.triples("the points")?;
    if origins == Origins::Each && starts.len() != points.len() {
        let given = format!("{} for {} points", starts.len(), points.len());
        return Err(Error::argument("the origins", "one, or one for every point", given));
    }
    let start = |i: usize| if origins == Origins::Each { starts[i] } else { origin };
    let returned = |(i, p): (usize, [f64; 3])| Beam { offset: Vec3::from(p) - start(i), returned: true };
    let mut content = Beams::of(points.into_iter().enumerate().map(returned).collect());
    content.intensity = planes::intensity(given.intensity.as_ref())?;
    content.colour = planes::colour(given.colour.as_ref())?;
    if origins == Origins::Each {
        content.starts = Some(starts.iter().map(|s| s - origin).collect());
    }
    if let Some(directions) = no_return {
        check_count(content.len() + directions.rows())?;
        let directions = directions.triples("the directions without return")?;
        if origins == Origins::Each {
            return Err(Error::argument("beams without return", "of one origin", "of several"));
        }
        content.extend_without_return(directions.into_iter().map(Vec3::from));
    }
    let spacing = step.map_or_else(|| content.spacing(origins), Spacing::Angle);
    Patch::pack(&PatchSpec { origins, station, origin, spacing, quantum }, &content)
}

/// One origin, or as many as the array has rows; at least one.
fn origins(array: &F64Array) -> Result<(Origins, Vec<Vec3>)> {
    if array.dimensions() < 2 {
        return Ok((Origins::One, vec![array.vector::<3>("the origin")?.into()]));
    }
    check_count(array.rows())?;
    let starts = array.triples("the origins")?;
    let starts: Vec<Vec3> = starts.into_iter().map(Vec3::from).collect();
    if starts.is_empty() { Err(Error::Empty { what: "the list of origins" }) } else { Ok((Origins::Each, starts)) }
}

fn cloud(points: &F64Array, spacing: Option<f64>, given: &PatchOptions) -> Result<Patch> {
    check_count(points.rows())?;
    let points = points.triples("the points")?;
    let points: Vec<Vec3> = points.into_iter().map(Vec3::from).collect();
    let origin = points.first().map_or_else(Vec3::zeros, |p| p.map(f64::round));
    let mut content = Beams::of(points.iter().map(|p| Beam { offset: p - origin, returned: true }).collect());
    content.intensity = planes::intensity(given.intensity.as_ref())?;
    content.colour = planes::colour(given.colour.as_ref())?;
    let (origins, station, quantum) = (Origins::Unknown, given.station, given.quantum);
    let spacing = spacing.map_or_else(|| content.spacing(origins), Spacing::Distance);
    Patch::pack(&PatchSpec { origins, station, origin, spacing, quantum }, &content)
}

sql_functions! {
    fn ab_scan_in(text: TextInput) {
        let bytes = hex_in(&text, "ab_scan", PREFIX)?;
        Ok(SqlValue::Bytes(Patch::from_bytes(&bytes)?.to_bytes()))
    }

    fn ab_scan_out(patch: ScanArg) {
        hex_out(&patch, PREFIX)
    }

    fn ab_scan_recv(message: Message) {
        Ok(SqlValue::Bytes(Patch::from_bytes(message.rest())?.to_bytes()))
    }

    fn ab_scan_send(patch: ScanArg) {
        Ok(patch.copied())
    }

    /// In the SQL of 0.1.0 the arrays behind the quantum are missing.
    fn ab_scan_make(
        origin: F64Array, points: F64Array, step: Option<f64>, station: i64, quantum: f64,
        intensity: Option<I32Array>, colour: Option<I32Array>, no_return: Option<F64Array>,
    ) {
        let given = PatchOptions { station, quantum, intensity, colour };
        Ok(SqlValue::Bytes(from_arrays(&origin, &points, step, &given, no_return)?.to_bytes()))
    }

    fn ab_scan_cloud(
        points: F64Array, spacing: Option<f64>, station: i64, quantum: f64,
        intensity: Option<I32Array>, colour: Option<I32Array>,
    ) {
        let given = PatchOptions { station, quantum, intensity, colour };
        Ok(SqlValue::Bytes(cloud(&points, spacing, &given)?.to_bytes()))
    }

    fn ab_scan_box(patch: ScanArg) {
        Ok(SqlValue::Fixed(box_bytes(&patch.header()?.hull)))
    }

    fn ab_scan_point_box(patch: ScanArg) {
        Ok(SqlValue::Fixed(box_bytes(&patch.header()?.points)))
    }

    fn ab_scan_count(patch: ScanArg) {
        Ok(SqlValue::I32(patch.header()?.beams as i32))
    }

    fn ab_scan_returns(patch: ScanArg) {
        Ok(SqlValue::I32(patch.header()?.returns as i32))
    }

    fn ab_scan_origin(patch: ScanArg) {
        let h = patch.header()?;
        Ok(if h.origins() == Origins::One { SqlValue::vector(h.origin) } else { SqlValue::Null })
    }

    fn ab_scan_station(patch: ScanArg) {
        Ok(SqlValue::I64(patch.header()?.station))
    }
}
