//! Triangles in a tree of boxes: what a ray meets first, and what lies near a point.

use asbuilt_core::geometry::Vec3;

use crate::triangle::Triangle;

/// Most triangles of a leaf.
const LEAF: usize = 4;
/// Boxes are grown by this, metres: a flat one would be missed.
const PADDING_M: f64 = 1e-7;

/// What a ray met.
#[derive(Debug, Clone, Copy)]
pub struct Hit {
    /// Distance along the ray, metres.
    pub range: f64,
    /// Unit normal of the triangle, as drawn: it may look away from the ray.
    pub normal: Vec3,
    /// Surface of the triangle.
    pub surface: u32,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    min: Vec3,
    max: Vec3,
    /// First triangle of a leaf; of an inner node its second child, the first follows it.
    first: u32,
    /// Triangles of a leaf; 0 for an inner node.
    count: u32,
}

/// Triangles sorted into boxes.
#[derive(Debug, Default)]
pub struct Tree {
    triangles: Vec<Triangle>,
    nodes: Vec<Node>,
}

impl Tree {
    /// Sorts triangles; those without area are left out.
    pub fn new(triangles: impl IntoIterator<Item = Triangle>) -> Self {
        let triangles: Vec<Triangle> = triangles.into_iter().filter(|t| t.normal() != Vec3::zeros()).collect();
        let mut out = Self { nodes: Vec::with_capacity(triangles.len()), triangles };
        if !out.triangles.is_empty() {
            out.divide(0, out.triangles.len());
        }
        out
    }

    /// The triangles, in the order of the tree.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// Divides triangles where the boxes of both parts promise the fewest rays through them.
    fn divide(&mut self, start: usize, end: usize) {
        let range = &mut self.triangles[start..end];
        let (mut whole, mut centres) = (Extent::EMPTY, Extent::EMPTY);
        for t in range.iter() {
            whole.grow(&Extent::of(t));
            centres.grow_to(&centre(t));
        }
        let node = self.nodes.len();
        let padding = Vec3::repeat(PADDING_M);
        let (count, first) = ((end - start) as u32, start as u32);
        self.nodes.push(Node { min: whole.min - padding, max: whole.max + padding, first, count });
        let axis = (centres.max - centres.min).imax();
        if end - start <= LEAF || centres.max[axis] - centres.min[axis] <= 0.0 {
            return;
        }
        let half = divided(range, &centres, axis);
        self.divide(start, start + half);
        self.nodes[node].first = self.nodes.len() as u32;
        self.nodes[node].count = 0;
        self.divide(start + half, end);
    }

    /// The first triangle along a unit `direction` that is farther than `beyond` metres.
    pub fn first(&self, origin: &Vec3, direction: &Vec3, beyond: f64) -> Option<Hit> {
        self.first_of(origin, direction, beyond, |_| true)
    }

    /// The same of the triangles whose surface counts.
    pub fn first_of(&self, origin: &Vec3, direction: &Vec3, beyond: f64, counts: impl Fn(u32) -> bool) -> Option<Hit> {
        let inverse = direction.map(|d| 1.0 / if d.abs() < 1e-300 { 1e-300 } else { d });
        let (mut best, mut found) = (f64::INFINITY, None);
        let mut stack = [(0.0, 0u32); 64];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let (enter, at) = stack[depth];
            if enter > best {
                continue;
            }
            let node = &self.nodes[at as usize];
            if node.count > 0 {
                for t in &self.triangles[node.first as usize..(node.first + node.count) as usize] {
                    let crossing = t.crossing(origin, direction).filter(|r| *r > beyond && *r < best);
                    if let Some(range) = crossing.filter(|_| counts(t.surface)) {
                        (best, found) = (range, Some(t));
                    }
                }
                continue;
            }
            let child = |i: u32| self.nodes[i as usize].enter(origin, &inverse, best).map(|enter| (enter, i));
            let (mut near, mut far) = (child(at + 1), child(node.first));
            if matches!((near, far), (Some(a), Some(b)) if b.0 < a.0) {
                std::mem::swap(&mut near, &mut far);
            }
            for next in [far, near].into_iter().flatten() {
                stack[depth] = next;
                depth += 1;
            }
        }
        found.map(|t| Hit { range: best, normal: t.normal(), surface: t.surface })
    }

    /// Calls `visit` with every triangle whose box comes within `radius` metres of a point.
    pub fn near<'a>(&'a self, point: &Vec3, radius: f64, mut visit: impl FnMut(&'a Triangle)) {
        let mut stack = Vec::with_capacity(64);
        stack.extend((!self.nodes.is_empty()).then_some(0u32));
        while let Some(at) = stack.pop() {
            let node = &self.nodes[at as usize];
            let off = point - point.sup(&node.min).inf(&node.max);
            if off.norm_squared() > radius * radius {
                continue;
            }
            if node.count > 0 {
                self.triangles[node.first as usize..(node.first + node.count) as usize].iter().for_each(&mut visit);
            } else {
                stack.extend([at + 1, node.first]);
            }
        }
    }

    /// The smallest distance, at most `radius` metres, of a point from the triangles that are `accepted`.
    pub fn distance(&self, point: &Vec3, radius: f64, accepted: impl Fn(&Triangle) -> bool) -> Option<f64> {
        let mut best = radius;
        let mut found = false;
        self.near(point, radius, |t| {
            let distance = (t.nearest(point) - point).norm();
            if distance <= best && accepted(t) {
                (best, found) = (distance, true);
            }
        });
        found.then_some(best)
    }
}

