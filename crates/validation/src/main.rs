//! Verdicts, beliefs and intervals against scenes whose truth is known: `make truth`.
//!
//! * [`building`]: layouts as drawn; [`built`]: what was built otherwise; [`survey`]: scanners and their places;
//! * [`truth`]: what is true of an object, from its built surface alone;
//! * [`case`]: one object under one survey, evidence compared with truth;
//! * [`tally`], [`report`], [`picture`]: the numbers, docs/truth.md and its pictures;
//! * [`field`]: the same questions on real buildings, by another scanner.

mod building;
mod built;
mod case;
mod field;
mod picture;
mod report;
mod survey;
mod tally;
mod truth;

use std::path::PathBuf;

use anyhow::{Result, bail};
use asbuilt_core::verify::ModelKind;
use asbuilt_simulate::Scene;
use clap::Parser;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use building::{Building, Layout};
use built::Built;
use case::Setup;
use report::{Results, SceneLine};
use survey::Survey;

/// Judge simulated buildings whose truth is known, and count how often the verdicts are right.
#[derive(Parser)]
struct Args {
    /// Number of scenes, about 21 object-cases each
    #[arg(long, default_value_t = 36)]
    scenes: usize,
    /// Only this scene of the set; may be given several times
    #[arg(long, value_name = "NUMBER")]
    scene: Vec<usize>,
    /// Seed of the set; another one is another set
    #[arg(long, default_value_t = 20_260_000)]
    seed: u64,
    /// Five coarse scenes only, and fail where the numbers fall short
    #[arg(long)]
    short: bool,
    /// Verify every object by itself, as ab_evidence_agg does, not together with its neighbours
    #[arg(long)]
    alone: bool,
    /// Real buildings under the second scanner instead of the standard set
    #[arg(long)]
    field: bool,
    /// Real buildings in two epochs under the second scanner: what changed, instead of the standard set
    #[arg(long, conflicts_with = "field")]
    change: bool,
    /// Surfaces of the model of a real scan moved by known amounts, instead of the standard set
    #[arg(long, conflicts_with_all = ["field", "change"])]
    planted: bool,
    /// With --field or --change: a line for every object-case, the wrong ones first
    #[arg(long, value_name = "FILE.csv")]
    cases: Option<PathBuf>,
    /// Write the report here, pictures and the numbers of meyer2022 beside it
    #[arg(long, value_name = "FILE.md")]
    report: Option<PathBuf>,
}

/// Scenes of the standard set that are scanned coarsely: a quarter of a minute.
const SHORT: [usize; 5] = [0, 2, 4, 7, 9];

fn main() -> Result<()> {
    let args = Args::parse();
    let report = args.report.as_deref();
    match () {
        () if args.planted => field::planted::run(report),
        () if args.field || args.change => {
            let (only, cases) = (&args.scene[..], args.cases.as_deref());
            let task = field::Task { only, short: args.short, seed: args.seed, cases, report };
            if args.change { field::epochs::run(&task) } else { field::run(&task) }
        }
        () => standard(&args),
    }
}

/// The standard set.
fn standard(args: &Args) -> Result<()> {
    let numbers: Vec<usize> = match () {
        () if !args.scene.is_empty() => args.scene.clone(),
        () if args.short => SHORT.to_vec(),
        () => (0..args.scenes).collect(),
    };
    let mut scenes = Vec::new();
    let mut surface = Results { model: ModelKind::Surface.name(), outcomes: Vec::new() };
    let mut rays = Results { model: ModelKind::Meyer2022.name(), outcomes: Vec::new() };
    for (done, number) in numbers.iter().enumerate() {
        eprintln!("truth: scene {number} ({} of {})", done + 1, numbers.len());
        let setup = setup(*number, args.seed)?;
        scenes.push(SceneLine::of(&setup));
        surface.outcomes.extend(setup.outcomes(ModelKind::Surface, args.alone)?);
        if args.report.is_some() {
            rays.outcomes.extend(setup.outcomes(ModelKind::Meyer2022, args.alone)?);
        }
    }
    print!("{}", report::text(&surface, args.report.is_some().then_some(&rays)));
    for o in surface.outcomes.iter().filter(|o| !tally::right(o)) {
        println!("wrong: {}", o.account);
    }
    if let Some(path) = &args.report {
        report::write(path, args.seed, &scenes, &surface, &rays)?;
    }
    if args.short { check(&surface) } else { Ok(()) }
}

fn setup(number: usize, seed: u64) -> Result<Setup> {
    let survey = Survey::number(number, seed);
    let mut rng = ChaCha8Rng::seed_from_u64(survey.seed);
    let building = Building::draw(Layout::number(number), &mut rng)?;
    let built = Built::of(&building, &mut rng)?;
    let places = survey.places(&building, &mut rng);
    let stations: Vec<_> = places.iter().map(|p| building.world_from_plan.point(p)).collect();
    let scene = Scene::new(&built.solids());
    let mut patches = Vec::new();
    for (i, station) in stations.iter().enumerate() {
        patches.extend(survey.scan(&scene, station, i as i64 + 1)?);
    }
    Ok(Setup { number, building, built, survey, scene, stations, patches })
}

/// The bounds of the whole set, with room for the few cases of the short one.
fn check(r: &Results) -> Result<()> {
    let error = tally::calibration_error(&r.reliability());
    let failed: Vec<&str> = [
        ("verdicts", r.verdicts().value() < 0.97 || r.verdicts().all < 90),
        ("false absent", r.false_absent().hits > 0),
        ("best LOA", r.loa(true).value() < 0.95 || r.loa(true).all < 50),
        ("calibration", error > 0.03),
        ("deviation", r.deviation().holds.value() < 0.9),
        ("shift", r.shift().holds.value() < 0.9),
    ]
    .into_iter()
    .filter_map(|(what, failed)| failed.then_some(what))
    .collect();
    if failed.is_empty() { Ok(()) } else { bail!("short of what it must show: {}", failed.join(", ")) }
}
