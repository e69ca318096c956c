//! `asbuilt load`: models and scans into the tables of the tour, one file a transaction.

mod model;
mod scans;

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, Result, anyhow, bail};
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Aabb, Vec3};
use asbuilt_core::num::text::numbers;

use crate::database::connect::{Database, DatabaseArgs, explain};
use crate::database::{layout, tables};
use crate::memory;
use crate::output::{Noted, notes, say};
use crate::read::{self, Columns, IdentityPose, Kind, Unit};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Models: IFC (STEP). Every product with a body becomes a row of building_object; what cannot be meshed is named.
Scans: E57, LAS, LAZ, PLY, PTX, PCD, XYZ, PTS, TXT, ASC, CSV. Every scanner position becomes a row of station, its beams patches in
scan. E57, PTX and most PCD tell the scanner's position; for the others give --origin, or their points say where something is,
but never that a place is empty. Loading a file again replaces what it had loaded. A file that fails leaves nothing behind.
Files are read by a process of their own, which ends with an error where it takes more than --max-memory.

Examples:
  asbuilt load model.ifc --loa LOA20
  asbuilt load scans/*.e57 --epoch 2
  asbuilt load tripod.laz --epoch 2 --origin 12.3,4.5,1.6
  asbuilt load survey.txt --columns n,x,y,z --file-unit ft")]
pub struct LoadArgs {
    /// IFC models and scan files
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Epoch of the scans
    #[arg(long, default_value_t = 1, value_name = "N", allow_hyphen_values = true)]
    epoch: i32,
    /// The scanner's position, for files that do not tell it
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_origin)]
    origin: Option<Vec3>,
    /// Drop returns nearer than this (the scanner's own platform), metres
    #[arg(long, default_value_t = 0.3, value_name = "M", allow_hyphen_values = true)]
    min_range: f64,
    /// Keep the intensity of every return (E57, LAS, LAZ, texts with a column i); 1 to 2 bytes a beam more
    #[arg(long)]
    intensity: bool,
    /// Keep the colour of every return (E57, LAS, LAZ, texts with columns r, g, b); up to 3 bytes a beam more
    #[arg(long, alias = "color")]
    colour: bool,
    /// What the columns of a text of points hold, in their order: n (number), x, y, z, i (intensity), r, g, b, - (passed over)
    #[arg(long, value_name = "n,x,y,z,…", allow_hyphen_values = true)]
    columns: Option<Columns>,
    /// A comma within a number of a text is its decimal mark, where the numbers themselves do not tell
    #[arg(long)]
    decimal_comma: bool,
    /// What the numbers of a file count in that does not tell it itself
    #[arg(long, value_name = "UNIT")]
    file_unit: Option<Unit>,
    /// Keep the points of LAS and LAZ that are classified as noise (classes 7 and 18)
    #[arg(long)]
    keep_noise: bool,
    /// What to make of a scanner at zero without rotation, as merged clouds have it
    #[arg(long, value_enum, default_value_t)]
    identity_pose: IdentityPose,
    /// Level of accuracy of objects whose property LevelOfAccuracy does not say
    #[arg(long, default_value = "LOA30", value_parser = parse_loa)]
    loa: Loa,
    /// Give up meshing a model after this many seconds
    #[arg(long, default_value_t = 300, value_name = "S")]
    mesh_timeout: u64,
    /// Give up meshing a single product after this many seconds; the others are loaded
    #[arg(long, default_value_t = 20, value_name = "S", value_parser = clap::value_parser!(u64).range(1..))]
    product_timeout: u64,
    /// Most memory that meshing may take for a single product; the others are loaded
    #[arg(long, default_value = "2GB", value_name = "SIZE", value_parser = memory::parse)]
    product_memory: u64,
    /// Most memory that reading a file may take, e.g. 4GB [default: three quarters of the machine's]
    #[arg(long, value_name = "SIZE", value_parser = memory::parse)]
    max_memory: Option<u64>,
    #[command(flatten)]
    database: DatabaseArgs,
}

impl LoadArgs {
    fn max_memory(&self) -> u64 {
        self.max_memory.unwrap_or_else(memory::budget)
    }
}

pub fn parse_origin(text: &str) -> std::result::Result<Vec3, String> {
    numbers::<3>(text).map(Vec3::from).ok_or_else(|| format!("\"{text}\" is not three numbers x,y,z"))
}

pub fn parse_loa(text: &str) -> std::result::Result<Loa, String> {
    Loa::parse(text).map_err(|e| e.to_string())
}

pub fn run(args: &LoadArgs) -> Result<()> {
    if !(args.min_range >= 0.0 && args.min_range.is_finite()) {
        bail!("--min-range {} must be 0 or more", args.min_range);
    }
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
    warn_apart(&mut db, args.epoch)
}

fn kind_of(file: &Path) -> Result<Kind> {
    if file.is_dir() {
        bail!("{}: it is a folder; name the files in it", file.display());
    }
    if file.exists() { read::kind(file) } else { bail!("{}: no such file", file.display()) }
}

/// One file, one transaction: dropped without commit, it leaves nothing.
fn load_file(args: &LoadArgs, file: &Path, kind: Kind, db: &mut Database) -> Result<()> {
    let mut tx = db.client.transaction().map_err(explain)?;
    tables::lock_source(&mut tx, &source(file), if kind == Kind::Scan { args.epoch } else { 0 })?;
    match kind {
        Kind::Model => model::load(args, file, &db.names, &mut tx)?,
        Kind::Scan => scans::load(args, file, &db.names, &mut tx)?,
    }
    tx.commit().map_err(explain).with_context(|| format!("{}: nothing of it was loaded", file.display()))
}

/// What the rows of a file are known by.
fn source(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// A box to the millimetre.
fn shown(b: &Aabb) -> String {
    let mm = |c: [f64; 3]| c.map(|v| (v * 1e3).round() / 1e3);
    Aabb { min: mm(b.min), max: mm(b.max) }.to_text()
}

/// Models and scans in different frames are a common mistake, and all objects would come out unobserved.
fn warn_apart(db: &mut Database, epoch: i32) -> Result<()> {
    let question = db.sql(
        "SELECT EXISTS (SELECT FROM @building_object), EXISTS (SELECT FROM @scan WHERE epoch = $1::int4),
            EXISTS (SELECT FROM @building_object o
                    JOIN @scan s ON s.epoch = $1::int4 AND s.patch OPERATOR(@ext.&&) o.solid)",
    );
    let row = db.client.query_one(&question, &[&epoch]).map_err(explain)?;
    if row.get::<_, bool>(0) && row.get::<_, bool>(1) && !row.get::<_, bool>(2) {
        say!(
            "warning: no beam of epoch {epoch} comes near any object: are model and scans in the same coordinate system?"
        );
    }
    Ok(())
}
