//! A rigid or similarity transform with its covariance.

use nalgebra::{Matrix3, Quaternion, SMatrix, UnitQuaternion};

use super::covariance;
use super::point::checked_sd;
use super::stored::{Stored, get_triangle, put_triangle};
use crate::error::{Error, Result};
use crate::geometry::{Vec3, check_coordinates};

/// Covariance of rotation, translation and scale.
pub type Matrix7 = SMatrix<f64, 7, 7>;

/// x' = s·R·x + t.
///
/// The true transform is x' = s·eᵟ·exp([ω]×)·R·x + t + δt: the covariance is that of (ω, δt, δ): radians about the axes
/// of the target frame, metres, and the relative error of scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UncertainPose {
    /// R.
    pub rotation: UnitQuaternion<f64>,
    /// t, metres.
    pub translation: Vec3,
    /// s.
    pub scale: f64,
    /// Of (ω, δt, δ).
    pub covariance: Matrix7,
}

impl UncertainPose {
    /// A pose from a quaternion w, x, y, z (which is normalised), checked.
    pub fn new(quaternion: [f64; 4], translation: Vec3, scale: f64, covariance: &Matrix7) -> Result<Self> {
        let [w, x, y, z] = quaternion;
        let q = Quaternion::new(w, x, y, z);
        if !(q.norm() > 1e-9 && q.norm().is_finite()) {
            return Err(Error::argument(
                "the rotation",
                "a quaternion w, x, y, z that is not all zero",
                format!("{w}, {x}, {y}, {z}"),
            ));
        }
        let covariance = covariance::checked("the covariance of the pose", covariance)?;
        Self { rotation: UnitQuaternion::from_quaternion(q), translation, scale, covariance }.checked()
    }

    /// Standard deviations of rotation (radians per axis), translation (metres per axis) and scale (relative).
    pub fn diagonal(sd_rotation: f64, sd_translation: f64, sd_scale: f64) -> Result<Matrix7> {
        let r = checked_sd("sd_rotation", sd_rotation)?.powi(2);
        let t = checked_sd("sd_translation", sd_translation)?.powi(2);
        let s = checked_sd("sd_scale", sd_scale)?.powi(2);
        Ok(Matrix7::from_diagonal(&nalgebra::SVector::from([r, r, r, t, t, t, s])))
    }

    /// The rotation as a matrix. From the source frame to the target frame.
    pub fn matrix(&self) -> Matrix3<f64> {
        self.rotation.to_rotation_matrix().into_inner()
    }

    /// s·R·x: the image of a vector.
    pub(super) fn turned(&self, x: &Vec3) -> Vec3 {
        self.rotation * x * self.scale
    }

    /// The image of a point without uncertainty. Metres: from the source frame to the target frame.
    pub fn apply(&self, x: &Vec3) -> Vec3 {
        self.turned(x) + self.translation
    }

    /// Derivative of the image of a fixed `x` by (ω, δt, δ).
    pub(super) fn by_pose(&self, x: &Vec3) -> SMatrix<f64, 3, 7> {
        let turned = self.turned(x);
        let mut j = SMatrix::<f64, 3, 7>::zeros();
        j.fixed_view_mut::<3, 3>(0, 0).copy_from(&-turned.cross_matrix());
        j.fixed_view_mut::<3, 3>(0, 3).fill_diagonal(1.0);
        j.fixed_view_mut::<3, 1>(0, 6).copy_from(&turned);
        j
    }
}

impl Stored<36> for UncertainPose {
    const NAME: &'static str = "ab_pose";
    const COORDINATES: usize = 8;

    fn to_numbers(&self) -> [f64; 36] {
        let mut out = [0.0; 36];
        let q = self.rotation.quaternion();
        out[..4].copy_from_slice(&[q.w, q.i, q.j, q.k]);
        out[4..7].copy_from_slice(self.translation.as_slice());
        out[7] = self.scale;
        put_triangle(&mut out, 8, &self.covariance);
        out
    }

    fn from_stored(n: &[f64; 36]) -> Self {
        Self {
            // Stored as it was normalised: normalising again could change the last bit.
            rotation: UnitQuaternion::new_unchecked(Quaternion::new(n[0], n[1], n[2], n[3])),
            translation: Vec3::new(n[4], n[5], n[6]),
            scale: n[7],
            covariance: get_triangle(n, 8),
        }
    }

    fn settled(self) -> Self {
        Self { covariance: covariance::settled(&self.covariance), ..self }
    }

    fn checked(mut self) -> Result<Self> {
        check_coordinates("a coordinate", &self.translation)?;
        let length = self.rotation.quaternion().norm();
        if (length - 1.0).abs() > 1e-6 || !length.is_finite() {
            return Err(Error::argument(
                "the rotation",
                "a unit quaternion w, x, y, z",
                format!("one of length {length}"),
            ));
        }
        // Written with fewer digits; what was stored as a unit stays as it is, to the bit.
        if (length - 1.0).abs() > 1e-15 {
            self.rotation = UnitQuaternion::from_quaternion(*self.rotation.quaternion());
        }
        if !(self.scale > 1e-9 && self.scale < 1e9) {
            return Err(Error::argument("the scale", "positive, between 1e-9 and 1e9", self.scale));
        }
        covariance::checked("the covariance of the pose", &self.covariance)?;
        Ok(self)
    }
}
