//! `asbuilt load`: models and scans into the tables of the tour, one file a transaction.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, anyhow, bail};
use asbuilt_core::NEVER;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Aabb, Closedness, Vec3};
use asbuilt_core::num::text::numbers;
use postgres::{Client, Transaction};
use serde_json::{Map, Value};

use crate::database::connect::{DatabaseArgs, explain};
use crate::database::copy::{BinaryCopy, jsonb};
use crate::database::tables;
use crate::output::{count, progress, say, spinner};
use crate::read::{self, Kind, RawScan, ReadOptions, ifc};
use crate::stations::{self, Packed};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Models: IFC (STEP). Every product with a body becomes a row of building_object; what cannot be meshed is named.
Scans: E57, LAS, LAZ, PLY, PTX, PCD, XYZ, PTS. Every scanner position becomes a row of station, its beams patches in
scan. E57 and PTX tell the scanner's position; for the others give --origin, or their points say where something is,
but never that a place is empty. Loading a file again replaces what it had loaded. A file that fails leaves nothing behind.

Examples:
  asbuilt load model.ifc --loa LOA20
  asbuilt load scans/*.e57 --epoch 2
  asbuilt load tripod.laz --epoch 2 --origin 12.3,4.5,1.6")]
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
    /// Keep the intensity of every return (E57, LAS, LAZ); 1 to 2 bytes a beam more
    #[arg(long)]
    intensity: bool,
    /// Keep the colour of every return (E57, LAS, LAZ); up to 3 bytes a beam more
    #[arg(long, alias = "color")]
    colour: bool,
    /// Level of accuracy of objects whose property LevelOfAccuracy does not say
    #[arg(long, default_value = "LOA30", value_parser = parse_loa)]
    loa: Loa,
    /// Give up meshing a model after this many seconds
    #[arg(long, default_value_t = 300, value_name = "S")]
    mesh_timeout: u64,
    #[command(flatten)]
    database: DatabaseArgs,
}

fn parse_origin(text: &str) -> std::result::Result<Vec3, String> {
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
    let mut client = args.database.connect()?;
    tables::make(&mut client)?;
    for (i, (file, kind)) in args.files.iter().zip(kinds).enumerate() {
        let start = Instant::now();
        if let Err(error) = load_file(args, file, kind, &mut client) {
            let rest: Vec<String> = args.files[i + 1..].iter().map(|f| f.display().to_string()).collect();
            return Err(if rest.is_empty() { error } else { anyhow!("{error:#}\nnot loaded: {}", rest.join(", ")) });
        }
        say!("  in {:.1} s", start.elapsed().as_secs_f64());
    }
    tables::analyse(&mut client)?;
    warn_apart(&mut client, args.epoch)
}

fn kind_of(file: &Path) -> Result<Kind> {
    if file.is_dir() {
        bail!("{}: it is a folder; name the files in it", file.display());
    }
    let kind = read::kind(file)?;
    if file.exists() { Ok(kind) } else { bail!("{}: no such file", file.display()) }
}

/// One file, one transaction: dropped without commit, it leaves nothing.
fn load_file(args: &LoadArgs, file: &Path, kind: Kind, client: &mut Client) -> Result<()> {
    let mut tx = client.transaction().map_err(explain)?;
    tables::lock_source(&mut tx, &source(file), if kind == Kind::Scan { args.epoch } else { 0 })?;
    match kind {
        Kind::Model => load_model(args, file, &mut tx)?,
        Kind::Scan => load_scans(args, file, &mut tx)?,
    }
    tx.commit().map_err(explain).with_context(|| format!("{}: nothing of it was loaded", file.display()))
}

/// What the rows of a file are known by.
fn source(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn load_model(args: &LoadArgs, file: &Path, tx: &mut Transaction) -> Result<()> {
    let bar = spinner(&format!("meshing {}", file.display()));
    let model = ifc::read(file, Duration::from_secs(args.mesh_timeout))?;
    bar.finish_and_clear();
    let source = source(file);
    let replaced = tx.execute("DELETE FROM building_object WHERE source = $1", &[&source]).map_err(explain)?;
    if replaced > 0 {
        say!("{source}: replaces {replaced} objects loaded before from a file of that name");
    }
    let columns = ["global_id", "ifc_class", "name", "storey", "loa", "solid", "properties", "source"];
    let mut copy = BinaryCopy::start(tx, "building_object", &columns)?;
    let (mut bounds, mut open, mut seen) = (Aabb::EMPTY, Vec::new(), std::collections::HashSet::new());
    let (mut meshed, mut twice) = (0, 0);
    for p in &model.products {
        if !seen.insert(&p.global_id) {
            twice += 1;
            continue;
        }
        let loa = level(p, args.loa)?;
        let solid = p.solid().with_context(|| format!("{} {}", p.ifc_class, p.name))?;
        if let Some(s) = &solid {
            meshed += 1;
            bounds = bounds.union(&s.bounds());
            if s.closedness() == Closedness::Open {
                open.push(format!("{} {}", p.ifc_class, p.name));
            }
        }
        let solid = solid.map(|s| s.to_bytes(NEVER)).transpose()?;
        let text = |s: &str| s.replace('\0', "").into_bytes();
        copy.row(&[
            Some(&text(&p.global_id)),
            Some(&text(&p.ifc_class)),
            Some(&text(&p.name)),
            p.storey.as_deref().map(text).as_deref(),
            Some(loa.name().as_bytes()),
            solid.as_deref(),
            Some(&jsonb(&properties(p))),
            Some(&text(&source)),
        ])?;
    }
    copy.finish()?;
    report_model(&source, &model, meshed, twice, &open, &bounds);
    Ok(())
}

/// Its own level of accuracy, or the given one. A property that names no level is said, not guessed.
fn level(p: &ifc::Product, default: Loa) -> Result<Loa> {
    match &p.level_of_accuracy {
        None => Ok(default),
        Some(text) => Ok(Loa::parse(text).unwrap_or_else(|_| {
            say!("warning: {} has LevelOfAccuracy \"{text}\", which is none; {} taken", p.name, default.name());
            default
        })),
    }
}

fn properties(p: &ifc::Product) -> Value {
    let clean = |s: &str| Value::from(s.replace('\0', ""));
    let mut map: Map<String, Value> = p.properties.iter().map(|(k, v)| (k.replace('\0', ""), clean(v))).collect();
    if let Some(whole) = &p.part_of {
        map.insert("part_of".into(), clean(whole));
    }
    if let Some(note) = &p.note {
        map.insert("geometry_note".into(), clean(note));
    }
    Value::Object(map)
}

fn report_model(source: &str, model: &ifc::Model, meshed: usize, twice: usize, open: &[String], bounds: &Aabb) {
    let parts = model.products.iter().filter(|p| p.part_of.is_some()).count();
    say!(
        "{source}: {} products read, {meshed} meshed, {} open surfaces, {parts} parts of others, {} missing",
        model.products.len(),
        open.len(),
        model.unmeshed.len()
    );
    say!("  box {}", shown(bounds));
    list("open surface (area and verdict, no volume)", open);
    let missing: Vec<String> = model.unmeshed.iter().map(|(name, why)| format!("{name}: {why}")).collect();
    list("missing", &missing);
    let left_out: Vec<String> = model.left_out.iter().map(|(class, n)| format!("{n} {class}")).collect();
    if !left_out.is_empty() {
        say!("  no building objects, left out: {}", left_out.join(", "));
    }
    if let Some(worst) = model.rounded.iter().map(|r| r.1).reduce(f64::max) {
        say!(
            "  warning: {} products lie so far from the file's zero that their geometry is rounded, to {:.0} mm at the \
             worst ({}); move the model near its origin for finer levels of accuracy",
            model.rounded.len(),
            worst * 1e3,
            model.rounded[0].0
        );
    }
    if twice > 0 {
        say!("  warning: {twice} products repeat another's GlobalId; the first of each was kept");
    }
    model.warnings.iter().for_each(|w| say!("  warning: {w}"));
}

/// A box to the millimetre.
fn shown(b: &Aabb) -> String {
    let mm = |c: [f64; 3]| c.map(|v| (v * 1e3).round() / 1e3);
    Aabb { min: mm(b.min), max: mm(b.max) }.to_text()
}

/// Names all missing, but of a long list only the beginning unless they are few.
fn list(what: &str, names: &[String]) {
    const SHOWN: usize = 40;
    names.iter().take(SHOWN).for_each(|n| say!("  {what}: {n}"));
    if names.len() > SHOWN {
        say!("  … and {} more", names.len() - SHOWN);
    }
}

fn load_scans(args: &LoadArgs, file: &Path, tx: &mut Transaction) -> Result<()> {
    let source = source(file);
    let delete = "DELETE FROM station WHERE source = $1 AND epoch = $2";
    let replaced = tx.execute(delete, &[&source, &args.epoch]).map_err(explain)?;
    if replaced > 0 {
        say!("{source}: replaces {replaced} stations of epoch {} loaded before from a file of that name", args.epoch);
    }
    let bar = progress(&format!("reading {source}"), "points");
    let mut total = Total::default();
    let options = ReadOptions { origin: args.origin, intensity: args.intensity, colour: args.colour };
    read::read_scans(file, &options, &bar, &mut |mut scan| {
        if scan.content.is_empty() {
            say!("  {}: empty, passed over", scan.name);
            return Ok(());
        }
        let packed = store(args, &source, &mut scan, tx)?;
        if packed.beams == packed.no_returns {
            say!("  warning: {}: no return of it is left", scan.name);
        }
        if let (Some(_), Some(given)) = (scan.world_from_scan, args.origin)
            && scan.anchor != given
        {
            say!("  {}: the file tells the scanner's position, which goes before --origin", scan.name);
        }
        total.add(&scan, &packed);
        Ok(())
    })?;
    bar.finish_and_clear();
    if total.returns() == 0 {
        let why = match total.too_near {
            0 => "no beam of it returned".into(),
            n => format!("its {n} returns are all nearer than --min-range {} m", args.min_range),
        };
        bail!("{}: nothing to load: {why}", file.display());
    }
    say!(
        "{source}: epoch {}, {} stations, {} beams, {} without return, {} too near (< {} m) dropped",
        args.epoch,
        total.stations,
        count(total.beams),
        count(total.no_returns),
        count(total.too_near),
        args.min_range
    );
    say!("  box {}", shown(&total.points));
    if total.unusable > 0 {
        say!("  warning: {} points are not finite or impossibly far, and were dropped", total.unusable);
    }
    if total.without_origin > 0 {
        say!(
            "  warning: {} of them without scanner position: their points say where something is, but never that a place is \
             empty; give --origin x,y,z if they were scanned from one place",
            total.without_origin
        );
    }
    Ok(())
}

#[derive(Debug)]
struct Total {
    stations: u64,
    without_origin: u64,
    beams: u64,
    no_returns: u64,
    too_near: u64,
    unusable: u64,
    points: Aabb,
}

impl Default for Total {
    fn default() -> Self {
        Self { stations: 0, without_origin: 0, beams: 0, no_returns: 0, too_near: 0, unusable: 0, points: Aabb::EMPTY }
    }
}

impl Total {
    fn returns(&self) -> u64 {
        self.beams - self.no_returns
    }

    fn add(&mut self, scan: &RawScan, packed: &Packed) {
        self.stations += 1;
        self.without_origin += u64::from(scan.world_from_scan.is_none());
        self.beams += packed.beams;
        self.no_returns += packed.no_returns;
        self.too_near += packed.too_near;
        self.unusable += scan.unusable;
        self.points = self.points.union(&packed.points);
    }
}

fn store(args: &LoadArgs, source: &str, scan: &mut RawScan, tx: &mut Transaction) -> Result<Packed> {
    let translation = scan.world_from_scan.map(|_| scan.anchor.as_slice().to_vec());
    let rotation = scan.world_from_scan.map(|q| q.to_vec());
    let insert = "INSERT INTO station (epoch, name, pose, sensor, source)
        VALUES ($1, $2, ab_pose($3::float8[], $4::float8[]), $5, $6) RETURNING id";
    let name = scan.name.replace('\0', "");
    let row =
        tx.query_one(insert, &[&args.epoch, &name, &translation, &rotation, &scan.sensor, &source]).map_err(explain)?;
    let station: i64 = row.get(0);
    let mut copy = BinaryCopy::start(tx, "scan", &["station_id", "epoch", "patch"])?;
    let packed = stations::pack(scan, station, args.min_range, |patch| {
        copy.row(&[Some(&station.to_be_bytes()), Some(&args.epoch.to_be_bytes()), Some(patch)])
    })?;
    copy.finish()?;
    Ok(packed)
}

/// Models and scans in different frames are a common mistake, and all objects would come out unobserved.
fn warn_apart(client: &mut Client, epoch: i32) -> Result<()> {
    let question = "SELECT EXISTS (SELECT FROM building_object), EXISTS (SELECT FROM scan WHERE epoch = $1),
        EXISTS (SELECT FROM building_object o JOIN scan s ON s.epoch = $1 AND s.patch && o.solid)";
    let row = client.query_one(question, &[&epoch]).map_err(explain)?;
    if row.get::<_, bool>(0) && row.get::<_, bool>(1) && !row.get::<_, bool>(2) {
        say!(
            "warning: no beam of epoch {epoch} comes near any object: are model and scans in the same coordinate system?"
        );
    }
    Ok(())
}
