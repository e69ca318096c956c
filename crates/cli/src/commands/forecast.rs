//! `asbuilt forecast`: what a planned survey would prove.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use asbuilt_core::NEVER;
use asbuilt_core::evidence::SensorPreset;
use asbuilt_core::geometry::{Aabb, Solid, Vec3};
use asbuilt_core::verify::{Evidence, EvidenceModel, PlannedStation, Summary, VerdictRule};
use rayon::prelude::*;
use serde_json::Value;

use super::simulate::read_stations;
use crate::forecast::next::{Unseen, best_place};
use crate::forecast::room::Room;
use crate::output::{Format, LengthUnit, Table, rounded, say, spinner};
use asbuilt_read::ifc;

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
No database is needed. STATIONS is a text file with a scanner position a line: x y z, in metres; # starts a comment.

coverage is the share of the object's surface that the stations would see; best_loa the finest USIBD Level of Accuracy
that they could prove for an object built as drawn, with this scanner and registration; stations how many see it. Only
what is in the model hides: furniture and people come on top.

Then the place is printed from which one more station would see most of what is still unseen; with --next 3 three of
them, each knowing the ones before.

CSV is guarded against spreadsheets: a text that begins with = + - @, a tab or a carriage return gets an apostrophe
before it, numbers never; --format csv-exact writes everything as it is.

Examples:
  asbuilt forecast model.ifc --stations plan.txt --sensor hybrid --sigma-station 0.002
  asbuilt forecast model.ifc --stations plan.txt --next 3 --format csv

To ask for more in SQL, simulate the beams and load them as an epoch of their own:
  asbuilt simulate model.ifc --stations plan.txt --out plan.e57
  asbuilt load model.ifc plan.e57 --epoch 0
  asbuilt verify --epoch 0")]
