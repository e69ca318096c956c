//! Statistical tests of relations between uncertain objects (Heuel 2004, ch. 4; Förstner & Wrobel 2016, 10.4).
//!
//! Each takes as null hypothesis that the relation holds, and gives χ² = rᵀΣ⁺r of a residual r that is then zero. The
//! two objects are taken as independent of each other.

use nalgebra::{Matrix1, Matrix2, Matrix3, RowVector6, SMatrix, SVector, Vector1, Vector2, Vector3};

use super::covariance::{mahalanobis_squared, propagate};
use super::{UncertainLine, UncertainPlane, UncertainPoint, distance, foot};
use crate::geometry::{Vec3, perpendiculars};
use crate::num::chi_square;

/// Outcome of a test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HypothesisTest {
    /// χ²; infinite where exact objects contradict each other.
    pub statistic: f64,
    /// Degrees of freedom: the rank of the residual's covariance.
    pub dof: u32,
    /// Probability of a statistic at least as large, given that the relation holds.
    pub p_value: f64,
}

impl HypothesisTest {
    fn of<const K: usize>(r: &SVector<f64, K>, s: &SMatrix<f64, K, K>) -> Self {
        let (statistic, dof) = mahalanobis_squared(r, s);
        Self { statistic, dof, p_value: chi_square::survival(statistic, dof) }
    }

    fn of_one(r: f64, variance: f64) -> Self {
        Self::of(&Vector1::new(r), &Matrix1::new(variance))
    }

    /// Whether the relation is not rejected at this significance.
    pub fn holds(&self, significance: f64) -> bool {
        self.p_value >= significance
    }
}

/// Are two points the same? 3 degrees of freedom.
pub fn same_point(a: &UncertainPoint, b: &UncertainPoint) -> HypothesisTest {
    HypothesisTest::of(&(a.position - b.position), &(a.covariance + b.covariance))
}

/// Does a point lie on an endless line? 2 degrees of freedom.
pub fn point_on_line(point: &UncertainPoint, line: &UncertainLine) -> HypothesisTest {
    let t = foot::parameter(&point.position, line);
    let b = basis(&line.direction());
    let r = b * (point.position - (line.start + line.span() * t));
    HypothesisTest::of(
        &r,
        &(propagate(&b, &point.covariance) + propagate(&(b * UncertainLine::jacobian_at(t)), &line.covariance)),
    )
}

/// Does a point lie on a plane? 1 degree of freedom.
pub fn point_on_plane(point: &UncertainPoint, plane: &UncertainPlane) -> HypothesisTest {
    HypothesisTest::of_one(plane.height(&point.position), distance::height_variance(point, plane))
}

/// Does a line lie in a plane? 2 degrees of freedom: its two ends.
pub fn line_in_plane(line: &UncertainLine, plane: &UncertainPlane) -> HypothesisTest {
    let r = Vector2::new(plane.height(&line.start), plane.height(&line.end));
    let n = plane.normal.transpose();
    let by_line =
        SMatrix::<f64, 2, 6>::from_rows(&[n * UncertainLine::jacobian_at(0.0), n * UncertainLine::jacobian_at(1.0)]);
    let by_plane = SMatrix::<f64, 2, 4>::from_rows(&[
        plane.height_by_plane(&line.start).transpose(),
        plane.height_by_plane(&line.end).transpose(),
    ]);
    HypothesisTest::of(&r, &(propagate(&by_line, &line.covariance) + propagate(&by_plane, &plane.covariance)))
}

/// Are two planes the same, whichever way their normals look? 3 degrees of freedom.
pub fn same_plane(p: &UncertainPlane, q: &UncertainPlane) -> HypothesisTest {
    let facing = p.normal.dot(&q.normal).signum();
    let normal = q.normal * facing;
    let cos = p.normal.dot(&normal);
    let b = basis(&p.normal);
    let tilt = b * normal;
    let between = q.point - p.point;
    let r = Vector3::new(tilt.x, tilt.y, p.normal.dot(&between));
    let mut by_p = SMatrix::<f64, 3, 4>::zeros();
    by_p.fixed_view_mut::<2, 3>(0, 0).copy_from(&(b * -cos));
    by_p.fixed_view_mut::<1, 3>(2, 0).copy_from(&between.transpose());
    by_p[(2, 3)] = -1.0;
    let mut by_q = SMatrix::<f64, 3, 4>::zeros();
    by_q.fixed_view_mut::<2, 3>(0, 0).copy_from(&b);
    by_q[(2, 3)] = cos;
    HypothesisTest::of(&r, &(propagate(&by_p, &p.covariance) + propagate(&by_q, &q.covariance)))
}

