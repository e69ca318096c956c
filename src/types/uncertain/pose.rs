//! `ab_pose`: constructor, accessors, and everything through one.

use asbuilt_core::uncertain::{UncertainLine, UncertainPlane, UncertainPoint, UncertainPose};
use asbuilt_core::{Error, Result};
use nalgebra::SMatrix;

use super::ret;
use crate::pg::{Backend, F64Array, SqlValue, sql_functions};
use crate::types::SolidArg;

/// The covariance of a pose: as given, or of these standard deviations of rotation, translation and scale.
fn covariance(given: Option<F64Array>, sd: [f64; 3]) -> Result<SMatrix<f64, 7, 7>> {
    match given {
        None => UncertainPose::diagonal(sd[0], sd[1], sd[2]),
        Some(given) if sd == [0.0; 3] => given.square::<7>("the covariance of the pose"),
        Some(_) => Err(Error::argument("the standard deviations", "left out where a covariance is given", "given")),
    }
}

sql_functions! {
    fn ab_pose_make(
        translation: F64Array, rotation: F64Array, scale: f64, sd_rotation: f64, sd_translation: f64, sd_scale: f64,
        covariance: Option<F64Array>,
    ) {
        let (translation, rotation) = (translation.vector::<3>("the translation")?, rotation.vector("the rotation")?);
        let covariance = self::covariance(covariance, [sd_rotation, sd_translation, sd_scale])?;
        ret(&UncertainPose::new(rotation, translation.into(), scale, &covariance)?)
    }

    fn ab_pose_translation(pose: UncertainPose) { Ok(SqlValue::vector(pose.translation)) }
    fn ab_pose_scale(pose: UncertainPose) { Ok(SqlValue::F64(pose.scale)) }
    fn ab_pose_covariance(pose: UncertainPose) { Ok(SqlValue::matrix(&pose.covariance)) }
    fn ab_pose_rotation(pose: UncertainPose) {
        let q = pose.rotation;
        Ok(SqlValue::F64Array(vec![q.w, q.i, q.j, q.k], vec![4]))
    }

    fn ab_transform_point(point: UncertainPoint, pose: UncertainPose) { ret(&pose.point(&point)?) }
    fn ab_transform_line(line: UncertainLine, pose: UncertainPose) { ret(&pose.line(&line)?) }
    fn ab_transform_plane(plane: UncertainPlane, pose: UncertainPose) { ret(&pose.plane(&plane)?) }
    fn ab_transform_pose(first: UncertainPose, pose: UncertainPose) { ret(&pose.after(&first)?) }
    fn ab_pose_inverse(pose: UncertainPose) { ret(&pose.inverse()?) }

    fn ab_transform_solid(solid: SolidArg, pose: UncertainPose) {
        let moved = solid.read()?.placed(|v| pose.apply(v), &Backend)?;
        Ok(SqlValue::Bytes(moved.to_bytes(&Backend)?))
    }
}
