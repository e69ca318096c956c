//! The object's rigid offset, from the offsets of its faces.

use std::collections::BTreeMap;

use nalgebra::Matrix3;

use super::closest_points::{MIN_FACETS, SurfacePoints};
use super::fitted_face::FittedFace;
use super::fitted_object::FittedObject;
use super::vote::{Solution, Vote};
use crate::geometry::Vec3;
use crate::num::eigen;
use crate::verify::evidence::Evidence;
use crate::verify::model::{EvidenceModel, measures_deviations};
use crate::{Interrupt, Result};

/// A face needs this many samples with a surface to have a say.
const MIN_SAMPLES: u64 = 10;
/// A direction is determined when faces with at least this share of the seen surface look along it.
const MIN_SHARE: f64 = 0.05;
/// An axis of which a greater part (squared) lies along what no face determines has no offset of its own.
const MAX_UNDETERMINED: f64 = 0.01;
/// How far an object may be off along what no face determines, metres.
const UNSEEN_M: f64 = 0.03;
/// Error of the offset of a round object, as a part of t²/r: moved by its radius r, it is known to 6 % (measured
/// on poles of 3 to 8 cm moved by 30 to 60 mm).
const OF_ROUND: f64 = 0.06;
/// Below this length the faces' offsets are linear in the shift, however curved the object, to a tenth of a
/// millimetre (5 mm across a column of 0.12 m radius).
const LINEAR_M: f64 = 0.005;

/// Below this a face's own standard deviation gives it no more weight, metres: its flatness is not better.
const MIN_SD_M: f64 = 3e-4;

/// Translation of the built object against the drawn one, along the directions that its seen faces determine.
#[derive(Debug, Clone, PartialEq)]
pub struct Shift {
    /// Metres, world axes; zero along the undetermined directions.
    pub vector: Vec3,
    /// Covariance, m²; meaningless along the undetermined directions.
    pub covariance: Matrix3<f64>,
    /// Unit vectors along which the seen faces say nothing.
    pub undetermined: Vec<Vec3>,
}

impl Shift {
    /// Robust least squares of the faces' median offsets d on their normals n, d = n·t, one vote a face. Where
    /// the object is curved and the shift long, `points` (the built surface) are then fitted to the drawn one.
    /// `None` when no direction is determined.
    pub(super) fn fit(faces: &[FittedFace], points: &SurfacePoints, model: &EvidenceModel) -> Option<Self> {
        let voting: Vec<&FittedFace> =
            faces.iter().filter(|f| f.with_surface >= MIN_SAMPLES && f.deviation.is_some()).collect();
        if voting.is_empty() {
            return None;
        }
        let directions = Directions::of(&voting);
        let votes: Vec<Vote> = voting.iter().filter_map(|f| vote(f)).collect();
        let linear = Solution::of(&votes, &directions.projector)?;
        let curved = is_curved(&voting);
        let solution = if linear.vector.norm() > LINEAR_M && curved {
            points.refine(linear.vector, &directions.projector).unwrap_or(linear)
        } else {
            linear
        };
        let t = solution.vector;
        let roundness = points.lateral_radius().filter(|_| curved).map_or(0.0, |r| OF_ROUND * t.norm_squared() / r);
        let covariance = solution.random
            + solution.stations * model.sigma_station.powi(2)
            + directions.projector * (model.sigma_model.powi(2) + model.least_variance() + roundness * roundness);
        Some(Self { vector: t, covariance, undetermined: directions.undetermined })
    }

    /// Whether a world axis lies within the determined directions, to 6°.
    pub fn determines(&self, axis: usize) -> bool {
        self.undetermined_part(axis) < MAX_UNDETERMINED
    }

    /// σ of the offset along a world axis, metres, with what an unseen offset along the undetermined directions would
    /// add.
    pub fn sd(&self, axis: usize) -> f64 {
        let unseen = self.undetermined_part(axis) * UNSEEN_M * UNSEEN_M;
        (self.covariance[(axis, axis)].max(0.0) + unseen).sqrt()
    }

    fn undetermined_part(&self, axis: usize) -> f64 {
        self.undetermined.iter().map(|u| u[axis] * u[axis]).sum()
    }

    /// Text `(+0.0121, -, +0.0003) +/- (0.0004, -, 0.0005)`, metres; `-` for an undetermined axis.
    pub fn to_text(&self) -> String {
        let list = |f: &dyn Fn(usize) -> String| {
            [0, 1, 2].map(|i| if self.determines(i) { f(i) } else { "-".into() }).join(", ")
        };
        let values = list(&|i| format!("{:+.4}", self.vector[i]));
        let sds = list(&|i| format!("{:.4}", self.sd(i)));
        format!("({values}) +/- ({sds})")
    }
}

