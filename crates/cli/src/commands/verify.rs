//! `asbuilt verify`: the query with `ab_verify_table`, printed.

use anyhow::Result;
use asbuilt_core::evidence::{Loa, SensorPreset};
use postgres::types::ToSql;
use postgres::{IsolationLevel, Row};
use serde_json::Value;

use super::load::parse_loa;
use crate::database::connect::{Database, DatabaseArgs, explain};
use crate::database::origins::StationOrigins;
use crate::database::tables;
use crate::output::{Format, Table, rounded, say, spinner};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Verdicts: confirmed (built, within the tolerance), deviating (built, but displaced beyond it), absent (its space was
seen empty), unobserved (too little was seen to say), conflicting (stations contradict each other).

coverage is seen/all samples; confirmed + refuted + open = 1 over the seen ones; deviation is the median along its
outward normal of the largest face that is certainly off, else of the largest, and shift the rigid offset (x, y, z) with its standard deviation, both
in metres; '-' marks an axis that the seen faces do not determine (JSON: null; CSV: an empty cell, a column an axis).

An object is looked for up to --reach from its drawn place (a plane face, as large as its own, that no other object
explains): deviating by that distance. Farther off it is absent, if its place was seen empty.

Stations whose scanner's place nobody knows (merged clouds) never prove that a place is empty; how many they are is said on
standard error, and asbuilt load --origins FILE tells their places.

reason says why an object is unobserved: hidden_by_object (hidden_by: which), hidden_by_other (something that nobody
drew), too_few beams, too_steep, not_looked_at, no_return, or shared_face (what was met may as well be another object's,
drawn at the same place).

CSV is guarded against spreadsheets: a text that begins with = + - @, a tab or a carriage return gets an apostrophe before
it, numbers never; --format csv-exact writes everything as it is.")]
pub struct VerifyArgs {
    /// Epoch of the scans
    #[arg(long, default_value_t = 1, value_name = "N", allow_hyphen_values = true)]
    epoch: i32,
    /// Judge every object at this level of accuracy, instead of at its own
    #[arg(long, value_parser = parse_loa)]
    loa: Option<Loa>,
    /// Evidence model: surface, or meyer2022 (as published; for comparison)
    #[arg(long, default_value = "surface")]
    model: String,
    /// Distance between samples on the objects, metres
    #[arg(long, default_value_t = 0.02, value_name = "M")]
    spacing: f64,
    /// Kind of scanner, for its standard uncertainties: phase, hybrid, pulse, compact, handheld or tablet
    #[arg(long, value_name = "NAME")]
    sensor: Option<String>,
    /// Standard deviation of a range, metres
    #[arg(long, value_name = "M")]
    sigma_range: Option<f64>,
    /// Standard deviation of a station's registration, metres
    #[arg(long, value_name = "M")]
    sigma_station: Option<f64>,
    /// How far from its drawn place an object is looked for that is not there, metres [default: 0.3]
    #[arg(long, value_name = "M")]
    reach: Option<f64>,
    /// Belief from which a sample counts as confirmed or refuted
    #[arg(long, value_name = "P")]
    confidence: Option<f64>,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    database: DatabaseArgs,
}

/// Every literal has its type and every name its schema, so that what others have planted beside the extension matches
/// less well.
const VERDICTS: &str = "
SELECT o.name, o.global_id, o.ifc_class, o.storey, coalesce($2::text, o.loa::text), s.verdict, s.best_loa::text, s.samples,
       s.coverage, s.confirmed, s.refuted, s.open, s.conflict, s.deviation, s.deviation_sd, s.shift, s.shift_sd,
       s.deviation_normal, s.deviation_face, s.reason, s.reason_shares, coalesce(h.name, s.hidden_by), coalesce(t.name, s.drawn_twice)
FROM   @building_object o
JOIN   @ext.ab_verify_table(
           pg_catalog.format($9::text, $2::text, $3::text, $4::float8, $5::float8, $8::float8, $6::float8, $7::float8, $10::float8),
           $1::text, NULL::@ext.ab_evidence_model, false, NULL::float8, NULL::float8, NULL::float8) s ON s.id = o.id
