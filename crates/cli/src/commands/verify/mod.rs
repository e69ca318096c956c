//! `asbuilt verify`: a verdict on every object.
//!
//! * [`question`]: what is asked, and how the scans were surveyed;
//! * [`query`]: all of them, by the server;
//! * [`selection`]: which are printed;
//! * [`sum`]: in which order, and what they add up to;
//! * [`shift`], [`columns`]: how.

mod columns;
pub mod query;
pub mod question;
pub mod selection;
pub mod shift;
mod sum;

use anyhow::Result;

use crate::database::connect::DatabaseArgs;
use crate::database::origins::StationOrigins;
use crate::database::tables;
use crate::frames::check;
use crate::output::{Format, LengthUnit, Table};
use columns::{Layout, cells, columns};
use query::judged;
use question::QuestionArgs;
use selection::SelectionArgs;
use sum::{SortKey, VerdictName, sort, sum};

/// Exit status where something of --fail-on was found; 1 is an error, 2 wrong usage.
const FOUND: i32 = 3;

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Verdicts: confirmed (built, within the tolerance), deviating (built, but displaced beyond it), absent (its space was
seen empty), unobserved (too little was seen to say), conflicting (stations contradict each other).

coverage is seen/all samples; confirmed + refuted + open = 1 over the seen ones; deviation is the median along its
outward normal of the largest face that is certainly off, else of the largest, and shift the rigid offset (x, y, z) with its standard deviation, in
the unit that the columns name: millimetres in tables, metres in CSV and JSON, or --units; '-' marks an axis that the seen faces do not determine (JSON: null; CSV: an empty cell, a column an axis).

An object is looked for up to --reach from its drawn place (a plane face, as large as its own, that no other object
explains): deviating by that distance. Farther off it is absent, if its place was seen empty.

Stations whose scanner's place nobody knows (merged clouds) never prove that a place is empty; how many they are is said on
standard error, and asbuilt load --origins FILE tells their places.

reason says why an object is unobserved: hidden_by_object (hidden_by: which), hidden_by_other (something that nobody
drew), too_few beams, too_steep, not_looked_at, no_return, or shared_face (what was met may as well be another object's,
drawn at the same place).

CSV is guarded against spreadsheets: a text that begins with = + - @, a tab or a carriage return gets an apostrophe before
it, numbers never; --format csv-exact writes everything as it is.

Exit status: 0 done, 1 error, 2 wrong usage, 3 something of --fail-on found among what is printed.

Examples:
  asbuilt verify --epoch 2 --sort verdict
  asbuilt verify --epoch 2 --class 'IfcWall*' --storey EG --units m
  asbuilt verify --epoch 2 --where \"o.properties ->> 'Phase' = '2'\" --format csv > phase2.csv
  asbuilt verify --epoch 2 --exclude 17,18 --fail-on deviating,absent")]
pub struct VerifyArgs {
    #[command(flatten)]
    question: QuestionArgs,
    /// Exit with status 3 where an object that is printed has one of these verdicts, separated by commas
    #[arg(long, value_name = "VERDICT,…", value_enum, value_delimiter = ',')]
    fail_on: Vec<VerdictName>,
    /// What to print first
    #[arg(long, value_enum, default_value_t, value_name = "KEY")]
    sort: SortKey,
    /// Unit of lengths [default: mm in tables, m in CSV and JSON]
    #[arg(long, value_enum, value_name = "UNIT")]
    units: Option<LengthUnit>,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    selection: SelectionArgs,
    #[command(flatten)]
    database: DatabaseArgs,
}

pub fn run(args: &VerifyArgs) -> Result<()> {
    let mut db = args.database.connect()?;
    tables::check_loaded(&mut db)?;
    tables::check_epoch(&mut db, args.question.epoch)?;
    let asked_for = args.selection.ids(&mut db)?;
    check::warn(&mut db, args.question.epoch)?;
    let mut objects = judged(&args.question, &mut db)?;
    let all = objects.len();
    objects.retain(|o| asked_for.contains(&o.id));
    sort(&mut objects, args.sort);
    let layout = Layout { format: args.format, unit: LengthUnit::or_default(args.units, args.format) };
    let mut table = Table::new(&columns(layout));
    objects.iter().for_each(|o| table.push(cells(o, layout)));
    StationOrigins::warn(&mut db, args.question.epoch)?;
    table.print_with(args.format, &sum(objects.iter().map(|o| o.verdict.as_str()), all))?;
    let is_found = args.fail_on.iter().any(|v| objects.iter().any(|o| o.verdict == v.name()));
    if is_found {
        std::process::exit(FOUND);
    }
    Ok(())
}
