//! The belief at one sample.

use super::evidence::{Evidence, Station};
use super::model::EvidenceModel;
use super::reading::{Body, Reading};
use super::sums::Sums;
use crate::evidence::Mass;
use crate::geometry::Vec3;
use crate::{Interrupt, Result, poll};

/// What is believed at one sample.
#[derive(Debug, Clone, Copy)]
pub struct SampleBelief {
    /// Combined mass: is the built surface within ±T of the face here?
    pub mass: Mass,
    /// Belief that a surface stands in front of the face, beyond T: displaced object or clutter.
    pub in_front: f64,
    /// Deviation of the built surface along the outward normal, metres, and its standard deviation.
    pub deviation: Option<(f64, f64)>,
    /// Beams that spoke.
    pub beams: u32,
    /// Whether so many beams spoke that belief could reach the confidence, had they all said the same.
    pub seen: bool,
    /// Conflict between stations.
    pub conflict: f64,
}

impl Evidence {
    /// Calls `visit(position, normal, belief)` for every sample, with the tolerance of `model`.
    pub fn for_each_sample(
        &self,
        model: &EvidenceModel,
        interrupt: Interrupt,
        mut visit: impl FnMut(&Vec3, &Vec3, &SampleBelief),
    ) -> Result<()> {
        let mut reading = Reading::default();
        for (b, block) in self.samples.blocks.iter().enumerate() {
            poll(interrupt)?;
            let normal = &self.samples.normals[block.face as usize];
            let heard = self.heard(b);
            for i in 0..block.len as usize {
                let position = self.samples.position(block.start as usize + i);
                reading.read(&heard, i, &position, normal, model);
                visit(&position, normal, &SampleBelief::of(&reading, model));
            }
        }
        Ok(())
    }

    /// The stations that spoke about block `b`, with their places in the list and their sums.
    pub(super) fn heard(&self, b: usize) -> Vec<(usize, &Station, &[Sums])> {
        self.stations.iter().enumerate().filter_map(|(i, s)| Some((i, s, &**s.blocks.get(&(b as u32))?))).collect()
    }
}

impl SampleBelief {
    fn of(reading: &Reading, model: &EvidenceModel) -> Self {
        let (mass, in_front) = reading.mass(model);
        let met = Body::that_met(&reading.bodies);
        Self {
            mass,
            in_front,
            deviation: met.map(|b| (f64::from(b.deviation), b.sd())),
            beams: reading.beams,
            seen: reading.seen,
            conflict: reading.conflict(model),
        }
    }
}
