//! One triangle: where a line crosses it, and which of its points is nearest.

use asbuilt_core::geometry::Vec3;

/// A crossing this far outside of an edge still counts (barycentric), lest rays slip between two triangles.
const EDGE: f64 = 1e-9;

/// A triangle of a surface, world metres; its corners are counter-clockwise seen from in front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Triangle {
    /// Corners.
    pub corners: [Vec3; 3],
    /// Number of the surface it belongs to.
    pub surface: u32,
}

impl Triangle {
    /// Unit normal; zero for a triangle without area.
    pub fn normal(&self) -> Vec3 {
        let [a, b, c] = &self.corners;
        (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_else(Vec3::zeros)
    }

    /// Distance along a unit `direction` at which the line from `origin` crosses it, from either side, in front of
    /// `origin` or behind it (negative). By volumes of tetrahedra: the line passes all three edges on the same side.
    pub fn crossing(&self, origin: &Vec3, direction: &Vec3) -> Option<f64> {
        let [a, b, c] = self.corners.map(|p| p - origin);
        let (u, v, w) = (direction.dot(&b.cross(&c)), direction.dot(&c.cross(&a)), direction.dot(&a.cross(&b)));
        let sum = u + v + w;
        if sum.abs() < 1e-16 {
            return None;
        }
        let least = -EDGE * sum.abs();
        let side = sum.signum();
        if u * side < least || v * side < least || w * side < least {
            return None;
        }
        Some((a * u + b * v + c * w).dot(direction) / sum)
    }

    /// The point of it nearest to `p`: Ericson, *Real-Time Collision Detection* (2005), 5.1.5.
    pub fn nearest(&self, p: &Vec3) -> Vec3 {
        let [a, b, c] = self.corners;
        let (ab, ac, ap) = (b - a, c - a, p - a);
        let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
        if d1 <= 0.0 && d2 <= 0.0 {
            return a;
        }
        let bp = p - b;
        let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
        if d3 >= 0.0 && d4 <= d3 {
            return b;
        }
        let vc = d1 * d4 - d3 * d2;
        if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
            return a + ab * (d1 / (d1 - d3));
        }
        let cp = p - c;
        let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
        if d6 >= 0.0 && d5 <= d6 {
            return c;
        }
        let vb = d5 * d2 - d1 * d6;
        if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
            return a + ac * (d2 / (d2 - d6));
        }
        let va = d3 * d6 - d5 * d4;
        if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
            return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
        }
        let denominator = 1.0 / (va + vb + vc);
        a + ab * (vb * denominator) + ac * (vc * denominator)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{Rng, SeedableRng};

    #[test]
    fn crossing_and_nearest_by_brute_force() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(5);
        for _ in 0..300 {
            let mut p = || Vec3::from_fn(|_, _| rng.random_range(-1.0..1.0));
            let t = Triangle { corners: [p(), p(), p()], surface: 0 };
            let (from, to) = (p(), p());
            let direction = (to - from).normalize();
            // A fine lattice of its points: none is nearer than the nearest, one is hardly farther.
            let lattice = (0..=60).flat_map(|i| (0..=60 - i).map(move |j| (f64::from(i) / 60.0, f64::from(j) / 60.0)));
            let [a, b, c] = t.corners;
            let least = lattice.map(|(u, v)| (a + (b - a) * u + (c - a) * v - from).norm()).fold(9.0, f64::min);
            let nearest = (t.nearest(&from) - from).norm();
            assert!(nearest <= least + 1e-12 && least < nearest + 0.06, "{nearest} {least}");
            if let Some(range) = t.crossing(&from, &direction) {
                let at = from + direction * range;
                assert!((t.nearest(&at) - at).norm() < 1e-7);
            }
        }
    }
}
