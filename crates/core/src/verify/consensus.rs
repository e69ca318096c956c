//! Do the deviations over a smooth surface follow one smooth course? Then what was met is that surface, as built.
//!
//! A plane face may be built displaced, tilted or bent: its deviations are a polynomial of second degree over it. The
//! mantle of a column or pipe is made of facets that look different ways: there d = n·(t₀ + t₁s + t₂s²), with s along
//! its axis, is a displacement, a tilt and a bow. Furniture, neighbours and edges do not follow.

use nalgebra::{Matrix3, SMatrix, SVector};

use crate::geometry::Vec3;
use crate::num::eigen;
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
/// Samples that the course is fitted to, at the most; spread evenly over the surface.
const MAX_FITTED: usize = 4_000;
/// With fewer samples than these a bend is not told from noise, with fewer than those no tilt.
const MIN_BENT: usize = 40;
const MIN_TILTED: usize = 8;
/// Deviations agree within this, metres, however precise they are: plaster, paint, rounding.
const LEAST_SCALE_M: f64 = 2e-4;

const TERMS: usize = 9;
type Row = SVector<f64, TERMS>;

/// An observed deviation, metres, at a place (local) of a face with this outward normal.
#[derive(Debug, Clone, Copy)]
pub struct Observed {
    pub position: Vec3,
    pub normal: Vec3,
    pub deviation: f64,
}

/// The course of the deviations over one smooth surface.
#[derive(Debug, Clone)]
pub struct Consensus {
    basis: Basis,
    course: Row,
    /// Robust standard deviation of the residuals, metres.
    pub spread: f64,
}

#[derive(Debug, Clone)]
struct Basis {
    origin: Vec3,
    /// Two axes over a plane face; the first is the mantle's own axis.
    axes: [Vec3; 2],
    curved: bool,
    /// Half the extent, metres: coordinates are near 1.
    scale: f64,
    terms: usize,
}

impl Consensus {
    /// Robust fit: least median of residuals over three samples each (Rousseeuw 1984), bettered by Tukey's biweight.
    /// `None` without samples.
    pub fn fit(observed: &[Observed], interrupt: Interrupt) -> Result<Option<Self>> {
        if observed.is_empty() {
            return Ok(None);
        }
        let few: Vec<Observed> = observed.iter().step_by(observed.len().div_ceil(MAX_FITTED)).copied().collect();
        let basis = Basis::of(&few);
        let mut start = Self { basis, course: Row::zeros(), spread: 0.0 };
        if !start.basis.curved {
            start.course[0] = median(&mut few.iter().map(|o| o.deviation).collect::<Vec<_>>()).unwrap_or(0.0);
        }
        start.least_median(&few).bettered(&few, interrupt)
    }

    fn least_median(self, observed: &[Observed]) -> Self {
        let judges: Vec<&Observed> = observed.iter().step_by(observed.len().div_ceil(JUDGES)).collect();
        let cost = |c: &Self| {
            let mut off: Vec<f64> = judges.iter().map(|o| c.residual(o).abs()).collect();
            median(&mut off).unwrap_or(f64::INFINITY)
        };
        let mut best = (cost(&self), self.clone());
        for trial in 0..TRIALS {
            // Weyl sequences (golden ratio, √2, √3): the same samples every time, spread over the surface.
            let three = [0.618_033_988_749_895, 0.414_213_562_373_095, 0.732_050_807_568_877].map(|irrational| {
                let x = ((trial + 1) as f64 * irrational).fract();
                &observed[(x * observed.len() as f64) as usize]
            });
            let rows = Matrix3::from_rows(&three.map(|o| self.basis.row(o).fixed_rows::<3>(0).transpose()));
            let Some(inverse) = rows.try_inverse() else { continue };
            let head = inverse * Vec3::from(three.map(|o| o.deviation));
            let mut candidate = self.clone();
            candidate.course.fixed_rows_mut::<3>(0).copy_from(&head);
            let c = cost(&candidate);
            if c < best.0 && candidate.is_surface(judges.iter().copied()) {
                best = (c, candidate);
            }
        }
        best.1
    }

