//! Least squares over groups of observations: the solution, and the solutions without each of the groups.

use nalgebra::{SMatrix, SVector};

/// Number of groups: sectors that the scanner swept one after the other, so that what is wrong within one counts once.
pub const GROUPS: usize = 20;

/// Normal equations of `N` unknowns, by group.
pub struct Grouped<const N: usize> {
    groups: Vec<(SMatrix<f64, N, N>, SVector<f64, N>)>,
}

impl<const N: usize> Grouped<N> {
    pub fn new() -> Self {
        Self { groups: vec![(SMatrix::zeros(), SVector::zeros()); GROUPS] }
    }

    /// Adds to the group of the `i`-th of `of` observations, each unknown in a unit of its own.
    pub fn add(&mut self, i: usize, of: usize, a: &SMatrix<f64, N, N>, b: &SVector<f64, N>) {
        let group = &mut self.groups[(i * GROUPS / of.max(1)).min(GROUPS - 1)];
        group.0 += a;
        group.1 += b;
    }

    fn total(&self) -> (SMatrix<f64, N, N>, SVector<f64, N>) {
        self.groups.iter().fold((SMatrix::zeros(), SVector::zeros()), |sum, g| (sum.0 + g.0, sum.1 + g.1))
    }

    /// The solution, each unknown in a unit of its own; `None` where it is not determined.
    pub fn solution(&self) -> Option<SVector<f64, N>> {
        let (a, b) = self.total();
        solved(a, b)
    }

    /// The solutions without each group, each unknown in a unit of its own.
    pub fn without_each(&self) -> Option<Vec<SVector<f64, N>>> {
        let (a, b) = self.total();
        self.groups.iter().map(|(ga, gb)| solved(a - ga, b - gb)).collect()
    }
}

fn solved<const N: usize>(a: SMatrix<f64, N, N>, b: SVector<f64, N>) -> Option<SVector<f64, N>> {
    // Unknowns of different units: scaled to ones on the diagonal.
    let scale = SVector::<f64, N>::from_fn(|i, _| 1.0 / a[(i, i)].sqrt());
    if !scale.iter().all(|s| s.is_finite()) {
        return None;
    }
    let scaled = SMatrix::<f64, N, N>::from_fn(|i, j| a[(i, j)] * scale[i] * scale[j]);
    let x = scaled.try_inverse()? * b.component_mul(&scale);
    let x = x.component_mul(&scale);
    x.iter().all(|v| v.is_finite()).then_some(x)
}

/// Standard deviation, in the unit of the values, of a value of which these are the ones without each group.
pub fn deviation(without_each: impl Iterator<Item = f64> + Clone) -> f64 {
    let n = without_each.clone().count() as f64;
    let mean = without_each.clone().sum::<f64>() / n;
    ((n - 1.0) / n * without_each.map(|v| (v - mean).powi(2)).sum::<f64>()).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Vector2};
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    /// A line through noise, of which that of a tenth of the observations is common.
    #[test]
    fn errors_are_as_large_as_said() {
        let (mut within, mut squares) = (0, 0.0);
        const TRIALS: usize = 400;
        for seed in 0..TRIALS {
            let mut rng = ChaCha8Rng::seed_from_u64(seed as u64);
            let mut normal = || <StandardNormal as Distribution<f64>>::sample(&StandardNormal, &mut rng);
            let mut sums = Grouped::new();
            let (mut common, n) = (0.0, 1000);
            for i in 0..n {
                if i % (n / GROUPS) == 0 {
                    common = 0.3 * normal();
                }
                let x = Vector2::new(1.0, i as f64 / n as f64);
                let a: Matrix2<f64> = x * x.transpose();
                sums.add(i, n, &a, &(x * (2.0 * x[1] + common + normal())));
            }
            let error = sums.solution().unwrap()[1] - 2.0;
            let sd = deviation(sums.without_each().unwrap().iter().map(|x| x[1]));
            within += usize::from(error.abs() <= 3.0 * sd);
            squares += (error / sd).powi(2);
        }
        assert!(within * 100 >= 98 * TRIALS, "{within}");
        let ratio = (squares / TRIALS as f64).sqrt();
        assert!((0.85..1.2).contains(&ratio), "{ratio}");
    }

    #[test]
    fn what_is_not_determined_has_no_solution() {
        let mut sums = Grouped::<2>::new();
        sums.add(0, 1, &Matrix2::new(1.0, 0.0, 0.0, 0.0), &Vector2::new(1.0, 0.0));
        assert!(sums.solution().is_none());
    }
}
