//! Which part of an object lies nearest to a place: a return belongs to it.
//!
//! A beam aimed at the seat of a chair that passes its edge meets the leg: that says nothing of how far off the seat is.

use super::near_face::NearFace;
use super::target::Target;
use super::triangle::TargetTriangle;
use crate::geometry::Vec3;

impl Target {
    /// The nearest triangle that a beam with this return could have met, how far away it is (metres) and its outward
    /// normal; `None` beyond `within`.
    pub fn met_part(&self, met_world: &Vec3, direction: &Vec3, within: f64) -> Option<(f64, Vec3)> {
        let near = self.nearest(met_world, within, |t| self.two_sided || t.normal.dot(direction) < 0.0);
        near.map(|(distance, triangle)| (distance, triangle.normal))
    }

    /// The distance from a place to the surface, metres; `None` beyond `within`.
    pub fn distance(&self, place_world: &Vec3, within: f64) -> Option<f64> {
        self.nearest(place_world, within, |_| true).map(|(d, _)| d)
    }

    /// The face nearest to a place; `None` beyond `within` metres.
    pub fn near_face(&self, place_world: &Vec3, within: f64) -> Option<NearFace> {
        let (distance, triangle) = self.nearest(place_world, within, |_| true)?;
        let height = triangle.normal.dot(&(place_world - triangle.corners[0]));
        let beside = (distance * distance - height * height).max(0.0).sqrt();
        Some(NearFace { normal: triangle.normal, height, beside })
    }

    fn nearest(
        &self,
        place_world: &Vec3,
        within: f64,
        counts: impl Fn(&TargetTriangle) -> bool,
    ) -> Option<(f64, &TargetTriangle)> {
        let is_near = |t: &&TargetTriangle| t.normal.dot(&(place_world - t.corners[0])).abs() <= within && counts(t);
        let around = self.index.around(&self.triangles, place_world, within).filter(is_near);
        let near = around.map(|t| (t.distance(place_world), t)).filter(|(d, _)| *d <= within);
        near.min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::geometry::Solid;
    use rand::{Rng, SeedableRng};

    #[test]
    fn the_nearest_part_that_a_beam_could_meet() {
        let solid = Solid::cuboid([0.0; 3], [1.0, 0.4, 0.5]).unwrap();
        let target = Target::new(&solid, NEVER).unwrap();
        let near = |p: [f64; 3], d: [f64; 3]| target.met_part(&p.into(), &d.into(), 0.1).map(|(d, _)| d);
        assert!((near([-0.02, 0.2, 0.2], [1.0, 0.0, 0.0]).unwrap() - 0.02).abs() < 1e-12);
        assert!((near([-0.03, -0.04, 0.2], [1.0, 1.0, 0.0]).unwrap() - 0.05).abs() < 1e-12);
        assert_eq!(near([-0.02, 0.2, 0.2], [-1.0, 0.0, 0.0]), None);
        assert_eq!(near([-0.2, 0.2, 0.2], [1.0, 0.0, 0.0]), None);
        let face = target.near_face(&Vec3::new(-0.03, -0.04, 0.2), 0.1).unwrap();
        assert!((face.deviation().abs() - 0.05).abs() < 1e-12 && face.beside > 0.02);
        let face = target.near_face(&Vec3::new(0.5, 0.2, 0.49), 0.1).unwrap();
        assert!((face.deviation() + 0.01).abs() < 1e-12 && face.normal == Vec3::z());
    }

    /// Brute force over all triangles.
    #[test]
    fn no_triangle_is_missed() {
        let target = Target::new(&Solid::cylinder([0.0; 3], 0.3, 2.0, 300).unwrap(), NEVER).unwrap();
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(3);
        for _ in 0..2_000 {
            let p = Vec3::new(rng.random_range(-0.6..0.6), rng.random_range(-0.6..0.6), rng.random_range(-0.2..2.2));
            let brute = target.triangles.iter().map(|t| t.distance(&p)).fold(f64::INFINITY, f64::min);
            assert_eq!(target.distance(&p, 0.25), Some(brute).filter(|d| *d <= 0.25));
        }
    }
}
