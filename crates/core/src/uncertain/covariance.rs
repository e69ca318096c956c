//! Covariance matrices: checked, packed, propagated.

use nalgebra::{DMatrix, Dyn, SMatrix, SVector, SymmetricEigen};

use crate::error::{Error, Result};
use crate::num::chi_square;
use crate::num::eigen;

/// A correlation eigenvalue below this counts as zero: rank is judged independently of units.
const RANK_TOLERANCE: f64 = 1e-13;
/// Deviation that a direction without any variance may show, metres or radians: rounding of projected coordinates.
const EXACT_TOLERANCE: f64 = 1e-8;
/// A scaled eigenvalue above the negative of this is negative only by rounding.
const ROUNDING: f64 = 1e-8;
/// In the check for a covariance a variance counts for no less than this fraction of the largest entry: anything below
/// is what rounding left of propagation.
const MIN_SHARE: f64 = 1e-6;

/// Checks that `m` is finite, symmetric and positive semi-definite (to rounding) and returns it exactly symmetric.
/// In the unit of the matrix.
pub fn checked<const N: usize>(what: &'static str, m: &SMatrix<f64, N, N>) -> Result<SMatrix<f64, N, N>> {
    if let Some(x) = m.iter().find(|x| !x.is_finite()) {
        return Err(Error::argument(what, "finite", x));
    }
    let asymmetry = (m - m.transpose()).amax();
    if asymmetry > 1e-9 * m.amax() {
        return Err(Error::Covariance { what, reason: format!("not symmetric: two entries differ by {asymmetry:e}") });
    }
    let symmetric = (m + m.transpose()) * 0.5;
    if smallest_eigenvalue(&divided(&symmetric, &scale_of(&symmetric))) < -ROUNDING {
        let smallest = smallest_eigenvalue(&symmetric);
        let reason = format!("not positive semi-definite: its smallest eigenvalue is {smallest:e}");
        return Err(Error::Covariance { what, reason });
    }
    Ok(symmetric)
}

/// The same matrix, or, where cancellation left it with negative eigenvalues (a transform with a lever as long as a
/// projected system, taken back), the nearest one without, in the scaled sense. In the unit of the matrix.
pub fn settled<const N: usize>(m: &SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    let scale = scale_of(m);
    if m.iter().any(|x| !x.is_finite()) {
        return *m;
    }
    let eigen = eigen_of(&divided(m, &scale));
    if eigen.eigenvalues.min() >= -0.1 * ROUNDING {
        return *m;
    }
    let clamped = &eigen.eigenvectors
        * DMatrix::from_diagonal(&eigen.eigenvalues.map(|v| v.max(0.0)))
        * eigen.eigenvectors.transpose();
    let back = SMatrix::<f64, N, N>::from_fn(|i, j| clamped[(i, j)] * scale[i] * scale[j]);
    (back + back.transpose()) * 0.5
}

/// Standard deviations, none smaller than the fraction of the largest that rounding leaves.
fn scale_of<const N: usize>(m: &SMatrix<f64, N, N>) -> SVector<f64, N> {
    let floor = (MIN_SHARE * m.amax()).max(f64::MIN_POSITIVE);
    SVector::from_fn(|i, _| m[(i, i)].max(floor).sqrt())
}

fn smallest_eigenvalue<const N: usize>(m: &SMatrix<f64, N, N>) -> f64 {
    eigen_of(m).eigenvalues.min()
}

fn eigen_of<const N: usize>(m: &SMatrix<f64, N, N>) -> SymmetricEigen<f64, Dyn> {
    eigen::of_any(DMatrix::from_iterator(N, N, m.iter().copied()))
}

/// The matrix scaled to a unit diagonal, and the scales; rows without variance keep theirs. By Sylvester's law the
/// signs of the eigenvalues stay the same, but units no longer matter.
fn correlation<const N: usize>(m: &SMatrix<f64, N, N>) -> (SMatrix<f64, N, N>, SVector<f64, N>) {
    let scale = SVector::<f64, N>::from_fn(|i, _| if m[(i, i)] > 0.0 { m[(i, i)].sqrt() } else { 1.0 });
    (divided(m, &scale), scale)
}

fn divided<const N: usize>(m: &SMatrix<f64, N, N>, scale: &SVector<f64, N>) -> SMatrix<f64, N, N> {
    SMatrix::from_fn(|i, j| m[(i, j)] / scale[i] / scale[j])
}

/// J Σ Jᵀ, exactly symmetric.
pub fn propagate<const N: usize, const M: usize>(
    jacobian: &SMatrix<f64, M, N>,
    covariance: &SMatrix<f64, N, N>,
) -> SMatrix<f64, M, M> {
    let m = jacobian * covariance * jacobian.transpose();
    (m + m.transpose()) * 0.5
}

/// Statistic rᵀ S⁺ r of a residual and its covariance, with the rank of S as degrees of freedom.
///
/// Where S is singular the pseudo-inverse is taken and the degrees of freedom are fewer. A residual along a direction
/// without any variance is a contradiction: the statistic is then infinite.
pub fn mahalanobis_squared<const K: usize>(residual: &SVector<f64, K>, s: &SMatrix<f64, K, K>) -> (f64, u32) {
    if K == 1 {
        return one_direction(residual[0], s[(0, 0)]);
    }
    let (c, scale) = correlation(s);
    let eigen = eigen_of(&c);
    let scaled = residual.component_div(&scale);
    let (mut statistic, mut dof) = (0.0, 0);
    for (lambda, direction) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
        let direction = SVector::<f64, K>::from_fn(|i, _| direction[i]);
        let along = scaled.dot(&direction);
        if *lambda > RANK_TOLERANCE {
            statistic += along * along / lambda;
            dof += 1;
        } else if (scale.component_mul(&direction) * along).norm() > EXACT_TOLERANCE {
            statistic = f64::INFINITY;
        }
    }
    (statistic, dof)
}

fn one_direction(residual: f64, variance: f64) -> (f64, u32) {
    if variance > 0.0 {
        (residual * residual / variance, 1)
    } else {
        (if residual.abs() > EXACT_TOLERANCE { f64::INFINITY } else { 0.0 }, 0)
    }
}

/// The factor by which a standard ellipsoid in `dimensions` grows to hold the truth with `probability`.
pub fn confidence_factor(probability: f64, dimensions: u32) -> Result<f64> {
    if !(probability > 0.0 && probability < 1.0) {
        return Err(Error::argument("the probability", "between 0 and 1, both excluded", probability));
    }
    Ok(chi_square::quantile(probability, dimensions).sqrt())
}
