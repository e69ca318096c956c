//! `ab_pose`: constructor, accessors, and everything through one.

use asbuilt_core::geometry::Solid;
use asbuilt_core::uncertain::Pose;
use asbuilt_core::{Error, Result};

use super::line::line;
use super::plane::plane;
use super::point::point;
use super::{ret, value};
use crate::pg::{Args, Backend, SqlValue, sql_functions};

fn pose(args: &Args, i: usize) -> Pose {
    value(args, i)
}

fn made(args: &Args) -> Result<Pose> {
    let translation = args.vector::<3>(0, "the translation")?.into();
    let rotation = args.vector::<4>(1, "the rotation")?;
    let sd = [3, 4, 5].map(|i| args.f64(i));
    let covariance = if args.is_null(6) {
        Pose::diagonal(sd[0], sd[1], sd[2])?
    } else if sd == [0.0; 3] {
        args.square::<7>(6, "the covariance of the pose")?
    } else {
        return Err(Error::argument("the standard deviations", "left out where a covariance is given", "given"));
    };
    Pose::new(rotation, translation, args.f64(2), &covariance)
}

sql_functions! {
    /// ab_pose(translation, rotation, scale, sd_rotation, sd_translation, sd_scale, covariance)
    fn ab_pose_make(args) {
        if (0..6).any(|i| args.is_null(i)) { Ok(SqlValue::Null) } else { ret(&made(args)?) }
    }

    fn ab_pose_translation(args) { Ok(SqlValue::vector(pose(args, 0).translation)) }
    fn ab_pose_scale(args) { Ok(SqlValue::F64(pose(args, 0).scale)) }
    fn ab_pose_covariance(args) { Ok(SqlValue::matrix(&pose(args, 0).covariance)) }
    fn ab_pose_rotation(args) {
        let q = pose(args, 0).rotation;
        Ok(SqlValue::F64Array(vec![q.w, q.i, q.j, q.k], vec![4]))
    }

    fn ab_transform_point(args) { ret(&pose(args, 1).point(&point(args, 0))?) }
    fn ab_transform_line(args) { ret(&pose(args, 1).line(&line(args, 0))?) }
    fn ab_transform_plane(args) { ret(&pose(args, 1).plane(&plane(args, 0))?) }
    fn ab_transform_pose(args) { ret(&pose(args, 1).after(&pose(args, 0))?) }
    fn ab_pose_inverse(args) { ret(&pose(args, 0).inverse()?) }

    fn ab_transform_solid(args) {
        let (solid, pose) = (Solid::from_stored(args.bytes(0), &Backend)?, pose(args, 1));
        let vertices = solid.vertices().iter().map(|v| pose.apply(v)).collect();
        let moved = Solid::interruptible(vertices, solid.triangles().to_vec(), &Backend)?;
        Ok(SqlValue::Bytes(moved.to_bytes(&Backend)?))
    }
}
