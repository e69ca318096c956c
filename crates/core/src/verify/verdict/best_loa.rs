//! The finest class that an object keeps.

use super::counts::is_well_seen;
use super::judgement::Judgement;
use super::rule::{Verdict, VerdictRule};
use super::thresholds::MIN_WITHIN_USIBD;
use crate::evidence::Loa;
use crate::verify::model::{EvidenceModel, Question, measures_deviations};
use crate::verify::surface::{FittedObject, FittedSurface};
use crate::{Interrupt, Result};

/// The finest class that would be confirmed, 95 % of every surface within it (USIBD), and that the survey proves at the
/// confidence.
pub fn best_loa(
    fitted: &FittedObject,
    judgement: &Judgement,
    model: &EvidenceModel,
    rule: &VerdictRule,
    interrupt: Interrupt,
) -> Result<Option<Loa>> {
    if !judgement.stands(rule) {
        return Ok(None);
    }
    if !measures_deviations(model) {
        // Its masses do not know the tolerance.
        return Ok((judgement.verdict() == Verdict::Confirmed).then_some(model.question.loa));
    }
    let rule = VerdictRule { min_within: rule.min_within.max(MIN_WITHIN_USIBD), ..*rule };
    for loa in Loa::ALL.into_iter().rev() {
        let model = EvidenceModel { question: Question { loa, ..model.question }, ..*model };
        let proven = || is_proven(fitted, loa.upper(), model.question.confidence);
        if proven() && Judgement::of(fitted, &model, &rule, interrupt)?.verdict() == Verdict::Confirmed {
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
