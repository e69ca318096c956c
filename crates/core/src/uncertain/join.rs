//! Lines and planes through points. The objects joined are taken as independent of each other.

use nalgebra::{Matrix3, Matrix6, SMatrix};

use super::covariance::propagate;
use super::line::MIN_LENGTH_M;
use super::{Stored, UncertainLine, UncertainPlane, UncertainPoint};
use crate::error::{Error, Result};
use crate::geometry::Vec3;

/// Least sine of the angle between two sides of a triangle that determines a plane.
const MIN_SINE: f64 = 1e-8;

/// The line from one point to the other.
pub fn line_through(a: &UncertainPoint, b: &UncertainPoint) -> Result<UncertainLine> {
    let mut covariance = Matrix6::zeros();
    covariance.fixed_view_mut::<3, 3>(0, 0).copy_from(&a.covariance);
    covariance.fixed_view_mut::<3, 3>(3, 3).copy_from(&b.covariance);
    UncertainLine { start: a.position, end: b.position, covariance }.with_length()?.built()
}

/// The plane through three points, its normal by the right hand from the first to the third.
pub fn plane_through(a: &UncertainPoint, b: &UncertainPoint, c: &UncertainPoint) -> Result<UncertainPlane> {
    let mut joint = SMatrix::<f64, 9, 9>::zeros();
    for (i, p) in [a, b, c].into_iter().enumerate() {
        joint.fixed_view_mut::<3, 3>(3 * i, 3 * i).copy_from(&p.covariance);
    }
    through_three([a.position, b.position, c.position], &joint)
}

/// The plane through a line and a point beside it.
pub fn plane_through_line(line: &UncertainLine, point: &UncertainPoint) -> Result<UncertainPlane> {
    let mut joint = SMatrix::<f64, 9, 9>::zeros();
    joint.fixed_view_mut::<6, 6>(0, 0).copy_from(&line.covariance);
    joint.fixed_view_mut::<3, 3>(6, 6).copy_from(&point.covariance);
    through_three([line.start, line.end, point.position], &joint)
}

fn through_three([a, b, c]: [Vec3; 3], joint: &SMatrix<f64, 9, 9>) -> Result<UncertainPlane> {
    let (ab, ac) = (b - a, c - a);
    let m = ab.cross(&ac);
    if m.norm() <= MIN_SINE * ab.norm() * ac.norm() || (c - b).norm().min(ab.norm()).min(ac.norm()) <= MIN_LENGTH_M {
        let reason = "the three points lie on one line".into();
        return Err(Error::Degenerate { what: "the plane", reason });
    }
    let normal = m.normalize();
    // δm = [c−b]× δa − [c−a]× δb + [b−a]× δc, and only what is across n turns it.
    let across = (Matrix3::identity() - normal * normal.transpose()) / m.norm();
    let mut j = SMatrix::<f64, 4, 9>::zeros();
    for (i, side) in [c - b, -ac, ab].into_iter().enumerate() {
        j.fixed_view_mut::<3, 3>(0, 3 * i).copy_from(&(across * side.cross_matrix()));
        j.fixed_view_mut::<1, 3>(3, 3 * i).copy_from(&(normal.transpose() / 3.0));
    }
    let centre = a + (ab + ac) / 3.0;
    UncertainPlane::centred(centre, normal, &propagate(&j, joint)).built()
}

/// The point halfway between two.
pub fn midpoint(a: &UncertainPoint, b: &UncertainPoint) -> UncertainPoint {
    let position = a.position + (b.position - a.position) * 0.5;
    UncertainPoint { position, covariance: (a.covariance + b.covariance) * 0.25 }
}
