//! An object fitted and judged as a question asks; and, where few beams told of each of its places, once more from all
//! of them together.

use super::judgement::Judgement;
use super::reason::Reason;
use super::rule::{Verdict, VerdictRule};
use super::thresholds::{CONFIDENCE_TOGETHER, MIN_INDEPENDENT_TOGETHER, MIN_UNANIMOUS};
use crate::verify::evidence::{Evidence, StationOrigin};
use crate::verify::model::{BEAMS_IN_KERNEL, EvidenceModel, Question, measures_deviations};
use crate::verify::surface::FittedObject;
use crate::{Interrupt, Result};

/// An object fitted and judged.
pub struct Inquiry {
    /// With the confidence at which its places are counted.
    pub model: EvidenceModel,
    pub fitted: FittedObject,
    pub judgement: Judgement,
}

impl Inquiry {
    /// Judges at the question's confidence. On what is narrower than the beams lie apart (a window's frame, a rail) no
    /// place ever reaches it, however many beams meet the object: then a place counts from [`CONFIDENCE_TOGETHER`] on, and
    /// the object is `confirmed` or `absent` where many independent beams say so, and hardly any other.
    pub fn of(evidence: &Evidence, question: &Question, rule: &VerdictRule, interrupt: Interrupt) -> Result<Self> {
        let alone = Self::at(evidence, question, rule, interrupt)?;
        let are_few = matches!(alone.judgement.reason, Reason::TooLittleSeen | Reason::TooFewMeasured);
        // Without an origin nobody knows which beams are independent.
        let are_known = evidence.stations().iter().all(|s| matches!(s.place, StationOrigin::At(_)));
        if !(are_few && are_known && may_count_together(&alone.model)) {
            return Ok(alone);
        }
        let question = Question { confidence: CONFIDENCE_TOGETHER, ..*question };
        let together = Self::at(evidence, &question, rule, interrupt)?;
        Ok(if together.is_unanimous() { together } else { alone })
    }

    fn at(evidence: &Evidence, question: &Question, rule: &VerdictRule, interrupt: Interrupt) -> Result<Self> {
        let model = evidence.asked(question);
        let fitted = FittedObject::of(evidence, &model, interrupt)?;
        let judgement = Judgement::of(&fitted, &model, rule, interrupt)?;
        Ok(Self { model, fitted, judgement })
    }

    /// Whether nearly all that was seen says the same, and enough measurements did.
    fn is_unanimous(&self) -> bool {
        let tally = &self.judgement.tally;
        let least = MIN_UNANIMOUS * tally.totals.seen as f64;
        let (agree, independent) = match self.judgement.verdict() {
            Verdict::Confirmed => (tally.totals.confirmed, tally.independent),
            Verdict::Absent => (tally.totals.pierced, self.independent_empty()),
            _ => return false,
        };
        agree as f64 >= least && independent >= MIN_INDEPENDENT_TOGETHER
    }

    /// How many samples' worth of independent measurements say that the place is empty.
    fn independent_empty(&self) -> f64 {
        let (observations, confidence) = (&self.fitted.observations, self.model.question.confidence);
        let is_empty = |sample: &&_| observations.mass(sample, &self.model).0.empty >= confidence;
        observations.seen.iter().filter(is_empty).map(|s| f64::from(s.independence)).sum()
    }
}

/// Whether places may be counted together for want of beams: not where a confidence is asked that all the beams around a
/// place of one station could not reach.
pub fn may_count_together(model: &EvidenceModel) -> bool {
    let most = model.reliability * (1.0 - (-0.5 * BEAMS_IN_KERNEL).exp());
    measures_deviations(model) && (CONFIDENCE_TOGETHER..most).contains(&model.question.confidence)
}

impl Evidence {
    /// The verdict at the level of accuracy and confidence of `model`.
    pub fn verdict(&self, question: &Question, rule: &VerdictRule, interrupt: Interrupt) -> Result<Verdict> {
        Ok(Inquiry::of(self, question, rule, interrupt)?.judgement.verdict())
    }
}
