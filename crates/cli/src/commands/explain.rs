//! `asbuilt explain`: why the verdict on an object is what it is.

use std::io::Write;

use anyhow::{Result, bail};
use postgres::Row;

use super::verify::query::explanations;
use super::verify::question::QuestionArgs;
use super::verify::selection::ids_of;
use crate::database::connect::DatabaseArgs;
use crate::database::origins::StationOrigins;
use crate::database::tables;
use crate::output::{safe, to_stdout};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
The objects are verified among all others, as by asbuilt verify with the same options, and each is explained: what was seen, what
that says, which threshold decided, why no finer class holds.

Examples:
  asbuilt explain 17 --epoch 2
  asbuilt explain 2O2Fr$t4X7Zf8NOew3FLMr --loa LOA20")]
pub struct ExplainArgs {
    /// Ids or GlobalIds of objects
    #[arg(required = true, value_name = "ID")]
    objects: Vec<String>,
    #[command(flatten)]
    question: QuestionArgs,
    #[command(flatten)]
    database: DatabaseArgs,
}

pub fn run(args: &ExplainArgs) -> Result<()> {
    let mut db = args.database.connect()?;
    tables::check_loaded(&mut db)?;
    tables::check_epoch(&mut db, args.question.epoch)?;
    let ids = ids_of(&mut db, &args.objects)?;
    let rows = explanations(&args.question, &mut db, &ids)?;
    StationOrigins::warn(&mut db, args.question.epoch)?;
    to_stdout(|out| {
        for (i, row) in rows.iter().enumerate() {
            if i > 0 {
                writeln!(out)?;
            }
            print(out, row)?;
        }
        Ok(())
    })?;
    if rows.is_empty() {
        bail!("nothing was verified");
    }
    Ok(())
}

fn print(out: &mut impl Write, row: &Row) -> Result<()> {
    writeln!(out, "{}", safe(&title(row)))?;
    match row.get::<_, Option<&str>>(5) {
        Some(text) => text.lines().try_for_each(|line| writeln!(out, "  {}", safe(line)))?,
        None => writeln!(out, "  It has no geometry that could be meshed: nothing is known of it.")?,
    }
    Ok(())
}

fn title(row: &Row) -> String {
    let storey = row.get::<_, Option<&str>>(4).map_or(String::new(), |s| format!(", {s}"));
    let (id, name, global_id, class): (i64, &str, &str, &str) = (row.get(0), row.get(1), row.get(2), row.get(3));
    format!("{name} ({class}{storey}; id {id}, {global_id})")
}
