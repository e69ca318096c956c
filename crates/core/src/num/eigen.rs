//! Eigenvalues and pseudo-inverses by nalgebra, whose iterations have no bound of their own: a number that is not
//! finite, or an overflow on the way, would keep them going for ever.

use nalgebra::{Const, DMatrix, Dyn, Matrix3, SMatrix, SymmetricEigen};

/// Sweeps after which nothing converges any more; the matrices here take about ten.
const MAX_SWEEPS: usize = 1000;

/// Eigenvalues and eigenvectors of a symmetric matrix; NaN where there are none. In the unit of the matrix.
pub fn of_three(m: Matrix3<f64>) -> SymmetricEigen<f64, Const<3>> {
    SymmetricEigen::try_new(m, f64::EPSILON, MAX_SWEEPS).unwrap_or_else(|| SymmetricEigen {
        eigenvalues: Matrix3::repeat(f64::NAN).column(0).into_owned(),
        eigenvectors: Matrix3::identity(),
    })
}

/// The same for a symmetric matrix of any size; NaN where there are none. In the unit of the matrix.
pub fn of_any(m: DMatrix<f64>) -> SymmetricEigen<f64, Dyn> {
    let n = m.nrows();
    SymmetricEigen::try_new(m, f64::EPSILON, MAX_SWEEPS).unwrap_or_else(|| SymmetricEigen {
        eigenvalues: nalgebra::DVector::repeat(n, f64::NAN),
        eigenvectors: DMatrix::identity(n, n),
    })
}

/// Whether nalgebra's singular values, and so its pseudo-inverse, terminate: nothing in the matrix is infinite, or
/// becomes so when squared.
pub fn is_tame<const N: usize>(m: &SMatrix<f64, N, N>) -> bool {
    m.iter().all(|x| x.abs() < 1e100)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// nalgebra's own calls do not terminate on some of these.
    #[test]
    fn everything_ends() {
        for x in [f64::NAN, f64::INFINITY, f64::MAX, 1e-320, 1e160] {
            for at in 0..9 {
                let mut m = Matrix3::new(2.0, 0.3, 0.1, 0.3, 3.0, 0.2, 0.1, 0.2, 4.0);
                m[at] = x;
                m[(at % 3) * 3 + at / 3] = x;
                let _ = of_three(m);
                let _ = of_any(DMatrix::from_iterator(3, 3, m.iter().copied()));
                if is_tame(&m) {
                    let _ = m.pseudo_inverse(1e-9);
                }
            }
        }
        assert!(!is_tame(&Matrix3::repeat(f64::NAN)) && is_tame(&Matrix3::identity()));
    }
}
