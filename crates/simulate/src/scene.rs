//! A scene of meshes, and what a ray meets first in it.

use asbuilt_core::geometry::{Solid, Vec3};
use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::{Bvh, BvhNode};
use bvh::ray::Ray;
use nalgebra::{Point3, Vector3};

/// Boxes are grown by this, because a flat box, or a ray along its side, would be missed.
const PADDING_M: f64 = 1e-6;

/// Everything that stands in the scene, prepared for rays.
pub struct Scene {
    triangles: Vec<Triangle>,
    tree: Bvh<f64, 3>,
}

struct Triangle([Vec3; 3]);

impl Bounded<f64, 3> for Triangle {
    fn aabb(&self) -> Aabb<f64, 3> {
        let [a, b, c] = &self.0;
        let padding = Vector3::repeat(PADDING_M);
        Aabb::with_bounds(Point3::from(a.inf(b).inf(c) - padding), Point3::from(a.sup(b).sup(c) + padding))
    }
}

impl BHShape<f64, 3> for Triangle {
    // Only asked when shapes are moved; ours stand still.
    fn set_bh_node_index(&mut self, _: usize) {}

    fn bh_node_index(&self) -> usize {
        0
    }
}

impl Scene {
    /// Sorts the triangles of all solids into a tree.
    pub fn new(solids: &[Solid]) -> Self {
        let mut triangles: Vec<Triangle> =
            solids.iter().flat_map(|s| (0..s.triangles().len()).map(|t| Triangle(s.corners(t)))).collect();
        let tree = Bvh::build_par(&mut triangles);
        Self { triangles, tree }
    }

    /// Distance to the first surface along a unit direction.
    pub fn first_hit(&self, origin: &Vec3, direction: &Vec3) -> Option<f64> {
        let inverse = direction.map(|d| if d.abs() < 1e-300 { 1e300 } else { 1.0 / d });
        let ray = Ray { origin: Point3::from(*origin), direction: *direction, inv_direction: inverse };
        let mut best = f64::INFINITY;
        let mut stack = vec![(0.0, 0usize)];
        while let Some((enter, node)) = stack.pop() {
            if enter > best || self.tree.nodes.is_empty() {
                continue;
            }
            match &self.tree.nodes[node] {
                BvhNode::Leaf { shape_index, .. } => {
                    if let Some(t) = self.triangles[*shape_index].cross(origin, direction) {
                        best = best.min(t);
                    }
                }
                BvhNode::Node { child_l_index, child_l_aabb, child_r_index, child_r_aabb, .. } => {
                    let enter = |b, i: &usize| ray.intersection_slice_for_aabb(b).map(|d| (d.0, *i));
                    let (l, r) = (enter(child_l_aabb, child_l_index), enter(child_r_aabb, child_r_index));
                    let left_first = matches!((l, r), (Some(a), Some(b)) if a.0 <= b.0);
                    let (near, far) = if left_first { (l, r) } else { (r, l) };
                    stack.extend(far);
                    stack.extend(near);
                }
            }
        }
        best.is_finite().then_some(best)
    }
}

impl Triangle {
    /// Möller & Trumbore (1997), both sides.
    fn cross(&self, origin: &Vec3, direction: &Vec3) -> Option<f64> {
        let [a, b, c] = &self.0;
        let (e1, e2) = (b - a, c - a);
        let p = direction.cross(&e2);
        let det = e1.dot(&p);
        if det.abs() < 1e-14 {
            return None;
        }
        let s = origin - a;
        let u = s.dot(&p) / det;
        let q = s.cross(&e1);
        let v = direction.dot(&q) / det;
        let t = e2.dot(&q) / det;
        let inside = u >= -1e-12 && v >= -1e-12 && u + v <= 1.0 + 1e-12;
        (inside && t > 1e-6).then_some(t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{Rng, SeedableRng};

    #[test]
    fn equals_brute_force() {
        let solids = [
            Solid::cuboid([-5.0, -5.0, -1.0], [5.0, 5.0, -0.9]).unwrap(),
            Solid::cuboid([2.0, -1.0, -1.0], [2.2, 1.0, 1.0]).unwrap(),
            Solid::cylinder([-2.0, 0.5, -1.0], 0.3, 2.0, 32).unwrap(),
        ];
        let scene = Scene::new(&solids);
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(3);
        let mut hits = 0;
        for i in 0..2000 {
            let origin = Vec3::new(0.0, 0.1, 0.2);
            let mut d: Vec3 = Vec3::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
            if i % 10 == 0 {
                d = [Vec3::x(), -Vec3::x(), Vec3::z(), -Vec3::z()][i / 10 % 4];
            }
            let want = scene.triangles.iter().filter_map(|t| t.cross(&origin, &d)).fold(f64::INFINITY, f64::min);
            let got = scene.first_hit(&origin, &d).unwrap_or(f64::INFINITY);
            assert!(got == want || (got - want).abs() < 1e-12, "{got} {want}");
            hits += usize::from(want.is_finite());
        }
        assert!(hits > 300, "{hits}");
    }
}
