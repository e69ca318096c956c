//! Judging one face: how its samples divide, and whether together they show it displaced.

use super::belief::{SampleBelief, belief};
use super::consensus::Consensus;
use super::evidence::Evidence;
use super::model::EvidenceModel;
use crate::geometry::Vec3;
use crate::num::stats::{median, median_and_spread};
use crate::{Interrupt, Result, poll, poll_now_and_then};

/// Share of a face's seen samples that must lie on one plane for that plane to be the built face.
const MAJORITY: f64 = 0.5;

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
    /// Most of the seen samples lie on one plane: the built face.
    pub coherent: bool,
    /// The seen samples lie on one plane, and most of it beyond the tolerance.
    pub displaced: bool,
    /// Median deviation along the outward normal, metres, and its standard deviation.
    pub deviation: Option<(f64, f64)>,
    /// The part of that standard deviation that is the face's own: without registration and model.
    pub random_sd: f64,
    /// Sum over seen samples of the conflict between stations.
    pub conflict: f64,
}

/// Part of the confidence that suffices for "in front" once the whole face agrees: by itself it is discounted.
const IN_FRONT_SHARE: f64 = 0.8;

impl FaceReport {
    /// Seen samples that are neither confirmed nor refuted.
    pub fn open(&self) -> u64 {
        self.seen - self.confirmed - self.refuted
    }
}

impl Evidence {
    /// A report for each face, at the tolerance and confidence of `model`.
    pub(super) fn face_reports(&self, model: &EvidenceModel, interrupt: Interrupt) -> Result<Vec<FaceReport>> {
        let mut beliefs: Vec<Vec<Seen>> = vec![Vec::new(); self.samples.normals.len()];
        let mut totals = vec![0u64; self.samples.normals.len()];
        for (b, block) in self.samples.blocks.iter().enumerate() {
            if b % 64 == 0 {
                poll(interrupt)?;
            }
            let face = block.face as usize;
            totals[face] += u64::from(block.len);
            let heard = self.heard(b);
            if heard.is_empty() {
                continue;
            }
            let normal = &self.samples.normals[face];
            let at = |i: usize| {
                let local = self.samples.local(block.start as usize + i);
                (local, belief(&heard, i, &(local + self.samples.reference), normal, model))
            };
            beliefs[face].extend((0..block.len as usize).map(at).filter(|(_, belief)| belief.seen));
        }
        let face = |(i, b): (usize, &Vec<Seen>)| {
            poll(interrupt)?;
            judge(self.samples.normals[i], totals[i], b, model, interrupt)
        };
        beliefs.iter().enumerate().map(face).collect()
    }
}

/// A seen sample's position and belief.
type Seen = (Vec3, SampleBelief);

fn judge(normal: Vec3, samples: u64, seen: &[Seen], model: &EvidenceModel, interrupt: Interrupt) -> Result<FaceReport> {
    let tolerance = model.tolerance();
    let mut surface = Surface::of(seen, interrupt)?;
    let count = surface.points.len() as u64;
    let location = median_and_spread(&mut surface.deviations);
    poll(interrupt)?;
    let common_sd = common_sd(&mut surface.stations, model);
    let on_plane = agreement(&normal, &surface.points, seen, tolerance, interrupt)?;
    let displaced = on_plane.is_some() && location.is_some_and(|(centre, _)| centre.abs() > tolerance);
    let mut report = FaceReport {
        normal,
        samples,
        seen: seen.len() as u64,
        confirmed: 0,
        refuted: 0,
        pierced: 0,
        surface: count,
        coherent: on_plane.is_some(),
        displaced,
        deviation: location.map(|(centre, spread)| (centre, median_sd(spread, count).hypot(common_sd))),
        random_sd: location.map_or(0.0, |(_, spread)| median_sd(spread, count)),
        conflict: surface.conflict,
    };
    for (i, (position, b)) in seen.iter().enumerate() {
        poll_now_and_then(i, interrupt)?;
        // A surface in front of the face is no refutation by itself: furniture. One that is the face is.
        let moved = b.in_front >= IN_FRONT_SHARE * model.confidence
            && on_plane.as_ref().is_some_and(|agrees| agrees(position, b));
        if b.mass.empty >= model.confidence || moved {
            report.refuted += 1;
            report.pierced += u64::from(!moved && b.pierced > 0.5);
        } else if b.mass.occupied >= model.confidence {
            report.confirmed += 1;
        }
    }
    Ok(report)
}

/// The seen samples at which a surface was met.
#[derive(Default)]
struct Surface {
    /// Position (local) and deviation, metres.
    points: Vec<(Vec3, f64)>,
    deviations: Vec<f64>,
    /// How many stations met it, per sample.
    stations: Vec<f64>,
    /// Sum over all seen samples.
    conflict: f64,
}

impl Surface {
    fn of(seen: &[Seen], interrupt: Interrupt) -> Result<Self> {
        let mut out = Self::default();
        for (i, (position, b)) in seen.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            out.conflict += b.conflict;
            if let Some((deviation, _)) = b.deviation {
                out.points.push((*position, deviation));
                out.deviations.push(deviation);
            }
            if b.stations > 0 {
                out.stations.push(f64::from(b.stations));
            }
        }
        Ok(out)
    }
}

/// Tells which samples lie on the built face, where most of the seen ones do.
fn agreement(
    normal: &Vec3,
    observed: &[(Vec3, f64)],
    seen: &[Seen],
    tolerance: f64,
    interrupt: Interrupt,
) -> Result<Option<impl Fn(&Vec3, &SampleBelief) -> bool>> {
    let Some(consensus) = Consensus::fit(normal, observed, interrupt)?.filter(Consensus::is_face) else {
        return Ok(None);
    };
    let agrees = move |position: &Vec3, b: &SampleBelief| {
        b.deviation.is_some_and(|(d, sd)| consensus.residual(position, d).abs() <= (0.25 * tolerance).max(3.0 * sd))
    };
    let mut agreeing = 0u64;
    for (i, (position, b)) in seen.iter().enumerate() {
        poll_now_and_then(i, interrupt)?;
        agreeing += u64::from(agrees(position, b));
    }
    Ok((agreeing as f64 >= MAJORITY * seen.len() as f64).then_some(agrees))
}

/// Standard deviation of the median of `n` samples with this robust spread: 1.2533 σ/√n.
fn median_sd(spread: f64, n: u64) -> f64 {
    1.2533 * spread / (n.max(1) as f64).sqrt()
}

/// What the samples share: registration averages out over the stations only, the model not at all.
fn common_sd(stations: &mut [f64], model: &EvidenceModel) -> f64 {
    let stations = median(stations).unwrap_or(1.0).max(1.0);
    (model.sigma_station / stations.sqrt()).hypot(model.sigma_model)
}
