//! Best-fit line and plane through uncertain points, with covariance.
//!
//! Maximum likelihood with the points' own covariances: residuals across the object, weighted by their variance in that
//! direction, by Gauss-Newton from the principal axes. Points without any uncertainty weigh alike, and the variance
//! comes from their residuals.

use nalgebra::{Matrix2, Matrix3, Matrix4, Matrix6, SMatrix, Vector2, Vector3, Vector4};

use super::covariance::propagate;
use super::line::MIN_LENGTH_M;
use super::{Stored, UncertainLine, UncertainPlane, UncertainPoint};
use crate::error::{Error, Result};
use crate::geometry::{Aabb, Vec3, perpendiculars};
use crate::num::eigen;
use crate::{Interrupt, poll_now_and_then};

const ROUNDS: usize = 10;
/// Standard deviation given to a point that is called exact among uncertain ones, metres.
const MIN_SD_M: f64 = 1e-6;
/// The points must spread by this fraction of their length in a direction to determine a direction across it.
const MIN_SPREAD: f64 = 1e-6;

struct Start {
    centre: Vec3,
    /// Principal axes, longest spread first, with their standard spreads.
    axes: [Vec3; 3],
    spread: [f64; 3],
    exact: bool,
}

impl Start {
    fn of(points: &[UncertainPoint], what: &'static str, least: usize, interrupt: Interrupt) -> Result<Self> {
        if points.len() < least {
            let reason = format!("{} points were given, {least} are needed", points.len());
            return Err(Error::Degenerate { what, reason });
        }
        let base = Aabb::around(points.iter().map(|p| &p.position)).centre();
        let n = points.len() as f64;
        let mut centre = Vec3::zeros();
        for (i, p) in points.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            centre += (p.position - base) / n;
        }
        let centre = base + centre;
        let mut scatter = Matrix3::zeros();
        for (i, p) in points.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            let d = p.position - centre;
            scatter += d * d.transpose() / n;
        }
        let eigen = eigen::of_three(scatter);
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
        Ok(Self {
            centre,
            axes: order.map(|i| eigen.eigenvectors.column(i).into_owned()),
            spread: order.map(|i| eigen.eigenvalues[i].max(0.0).sqrt()),
            exact: points.iter().all(|p| p.covariance == Matrix3::zeros()),
        })
    }
}

/// The plane that fits best, its normal's largest component positive.
pub fn plane(points: &[UncertainPoint], interrupt: Interrupt) -> Result<UncertainPlane> {
    let start = Start::of(points, "the best-fit plane", 3, interrupt)?;
    if start.spread[1] <= (MIN_SPREAD * start.spread[0]).max(MIN_LENGTH_M) {
        let reason = "the points lie on one line".into();
        return Err(Error::Degenerate { what: "the best-fit plane", reason });
    }
    let (mut c, mut n) = (start.centre, start.axes[2]);
    let mut inverse = Matrix3::zeros();
    for _ in 0..ROUNDS {
        let [r, s] = perpendiculars(&n);
        let (mut normal_matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
        for (i, p) in points.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            let d = p.position - c;
            let row = Vector3::new(d.dot(&r), d.dot(&s), -1.0);
            let w = if start.exact { 1.0 } else { 1.0 / n.dot(&(p.covariance * n)).max(MIN_SD_M.powi(2)) };
            normal_matrix += row * row.transpose() * w;
            right -= row * (w * d.dot(&n));
        }
        inverse = inverted(&normal_matrix, "the best-fit plane")?;
        let step = inverse * right;
        c += n * step.z;
        n = (n + r * step.x + s * step.y).normalize();
        if step.x.hypot(step.y) < 1e-12 && step.z.abs() < 1e-12 {
            break;
        }
    }
    if start.exact {
        let sum: f64 = points.iter().map(|p| n.dot(&(p.position - c)).powi(2)).sum();
        inverse *= sum / (points.len() as f64 - 3.0).max(1.0);
    }
    let [r, s] = perpendiculars(&n);
    let mut j = SMatrix::<f64, 4, 3>::zeros();
    j.fixed_view_mut::<3, 1>(0, 0).copy_from(&r);
    j.fixed_view_mut::<3, 1>(0, 1).copy_from(&s);
    j[(3, 2)] = 1.0;
    let covariance = propagate(&j, &inverse);
    // With the normal, tilt and offset change their signs together: the covariance stays as it is.
    UncertainPlane::centred(c, if n[n.iamax()] > 0.0 { n } else { -n }, &covariance).built()
}

