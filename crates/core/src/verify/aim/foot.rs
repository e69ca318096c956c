//! Where on the drawn surface a return belongs: the nearest place of the smooth surface that the beam was aimed at.
//!
//! A beam aimed at X meets the built surface at P. On a displaced plane the foot of P lies beside X by the
//! displacement times the tangent of the incidence, on a displaced column on another facet: counted at X, the
//! displacement of one place would be told of another.

use super::target::Target;
use super::triangle::TargetTriangle;
use crate::geometry::Vec3;

/// Triangles walked over at the most.
const MAX_STEPS: usize = 64;

/// The foot of a point on a surface.
#[derive(Debug, Clone, Copy)]
pub struct Foot {
    /// Triangle that it lies on.
    pub triangle: u32,
    /// World metres.
    pub place_world: Vec3,
}

/// Walks from triangle `start` to where the foot of a point (world metres) lies; `None` where the surface ends before.
pub fn foot(target: &Target, start: u32, point_world: &Vec3) -> Option<Foot> {
    let (mut here, mut before) = (start, TargetTriangle::NONE);
    for _ in 0..MAX_STEPS {
        let triangle = &target.triangles[here as usize];
        let on_plane = triangle.on_plane(point_world);
        let Some(edge) = triangle.crossed_edge(&on_plane) else {
            return Some(Foot { triangle: here, place_world: on_plane });
        };
        let next = triangle.neighbours[edge];
        if next == TargetTriangle::NONE {
            return None;
        }
        if next == before {
            // Beyond the common edge of both: the foot is on that ridge.
            return Some(Foot { triangle: here, place_world: triangle.on_edge(edge, point_world) });
        }
        (before, here) = (here, next);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::geometry::Solid;
    use rand::{Rng, SeedableRng};

    /// Brute force: the nearest of all points of the lateral surface.
    #[test]
    fn on_a_column_it_is_the_nearest_point_of_the_lateral_surface() {
        let column = Solid::cylinder([0.0; 3], 0.2, 3.0, 48).unwrap();
        let target = Target::new(&column, NEVER).unwrap();
        let lateral: Vec<u32> =
            (0..target.triangles.len() as u32).filter(|t| target.triangles[*t as usize].normal.z.abs() < 0.5).collect();
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(5);
        for _ in 0..500 {
            let angle: f64 = rng.random_range(0.0..std::f64::consts::TAU);
            let p = Vec3::new(angle.cos(), angle.sin(), 0.0) * rng.random_range(0.15..0.3)
                + Vec3::new(0.0, 0.0, rng.random_range(0.2..2.8));
            let start = lateral
                .iter()
                .copied()
                .filter(|t| target.triangles[*t as usize].normal.dot(&p) > 0.0)
                .nth(rng.random_range(0..10))
                .unwrap();
            let foot = foot(&target, start, &p).unwrap();
            let nearest = lateral
                .iter()
                .map(|t| {
                    let t = &target.triangles[*t as usize];
                    let on_plane = t.on_plane(&p);
                    match t.crossed_edge(&on_plane) {
                        None => (on_plane - p).norm(),
                        Some(_) => (0..3).map(|k| (t.on_edge(k, &p) - p).norm()).fold(f64::INFINITY, f64::min),
                    }
                })
                .fold(f64::INFINITY, f64::min);
            // Inside, the nearest facet may be another one than the walk's by the height of a chord.
            assert!(
                ((foot.place_world - p).norm() - nearest).abs() < 5e-4,
                "{p}: {} {nearest}",
                (foot.place_world - p).norm()
            );
        }
        assert!(foot(&target, lateral[0], &Vec3::new(0.3, 0.0, 3.5)).is_none());
    }
}
