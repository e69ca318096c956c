//! What the verifier says of a scene, beside what is right. This file alone knows the verifier.

use anyhow::Result;
use asbuilt_core::NEVER;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::Solid;
use asbuilt_core::verify::{
    Evidence, EvidenceModel, Judged, Question, Sights, Summary, SurveyObjects, Threads, Verdict, VerdictRule,
};
use asbuilt_fieldscan::Receiver;
use rayon::prelude::*;

use super::cases::Case;
use super::fate::Deed;
use super::observer::{MAX_INCIDENCE, Truth, truths};
use super::patches::Delivery;
use super::right::right;
use super::scene::{DATUM_M, Scene};
use super::standing::SIGMA_BIAS_M;
use super::why::{Kept, ReasonSaid};
use crate::case::{Estimate, Stated};

/// Most samples of an object whose belief is compared with the truth.
const MAX_STATED: usize = 400;
/// Built surfaces are looked for so far from a sample, metres.
const REACH_M: f64 = 0.3;

/// Every object under every delivery.
pub fn cases(scene: &Scene) -> Result<Vec<Case>> {
    let numbers: Vec<usize> = (0..scene.layout.objects.len()).collect();
    let truths: Vec<Vec<Truth>> = numbers.par_iter().map(|i| truths(scene, *i)).collect();
    let returns = scene.returns();
    let mut out = Vec::new();
    for delivery in [Delivery::Stations, Delivery::Merged] {
        let verified = verified(scene, delivery)?;
        let judged: Vec<Case> = numbers
            .par_iter()
            .filter(|i| !scene.layout.objects[**i].twin)
            .map(|&i| case(scene, delivery, i, (&truths[i], returns[i]), &verified[i]))
            .collect::<Result<_>>()?;
        out.extend(judged);
    }
    Ok(out)
}

/// The evidence and the verdict of every object, together.
pub fn verified(scene: &Scene, delivery: Delivery) -> Result<Vec<(Evidence, Judged)>> {
    let (objects, patches) = survey(scene, delivery)?;
    Ok(objects.verified(&patches, 32, &VerdictRule::default(), Threads::Pool, NEVER)?)
}

/// The objects by station, the evidence of each, and where all beams ended.
pub fn evidence(scene: &Scene) -> Result<(SurveyObjects, Vec<Evidence>, Sights)> {
    let (objects, patches) = survey(scene, Delivery::Stations)?;
    let (evidence, sights) = objects.evidence_and_sights(&patches, 32, Threads::Pool, NEVER)?;
    Ok((objects, evidence, sights))
}

/// All drawn objects, and the patches that are delivered.
fn survey(scene: &Scene, delivery: Delivery) -> Result<(SurveyObjects, Vec<Vec<u8>>)> {
    let solids: Vec<(Solid, EvidenceModel)> =
        scene.layout.objects.iter().enumerate().map(|(i, o)| (o.solid.clone(), model(scene, i))).collect();
    Ok((SurveyObjects::new(solids, Threads::Pool, NEVER)?, delivery.patches(&scene.scans)?))
}

/// What a surveyor tells: the scanner's data sheet (noise on a white surface at 10 m, bias by material), the report of the
/// registration, and how well the datum is known; the last two of these no number of stations averages out. Classes
/// alternate among those for which the survey is fit.
fn model(scene: &Scene, number: usize) -> EvidenceModel {
    let registration = &scene.plan.registration;
    EvidenceModel {
        question: Question { loa: loa(scene, number), ..Question::default() },
        sigma_range: scene.plan.scanner.receiver.sigma(Receiver::WHITE_AT_10_M),
        sigma_angle: scene.plan.scanner.sigma_angle,
        sigma_station: registration.sigma_place_m,
        sigma_model: DATUM_M.hypot(SIGMA_BIAS_M),
        max_incidence: MAX_INCIDENCE,
        ..EvidenceModel::default()
    }
}

fn loa(scene: &Scene, number: usize) -> Loa {
    let sd = scene.common_sd();
    let fit: Vec<Loa> = [Loa::Loa20, Loa::Loa30, Loa::Loa40].into_iter().filter(|l| l.upper() >= 4.0 * sd).collect();
    fit[(number + scene.plan.number) % fit.len()]
}

