//! Everything through an uncertain pose. Pose and object are taken as independent of each other.

use nalgebra::{Matrix3, Matrix4, Matrix6, SMatrix};

use super::covariance::propagate;
use super::{Matrix7, Stored, UncertainLine, UncertainPlane, UncertainPoint, UncertainPose};
use crate::error::Result;

impl UncertainPose {
    /// Derivative of the image by the object's own coordinates, s·R.
    fn by_object(&self) -> Matrix3<f64> {
        self.matrix() * self.scale
    }

    /// The image of a point.
    pub fn point(&self, p: &UncertainPoint) -> Result<UncertainPoint> {
        let covariance =
            propagate(&self.by_object(), &p.covariance) + propagate(&self.by_pose(&p.position), &self.covariance);
        UncertainPoint { position: self.apply(&p.position), covariance }.built()
    }

    /// The image of a line; both ends share the pose's errors.
    pub fn line(&self, l: &UncertainLine) -> Result<UncertainLine> {
        let mut own = Matrix6::zeros();
        let mut shared = SMatrix::<f64, 6, 7>::zeros();
        for (row, end) in [(0, l.start), (3, l.end)] {
            own.fixed_view_mut::<3, 3>(row, row).copy_from(&self.by_object());
            shared.fixed_view_mut::<3, 7>(row, 0).copy_from(&self.by_pose(&end));
        }
        let covariance = propagate(&own, &l.covariance) + propagate(&shared, &self.covariance);
        UncertainLine { start: self.apply(&l.start), end: self.apply(&l.end), covariance }.with_length()?.built()
    }

    /// The image of a plane: δn' = R δn + ω × n', δq' = s δq + n'·(error of the pose at the plane's point).
    pub fn plane(&self, p: &UncertainPlane) -> Result<UncertainPlane> {
        let normal = (self.rotation * p.normal).normalize();
        let mut own = Matrix4::zeros();
        own.fixed_view_mut::<3, 3>(0, 0).copy_from(&self.matrix());
        own[(3, 3)] = self.scale;
        let mut by_pose = SMatrix::<f64, 4, 7>::zeros();
        by_pose.fixed_view_mut::<3, 3>(0, 0).copy_from(&-normal.cross_matrix());
        by_pose.fixed_view_mut::<1, 7>(3, 0).copy_from(&(normal.transpose() * self.by_pose(&p.point)));
        let covariance = propagate(&own, &p.covariance) + propagate(&by_pose, &self.covariance);
        UncertainPlane::centred(self.apply(&p.point), normal, &covariance).built()
    }

    /// This transform after `first`: x ↦ self(first(x)).
    pub fn after(&self, first: &Self) -> Result<Self> {
        // ω = ω₁ + R₁ω₂, δt = δt₁ + (error of self at t₂) + s₁R₁δt₂, δ = δ₁ + δ₂
        let mut own = Matrix7::identity();
        own.fixed_view_mut::<3, 7>(3, 0).copy_from(&self.by_pose(&first.translation));
        let mut inner = Matrix7::zeros();
        inner.fixed_view_mut::<3, 3>(0, 0).copy_from(&self.matrix());
        inner.fixed_view_mut::<3, 3>(3, 3).copy_from(&self.by_object());
        inner[(6, 6)] = 1.0;
        Self {
            rotation: renormalised(self.rotation * first.rotation),
            translation: self.apply(&first.translation),
            scale: self.scale * first.scale,
            covariance: propagate(&own, &self.covariance) + propagate(&inner, &first.covariance),
        }
        .built()
    }

    /// The transform back.
    pub fn inverse(&self) -> Result<Self> {
        let back = self.matrix().transpose();
        let t = self.translation;
        // R' = Rᵀ, t' = −Rᵀt/s: ω' = −Rᵀω, δt' = Rᵀ(ω×t − δt + δ t)/s, δ' = −δ
        let mut j = Matrix7::zeros();
        j.fixed_view_mut::<3, 3>(0, 0).copy_from(&-back);
        j.fixed_view_mut::<3, 3>(3, 0).copy_from(&(back * -t.cross_matrix() / self.scale));
        j.fixed_view_mut::<3, 3>(3, 3).copy_from(&(-back / self.scale));
        j.fixed_view_mut::<3, 1>(3, 6).copy_from(&(back * t / self.scale));
        j[(6, 6)] = -1.0;
        Self {
            rotation: self.rotation.inverse(),
            translation: -(back * t) / self.scale,
            scale: 1.0 / self.scale,
            covariance: propagate(&j, &self.covariance),
        }
        .built()
    }
}

fn renormalised(mut rotation: nalgebra::UnitQuaternion<f64>) -> nalgebra::UnitQuaternion<f64> {
    rotation.renormalize();
    rotation
}
