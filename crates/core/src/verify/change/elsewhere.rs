//! A second look for what left its place: beside it, in the epoch in which the place is empty.

use super::class::ObjectChangeClass;
use super::value::ObjectChange;
use crate::verify::collect::SurveyObjects;
use crate::verify::evidence::Evidence;
use crate::verify::sights::Sights;
use crate::{Interrupt, Result};

/// One epoch: the objects as it surveyed them, and where all its beams ended.
#[derive(Debug, Clone, Copy)]
pub struct SurveyedEpoch<'a> {
    /// All objects of the survey.
    pub objects: &'a SurveyObjects,
    /// Of all its beams.
    pub sights: &'a Sights,
}

impl ObjectChange {
    /// What became of one object, by the evidence of both epochs; one that is gone, or appeared, is looked for beside its
    /// place, and noted in the evidence of the epoch that has it there.
    pub fn looking_beside(
        object: u32,
        [old, new]: [&mut Evidence; 2],
        epochs: [SurveyedEpoch<'_>; 2],
        interrupt: Interrupt,
    ) -> Result<Self> {
        let change = Self::between(old, new, interrupt)?;
        let found = match change.class {
            ObjectChangeClass::Gone => epochs[1].look_beside(object, new, interrupt)?,
            ObjectChangeClass::Appeared => epochs[0].look_beside(object, old, interrupt)?,
            _ => false,
        };
        if found { Self::between(old, new, interrupt) } else { Ok(change) }
    }
}

impl SurveyedEpoch<'_> {
    fn look_beside(&self, object: u32, evidence: &mut Evidence, interrupt: Interrupt) -> Result<bool> {
        self.objects.look_again(object, |looked| {
            evidence.found = self.sights.far_face(evidence, looked, interrupt)?;
            Ok(())
        })?;
        Ok(evidence.found.is_some())
    }
}
