//! One epoch of an object: the fitted object, asked sample by sample.

use super::state::{MetSurface, SampleState};
use crate::evidence::Loa;
use crate::geometry::Vec3;
use crate::verify::evidence::Evidence;
use crate::verify::model::{EvidenceModel, Question};
use crate::verify::surface::FittedObject;
use crate::{Interrupt, Result};

/// One epoch of an object.
pub struct Epoch<'a> {
    pub evidence: &'a Evidence,
    pub model: EvidenceModel,
    pub fitted: FittedObject,
}

impl<'a> Epoch<'a> {
    /// Fits the object; its places are counted from `confidence` on. Whether it is there is asked at one class for all
    /// objects, the coarsest that tells a face from what stands behind: its own class says where it should be, not whether
    /// it is the same as before.
    pub fn of(evidence: &'a Evidence, confidence: f64, interrupt: Interrupt) -> Result<Self> {
        let question = Question { loa: Loa::Loa20, confidence };
        let model = evidence.asked(&question);
        let fitted = FittedObject::of(evidence, &model, interrupt)?;
        Ok(Self { evidence, model, fitted })
    }

    /// Seen sample `at`: where it lies (local, metres), to tell which of the object's samples it is.
    pub fn position(&self, at: usize) -> Vec3 {
        self.fitted.observations.seen[at].position()
    }

    /// How many samples' worth of independent measurements seen sample `at` is: at most 1, without unit.
    pub fn independence(&self, at: usize) -> f64 {
        f64::from(self.fitted.observations.seen[at].independence)
    }

    /// What is said at seen sample `at`.
    pub fn state(&self, at: usize) -> SampleState {
        let (observations, confidence) = (&self.fitted.observations, self.model.question.confidence);
        let sample = &observations.seen[at];
        let met = observations.surface_body(sample).map(|(body, deviation)| MetSurface {
            deviation,
            random_variance: f64::from(body.random_variance),
            common_variance: f64::from(body.common_variance),
            independence: f64::from(sample.independence),
        });
        let (mass, _) = observations.mass(sample, &self.model);
        match self.fitted.on_surface[at].is_some() {
            true if met.is_some() => SampleState::There(met),
            // The lee side of what is displaced: it is there, a little farther on.
            true => SampleState::Open,
            false if mass.empty >= confidence => SampleState::Empty,
            false if mass.occupied >= confidence => SampleState::There(met),
            false => SampleState::Open,
        }
    }
}
