//! A plane in centroid form with its covariance.

use nalgebra::{Matrix3, Matrix4, Vector4};

use super::covariance;
use super::point::checked_sd;
use super::stored::{Stored, get_triangle, put_triangle};
use crate::error::{Error, Result};
use crate::geometry::{Vec3, check_coordinates};
use crate::num::eigen;

/// A plane through `point` with unit `normal` (Förstner & Wrobel 2016, 10.2.2.3).
///
/// The true plane is (n + δn)·(x − c) = δq: the covariance is that of (δn, δq), basis-free, δn ⟂ n. Built from others,
/// c is where offset and tilt are uncorrelated, the centroid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UncertainPlane {
    /// c, metres.
    pub point: Vec3,
    /// n, unit length.
    pub normal: Vec3,
    /// Of (δn, δq): rad², rad·m, m².
    pub covariance: Matrix4<f64>,
}

impl UncertainPlane {
    /// A plane whose offset along the normal and whose tilt about any axis in it have these standard deviations
    /// (metres, radians), independently. The normal is made a unit vector.
    pub fn tilted(point: Vec3, normal: Vec3, sd_offset: f64, sd_tilt: f64) -> Result<Self> {
        let normal = unit(&normal)?;
        let mut covariance = Matrix4::<f64>::zeros();
        let tilt = (Matrix3::identity() - normal * normal.transpose()) * checked_sd("sd_tilt", sd_tilt)?.powi(2);
        covariance.fixed_view_mut::<3, 3>(0, 0).copy_from(&tilt);
        covariance[(3, 3)] = checked_sd("sd_offset", sd_offset)?.powi(2);
        Self { point, normal, covariance }.checked()
    }

    /// A plane with the covariance of (normal, offset); the part of it along the normal is taken out.
    pub fn new(point: Vec3, normal: Vec3, covariance: &Matrix4<f64>) -> Result<Self> {
        let covariance = covariance::checked("the covariance of the plane", covariance)?;
        Self::projected(point, unit(&normal)?, &covariance).checked()
    }

    fn projected(point: Vec3, normal: Vec3, covariance: &Matrix4<f64>) -> Self {
        let mut across = Matrix4::<f64>::identity();
        across.fixed_view_mut::<3, 3>(0, 0).copy_from(&(Matrix3::identity() - normal * normal.transpose()));
        Self { point, normal, covariance: covariance::propagate(&across, covariance) }
    }

    /// The same plane with its point moved to where offset and tilt are uncorrelated. A plane whose tilt is known
    /// exactly along some direction keeps its place there.
    pub(super) fn centred(point: Vec3, normal: Vec3, covariance: &Matrix4<f64>) -> Self {
        let own = Self::projected(point, normal, covariance);
        let tilt: Matrix3<f64> = own.covariance.fixed_view::<3, 3>(0, 0).into_owned();
        let mixed: Vec3 = own.covariance.fixed_view::<3, 1>(0, 3).into_owned();
        let shift = if eigen::is_tame(&tilt) {
            tilt.pseudo_inverse(1e-12 * tilt.amax()).map_or_else(|_| Vec3::zeros(), |inverse| inverse * mixed)
        } else {
            // Beyond what can be computed with: the value will be refused.
            Vec3::repeat(f64::NAN)
        };
        own.referred_to(&shift)
    }

    /// The same plane about point + shift, the shift within the plane: δq' = δq − shift·δn.
    fn referred_to(&self, shift: &Vec3) -> Self {
        let mut j = Matrix4::<f64>::identity();
        j.fixed_view_mut::<1, 3>(3, 0).copy_from(&-shift.transpose());
        Self { point: self.point + shift, covariance: covariance::propagate(&j, &self.covariance), ..*self }
    }

    /// Signed distance of `x` in front of the plane, metres.
    pub fn height(&self, x: &Vec3) -> f64 {
        self.normal.dot(&(x - self.point))
    }

    /// Derivative of the height of a fixed `x` by (δn, δq).
    pub(super) fn height_by_plane(&self, x: &Vec3) -> Vector4<f64> {
        let r = x - self.point;
        Vector4::new(r.x, r.y, r.z, -1.0)
    }

    /// Variance of the height of a fixed `x`, m².
    pub(super) fn height_variance(&self, x: &Vec3) -> f64 {
        let j = self.height_by_plane(x);
        j.dot(&(self.covariance * j)).max(0.0)
    }
}

pub(super) fn unit(v: &Vec3) -> Result<Vec3> {
    v.try_normalize(1e-12).filter(|n| n.iter().all(|c| c.is_finite())).ok_or_else(|| Error::Degenerate {
        what: "the normal",
        reason: format!("the vector ({}, {}, {}) has no direction", v.x, v.y, v.z),
    })
}

impl Stored<16> for UncertainPlane {
    const NAME: &'static str = "ab_plane";
    const COORDINATES: usize = 6;

    fn to_numbers(&self) -> [f64; 16] {
        let mut out = [0.0; 16];
        out[..3].copy_from_slice(self.point.as_slice());
        out[3..6].copy_from_slice(self.normal.as_slice());
        put_triangle(&mut out, 6, &self.covariance);
        out
    }

    fn from_stored(n: &[f64; 16]) -> Self {
        let at = |i: usize| Vec3::new(n[i], n[i + 1], n[i + 2]);
        Self { point: at(0), normal: at(3), covariance: get_triangle(n, 6) }
    }

    fn settled(self) -> Self {
        Self { covariance: covariance::settled(&self.covariance), ..self }
    }

    fn checked(mut self) -> Result<Self> {
        check_coordinates("a coordinate", &self.point)?;
        let length = self.normal.norm();
        if (length - 1.0).abs() > 1e-6 || !length.is_finite() {
            return Err(Error::argument("the plane's normal", "of unit length", length));
        }
        // Written with fewer digits; what was stored as a unit stays as it is, to the bit.
        if (length - 1.0).abs() > 1e-15 {
            self.normal /= length;
        }
        covariance::checked("the covariance of the plane", &self.covariance)?;
        let n = Vector4::new(self.normal.x, self.normal.y, self.normal.z, 0.0);
        let along = n.dot(&(self.covariance * n));
        // Beside the relative tolerance, what rounding leaves on a plane without uncertainty.
        if along > 1e-6 * self.covariance.fixed_view::<3, 3>(0, 0).trace() + 1e-24 {
            let reason = format!("not that of a plane: the normal's length has variance {along:e}");
            return Err(Error::Covariance { what: "the covariance of the plane", reason });
        }
        Ok(self)
    }
}
