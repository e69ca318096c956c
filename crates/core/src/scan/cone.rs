//! Cones of directions.

use crate::geometry::{Vec3, perpendiculars};

/// All directions within `half_angle` of `axis`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Unit vector.
    pub axis: Vec3,
    /// Radians; from π on, all directions.
    pub half_angle: f64,
}

impl Cone {
    /// The cone of all directions.
    pub const EVERYWHERE: Self = Self { axis: Vec3::new(1.0, 0.0, 0.0), half_angle: 4.0 };

    /// A small cone around unit vectors: about their mean direction, as wide as the farthest of them.
    pub fn around(directions: &[Vec3]) -> Self {
        let sum: Vec3 = directions.iter().sum();
        let axis = sum.try_normalize(1e-9).or(directions.first().copied()).unwrap_or_else(Vec3::x);
        let half_angle = directions.iter().map(|d| angle(&axis, d)).fold(0.0, f64::max);
        Self { axis, half_angle }
    }

    /// Whether the cone with its apex at the coordinate origin, widened by `margin` radians, meets a ball.
    pub fn meets_ball(&self, centre: &Vec3, radius: f64, margin: f64) -> bool {
        let distance = centre.norm();
        if distance <= radius {
            return true;
        }
        let limit = self.half_angle + margin + (radius / distance).asin();
        limit >= std::f64::consts::PI || centre.dot(&self.axis) >= distance * limit.cos()
    }

    /// Two unit vectors that complete the axis to a right-handed frame.
    pub fn basis(&self) -> [Vec3; 2] {
        perpendiculars(&self.axis)
    }
}

/// Angle between unit vectors, exact for small angles too.
fn angle(a: &Vec3, b: &Vec3) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cone_holds_its_directions_and_meets_what_it_should() {
        let dirs: Vec<Vec3> =
            (0..100).map(|i| Vec3::new(1.0, 0.01 * (i % 10) as f64, 0.01 * (i / 10) as f64).normalize()).collect();
        let cone = Cone::around(&dirs);
        assert!(dirs.iter().all(|d| angle(&cone.axis, d) <= cone.half_angle));
        assert!(cone.half_angle < 0.08);
        assert!(cone.meets_ball(&(cone.axis * 10.0), 0.0, 0.0));
        assert!(!cone.meets_ball(&(cone.axis * -10.0), 1.0, 0.0));
        assert!(cone.meets_ball(&(cone.axis * -10.0), 10.5, 0.0));
    }
}
