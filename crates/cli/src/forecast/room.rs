//! The drawn building as an obstacle, and where in it a scanner could stand.

use asbuilt_core::geometry::{Closedness, Solid, Vec3};
use asbuilt_simulate::Scene;

/// A surface no farther than this in front of a sample is the sample's own, metres.
const OWN_SURFACE_M: f64 = 0.005;
/// Clearance that a scanner needs around it, metres.
const ELBOW_M: f64 = 0.4;
/// How far beyond a crossing the search for the next one begins, metres.
const STEP_M: f64 = 1e-6;

/// All solids, as obstacles to one another's sight.
pub struct Room {
    scene: Scene,
    /// Each closed solid as a scene of its own.
    closed: Vec<(Solid, Scene)>,
}

impl Room {
    pub fn new(solids: &[Solid]) -> Self {
        let closed = solids.iter().filter(|s| s.closedness() != Closedness::Open);
        let closed = closed.map(|s| (s.clone(), Scene::new(std::slice::from_ref(s)))).collect();
        Self { scene: Scene::new(solids), closed }
    }

    /// Whether nothing stands between a scanner and a place on a surface.
    pub fn is_free(&self, from: &Vec3, to: &Vec3) -> bool {
        let sight = to - from;
        let range = sight.norm();
        range > 0.0 && self.scene.first_hit(from, &(sight / range)).is_none_or(|hit| hit >= range - OWN_SURFACE_M)
    }

    /// Whether a scanner could stand here: in no solid, and with clearance around it.
    pub fn can_stand(&self, p: &Vec3) -> bool {
        let around =
            (0..8).map(|k| f64::from(k) * std::f64::consts::FRAC_PI_4).map(|a| Vec3::new(a.cos(), a.sin(), 0.0));
        let elbow = around.into_iter().all(|d| self.scene.first_hit(p, &d).is_none_or(|hit| hit >= ELBOW_M));
        elbow && !self.closed.iter().any(|(solid, scene)| inside(solid, scene, p))
    }
}

/// By the parity of crossings along a slanting ray.
fn inside(solid: &Solid, scene: &Scene, p: &Vec3) -> bool {
    let b = solid.bounds();
    if !(0..3).all(|k| b.min[k] <= p[k] && p[k] <= b.max[k]) {
        return false;
    }
    let direction = Vec3::new(0.31, 0.17, 0.93).normalize();
    let (mut from, mut crossings) = (*p, 0);
    while let Some(hit) = scene.first_hit(&from, &direction) {
        crossings += 1;
        from += direction * (hit + STEP_M);
    }
    crossings % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stands_beside_but_not_in_or_at_a_wall() {
        let wall = Solid::cuboid([0.0, 0.0, 0.0], [4.0, 0.2, 3.0]).unwrap();
        let room = Room::new(&[wall]);
        assert!(room.can_stand(&Vec3::new(2.0, 1.0, 1.5)));
        assert!(!room.can_stand(&Vec3::new(2.0, 0.1, 1.5)));
        assert!(!room.can_stand(&Vec3::new(2.0, 0.4, 1.5)));
        assert!(room.is_free(&Vec3::new(2.0, 3.0, 1.5), &Vec3::new(1.0, 0.2, 1.0)));
        assert!(!room.is_free(&Vec3::new(2.0, 3.0, 1.5), &Vec3::new(1.0, 0.0, 1.0)));
    }
}
