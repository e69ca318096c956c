//! The finest class that an object keeps.

use super::counts::is_well_seen;
use super::inquiry::Inquiry;
use super::judgement::Judgement;
use super::rule::{Verdict, VerdictRule};
use crate::evidence::Loa;
use crate::verify::model::{EvidenceModel, Question, measures_deviations};
use crate::verify::surface::{FittedObject, FittedSurface};
use crate::{Interrupt, Result};

/// The finest class that would be confirmed, and that the survey proves at the confidence. Of the class that is asked
/// the verdict says whether it holds.
pub fn best_loa(
    inquiry: &Inquiry,
    question: &Question,
    rule: &VerdictRule,
    interrupt: Interrupt,
) -> Result<Option<Loa>> {
    let Inquiry { model, fitted, judgement } = inquiry;
    if !judgement.stands(rule) {
        return Ok(None);
    }
    if !measures_deviations(model) {
        // Its masses do not know the tolerance.
        return Ok((judgement.verdict() == Verdict::Confirmed).then_some(model.question.loa));
    }
    let asked = model.question.loa;
    for loa in Loa::ALL.into_iter().rev() {
        let model = EvidenceModel { question: Question { loa, ..model.question }, ..*model };
        let holds = if loa == asked {
            judgement.verdict() == Verdict::Confirmed
        } else {
            is_proven(fitted, loa.upper(), question.confidence)
                && Judgement::of(fitted, &model, rule, interrupt)?.verdict() == Verdict::Confirmed
        };
        if holds {
            return Ok(Some(loa));
        }
    }
    Ok(None)
}

/// Whether every well-seen surface, and all as one, keep ±`tolerance` metres with this probability.
fn is_proven(fitted: &FittedObject, tolerance: f64, probability: f64) -> bool {
    let all = fitted.whole.inliers;
    let holds = |s: &FittedSurface| s.holds(tolerance) >= probability;
    fitted.surfaces.iter().all(|s| !is_well_seen(s.inliers, all) || holds(s)) && (all == 0 || holds(&fitted.whole))
}