    fn bettered(mut self, observed: &[Observed], interrupt: Interrupt) -> Result<Option<Self>> {
        for _ in 0..ROUNDS {
            poll(interrupt)?;
            let mut residuals: Vec<f64> = observed.iter().map(|o| self.residual(o)).collect();
            self.spread = median_and_spread(&mut residuals).map_or(0.0, |m| m.1);
            poll(interrupt)?;
            let scale = 4.685 * self.spread.max(LEAST_SCALE_M);
            let mut normal_matrix = SMatrix::<f64, TERMS, TERMS>::zeros();
            let mut right = Row::zeros();
            for (i, o) in observed.iter().enumerate() {
                poll_now_and_then(i, interrupt)?;
                let r = self.residual(o) / scale;
                let w = if r.abs() < 1.0 { (1.0 - r * r).powi(2) } else { 0.0 };
                let row = self.basis.row(o);
                normal_matrix += row * row.transpose() * w;
                right += row * (w * o.deviation);
            }
            // A strip of samples has no slope across: the pseudo-inverse leaves it at zero.
            if !eigen::is_tame(&normal_matrix) {
                return Ok(None);
            }
            let Ok(inverse) = normal_matrix.pseudo_inverse(1e-6 * normal_matrix.norm()) else { return Ok(None) };
            self.course = inverse * right;
        }
        Ok(Some(self))
    }

    /// Whether the surface is a mantle.
    pub fn is_curved(&self) -> bool {
        self.basis.curved
    }

    /// The course at a place.
    pub fn at(&self, o: &Observed) -> f64 {
        self.course.dot(&self.basis.row(o))
    }

    /// How far the surface as a whole is displaced where it passes a place, metres: of a mantle the offset of its axis,
    /// whichever way the facet there looks.
    pub fn displacement(&self, o: &Observed) -> f64 {
        if !self.basis.curved {
            return self.at(o).abs();
        }
        let s = self.basis.row(&Observed { normal: Vec3::repeat(1.0), ..*o });
        let offset = |k: usize| (0..3).map(|term| self.course[3 * term + k] * s[3 * term + k]).sum();
        Vec3::new(offset(0), offset(1), offset(2)).norm()
    }

    /// Deviation against the course's at this place.
    pub fn residual(&self, o: &Observed) -> f64 {
        o.deviation - self.at(o)
    }

    /// Whether the course could be the surface itself, built displaced, tilted or bent: nowhere too steep.
    pub fn is_surface<'a>(&self, places: impl Iterator<Item = &'a Observed>) -> bool {
        let mut slopes: Vec<f64> = places.map(|o| self.basis.slope(&self.course, o)).collect();
        median(&mut slopes).is_some_and(|s| s <= MAX_SLOPE)
    }
}

impl Basis {
    fn of(observed: &[Observed]) -> Self {
        let n = observed.len() as f64;
        let origin = observed.iter().map(|o| o.position).sum::<Vec3>() / n;
        let looks: Matrix3<f64> = observed.iter().map(|o| o.normal * o.normal.transpose() / n).sum();
        let eigen = eigen::of_three(looks);
        let normal = eigen.eigenvectors.column(eigen.eigenvalues.imax()).into_owned();
        let axis = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
        // Facets that turn by more than about 15° from their mean.
        let curved = eigen.eigenvalues.max() < 0.93;
        let first = if curved { axis } else { perpendicular(&normal) };
        let axes = [first, normal.cross(&first)];
        let extent = |a: &Vec3| observed.iter().map(|o| (o.position - origin).dot(a).abs()).fold(0.0, f64::max);
        let scale = if curved { extent(&first) } else { extent(&first).max(extent(&axes[1])) };
        let terms = match observed.len() {
            0..MIN_TILTED if !curved => 1,
            0..MIN_BENT => 3,
            _ if curved => 9,
            _ => 6,
        };
        Self { origin, axes, curved, scale: scale.max(1e-3), terms }
    }

