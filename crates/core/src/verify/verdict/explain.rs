//! The numbers that led to a verdict, in words.

use std::fmt::Write;

use super::best_loa::best_loa;
use super::counts::Counts;
use super::judgement::Judgement;
use super::reason::Reason;
use super::rule::VerdictRule;
use super::tally::allowed_out_of_tolerance;
use super::thresholds::{MAX_ON_SURFACE_OF_ABSENT, MIN_CONFIRMED_OF_SEEN, MIN_DECIDED, MIN_EMPTY};
use crate::evidence::Loa;
use crate::verify::evidence::Evidence;
use crate::verify::model::{EvidenceModel, Question, measures_deviations};
use crate::verify::surface::{FittedObject, FittedSurface};
use crate::{Interrupt, Result};

impl Evidence {
    /// Why the verdict is what it is: what was seen, what that says, which threshold decided, why no finer class holds.
    pub fn explain(&self, question: &Question, rule: &VerdictRule, interrupt: Interrupt) -> Result<String> {
        let model = self.asked(question);
        let fitted = FittedObject::of(self, &model, interrupt)?;
        let judgement = Judgement::of(&fitted, &model, rule, interrupt)?;
        let best_loa = best_loa(&fitted, &judgement, &model, rule, interrupt)?;
        let explanation = Explanation { judgement: &judgement, fitted: &fitted, model: &model, rule };
        let totals = &judgement.tally.totals;
        let mut out = explanation.head(self.stations().len());
        if totals.seen > 0 {
            out += &what_they_say(totals, &model);
            let _ = writeln!(out, "because: {}", explanation.because());
        }
        if measures_deviations(&model) && totals.on_surface > 0 {
            out += &explanation.surfaces(best_loa);
        }
        Ok(out.trim_end().into())
    }
}

fn what_they_say(totals: &Counts, model: &EvidenceModel) -> String {
    let mut out = format!(
        "of these: {} confirmed, {} refuted, {} open\n",
        percent(totals.confirmed, totals.seen),
        percent(totals.refuted, totals.seen),
        percent(totals.open(), totals.seen)
    );
    if measures_deviations(model) {
        let _ = writeln!(
            out,
            "the object's own surface: {} samples, {} of them beyond the tolerance; seen empty: {}; \
            other things in front, or too unsure: {}",
            totals.on_surface,
            percent(totals.out_of_tolerance, totals.on_surface),
            totals.pierced,
            totals.seen.saturating_sub(totals.on_surface + totals.pierced)
        );
        let _ = writeln!(out, "conflict between stations: {:.3}", totals.conflict / totals.seen as f64);
    }
    out
}

/// What is to be explained.
struct Explanation<'a> {
    judgement: &'a Judgement,
    fitted: &'a FittedObject,
    model: &'a EvidenceModel,
    rule: &'a VerdictRule,
}

