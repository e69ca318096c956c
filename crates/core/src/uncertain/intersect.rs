//! Where planes and lines meet. The objects met are taken as independent of each other.

use nalgebra::{Matrix2x3, Matrix3, SMatrix};

use super::covariance::propagate;
use super::{Stored, UncertainLine, UncertainPlane, UncertainPoint};
use crate::error::{Error, Result};
use crate::geometry::Vec3;

/// Least sine of the angle between planes, or between a line and a plane, that meet.
const MIN_SINE: f64 = 1e-8;

fn parallel(what: &'static str) -> Error {
    Error::Degenerate { what, reason: "they are parallel".into() }
}

/// The line in which two planes meet, one metre long, about the foot of the middle between their points. Its end points
/// are uncertain across the line only.
pub fn planes(p: &UncertainPlane, q: &UncertainPlane) -> Result<UncertainLine> {
    let along = p.normal.cross(&q.normal);
    if along.norm() <= MIN_SINE {
        return Err(parallel("the line of two planes"));
    }
    let direction = along.normalize();
    let normals = Matrix2x3::from_rows(&[p.normal.transpose(), q.normal.transpose()]);
    // N⁺ = Nᵀ(N Nᵀ)⁻¹
    let Some(inverse) = (normals * normals.transpose()).try_inverse() else {
        return Err(parallel("the line of two planes"));
    };
    let raise = normals.transpose() * inverse;
    let middle = p.point + (q.point - p.point) * 0.5;
    let foot = middle - raise * nalgebra::Vector2::new(p.height(&middle), q.height(&middle));
    let (start, end) = (foot - direction * 0.5, foot + direction * 0.5);
    // δx = −N⁺ (δf of either plane at x)
    let mut j = SMatrix::<f64, 6, 8>::zeros();
    for (row, x) in [(0, start), (3, end)] {
        for (k, plane) in [p, q].into_iter().enumerate() {
            let block = raise.column(k) * -plane.height_by_plane(&x).transpose();
            j.fixed_view_mut::<3, 4>(row, 4 * k).copy_from(&block);
        }
    }
    let mut joint = SMatrix::<f64, 8, 8>::zeros();
    joint.fixed_view_mut::<4, 4>(0, 0).copy_from(&p.covariance);
    joint.fixed_view_mut::<4, 4>(4, 4).copy_from(&q.covariance);
    UncertainLine { start, end, covariance: propagate(&j, &joint) }.built()
}

/// The point in which three planes meet.
pub fn three_planes(planes: [&UncertainPlane; 3]) -> Result<UncertainPoint> {
    let normals = Matrix3::from_rows(&planes.map(|p| p.normal.transpose()));
    let inverse = normals.try_inverse().filter(|_| normals.determinant().abs() > MIN_SINE);
    let Some(inverse) = inverse else {
        let reason = "they share a direction".into();
        return Err(Error::Degenerate { what: "the point of three planes", reason });
    };
    let reference = planes[0].point;
    let position = reference - inverse * Vec3::from(planes.map(|p| p.height(&reference)));
    let mut covariance = Matrix3::zeros();
    for (k, plane) in planes.into_iter().enumerate() {
        let column = inverse.column(k);
        covariance += column * column.transpose() * plane.height_variance(&position);
    }
    UncertainPoint { position, covariance }.built()
}

/// The point in which a line, endless, meets a plane.
pub fn line_plane(line: &UncertainLine, plane: &UncertainPlane) -> Result<UncertainPoint> {
    let span = line.span();
    let slope = plane.normal.dot(&span);
    if slope.abs() <= MIN_SINE * span.norm() {
        return Err(parallel("the point of a line and a plane"));
    }
    let t = -plane.height(&line.start) / slope;
    let position = line.start + span * t;
    // x stays on line and plane: δx = (I − span nᵀ/slope) δ(point of the line at t) − span/slope δf.
    let slide = Matrix3::identity() - span * plane.normal.transpose() / slope;
    let by_line = slide * UncertainLine::jacobian_at(t);
    let by_plane = -span / slope * plane.height_by_plane(&position).transpose();
    let covariance = propagate(&by_line, &line.covariance) + propagate(&by_plane, &plane.covariance);
    UncertainPoint { position, covariance }.built()
}