    fn row(&self, o: &Observed) -> Row {
        let v = (o.position - self.origin) / self.scale;
        let (s, t) = (v.dot(&self.axes[0]), v.dot(&self.axes[1]));
        let n = &o.normal;
        let mut row = if self.curved {
            let q = s * s;
            Row::from([n.x, n.y, n.z, n.x * s, n.y * s, n.z * s, n.x * q, n.y * q, n.z * q])
        } else {
            Row::from([1.0, s, t, s * s, s * t, t * t, 0.0, 0.0, 0.0])
        };
        row.iter_mut().skip(self.terms).for_each(|x| *x = 0.0);
        row
    }

    /// Steepness of the course at a place: along the axis of a mantle, in any direction over a plane face.
    fn slope(&self, c: &Row, o: &Observed) -> f64 {
        let v = (o.position - self.origin) / self.scale;
        let (s, t) = (v.dot(&self.axes[0]), v.dot(&self.axes[1]));
        let rise = if self.curved {
            let term = |k: usize| Vec3::new(c[k], c[k + 1], c[k + 2]).dot(&o.normal);
            term(3) + 2.0 * s * term(6)
        } else {
            (c[1] + 2.0 * s * c[3] + t * c[4]).hypot(c[2] + 2.0 * t * c[5] + s * c[4])
        };
        rise.abs() / self.scale
    }
}

fn perpendicular(normal: &Vec3) -> Vec3 {
    let helper = if normal.z.abs() < 0.9 { Vec3::z() } else { Vec3::x() };
    helper.cross(normal).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;

    fn at(position: Vec3, deviation: f64) -> Observed {
        Observed { position, normal: Vec3::x(), deviation }
    }

    fn grid(d: impl Fn(f64, f64) -> f64) -> Vec<Observed> {
        (0..400)
            .map(|i| (f64::from(i % 20) * 0.1, f64::from(i / 20) * 0.1))
            .map(|(y, z)| at(Vec3::new(3.0, y, z), d(y, z)))
            .collect()
    }

    #[test]
    fn tilted_face_with_a_shelf_before_it() {
        let shelf = grid(|y, z| if y < 0.7 { 0.09 } else { 0.002 + 0.02 * z });
        let c = Consensus::fit(&shelf, NEVER).unwrap().unwrap();
        assert!(c.is_surface(shelf.iter()));
        assert!(c.residual(&at(Vec3::new(3.0, 1.5, 1.0), 0.022)).abs() < 1e-3);
        assert!(c.residual(&at(Vec3::new(3.0, 0.2, 1.0), 0.09)) > 0.05);
    }

    #[test]
    fn a_bent_face_and_a_bent_pipe() {
        let sine = |z: f64| 0.05 * (std::f64::consts::PI * z / 1.9).sin();
        let face = grid(|_, z| sine(z));
        let c = Consensus::fit(&face, NEVER).unwrap().unwrap();
        assert!(c.is_surface(face.iter()) && face.iter().all(|o| c.residual(o).abs() < 0.004));
        let pipe: Vec<Observed> = (0..600)
            .map(|i| (f64::from(i % 12) * 0.3 - 1.6, f64::from(i / 12) * 0.04))
            .map(|(angle, z)| {
                let normal = Vec3::new(angle.cos(), angle.sin(), 0.0);
                let deviation = normal.dot(&Vec3::new(0.03 + sine(z), 0.01, 0.0));
                Observed { position: normal * 0.1 + Vec3::new(0.0, 0.0, z), normal, deviation }
            })
            .collect();
        let c = Consensus::fit(&pipe, NEVER).unwrap().unwrap();
        assert!(c.is_surface(pipe.iter()) && pipe.iter().all(|o| c.residual(o).abs() < 0.006), "{c:?}");
    }

    #[test]
    fn a_neighbour_that_hides_the_face_is_not_the_face() {
        let neighbour = grid(|y, _| 0.2 * y);
        let c = Consensus::fit(&neighbour, NEVER).unwrap().unwrap();
        assert!(!c.is_surface(neighbour.iter()));
        assert!(Consensus::fit(&[], NEVER).unwrap().is_none());
        let one = [at(Vec3::zeros(), 0.01)];
        assert!(Consensus::fit(&one, NEVER).unwrap().unwrap().is_surface(one.iter()));
    }
}
