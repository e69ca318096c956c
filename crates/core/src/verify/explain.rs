//! The numbers that led to a verdict, in words.

use std::fmt::Write;

use super::built_surface::{Built, BuiltSurface};
use super::evidence::Evidence;
use super::model::{EvidenceModel, ModelKind};
use super::summary::{Summary, Totals, Verdict, VerdictRule};
use crate::evidence::Loa;
use crate::{Interrupt, Result};

impl Evidence {
    /// Why the verdict is what it is: what was seen, what that says, which threshold decided, why no finer class holds.
    pub fn explain(&self, model: &EvidenceModel, rule: &VerdictRule, interrupt: Interrupt) -> Result<String> {
        let summary = self.summary(model, rule, interrupt)?;
        let model = EvidenceModel { confidence: model.confidence, loa: model.loa, ..*self.model() };
        let built = Built::of(self, &model, interrupt)?;
        let totals = Totals::of(&built.faces(self, &model, interrupt)?);
        let mut out = format!(
            "{} at {} (±{} mm), model {}, confidence {}\n",
            summary.verdict.name(),
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
            out += &self.what_they_say(&totals, &model);
            out += &decision(&summary, &totals, rule);
        }
        if model.kind == ModelKind::Surface && totals.own > 0 {
            out += &surfaces(&built, &model, summary.best_loa);
        }
        Ok(out.trim_end().into())
    }

    fn what_they_say(&self, totals: &Totals, model: &EvidenceModel) -> String {
        let mut out = format!(
            "of these: {} confirmed, {} refuted, {} open\n",
            percent(totals.confirmed, totals.seen),
            percent(totals.refuted, totals.seen),
            percent(totals.seen - totals.confirmed - totals.refuted, totals.seen)
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
}

fn decision(summary: &Summary, totals: &Totals, rule: &VerdictRule) -> String {
    let here = totals.confirmed.max(totals.own - totals.beyond);
    let decided = here + totals.beyond + totals.pierced;
    let why = match summary.verdict {
        Verdict::Unobserved => "too little was seen, decided, or sure enough for this tolerance".into(),
        Verdict::Conflicting => format!("stations contradict each other by more than {}", rule.max_conflict),
        Verdict::Absent => {
            format!("{} of what is decided was seen empty, more than 60 %", percent(totals.pierced, decided))
        }
        Verdict::Deviating => format!(
            "a well-seen surface keeps the tolerance in less than {} of its places, a face is mostly not there, or too little \
            of what is decided ({}) is in place",
            percent_of(rule.min_confirmed.max(0.75)),
            percent(here, decided)
        ),
        Verdict::Confirmed => format!(
            "{} of what is decided is in place, and every well-seen surface keeps the tolerance in {} of its places",
            percent(here, decided),
            percent_of(rule.min_confirmed.max(0.75))
        ),
    };
    format!("because: {why}\n")
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
