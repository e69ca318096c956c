//! The verdict on an object.

use super::built_surface::{Built, BuiltSurface};
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
/// Share of the decided samples that must have been seen empty before the object is absent: more than half, for the
/// lee side of a displaced object is empty too.
const MIN_EMPTY: f64 = 0.6;
/// Least share of the seen samples that must say something; below it everything is open.
const MIN_DECIDED: f64 = 0.2;
/// Least share of the seen samples that must speak for the object before it is confirmed, where its surface as a whole
/// is not known.
const MIN_CONFIRMED_OF_SEEN: f64 = 0.5;
/// A surface counts as well seen with this share of the object's samples that have one.
const WELL_SEEN_SHARE: f64 = 0.03;
const WELL_SEEN_SAMPLES: u64 = 10;
/// Least share of a surface that must keep the tolerance before it counts as displaced, unless more is asked: a ceiling
/// of which a corner sags is still where it was drawn. [`Summary::best_loa`] asks for USIBD's 95 %.
const MIN_WITHIN: f64 = 0.75;
const MIN_WITHIN_USIBD: f64 = 0.95;
/// Least share of the decided samples that must show the object in place, however strict the rule is about where its
/// surfaces are: openings and furniture take the rest.
const MIN_PRESENT: f64 = 0.6;
/// A face with this share of the seen samples can condemn the object by being pierced.
const LARGE_FACE_SHARE: f64 = 0.1;
/// A face is certainly off when its deviation is this many σ: the largest of several that are not seldom is.
const CERTAINLY_OFF: f64 = 3.0;

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

/// The faces' counts added up.
pub(super) struct Totals {
    pub samples: u64,
    pub seen: u64,
    pub confirmed: u64,
    pub refuted: u64,
    pub pierced: u64,
    pub own: u64,
    pub beyond: u64,
    surface: u64,
    pub conflict: f64,
}

impl Totals {
    pub fn of(faces: &[FaceReport]) -> Self {
        let sum = |f: fn(&FaceReport) -> u64| faces.iter().map(f).sum();
        Self {
            samples: sum(|f| f.samples),
            seen: sum(|f| f.seen),
            confirmed: sum(|f| f.confirmed),
            refuted: sum(|f| f.refuted),
            pierced: sum(|f| f.pierced),
            own: sum(|f| f.own),
            beyond: sum(|f| f.beyond),
            surface: sum(|f| f.surface),
            conflict: faces.iter().map(|f| f.conflict).sum(),
        }
    }
}

