//! A line as a segment between two uncertain points.

use nalgebra::{Matrix6, SMatrix, Vector6};

use super::UncertainPoint;
use super::covariance::{self, propagate};
use super::stored::{Stored, get_triangle, put_triangle};
use crate::error::{Error, Result};
use crate::geometry::{Aabb, Vec3, check_coordinates};

/// Points nearer than this do not determine a direction, metres: the rounding of projected coordinates.
pub(super) const MIN_LENGTH_M: f64 = 1e-8;

/// Two end points, metres, and their joint covariance, m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UncertainLine {
    /// Metres.
    pub start: Vec3,
    /// Metres; not the start.
    pub end: Vec3,
    /// Of (start, end), m².
    pub covariance: Matrix6<f64>,
}

impl UncertainLine {
    /// A segment whose joint covariance need not be exactly symmetric.
    pub fn new(start: Vec3, end: Vec3, covariance: &Matrix6<f64>) -> Result<Self> {
        let covariance = covariance::checked("the covariance of the line", covariance)?;
        Self { start, end, covariance }.in_range()?.with_length()
    }

    /// The same line, unless its ends coincide.
    pub(super) fn with_length(self) -> Result<Self> {
        if self.span().norm() > MIN_LENGTH_M {
            return Ok(self);
        }
        let reason = format!("its end points are {:e} m apart", self.span().norm());
        Err(Error::Degenerate { what: "the line", reason })
    }

    /// Start to end, metres.
    pub fn span(&self) -> Vec3 {
        self.end - self.start
    }

    /// Unit vector from start to end. A unit vector in the world.
    pub fn direction(&self) -> Vec3 {
        self.span().normalize()
    }

    /// The point at start + t·span, 0 at the start, 1 at the end. World metres.
    pub fn at(&self, t: f64) -> UncertainPoint {
        let j = Self::jacobian_at(t);
        UncertainPoint { position: self.start + self.span() * t, covariance: propagate(&j, &self.covariance) }
    }

    /// Derivative of the point at t by (start, end).
    pub(super) fn jacobian_at(t: f64) -> SMatrix<f64, 3, 6> {
        let mut j = SMatrix::<f64, 3, 6>::zeros();
        j.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(1.0 - t);
        j.fixed_view_mut::<3, 3>(0, 3).fill_diagonal(t);
        j
    }

    /// Derivative of the unit direction by (start, end).
    pub(super) fn jacobian_direction(&self) -> SMatrix<f64, 3, 6> {
        let (d, length) = (self.direction(), self.span().norm());
        let across = (nalgebra::Matrix3::identity() - d * d.transpose()) / length;
        let mut j = SMatrix::<f64, 3, 6>::zeros();
        j.fixed_view_mut::<3, 3>(0, 0).copy_from(&-across);
        j.fixed_view_mut::<3, 3>(0, 3).copy_from(&across);
        j
    }

    /// Homogeneous Plücker line (L_h = Y − X, L_0 = X × Y) about `reference` and its covariance (Meyer (2022), eqs. 2.7
    /// and 2.8).
    pub fn plucker(&self, reference: &Vec3) -> (Vector6<f64>, Matrix6<f64>) {
        let (x, y) = (self.start - reference, self.end - reference);
        let (h, zero) = (y - x, x.cross(&y));
        let mut j = Matrix6::zeros();
        j.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(-1.0);
        j.fixed_view_mut::<3, 3>(0, 3).fill_diagonal(1.0);
        j.fixed_view_mut::<3, 3>(3, 0).copy_from(&-y.cross_matrix());
        j.fixed_view_mut::<3, 3>(3, 3).copy_from(&x.cross_matrix());
        (Vector6::new(h.x, h.y, h.z, zero.x, zero.y, zero.z), propagate(&j, &self.covariance))
    }

    /// The box around the end points' standard ellipsoids grown by `factor`. World metres.
    pub fn bounds(&self, factor: f64) -> Aabb {
        self.at(0.0).bounds(factor).union(&self.at(1.0).bounds(factor))
    }
}

impl Stored<27> for UncertainLine {
    const NAME: &'static str = "ab_line";
    const COORDINATES: usize = 6;

    fn to_numbers(&self) -> [f64; 27] {
        let mut out = [0.0; 27];
        out[..3].copy_from_slice(self.start.as_slice());
        out[3..6].copy_from_slice(self.end.as_slice());
        put_triangle(&mut out, 6, &self.covariance);
        out
    }

    fn from_stored(n: &[f64; 27]) -> Self {
        let at = |i: usize| Vec3::new(n[i], n[i + 1], n[i + 2]);
        Self { start: at(0), end: at(3), covariance: get_triangle(n, 6) }
    }

    fn settled(self) -> Self {
        Self { covariance: covariance::settled(&self.covariance), ..self }
    }

    fn checked(self) -> Result<Self> {
        check_coordinates("a coordinate", &self.start)?;
        check_coordinates("a coordinate", &self.end)?;
        covariance::checked("the covariance of the line", &self.covariance)?;
        self.with_length()
    }
}