impl Explanation<'_> {
    fn head(&self, stations: usize) -> String {
        let (totals, model) = (&self.judgement.tally.totals, self.model);
        format!(
            "{} at {} (±{} mm), model {}, confidence {}\n\
            seen: {} of {} samples ({}) by {stations} stations; least for a verdict {}\n",
            self.judgement.verdict().name(),
            model.question.loa.name(),
            self.tolerance_mm(),
            model.kind.name(),
            model.question.confidence,
            totals.seen,
            totals.samples,
            percent(totals.seen, totals.samples),
            percent_of(self.rule.min_coverage)
        )
    }

    fn tolerance_mm(&self) -> f64 {
        self.model.question.tolerance() * 1e3
    }

    fn because(&self) -> String {
        let (totals, rule) = (&self.judgement.tally.totals, self.rule);
        let empty = percent(totals.pierced, totals.decided());
        match self.judgement.reason {
            Reason::TooLittleSeen => format!("less was seen than {}", percent_of(rule.min_coverage)),
            Reason::Contradiction => format!("stations contradict each other by more than {}", rule.max_conflict),
            Reason::TooLittleDecided => format!(
                "only {} of what was seen says anything, less than {}",
                percent(totals.decided(), totals.seen),
                percent_of(MIN_DECIDED)
            ),
            Reason::Empty => format!(
                "{empty} of what is decided was seen empty, more than {}; \
                the object's own surface is less than {} of it",
                percent_of(MIN_EMPTY),
                percent_of(MAX_ON_SURFACE_OF_ABSENT)
            ),
            Reason::Beside => format!(
                "{empty} of what is decided was seen empty, \
                but something that no other object explains stands beside it"
            ),
            Reason::Displaced(surface) => self.displaced(surface),
            Reason::SeenThrough(surface) => self.seen_through(surface),
            Reason::OutOfPlace => format!(
                "{} of what is decided is in place, less than {}",
                percent(totals.in_place(), totals.decided()),
                percent_of(rule.min_present)
            ),
            Reason::TooUnsure => self.too_unsure(),
            Reason::InPlace => self.in_place(),
        }
    }

    fn displaced(&self, surface: usize) -> String {
        let (counts, within) = (&self.judgement.tally.surfaces[surface], self.rule.min_within);
        format!(
            "{} of {} keeps ±{} mm, less than {} (less {} for chance)",
            percent_of(1.0 - counts.out_of_tolerance as f64 / counts.on_surface.max(1) as f64),
            self.looking(surface),
            self.tolerance_mm(),
            percent_of(within),
            percent_of(allowed_out_of_tolerance(&self.fitted.surfaces[surface], within) - (1.0 - within))
        )
    }

    fn seen_through(&self, surface: usize) -> String {
        let counts = &self.judgement.tally.surfaces[surface];
        format!(
            "{} samples of {} were seen empty, {} show it: part of the object is not there",
            counts.pierced,
            self.looking(surface),
            counts.confirmed.max(counts.on_surface)
        )
    }

    fn too_unsure(&self) -> String {
        format!(
            "what was seen is in place, but not known well enough for ±{} mm (σ {:.1} mm), and less than {} of it \
            is confirmed sample by sample",
            self.tolerance_mm(),
            self.fitted.whole.sd * 1e3,
            percent_of(MIN_CONFIRMED_OF_SEEN)
        )
    }

    fn in_place(&self) -> String {
        let totals = &self.judgement.tally.totals;
        format!(
            "{} of what is decided is in place, and every well-seen surface keeps ±{} mm in {} of its \
            places, but for chance",
            percent(totals.in_place(), totals.decided()),
            self.tolerance_mm(),
            percent_of(self.rule.min_within)
        )
    }

    /// A smooth surface by where its largest face looks.
    fn looking(&self, surface: usize) -> String {
        let faces = self.judgement.tally.faces.iter().filter(|f| f.smooth_surface as usize == surface);
        let count = faces.clone().count();
        let n = faces.max_by_key(|f| f.counts.seen).map_or_else(Default::default, |f| f.normal);
        let what = if count == 1 { "the face".into() } else { format!("the surface of {count} faces") };
        format!("{what} that looks towards ({:.2}, {:.2}, {:.2})", n.x, n.y, n.z)
    }

    /// How well the surfaces are known, and why no finer class than `best` holds.
    fn surfaces(&self, best: Option<Loa>) -> String {
        let FittedObject { surfaces, whole, .. } = self.fitted;
        let seen = surfaces.iter().filter(|s| s.inliers > 0).count();
        let worst = surfaces.iter().filter(|s| s.inliers > 0).max_by(|a, b| a.quantile.total_cmp(&b.quantile));
        let mut out = format!("all {seen} surfaces seen: {}\n", bounds(whole));
        if let Some(worst) = worst {
            let _ = writeln!(out, "the worst of them ({} samples): {}", worst.inliers, bounds(worst));
        }
        let finer = Loa::ALL.into_iter().find(|l| best.is_none_or(|b| *l > b));
        let _ = writeln!(out, "best level of accuracy: {}", best.map_or("none", Loa::name));
        if let (Some(finer), Some(worst)) = (finer, worst) {
            let _ = writeln!(
                out,
                "{} (±{} mm in 95 % of the places) holds with probability {:.3} for the worst surface, {:.3} for all; \
                {} is asked",
                finer.name(),
                finer.upper() * 1e3,
                worst.holds(finer.upper()),
                whole.holds(finer.upper()),
                self.model.question.confidence
            );
        }
        out
    }
}

fn bounds(s: &FittedSurface) -> String {
    format!("95 % within {:.1} mm, σ {:.1} mm", s.quantile * 1e3, s.sd * 1e3)
}

fn percent(part: u64, whole: u64) -> String {
    percent_of(part as f64 / whole.max(1) as f64)
}

fn percent_of(share: f64) -> String {
    format!("{} %", (share * 1e3).round() / 10.0)
}
