//! The point of a line or plane nearest to a point. The two are taken as independent of each other.

use nalgebra::{Matrix3, SMatrix};

use super::covariance::propagate;
use super::{UncertainLine, UncertainPlane, UncertainPoint};
use crate::geometry::Vec3;

/// Foot of a point on a plane.
pub fn on_plane(point: &UncertainPoint, plane: &UncertainPlane) -> UncertainPoint {
    let (n, height) = (plane.normal, plane.height(&point.position));
    let position = point.position - n * height;
    // δx' = (I − n nᵀ) δx − n δf − f δn
    let by_point = Matrix3::identity() - n * n.transpose();
    let mut by_plane = -n * plane.height_by_plane(&point.position).transpose();
    for i in 0..3 {
        by_plane[(i, i)] -= height;
    }
    let covariance = propagate(&by_point, &point.covariance) + propagate(&by_plane, &plane.covariance);
    UncertainPoint { position, covariance }
}

/// Where along the endless line, in spans from its start, the foot of `x` lies. The point in world metres.
pub fn parameter(x: &Vec3, line: &UncertainLine) -> f64 {
    let span = line.span();
    (x - line.start).dot(&span) / span.norm_squared()
}

/// Foot of a point on an endless line.
pub fn on_line(point: &UncertainPoint, line: &UncertainLine) -> UncertainPoint {
    let (by_point, by_line) = jacobians(&point.position, line);
    UncertainPoint {
        position: line.start + line.span() * parameter(&point.position, line),
        covariance: propagate(&by_point, &point.covariance) + propagate(&by_line, &line.covariance),
    }
}

/// Derivatives of the foot by the point and by (start, end): with t = (x−a)·u/u², δt = [(δx−δa)·u + (x−a)·δu − 2t
/// u·δu]/u².
pub(super) fn jacobians(x: &Vec3, line: &UncertainLine) -> (Matrix3<f64>, SMatrix<f64, 3, 6>) {
    let (a, u) = (line.start, line.span());
    let t = parameter(x, line);
    let by_point = u * u.transpose() / u.norm_squared();
    let by_span = ((x - a) - u * (2.0 * t)).transpose() / u.norm_squared();
    let mut t_by_line = SMatrix::<f64, 1, 6>::zeros();
    t_by_line.fixed_view_mut::<1, 3>(0, 0).copy_from(&(-u.transpose() / u.norm_squared() - by_span));
    t_by_line.fixed_view_mut::<1, 3>(0, 3).copy_from(&by_span);
    (by_point, UncertainLine::jacobian_at(t) + u * t_by_line)
}
