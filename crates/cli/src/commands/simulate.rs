//! `asbuilt simulate`: laser scans of a model whose truth is known.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::num::text::numbers;
use asbuilt_simulate::{Changes, Drawn, Scanner, Scene, write_e57};

use crate::output::{count, progress, say, spinner};
use asbuilt_read::ifc::{self, Product};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
STATIONS is a text file with a scanner position a line: x y z, in metres; # starts a comment.
CHANGES is JSON and says what was built otherwise than drawn:
  {\"objects\": {\"W-mid\": {\"shift\": [0.012, 0, 0]},
               \"C2\":    {\"missing\": true},
               \"W-east\": {\"tilt_deg\": 0.5, \"tilt_axis\": [0, 1, 0]},
               \"S-1\":    {\"bow\": [0, 0, -0.02]}},
   \"added\": [{\"name\": \"pallet\", \"min\": [9, 6.5, 0], \"max\": [10.2, 7.3, 0.4]},
             {\"name\": \"pipe\", \"foot\": [1, 1, 0], \"radius\": 0.1, \"height\": 3}]}

Example:
  asbuilt simulate model.ifc --stations stations.txt --step-mrad 3 --built changes.json --out epoch2.e57")]
pub struct SimulateArgs {
    /// IFC model
    model: PathBuf,
    /// File of scanner positions
    #[arg(long, value_name = "FILE")]
    stations: PathBuf,
    /// Where to write the scans (E57)
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// File of what was built otherwise
    #[arg(long, value_name = "CHANGES.json")]
    built: Option<PathBuf>,
    /// Angle between neighbouring beams, milliradians
    #[arg(long, default_value_t = 3.0, value_name = "MRAD")]
    step_mrad: f64,
    /// Standard deviation of a range, metres
    #[arg(long, default_value_t = 0.001, value_name = "M")]
    sigma_range: f64,
    /// Standard deviation of an angle, radians
    #[arg(long, default_value_t = 4e-5, value_name = "RAD")]
    sigma_angle: f64,
    /// Standard deviation of a station's registered position, metres per axis
    #[arg(long, default_value_t = 0.0007, value_name = "M")]
    sigma_registration: f64,
    /// Share of mixed pixels
    #[arg(long, default_value_t = 0.002, value_name = "SHARE")]
    mixed_pixels: f64,
    /// Farthest return, metres
    #[arg(long, default_value_t = 60.0, value_name = "M")]
    max_range: f64,
    /// Seed; the same seed gives the same scans
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

pub fn run(args: &SimulateArgs) -> Result<()> {
    check_output(args)?;
    let scanner = scanner(args)?;
    let stations = read_stations(&args.stations)?;
    check_size(&scanner, stations.len())?;
    let changes = args.built.as_deref().map_or_else(|| Ok(Changes::default()), Changes::read)?;
    let bar = spinner(&format!("meshing {}", args.model.display()));
    let model = ifc::read(&args.model, ifc::Limits::default())?;
    bar.finish_and_clear();
    let drawn = model.products.iter().map(drawn).collect::<Result<Vec<_>>>()?;
    let scene = Scene::new(&changes.build(&drawn)?);
    let bar = progress("scanning", "stations");
    bar.set_length(stations.len() as u64);
    let mut scans = Vec::new();
    for (i, station) in stations.iter().enumerate() {
        scans.push(scanner.scan(&scene, station, args.seed.wrapping_add(1_000_003 * i as u64)));
        bar.inc(1);
    }
    bar.finish_and_clear();
    write_e57(&args.out, &scans)?;
    let shots = || scans.iter().flat_map(|s| &s.shots);
    say!(
        "{}: {} stations, {} beams, {} without return",
        args.out.display(),
        scans.len(),
        count(shots().count() as u64),
        count(shots().filter(|s| !s.returned).count() as u64)
    );
    Ok(())
}

fn drawn(p: &Product) -> Result<Drawn<'_>> {
    Ok(Drawn { name: &p.name, global_id: &p.global_id, solid: p.solid()? })
}

/// Checks that the output is E57 and not one of the inputs.
fn check_output(args: &SimulateArgs) -> Result<()> {
    if !args.out.extension().is_some_and(|e| e.eq_ignore_ascii_case("e57")) {
        bail!("--out {}: scans are written as E57; give a name that ends in .e57", args.out.display());
    }
    let same = |input: &Path| input.canonicalize().ok().is_some_and(|i| args.out.canonicalize().is_ok_and(|o| o == i));
    let inputs = [Some(&args.model), Some(&args.stations), args.built.as_ref()];
    match inputs.into_iter().flatten().find(|input| same(input)) {
        Some(input) => bail!("--out {} would overwrite the input {}", args.out.display(), input.display()),
        None => Ok(()),
    }
}

/// Most beams of one call: they are held in memory, and so is the file.
const MAX_BEAMS: f64 = 200e6;

fn check_size(scanner: &Scanner, stations: usize) -> Result<()> {
    let (columns, rows) = scanner.grid();
    let beams = f64::from(columns) * f64::from(rows) * stations as f64;
    if beams > MAX_BEAMS {
        bail!(
            "--step-mrad {} from {stations} stations makes {} beams, more than {} at once; take a larger step, or \
             simulate the stations one by one",
            scanner.step * 1e3,
            count(beams as u64),
            count(MAX_BEAMS as u64)
        );
    }
    Ok(())
}

fn scanner(args: &SimulateArgs) -> Result<Scanner> {
    for (name, value, max) in [
        ("--sigma-range", args.sigma_range, 1.0),
        ("--sigma-angle", args.sigma_angle, 0.1),
        ("--sigma-registration", args.sigma_registration, 10.0),
        ("--mixed-pixels", args.mixed_pixels, 1.0),
        ("--max-range", args.max_range, 1e5),
    ] {
        if !(0.0..=max).contains(&value) {
            bail!("{name} {value} must be between 0 and {max}");
        }
    }
    if !(0.05..=100.0).contains(&args.step_mrad) {
        bail!("--step-mrad {} must be between 0.05 and 100", args.step_mrad);
    }
    Ok(Scanner {
        step: args.step_mrad * 1e-3,
        sigma_range: args.sigma_range,
        sigma_range_per_m: 1e-5,
        sigma_zero: 0.0,
        sigma_angle: args.sigma_angle,
        sigma_registration: args.sigma_registration,
        mixed_pixels: args.mixed_pixels,
        max_range: args.max_range,
        min_elevation: (-60f64).to_radians(),
    })
}

/// Scanner positions, one per line.
pub fn read_stations(path: &Path) -> Result<Vec<Vec3>> {
    let text = std::fs::read_to_string(path).with_context(|| format!("{}: cannot read it", path.display()))?;
    let mut out = Vec::new();
    for (i, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let line = line.split('#').next().unwrap_or("").trim();
        if !line.is_empty() {
            let Some(p) = numbers::<3>(line) else {
                bail!("{}, line {}: a position x y z expected, found \"{line}\"", path.display(), i + 1);
            };
            out.push(Vec3::from(p));
        }
    }
    if out.is_empty() {
        bail!("{}: it names no scanner position", path.display());
    }
    Ok(out)
}
