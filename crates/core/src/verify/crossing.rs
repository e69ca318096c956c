//! Where the beams of a patch would cross a solid.
//!
//! Each beam is asked against the drawn geometry before it is asked against any sample: a triangle is projected
//! into the patch's range image and tested only against the beams under it; the nearest crossing wins. A beam so
//! speaks about the one place where it should have met the object, whether at an edge, in an opening, at a
//! curved face or at a thin wall.

use crate::geometry::{Closedness, Solid, Vec3};
use crate::scan::View;
use crate::{Interrupt, Result, poll, poll_now_and_then};

/// Triangles of one culling chunk.
const CHUNK: usize = 32;

/// A solid made ready to be crossed.
#[derive(Debug)]
pub struct Target {
    triangles: Vec<Triangle>,
    chunks: Vec<Ball>,
    two_sided: bool,
}

#[derive(Debug)]
struct Triangle {
    corners: [Vec3; 3],
    normal: Vec3,
}

#[derive(Debug)]
struct Ball {
    centre: Vec3,
    radius: f64,
}

/// For each beam (by slot of the view) the first crossing with the solid.
#[derive(Debug)]
pub struct Crossings {
    /// Distance from the origin, metres; infinite where the beam passes by.
    pub distance: Vec<f64>,
    /// Unit normal of the crossed face, towards the scanner.
    pub normal: Vec<Vec3>,
    /// Whether any beam crosses.
    pub any: bool,
}

impl Target {
    /// Sorts the triangles with an area into chunks of neighbours.
    pub fn new(solid: &Solid, interrupt: Interrupt) -> Result<Self> {
        let mut triangles = Vec::with_capacity(solid.triangles().len());
        for t in 0..solid.triangles().len() {
            poll_now_and_then(t, interrupt)?;
            let corners = solid.corners(t);
            let n = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
            triangles.extend(n.try_normalize(1e-12).map(|normal| Triangle { corners, normal }));
        }
        let mut chunks = Vec::with_capacity(triangles.len().div_ceil(CHUNK));
        for chunk in triangles.chunks(CHUNK) {
            poll_now_and_then(chunks.len(), interrupt)?;
            chunks.push(Ball::around(chunk));
        }
        Ok(Self { triangles, chunks, two_sided: solid.closedness() == Closedness::Open })
    }

    /// The first crossing of every beam, up to `reach` metres from the origin.
    pub fn crossings(&self, view: &View, reach: f64, interrupt: Interrupt) -> Result<Crossings> {
        let mut out = Crossings {
            distance: vec![f64::INFINITY; view.len()],
            normal: vec![Vec3::zeros(); view.len()],
            any: false,
        };
        let origin = view.header.origin;
        for (ball, chunk) in self.chunks.iter().zip(self.triangles.chunks(CHUNK)) {
            let centre = ball.centre - origin;
            if centre.norm() - ball.radius > reach || !view.header.cone.meets_ball(&centre, ball.radius, 0.0) {
                continue;
            }
            poll(interrupt)?;
            for triangle in chunk {
                triangle.cross(view, &origin, reach, self.two_sided, &mut out);
            }
        }
        Ok(out)
    }
}

impl Ball {
    fn around(triangles: &[Triangle]) -> Self {
        let corners = || triangles.iter().flat_map(|t| t.corners.iter());
        let centre = crate::geometry::Aabb::around(corners()).centre();
        Self { centre, radius: corners().map(|c| (c - centre).norm()).fold(0.0, f64::max) }
    }
}

