//! The numbers that led to a verdict, in words.

use std::fmt::Write;

use super::built_surface::{Built, BuiltSurface};
use super::evidence::Evidence;
use super::face::Counts;
use super::judgement::{
    Judgement, MAX_OWN_OF_ABSENT, MIN_CONFIRMED_OF_SEEN, MIN_DECIDED, MIN_EMPTY, MIN_PRESENT, Reason,
};
use super::model::{EvidenceModel, ModelKind};
use super::summary::{VerdictRule, best_loa};
use crate::evidence::Loa;
use crate::{Interrupt, Result};

impl Evidence {
    /// Why the verdict is what it is: what was seen, what that says, which threshold decided, why no finer class holds.
    pub fn explain(&self, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<String> {
        let model = self.question(model);
        let built = Built::of(self, &model, interrupt)?;
        let judgement = Judgement::of(&built, &model, rule, interrupt)?;
        let best_loa = best_loa(&built, &judgement, &model, rule, interrupt)?;
        let totals = &judgement.totals;
        let mut out = format!(
            "{} at {} (±{} mm), model {}, confidence {}\n",
            judgement.verdict().name(),
            model.loa.name(),
            model.tolerance() * 1e3,
            model.kind.name(),
            model.confidence
        );
        let _ = writeln!(
            out,
            "seen: {} of {} samples ({}) by {} stations; least for a verdict {}",
            totals.seen,
            totals.samples,
            percent(totals.seen, totals.samples),
            self.stations().len(),
            percent_of(rule.min_coverage)
        );
        if totals.seen > 0 {
            out += &what_they_say(totals, &model);
            out += &decision(&judgement, &built, &model, rule);
        }
        if model.kind == ModelKind::Surface && totals.own > 0 {
            out += &surfaces(&built, &model, best_loa);
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
    if model.kind == ModelKind::Surface {
        let _ = writeln!(
            out,
            "the object's own surface: {} samples, {} of them beyond the tolerance; seen empty: {}; other things in front, \
            or too unsure: {}",
            totals.own,
            percent(totals.beyond, totals.own),
            totals.pierced,
            totals.seen.saturating_sub(totals.own + totals.pierced)
        );
        let _ = writeln!(out, "conflict between stations: {:.3}", totals.conflict / totals.seen as f64);
    }
    out
}

fn decision(judgement: &Judgement, built: &Built, model: &EvidenceModel, rule: &VerdictRule) -> String {
    let totals = &judgement.totals;
    let (decided, within) = (totals.decided(), rule.min_within());
    let (in_place, empty) = (percent(totals.in_place(), decided), percent(totals.pierced, decided));
    let tolerance = model.tolerance() * 1e3;
    let because = match judgement.reason {
        Reason::TooLittleSeen => format!("less was seen than {}", percent_of(rule.min_coverage)),
        Reason::Contradiction => format!("stations contradict each other by more than {}", rule.max_conflict),
        Reason::TooLittleDecided => format!(
            "only {} of what was seen says anything, less than {}",
            percent(decided, totals.seen),
            percent_of(MIN_DECIDED)
        ),
        Reason::Empty => format!(
            "{empty} of what is decided was seen empty, more than {}; the object's own surface is less than {} of it",
            percent_of(MIN_EMPTY),
            percent_of(MAX_OWN_OF_ABSENT)
        ),
        Reason::Beside => format!(
            "{empty} of what is decided was seen empty, but something that no other object explains stands beside it"
        ),
        Reason::Displaced(s) => format!(
            "{} of {} keeps ±{tolerance} mm, less than {} (less {} for chance)",
            percent_of(1.0 - judgement.surfaces[s].beyond as f64 / judgement.surfaces[s].own.max(1) as f64),
            looking(judgement, s),
            percent_of(within),
            percent_of(built.surfaces[s].allowed_beyond(within) - (1.0 - within))
        ),
        Reason::Pierced(s) => format!(
            "{} samples of {} were seen empty, {} show it: part of the object is not there",
            judgement.surfaces[s].pierced,
            looking(judgement, s),
            judgement.surfaces[s].confirmed.max(judgement.surfaces[s].own)
        ),
        Reason::OutOfPlace => format!(
            "{in_place} of what is decided is in place, less than {}",
            percent_of(rule.min_confirmed.min(MIN_PRESENT))
        ),
        Reason::TooUnsure => format!(
            "what was seen is in place, but not known well enough for ±{tolerance} mm (σ {:.1} mm), and less than {} of it \
            is confirmed sample by sample",
            built.whole.sd * 1e3,
            percent_of(MIN_CONFIRMED_OF_SEEN)
        ),
        Reason::InPlace => format!(
            "{in_place} of what is decided is in place, and every well-seen surface keeps ±{tolerance} mm in {} of its \
            places, but for chance",
            percent_of(within)
        ),
    };
    format!("because: {because}\n")
}

/// A smooth surface by where its largest face looks.
fn looking(judgement: &Judgement, surface: usize) -> String {
    let own = judgement.faces.iter().filter(|f| f.smooth_surface as usize == surface);
    let count = own.clone().count();
    let n = own.max_by_key(|f| f.counts.seen).map_or_else(Default::default, |f| f.normal);
    let what = if count == 1 { "the face".into() } else { format!("the surface of {count} faces") };
    format!("{what} that looks towards ({:.2}, {:.2}, {:.2})", n.x, n.y, n.z)
}

fn surfaces(built: &Built, model: &EvidenceModel, best: Option<Loa>) -> String {
    let seen = built.surfaces.iter().filter(|s| s.own > 0).count();
    let worst = built.surfaces.iter().filter(|s| s.own > 0).max_by(|a, b| a.quantile.total_cmp(&b.quantile));
    let mut out = String::new();
    let line = |s: &BuiltSurface| {
        format!("95 % within {:.1} mm, 75 % within {:.1} mm, σ {:.1} mm", s.quantile * 1e3, s.bulk * 1e3, s.sd * 1e3)
    };
    let _ = writeln!(out, "all {seen} surfaces seen: {}", line(&built.whole));
    if let Some(worst) = worst {
        let _ = writeln!(out, "the worst of them ({} samples): {}", worst.own, line(worst));
    }
    let finer = Loa::ALL.into_iter().find(|l| best.is_none_or(|b| *l > b));
    let _ = writeln!(out, "best level of accuracy: {}", best.map_or("none", Loa::name));
    if let (Some(finer), Some(worst)) = (finer, worst) {
        let _ = writeln!(
            out,
            "{} (±{} mm in 95 % of the places) holds with probability {:.3} for the worst surface, {:.3} for all; {} is asked",
            finer.name(),
            finer.upper() * 1e3,
            worst.holds(finer.upper()),
            built.whole.holds(finer.upper()),
            model.confidence
        );
    }
    out
}

fn percent(part: u64, whole: u64) -> String {
    percent_of(part as f64 / whole.max(1) as f64)
}

fn percent_of(share: f64) -> String {
    format!("{} %", (share * 1e3).round() / 10.0)
}
