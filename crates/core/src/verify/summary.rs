//! The verdict on an object.

use super::built_surface::Built;
use super::evidence::Evidence;
use super::face::FaceReport;
use super::judgement::Judgement;
use super::model::{EvidenceModel, ModelKind};
use super::shift::Shift;
use super::surface_points::SurfacePoints;
use crate::evidence::Loa;
use crate::{Interrupt, Result};

/// What can be said of an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Built, within the tolerance.
    Confirmed,
    /// Built, but not where it was drawn.
    Deviating,
    /// Its space was seen empty.
    Absent,
    /// Too little of it was seen to say.
    Unobserved,
    /// Stations contradict each other.
    Conflicting,
}

impl Verdict {
    /// SQL text.
    pub fn name(self) -> &'static str {
        ["confirmed", "deviating", "absent", "unobserved", "conflicting"][self as usize]
    }
}

/// Thresholds of the verdict, all shares of samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerdictRule {
    /// Least share of all samples that must be seen.
    pub min_coverage: f64,
    /// Least share of each well-seen surface that must keep the tolerance (0.75 where less is given), and, up to 0.6,
    /// of what is decided that must be in place.
    pub min_confirmed: f64,
    /// Mean conflict between stations from which nothing else is said.
    pub max_conflict: f64,
}

impl Default for VerdictRule {
    fn default() -> Self {
        Self { min_coverage: 0.02, min_confirmed: 0.6, max_conflict: 0.3 }
    }
}

/// Verdict with the numbers that led to it: SQL's `ab_summary`.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// The verdict at the asked level of accuracy.
    pub verdict: Verdict,
    /// The finest level of accuracy at which the object would be confirmed.
    pub best_loa: Option<Loa>,
    /// All samples.
    pub samples: u64,
    /// Share of all samples that were seen.
    pub coverage: f64,
    /// Shares of the seen samples; `None` when none was seen. They add up to 1.
    pub shares: Option<Shares>,
    /// Median deviation of the worst well-seen face along its outward normal, metres, and its σ.
    pub deviation: Option<(f64, f64)>,
    /// Rigid offset.
    pub shift: Option<Shift>,
}

/// How the seen samples divide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    /// Belief in "built here" reaches the confidence.
    pub confirmed: f64,
    /// Belief in "not built here" reaches it.
    pub refuted: f64,
    /// Neither.
    pub open: f64,
    /// Mean conflict between stations.
    pub conflict: f64,
}

/// Share of every surface that must keep a class before an object has it.
const MIN_WITHIN_USIBD: f64 = 0.95;

impl Evidence {
    /// The verdict at the level of accuracy and confidence of `model`.
    pub fn verdict(&self, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<Verdict> {
        let model = self.question(model);
        let built = Built::of(self, &model, interrupt)?;
        Ok(Judgement::of(&built, &model, rule, interrupt)?.verdict())
    }

    /// Every face as judged at the level of accuracy and confidence of `model`.
    pub fn faces(&self, model: &EvidenceModel, interrupt: Interrupt) -> Result<Vec<FaceReport>> {
        let model = self.question(model);
        Built::of(self, &model, interrupt)?.faces(&model, interrupt)
    }

    /// The rigid offset; `None` where no face determines one.
    pub fn rigid_shift(&self, interrupt: Interrupt) -> Result<Option<Shift>> {
        self.shift(&self.faces(&self.model, interrupt)?, interrupt)
    }

    /// Verdict, shares, deviation, rigid offset and best level of accuracy.
    pub fn summary(&self, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<Summary> {
        let model = self.question(model);
        let built = Built::of(self, &model, interrupt)?;
        let judgement = Judgement::of(&built, &model, rule, interrupt)?;
        let (totals, stands) = (&judgement.totals, judgement.stands(&built, rule));
        let seen = totals.seen as f64;
        Ok(Summary {
            verdict: judgement.verdict(),
            best_loa: best_loa(&built, &judgement, &model, rule, interrupt)?,
            samples: totals.samples,
            coverage: if totals.samples > 0 { seen / totals.samples as f64 } else { 0.0 },
            shares: (totals.seen > 0).then(|| Shares {
                confirmed: totals.confirmed as f64 / seen,
                refuted: totals.refuted as f64 / seen,
                open: totals.open() as f64 / seen,
                conflict: totals.conflict / seen,
            }),
            deviation: judgement.worst_face().filter(|_| stands).and_then(|f| f.deviation),
            shift: if stands { self.shift(&judgement.faces, interrupt)? } else { None },
        })
    }

    fn shift(&self, faces: &[FaceReport], interrupt: Interrupt) -> Result<Option<Shift>> {
        if self.model.kind != ModelKind::Surface {
            return Ok(None);
        }
        Ok(Shift::fit(faces, &SurfacePoints::of(self, interrupt)?, &self.model))
    }

    /// Level of accuracy and confidence may be asked anew; how the sums were made may not.
    pub(super) fn question(&self, asked: &EvidenceModel) -> EvidenceModel {
        EvidenceModel { confidence: asked.confidence, loa: asked.loa, ..self.model }
    }
}

/// The finest class that would be confirmed, 95 % of every surface within it (USIBD), and that the survey proves at the
/// confidence.
pub(super) fn best_loa(
    built: &Built,
    judgement: &Judgement,
    model: &EvidenceModel,
    rule: &VerdictRule,
    interrupt: Interrupt,
) -> Result<Option<Loa>> {
    if !judgement.stands(built, rule) {
        return Ok(None);
    }
    if model.kind == ModelKind::Meyer2022 {
        // Its masses do not know the tolerance.
        return Ok((judgement.verdict() == Verdict::Confirmed).then_some(model.loa));
    }
    let rule = VerdictRule { min_confirmed: rule.min_confirmed.max(MIN_WITHIN_USIBD), ..*rule };
    for loa in Loa::ALL.into_iter().rev() {
        let model = EvidenceModel { loa, ..*model };
        let proven = || built.is_proven(loa.upper(), model.confidence);
        if proven() && Judgement::of(built, &model, &rule, interrupt)?.verdict() == Verdict::Confirmed {
            return Ok(Some(loa));
        }
    }
    Ok(None)
}
