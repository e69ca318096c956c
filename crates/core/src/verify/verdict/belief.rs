//! The belief at one sample.

use crate::evidence::Mass;
use crate::geometry::Vec3;
use crate::verify::evidence::Evidence;
use crate::verify::model::{EvidenceModel, Question};
use crate::verify::surface::{EvidenceBody, SampleReading};
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
    /// Beams of all stations.
    pub beams: u32,
    /// Whether so many beams were there that belief could reach the confidence, had they all said the same.
    pub seen: bool,
    /// Conflict between stations.
    pub conflict: f64,
}

impl Evidence {
    /// Calls `visit(position, normal, belief)` for every sample, with the tolerance asked.
    pub fn for_each_sample(
        &self,
        question: &Question,
        interrupt: Interrupt,
        mut visit: impl FnMut(&Vec3, &Vec3, &SampleBelief),
    ) -> Result<()> {
        let model = &self.asked(question);
        let mut reading = SampleReading::default();
        for (b, block) in self.samples.blocks.iter().enumerate() {
            poll(interrupt)?;
            let normal = &self.samples.normals[block.face as usize];
            let stations = self.stations_of_block(b);
            for i in 0..block.len as usize {
                let position = self.samples.position(block.start as usize + i);
                reading.read(&stations, i, &position, normal, model);
                visit(&position, normal, &SampleBelief::of(&reading, model));
            }
        }
        Ok(())
    }
}

impl SampleBelief {
    fn of(reading: &SampleReading, model: &EvidenceModel) -> Self {
        let (mass, in_front) = reading.mass(model);
        Self {
            mass,
            in_front,
            deviation: EvidenceBody::on_surface(&reading.bodies).map(|(body, deviation)| (deviation, body.sd())),
            beams: reading.beams,
            seen: reading.seen,
            conflict: reading.conflict(model),
        }
    }
}
