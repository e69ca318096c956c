//! How the counts of an object's faces become a verdict.

use super::built_surface::{Built, BuiltSurface};
use super::face::{Counts, FaceReport};
use super::model::{EvidenceModel, ModelKind};
use super::summary::{Verdict, VerdictRule};
use crate::{Interrupt, Result};

/// Least number of seen samples for a verdict.
const MIN_SEEN: u64 = 5;
/// Share of the decided samples that must have been seen empty before the object is absent: more than half, for the
/// lee side of a displaced object is empty too.
pub(super) const MIN_EMPTY: f64 = 0.6;
/// … but not where as much of the decided shows the object's own surface, in place or not: it was built in part, or
/// displaced by more than it is thick.
pub(super) const MAX_OWN_OF_ABSENT: f64 = 0.25;
/// A slim object stands beside its place when something was met off as many samples as this share of the empty ones.
const MIN_BESIDE: f64 = 0.2;
/// Least share of the seen samples that must say something; below it everything is open.
pub(super) const MIN_DECIDED: f64 = 0.2;
/// Least share of the seen samples that must speak for the object before it is confirmed, where its surface as a whole
/// is not known.
pub(super) const MIN_CONFIRMED_OF_SEEN: f64 = 0.5;
/// A surface counts as well seen with this share of the object's samples that have one.
const WELL_SEEN_SHARE: f64 = 0.03;
const WELL_SEEN_SAMPLES: u64 = 10;
/// Least share of a surface that must keep the tolerance before it counts as displaced, unless more is asked: a ceiling
/// of which a corner sags is still where it was drawn. [`Summary::best_loa`](super::Summary::best_loa) asks for 95 %.
const MIN_WITHIN: f64 = 0.75;
/// Least share of the decided samples that must show the object in place, however strict the rule is about where its
/// surfaces are: openings and furniture take the rest.
pub(super) const MIN_PRESENT: f64 = 0.6;
/// A smooth surface with this share of the seen samples can condemn the object by being pierced.
const LARGE_SHARE: f64 = 0.1;
/// A face is certainly off when its deviation is this many σ: the largest of several that are not seldom is.
const CERTAINLY_OFF: f64 = 3.0;

/// What decides; surfaces by number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reason {
    /// Fewer samples were seen than the rule asks for.
    TooLittleSeen,
    /// Stations contradict each other.
    Contradiction,
    /// Too few of the seen samples say anything.
    TooLittleDecided,
    /// The object's space was seen empty.
    Empty,
    /// It was, and something that no other object explains stands beside it.
    Beside,
    /// This surface keeps the tolerance in too few of its places.
    Displaced(usize),
    /// This surface is mostly not there.
    Pierced(usize),
    /// Too little of what is decided is in place.
    OutOfPlace,
    /// In place, but not known well enough for the tolerance.
    TooUnsure,
    /// In place.
    InPlace,
}

impl Reason {
    pub fn verdict(self) -> Verdict {
        match self {
            Self::TooLittleSeen | Self::TooLittleDecided | Self::TooUnsure => Verdict::Unobserved,
            Self::Contradiction => Verdict::Conflicting,
            Self::Empty => Verdict::Absent,
            Self::Beside | Self::Displaced(_) | Self::Pierced(_) | Self::OutOfPlace => Verdict::Deviating,
            Self::InPlace => Verdict::Confirmed,
        }
    }
}

/// A verdict with all that it was made from.
pub(super) struct Judgement {
    pub reason: Reason,
    pub faces: Vec<FaceReport>,
    pub totals: Counts,
    /// For each smooth surface.
    pub surfaces: Vec<Counts>,
    /// For each smooth surface whether too little of it keeps the tolerance.
    displaced: Vec<bool>,
}

impl Counts {
    /// Whether enough was seen to judge at all.
    pub(super) fn cover(&self, rule: &VerdictRule) -> bool {
        self.seen > 0
            && self.seen >= MIN_SEEN.min(self.samples)
            && self.seen as f64 >= rule.min_coverage * self.samples as f64
    }

