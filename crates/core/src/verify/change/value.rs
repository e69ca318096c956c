//! The change of one object.

use super::class::{ObjectChangeClass, decide};
use super::displacement::Displacement;
use super::epoch::Epoch;
use super::paired::{Paired, PairedSamples};
use crate::error::{Error, Mismatch};
use crate::verify::evidence::Evidence;
use crate::verify::verdict::{
    CONFIDENCE_TOGETHER, MIN_INDEPENDENT, MIN_INDEPENDENT_TOGETHER, MIN_UNANIMOUS, may_count_together,
};
use crate::{Interrupt, Result};

/// What became of an object between two epochs, with the numbers that say so.
#[derive(Debug, Clone, PartialEq)]
pub struct ObjectChange {
    /// What became of it.
    pub class: ObjectChangeClass,
    /// How its samples divide.
    pub samples: PairedSamples,
    /// How far it moved; `None` where no face shows it in both epochs.
    pub displacement: Option<Displacement>,
}

impl ObjectChange {
    /// Compares the evidence of two epochs about one solid, at the same samples. What left its place is `Moved` where the
    /// evidence of the other epoch [found](Evidence::found) it beside.
    pub fn between(old: &Evidence, new: &Evidence, interrupt: Interrupt) -> Result<Self> {
        if old.fingerprint() != new.fingerprint() {
            return Err(Error::Mismatch(Mismatch::Solids));
        }
        if !old.samples.are_those_of(&new.samples) {
            return Err(Error::Mismatch(Mismatch::Samples));
        }
        let confidence = old.model().question.confidence;
        let (mut alone, independent) = Self::at(old, new, confidence, interrupt)?;
        if independent < MIN_INDEPENDENT.min(alone.samples.samples as f64) {
            alone.class = ObjectChangeClass::NotComparable;
        }
        if alone.class != ObjectChangeClass::NotComparable || !may_count_together(old.model()) {
            return Ok(alone);
        }
        // As a verdict asks what few beams told of: together, where nearly all say the same.
        let (together, independent) = Self::at(old, new, CONFIDENCE_TOGETHER, interrupt)?;
        let is_sure = together.is_unanimous() && independent >= MIN_INDEPENDENT_TOGETHER;
        Ok(if is_sure { together } else { alone })
    }

    /// Places counted from this confidence on, and how many independent measurements they are.
    fn at(old: &Evidence, new: &Evidence, confidence: f64, interrupt: Interrupt) -> Result<(Self, f64)> {
        let [old, new] = [Epoch::of(old, confidence, interrupt)?, Epoch::of(new, confidence, interrupt)?];
        let mut paired = Paired::of(&old, &new, interrupt)?;
        let displacement = Displacement::of(&old, &new, &mut paired, interrupt)?;
        let mut out = Self { class: decide(&paired.all, displacement.as_ref()), samples: paired.all, displacement };
        if let Some(displacement) = out.elsewhere(&old, &new) {
            (out.class, out.displacement) = (ObjectChangeClass::Moved, displacement);
        }
        Ok((out, paired.independent))
    }

    /// Where what left its place was found; nothing where it was not.
    fn elsewhere(&self, old: &Epoch, new: &Epoch) -> Option<Option<Displacement>> {
        match self.class {
            ObjectChangeClass::Gone => new.evidence.found.map(|f| Displacement::to_elsewhere(old, new, &f)),
            ObjectChangeClass::Appeared => {
                let from = |f| Displacement::to_elsewhere(new, old, &f).map(Displacement::reversed);
                old.evidence.found.map(from)
            }
            _ => None,
        }
    }

    /// Whether nearly all places that say something in both epochs say the same.
    fn is_unanimous(&self) -> bool {
        let PairedSamples { kept, displaced, lost, won, empty, .. } = self.samples;
        let agree = match self.class {
            ObjectChangeClass::Unchanged => (kept - displaced).max(empty),
            ObjectChangeClass::Gone => lost,
            ObjectChangeClass::Appeared => won,
            _ => return false,
        };
        agree as f64 >= MIN_UNANIMOUS * self.samples.compared() as f64
    }

    /// Share of the object's samples that both epochs saw.
    pub fn seen_in_both(&self) -> f64 {
        let PairedSamples { samples, seen_in_both, .. } = self.samples;
        if samples == 0 { 0.0 } else { seen_in_both as f64 / samples as f64 }
    }
}