impl Triangle {
    fn cross(&self, view: &View, origin: &Vec3, reach: f64, two_sided: bool, out: &mut Crossings) {
        let [a, b, c] = self.corners.map(|p| p - origin);
        let height = a.dot(&self.normal);
        if height == 0.0 || (height > 0.0 && !two_sided) {
            return; // edge on, or seen from behind
        }
        // Turned so that the normal looks at the scanner; a beam inside the triangle then has all three triple
        // products ≤ 0. Triangles that share an edge compute it from the same two points, so no beam slips through.
        let side = if height < 0.0 { 1.0 } else { -1.0 };
        let edges = [a.cross(&b) * side, b.cross(&c) * side, c.cross(&a) * side];
        let normal = self.normal * side;
        let (min, max) = image_rectangle(view, &[a, b, c]);
        for slots in view.slots_in(min, max) {
            for slot in slots {
                let d = &view.directions[slot];
                if d.dot(&edges[0]) > 0.0 || d.dot(&edges[1]) > 0.0 || d.dot(&edges[2]) > 0.0 {
                    continue;
                }
                let slope = d.dot(&normal);
                let t = height * side / slope;
                if slope < 0.0 && t < out.distance[slot] && t <= reach {
                    out.distance[slot] = t;
                    out.normal[slot] = normal;
                    out.any = true;
                }
            }
        }
    }
}

/// The triangle's rectangle in the image; the whole image when a corner is beside or behind the scanner.
fn image_rectangle(view: &View, corners: &[Vec3; 3]) -> ([f64; 2], [f64; 2]) {
    let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for corner in corners {
        let Some(uv) = view.project(corner) else {
            return ([f64::NEG_INFINITY; 2], [f64::INFINITY; 2]);
        };
        for k in 0..2 {
            min[k] = min[k].min(uv[k] - 1e-9);
            max[k] = max[k].max(uv[k] + 1e-9);
        }
    }
    (min, max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::scan::{Beam, Patch};
    use rand::{Rng, SeedableRng};

    /// Brute force: Möller-Trumbore on every triangle, front faces only.
    fn first_hit(solid: &Solid, origin: &Vec3, d: &Vec3) -> f64 {
        let mut best = f64::INFINITY;
        for t in 0..solid.triangles().len() {
            let [a, b, c] = solid.corners(t);
            let (e1, e2) = (b - a, c - a);
            let p = d.cross(&e2);
            let det = e1.dot(&p);
            if det <= 1e-12 {
                continue;
            }
            let s = origin - a;
            let (u, q) = (s.dot(&p) / det, s.cross(&e1));
            let (v, t) = (d.dot(&q) / det, e2.dot(&q) / det);
            if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 {
                best = best.min(t);
            }
        }
        best
    }

    #[test]
    fn equals_brute_force() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        let solids = [
            Solid::cuboid([3.0, -1.0, -1.0], [3.2, 1.0, 1.0]).unwrap(),
            Solid::cuboid([-2.0; 3], [20.0, 2.0, 2.0]).unwrap(),
            Solid::cuboid([-9.0, -9.0, -1.7], [9.0, 9.0, -1.5]).unwrap(),
            Solid::cylinder([4.0, 0.3, -1.5], 0.4, 3.0, 48).unwrap(),
        ];
        let origin = Vec3::new(0.1, 0.2, 0.3);
        let mut crossed = 0;
        for solid in &solids {
            let beams: Vec<Beam> = (0..3000)
                .map(|_| Beam {
                    offset: Vec3::new(5.0, rng.random_range(-3.0..3.0), rng.random_range(-4.0..3.0)),
                    returned: true,
                })
                .collect();
            let bytes = Patch::encode(0, origin, 2e-2, 1e-4, &beams).unwrap().to_bytes();
            let (header, content) = Patch::beams_of(&bytes).unwrap();
            let view = View::new(header, &content.beams);
            let got = Target::new(solid, NEVER).unwrap().crossings(&view, f64::INFINITY, NEVER).unwrap();
            for slot in 0..view.len() {
                let want = first_hit(solid, &origin, &view.directions[slot]);
                assert!(got.distance[slot] == want || (got.distance[slot] - want).abs() < 1e-9);
                crossed += usize::from(want.is_finite());
            }
        }
        assert!(crossed > 2000, "{crossed}");
    }
}
