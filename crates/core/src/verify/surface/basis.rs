//! The functions whose sum a trend is: coordinates over a plane face or along a lateral surface.

use nalgebra::{Matrix3, SVector};

use crate::geometry::{Vec3, perpendiculars};
use crate::num::eigen;

/// Terms of a trend at the most.
pub const TERMS: usize = 9;
/// One number a term.
pub type TermVector = SVector<f64, TERMS>;

/// With fewer samples a bend is not told from noise.
const MIN_BENT: usize = 40;
/// With fewer samples a tilt is not told from noise.
const MIN_TILTED: usize = 8;
/// A surface is curved when its facets turn by more than about 15° from their mean: largest eigenvalue of their
/// normals.
const MAX_CURVED: f64 = 0.93;

/// A deviation, metres, at a place of a face with this outward normal.
#[derive(Debug, Clone, Copy)]
pub struct DeviationSample {
    pub position_local: Vec3,
    pub normal: Vec3,
    pub deviation: f64,
}

/// Coordinates over a smooth surface.
#[derive(Debug, Clone)]
pub struct Basis {
    origin_local: Vec3,
    /// Two axes over a plane face; the first is a lateral surface's own axis.
    axes: [Vec3; 2],
    pub curved: bool,
    /// Half the extent, metres: coordinates are near 1.
    scale: f64,
    terms: usize,
}

impl Basis {
    /// For these places.
    pub fn of(samples: &[DeviationSample]) -> Self {
        let n = samples.len() as f64;
        let origin_local = samples.iter().map(|o| o.position_local).sum::<Vec3>() / n;
        let looks: Matrix3<f64> = samples.iter().map(|o| o.normal * o.normal.transpose() / n).sum();
        let eigen = eigen::of_three(looks);
        let normal = eigen.eigenvectors.column(eigen.eigenvalues.imax()).into_owned();
        let axis = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
        let curved = eigen.eigenvalues.max() < MAX_CURVED;
        let axes = if curved { [axis, normal.cross(&axis)] } else { perpendiculars(&normal) };
        let first = axes[0];
        let off = |o: &DeviationSample, a: &Vec3| (o.position_local - origin_local).dot(a).abs();
        let extent = |a: &Vec3| samples.iter().map(|o| off(o, a)).fold(0.0, f64::max);
        let scale = if curved { extent(&first) } else { extent(&first).max(extent(&axes[1])) };
        let terms = match samples.len() {
            0..MIN_TILTED if !curved => 1,
            0..MIN_BENT => 3,
            _ if curved => 9,
            _ => 6,
        };
        Self { origin_local, axes, curved, scale: scale.max(1e-3), terms }
    }

    /// The two coordinates of a place.
    fn coordinates(&self, o: &DeviationSample) -> (f64, f64) {
        let v = (o.position_local - self.origin_local) / self.scale;
        (v.dot(&self.axes[0]), v.dot(&self.axes[1]))
    }

    /// The terms at a place.
    pub fn row(&self, o: &DeviationSample) -> TermVector {
        let (s, t) = self.coordinates(o);
        let n = &o.normal;
        let mut row = if self.curved {
            let q = s * s;
            TermVector::from([n.x, n.y, n.z, n.x * s, n.y * s, n.z * s, n.x * q, n.y * q, n.z * q])
        } else {
            TermVector::from([1.0, s, t, s * s, s * t, t * t, 0.0, 0.0, 0.0])
        };
        row.iter_mut().skip(self.terms).for_each(|x| *x = 0.0);
        row
    }

    /// Steepness of a trend at a place: along the axis of a lateral surface, in any direction over a plane face.
    pub fn slope(&self, c: &TermVector, o: &DeviationSample) -> f64 {
        let (s, t) = self.coordinates(o);
        let rise = if self.curved {
            let term = |k: usize| Vec3::new(c[k], c[k + 1], c[k + 2]).dot(&o.normal);
            term(3) + 2.0 * s * term(6)
        } else {
            (c[1] + 2.0 * s * c[3] + t * c[4]).hypot(c[2] + 2.0 * t * c[5] + s * c[4])
        };
        rise.abs() / self.scale
    }
}