impl Evidence {
    /// The verdict at the level of accuracy and confidence of `model`.
    pub fn verdict(&self, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<Verdict> {
        let model = self.question(model);
        let built = Built::of(self, &model, interrupt)?;
        let faces = built.faces(self, &model, interrupt)?;
        Ok(decide(&faces, &Totals::of(&faces), &built, &model, rule).0)
    }

    /// Every face as judged at the level of accuracy and confidence of `model`.
    pub fn faces(&self, model: &EvidenceModel, interrupt: Interrupt) -> Result<Vec<FaceReport>> {
        let model = self.question(model);
        Built::of(self, &model, interrupt)?.faces(self, &model, interrupt)
    }

    /// The rigid offset; `None` where no face determines one.
    pub fn rigid_shift(&self, interrupt: Interrupt) -> Result<Option<Shift>> {
        self.shift(&self.faces(&self.model, interrupt)?, &self.model, interrupt)
    }

    /// Verdict, shares, deviation, rigid offset and best level of accuracy.
    pub fn summary(&self, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<Summary> {
        let model = self.question(model);
        let built = Built::of(self, &model, interrupt)?;
        let faces = built.faces(self, &model, interrupt)?;
        let totals = Totals::of(&faces);
        let (verdict, displaced) = decide(&faces, &totals, &built, &model, rule);
        let best_loa = self.best_loa(&built, &model, verdict, covered(&totals, rule), rule, interrupt)?;
        let seen = totals.seen as f64;
        let shares = (totals.seen > 0).then(|| Shares {
            confirmed: totals.confirmed as f64 / seen,
            refuted: totals.refuted as f64 / seen,
            open: (totals.seen - totals.confirmed - totals.refuted) as f64 / seen,
            conflict: totals.conflict / seen,
        });
        // Surfaces met where an absent object should stand are not its own.
        let stands = verdict != Verdict::Absent && covered(&totals, rule);
        let deviation = worst_face(&faces, &totals, &displaced).filter(|_| stands).and_then(|f| f.deviation);
        let shift = if stands { self.shift(&faces, &model, interrupt)? } else { None };
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
        Ok(Shift::fit(faces, &SurfacePoints::of(self, interrupt)?, model))
    }

    /// Level of accuracy and confidence may be asked anew; how the sums were made may not.
    fn question(&self, asked: &EvidenceModel) -> EvidenceModel {
        EvidenceModel { confidence: asked.confidence, loa: asked.loa, ..self.model }
    }

    /// The finest class that would be confirmed and that the survey proves at the confidence.
    fn best_loa(
        &self,
        built: &Built,
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
            let model = EvidenceModel { loa, ..*model };
            let own = built.whole.own;
            let proven = |s: &BuiltSurface| !counts(s.own, own) || s.holds(loa.upper()) >= model.confidence;
            if !built.surfaces.iter().all(proven) || (own > 0 && built.whole.holds(loa.upper()) < model.confidence) {
                continue;
            }
            let faces = built.faces(self, &model, interrupt)?;
            let rule = VerdictRule { min_confirmed: rule.min_confirmed.max(MIN_WITHIN_USIBD), ..*rule };
            if decide(&faces, &Totals::of(&faces), built, &model, &rule).0 == Verdict::Confirmed {
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

/// The verdict, and for each smooth surface whether it is displaced.
fn decide(
    faces: &[FaceReport],
    totals: &Totals,
    built: &Built,
    model: &EvidenceModel,
    rule: &VerdictRule,
) -> (Verdict, Vec<bool>) {
    let displaced = displaced_surfaces(faces, totals, built, rule.min_confirmed.max(MIN_WITHIN));
    let verdict = verdict_of(faces, totals, built, displaced.contains(&true), model, rule);
    (verdict, displaced)
}

fn verdict_of(
    faces: &[FaceReport],
    totals: &Totals,
    built: &Built,
    displaced: bool,
    model: &EvidenceModel,
    rule: &VerdictRule,
) -> Verdict {
    let seen = totals.seen as f64;
    if !covered(totals, rule) {
        return Verdict::Unobserved;
    }
    // Before "undecided": contradiction is what leaves samples open. The ray model's conflict says nothing of this kind.
    if model.kind == ModelKind::Surface && totals.conflict > rule.max_conflict * seen {
        return Verdict::Conflicting;
    }
    // What speaks for the object where it was drawn, what shows it elsewhere, what shows that it is not there.
    let confirmed = (totals.own - totals.beyond).max(totals.confirmed);
    let (here, elsewhere, nothing) = (confirmed as f64, totals.beyond as f64, totals.pierced as f64);
    let decided = here + elsewhere + nothing;
    if decided == 0.0 || decided < MIN_DECIDED * seen {
        return Verdict::Unobserved;
    }
    if nothing > MIN_EMPTY * decided {
        return Verdict::Absent;
    }
    let least = rule.min_confirmed.min(MIN_PRESENT);
    if displaced || faces.iter().any(|f| mostly_pierced(f, totals)) || here < least * decided {
        return Verdict::Deviating;
    }
    // Too rough or too noisy for this tolerance; the ray model leaves most open by its nature.
    let known = built.whole.is_known_to_hold(model.tolerance());
    if model.kind == ModelKind::Surface && !known && (totals.confirmed as f64) < MIN_CONFIRMED_OF_SEEN * seen {
        return Verdict::Unobserved;
    }
    Verdict::Confirmed
}

/// Whether a part of the object's own samples is enough to count.
fn counts(part: u64, whole: u64) -> bool {
    part >= WELL_SEEN_SAMPLES.min(whole) && part as f64 >= WELL_SEEN_SHARE * whole as f64
}

/// For each smooth surface whether less than `min_within` of it keeps the tolerance; where that holds of the whole object
/// although of none of its surfaces, all.
fn displaced_surfaces(faces: &[FaceReport], totals: &Totals, built: &Built, min_within: f64) -> Vec<bool> {
    let mut sums = vec![(0, 0); built.surfaces.len()];
    for f in faces {
        if let Some(s) = sums.get_mut(f.smooth_surface as usize) {
            *s = (s.0 + f.own, s.1 + f.beyond);
        }
    }
    let allowed = |s: &BuiltSurface| {
        let share = 1.0 - min_within;
        share + 2.0 * (share * min_within / s.independent.max(1.0)).sqrt()
    };
    // Two σ of chance more than allowed.
    let off = |s: &BuiltSurface, own: u64, beyond: u64| beyond as f64 > allowed(s) * own as f64;
    let each = |(s, (own, beyond)): (&BuiltSurface, &(u64, u64))| counts(*own, totals.own) && off(s, *own, *beyond);
    let mut out: Vec<bool> = built.surfaces.iter().zip(&sums).map(each).collect();
    if !out.contains(&true) && totals.own > 0 && off(&built.whole, totals.own, totals.beyond) {
        out.iter_mut().for_each(|o| *o = true);
    }
    out
}

/// A face with a fair share of what was seen, most of it not there: part of the object was not built.
fn mostly_pierced(face: &FaceReport, totals: &Totals) -> bool {
    let decided = (face.confirmed.max(face.own) + face.pierced) as f64;
    face.seen >= WELL_SEEN_SAMPLES
        && face.seen as f64 >= LARGE_FACE_SHARE * totals.seen as f64
        && decided >= 0.5 * face.seen as f64
        && face.pierced as f64 > 0.5 * decided
}

/// The face whose deviation stands for the object: of those that are certainly off the farthest, else the largest.
/// Taking the farthest of all would report noise wherever nothing is off. A displaced object is judged by what is.
fn worst_face<'a>(faces: &'a [FaceReport], totals: &Totals, displaced: &[bool]) -> Option<&'a FaceReport> {
    let any = displaced.contains(&true);
    let judged = |f: &&FaceReport| {
        let d = !any || displaced.get(f.smooth_surface as usize) == Some(&true);
        d && f.deviation.is_some() && f.surface >= WELL_SEEN_SAMPLES.min(totals.surface)
    };
    let certainly_off = |f: &FaceReport| {
        f.deviation.map_or(0.0, |(d, sd)| if any || d.abs() > CERTAINLY_OFF * sd { d.abs() } else { 0.0 })
    };
    let order = |a: &&FaceReport, b: &&FaceReport| {
        a.coherent
            .cmp(&b.coherent)
            .then(well_seen(a, totals).cmp(&well_seen(b, totals)))
            .then(certainly_off(a).total_cmp(&certainly_off(b)))
            .then(a.surface.cmp(&b.surface))
    };
    faces.iter().filter(judged).max_by(order)
}

fn well_seen(face: &FaceReport, totals: &Totals) -> bool {
    counts(face.surface, totals.surface)
}
