//! Do the deviations over a smooth surface follow one smooth trend? Then what was met is that surface, as built.
//!
//! A plane face may be built displaced, tilted or bent: its deviations are a polynomial of second degree over it. The
//! lateral surface of a column or pipe is made of facets that look different ways: there d = n·(t₀ + t₁s + t₂s²), with
//! s along its axis, is a displacement, a tilt and a bow. Furniture, neighbours and edges do not follow.

use nalgebra::{Matrix3, SMatrix};

use super::basis::{Basis, DeviationSample, TERMS, TermVector};
use crate::geometry::Vec3;
use crate::num::eigen;
use crate::num::stats::{median, median_and_spread, tukey};
use crate::{Interrupt, Result, poll, poll_now_and_then};

/// Steepest slope of a built face against the drawn one, about 5°. What lies steeper before a face is another
/// surface that hides it: the wall it abuts on, a cupboard seen from the side.
const MAX_SLOPE: f64 = 0.087;
/// Rounds of the biweight.
const ROUNDS: usize = 8;
/// Planes tried through three samples each; with 40 % of the samples elsewhere, all but one in 10⁵ runs hit a good one.
const TRIALS: u64 = 48;
/// Samples by which a trial is judged.
const JUDGES: usize = 200;
/// Samples that the trend is fitted to, at the most; spread evenly over the surface.
const MAX_FITTED: usize = 4_000;
/// Deviations agree within this, metres, however precise they are: plaster, paint, rounding.
const MIN_SCALE_M: f64 = 2e-4;

/// The trend of the deviations over one smooth surface.
#[derive(Debug, Clone)]
pub struct DeviationTrend {
    polynomial: Polynomial,
    /// Robust standard deviation of the residuals, metres.
    pub spread: f64,
}

/// A trend as a sum of terms.
#[derive(Debug, Clone)]
struct Polynomial {
    basis: Basis,
    coefficients: TermVector,
}

/// What one sample asks of the coefficients: row · coefficients = deviation (metres).
#[derive(Debug, Clone, Copy)]
struct Equation {
    row: TermVector,
    deviation: f64,
}

impl Equation {
    fn residual(&self, coefficients: &TermVector) -> f64 {
        self.deviation - coefficients.dot(&self.row)
    }
}

impl DeviationTrend {
    /// Robust fit: least median of residuals over three samples each (Rousseeuw 1984), refined by Tukey's biweight.
    /// `None` without samples.
    pub fn fit(samples: &[DeviationSample], interrupt: Interrupt) -> Result<Option<Self>> {
        if samples.is_empty() {
            return Ok(None);
        }
        let few: Vec<DeviationSample> = samples.iter().step_by(samples.len().div_ceil(MAX_FITTED)).copied().collect();
        let level = Polynomial::level(&few);
        let equations: Vec<Equation> = few.iter().map(|o| level.equation(o)).collect();
        level.least_median(&few, &equations).refined(&equations, interrupt)
    }

    /// Whether the surface is a lateral surface.
    pub fn is_curved(&self) -> bool {
        self.polynomial.basis.curved
    }

    /// The trend at a place. Metres.
    pub fn at(&self, o: &DeviationSample) -> f64 {
        self.polynomial.at(o)
    }

    /// How far the surface as a whole is displaced where it passes a place, metres: of a lateral surface the offset of
    /// its axis, whichever way the facet there looks.
    pub fn displacement(&self, o: &DeviationSample) -> f64 {
        if !self.is_curved() {
            return self.at(o).abs();
        }
        let Polynomial { basis, coefficients } = &self.polynomial;
        let s = basis.row(&DeviationSample { normal: Vec3::repeat(1.0), ..*o });
        let offset = |k: usize| (0..3).map(|term| coefficients[3 * term + k] * s[3 * term + k]).sum();
        Vec3::new(offset(0), offset(1), offset(2)).norm()
    }

    /// Deviation against the trend's at this place. Metres.
    pub fn residual(&self, o: &DeviationSample) -> f64 {
        self.polynomial.residual(o)
    }

    /// Whether the trend could be the surface itself, built displaced, tilted or bent: nowhere too steep.
    pub fn is_surface<'a>(&self, places: impl Iterator<Item = &'a DeviationSample>) -> bool {
        self.polynomial.is_surface(places)
    }
}

impl Polynomial {
    /// The median everywhere on a plane face; a lateral surface where it is drawn.
    fn level(samples: &[DeviationSample]) -> Self {
        let basis = Basis::of(samples);
        let mut coefficients = TermVector::zeros();
        if !basis.curved {
            let mut deviations: Vec<f64> = samples.iter().map(|o| o.deviation).collect();
            coefficients[0] = median(&mut deviations).unwrap_or(0.0);
        }
        Self { basis, coefficients }
    }

    fn at(&self, o: &DeviationSample) -> f64 {
        self.coefficients.dot(&self.basis.row(o))
    }

    fn residual(&self, o: &DeviationSample) -> f64 {
        o.deviation - self.at(o)
    }

