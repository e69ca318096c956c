//! Offsets along normals, and the translation that explains them.

use std::collections::BTreeMap;

use nalgebra::Matrix3;

use crate::geometry::Vec3;
use crate::num::eigen;

/// Huber's constant for 95 % efficiency at the normal distribution.
const HUBER: f64 = 1.345;

/// An offset along a normal, and how well it is known.
pub struct Vote<'a> {
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

/// A translation with what its errors come from.
pub struct Solution {
    pub vector: Vec3,
    /// Covariance from the votes' own noise, m².
    pub random: Matrix3<f64>,
    /// Covariance that stations registered with a σ of 1 m per axis would add, m².
    pub stations: Matrix3<f64>,
}

impl Solution {
    /// Iteratively re-weighted least squares (Huber) within the subspace of `projector`. Metres.
    pub fn of(votes: &[Vote], projector: &Matrix3<f64>) -> Option<Self> {
        let mut t = Vec3::zeros();
        let mut inverse = Matrix3::zeros();
        for _ in 0..20 {
            let mut normal_matrix = Matrix3::zeros();
            let mut right = Vec3::zeros();
            for v in votes {
                let n = projector * v.normal;
                let w = v.weight(projector, &t);
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
        t.iter().all(|c| c.is_finite()).then(|| Self::with_errors(votes, projector, t, &inverse))
    }

    /// A station registered off by b adds n·b to every offset it measured: t follows by Σ (A⁻¹ w n nᵀ share) b.
    fn with_errors(votes: &[Vote], projector: &Matrix3<f64>, vector: Vec3, inverse: &Matrix3<f64>) -> Self {
        let mut random = Matrix3::zeros();
        let mut by_station: BTreeMap<usize, Matrix3<f64>> = BTreeMap::new();
        for v in votes {
            let n = projector * v.normal;
            let gain = inverse * n * v.weight(projector, &vector);
            random += gain * gain.transpose() * v.random_sd.powi(2);
            for (station, share) in v.stations {
                *by_station.entry(*station).or_default() += gain * v.normal.transpose() * *share;
            }
        }
        let stations = by_station.values().map(|g| g * g.transpose()).sum();
        Self { vector, random, stations }
    }
}

impl Vote<'_> {
    /// What it weighs beside a translation `t`.
    fn weight(&self, projector: &Matrix3<f64>, t: &Vec3) -> f64 {
        let residual = (self.offset - (projector * self.normal).dot(t)).abs() / self.weight_sd;
        let huber = if residual <= HUBER { 1.0 } else { HUBER / residual };
        huber / (self.weight_sd * self.weight_sd)
    }
}
