//! One object under one survey: what the evidence says, compared with what is true.

use anyhow::Result;
use asbuilt_core::NEVER;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::verify::{
    Collector, Evidence, EvidenceModel, ModelKind, Question, SampleBelief, Summary, SurveyObjects, Threads, Verdict,
    VerdictRule,
};
use asbuilt_simulate::{Change, Scanner, Scene};
use rayon::prelude::*;

use crate::building::{Building, Layout, Object};
use crate::built::{Built, Case, Fate};
use crate::survey::Survey;
use crate::truth::{BuiltSurface, Expected, SampleTruth, Viewpoints, expected, sight};

/// Most samples of an object whose truth is looked up.
const MAX_TRUTHS: usize = 4000;

/// An estimate with its stated standard deviation, and the truth, metres.
#[derive(Debug, Clone, Copy)]
pub struct Estimate {
    pub value: f64,
    pub sd: f64,
    pub truth: f64,
}

/// What one sample's belief said, and whether it was true.
#[derive(Debug, Clone, Copy)]
pub struct Stated {
    pub occupied: f64,
    pub within: bool,
}

/// An object-case.
#[derive(Debug)]
pub struct Outcome {
    pub layout: Layout,
    pub case: Case,
    pub expected: Expected,
    pub verdict: Verdict,
    pub best_loa: Option<Loa>,
    /// The finest class that a survey of this registration can prove at 95 %.
    pub provable: Loa,
    /// The survey that scanned it.
    pub scanner: Scanner,
    /// The estimate of the deviation in the summary.
    pub deviation: Option<Estimate>,
    /// The estimates of the deviation of every well-seen face.
    pub faces: Vec<Estimate>,
    /// The estimates of the rigid shift along each determined direction; only for objects that moved rigidly.
    pub shift: Vec<Estimate>,
    pub stated: Vec<Stated>,
    /// A line for the list of what went wrong.
    pub account: String,
}

/// A scene with everything known about it.
pub struct Setup {
    pub number: usize,
    pub building: Building,
    pub built: Built,
    pub survey: Survey,
    pub scene: Scene,
    pub stations: Vec<Vec3>,
    pub patches: Vec<Vec<u8>>,
}

impl Setup {
    /// Every object under `kind`: all together as `ab_verify_table` and `asbuilt verify` take them, or each `alone` as
    /// `ab_evidence_agg` does.
    pub fn outcomes(&self, kind: ModelKind, alone: bool) -> Result<Vec<Outcome>> {
        let objects = &self.building.objects;
        let solids: Vec<(Solid, EvidenceModel)> =
            objects.iter().enumerate().map(|(i, o)| (o.solid.clone(), self.model(i, kind))).collect();
        let rule = VerdictRule::default();
        let verified: Vec<(Evidence, Summary)> = if alone {
            let alone = |(solid, model): &(Solid, EvidenceModel)| {
                let evidence = self.evidence_alone(solid, *model)?;
                let summary = evidence.summary(&model.question, &rule, NEVER)?;
                Ok((evidence, summary))
            };
            solids.par_iter().map(alone).collect::<Result<_>>()?
        } else {
            let objects = SurveyObjects::new(solids, Threads::Pool, NEVER)?;
            let verified = objects.verified(&self.patches, 32, &rule, Threads::Pool, NEVER)?;
            verified.into_iter().map(|(evidence, judged)| (evidence, judged.summary)).collect()
        };
        let cases: Vec<_> = objects.iter().zip(&self.built.fates).zip(&verified).collect();
        cases.into_par_iter().map(|((object, fate), verified)| self.outcome(object, fate, verified)).collect()
    }

    fn evidence_alone(&self, solid: &Solid, model: EvidenceModel) -> Result<Evidence> {
        let mut collector = Collector::new(solid, model, NEVER)?;
        self.patches.iter().try_for_each(|patch| collector.absorb(patch, NEVER))?;
        Ok(collector.into_evidence())
    }

    fn outcome(&self, object: &Object, fate: &Fate, (evidence, summary): &(Evidence, Summary)) -> Result<Outcome> {
        let model = *evidence.model();
        let rule = VerdictRule::default();
        let samples = self.samples(evidence, &model, fate)?;
        let truths: Vec<(usize, SampleTruth)> = samples.iter().map(|s| (s.face, s.truth)).collect();
        let missing = fate.solid.is_none();
        let expected = expected(&truths, missing, model.question.tolerance(), rule.min_coverage);
        let faces = face_estimates(evidence, &model, &samples)?;
        let deviation = summary
            .deviation
            .and_then(|(value, sd)| faces.iter().find(|(_, e)| e.value == value).map(|(_, e)| Estimate { sd, ..*e }));
        let rigid = matches!(fate.case, Case::AsDrawn | Case::Shifted | Case::HalfHidden);
        let shift = match &summary.shift {
            Some(s) if rigid && !missing => shift_estimates(s, &Vec3::from(fate.change.shift)),
            _ => Vec::new(),
        };
        let survey_sd = self.survey.scanner.sigma_registration / (self.stations.len() as f64).sqrt();
        let account = self.account(object, fate, &model, &expected, summary);
        Ok(Outcome {
            layout: self.building.layout,
            case: fate.case,
            verdict: summary.verdict,
            best_loa: summary.best_loa,
            provable: provable(survey_sd),
            scanner: self.survey.scanner,
            deviation,
            faces: faces.into_iter().map(|f| f.1).collect(),
            shift,
            stated: samples.iter().filter_map(|s| s.stated(model.question.tolerance())).collect(),
            expected,
            account,
        })
    }

