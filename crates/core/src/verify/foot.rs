//! Where on the drawn surface a return belongs: the nearest place of the smooth surface that the beam was aimed at.
//!
//! A beam aimed at X meets the built surface at P. On a displaced plane the foot of P lies beside X by the
//! displacement times the tangent of the incidence, on a displaced column on another facet: counted at X, the
//! displacement of one place would be told of another.

use super::target::{Target, Triangle};
use crate::geometry::Vec3;

/// Triangles walked over at the most.
const MAX_STEPS: usize = 64;

/// The foot of a point on a surface.
#[derive(Debug, Clone, Copy)]
pub struct Foot {
    /// Triangle that it lies on.
    pub triangle: u32,
    /// World metres.
    pub place: Vec3,
}

impl Target {
    /// Walks from triangle `start` to where the foot of `p` (world metres) lies; `None` where the surface ends before.
    pub fn foot(&self, start: u32, p: &Vec3) -> Option<Foot> {
        let (mut here, mut before) = (start, Triangle::NONE);
        for _ in 0..MAX_STEPS {
            let triangle = &self.triangles[here as usize];
            let on_plane = p - triangle.normal * triangle.normal.dot(&(p - triangle.corners[0]));
            let Some(edge) = triangle.crossed_edge(&on_plane) else {
                return Some(Foot { triangle: here, place: on_plane });
            };
            let next = triangle.neighbours[edge];
            if next == Triangle::NONE {
                return None;
            }
            if next == before {
                // Beyond the common edge of both: the foot is on that ridge.
                return Some(Foot { triangle: here, place: triangle.on_edge(edge, p) });
            }
            (before, here) = (here, next);
        }
        None
    }
}

impl Triangle {
    /// The edge that a point of its plane lies farthest beyond; `None` inside.
    fn crossed_edge(&self, p: &Vec3) -> Option<usize> {
        let mut worst = (-1e-9, None);
        for k in 0..3 {
            let (a, b) = (self.corners[k], self.corners[(k + 1) % 3]);
            let e = b - a;
            let inside = e.cross(&(p - a)).dot(&self.normal) / e.norm().max(1e-12);
            if inside < worst.0 {
                worst = (inside, Some(k));
            }
        }
        worst.1
    }

    fn on_edge(&self, k: usize, p: &Vec3) -> Vec3 {
        let (a, b) = (self.corners[k], self.corners[(k + 1) % 3]);
        let e = b - a;
        a + e * (e.dot(&(p - a)) / e.norm_squared().max(1e-24)).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::geometry::Solid;
    use rand::{Rng, SeedableRng};

    /// Brute force: the nearest of all points of the mantle.
    #[test]
    fn on_a_column_it_is_the_nearest_point_of_the_mantle() {
        let column = Solid::cylinder([0.0; 3], 0.2, 3.0, 48).unwrap();
        let target = Target::new(&column, NEVER).unwrap();
        let mantle: Vec<u32> =
            (0..target.triangles.len() as u32).filter(|t| target.triangles[*t as usize].normal.z.abs() < 0.5).collect();
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(5);
        for _ in 0..500 {
            let angle: f64 = rng.random_range(0.0..std::f64::consts::TAU);
            let p = Vec3::new(angle.cos(), angle.sin(), 0.0) * rng.random_range(0.15..0.3)
                + Vec3::new(0.0, 0.0, rng.random_range(0.2..2.8));
            let start = mantle
                .iter()
                .copied()
                .filter(|t| target.triangles[*t as usize].normal.dot(&p) > 0.0)
                .nth(rng.random_range(0..10))
                .unwrap();
            let foot = target.foot(start, &p).unwrap();
            let nearest = mantle
                .iter()
                .map(|t| {
                    let t = &target.triangles[*t as usize];
                    let on_plane = p - t.normal * t.normal.dot(&(p - t.corners[0]));
                    match t.crossed_edge(&on_plane) {
                        None => (on_plane - p).norm(),
                        Some(_) => (0..3).map(|k| (t.on_edge(k, &p) - p).norm()).fold(f64::INFINITY, f64::min),
                    }
                })
                .fold(f64::INFINITY, f64::min);
            // Inside, the nearest facet may be another one than the walk's by the height of a chord.
            assert!(((foot.place - p).norm() - nearest).abs() < 5e-4, "{p}: {} {nearest}", (foot.place - p).norm());
        }
        assert!(target.foot(mantle[0], &Vec3::new(0.3, 0.0, 3.5)).is_none());
    }
}
