//! The verdict on an object.

use super::evidence::Evidence;
use super::face::FaceReport;
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
    /// Least share of the decided samples (confirmed or refuted) that must be confirmed.
    pub min_confirmed: f64,
    /// Mean conflict between stations from which nothing else is said.
    pub max_conflict: f64,
}

impl Default for VerdictRule {
    fn default() -> Self {
        Self { min_coverage: 0.02, min_confirmed: 0.6, max_conflict: 0.3 }
    }
}

/// Least number of seen samples for a verdict.
const MIN_SEEN: u64 = 5;
/// Least share of the seen samples that must be decided; below it everything is open.
const MIN_DECIDED: f64 = 0.2;
/// Least share of the seen samples that must speak for the object before it is confirmed.
const MIN_CONFIRMED_OF_SEEN: f64 = 0.5;
/// A face counts as well seen with this share of the object's samples that have a surface.
const WELL_SEEN_SHARE: f64 = 0.03;
const WELL_SEEN_SAMPLES: u64 = 10;
/// A face with this share of the seen samples can condemn the object by being refuted, however.
const LARGE_FACE_SHARE: f64 = 0.1;

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

struct Totals {
    samples: u64,
    seen: u64,
    confirmed: u64,
    refuted: u64,
    pierced: u64,
    surface: u64,
    conflict: f64,
}

impl Totals {
    fn of(faces: &[FaceReport]) -> Self {
        let sum = |f: fn(&FaceReport) -> u64| faces.iter().map(f).sum();
        Self {
            samples: sum(|f| f.samples),
            seen: sum(|f| f.seen),
            confirmed: sum(|f| f.confirmed),
            refuted: sum(|f| f.refuted),
            pierced: sum(|f| f.pierced),
            surface: sum(|f| f.surface),
            conflict: faces.iter().map(|f| f.conflict).sum(),
        }
    }
}