LEFT   JOIN @building_object h ON h.id = s.hidden_by::int8
LEFT   JOIN @building_object t ON t.id = s.drawn_twice::int8
ORDER  BY o.id";

/// What is verified, as a template for PostgreSQL's `format`.
pub const OBJECTS: &str = "
SELECT id, solid, @ext.ab_evidence_model(loa => coalesce(%L::@ext.ab_loa, loa), model => %L::text, spacing => %L::float8,
       sigma_range => %L::float8, sigma_angle => %L::float8, sigma_station => %L::float8, confidence => %L::float8,
       reach => %L::float8)
FROM   @building_object";

pub fn run(args: &VerifyArgs) -> Result<()> {
    let mut db = args.database.connect()?;
    tables::check_loaded(&mut db)?;
    tables::check_epoch(&mut db, args.epoch)?;
    let mut table = Table::new(&columns(args.format));
    for row in judged(args, &mut db)? {
        table.push(cells(&row, args.format));
    }
    if let Some(remark) = StationOrigins::count(&mut db, args.epoch)?.remark() {
        say!("asbuilt: {remark}");
    }
    table.print(args.format)
}

/// A row of [`VERDICTS`] per object.
fn judged(args: &VerifyArgs, db: &mut Database) -> Result<Vec<Row>> {
    let verdicts = db.sql(VERDICTS);
    let objects = db.names.for_format().sql(OBJECTS);
    let scans = format!("{} WHERE epoch = '{}'::int4", db.sql("SELECT patch FROM @scan"), args.epoch);
    let loa = args.loa.map(Loa::name);
    let preset = args.sensor.as_deref().map(SensorPreset::named).transpose()?;
    let sigma_range = args.sigma_range.or(preset.map(|p| p.sigma_range));
    let sigma_station = args.sigma_station.or(preset.map(|p| p.sigma_station));
    let sigma_angle = preset.map(|p| p.sigma_angle);
    let bar = spinner("verifying");
    let one_view = db.client.build_transaction().read_only(true).isolation_level(IsolationLevel::RepeatableRead);
    let mut client = one_view.start().map_err(explain)?;
    let VerifyArgs { model, spacing, confidence, reach, .. } = args;
    let parameters: [&(dyn ToSql + Sync); 10] =
        [&scans, &loa, model, spacing, &sigma_range, &sigma_station, confidence, &sigma_angle, &objects, reach];
    let rows = client.query(&verdicts, &parameters).map_err(explain)?;
    bar.finish_and_clear();
    Ok(rows)
}

/// Whether what identifies an object is printed, too.
fn is_wide(format: Format) -> bool {
    format != Format::Table
}

fn columns(format: Format) -> Vec<&'static str> {
    let mut columns = vec!["name"];
    if is_wide(format) {
        columns.extend(["global_id", "ifc_class", "storey"]);
    }
    columns.extend(["loa", "verdict", "best_loa", "samples", "coverage", "confirmed", "refuted", "open", "conflict"]);
    columns.extend(["deviation", "deviation_sd"]);
    columns.extend(shift_columns(format));
    columns.extend(face_columns(format));
    columns.push("reason");
    columns.extend(reason_columns(format));
    columns.push("hidden_by");
    if is_wide(format) {
        columns.push("drawn_twice");
    }
    columns
}

/// A row of [`VERDICTS`] under [`columns`].
fn cells(row: &Row, format: Format) -> Vec<Value> {
    let text = |i: usize| row.get::<_, Option<String>>(i).map_or(Value::Null, Value::from);
    let number = |i: usize, digits: i32| rounded(row.get::<_, Option<f64>>(i), digits);
    let mut out = vec![text(0)];
    if is_wide(format) {
        out.extend([text(1), text(2), text(3)]);
    }
    let samples = row.get::<_, Option<i64>>(7).map_or(Value::Null, Value::from);
    // No solid, no evidence: the object is there all the same.
    let verdict = if text(5).is_null() { Value::from("unobserved") } else { text(5) };
    out.extend([text(4), verdict, text(6), samples]);
    out.extend((8..13).map(|i| number(i, 3)));
    out.extend([number(13, 4), number(14, 4)]);
    out.extend(shift(format, row.get(15), row.get(16)));
    if is_wide(format) {
        out.extend(numbers(format, row.get(17), 3, 6));
        out.push(row.get::<_, Option<i32>>(18).map_or(Value::Null, Value::from));
    }
    out.push(text(19));
    if is_wide(format) {
        out.extend(numbers(format, row.get(20), 7, 3));
    }
    out.push(text(21));
    if is_wide(format) {
        out.push(text(22));
    }
    out
}

