//! `asbuilt remove`: an epoch, a file or a station and all that hangs on it.

use std::io::{BufRead, IsTerminal, Write};

use anyhow::{Result, bail};
use postgres::Transaction;
use postgres::types::ToSql;

use crate::database::connect::{DatabaseArgs, explain};
use crate::database::names::Names;
use crate::database::tables;
use crate::output::{safe, say};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Removed are rows, not files: what was loaded can be loaded again. asbuilt list shows what there is.

Examples:
  asbuilt remove epoch 2
  asbuilt remove file scan-17.e57 --yes
  asbuilt remove station 4")]
pub struct RemoveArgs {
    /// What to remove
    #[arg(value_enum)]
    what: Removed,
    /// Its number (epoch), name (file, as asbuilt list shows it) or id (station)
    #[arg(allow_hyphen_values = true)]
    name: String,
    /// Do not ask
    #[arg(long, short)]
    yes: bool,
    #[command(flatten)]
    database: DatabaseArgs,
}

/// What can be removed.
#[derive(clap::ValueEnum, Debug, Clone, Copy, PartialEq, Eq)]
enum Removed {
    /// All scans of an epoch
    Epoch,
    /// The objects or the stations of a file, of all epochs
    File,
    /// One scanner position
    Station,
}

impl Removed {
    fn name(self) -> &'static str {
        ["epoch", "file", "station"][self as usize]
    }

    /// Which stations.
    fn of_stations(self) -> &'static str {
        match self {
            Self::Epoch => "epoch::text = $1::text",
            Self::File => "source = $1::text",
            Self::Station => "id::text = $1::text",
        }
    }
}

pub fn run(args: &RemoveArgs) -> Result<()> {
    let mut db = args.database.connect()?;
    tables::check_loaded(&mut db)?;
    let names = db.names.clone();
    let mut tx = db.client.transaction().map_err(explain)?;
    // What is counted is what goes.
    tx.batch_execute(&names.sql("LOCK TABLE @building_object, @station, @scan IN SHARE ROW EXCLUSIVE MODE"))
        .map_err(explain)?;
    let counted = Counted::of(args, &names, &mut tx)?;
    if counted.is_nothing() {
        bail!("there is no {} {}; asbuilt list shows what is loaded", args.what.name(), args.name);
    }
    if !args.yes && !is_confirmed(&format!("remove {} {} ({})?", args.what.name(), args.name, counted.text()))? {
        bail!("nothing was removed");
    }
    counted.remove(args, &names, &mut tx)?;
    tx.commit().map_err(explain)?;
    say!("{} {}: removed {}", args.what.name(), args.name, counted.text());
    Ok(())
}

/// What hangs on it.
struct Counted {
    objects: i64,
    stations: i64,
    patches: i64,
}

impl Counted {
    fn of(args: &RemoveArgs, names: &Names, tx: &mut Transaction) -> Result<Self> {
        let which = args.what.of_stations();
        let mut count = |sql: &str| -> Result<i64> {
            let parameters: [&(dyn ToSql + Sync); 1] = [&args.name];
            Ok(tx.query_one(&names.sql(sql), &parameters).map_err(explain)?.get(0))
        };
        Ok(Self {
            objects: match args.what {
                Removed::File => count("SELECT pg_catalog.count(*) FROM @building_object WHERE source = $1::text")?,
                _ => 0,
            },
            stations: count(&format!("SELECT pg_catalog.count(*) FROM @station WHERE {which}"))?,
            patches: count(&format!(
                "SELECT pg_catalog.count(*) FROM @scan WHERE station_id IN (SELECT id FROM @station WHERE {which})"
            ))?,
        })
    }

    fn is_nothing(&self) -> bool {
        self.objects + self.stations == 0
    }

    fn text(&self) -> String {
        let Self { objects, stations, patches } = self;
        let named = |n: &i64, one: &str| (*n > 0).then(|| format!("{n} {one}{}", if *n == 1 { "" } else { "s" }));
        let mut parts: Vec<String> =
            [named(objects, "object"), named(stations, "station")].into_iter().flatten().collect();
        parts.extend((*patches > 0).then(|| format!("{patches} {}", if *patches == 1 { "patch" } else { "patches" })));
        parts.join(", ")
    }

    fn remove(&self, args: &RemoveArgs, names: &Names, tx: &mut Transaction) -> Result<()> {
        let which = args.what.of_stations();
        let mut statements = vec![format!("DELETE FROM @station WHERE {which}")];
        if self.objects > 0 {
            statements.push("DELETE FROM @building_object WHERE source = $1::text".into());
        }
        for statement in statements {
            tx.execute(&names.sql(&statement), &[&args.name]).map_err(explain)?;
        }
        Ok(())
    }
}

/// Asks; without a terminal there is nobody to ask.
fn is_confirmed(question: &str) -> Result<bool> {
    let stdin = std::io::stdin();
    if !stdin.is_terminal() {
        bail!("{question} give --yes: there is no terminal to ask at");
    }
    write!(std::io::stderr(), "{} [y/N] ", safe(question))?;
    let mut answer = String::new();
    stdin.lock().read_line(&mut answer)?;
    Ok(matches!(answer.trim(), "y" | "Y" | "yes"))
}