pub struct ForecastArgs {
    /// IFC model
    model: PathBuf,
    /// File of scanner positions
    #[arg(long, value_name = "FILE")]
    stations: PathBuf,
    /// Kind of scanner: phase, hybrid, pulse, compact, handheld or tablet
    #[arg(long, default_value = "hybrid", value_name = "NAME")]
    sensor: String,
    /// Standard deviation of a station's registration, metres; instead of what is usual with the scanner
    #[arg(long, value_name = "M")]
    sigma_station: Option<f64>,
    /// Angle between neighbouring beams, milliradians
    #[arg(long, default_value_t = 3.0, value_name = "MRAD")]
    step_mrad: f64,
    /// Distance between samples on the objects, metres
    #[arg(long, default_value_t = 0.05, value_name = "M")]
    spacing: f64,
    /// How many more stations to propose
    #[arg(long, default_value_t = 1, value_name = "N")]
    next: usize,
    /// Distance between places that are tried for them, metres
    #[arg(long, default_value_t = 1.0, value_name = "M")]
    grid: f64,
    /// Height of the scanner above the model's lowest point … of its first station, if not given
    #[arg(long, value_name = "M")]
    height: Option<f64>,
    /// Unit of deviations [default: mm in tables, m in CSV and JSON]
    #[arg(long, value_enum, value_name = "UNIT")]
    units: Option<LengthUnit>,
    /// How to print
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

struct Object {
    name: String,
    ifc_class: String,
    solid: Solid,
}

pub fn run(args: &ForecastArgs) -> Result<()> {
    let model = model(args)?;
    let preset = SensorPreset::named(&args.sensor)?;
    let plan = |origin| PlannedStation { origin, step: args.step_mrad * 1e-3, max_range: preset.max_range };
    let stations: Vec<PlannedStation> = read_stations(&args.stations)?.into_iter().map(plan).collect();
    let bar = spinner(&format!("meshing {}", args.model.display()));
    let objects = objects(args)?;
    bar.finish_and_clear();
    let solids: Vec<Solid> = objects.iter().map(|o| o.solid.clone()).collect();
    let room = Room::new(&solids);
    for (i, s) in stations.iter().enumerate().filter(|(_, s)| !room.can_stand(&s.origin)) {
        say!("asbuilt: station {} ({}) stands in or at an object of the model", i + 1, place(&s.origin));
    }
    let bar = spinner("looking around");
    let evidence = solids
        .par_iter()
        .map(|s| Ok(Evidence::expected(s, model, &stations, |from, to| room.is_free(from, to), NEVER)?))
        .collect::<Result<Vec<Evidence>>>()?;
    bar.finish_and_clear();
    print_objects(args, &objects, &evidence, &model)?;
    propose(args, &room, &solids, &evidence, &stations, &model)
}

fn model(args: &ForecastArgs) -> Result<EvidenceModel> {
    if !(0.05..=100.0).contains(&args.step_mrad) {
        bail!("--step-mrad {} must be between 0.05 and 100", args.step_mrad);
    }
    if !(0.1..=1000.0).contains(&args.grid) {
        bail!("--grid {} must be between 0.1 and 1000 m", args.grid);
    }
    if let Some(height) = args.height.filter(|h| !(-1000.0..=1000.0).contains(h)) {
        bail!("--height {height} must be between -1000 and 1000 m");
    }
    let preset = SensorPreset::named(&args.sensor)?;
    let mut model = EvidenceModel::default();
    model.set("spacing", args.spacing)?;
    model.set("sigma_range", preset.sigma_range)?;
    model.set("sigma_angle", preset.sigma_angle)?;
    model.set("sigma_station", args.sigma_station.unwrap_or(preset.sigma_station))?;
    Ok(model)
}

fn objects(args: &ForecastArgs) -> Result<Vec<Object>> {
    let read = ifc::read(&args.model, ifc::Limits::default())?;
    let mut out = Vec::new();
    for p in &read.products {
        let solid = p.solid().with_context(|| p.name.clone())?;
        out.extend(solid.map(|solid| Object { name: p.name.clone(), ifc_class: p.ifc_class.clone(), solid }));
    }
    if out.is_empty() {
        bail!("{}: no object has a body", args.model.display());
    }
    Ok(out)
}

fn print_objects(args: &ForecastArgs, objects: &[Object], evidence: &[Evidence], model: &EvidenceModel) -> Result<()> {
    let unit = LengthUnit::or_default(args.units, args.format);
    let deviation_sd = unit.column("deviation_sd");
    let mut table = Table::new(&["name", "ifc_class", "area_m2", "coverage", "stations", "best_loa", &deviation_sd]);
    for (o, e) in objects.iter().zip(evidence) {
        let s: Summary = e.summary(&model.question, &VerdictRule::default(), NEVER)?;
        table.push(vec![
            Value::from(o.name.as_str()),
            Value::from(o.ifc_class.as_str()),
            rounded(Some(o.solid.area()), 1),
            rounded(Some(s.coverage), 3),
            Value::from(e.stations().len()),
            s.best_loa.map_or(Value::Null, |l| Value::from(l.name())),
            unit.value(s.deviation.map(|d| d.1)),
        ]);
    }
    table.print(args.format)
}

/// Proposes further stations, each where it sees most of what no station before it sees.
fn propose(
    args: &ForecastArgs,
    room: &Room,
    solids: &[Solid],
    evidence: &[Evidence],
    stations: &[PlannedStation],
    model: &EvidenceModel,
) -> Result<()> {
    let bounds = solids.iter().map(Solid::bounds).fold(Aabb::EMPTY, |a, b| a.union(&b));
    let whole: f64 = solids.iter().map(Solid::area).sum();
    let height = args.height.unwrap_or(stations[0].origin.z - bounds.min[2]);
    let mut unseen = unseen(solids, evidence, model)?;
    for _ in 0..args.next {
        let bar = spinner("looking for one more station");
        let found = best_place(room, &bounds, &unseen, &stations[0], height, args.grid, model);
        bar.finish_and_clear();
        let Some(best) = found else {
            say!("asbuilt: no further station would see anything new at {height:.2} m above the model's lowest point");
            return Ok(());
        };
        let seen = 1.0 - unseen.iter().map(|u| u.area).sum::<f64>() / whole;
        say!(
            "one more station at {}: {:.1} m² more ({:.1} % of all surface instead of {:.1} %)",
            place(&best.origin),
            best.gain,
            100.0 * (seen + best.gain / whole),
            100.0 * seen
        );
        let station = PlannedStation { origin: best.origin, ..stations[0] };
        unseen.retain(|u| !(station.faces(&u.position, &u.normal, model) && room.is_free(&best.origin, &u.position)));
    }
    Ok(())
}

fn unseen(solids: &[Solid], evidence: &[Evidence], model: &EvidenceModel) -> Result<Vec<Unseen>> {
    let mut out = Vec::new();
    for (solid, e) in solids.iter().zip(evidence) {
        let area = solid.area() / e.samples().len().max(1) as f64;
        e.for_each_sample(&model.question, NEVER, |position, normal, belief| {
            if !belief.seen {
                out.push(Unseen { position: *position, normal: *normal, area });
            }
        })?;
    }
    Ok(out)
}

fn place(p: &Vec3) -> String {
    format!("{:.2} {:.2} {:.2}", p.x, p.y, p.z)
}
