//! Axes across an axis.

use super::Vec3;

/// Two unit vectors that make a right-handed frame with a unit vector.
pub fn perpendiculars(axis: &Vec3) -> [Vec3; 2] {
    let helper = if axis.z.abs() < 0.9 { Vec3::z() } else { Vec3::x() };
    let u = helper.cross(axis).normalize();
    [u, axis.cross(&u)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frame_is_right_handed() {
        for axis in [Vec3::x(), Vec3::z(), Vec3::new(1.0, 2.0, -3.0).normalize()] {
            let [u, v] = perpendiculars(&axis);
            assert!((u.cross(&v) - axis).norm() < 1e-12);
        }
    }
}
