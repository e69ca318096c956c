//! Real buildings in two epochs, by the second scanner: `truth --change`. Stations, registration, clutter and whoever
//! passes are others in the second epoch; of the objects some appeared, went, moved, or were built on.
//!
//! * [`deed`]: what became of each object between the epochs;
//! * [`right`]: what may be said of it, from what an ideal observer sees in both;
//! * [`case`]: one object of one pair of epochs;
//! * [`report`]: the numbers.

mod case;
mod deed;
mod report;
mod right;

use std::time::Instant;

use anyhow::{Result, bail};
use asbuilt_core::NEVER;
use asbuilt_core::verify::{ObjectChange, SurveyedEpoch};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use super::Task;
use super::judged::evidence;
use super::layout::Layout;
use super::observer::truths;
use super::scene::{Plan, Scene, plans};
use case::Case;
use deed::{Deed, deeds};

/// The seed of the second epoch's survey is so far from the first one's.
const SECOND_EPOCH: u64 = 500_000;

/// Judges every scene, prints the numbers, and writes what was asked for.
pub fn run(task: &Task) -> Result<()> {
    let mut cases = Vec::new();
    for plan in plans(task.seed, task.short)?.iter().filter(|p| task.only.is_empty() || task.only.contains(&p.number)) {
        cases.extend(judge(plan)?);
    }
    if cases.is_empty() {
        bail!("no scene: neither ../shared/data nor demo/models holds a model");
    }
    let tables = report::tables(&cases);
    print!("{tables}");
    if let Some(path) = task.cases {
        report::write_cases(path, &cases)?;
    }
    if let Some(path) = task.report {
        report::write(path, &tables, &cases)?;
    }
    if task.short { report::check_short(&cases) } else { Ok(()) }
}

/// The cases of one building.
fn judge(plan: &Plan) -> Result<Vec<Case>> {
    let start = Instant::now();
    let layout = Layout::read(&plan.model)?;
    let deeds = deeds(&layout, &mut ChaCha8Rng::seed_from_u64(plan.seed ^ SECOND_EPOCH));
    let epochs = [epoch(plan, layout, &deeds, 0)?, epoch(plan, Layout::read(&plan.model)?, &deeds, 1)?];
    let scanned = start.elapsed();
    let cases = cases(&epochs, &deeds)?;
    eprintln!(
        "change: scene {} ({}), {} objects, {} and {} stations: {} of {} cases wrong; {:.0} s to scan, {:.0} s to judge",
        plan.number,
        plan.name(),
        deeds.len(),
        epochs[0].stations.len(),
        epochs[1].stations.len(),
        cases.iter().filter(|c| !c.is_right()).count(),
        cases.len(),
        scanned.as_secs_f64(),
        (start.elapsed() - scanned).as_secs_f64(),
    );
    Ok(cases)
}

/// The building in one of the epochs.
fn epoch(plan: &Plan, layout: Layout, deeds: &[Deed], number: usize) -> Result<Scene> {
    let plan = Plan { seed: plan.seed + number as u64 * SECOND_EPOCH, ..plan.clone() };
    Scene::built(&plan, layout, |_, _| deeds.iter().map(|d| d.fates[number].clone()).collect())
}

fn cases(epochs: &[Scene; 2], deeds: &[Deed]) -> Result<Vec<Case>> {
    let [old, new] = [evidence(&epochs[0])?, evidence(&epochs[1])?];
    let surveyed = [&old, &new].map(|(objects, _, sights)| SurveyedEpoch { objects, sights });
    let returns = [epochs[0].returns(), epochs[1].returns()];
    let numbers: Vec<usize> = (0..deeds.len()).collect();
    numbers
        .par_iter()
        .filter(|i| !epochs[0].layout.objects[**i].twin)
        .map(|&i| {
            let mut both = [old.1[i].clone(), new.1[i].clone()];
            let change = ObjectChange::looking_beside(i as u32, both.each_mut(), surveyed, NEVER)?;
            let seen = [0, 1].map(|k| right::Seen { truths: truths(&epochs[k], i), returns: returns[k][i] });
            Ok(Case::of(epochs, i, &deeds[i], &seen, change))
        })
        .collect()
}