    fn account(&self, object: &Object, fate: &Fate, model: &EvidenceModel, right: &Expected, said: &Summary) -> String {
        let millimetres = |v: [f64; 3]| v.map(|x| (x * 1e4).round() / 10.0);
        let Change { shift, tilt_deg, bow, .. } = fate.change;
        let names: Vec<&str> = right.verdicts.iter().map(|v| v.name()).collect();
        format!(
            "scene {}, {}, {} (shift {:?} mm, tilt {tilt_deg:.2}°, bow {:?} mm), {}: {} right, {:.1} mm from the border, \
            said {} ({}; deviation {} mm)",
            self.number,
            object.name,
            fate.case.name(),
            millimetres(shift),
            millimetres(bow),
            model.question.loa.name(),
            names.join(" or "),
            right.margin * 1e3,
            said.verdict.name(),
            said.best_loa.map_or("no LOA", Loa::name),
            said.deviation.map_or("-".into(), |(d, sd)| format!("{:.1} ± {:.1}", d * 1e3, sd * 1e3)),
        )
    }

    /// The parameters that the sensor's data sheet and the registration's report give; levels of accuracy alternate
    /// among those for which the survey is fit.
    fn model(&self, i: usize, kind: ModelKind) -> EvidenceModel {
        let s = &self.survey.scanner;
        let fit: Vec<Loa> = [Loa::Loa20, Loa::Loa30, Loa::Loa40]
            .into_iter()
            .filter(|l| l.upper() >= 3.0 * s.sigma_registration && l.upper() >= s.sigma_range)
            .collect();
        EvidenceModel {
            kind,
            question: Question { loa: fit[(i + self.number) % fit.len()], ..Question::default() },
            sigma_range: s.sigma_range,
            sigma_angle: s.sigma_angle,
            sigma_station: s.sigma_registration,
            max_incidence: self.survey.max_incidence,
            ..EvidenceModel::default()
        }
    }

    fn samples(&self, evidence: &Evidence, model: &EvidenceModel, fate: &Fate) -> Result<Vec<Sample>> {
        let surface = BuiltSurface::new(fate.solid.as_ref());
        let stride = evidence.samples().len().div_ceil(MAX_TRUTHS).max(1);
        let faces: Vec<usize> = evidence.samples().face_of_each().collect();
        let Survey { scanner, max_incidence, .. } = self.survey;
        // Up to 10 cm in front of its place it may be the object itself; what was not built stands nowhere.
        let in_front = if fate.solid.is_some() { 0.1 } else { 1e-3 };
        let view = Viewpoints { stations: &self.stations, step: scanner.step, max_incidence, in_front };
        let (mut out, mut i) = (Vec::new(), 0);
        evidence.for_each_sample(&model.question, NEVER, |position, normal, belief| {
            if i % stride == 0 {
                let area = model.spacing * model.spacing * stride as f64;
                let sight = sight(&self.scene, &view, area, position, normal);
                let truth = surface.at(position, normal, sight);
                out.push(Sample { face: faces[i], truth, belief: *belief });
            }
            i += 1;
        })?;
        Ok(out)
    }
}

struct Sample {
    face: usize,
    truth: SampleTruth,
    belief: SampleBelief,
}

impl Sample {
    fn stated(&self, tolerance: f64) -> Option<Stated> {
        let (occupied, within) = (self.belief.mass.occupied, self.truth.distance <= tolerance);
        self.belief.seen.then_some(Stated { occupied, within })
    }
}

/// The finest class whose bound is 1.96 of these σ or more.
fn provable(sd: f64) -> Loa {
    Loa::ALL.into_iter().rev().find(|l| l.upper() >= 1.96 * sd).unwrap_or(Loa::Loa10)
}

/// Faces with a deviation, and the true median of the same samples.
fn face_estimates(evidence: &Evidence, model: &EvidenceModel, samples: &[Sample]) -> Result<Vec<(usize, Estimate)>> {
    let mut out = Vec::new();
    for (f, report) in evidence.faces(&model.question, NEVER)?.iter().enumerate() {
        let mut truth: Vec<f64> = samples
            .iter()
            .filter(|s| s.face == f && s.belief.seen && s.belief.deviation.is_some())
            .filter_map(|s| s.truth.deviation)
            .collect();
        truth.sort_by(f64::total_cmp);
        if let (Some((value, sd)), true) = (report.deviation, report.coherent && truth.len() >= 10) {
            out.push((f, Estimate { value, sd, truth: truth[truth.len() / 2] }));
        }
    }
    Ok(out)
}

/// Shift and truth along the principal directions of what is determined.
fn shift_estimates(shift: &asbuilt_core::verify::Shift, truth: &Vec3) -> Vec<Estimate> {
    let eigen = nalgebra::SymmetricEigen::new(shift.covariance);
    (0..3)
        .map(|k| eigen.eigenvectors.column(k).into_owned())
        .filter(|v| shift.undetermined.iter().all(|u| u.dot(v).abs() < 0.05))
        .map(|v| Estimate {
            value: shift.vector.dot(&v),
            sd: v.dot(&(shift.covariance * v)).max(0.0).sqrt(),
            truth: truth.dot(&v),
        })
        .collect()
}