/// Which directions the seen faces determine.
struct Directions {
    /// Onto the determined ones.
    projector: Matrix3<f64>,
    undetermined: Vec<Vec3>,
}

impl Directions {
    fn of(voting: &[&FittedFace]) -> Self {
        let total: f64 = voting.iter().map(|f| f.with_surface as f64).sum();
        let looks = voting
            .iter()
            .map(|f| f.normal * f.normal.transpose() * (f.with_surface as f64 / total))
            .sum::<Matrix3<f64>>();
        let eigen = eigen::of_three(looks);
        let (known, undetermined): (Vec<usize>, Vec<usize>) = (0..3).partition(|&k| eigen.eigenvalues[k] >= MIN_SHARE);
        let column = |k: &usize| eigen.eigenvectors.column(*k).into_owned();
        Self {
            projector: known.iter().map(column).map(|v| v * v.transpose()).sum(),
            undetermined: undetermined.iter().map(column).collect(),
        }
    }
}

fn vote(face: &FittedFace) -> Option<Vote<'_>> {
    let (offset, weight_sd) = (face.deviation?.0, face.random_sd.max(MIN_SD_M));
    Some(Vote { normal: face.normal, offset, weight_sd, random_sd: face.random_sd, stations: &face.stations })
}

/// Whether faces turn into each other smoothly: facets of a lateral surface.
fn is_curved(faces: &[&FittedFace]) -> bool {
    let mut facets = BTreeMap::new();
    faces.iter().for_each(|f| *facets.entry(f.smooth_surface).or_insert(0) += 1);
    facets.values().any(|n| *n >= MIN_FACETS)
}

/// The rigid offset of an object by its faces; `None` where none determines one, or the model measures no deviations.
pub fn shift_of(e: &Evidence, faces: &[FittedFace], interrupt: Interrupt) -> Result<Option<Shift>> {
    if !measures_deviations(&e.model) {
        return Ok(None);
    }
    Ok(Shift::fit(faces, &SurfacePoints::of(e, interrupt)?, &e.model))
}

/// The offset that the deviations of these faces alone explain.
pub fn shift_of_faces(faces: &[FittedFace], model: &EvidenceModel) -> Option<Shift> {
    Shift::fit(faces, &SurfacePoints::default(), model)
}

impl Evidence {
    /// The rigid offset; `None` where no face determines one.
    pub fn rigid_shift(&self, interrupt: Interrupt) -> Result<Option<Shift>> {
        let fitted = FittedObject::of(self, &self.model, interrupt)?;
        shift_of(self, &fitted.faces, interrupt)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::FaceKind;

    fn face(normal: Vec3, deviation: f64, samples: u64) -> FittedFace {
        FittedFace {
            is_expected: true,
            kind: FaceKind::Fixed,
            normal,
            smooth_surface: 0,
            samples,
            with_surface: samples,
            coherent: true,
            deviation: Some((deviation, 0.0009)),
            random_sd: 0.0005,
            stations: vec![(0, 0.5), (1, 0.5)],
        }
    }

    /// Two stations of 1 mm each: 0.7 mm together.
    fn model() -> EvidenceModel {
        EvidenceModel::default()
    }

    #[test]
    fn a_wall_seen_from_both_sides_determines_its_normal_only() {
        let jamb = face(Vec3::y(), 0.02, 20);
        let faces = [face(Vec3::x(), 0.012, 1000), face(-Vec3::x(), -0.012, 900), jamb];
        let s = Shift::fit(&faces, &SurfacePoints::default(), &model()).unwrap();
        assert!((s.vector - Vec3::new(0.012, 0.0, 0.0)).norm() < 1e-9, "{}", s.vector);
        assert_eq!(s.to_text(), "(+0.0120, -, -) +/- (0.0008, -, -)");
    }

    #[test]
    fn one_wild_face_does_not_pull_a_column() {
        let truth = Vec3::new(0.03, -0.01, 0.0);
        let mut faces: Vec<FittedFace> = (0..16)
            .map(|i| f64::from(i) * std::f64::consts::FRAC_PI_8)
            .map(|a| Vec3::new(a.cos(), a.sin(), 0.0))
            .map(|n| face(n, n.dot(&truth), 100))
            .collect();
        faces[3].deviation = Some((0.09, 0.0009));
        let s = Shift::fit(&faces, &SurfacePoints::default(), &model()).unwrap();
        assert!((s.vector - truth).norm() < 5e-4, "{}", s.vector);
        assert!(s.determines(0) && s.determines(1) && !s.determines(2));
        assert!(Shift::fit(&[], &SurfacePoints::default(), &model()).is_none());
    }
}
