//! `asbuilt load`: models and scans into the database's tables, one file per transaction.

mod model;
mod scans;

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, Result, anyhow, bail};
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::Aabb;
use postgres::Transaction;

use crate::commands::reading::ReadingArgs;
use crate::database::connect::{Database, DatabaseArgs, explain};
use crate::database::names::Names;
use crate::database::{layout, tables};
use crate::frames::check;
use crate::output::{Noted, notes, say, say_error};
use asbuilt_read::{self as read, FileContents};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Models: IFC (STEP). Every product with a body becomes a row of building_object; what cannot be meshed is named.
Scans: E57, LAS, LAZ, PLY, PTX, PCD, XYZ, PTS, TXT, ASC, CSV. Every scanner position becomes a row of station, its beams patches in
scan. E57, PTX and most PCD tell the scanner's position; for the others give --origin, or --origins for several, or their points
say where something is, but never that a place is empty: nothing of them makes an object absent. Loading a file again replaces what it had loaded. A file that fails leaves nothing behind.
Files are read by a process of their own, which ends with an error where it takes more than --max-memory.

Examples:
  asbuilt load model.ifc --loa LOA20
  asbuilt load scans/*.e57 --epoch 2
  asbuilt load tripod.laz --epoch 2 --origin 12.3,4.5,1.6
  asbuilt load merged.laz --origins stations.csv            (lines such as 3,12.3,4.5,1.6: the points of point source id 3)
  asbuilt load wrong-poses.e57 --origins none
  asbuilt load whole-scan.xyz --origins recover             (tells when the points do not prove the position)
  asbuilt load survey.txt --columns n,x,y,z --file-unit ft
  asbuilt load utm.laz --origin 512350,5412330,103 --offset -512345,-5412345,-101.5  (--origin as the file counts)
  asbuilt load unregistered.e57 --transform icp.txt         (16 numbers, from the scan's frame into the model's)

After loading, and before asbuilt verify, the boxes of objects and patches are compared: a wrong unit, exchanged axes, a
projected frame and a station that is not registered are named, with the option that mends it.")]
pub struct LoadArgs {
    /// IFC models and scan files
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Epoch of the scans
    #[arg(long, default_value_t = 1, value_name = "N", allow_hyphen_values = true)]
    epoch: i32,
    #[command(flatten)]
    reading: ReadingArgs,
    /// Read and check everything, against the database too, and load nothing
    #[arg(long)]
    dry_run: bool,
    /// Level of accuracy of objects whose property LevelOfAccuracy does not say
    #[arg(long, default_value = "LOA30", value_parser = parse_loa)]
    loa: Loa,
    #[command(flatten)]
    database: DatabaseArgs,
}

pub fn parse_loa(text: &str) -> std::result::Result<Loa, String> {
    Loa::parse(text).map_err(|e| e.to_string())
}

pub fn run(args: &LoadArgs) -> Result<()> {
    args.reading.check()?;
    let kinds = args.files.iter().map(|f| kind_of(f)).collect::<Result<Vec<_>>>()?;
    for (i, file) in args.files.iter().enumerate() {
        if let Some(other) = args.files[..i].iter().find(|o| source(o) == source(file)) {
            bail!(
                "{} and {} have the same name, by which loaded files are known; rename one or load it alone",
                other.display(),
                file.display()
            );
        }
    }
    let mut db = args.database.connect()?;
    if args.dry_run {
        return rehearse(args, &kinds, &mut db);
    }
    layout::make(&mut db)?;
    for (i, (file, kind)) in args.files.iter().zip(kinds).enumerate() {
        let start = Instant::now();
        if let Err(error) = load_file(args, file, kind, &mut db) {
            let rest: Vec<String> = args.files[i + 1..].iter().map(|f| f.display().to_string()).collect();
            let mut notes = notes(&error);
            notes.extend((!rest.is_empty()).then(|| format!("not loaded: {}", rest.join(", "))));
            return Err(anyhow!(Noted { message: format!("{error:#}"), notes }));
        }
        say!("  in {:.1} s", start.elapsed().as_secs_f64());
    }
    tables::analyse(&mut db)?;
    check::warn(&mut db, args.epoch)
}

/// Everything but the commit; a file that cannot be loaded does not keep the others from being tried.
fn rehearse(args: &LoadArgs, kinds: &[FileContents], db: &mut Database) -> Result<()> {
    let is_made = layout::is_made(db)?;
    let (mut names, current) = (db.names.clone(), db.current_schema.clone());
    let mut tx = db.client.transaction().map_err(explain)?;
    if !is_made {
        (names, _) = layout::make_within(&mut tx, &names, current.as_deref())?;
        say!("the tables of asbuilt would be made or brought up to date in schema {}", names.home);
    }
    let mut failed = 0;
    for (file, kind) in args.files.iter().zip(kinds) {
        let mut part = tx.transaction().map_err(explain)?;
        if let Err(error) = store(args, file, *kind, &names, &mut part) {
            failed += 1;
            say_error("asbuilt", &error);
        }
    }
    say!("nothing was loaded (--dry-run)");
    if failed > 0 {
        bail!("{failed} of {} files cannot be loaded", args.files.len());
    }
    Ok(())
}

fn kind_of(file: &Path) -> Result<FileContents> {
    if file.is_dir() {
        bail!("{}: it is a folder; name the files in it", file.display());
    }
    if file.exists() { read::kind(file) } else { bail!("{}: no such file", file.display()) }
}

/// One file, one transaction: dropped without commit, it leaves nothing.
fn load_file(args: &LoadArgs, file: &Path, kind: FileContents, db: &mut Database) -> Result<()> {
    let mut tx = db.client.transaction().map_err(explain)?;
    store(args, file, kind, &db.names, &mut tx)?;
    tx.commit().map_err(explain).with_context(|| format!("{}: nothing of it was loaded", file.display()))
}

fn store(args: &LoadArgs, file: &Path, kind: FileContents, names: &Names, tx: &mut Transaction) -> Result<()> {
    tables::lock_source(tx, &source(file), if kind == FileContents::Scan { args.epoch } else { 0 })?;
    match kind {
        FileContents::Model => model::load(args, file, names, tx),
        FileContents::Scan => scans::load(args, file, names, tx),
    }
}

/// How the rows of a file are identified.
fn source(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// A box to the millimetre.
fn shown(b: &Aabb) -> String {
    let mm = |c: [f64; 3]| c.map(|v| (v * 1e3).round() / 1e3);
    Aabb { min: mm(b.min), max: mm(b.max) }.to_text()
}
