//! How far an object moved between two epochs.

use nalgebra::Matrix3;

use super::epoch::Epoch;
use super::paired::{FaceDifference, Paired};
use super::thresholds::{MAX_CHANCE, MIN_REGISTRATION_SIGMAS, MIN_SAMPLES_OF_FACE};
use crate::geometry::{Vec3, perpendiculars};
use crate::num::chi_square;
use crate::num::eigen;
use crate::num::stats::{MEDIAN_SD, median_and_spread};
use crate::verify::evidence::FoundFace;
use crate::verify::model::EvidenceModel;
use crate::verify::surface::{FittedFace, Shift, shift_of_faces};
use crate::{Interrupt, Result, poll};

/// How far an object moved, and whether that is more than chance and registration.
#[derive(Debug, Clone, PartialEq)]
pub struct Displacement {
    /// Its offset in the new epoch against the old one.
    pub shift: Shift,
    /// Probability of so long a shift by chance, if it did not move.
    pub chance: f64,
    /// The shortest shift that is more than registration, metres.
    pub floor: f64,
}

impl Displacement {
    /// From the faces that show the object in both epochs; `None` where none does. What the drawn face has wrong is
    /// in both epochs, and falls out of the differences; what all stations of an epoch have wrong does not.
    pub fn of(old: &Epoch, new: &Epoch, paired: &mut Paired, interrupt: Interrupt) -> Result<Option<Self>> {
        let mut faces = Vec::new();
        for (face, difference) in paired.faces.iter_mut().enumerate() {
            poll(interrupt)?;
            faces.extend(difference.face(old, new, face));
        }
        // Stations of either epoch count by their own registration: their shares are multiples of it.
        let sigma_model = old.model.sigma_model.hypot(new.model.sigma_model);
        let model = EvidenceModel { sigma_model, sigma_station: 1.0, ..new.model };
        let Some(mut shift) = shift_of_faces(&faces, &model) else { return Ok(None) };
        shift.covariance += Matrix3::identity() * new.model.least_variance();
        Ok(Some(Self { chance: chance(&shift), floor: floor(&old.model, &new.model), shift }))
    }

    /// Of an object that one epoch found beside its place, where it stood in the other: along the normal of the face that
    /// was found. `None` where the other has no deviation of that face.
    pub fn to_elsewhere(there: &Epoch, elsewhere: &Epoch, found: &FoundFace) -> Option<Self> {
        let face = &there.fitted.faces[found.face as usize];
        let (deviation, sd) = face.deviation?;
        let along = face.normal;
        let covariance = along * along.transpose() * (sd * sd + found.sd * found.sd);
        let vector = along * (found.deviation - deviation);
        let shift = Shift { vector, covariance, undetermined: perpendiculars(&along).into() };
        Some(Self { chance: chance(&shift), floor: floor(&there.model, &elsewhere.model), shift })
    }

    /// The way back.
    pub fn reversed(self) -> Self {
        let shift = Shift { vector: -self.shift.vector, ..self.shift };
        Self { shift, ..self }
    }

    /// Whether the object moved.
    pub fn is_certain(&self) -> bool {
        self.chance < MAX_CHANCE && self.shift.vector.norm() > self.floor
    }
}

impl FaceDifference {
    /// The face with its difference in the place of its deviation.
    fn face(&mut self, old: &Epoch, new: &Epoch, number: usize) -> Option<FittedFace> {
        let count = self.differences.len();
        if count < MIN_SAMPLES_OF_FACE {
            return None;
        }
        let (difference, spread) = median_and_spread(&mut self.differences)?;
        let scatter = (self.noise / count as f64).max(spread * spread);
        let random_sd = MEDIAN_SD * (scatter / self.independent.max(1.0)).sqrt();
        let [a, b] = [old, new].map(|e| &e.fitted.faces[number]);
        let registered = |epoch: &Epoch, face: &FittedFace, first: usize| {
            let sigma = epoch.model.sigma_station;
            face.stations.iter().map(|(station, share)| (first + station, share * sigma)).collect::<Vec<_>>()
        };
        let stations = [registered(old, a, 0), registered(new, b, old.evidence.stations().len())].concat();
        Some(FittedFace {
            with_surface: count as u64,
            coherent: a.coherent && b.coherent,
            deviation: Some((difference, random_sd)),
            random_sd,
            stations,
            ..a.clone()
        })
    }
}

/// The shortest shift that is more than what the stations of both epochs have wrong, metres.
fn floor(old: &EvidenceModel, new: &EvidenceModel) -> f64 {
    let variance = |m: &EvidenceModel| m.sigma_station.powi(2) + m.sigma_model.powi(2);
    MIN_REGISTRATION_SIGMAS * (variance(old) + variance(new)).sqrt()
}

/// Probability of a shift as long as this along its determined directions, if it is none.
fn chance(shift: &Shift) -> f64 {
    let unknown: Matrix3<f64> = shift.undetermined.iter().map(|u| u * u.transpose()).sum();
    let projector = Matrix3::identity() - unknown;
    let covariance = projector * shift.covariance * projector;
    let t: Vec3 = projector * shift.vector;
    let dof = 3 - shift.undetermined.len().min(3) as u32;
    if !eigen::is_tame(&covariance) {
        return 1.0;
    }
    let inverse = covariance.pseudo_inverse(1e-9 * covariance.norm());
    inverse.map_or(1.0, |inverse| chi_square::survival((inverse * t).dot(&t), dof))
}