fn case(
    scene: &Scene,
    delivery: Delivery,
    number: usize,
    (truths, returns): (&[Truth], usize),
    (evidence, judged): &(Evidence, Judged),
) -> Result<Case> {
    let (object, fate) = (&scene.layout.objects[number], &scene.fates[number]);
    let summary = &judged.summary;
    let mut right = right(object, fate, (truths, returns), loa(scene, number).upper(), border(scene));
    if delivery == Delivery::Merged {
        // Without rays nothing is seen to be empty.
        allow_silence(&mut right.verdicts);
    }
    let (stated, deviation) = compared(scene, number, evidence, summary)?;
    let is_wrong = !right.verdicts.contains(&summary.verdict);
    let explain = || evidence.explain(&evidence.model().question, &VerdictRule::default(), NEVER);
    Ok(Case {
        account: is_wrong.then(explain).transpose()?,
        scene: scene.plan.number,
        model: scene.plan.name(),
        delivery,
        id: object.id.clone(),
        class: object.class.clone(),
        name: object.name.clone(),
        kind: object.kind,
        glazed: object.transparent.iter().any(|t| *t),
        deed: fate.deed,
        displaced_mm: fate.displaced.map(|c| c * 1e3).into(),
        loa: loa(scene, number),
        said: summary.verdict,
        best_loa: summary.best_loa,
        coverage: summary.coverage,
        shares: summary.shares.map(|s| [s.confirmed, s.refuted, s.open]),
        deviation: summary.deviation,
        true_deviation: deviation,
        hidden_by: right.hidden_by.map(|owner| owner_name(scene, owner)),
        reason: summary.unseen.map(|unseen| {
            // Panes and leaves are asked nothing where the object has anything else.
            let fixed = || truths.iter().filter(|t| !t.glass && !t.leaf);
            let kept: Vec<Kept> = if fixed().next().is_some() {
                fixed().filter_map(|t| t.kept).collect()
            } else {
                truths.iter().filter_map(|t| t.kept).collect()
            };
            ReasonSaid::of(unseen.main(), judged.hidden_by, &kept)
        }),
        shared_with: most_shared(scene, truths),
        right,
        stated,
    })
}

/// Within this of the tolerance no survey of this registration can tell, metres: two standard deviations, and 1 mm.
fn border(scene: &Scene) -> f64 {
    2.0 * scene.common_sd() + 0.001
}

fn allow_silence(verdicts: &mut Vec<Verdict>) {
    let may_be_silent = verdicts.contains(&Verdict::Absent);
    if may_be_silent && !verdicts.contains(&Verdict::Unobserved) {
        verdicts.push(Verdict::Unobserved);
    }
}

fn owner_name(scene: &Scene, owner: u32) -> String {
    scene.layout.objects.get(owner as usize).map_or("nobody's".into(), |o| o.name.clone())
}

fn most_shared(scene: &Scene, truths: &[Truth]) -> Option<String> {
    let mut counts = std::collections::BTreeMap::new();
    truths.iter().filter_map(|t| t.shared_with).for_each(|o| *counts.entry(o).or_insert(0usize) += 1);
    let (most, _) = counts.into_iter().max_by_key(|(_, n)| *n)?;
    Some(owner_name(scene, most as u32))
}

/// Beliefs at samples beside the truth there; and the true deviation of the face that the summary's is of.
fn compared(
    scene: &Scene,
    number: usize,
    evidence: &Evidence,
    summary: &Summary,
) -> Result<(Vec<Stated>, Option<Estimate>)> {
    let (object, fate, standing) = (&scene.layout.objects[number], &scene.fates[number], &scene.standing[number]);
    let (question, tolerance) = (evidence.model().question, loa(scene, number).upper());
    let stride = evidence.samples().len().div_ceil(MAX_STATED).max(1);
    let faces: Vec<usize> = evidence.samples().face_of_each().collect();
    let (mut stated, mut deviations, mut i) = (Vec::new(), Vec::new(), 0);
    evidence.for_each_sample(&question, NEVER, |place, normal, belief| {
        if i % stride == 0 && belief.seen {
            let distance = standing.distance(place, normal, object.is_closed, REACH_M);
            let within = distance.is_some_and(|d| d <= tolerance);
            stated.push(Stated { occupied: belief.mass.occupied, within });
            let truth = belief.deviation.and_then(|_| standing.deviation(place, normal, object.is_closed, REACH_M));
            deviations.extend(truth.map(|d| (faces[i], d)));
        }
        i += 1;
    })?;
    let is_rigid = matches!(fate.deed, Deed::AsDrawn | Deed::Displaced);
    let estimate = summary.deviation.filter(|_| is_rigid).and_then(|(value, sd)| {
        let reports = evidence.faces(&question, NEVER).ok()?;
        let face = reports.iter().position(|r| r.deviation.is_some_and(|d| d.0 == value))?;
        let mut truth: Vec<f64> = deviations.iter().filter(|d| d.0 == face).map(|d| d.1).collect();
        truth.sort_by(f64::total_cmp);
        (truth.len() >= 10).then(|| Estimate { value, sd, truth: truth[truth.len() / 2] })
    });
    Ok((stated, estimate))
}
