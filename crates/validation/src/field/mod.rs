//! Verdicts on real buildings, scanned by the second scanner (`asbuilt-fieldscan`): `truth --field`.
//!
//! * [`layout`], [`leaf`]: buildings as drawn, from IFC; what of a door may turn;
//! * [`fate`], [`standing`], [`clutter`]: what was built of them, and what nobody drew;
//! * [`places`]: where a surveyor sets up;
//! * [`scene`]: one building, built and scanned; [`patches`]: its scans as the database gets them;
//! * [`samples`], [`observer`], [`right`]: what an ideal observer knows of an object, and what a verdict must be;
//! * [`judged`]: what the verifier says;
//! * [`score`], [`bins`], [`cases`], [`report`]: the numbers, docs/truth-field.md and the list of cases;
//! * [`epochs`]: the same buildings in two epochs, and what changed;
//! * [`planted`]: a real scan under a model of which surfaces were moved.

mod bins;
mod cases;
mod clutter;
pub mod epochs;
mod fate;
mod judged;
mod layout;
mod leaf;
mod observer;
mod patches;
mod places;
pub mod planted;
mod report;
mod right;
mod samples;
mod scene;
mod score;
mod standing;
mod why;

use std::path::Path;
use std::time::Instant;

use anyhow::{Result, bail};

use cases::Case;
use layout::Layout;
use scene::{Plan, Scene};

/// What to run.
#[derive(Debug)]
pub struct Task<'a> {
    /// Only these scenes; all where it is empty.
    pub only: &'a [usize],
    /// A few small scenes, and fail where the numbers fall short.
    pub short: bool,
    /// Seed of the set.
    pub seed: u64,
    /// Where to write a line for every case (CSV).
    pub cases: Option<&'a Path>,
    /// Where to write the report.
    pub report: Option<&'a Path>,
}

/// Judges every scene, prints the numbers, and writes what was asked for.
pub fn run(task: &Task) -> Result<()> {
    let plans = scene::plans(task.seed, task.short)?;
    let chosen = plans.iter().filter(|p| task.only.is_empty() || task.only.contains(&p.number));
    let mut cases = Vec::new();
    let mut lines = Vec::new();
    for plan in chosen {
        let (found, line) = judge(plan)?;
        cases.extend(found);
        lines.push(line);
    }
    if cases.is_empty() {
        bail!("no scene: neither ../shared/data nor demo/models holds a model");
    }
    let score = score::Score::of(&cases);
    print!("{}", report::tables(&score));
    if let Some(path) = task.cases {
        cases::write(path, &cases)?;
    }
    if let Some(path) = task.report {
        report::write(path, task.seed, &score, &lines)?;
    }
    if task.short { score.check_short() } else { Ok(()) }
}

/// The cases of one scene, by delivery; and its line in the report.
fn judge(plan: &Plan) -> Result<(Vec<Case>, String)> {
    let start = Instant::now();
    let layout = Layout::read(&plan.model)?;
    let scene = Scene::build(plan, layout)?;
    let scanned = start.elapsed();
    let cases = judged::cases(&scene)?;
    let wrong = cases.iter().filter(|c| !c.is_right()).count();
    eprintln!(
        "field: scene {} ({}), {} objects, {} stations: {} of {} cases wrong; {:.0} s to scan, {:.0} s to judge",
        plan.number,
        plan.name(),
        scene.layout.objects.len(),
        scene.stations.len(),
        wrong,
        cases.len(),
        scanned.as_secs_f64(),
        (start.elapsed() - scanned).as_secs_f64(),
    );
    Ok((cases, report::scene_line(&scene)))
}
