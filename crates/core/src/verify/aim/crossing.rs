//! Where the beams of a patch would cross a solid.
//!
//! Each beam is asked against the drawn geometry before it is asked against any sample: a triangle is projected
//! into the patch's range image and tested only against the beams under it; the nearest crossing wins. A beam so
//! tells of the one place where it should have met the object, whether at an edge, in an opening, at a
//! curved face or at a thin wall. What is drawn farther behind the place where a beam ended than a patch can tell of
//! ([`Depth`]) is not asked: rooms behind a wall are left out by the farthest beam that looks towards them.
//!
//! Glass lets beams through, and a leaf may stand open: a pane or leaf counts only where a beam met it. Every other beam
//! passes on to the parts behind. What passed a pane may as well have been mirrored by it: that it ends behind a part
//! there does not say that the part is missing.

use super::target::Target;
use super::triangle::TargetTriangle;
use crate::geometry::{Aabb, FaceKind, Vec3};
use crate::scan::{RangeImage, Window};
use crate::{Interrupt, Result, poll};

/// A pane or leaf was met when the return lies no farther from it, metres along its normal: what it may be off as built,
/// and less than what stands behind it.
const MET_M: f64 = 0.03;

/// Where one beam crosses the solid first.
#[derive(Debug, Clone, Copy)]
pub struct BeamCrossing {
    /// The beam, by slot of the view.
    pub slot: u32,
    /// The triangle crossed.
    pub triangle: u32,
    /// Distance from where the beam starts, metres.
    pub distance: f64,
    /// Whether the triangle is seen from behind.
    from_behind: bool,
    /// Where a pane of the solid lies before it, the cosine of the angle of incidence there.
    pub pane_cos: Option<f64>,
}

impl BeamCrossing {
    /// Unit normal of the crossed triangle, towards the scanner.
    pub fn normal(&self, target: &Target) -> Vec3 {
        self.turned(target, self.triangle)
    }

    /// Normal of another triangle, on the side from which the beam sees its own.
    pub fn turned(&self, target: &Target, triangle: u32) -> Vec3 {
        let normal = target.triangles[triangle as usize].normal;
        if self.from_behind { -normal } else { normal }
    }
}

/// How far along its beams a patch can tell anything, metres.
#[derive(Debug, Clone, Copy)]
pub struct Depth {
    /// From where they start.
    pub farthest: f64,
    /// Behind what they met.
    pub behind: f64,
}

impl Depth {
    #[cfg(test)]
    pub const EVERYWHERE: Self = Self { farthest: f64::INFINITY, behind: f64::INFINITY };

    /// Whether any beam towards what has these corners (from the scanner, metres), and is no nearer than `nearest` metres,
    /// can tell of it.
    pub fn reaches(&self, view: &RangeImage, corners_scanner: &[Vec3], nearest: f64) -> bool {
        let (min, max) = view.rectangle_around(corners_scanner);
        nearest <= self.of(view.farthest_in(min, max))
    }

    /// Of a beam with this range, from where it starts.
    fn of(&self, range: f64) -> f64 {
        (range + self.behind).min(self.farthest)
    }
}

/// By slot, the nearest crossing found so far.
struct Nearest {
    /// Without a crossing, how far one would tell anything.
    distance: Vec<f64>,
    triangle: Vec<u32>,
    from_behind: Vec<bool>,
}

/// The first crossing of every beam that crosses within `depth`, by slot.
pub fn crossings(target: &Target, view: &RangeImage, depth: &Depth, interrupt: Interrupt) -> Result<Vec<BeamCrossing>> {
    let origin = view.header.origin;
    let concerns = |centre_world: &Vec3, radius: f64| {
        let centre_scanner = centre_world - origin;
        let nearest = centre_scanner.norm() - radius;
        nearest <= depth.farthest
            && view.header.cone.meets_ball(&centre_scanner, radius, 0.0)
            && depth.reaches(view, &Aabb::around(&[centre_scanner]).expanded(radius).corners(), nearest)
    };
    let faces_it = |t: &usize| {
        target.triangles[*t].height_of(&origin, target.two_sided).is_some_and(|h| h.abs() <= depth.farthest)
    };
    let triangles: Vec<usize> = target.chunks(concerns).flatten().filter(faces_it).collect();
    if triangles.is_empty() {
        return Ok(Vec::new());
    }
    let mut fixed = Nearest::none(&view.ranges, depth);
    let mut optional = Nearest::none(if target.has_optional { &view.ranges } else { &[] }, depth);
    for (round, t) in triangles.into_iter().enumerate() {
        if round % 32 == 0 {
            poll(interrupt)?;
        }
        let nearest = if target.triangles[t].is_optional() { &mut optional } else { &mut fixed };
        nearest.cross(target, t, view, depth);
    }
    let first = |slot| optional.met(target, view, slot).filter(|o| o.distance < fixed.distance[slot]);
    let behind = |slot, c: BeamCrossing| {
        let is_before = |o: &BeamCrossing| {
            o.distance < c.distance && target.triangles[o.triangle as usize].kind == FaceKind::Transparent
        };
        let pane = optional.at(slot).filter(is_before);
        BeamCrossing { pane_cos: pane.map(|p| view.directions[slot].dot(&p.normal(target)).abs()), ..c }
    };
    let crossing = |slot| first(slot).or_else(|| fixed.at(slot).map(|c| behind(slot, c)));
    Ok((0..view.len()).filter_map(crossing).collect())
}

