//! `asbuilt list`: what is loaded.

use anyhow::Result;
use postgres::Row;
use serde_json::Value;

use crate::database::connect::{DatabaseArgs, explain};
use crate::database::tables;
use crate::output::{Format, LengthUnit, Table, rounded};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Files: every model with its objects, every file of scans with its epoch and stations. Stations: every scanner position, with how its
place is known. What is loaded is removed by asbuilt remove.

Examples:
  asbuilt list
  asbuilt list stations --format csv")]
pub struct ListArgs {
    /// What to list
    #[arg(value_enum, default_value_t)]
    what: Listed,
    /// Unit of lengths [default: mm in tables, m in CSV and JSON]
    #[arg(long, value_enum, value_name = "UNIT")]
    units: Option<LengthUnit>,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    database: DatabaseArgs,
}

/// What can be listed.
#[derive(clap::ValueEnum, Debug, Clone, Copy, Default)]
enum Listed {
    /// Models, and files of scans by epoch
    #[default]
    Files,
    /// Scanner positions
    Stations,
}

/// Sizes are those that are stored, compressed.
const FILES: &str = "
SELECT 'model'::text, NULL::int4, o.source, pg_catalog.count(*), pg_catalog.count(o.solid), NULL::int8, NULL::int8,
       coalesce(pg_catalog.sum(pg_catalog.pg_column_size(o.solid)), 0::int8)::float8
FROM   @building_object o
GROUP  BY o.source
UNION ALL
SELECT 'scans'::text, t.epoch, t.source, NULL::int8, NULL::int8, pg_catalog.count(DISTINCT t.id), pg_catalog.count(s.patch),
       coalesce(pg_catalog.sum(pg_catalog.pg_column_size(s.patch)), 0::int8)::float8
FROM   @station t LEFT JOIN @scan s ON s.station_id = t.id
GROUP  BY t.epoch, t.source
ORDER  BY 1, 2, 3";

const STATIONS: &str = "
SELECT t.id, t.epoch, t.name, t.source, t.sensor, t.origin_source, t.origin_sd, p.patches
FROM   @station t
LEFT   JOIN (SELECT station_id, pg_catalog.count(*) AS patches FROM @scan GROUP BY station_id) p ON p.station_id = t.id
ORDER  BY t.epoch, t.source, t.id";

pub fn run(args: &ListArgs) -> Result<()> {
    let mut db = args.database.connect()?;
    tables::check_loaded(&mut db)?;
    match args.what {
        Listed::Files => {
            let rows = db.client.query(&db.names.sql(FILES), &[]).map_err(explain)?;
            let columns = ["kind", "epoch", "file", "objects", "with_solid", "stations", "patches", "size_mb"];
            print(args, &columns, &rows, file, ["file", "files"])
        }
        Listed::Stations => {
            let unit = LengthUnit::or_default(args.units, args.format);
            let rows = db.client.query(&db.names.sql(STATIONS), &[]).map_err(explain)?;
            let sd = unit.column("origin_sd");
            let columns = ["id", "epoch", "name", "file", "sensor", "origin_source", &sd, "patches"];
            print(args, &columns, &rows, |row| station(row, unit), ["station", "stations"])
        }
    }
}

fn print(
    args: &ListArgs,
    columns: &[&str],
    rows: &[Row],
    cells: impl Fn(&Row) -> Vec<Value>,
    [one, many]: [&str; 2],
) -> Result<()> {
    let mut table = Table::new(columns);
    rows.iter().for_each(|row| table.push(cells(row)));
    table.print_of(args.format, one, many)
}

fn text(row: &Row, column: usize) -> Value {
    row.get::<_, Option<String>>(column).map_or(Value::Null, Value::from)
}

fn number(row: &Row, column: usize) -> Value {
    row.get::<_, Option<i64>>(column).map_or(Value::Null, Value::from)
}

fn epoch(row: &Row) -> Value {
    row.get::<_, Option<i32>>(1).map_or(Value::Null, Value::from)
}

fn file(row: &Row) -> Vec<Value> {
    let mut out = vec![text(row, 0), epoch(row), text(row, 2)];
    out.extend((3..7).map(|i| number(row, i)));
    out.push(rounded(row.get::<_, Option<f64>>(7).map(|bytes| bytes / 1e6), 1));
    out
}

fn station(row: &Row, unit: LengthUnit) -> Vec<Value> {
    let mut out = vec![number(row, 0), epoch(row)];
    out.extend((2..6).map(|i| text(row, i)));
    out.extend([unit.value(row.get(6)), number(row, 7)]);
    out
}