    /// Samples that speak for the object where it was drawn; [`Counts::beyond`] show it elsewhere,
    /// [`Counts::pierced`] that it is not there.
    pub(super) fn in_place(&self) -> u64 {
        (self.own - self.beyond).max(self.confirmed)
    }

    /// Samples that say one of the three.
    pub(super) fn decided(&self) -> u64 {
        self.in_place() + self.beyond + self.pierced
    }
}

impl VerdictRule {
    /// Share of a well-seen surface that must keep the tolerance.
    pub(super) fn min_within(&self) -> f64 {
        self.min_confirmed.max(MIN_WITHIN)
    }
}

impl Judgement {
    pub fn verdict(&self) -> Verdict {
        self.reason.verdict()
    }

    /// Judges at the tolerance and confidence of `model`.
    pub fn of(built: &Built, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<Self> {
        let faces = built.faces(model, interrupt)?;
        let (mut totals, mut surfaces) = (Counts::default(), vec![Counts::default(); built.surfaces.len()]);
        for f in &faces {
            totals.add(&f.counts);
            if let Some(surface) = surfaces.get_mut(f.smooth_surface as usize) {
                surface.add(&f.counts);
            }
        }
        let displaced = displaced(&surfaces, &totals, built, rule.min_within());
        let mut out = Self { reason: Reason::TooLittleSeen, faces, totals, surfaces, displaced };
        out.reason = out.decide(built, model, rule);
        Ok(out)
    }

    fn decide(&self, built: &Built, model: &EvidenceModel, rule: &VerdictRule) -> Reason {
        let totals = &self.totals;
        let (seen, decided) = (totals.seen as f64, totals.decided() as f64);
        if !totals.cover(rule) {
            return Reason::TooLittleSeen;
        }
        // Before "undecided": contradiction is what leaves samples open. The ray model's conflict says nothing of this
        // kind.
        if model.kind == ModelKind::Surface && totals.conflict > rule.max_conflict * seen {
            return Reason::Contradiction;
        }
        if decided == 0.0 || decided < MIN_DECIDED * seen {
            return Reason::TooLittleDecided;
        }
        if self.is_empty() {
            return if self.is_beside(built) { Reason::Beside } else { Reason::Empty };
        }
        if let Some(surface) = self.displaced.iter().position(|d| *d) {
            return Reason::Displaced(surface);
        }
        if let Some(surface) = self.surfaces.iter().position(|s| mostly_pierced(s, totals)) {
            return Reason::Pierced(surface);
        }
        if (totals.in_place() as f64) < rule.min_confirmed.min(MIN_PRESENT) * decided {
            return Reason::OutOfPlace;
        }
        // Too rough or too noisy for this tolerance; the ray model leaves most open by its nature.
        let known = built.whole.is_known_to_hold(model.tolerance());
        if model.kind == ModelKind::Surface && !known && (totals.confirmed as f64) < MIN_CONFIRMED_OF_SEEN * seen {
            return Reason::TooUnsure;
        }
        Reason::InPlace
    }

    /// Whether the object stands where its faces tell: surfaces met where an absent object should stand are not its own,
    /// and what stands beside its place does not tell how far off it is.
    pub fn stands(&self, built: &Built, rule: &VerdictRule) -> bool {
        self.verdict() != Verdict::Absent && !self.is_beside(built) && self.totals.cover(rule)
    }

    /// Whether the place of a slim object is empty, and something that no other object explains stands beside it:
    /// itself, displaced by its thickness.
    fn is_beside(&self, built: &Built) -> bool {
        built.is_slim && self.is_empty() && built.before as f64 >= MIN_BESIDE * self.totals.pierced as f64
    }

    /// Whether most of what is decided was seen empty, and little of the object.
    fn is_empty(&self) -> bool {
        let decided = self.totals.decided() as f64;
        self.totals.pierced as f64 > MIN_EMPTY * decided && (self.totals.own as f64) < MAX_OWN_OF_ABSENT * decided
    }

    /// The face whose deviation stands for the object: of those that are certainly off the farthest, else the largest.
    /// Taking the farthest of all would report noise wherever nothing is off. A displaced object is judged by what is.
    pub fn worst_face(&self) -> Option<&FaceReport> {
        let (totals, displaced) = (&self.totals, &self.displaced);
        let any = displaced.contains(&true);
        let judged = |f: &&FaceReport| {
            let d = !any || displaced.get(f.smooth_surface as usize) == Some(&true);
            d && f.deviation.is_some() && f.counts.surface >= WELL_SEEN_SAMPLES.min(totals.surface)
        };
        let well_seen = |f: &FaceReport| counts(f.counts.surface, totals.surface);
        let certainly_off = |f: &FaceReport| {
            f.deviation.map_or(0.0, |(d, sd)| if any || d.abs() > CERTAINLY_OFF * sd { d.abs() } else { 0.0 })
        };
        let order = |a: &&FaceReport, b: &&FaceReport| {
            a.coherent
                .cmp(&b.coherent)
                .then(well_seen(a).cmp(&well_seen(b)))
                .then(certainly_off(a).total_cmp(&certainly_off(b)))
                .then(a.counts.surface.cmp(&b.counts.surface))
        };
        self.faces.iter().filter(judged).max_by(order)
    }
}

impl Built {
    /// Whether every well-seen surface, and all as one, keep ±`tolerance` metres with this probability.
    pub(super) fn is_proven(&self, tolerance: f64, probability: f64) -> bool {
        let own = self.whole.own;
        let holds = |s: &BuiltSurface| s.holds(tolerance) >= probability;
        self.surfaces.iter().all(|s| !counts(s.own, own) || holds(s)) && (own == 0 || holds(&self.whole))
    }
}

impl BuiltSurface {
    /// Share of its samples that may lie beyond the tolerance: what the rule leaves, and two σ of chance.
    pub(super) fn allowed_beyond(&self, min_within: f64) -> f64 {
        let share = 1.0 - min_within;
        share + 2.0 * (share * min_within / self.independent.max(1.0)).sqrt()
    }
}

/// Whether a part of the object's own samples is enough to count.
fn counts(part: u64, whole: u64) -> bool {
    part >= WELL_SEEN_SAMPLES.min(whole) && part as f64 >= WELL_SEEN_SHARE * whole as f64
}

/// For each smooth surface whether less than `min_within` of it keeps the tolerance; where that holds of the whole object
/// although of none of its surfaces, all.
fn displaced(surfaces: &[Counts], totals: &Counts, built: &Built, min_within: f64) -> Vec<bool> {
    let off = |s: &BuiltSurface, t: &Counts| t.beyond as f64 > s.allowed_beyond(min_within) * t.own as f64;
    let each = |(s, t): (&BuiltSurface, &Counts)| counts(t.own, totals.own) && off(s, t);
    let mut out: Vec<bool> = built.surfaces.iter().zip(surfaces).map(each).collect();
    if !out.contains(&true) && totals.own > 0 && off(&built.whole, totals) {
        out.iter_mut().for_each(|o| *o = true);
    }
    out
}

/// A smooth surface with a fair share of the object and of what was seen, most of it not there: part of the object was
/// not built. (Of the facets of a displaced column the lee ones are pierced, of a displaced board the narrow sides.)
fn mostly_pierced(surface: &Counts, totals: &Counts) -> bool {
    let decided = (surface.confirmed.max(surface.own) + surface.pierced) as f64;
    surface.seen >= WELL_SEEN_SAMPLES
        && surface.samples as f64 >= WELL_SEEN_SHARE * totals.samples as f64
        && surface.seen as f64 >= LARGE_SHARE * totals.seen as f64
        && decided >= 0.5 * surface.seen as f64
        && surface.pierced as f64 > 0.5 * decided
}