/// The line that fits best, from the foot of the first extreme point to that of the last, in the points' order.
pub fn line(points: &[UncertainPoint], interrupt: Interrupt) -> Result<UncertainLine> {
    let start = Start::of(points, "the best-fit line", 2, interrupt)?;
    if start.spread[0] <= MIN_LENGTH_M {
        let reason = "the points lie in one place".into();
        return Err(Error::Degenerate { what: "the best-fit line", reason });
    }
    let (mut c, mut d) = (start.centre, start.axes[0]);
    if d.dot(&(points[points.len() - 1].position - points[0].position)) < 0.0 {
        d = -d;
    }
    let mut inverse = Matrix4::zeros();
    let mut sum = 0.0;
    for _ in 0..ROUNDS {
        let [r, s] = perpendiculars(&d);
        let b = SMatrix::<f64, 3, 2>::from_columns(&[r, s]);
        let (mut normal_matrix, mut right) = (Matrix4::zeros(), Vector4::zeros());
        sum = 0.0;
        for (i, p) in points.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            let x = p.position - c;
            let (e, t): (Vector2<f64>, f64) = (b.transpose() * x, x.dot(&d));
            sum += e.norm_squared();
            let (row, weight) = observation(p, &b, t, start.exact)?;
            normal_matrix += row.transpose() * weight * row;
            right += row.transpose() * weight * e;
        }
        inverse = inverted(&normal_matrix, "the best-fit line")?;
        let step = inverse * right;
        c += r * step[0] + s * step[1];
        d = (d + r * step[2] + s * step[3]).normalize();
        if step.amax() < 1e-12 {
            break;
        }
    }
    if start.exact {
        inverse *= sum / (2.0 * points.len() as f64 - 4.0).max(1.0);
    }
    between_extremes(points, &c, &d, &inverse, start.exact)
}

/// The segment between the feet of the two extreme points. Along the line an end is as uncertain as its point, whose
/// errors across the line moved the fit too.
fn between_extremes(
    points: &[UncertainPoint],
    c: &Vec3,
    d: &Vec3,
    inverse: &Matrix4<f64>,
    exact: bool,
) -> Result<UncertainLine> {
    let [r, s] = perpendiculars(d);
    let place = |p: &UncertainPoint| (p.position - c).dot(d);
    let order = |a: &&UncertainPoint, b: &&UncertainPoint| place(a).total_cmp(&place(b));
    let (Some(first), Some(last)) = (points.iter().min_by(order), points.iter().max_by(order)) else {
        return Err(Error::Empty { what: "the list of points" });
    };
    // Of (offsets, tilts, first along, last along).
    let mut joint = Matrix6::zeros();
    joint.fixed_view_mut::<4, 4>(0, 0).copy_from(inverse);
    let mut j = Matrix6::zeros();
    for (k, end) in [first, last].into_iter().enumerate() {
        let t = place(end);
        for (column, v) in [(0, r), (1, s), (2, r * t), (3, s * t), (4 + k, *d)] {
            j.fixed_view_mut::<3, 1>(3 * k, column).copy_from(&v);
        }
        if !exact {
            let (row, weight) = observation(end, &SMatrix::from_columns(&[r, s]), t, false)?;
            let b = SMatrix::<f64, 3, 2>::from_columns(&[r, s]);
            let mixed = inverse * row.transpose() * weight * b.transpose() * end.covariance * d;
            joint.fixed_view_mut::<4, 1>(0, 4 + k).copy_from(&mixed);
            joint.fixed_view_mut::<1, 4>(4 + k, 0).copy_from(&mixed.transpose());
            joint[(4 + k, 4 + k)] = d.dot(&(end.covariance * d));
        }
    }
    let covariance = propagate(&j, &joint);
    UncertainLine { start: c + d * place(first), end: c + d * place(last), covariance }.built()
}

/// Derivative of a point's two residuals across the line by (offsets, tilts), and their weight.
fn observation(
    p: &UncertainPoint,
    b: &SMatrix<f64, 3, 2>,
    t: f64,
    exact: bool,
) -> Result<(SMatrix<f64, 2, 4>, Matrix2<f64>)> {
    let mut row = SMatrix::<f64, 2, 4>::zeros();
    row.fixed_view_mut::<2, 2>(0, 0).fill_diagonal(1.0);
    row.fixed_view_mut::<2, 2>(0, 2).fill_diagonal(t);
    let floor = Matrix2::identity() * MIN_SD_M.powi(2);
    let weight = match exact {
        true => Matrix2::identity(),
        false => inverted(&(b.transpose() * p.covariance * b + floor), "the best-fit line")?,
    };
    Ok((row, weight))
}

fn inverted<const N: usize>(m: &SMatrix<f64, N, N>, what: &'static str) -> Result<SMatrix<f64, N, N>> {
    m.try_inverse().ok_or_else(|| Error::Degenerate { what, reason: "the points do not determine it".into() })
}
