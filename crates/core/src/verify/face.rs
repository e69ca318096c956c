//! One face in numbers: how its samples divide, and how far off it was built.

use super::built_surface::Built;
use super::evidence::Evidence;
use super::model::EvidenceModel;
use crate::geometry::Vec3;
use crate::num::stats::median_and_spread;
use crate::{Interrupt, Result, poll, poll_now_and_then};

/// How samples divide, those of one face or of several.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Counts {
    /// All samples.
    pub samples: u64,
    /// Samples enough beams spoke about; confirmed, refuted and open ones add up to these.
    pub seen: u64,
    /// Belief in occupied reaches the confidence.
    pub confirmed: u64,
    /// Belief in empty reaches the confidence, or the sample shares the face's displacement.
    pub refuted: u64,
    /// Of the refuted: nothing of the object there, the space was seen empty.
    pub pierced: u64,
    /// Samples at which the object's own surface was seen.
    pub own: u64,
    /// Of these the ones beyond the tolerance.
    pub beyond: u64,
    /// Samples at which any surface was seen within the search band.
    pub surface: u64,
    /// Sum over seen samples of the conflict between stations.
    pub conflict: f64,
}

/// One face.
#[derive(Debug, Clone, PartialEq)]
pub struct FaceReport {
    /// Outward unit normal.
    pub normal: Vec3,
    /// The smooth surface that it is a facet of.
    pub(super) smooth_surface: u32,
    /// How its samples divide.
    pub counts: Counts,
    /// Most of the seen samples follow one course: the built face.
    pub coherent: bool,
    /// Median deviation along the outward normal, metres, and its standard deviation.
    pub deviation: Option<(f64, f64)>,
    /// The part of that standard deviation that is the face's own: without registration and model.
    pub random_sd: f64,
    /// Share of each station in that deviation.
    pub(super) stations: Vec<(usize, f64)>,
}

/// Part of the confidence that suffices for "in front" once the whole surface agrees: by itself it is discounted.
const IN_FRONT_SHARE: f64 = 0.8;

impl Counts {
    /// Adds those of another face.
    pub(super) fn add(&mut self, other: &Self) {
        self.samples += other.samples;
        self.seen += other.seen;
        self.confirmed += other.confirmed;
        self.refuted += other.refuted;
        self.pierced += other.pierced;
        self.own += other.own;
        self.beyond += other.beyond;
        self.surface += other.surface;
        self.conflict += other.conflict;
    }

    /// Seen samples that are neither confirmed nor refuted.
    pub fn open(&self) -> u64 {
        self.seen - self.confirmed - self.refuted
    }
}

impl Built {
    /// A report for each face, at the tolerance and confidence of `model`.
    pub fn faces(&self, model: &EvidenceModel, interrupt: Interrupt) -> Result<Vec<FaceReport>> {
        let count = |(face, located): (usize, &FaceReport)| {
            poll(interrupt)?;
            let counts = self.count(face, located.counts, model, interrupt)?;
            Ok(FaceReport { counts, ..located.clone() })
        };
        self.located.iter().enumerate().map(count).collect()
    }

    /// Where each face is: the part of the reports that no level of accuracy changes.
    pub(super) fn locate(&mut self, e: &Evidence, model: &EvidenceModel, interrupt: Interrupt) -> Result<()> {
        let face = |face| {
            poll(interrupt)?;
            self.located_face(face, e, model, interrupt)
        };
        self.located = (0..self.observations.faces.len()).map(face).collect::<Result<_>>()?;
        Ok(())
    }

    fn located_face(
        &self,
        face: usize,
        e: &Evidence,
        model: &EvidenceModel,
        interrupt: Interrupt,
    ) -> Result<FaceReport> {
        let o = &self.observations;
        let run = o.faces[face].clone();
        let smooth_surface = e.samples.surface_of_face[face];
        let coherent = self.surfaces.get(smooth_surface as usize).is_some_and(|s| s.coherent);
        let (mut deviations, mut noise, mut independent, mut surface) = (Vec::new(), 0.0, 0.0, 0);
        for (i, (s, own)) in o.seen[run.clone()].iter().zip(&self.own[run]).enumerate() {
            poll_now_and_then(i, interrupt)?;
            let Some(body) = o.surface_body(s) else { continue };
            surface += 1;
            // Where the surface is known, what else was met there does not count.
            if !coherent || !own.is_nan() {
                deviations.push(f64::from(body.deviation));
                noise += f64::from(body.random_variance);
                independent += f64::from(s.independence);
            }
        }
        let count = deviations.len();
        let location = median_and_spread(&mut deviations);
        poll(interrupt)?;
        // The median of what is independent; a bent face spreads by its shape, which is not noise.
        let scatter = if coherent { noise / count.max(1) as f64 } else { location.map_or(0.0, |l| l.1.powi(2)) };
        let random_sd = 1.2533 * (scatter / f64::max(independent, 1.0)).sqrt();
        let heard = &o.heard[face];
        let common = heard.common_variance(model);
        let with_sd = |(d, _): (f64, f64)| (d, (random_sd.powi(2) + common).sqrt().hypot(model.second_order_sd(d)));
        Ok(FaceReport {
            normal: e.samples.normals[face],
            smooth_surface,
            counts: Counts { samples: heard.samples, surface, ..Counts::default() },
            coherent,
            deviation: location.map(with_sd),
            random_sd,
            stations: heard.shares().collect(),
        })
    }

    fn count(&self, face: usize, located: Counts, model: &EvidenceModel, interrupt: Interrupt) -> Result<Counts> {
        let mut counts = located;
        let tolerance = model.tolerance();
        let run = self.observations.faces[face].clone();
        for (i, (s, own)) in self.observations.seen[run.clone()].iter().zip(&self.own[run]).enumerate() {
            poll_now_and_then(i, interrupt)?;
            let (mass, in_front) = self.observations.mass(s, model);
            let is_own = !own.is_nan();
            // A surface in front of the face is no refutation by itself: furniture. One that is the face is.
            let moved = is_own && in_front >= IN_FRONT_SHARE * model.confidence;
            let refuted = moved || mass.empty >= model.confidence;
            counts.seen += 1;
            counts.conflict += f64::from(s.conflict);
            counts.refuted += u64::from(refuted);
            counts.pierced += u64::from(refuted && !is_own);
            counts.confirmed += u64::from(!refuted && mass.occupied >= model.confidence);
            counts.own += u64::from(is_own);
            counts.beyond += u64::from(is_own && f64::from(own.abs()) > tolerance);
        }
        Ok(counts)
    }
}
