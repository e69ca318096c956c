//! `ab_pose`: constructor, accessors, and everything through one.

use asbuilt_core::uncertain::{Line, Plane, Point, Pose};
use asbuilt_core::{Error, Result};
use nalgebra::SMatrix;

use super::ret;
use crate::pg::{Backend, F64Array, SqlValue, sql_functions};
use crate::types::SolidArg;

/// The covariance of a pose: as given, or of these standard deviations of rotation, translation and scale.
fn covariance(given: Option<F64Array>, sd: [f64; 3]) -> Result<SMatrix<f64, 7, 7>> {
    match given {
        None => Pose::diagonal(sd[0], sd[1], sd[2]),
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
        ret(&Pose::new(rotation, translation.into(), scale, &covariance)?)
    }

    fn ab_pose_translation(pose: Pose) { Ok(SqlValue::vector(pose.translation)) }
    fn ab_pose_scale(pose: Pose) { Ok(SqlValue::F64(pose.scale)) }
    fn ab_pose_covariance(pose: Pose) { Ok(SqlValue::matrix(&pose.covariance)) }
    fn ab_pose_rotation(pose: Pose) {
        let q = pose.rotation;
        Ok(SqlValue::F64Array(vec![q.w, q.i, q.j, q.k], vec![4]))
    }

    fn ab_transform_point(point: Point, pose: Pose) { ret(&pose.point(&point)?) }
    fn ab_transform_line(line: Line, pose: Pose) { ret(&pose.line(&line)?) }
    fn ab_transform_plane(plane: Plane, pose: Pose) { ret(&pose.plane(&plane)?) }
    fn ab_transform_pose(first: Pose, pose: Pose) { ret(&pose.after(&first)?) }
    fn ab_pose_inverse(pose: Pose) { ret(&pose.inverse()?) }

    fn ab_transform_solid(solid: SolidArg, pose: Pose) {
        let moved = solid.read()?.placed(|v| pose.apply(v), &Backend)?;
        Ok(SqlValue::Bytes(moved.to_bytes(&Backend)?))
    }
}
