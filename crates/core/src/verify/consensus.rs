//! Do the deviations of a face's samples lie on one plane?

use nalgebra::{Matrix3, Vector3};

use crate::geometry::Vec3;
use crate::num::stats::{median, median_and_spread};
use crate::{Interrupt, Result, poll, poll_now_and_then};

/// Steepest slope of a built face against the drawn one, about 5°. What lies steeper before a face is another
/// surface that hides it: the wall it abuts on, a cupboard seen from the side.
const MAX_SLOPE: f64 = 0.087;
const ROUNDS: usize = 8;
/// Planes tried through three samples each; with 40 % of the samples elsewhere, all but one in 10⁵ runs hit a good one.
const TRIALS: u64 = 48;
/// Samples by which a trial is judged.
const JUDGES: usize = 200;

/// A plane of deviations over the face: d = a + b·u + c·v.
#[derive(Debug, Clone, Copy)]
pub struct Consensus {
    origin: Vec3,
    axes: [Vec3; 2],
    plane: Vector3<f64>,
}

impl Consensus {
    /// Robust fit to positions and deviations, metres: least median of residuals over planes through three samples
    /// (Rousseeuw 1984), bettered by Tukey's biweight. `None` without samples.
    pub fn fit(normal: &Vec3, observed: &[(Vec3, f64)], interrupt: Interrupt) -> Result<Option<Self>> {
        let Some(first) = observed.first().map(|o| o.0) else { return Ok(None) };
        let helper = if normal.z.abs() < 0.9 { Vec3::z() } else { Vec3::x() };
        let u = helper.cross(normal).normalize();
        let mut start = Self { origin: first, axes: [u, normal.cross(&u)], plane: Vector3::zeros() };
        start.plane.x = median(&mut observed.iter().map(|o| o.1).collect::<Vec<_>>()).unwrap_or(0.0);
        start.least_median(observed).bettered(observed, interrupt)
    }

    fn least_median(self, observed: &[(Vec3, f64)]) -> Self {
        let judges: Vec<&(Vec3, f64)> = observed.iter().step_by(observed.len().div_ceil(JUDGES)).collect();
        let cost = |c: &Self| {
            let mut off: Vec<f64> = judges.iter().map(|(p, d)| c.residual(p, *d).abs()).collect();
            median(&mut off).unwrap_or(f64::INFINITY)
        };
        let mut best = (cost(&self), self);
        for trial in 0..TRIALS {
            // Weyl sequences (golden ratio, √2, √3): the same samples every time, spread over the face.
            let three = [0.618_033_988_749_895, 0.414_213_562_373_095, 0.732_050_807_568_877].map(|irrational| {
                let x = ((trial + 1) as f64 * irrational).fract();
                &observed[(x * observed.len() as f64) as usize]
            });
            let rows = Matrix3::from_rows(&three.map(|(p, _)| self.row(p).transpose()));
            let Some(inverse) = rows.try_inverse() else { continue };
            let candidate = Self { plane: inverse * Vector3::from(three.map(|o| o.1)), ..self };
            let c = cost(&candidate);
            if candidate.is_face() && c < best.0 {
                best = (c, candidate);
            }
        }
        best.1
    }

    fn bettered(mut self, observed: &[(Vec3, f64)], interrupt: Interrupt) -> Result<Option<Self>> {
        for _ in 0..ROUNDS {
            poll(interrupt)?;
            let mut residuals: Vec<f64> = observed.iter().map(|(p, d)| self.residual(p, *d)).collect();
            poll(interrupt)?;
            let spread = median_and_spread(&mut residuals).map_or(0.0, |m| m.1);
            poll(interrupt)?;
            let scale = 4.685 * spread.max(2e-4);
            let (mut normal_matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
            for (i, (p, d)) in observed.iter().enumerate() {
                poll_now_and_then(i, interrupt)?;
                let r = self.residual(p, *d) / scale;
                let w = if r.abs() < 1.0 { (1.0 - r * r).powi(2) } else { 0.0 };
                let row = self.row(p);
                normal_matrix += row * row.transpose() * w;
                right += row * (w * d);
            }
            // A strip of samples has no slope across: the pseudo-inverse leaves it at zero.
            let Ok(inverse) = normal_matrix.pseudo_inverse(1e-6 * normal_matrix.norm()) else { return Ok(None) };
            self.plane = inverse * right;
        }
        Ok(Some(self))
    }

    fn row(&self, p: &Vec3) -> Vector3<f64> {
        let v = p - self.origin;
        Vector3::new(1.0, v.dot(&self.axes[0]), v.dot(&self.axes[1]))
    }

    /// Deviation against the plane's at this place.
    pub fn residual(&self, position: &Vec3, deviation: f64) -> f64 {
        deviation - self.plane.dot(&self.row(position))
    }

    /// Whether the plane could be the face itself, built displaced or tilted.
    pub fn is_face(&self) -> bool {
        self.plane.y.hypot(self.plane.z) <= MAX_SLOPE
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;

    fn grid(d: impl Fn(f64, f64) -> f64) -> Vec<(Vec3, f64)> {
        (0..400)
            .map(|i| (f64::from(i % 20) * 0.1, f64::from(i / 20) * 0.1))
            .map(|(y, z)| (Vec3::new(3.0, y, z), d(y, z)))
            .collect()
    }

    #[test]
    fn tilted_face_with_a_shelf_before_it() {
        let shelf = |y: f64, z: f64| if y < 0.7 { 0.09 } else { 0.002 + 0.02 * z };
        let c = Consensus::fit(&Vec3::x(), &grid(shelf), NEVER).unwrap().unwrap();
        assert!(c.is_face());
        assert!(c.residual(&Vec3::new(3.0, 1.5, 1.0), 0.022).abs() < 1e-3);
        assert!(c.residual(&Vec3::new(3.0, 0.2, 1.0), 0.09) > 0.05);
    }

    #[test]
    fn a_neighbour_that_hides_the_face_is_not_the_face() {
        let c = Consensus::fit(&Vec3::x(), &grid(|y, _| 0.2 * y), NEVER).unwrap().unwrap();
        assert!(!c.is_face());
        assert!(Consensus::fit(&Vec3::x(), &[], NEVER).unwrap().is_none());
        assert!(Consensus::fit(&Vec3::z(), &[(Vec3::zeros(), 0.01)], NEVER).unwrap().unwrap().is_face());
    }
}