/// Cells along an axis between which triangles may be divided.
const CELLS: usize = 16;

/// Sorts triangles into two parts by the surface area heuristic (Wald 2007), and returns where the second begins.
fn divided(range: &mut [Triangle], centres: &Extent, axis: usize) -> usize {
    let low = centres.min[axis];
    let scale = CELLS as f64 * (1.0 - 1e-9) / (centres.max[axis] - low);
    let cell = |t: &Triangle| ((centre(t)[axis] - low) * scale) as usize;
    let mut cells = [(0usize, Extent::EMPTY); CELLS];
    for t in range.iter() {
        let (count, extent) = &mut cells[cell(t).min(CELLS - 1)];
        *count += 1;
        extent.grow(&Extent::of(t));
    }
    let cost = |part: &[(usize, Extent)]| {
        let (mut count, mut extent) = (0, Extent::EMPTY);
        part.iter().for_each(|(n, e)| {
            count += n;
            extent.grow(e);
        });
        if count == 0 { f64::INFINITY } else { count as f64 * extent.area() }
    };
    let costs = (1..CELLS).map(|k| (k, cost(&cells[..k]) + cost(&cells[k..])));
    let best = costs.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(1, |b| b.0);
    range.sort_unstable_by_key(|t| cell(t).min(CELLS - 1) >= best);
    let half = range.partition_point(|t| cell(t).min(CELLS - 1) < best);
    if half == 0 || half == range.len() { range.len() / 2 } else { half }
}

/// A box.
#[derive(Debug, Clone, Copy)]
struct Extent {
    min: Vec3,
    max: Vec3,
}

impl Extent {
    const EMPTY: Self = Self {
        min: Vec3::new(f64::INFINITY, f64::INFINITY, f64::INFINITY),
        max: Vec3::new(f64::NEG_INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    fn of(t: &Triangle) -> Self {
        let [a, b, c] = &t.corners;
        Self { min: a.inf(b).inf(c), max: a.sup(b).sup(c) }
    }

    fn grow(&mut self, other: &Self) {
        (self.min, self.max) = (self.min.inf(&other.min), self.max.sup(&other.max));
    }

    fn grow_to(&mut self, point: &Vec3) {
        (self.min, self.max) = (self.min.inf(point), self.max.sup(point));
    }

    /// Half of its surface.
    fn area(&self) -> f64 {
        let size = self.max - self.min;
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

fn centre(t: &Triangle) -> Vec3 {
    (t.corners[0] + t.corners[1] + t.corners[2]) / 3.0
}

impl Node {
    /// Where a ray enters the box, if it does before `limit` metres.
    fn enter(&self, origin: &Vec3, inverse: &Vec3, limit: f64) -> Option<f64> {
        let a = (self.min - origin).component_mul(inverse);
        let b = (self.max - origin).component_mul(inverse);
        let enter = a.inf(&b).max().max(0.0);
        let leave = a.sup(&b).min();
        (enter <= leave && enter <= limit).then_some(enter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{Rng, SeedableRng};

    #[test]
    fn as_brute_force_and_in_closed_form() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        let mut point = |size: f64| Vec3::from_fn(|_, _| rng.random_range(-size..size));
        let triangles: Vec<Triangle> = (0..400)
            .map(|i| {
                let at = point(3.0);
                Triangle { corners: [at, at + point(0.4), at + point(0.4)], surface: i }
            })
            .collect();
        let tree = Tree::new(triangles.clone());
        for _ in 0..2000 {
            let (from, direction) = (point(4.0), point(1.0).normalize());
            let ranges = triangles.iter().filter_map(|t| t.crossing(&from, &direction)).filter(|r| *r > 0.1);
            let want = ranges.fold(f64::INFINITY, f64::min);
            let got = tree.first(&from, &direction, 0.1).map_or(f64::INFINITY, |h| h.range);
            assert!(got == want, "{got} {want}");
            let want = triangles.iter().map(|t| (t.nearest(&from) - from).norm()).fold(1.0, f64::min);
            assert!((tree.distance(&from, 1.0, |_| true).unwrap_or(1.0) - want).abs() < 1e-12);
        }
        // A plane x = 2 at an angle of 60°: twice as far.
        let plane = [Vec3::new(2.0, -50.0, -50.0), Vec3::new(2.0, 50.0, -50.0), Vec3::new(2.0, 0.0, 90.0)];
        let tree = Tree::new([Triangle { corners: plane, surface: 7 }]);
        let direction = Vec3::new(0.5, 0.75f64.sqrt(), 0.0);
        let hit = tree.first(&Vec3::zeros(), &direction, 0.0).unwrap();
        assert!((hit.range - 4.0).abs() < 1e-9 && hit.surface == 7 && (hit.normal.x.abs() - 1.0).abs() < 1e-9);
    }
}