/// The face that the deviation is of.
fn face_columns(format: Format) -> &'static [&'static str] {
    match format {
        Format::Table => &[],
        Format::Csv | Format::CsvExact => &["normal_x", "normal_y", "normal_z", "deviation_face"],
        Format::Json => &["deviation_normal", "deviation_face"],
    }
}

/// The shares of the reasons for which an object was not seen.
fn reason_columns(format: Format) -> &'static [&'static str] {
    match format {
        Format::Table => &[],
        Format::Csv | Format::CsvExact => &[
            "hidden_by_object",
            "hidden_by_other",
            "too_few",
            "too_steep",
            "not_looked_at",
            "no_return",
            "shared_face",
        ],
        Format::Json => &["reason_shares"],
    }
}

/// `count` numbers: a column each for spreadsheets, an array for programs.
fn numbers(format: Format, values: Option<Vec<f64>>, count: usize, digits: i32) -> Vec<Value> {
    let values = values.map(|v| v.into_iter().map(|x| rounded(Some(x), digits)).collect::<Vec<_>>());
    match format {
        Format::Json => vec![values.map_or(Value::Null, Value::from)],
        _ => values.unwrap_or(vec![Value::Null; count]),
    }
}

/// One text for people, a number a column for spreadsheets, arrays for programs.
pub fn shift_columns(format: Format) -> &'static [&'static str] {
    match format {
        Format::Table => &["shift"],
        Format::Csv | Format::CsvExact => &["shift_x", "shift_y", "shift_z", "shift_sd_x", "shift_sd_y", "shift_sd_z"],
        Format::Json => &["shift", "shift_sd"],
    }
}

/// Numbers along x, y and z; `None` where the seen faces do not determine one, or any.
pub type NumbersByAxis = Option<Vec<Option<f64>>>;

/// The rigid offset and its standard deviation under these columns, to a tenth of a millimetre.
pub fn shift(format: Format, offset: NumbersByAxis, sd: NumbersByAxis) -> Vec<Value> {
    let rounded = |axes: &NumbersByAxis| axes.as_ref().map(|a| a.iter().map(|v| rounded(*v, 4)).collect::<Vec<_>>());
    match format {
        Format::Table => {
            let words = |axes: Vec<Option<f64>>, word: fn(f64) -> String| {
                axes.into_iter().map(|v| v.map_or("-".into(), word)).collect::<Vec<_>>().join(", ")
            };
            let text =
                |(o, s)| format!("({}) +/- ({})", words(o, |v| format!("{v:+.4}")), words(s, |v| format!("{v:.4}")));
            vec![offset.zip(sd).map_or(Value::Null, |both| text(both).into())]
        }
        Format::Csv | Format::CsvExact => {
            [offset, sd].iter().flat_map(|axes| rounded(axes).unwrap_or(vec![Value::Null; 3])).collect()
        }
        Format::Json => [offset, sd].iter().map(|axes| rounded(axes).map_or(Value::Null, Value::from)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shift_is_told_in_numbers() {
        let (offset, sd) =
            (Some(vec![Some(0.012_14), None, Some(-0.0003)]), Some(vec![Some(0.0004), None, Some(0.001)]));
        let told = |format| {
            let values = shift(format, offset.clone(), sd.clone());
            assert_eq!(values.len(), shift_columns(format).len());
            assert!(shift(format, None, None).iter().all(Value::is_null));
            Value::from(values).to_string()
        };
        assert_eq!(told(Format::Table), r#"["(+0.0121, -, -0.0003) +/- (0.0004, -, 0.0010)"]"#);
        assert_eq!(told(Format::Csv), "[0.0121,null,-0.0003,0.0004,null,0.001]");
        assert_eq!(told(Format::Json), "[[0.0121,null,-0.0003],[0.0004,null,0.001]]");
    }
}