/// Are two lines parallel? 2 degrees of freedom.
pub fn parallel_lines(a: &UncertainLine, b: &UncertainLine) -> HypothesisTest {
    along(&direction(a), &direction(b))
}

/// Are two planes parallel? 2 degrees of freedom.
pub fn parallel_planes(p: &UncertainPlane, q: &UncertainPlane) -> HypothesisTest {
    along(&normal(p), &normal(q))
}

/// Is a line parallel to a plane? 1 degree of freedom.
pub fn line_parallel_plane(line: &UncertainLine, plane: &UncertainPlane) -> HypothesisTest {
    square(&direction(line), &normal(plane))
}

/// Are two lines, endless and perhaps skew, orthogonal? 1 degree of freedom.
pub fn orthogonal_lines(a: &UncertainLine, b: &UncertainLine) -> HypothesisTest {
    square(&direction(a), &direction(b))
}

/// Are two planes orthogonal? 1 degree of freedom.
pub fn orthogonal_planes(p: &UncertainPlane, q: &UncertainPlane) -> HypothesisTest {
    square(&normal(p), &normal(q))
}

/// Is a line orthogonal to a plane? 2 degrees of freedom.
pub fn line_orthogonal_plane(line: &UncertainLine, plane: &UncertainPlane) -> HypothesisTest {
    along(&direction(line), &normal(plane))
}

/// Do two endless lines lie in one plane? 1 degree of freedom: the volume that their ends span, per length of each.
pub fn coplanar(a: &UncertainLine, b: &UncertainLine) -> HypothesisTest {
    let (u, v, w) = (a.span(), b.start - a.start, b.end - a.start);
    let scale = 1.0 / (u.norm() * b.span().norm());
    let r = u.dot(&v.cross(&w)) * scale;
    let (by_u, by_v, by_w) = (v.cross(&w) * scale, w.cross(&u) * scale, u.cross(&v) * scale);
    let variance = |ends: (Vec3, Vec3), line: &UncertainLine| {
        let (s, e) = ends;
        let row = RowVector6::new(s.x, s.y, s.z, e.x, e.y, e.z);
        (row * line.covariance * row.transpose())[0]
    };
    HypothesisTest::of_one(r, variance((-(by_u + by_v + by_w), by_u), a) + variance((by_v, by_w), b))
}

/// A unit vector and the covariance of it.
type UncertainDirection = (Vec3, Matrix3<f64>);

fn direction(line: &UncertainLine) -> UncertainDirection {
    (line.direction(), propagate(&line.jacobian_direction(), &line.covariance))
}

fn normal(plane: &UncertainPlane) -> UncertainDirection {
    (plane.normal, plane.covariance.fixed_view::<3, 3>(0, 0).into_owned())
}

/// Do two directions lie along each other, either way?
fn along((d, of_d): &UncertainDirection, (e, of_e): &UncertainDirection) -> HypothesisTest {
    let b = basis(d);
    let facing = d.dot(e).signum();
    let cos = d.dot(e) * facing;
    let s: Matrix2<f64> = propagate(&b, of_e) + propagate(&(b * cos), of_d);
    HypothesisTest::of(&(b * (e * facing)), &s)
}

/// Are two directions at a right angle?
fn square((d, of_d): &UncertainDirection, (e, of_e): &UncertainDirection) -> HypothesisTest {
    HypothesisTest::of_one(d.dot(e), e.dot(&(of_d * e)) + d.dot(&(of_e * d)))
}

/// Two rows that make a right-handed frame with `axis`.
fn basis(axis: &Vec3) -> SMatrix<f64, 2, 3> {
    let [r, s] = perpendiculars(axis);
    SMatrix::from_rows(&[r.transpose(), s.transpose()])
}
