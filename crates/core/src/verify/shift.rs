//! The object's rigid offset, from the offsets of its faces.

use std::collections::BTreeMap;

use nalgebra::Matrix3;

use super::face::FaceReport;
use super::model::EvidenceModel;
use super::surface_points::SurfacePoints;
use crate::geometry::Vec3;
use crate::num::eigen;

/// A face needs this many samples with a surface to have a say.
const MIN_SAMPLES: u64 = 10;
/// A direction is determined when faces with at least this share of the seen surface look along it.
const MIN_SHARE: f64 = 0.05;
/// Huber's constant for 95 % efficiency at the normal distribution.
const HUBER: f64 = 1.345;
/// An axis of which a greater part (squared) lies along what no face determines has no offset of its own.
const MAX_UNDETERMINED: f64 = 0.01;
/// How far an object may be off along what no face determines, metres.
const UNSEEN_M: f64 = 0.03;
/// Error of the offset of a round object, as a part of t²/r: moved by its radius r, it is known to 6 % (measured
/// on poles of 3 to 8 cm moved by 30 to 60 mm).
const OF_ROUND: f64 = 0.06;
/// A smooth surface of as many facets is curved.
pub(super) const MIN_FACETS: usize = 3;
/// Below this length the faces' offsets are linear in the shift, however curved the object, to a tenth of a
/// millimetre (5 mm across a column of 0.12 m radius).
const LINEAR_M: f64 = 0.005;

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

/// An offset along a normal, and how well it is known.
pub(super) struct Vote<'a> {
    pub normal: Vec3,
    /// Metres along the normal.
    pub offset: f64,
    /// σ by which it weighs.
    pub weight_sd: f64,
    /// Its standard deviation, without what it shares with others.
    pub random_sd: f64,
    /// Share of each station in the offset.
    pub stations: &'a [(usize, f64)],
}

/// Below this a face's own standard deviation gives it no more weight, metres: its flatness is not better.
const LEAST_SD_M: f64 = 3e-4;

impl Shift {
    /// Robust least squares of the faces' median offsets d on their normals n, d = n·t, one vote a face. Where
    /// the object is curved and the shift long, `points` (the built surface) are then fitted to the drawn one.
    /// `None` when no direction is determined.
    pub fn fit(faces: &[FaceReport], points: &SurfacePoints, model: &EvidenceModel) -> Option<Self> {
        let voting: Vec<&FaceReport> =
            faces.iter().filter(|f| f.counts.surface >= MIN_SAMPLES && f.deviation.is_some()).collect();
        let total: f64 = voting.iter().map(|f| f.counts.surface as f64).sum();
        let looks = voting
            .iter()
            .map(|f| f.normal * f.normal.transpose() * (f.counts.surface as f64 / total))
            .sum::<Matrix3<f64>>();
        if voting.is_empty() {
            return None;
        }
        let eigen = eigen::of_three(looks);
        let (known, undetermined): (Vec<usize>, Vec<usize>) = (0..3).partition(|&k| eigen.eigenvalues[k] >= MIN_SHARE);
        let column = |k: &usize| eigen.eigenvectors.column(*k).into_owned();
        let projector: Matrix3<f64> = known.iter().map(column).map(|v| v * v.transpose()).sum();
        let votes: Vec<Vote> = voting
            .iter()
            .filter_map(|f| {
                let (offset, weight_sd) = (f.deviation?.0, f.random_sd.max(LEAST_SD_M));
                Some(Vote { normal: f.normal, offset, weight_sd, random_sd: f.random_sd, stations: &f.stations })
            })
            .collect();
        let mut solution = Solution::of(&votes, &projector)?;
        let curved = is_curved(&voting);
        if solution.vector.norm() > LINEAR_M && curved {
            solution = points.refine(solution.vector, &projector).unwrap_or(solution);
        }
        let t = solution.vector;
        let roundness = points.mantle_radius().filter(|_| curved).map_or(0.0, |r| OF_ROUND * t.norm_squared() / r);
        let covariance = solution.random
            + solution.stations * model.sigma_station.powi(2)
            + projector * (model.sigma_model.powi(2) + model.least_variance() + roundness * roundness);
        Some(Self { vector: t, covariance, undetermined: undetermined.iter().map(column).collect() })
    }

    /// Whether a world axis lies within the determined directions, to 6°.
    pub fn determines(&self, axis: usize) -> bool {
        self.undetermined_part(axis) < MAX_UNDETERMINED
    }

    /// σ of the offset along a world axis, metres, with what an unseen offset along the undetermined directions would add.
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

/// Whether faces turn into each other smoothly: facets of a mantle.
fn is_curved(faces: &[&FaceReport]) -> bool {
    let mut facets = BTreeMap::new();
    faces.iter().for_each(|f| *facets.entry(f.smooth_surface).or_insert(0) += 1);
    facets.values().any(|n| *n >= MIN_FACETS)
}

/// A translation with what its errors come from.
pub(super) struct Solution {
    pub vector: Vec3,
    /// Covariance from the votes' own noise, m².
    pub random: Matrix3<f64>,
    /// Covariance that stations registered with a σ of 1 m an axis would add, m².
    pub stations: Matrix3<f64>,
}

impl Solution {
    /// Iteratively re-weighted least squares (Huber) within the subspace of `projector`.
    pub fn of(votes: &[Vote], projector: &Matrix3<f64>) -> Option<Self> {
        let mut t = Vec3::zeros();
        let mut inverse = Matrix3::zeros();
        let weight = |v: &Vote, t: &Vec3| {
            let residual = (v.offset - (projector * v.normal).dot(t)).abs() / v.weight_sd;
            let huber = if residual <= HUBER { 1.0 } else { HUBER / residual };
            huber / (v.weight_sd * v.weight_sd)
        };
        for _ in 0..20 {
            let mut normal_matrix = Matrix3::zeros();
            let mut right = Vec3::zeros();
            for v in votes {
                let n = projector * v.normal;
                let w = weight(v, &t);
                normal_matrix += n * n.transpose() * w;
                right += n * (v.offset * w);
            }
            inverse = Some(normal_matrix).filter(eigen::is_tame)?.pseudo_inverse(1e-9 * normal_matrix.norm()).ok()?;
            let next = inverse * right;
            let step = (next - t).norm();
            t = next;
            if step < 1e-7 {
                break;
            }
        }
        if !t.iter().all(|c| c.is_finite()) {
            return None;
        }
        // A station registered off by b adds n·b to every offset it measured: t follows by Σ (A⁻¹ w n nᵀ share) b.
        let mut random = Matrix3::zeros();
        let mut by_station: BTreeMap<usize, Matrix3<f64>> = BTreeMap::new();
        for v in votes {
            let n = projector * v.normal;
            let gain = inverse * n * weight(v, &t);
            random += gain * gain.transpose() * v.random_sd.powi(2);
            for (station, share) in v.stations {
                *by_station.entry(*station).or_default() += gain * v.normal.transpose() * *share;
            }
        }
        let stations = by_station.values().map(|g| g * g.transpose()).sum();
        Some(Self { vector: t, random, stations })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::face::Counts;

    fn face(normal: Vec3, deviation: f64, surface: u64) -> FaceReport {
        FaceReport {
            normal,
            smooth_surface: 0,
            counts: Counts { samples: surface, seen: surface, surface, own: surface, ..Counts::default() },
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
        let mut faces: Vec<FaceReport> = (0..16)
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