impl Nearest {
    fn none(ranges: &[f64], depth: &Depth) -> Self {
        Self {
            distance: ranges.iter().map(|range| depth.of(*range)).collect(),
            triangle: vec![TargetTriangle::NONE; ranges.len()],
            from_behind: vec![false; ranges.len()],
        }
    }

    /// The crossing of one beam.
    fn at(&self, slot: usize) -> Option<BeamCrossing> {
        let triangle = *self.triangle.get(slot).filter(|t| **t != TargetTriangle::NONE)?;
        let (distance, from_behind) = (self.distance[slot], self.from_behind[slot]);
        Some(BeamCrossing { slot: slot as u32, triangle, distance, from_behind, pane_cos: None })
    }

    /// The crossing of one beam, if it met something there.
    fn met(&self, target: &Target, view: &RangeImage, slot: usize) -> Option<BeamCrossing> {
        let is_met = |crossing: &BeamCrossing| {
            let cos = view.directions[slot].dot(&crossing.normal(target)).abs();
            ((view.ranges[slot] - crossing.distance) * cos).abs() <= MET_M
        };
        self.at(slot).filter(is_met)
    }

    /// Takes the beams for which triangle `t` is nearer than all before.
    fn cross(&mut self, target: &Target, t: usize, view: &RangeImage, depth: &Depth) {
        let triangle = &target.triangles[t];
        let corners_scanner = triangle.corners.map(|p| p - view.header.origin);
        let [a, b, c] = &corners_scanner;
        let height = a.dot(&triangle.normal);
        // Turned so that the normal looks at the scanner; a beam inside the triangle then has all three triple
        // products ≤ 0. Triangles that share an edge compute it from the same two points, so no beam slips through.
        let side = if height < 0.0 { 1.0 } else { -1.0 };
        let edges = [a.cross(b) * side, b.cross(c) * side, c.cross(a) * side];
        let normal = triangle.normal * side;
        let Some(Window { min, max, depth: nearest }) = view.window_on(&corners_scanner) else { return };
        if nearest.max(height.abs()) > depth.of(view.farthest_in(min, max)) {
            return;
        }
        for slots in view.slots_in(min, max) {
            for slot in slots {
                let d = &view.directions[slot];
                let slope = d.dot(&normal);
                let distance = height * side / slope;
                // Most beams end here: the plane looks away, or something nearer is before it.
                if slope >= 0.0 || distance >= self.distance[slot] {
                    continue;
                }
                if d.dot(&edges[0]) > 0.0 || d.dot(&edges[1]) > 0.0 || d.dot(&edges[2]) > 0.0 {
                    continue;
                }
                self.distance[slot] = distance;
                self.triangle[slot] = t as u32;
                self.from_behind[slot] = side < 0.0;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::geometry::Solid;
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
            let view = RangeImage::new(header, &content.beams);
            let got = crossings(&Target::new(solid, NEVER).unwrap(), &view, &Depth::EVERYWHERE, NEVER).unwrap();
            for slot in 0..view.len() {
                let want = first_hit(solid, &origin, &view.directions[slot]);
                let found = got.binary_search_by_key(&(slot as u32), |c| c.slot).map(|i| got[i].distance);
                let got = found.unwrap_or(f64::INFINITY);
                assert!(got == want || (got - want).abs() < 1e-9);
                crossed += usize::from(want.is_finite());
            }
        }
        assert!(crossed > 2000, "{crossed}");
    }
}
