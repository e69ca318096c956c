//! All that a verdict is made from, counted at one tolerance.

use super::counts::{Counts, is_well_seen};
use super::face_report::FaceReport;
use super::rule::VerdictRule;
use super::thresholds::{
    CERTAINLY_OFF, LARGE_SHARE, MAX_ON_SURFACE_OF_ABSENT, MIN_BESIDE, MIN_EMPTY, MIN_SEEN_THROUGH, WELL_SEEN_SAMPLES,
    WELL_SEEN_SHARE,
};
use crate::verify::evidence::FoundFace;
use crate::verify::model::EvidenceModel;
use crate::verify::surface::{FittedObject, FittedSurface};
use crate::{Interrupt, Result};

/// The counts of an object, and what is known of its surfaces beside them.
pub struct VerdictTally {
    pub faces: Vec<FaceReport>,
    pub totals: Counts,
    /// For each smooth surface.
    pub surfaces: Vec<Counts>,
    /// For each smooth surface whether too little of it keeps the tolerance.
    pub displaced: Vec<bool>,
    /// Whether the built surface as a whole is known to keep the tolerance.
    pub known_to_hold: bool,
    /// How many independent measurements show it.
    pub independent: f64,
    /// Displaced by its own thickness, no beam aimed at the object meets it.
    pub is_slim: bool,
    /// Samples in front of which something stands that is not the object's own surface.
    pub in_front_unexplained: u64,
    /// The face that a second look found elsewhere.
    pub found: Option<FoundFace>,
}

impl VerdictTally {
    /// Counts at the tolerance and confidence of `model`.
    pub fn of(fitted: &FittedObject, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<Self> {
        let faces = FaceReport::all(fitted, model, interrupt)?;
        let (mut totals, mut surfaces) = (Counts::default(), vec![Counts::default(); fitted.surfaces.len()]);
        for f in &faces {
            totals.add(&f.counts);
            if let Some(surface) = surfaces.get_mut(f.smooth_surface as usize) {
                surface.add(&f.counts);
            }
        }
        Ok(Self {
            displaced: displaced(&surfaces, &totals, fitted, rule.min_within),
            faces,
            totals,
            surfaces,
            known_to_hold: fitted.whole.is_known_to_hold(model.question.tolerance()),
            independent: fitted.whole.independent,
            is_slim: fitted.is_slim,
            in_front_unexplained: fitted.in_front_unexplained,
            found: fitted.found,
        })
    }

    /// The face that stands elsewhere, out of tolerance, if more of the object was found there than at its
    /// place. Metres.
    pub fn found_elsewhere(&self, tolerance: f64) -> Option<usize> {
        let more = |f: &FoundFace| f.deviation.abs() > tolerance && u64::from(f.samples) > self.totals.on_surface;
        self.found.filter(more).map(|f| f.face as usize)
    }

    /// Whether most of what is decided was seen empty, and little of the object.
    pub fn is_empty(&self) -> bool {
        let decided = self.totals.decided() as f64;
        self.totals.pierced as f64 > MIN_EMPTY * decided
            && (self.totals.on_surface as f64) < MAX_ON_SURFACE_OF_ABSENT * decided
    }

    /// Whether the place of a slim object is empty, and something that no other object explains stands beside it:
    /// itself, displaced by its thickness.
    pub fn is_beside(&self) -> bool {
        self.is_slim && self.is_empty() && self.in_front_unexplained as f64 >= MIN_BESIDE * self.totals.pierced as f64
    }

    /// A smooth surface with a fair share of the object and of what was seen, most of it not there: part of the object
    /// was not built. (Of the facets of a displaced column the lee ones are seen through, of a displaced board the
    /// narrow sides.)
    pub fn is_mostly_seen_through(&self, surface: &Counts) -> bool {
        let decided = (surface.confirmed.max(surface.on_surface) + surface.pierced) as f64;
        surface.seen >= WELL_SEEN_SAMPLES
            && surface.samples as f64 >= WELL_SEEN_SHARE * self.totals.samples as f64
            && surface.seen as f64 >= LARGE_SHARE * self.totals.seen as f64
            && decided >= MIN_SEEN_THROUGH * surface.seen as f64
            && surface.pierced as f64 > MIN_SEEN_THROUGH * decided
    }

    /// The face whose deviation stands for the object: the largest of those that are certainly off, else of all; so that
    /// it is the same one in every epoch. A displaced object is judged by what is.
    pub fn face_meant(&self) -> Option<usize> {
        let (totals, displaced) = (&self.totals, &self.displaced);
        let any = displaced.contains(&true);
        let judged = |f: &FaceReport| {
            let d = !any || displaced.get(f.smooth_surface as usize) == Some(&true);
            d && f.deviation.is_some() && f.counts.with_surface >= WELL_SEEN_SAMPLES.min(totals.with_surface)
        };
        let well_seen = |f: &FaceReport| is_well_seen(f.counts.with_surface, totals.with_surface);
        let certainly_off = |f: &FaceReport| f.deviation.is_some_and(|(d, sd)| d.abs() > CERTAINLY_OFF * sd);
        // A leaf may stand elsewhere, and a pane is met less surely.
        let firmness = |f: &FaceReport| std::cmp::Reverse(f.kind as u8);
        let order = |f: &FaceReport| (f.coherent, well_seen(f), firmness(f), certainly_off(f), f.counts.samples);
        let numbered = self.faces.iter().enumerate().filter(|(_, f)| judged(f));
        numbered.max_by(|(i, a), (j, b)| order(a).cmp(&order(b)).then(j.cmp(i))).map(|(i, _)| i)
    }
}

/// Share of a surface's samples that may lie out of tolerance: what the rule leaves, and two σ of chance.
pub fn allowed_out_of_tolerance(surface: &FittedSurface, min_within: f64) -> f64 {
    let share = 1.0 - min_within;
    share + 2.0 * (share * min_within / surface.independent.max(1.0)).sqrt()
}

/// For each smooth surface whether less than `min_within` of it keeps the tolerance; where that holds of the whole
/// object although of none of its surfaces, all.
fn displaced(surfaces: &[Counts], totals: &Counts, fitted: &FittedObject, min_within: f64) -> Vec<bool> {
    let off = |s: &FittedSurface, t: &Counts| {
        t.out_of_tolerance as f64 > allowed_out_of_tolerance(s, min_within) * t.on_surface as f64
    };
    let each = |(s, t): (&FittedSurface, &Counts)| is_well_seen(t.on_surface, totals.on_surface) && off(s, t);
    let out: Vec<bool> = fitted.surfaces.iter().zip(surfaces).map(each).collect();
    let whole = !out.contains(&true) && totals.on_surface > 0 && off(&fitted.whole, totals);
    if whole { vec![true; out.len()] } else { out }
}