impl Evidence {
    /// The verdict at the level of accuracy and confidence of `model`.
    pub fn verdict(&self, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<Verdict> {
        let faces = self.face_reports(&self.question(model), interrupt)?;
        Ok(decide(&faces, &Totals::of(&faces), model, rule))
    }

    /// Every face as judged at the level of accuracy and confidence of `model`.
    pub fn faces(&self, model: &EvidenceModel, interrupt: Interrupt) -> Result<Vec<FaceReport>> {
        self.face_reports(&self.question(model), interrupt)
    }

    /// The rigid offset; `None` where no face determines one.
    pub fn rigid_shift(&self, interrupt: Interrupt) -> Result<Option<Shift>> {
        self.shift(&self.faces(&self.model, interrupt)?, &self.model, interrupt)
    }

    /// Verdict, shares, deviation, rigid offset and best level of accuracy.
    pub fn summary(&self, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<Summary> {
        let model = self.question(model);
        let faces = self.face_reports(&model, interrupt)?;
        let totals = Totals::of(&faces);
        let verdict = decide(&faces, &totals, &model, rule);
        let best_loa = self.best_loa(&model, verdict, covered(&totals, rule), rule, interrupt)?;
        let seen = totals.seen as f64;
        let shares = (totals.seen > 0).then(|| Shares {
            confirmed: totals.confirmed as f64 / seen,
            refuted: totals.refuted as f64 / seen,
            open: (totals.seen - totals.confirmed - totals.refuted) as f64 / seen,
            conflict: totals.conflict / seen,
        });
        // Surfaces met where an absent object should stand are not its own.
        let built = verdict != Verdict::Absent && covered(&totals, rule);
        let deviation = worst_face(&faces, &totals).filter(|_| built).and_then(|f| f.deviation);
        let shift = if built { self.shift(&faces, &model, interrupt)? } else { None };
        Ok(Summary {
            verdict,
            best_loa,
            samples: totals.samples,
            coverage: if totals.samples > 0 { seen / totals.samples as f64 } else { 0.0 },
            shares,
            deviation,
            shift,
        })
    }

    fn shift(&self, faces: &[FaceReport], model: &EvidenceModel, interrupt: Interrupt) -> Result<Option<Shift>> {
        if model.kind != ModelKind::Surface {
            return Ok(None);
        }
        let stations = (self.stations.len() as f64).max(1.0);
        let common_sd = (model.sigma_station / stations.sqrt()).hypot(model.sigma_model);
        Ok(Shift::fit(faces, &SurfacePoints::of(self, interrupt)?, common_sd))
    }

    /// Level of accuracy and confidence may be asked anew; how the sums were made may not.
    fn question(&self, asked: &EvidenceModel) -> EvidenceModel {
        EvidenceModel { confidence: asked.confidence, loa: asked.loa, ..self.model }
    }

    fn best_loa(
        &self,
        model: &EvidenceModel,
        verdict: Verdict,
        covered: bool,
        rule: &VerdictRule,
        interrupt: Interrupt,
    ) -> Result<Option<Loa>> {
        if !covered || verdict == Verdict::Absent {
            return Ok(None);
        }
        if model.kind == ModelKind::Meyer2022 {
            // Its masses do not know the tolerance.
            return Ok((verdict == Verdict::Confirmed).then_some(model.loa));
        }
        for loa in Loa::ALL.into_iter().rev() {
            let confirmed = match loa == model.loa {
                true => verdict == Verdict::Confirmed,
                false => self.verdict(&EvidenceModel { loa, ..*model }, rule, interrupt)? == Verdict::Confirmed,
            };
            if confirmed {
                return Ok(Some(loa));
            }
        }
        Ok(None)
    }
}

/// Whether enough was seen to judge at all.
fn covered(totals: &Totals, rule: &VerdictRule) -> bool {
    totals.seen > 0
        && totals.seen >= MIN_SEEN.min(totals.samples)
        && totals.seen as f64 >= rule.min_coverage * totals.samples as f64
}

fn decide(faces: &[FaceReport], totals: &Totals, model: &EvidenceModel, rule: &VerdictRule) -> Verdict {
    let decided = totals.confirmed + totals.refuted;
    let seen = totals.seen as f64;
    if !covered(totals, rule) {
        return Verdict::Unobserved;
    }
    // Before "undecided": contradiction is what leaves samples open. The ray model's conflict says nothing of this kind.
    if model.kind == ModelKind::Surface && totals.conflict > rule.max_conflict * seen {
        return Verdict::Conflicting;
    }
    if decided == 0 || (decided as f64) < MIN_DECIDED * seen {
        return Verdict::Unobserved;
    }
    let decided = decided as f64;
    if totals.pierced as f64 > 0.5 * decided {
        return Verdict::Absent;
    }
    let worst = faces.iter().any(|f| (well_seen(f, totals) && f.displaced) || mostly_refuted(f, totals));
    if worst || (totals.confirmed as f64) < rule.min_confirmed * decided {
        return Verdict::Deviating;
    }
    // What stays open is too rough or too noisy for this tolerance; the ray model leaves most open by its nature.
    if model.kind == ModelKind::Surface && (totals.confirmed as f64) < MIN_CONFIRMED_OF_SEEN * seen {
        return Verdict::Unobserved;
    }
    Verdict::Confirmed
}

fn well_seen(face: &FaceReport, totals: &Totals) -> bool {
    face.surface >= WELL_SEEN_SAMPLES.min(totals.surface)
        && face.surface as f64 >= WELL_SEEN_SHARE * totals.surface as f64
}

/// A face with a fair share of what was seen, most of it refuted: part of the object is not where it was drawn.
fn mostly_refuted(face: &FaceReport, totals: &Totals) -> bool {
    let decided = (face.confirmed + face.refuted) as f64;
    face.seen >= WELL_SEEN_SAMPLES
        && face.seen as f64 >= LARGE_FACE_SHARE * totals.seen as f64
        && decided >= 0.5 * face.seen as f64
        && face.refuted as f64 > 0.5 * decided
}

/// The well-seen face that is farthest off; the object is no better than it. Faces whose samples lie on one plane go
/// before those where they scatter.
fn worst_face<'a>(faces: &'a [FaceReport], totals: &Totals) -> Option<&'a FaceReport> {
    let off = |f: &FaceReport| (f.coherent, f.deviation.map_or(0.0, |d| d.0.abs()));
    let order = |a: &&FaceReport, b: &&FaceReport| {
        let (a, b) = (off(a), off(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    };
    faces.iter().filter(|f| f.deviation.is_some() && well_seen(f, totals)).max_by(order)
}
