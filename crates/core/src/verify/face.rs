//! Judging one face: how its samples divide, and whether they agree that it is displaced.

use super::belief::SampleBelief;
use super::evidence::Evidence;
use super::model::EvidenceModel;
use crate::geometry::Vec3;
use crate::num::stats::{median, median_and_spread};
use crate::{Interrupt, Result, poll};

/// Share of a face's seen samples that must agree on one offset for the face to count as displaced.
const CONSENSUS: f64 = 0.5;

/// How the samples of one face divide.
#[derive(Debug, Clone, PartialEq)]
pub struct FaceReport {
    /// Outward unit normal.
    pub normal: Vec3,
    /// All samples.
    pub samples: u64,
    /// Samples enough beams spoke about; confirmed, refuted and open ones add up to these.
    pub seen: u64,
    /// Belief in occupied reaches the confidence.
    pub confirmed: u64,
    /// Belief in empty reaches the confidence, or the sample shares the face's displacement.
    pub refuted: u64,
    /// Of the refuted: the space was seen empty, no surface near.
    pub pierced: u64,
    /// Samples at which a surface was seen within the search band.
    pub surface: u64,
    /// The seen samples agree on an offset beyond the tolerance.
    pub displaced: bool,
    /// Median deviation along the outward normal, metres, and its standard deviation.
    pub deviation: Option<(f64, f64)>,
    /// The part of that standard deviation that is the face's own: without registration and model.
    pub random_sd: f64,
    /// Sum over seen samples of the conflict between stations.
    pub conflict: f64,
}

impl FaceReport {
    /// Seen samples that are neither confirmed nor refuted.
    pub fn open(&self) -> u64 {
        self.seen - self.confirmed - self.refuted
    }
}

impl Evidence {
    /// A report for each face, at the tolerance and confidence of `model`.
    pub(super) fn face_reports(&self, model: &EvidenceModel, interrupt: Interrupt) -> Result<Vec<FaceReport>> {
        let mut beliefs: Vec<Vec<SampleBelief>> = vec![Vec::new(); self.samples.normals.len()];
        let mut totals = vec![0u64; self.samples.normals.len()];
        for (b, block) in self.samples.blocks.iter().enumerate() {
            if b % 64 == 0 {
                poll(interrupt)?;
            }
            let face = block.face as usize;
            totals[face] += u64::from(block.len);
            if self.stations.iter().all(|s| s.blocks[b].is_none()) {
                continue;
            }
            let seen = (0..block.len as usize).map(|i| self.belief(b, i, model)).filter(|x| x.seen);
            beliefs[face].extend(seen);
        }
        let face = |(i, b): (usize, &Vec<SampleBelief>)| judge(self.samples.normals[i], totals[i], b, model);
        Ok(beliefs.iter().enumerate().map(face).collect())
    }
}

fn judge(normal: Vec3, samples: u64, seen: &[SampleBelief], model: &EvidenceModel) -> FaceReport {
    let tolerance = model.tolerance();
    let mut offsets: Vec<f64> = seen.iter().filter_map(|s| s.deviation.map(|d| d.0)).collect();
    let surface = offsets.len() as u64;
    let location = median_and_spread(&mut offsets);
    let agreeing = |s: &SampleBelief| {
        let (Some((d, sd)), Some((centre, _))) = (s.deviation, location) else { return false };
        (d - centre).abs() <= (0.5 * tolerance).max(3.0 * sd)
    };
    let displaced = location.is_some_and(|(centre, _)| centre.abs() > tolerance)
        && seen.iter().filter(|s| agreeing(s)).count() as f64 >= CONSENSUS * seen.len() as f64;
    let mut report = FaceReport {
        normal,
        samples,
        seen: seen.len() as u64,
        confirmed: 0,
        refuted: 0,
        pierced: 0,
        surface,
        displaced,
        deviation: location.map(|(centre, spread)| (centre, median_sd(spread, surface).hypot(common_sd(seen, model)))),
        random_sd: location.map_or(0.0, |(_, spread)| median_sd(spread, surface)),
        conflict: seen.iter().map(|s| s.conflict).sum(),
    };
    for s in seen {
        // In front of the face alone is no refutation: furniture. All of the face in front at one offset is.
        let moved = displaced && agreeing(s) && s.in_front >= 0.8 * model.confidence;
        if s.mass.empty >= model.confidence || moved {
            report.refuted += 1;
            report.pierced += u64::from(!moved && s.pierced > 0.5);
        } else if s.mass.occupied >= model.confidence {
            report.confirmed += 1;
        }
    }
    report
}

/// Standard deviation of the median of `n` samples with this robust spread: 1.2533 σ/√n.
fn median_sd(spread: f64, n: u64) -> f64 {
    1.2533 * spread / (n.max(1) as f64).sqrt()
}

/// What the samples share: registration averages out over the stations only, the model not at all.
fn common_sd(seen: &[SampleBelief], model: &EvidenceModel) -> f64 {
    let mut stations: Vec<f64> = seen.iter().filter(|s| s.stations > 0).map(|s| f64::from(s.stations)).collect();
    let stations = median(&mut stations).unwrap_or(1.0).max(1.0);
    (model.sigma_station / stations.sqrt()).hypot(model.sigma_model)
}
