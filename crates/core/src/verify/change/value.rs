//! The change of one object.

use super::class::{ObjectChangeClass, decide};
use super::displacement::Displacement;
use super::epoch::Epoch;
use super::paired::{Paired, PairedSamples};
use crate::error::{Error, Mismatch};
use crate::verify::evidence::Evidence;
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
        let (old, new) = (Epoch::of(old, interrupt)?, Epoch::of(new, interrupt)?);
        let mut paired = Paired::of(&old, &new, interrupt)?;
        let displacement = Displacement::of(&old, &new, &mut paired, interrupt)?;
        let mut out = Self { class: decide(&paired.all, displacement.as_ref()), samples: paired.all, displacement };
        let to = match out.class {
            ObjectChangeClass::Gone => new.evidence.found.map(|f| Displacement::to_elsewhere(&old, &new, &f)),
            ObjectChangeClass::Appeared => {
                let from = |f| Displacement::to_elsewhere(&new, &old, &f).map(Displacement::reversed);
                old.evidence.found.map(from)
            }
            _ => None,
        };
        if let Some(displacement) = to {
            (out.class, out.displacement) = (ObjectChangeClass::Moved, displacement);
        }
        Ok(out)
    }

    /// Share of the object's samples that both epochs saw.
    pub fn seen_in_both(&self) -> f64 {
        let PairedSamples { samples, seen_in_both, .. } = self.samples;
        if samples == 0 { 0.0 } else { seen_in_both as f64 / samples as f64 }
    }
}
