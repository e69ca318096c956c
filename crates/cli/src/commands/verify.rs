//! `asbuilt verify`: the query with `ab_verify_table`, printed.

use anyhow::Result;
use asbuilt_core::evidence::{Loa, SensorPreset};
use postgres::types::ToSql;
use postgres::{IsolationLevel, Row};
use serde_json::Value;

use super::load::parse_loa;
use crate::database::connect::{Database, DatabaseArgs, explain};
use crate::database::tables;
use crate::output::{Format, Table, rounded, say, spinner};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Verdicts: confirmed (built, within the tolerance), deviating (built, but displaced beyond it), absent (its space was
seen empty), unobserved (too little was seen to say), conflicting (stations contradict each other).

coverage is seen/all samples; confirmed + refuted + open = 1 over the seen ones; deviation is the median of the
worst well-seen face along its outward normal and shift the rigid offset (x, y, z) with its standard deviation, both
in metres; '-' marks an axis that the seen faces do not determine (JSON: null; CSV: an empty cell, a column an axis).

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
       s.coverage, s.confirmed, s.refuted, s.open, s.conflict, s.deviation, s.deviation_sd, s.shift, s.shift_sd
FROM   @building_object o
JOIN   @ext.ab_verify_table(
           pg_catalog.format($9::text, $2::text, $3::text, $4::float8, $5::float8, $8::float8, $6::float8, $7::float8, $10::int8[]),
           $1::text, NULL::@ext.ab_evidence_model, false, NULL::float8, NULL::float8, NULL::float8) s ON s.id = o.id
ORDER  BY o.id";

/// What is verified, as a template for PostgreSQL's `format`.
pub const OBJECTS: &str = "
SELECT id, solid, @ext.ab_evidence_model(loa => coalesce(%L::@ext.ab_loa, loa), model => %L::text, spacing => %L::float8,
       sigma_range => %L::float8, sigma_angle => %L::float8, sigma_station => %L::float8, confidence => %L::float8)
FROM   @building_object WHERE id = ANY(%L::int8[])";

/// Objects that are verified together: neighbours know each other, and their evidence is in memory together.
pub const BATCHES: &str = "
SELECT pg_catalog.array_agg(id ORDER BY id) FROM (
  SELECT id, pg_catalog.floor(pg_catalog.sum(least(coalesce(@ext.ab_area(solid), 0::float8) / ($1::float8 * $1::float8), 5e6::float8))
                              OVER (ORDER BY id) / 20e6::float8) AS batch FROM @building_object) x
GROUP BY batch ORDER BY batch";

pub fn run(args: &VerifyArgs) -> Result<()> {
    let mut db = args.database.connect()?;
    tables::check_loaded(&mut db)?;
    tables::check_epoch(&mut db, args.epoch)?;
    let mut table = Table::new(&columns(args.format));
    for row in judged(args, &mut db)? {
        table.push(cells(&row, args.format));
    }
    table.print(args.format)
}

/// A row of [`VERDICTS`] per object, batch by batch; all batches see the same data.
fn judged(args: &VerifyArgs, db: &mut Database) -> Result<Vec<Row>> {
    let (verdicts, batches) = (db.sql(VERDICTS), db.sql(BATCHES));
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
    let batches = client.query(&batches, &[&args.spacing]).map_err(explain)?;
    if batches.len() > 1 {
        bar.suspend(|| warn_of_batches(batches.len()));
    }
    let mut rows = Vec::new();
    for batch in batches {
        let ids: Vec<i64> = batch.get(0);
        let VerifyArgs { model, spacing, confidence, .. } = args;
        let (range, station, angle) = (&sigma_range, &sigma_station, &sigma_angle);
        let parameters: [&(dyn ToSql + Sync); 10] =
            [&scans, &loa, model, spacing, range, station, confidence, angle, &objects, &ids];
        rows.extend(client.query(&verdicts, &parameters).map_err(explain)?);
    }
    bar.finish_and_clear();
    Ok(rows)
}

pub fn warn_of_batches(count: usize) {
    say!(
        "asbuilt: {count} batches of some 20 million samples; objects of different batches do not know each other as \
        neighbours (a wider --spacing makes fewer)"
    );
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
    out
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
