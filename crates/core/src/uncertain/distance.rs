//! Distances with their standard deviations, metres. The two objects are taken as independent of each other.

use nalgebra::{Matrix3, RowVector3};

use super::{UncertainLine, UncertainPlane, UncertainPoint, foot};
use crate::geometry::Vec3;
use crate::num::eigen;

/// A distance and its standard deviation, metres.
///
/// Where the distance is zero its direction, and so its derivative, is undefined: the standard deviation is then that
/// of the most uncertain direction, an upper bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UncertainDistance {
    /// Metres; signed only for point and plane.
    pub distance: f64,
    /// Metres.
    pub sd: f64,
}

/// Between two points.
pub fn points(a: &UncertainPoint, b: &UncertainPoint) -> UncertainDistance {
    of_difference(&(b.position - a.position), &(a.covariance + b.covariance))
}

/// Height of a point in front of a plane, negative behind it.
pub fn point_plane(point: &UncertainPoint, plane: &UncertainPlane) -> UncertainDistance {
    UncertainDistance { distance: plane.height(&point.position), sd: height_variance(point, plane).sqrt() }
}

pub(super) fn height_variance(point: &UncertainPoint, plane: &UncertainPlane) -> f64 {
    plane.normal.dot(&(point.covariance * plane.normal)) + plane.height_variance(&point.position)
}

/// Between a point and an endless line.
pub fn point_line(point: &UncertainPoint, line: &UncertainLine) -> UncertainDistance {
    let (by_point, by_line) = foot::jacobians(&point.position, line);
    let across = point.position - (line.start + line.span() * foot::parameter(&point.position, line));
    let own = Matrix3::identity() - by_point;
    let s = own * point.covariance * own.transpose() + by_line * line.covariance * by_line.transpose();
    of_difference(&across, &s)
}

/// Between two endless lines; parallel ones by the middle of the second.
pub fn lines(a: &UncertainLine, b: &UncertainLine) -> UncertainDistance {
    let (u, v) = (a.span(), b.span());
    let across = u.cross(&v);
    if across.norm() <= 1e-8 * u.norm() * v.norm() {
        return point_line(&b.at(0.5), a);
    }
    let w = across.normalize();
    let between = b.start - a.start;
    // Nearest points at a + s·u and b + t·v; to first order only these two move the distance.
    let s = between.cross(&v).dot(&across) / across.norm_squared();
    let t = between.cross(&u).dot(&across) / across.norm_squared();
    let (row_a, row_b) = (w.transpose() * UncertainLine::jacobian_at(s), w.transpose() * UncertainLine::jacobian_at(t));
    let variance = (row_a * a.covariance * row_a.transpose())[0] + (row_b * b.covariance * row_b.transpose())[0];
    UncertainDistance { distance: w.dot(&between).abs(), sd: variance.max(0.0).sqrt() }
}

fn of_difference(d: &Vec3, s: &Matrix3<f64>) -> UncertainDistance {
    let distance = d.norm();
    let variance = if distance > 0.0 {
        let unit: RowVector3<f64> = d.transpose() / distance;
        (unit * s * unit.transpose())[0]
    } else {
        eigen::of_three(*s).eigenvalues.max()
    };
    UncertainDistance { distance, sd: variance.max(0.0).sqrt() }
}
