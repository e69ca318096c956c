//! A point with its covariance.

use nalgebra::Matrix3;

use super::covariance;
use super::stored::{Stored, get_triangle, put_triangle};
use crate::error::{Error, Result};
use crate::geometry::{Aabb, Vec3, check_coordinates};
use crate::num::eigen;

/// A point, metres, and its covariance, m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UncertainPoint {
    /// Metres.
    pub position: Vec3,
    /// m².
    pub covariance: Matrix3<f64>,
}

impl UncertainPoint {
    /// A point with the same standard deviation along every axis, metres.
    pub fn isotropic(position: Vec3, sd: f64) -> Result<Self> {
        Self { position, covariance: Matrix3::identity() * checked_sd("the standard deviation", sd)?.powi(2) }.checked()
    }

    /// A point whose covariance need not be exactly symmetric.
    pub fn new(position: Vec3, covariance: &Matrix3<f64>) -> Result<Self> {
        let covariance = covariance::checked("the covariance of the point", covariance)?;
        Self { position, covariance }.in_range()
    }

    /// The ellipsoid that holds the true point with `probability`: half-axes by falling length, metres, and their unit
    /// directions.
    pub fn ellipsoid(&self, probability: f64) -> Result<[(f64, Vec3); 3]> {
        let factor = covariance::confidence_factor(probability, 3)?;
        let eigen = eigen::of_three(self.covariance);
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
        Ok(order.map(|i| (factor * eigen.eigenvalues[i].max(0.0).sqrt(), eigen.eigenvectors.column(i).into_owned())))
    }

    /// The box around the standard ellipsoid grown by `factor`. World metres.
    pub fn bounds(&self, factor: f64) -> Aabb {
        let half = |i: usize| factor * self.covariance[(i, i)].max(0.0).sqrt();
        Aabb { min: [0, 1, 2].map(|i| self.position[i] - half(i)), max: [0, 1, 2].map(|i| self.position[i] + half(i)) }
    }

    /// Mahalanobis distance of two points that are uncertain independently; infinite where they differ along a
    /// direction without variance.
    pub fn mahalanobis(&self, other: &Self) -> f64 {
        let s = self.covariance + other.covariance;
        covariance::mahalanobis_squared(&(self.position - other.position), &s).0.sqrt()
    }
}

impl Stored<9> for UncertainPoint {
    const NAME: &'static str = "ab_point";
    const COORDINATES: usize = 3;

    fn to_numbers(&self) -> [f64; 9] {
        let mut out = [0.0; 9];
        out[..3].copy_from_slice(self.position.as_slice());
        put_triangle(&mut out, 3, &self.covariance);
        out
    }

    fn from_stored(n: &[f64; 9]) -> Self {
        Self { position: Vec3::new(n[0], n[1], n[2]), covariance: get_triangle(n, 3) }
    }

    fn settled(self) -> Self {
        Self { covariance: covariance::settled(&self.covariance), ..self }
    }

    fn checked(self) -> Result<Self> {
        check_coordinates("a coordinate", &self.position)?;
        covariance::checked("the covariance of the point", &self.covariance)?;
        Ok(self)
    }
}

/// A standard deviation, checked to be finite and not negative. Metres.
pub fn checked_sd(what: &'static str, sd: f64) -> Result<f64> {
    if sd >= 0.0 && sd.is_finite() { Ok(sd) } else { Err(Error::argument(what, "0 or more, and finite", sd)) }
}
