//! One face in numbers: how its samples divide, and how far off it was built.

use super::counts::Counts;
use super::thresholds::IN_FRONT_SHARE;
use crate::geometry::{FaceKind, Vec3};
use crate::verify::evidence::Evidence;
use crate::verify::model::{EvidenceModel, Question};
use crate::verify::surface::{FittedFace, FittedObject};
use crate::{Interrupt, Result, poll, poll_now_and_then};

/// One face.
#[derive(Debug, Clone, PartialEq)]
pub struct FaceReport {
    /// Outward unit normal.
    pub normal: Vec3,
    /// The smooth surface that it is a facet of.
    pub(super) smooth_surface: u32,
    /// What it belongs to.
    pub(super) kind: FaceKind,
    /// How its samples divide.
    pub counts: Counts,
    /// Most of the seen samples follow one trend: the built face.
    pub coherent: bool,
    /// Median deviation along the outward normal, metres, and its standard deviation.
    pub deviation: Option<(f64, f64)>,
    /// The part of that standard deviation that is the face's own: without registration and model.
    pub random_sd: f64,
}

impl FaceReport {
    /// Every face, at the tolerance and confidence of `model`.
    pub(super) fn all(fitted: &FittedObject, model: &EvidenceModel, interrupt: Interrupt) -> Result<Vec<Self>> {
        let report = |(number, face): (usize, &FittedFace)| {
            poll(interrupt)?;
            Ok(Self {
                normal: face.normal,
                smooth_surface: face.smooth_surface,
                kind: face.kind,
                counts: count(number, fitted, model, interrupt)?,
                coherent: face.coherent,
                deviation: face.deviation,
                random_sd: face.random_sd,
            })
        };
        fitted.faces.iter().enumerate().map(report).collect()
    }
}

fn count(number: usize, fitted: &FittedObject, model: &EvidenceModel, interrupt: Interrupt) -> Result<Counts> {
    let FittedFace { samples, with_surface, kind, is_expected, .. } = fitted.faces[number];
    let mut counts = Counts { samples, with_surface, ..Counts::default() };
    let tolerance = model.question.tolerance();
    let observations = &fitted.observations;
    let run = observations.faces[number].clone();
    for (i, (s, on_surface)) in observations.seen[run.clone()].iter().zip(&fitted.on_surface[run]).enumerate() {
        poll_now_and_then(i, interrupt)?;
        let (mass, in_front) = observations.mass(s, model);
        let is_off = on_surface.get().is_some_and(|d| f64::from(d.abs()) > tolerance);
        // A surface in front of the face is no refutation by itself: furniture. One that is the face is.
        let moved = on_surface.is_some() && in_front >= IN_FRONT_SHARE * model.question.confidence;
        let refuted = moved || mass.empty >= model.question.confidence;
        // Where a pane was met is not known well enough to displace it, and beside a leaf its stop or threshold is met.
        if kind != FaceKind::Fixed && (refuted || is_off) {
            counts.samples = counts.samples.saturating_sub(u64::from(!is_expected));
            continue;
        }
        counts.seen += 1;
        // One station sees through a pane that another meets.
        counts.conflict += if kind == FaceKind::Fixed { f64::from(s.conflict) } else { 0.0 };
        counts.refuted += u64::from(refuted);
        counts.pierced += u64::from(refuted && !on_surface.is_some());
        counts.confirmed += u64::from(!refuted && mass.occupied >= model.question.confidence);
        counts.on_surface += u64::from(on_surface.is_some());
        counts.out_of_tolerance += u64::from(is_off);
    }
    Ok(counts)
}

impl Evidence {
    /// Every face as judged at the level of accuracy and confidence of `model`.
    pub fn faces(&self, question: &Question, interrupt: Interrupt) -> Result<Vec<FaceReport>> {
        let model = self.asked(question);
        FaceReport::all(&FittedObject::of(self, &model, interrupt)?, &model, interrupt)
    }
}