    fn is_surface<'a>(&self, places: impl Iterator<Item = &'a DeviationSample>) -> bool {
        let mut slopes: Vec<f64> = places.map(|o| self.basis.slope(&self.coefficients, o)).collect();
        median(&mut slopes).is_some_and(|s| s <= MAX_SLOPE)
    }

    fn equation(&self, o: &DeviationSample) -> Equation {
        Equation { row: self.basis.row(o), deviation: o.deviation }
    }

    fn least_median(self, samples: &[DeviationSample], equations: &[Equation]) -> Self {
        let stride = samples.len().div_ceil(JUDGES);
        let cost = |c: &Self| {
            let off = equations.iter().step_by(stride).map(|e| e.residual(&c.coefficients).abs());
            median(&mut off.collect::<Vec<_>>()).unwrap_or(f64::INFINITY)
        };
        let mut best = (cost(&self), self.clone());
        for trial in 0..TRIALS {
            // Weyl sequences (golden ratio, √2, √3): the same samples every time, spread over the surface.
            let three = [0.618_033_988_749_895, 0.414_213_562_373_095, 0.732_050_807_568_877].map(|irrational| {
                let x = ((trial + 1) as f64 * irrational).fract();
                &equations[(x * equations.len() as f64) as usize]
            });
            let Some(candidate) = self.through(three) else { continue };
            let c = cost(&candidate);
            if c < best.0 && candidate.is_surface(samples.iter().step_by(stride)) {
                best = (c, candidate);
            }
        }
        best.1
    }

    /// With other coefficients of the first three terms, so that it passes through three samples.
    fn through(&self, three: [&Equation; 3]) -> Option<Self> {
        let rows = Matrix3::from_rows(&three.map(|e| e.row.fixed_rows::<3>(0).transpose()));
        let head = rows.try_inverse()? * Vec3::from(three.map(|e| e.deviation));
        let mut candidate = self.clone();
        candidate.coefficients.fixed_rows_mut::<3>(0).copy_from(&head);
        Some(candidate)
    }

    fn refined(mut self, equations: &[Equation], interrupt: Interrupt) -> Result<Option<DeviationTrend>> {
        let mut spread = 0.0;
        for _ in 0..ROUNDS {
            poll(interrupt)?;
            let mut residuals: Vec<f64> = equations.iter().map(|e| e.residual(&self.coefficients)).collect();
            spread = median_and_spread(&mut residuals).map_or(0.0, |m| m.1);
            poll(interrupt)?;
            let scale = spread.max(MIN_SCALE_M);
            let mut normal_matrix = SMatrix::<f64, TERMS, TERMS>::zeros();
            let mut right = TermVector::zeros();
            for (i, e @ Equation { row, deviation }) in equations.iter().enumerate() {
                poll_now_and_then(i, interrupt)?;
                let w = tukey(e.residual(&self.coefficients), scale);
                normal_matrix += row * row.transpose() * w;
                right += row * (w * deviation);
            }
            // A strip of samples has no slope across: the pseudo-inverse leaves it at zero.
            if !eigen::is_tame(&normal_matrix) {
                return Ok(None);
            }
            let Ok(inverse) = normal_matrix.pseudo_inverse(1e-6 * normal_matrix.norm()) else { return Ok(None) };
            self.coefficients = inverse * right;
        }
        Ok(Some(DeviationTrend { polynomial: self, spread }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;

    fn at(position: Vec3, deviation: f64) -> DeviationSample {
        DeviationSample { position_local: position, normal: Vec3::x(), deviation }
    }

    fn grid(d: impl Fn(f64, f64) -> f64) -> Vec<DeviationSample> {
        (0..400)
            .map(|i| (f64::from(i % 20) * 0.1, f64::from(i / 20) * 0.1))
            .map(|(y, z)| at(Vec3::new(3.0, y, z), d(y, z)))
            .collect()
    }

    #[test]
    fn tilted_face_with_a_shelf_before_it() {
        let shelf = grid(|y, z| if y < 0.7 { 0.09 } else { 0.002 + 0.02 * z });
        let c = DeviationTrend::fit(&shelf, NEVER).unwrap().unwrap();
        assert!(c.is_surface(shelf.iter()));
        assert!(c.residual(&at(Vec3::new(3.0, 1.5, 1.0), 0.022)).abs() < 1e-3);
        assert!(c.residual(&at(Vec3::new(3.0, 0.2, 1.0), 0.09)) > 0.05);
    }

    #[test]
    fn a_bent_face_and_a_bent_pipe() {
        let sine = |z: f64| 0.05 * (std::f64::consts::PI * z / 1.9).sin();
        let face = grid(|_, z| sine(z));
        let c = DeviationTrend::fit(&face, NEVER).unwrap().unwrap();
        assert!(c.is_surface(face.iter()) && face.iter().all(|o| c.residual(o).abs() < 0.004));
        let pipe: Vec<DeviationSample> = (0..600)
            .map(|i| (f64::from(i % 12) * 0.3 - 1.6, f64::from(i / 12) * 0.04))
            .map(|(angle, z)| {
                let normal = Vec3::new(angle.cos(), angle.sin(), 0.0);
                let deviation = normal.dot(&Vec3::new(0.03 + sine(z), 0.01, 0.0));
                DeviationSample { position_local: normal * 0.1 + Vec3::new(0.0, 0.0, z), normal, deviation }
            })
            .collect();
        let c = DeviationTrend::fit(&pipe, NEVER).unwrap().unwrap();
        assert!(c.is_surface(pipe.iter()) && pipe.iter().all(|o| c.residual(o).abs() < 0.006), "{c:?}");
    }

    #[test]
    fn a_neighbour_that_hides_the_face_is_not_the_face() {
        let neighbour = grid(|y, _| 0.2 * y);
        let c = DeviationTrend::fit(&neighbour, NEVER).unwrap().unwrap();
        assert!(!c.is_surface(neighbour.iter()));
        assert!(DeviationTrend::fit(&[], NEVER).unwrap().is_none());
        let one = [at(Vec3::zeros(), 0.01)];
        assert!(DeviationTrend::fit(&one, NEVER).unwrap().unwrap().is_surface(one.iter()));
    }
}
