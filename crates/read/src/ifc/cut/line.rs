//! Where a straight line is inside a mesh.

use asbuilt_core::geometry::Vec3;

use crate::ifc::soup::Soup;

/// A line with two axes perpendicular to it.
pub struct ProbeLine {
    point: Vec3,
    axes: [Vec3; 3],
}

impl ProbeLine {
    /// The line through a point; `direction` is a unit vector.
    pub fn new(point: Vec3, direction: Vec3) -> Self {
        let least = (0..3).min_by(|&a, &b| direction[a].abs().total_cmp(&direction[b].abs())).unwrap_or(0);
        let mut helper = Vec3::zeros();
        helper[least] = 1.0;
        let across = direction.cross(&helper).normalize();
        Self { point, axes: [across, direction.cross(&across), direction] }
    }

    fn local(&self, world: [f64; 3]) -> Vec3 {
        let d = Vec3::from(world) - self.point;
        self.axes.map(|axis| axis.dot(&d)).into()
    }

    /// Stretches of the line inside a mesh, in order; `None` where it leaves a mesh that it never entered, which is
    /// then not closed. Where faces are drawn twice or solids overlap, what counts is whether there is any solid.
    /// `as_is` is false for meshes whose faces may all point inwards.
    pub fn inside(&self, mesh: &Soup, as_is: bool) -> Option<Vec<[f64; 2]>> {
        let local: Vec<Vec3> = mesh.vertices.iter().map(|&v| self.local(v)).collect();
        let mut crossings: Vec<(f64, i32)> = mesh.triangles.iter().filter_map(|&t| crossing(&local, t)).collect();
        crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut stretches, mut depth, mut start) = (Vec::new(), 0, 0.0);
        for (at, step) in crossings {
            let before = if as_is { depth > 0 } else { depth != 0 };
            depth += step;
            let after = if as_is { depth > 0 } else { depth != 0 };
            match (before, after) {
                (false, true) => start = at,
                (true, false) => stretches.push([start, at]),
                _ => {}
            }
        }
        (depth == 0).then_some(stretches)
    }
}

/// Where the line crosses a triangle, and whether it enters (+1) or leaves (−1). Both triangles at an edge decide by
/// the same number on which side of it the line passes, so a crossing is neither counted twice nor missed.
fn crossing(local: &[Vec3], triangle: [u32; 3]) -> Option<(f64, i32)> {
    let [a, b, c] = triangle.map(|i| local[i as usize]);
    let [x, y] = [0, 1].map(|k| (a[k].min(b[k]).min(c[k]), a[k].max(b[k]).max(c[k])));
    if x.0 > 0.0 || x.1 < 0.0 || y.0 > 0.0 || y.1 < 0.0 {
        return None;
    }
    let side = |i: usize, j: usize| {
        let (p, q, is_turned) = if triangle[i] < triangle[j] { (i, j, false) } else { (j, i, true) };
        let (p, q) = (local[triangle[p] as usize], local[triangle[q] as usize]);
        let area = p[0] * q[1] - p[1] * q[0];
        ((area >= 0.0) != is_turned, if is_turned { -area } else { area })
    };
    let ((ab, wc), (bc, wa), (ca, wb)) = (side(0, 1), side(1, 2), side(2, 0));
    if ab != bc || bc != ca {
        return None;
    }
    let sum = wa + wb + wc;
    let at = if sum == 0.0 { (a[2] + b[2] + c[2]) / 3.0 } else { (wa * a[2] + wb * b[2] + wc * c[2]) / sum };
    // Seen along the line, a face that looks against it turns clockwise.
    Some((at, if ab { -1 } else { 1 }))
}

/// What is in `a` and not in `b`; both in order and without overlap.
pub fn without(a: &[[f64; 2]], b: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut out = Vec::new();
    for &[mut from, to] in a {
        for &[start, end] in b {
            if end <= from || start >= to {
                continue;
            }
            if start > from {
                out.push([from, start]);
            }
            from = from.max(end);
        }
        if to > from {
            out.push([from, to]);
        }
    }
    out
}

/// What is in any of them, in order.
pub fn union(mut all: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut out: Vec<[f64; 2]> = Vec::new();
    for s in all {
        match out.last_mut() {
            Some(last) if s[0] <= last[1] => last[1] = last[1].max(s[1]),
            _ => out.push(s),
        }
    }
    out
}

#[cfg(test)]
pub mod tests {
    use super::*;

    pub fn cuboid(low: [f64; 3], high: [f64; 3]) -> Soup {
        let mut soup = Soup::default();
        let corner = |i: usize| [0, 1, 2].map(|k| if i >> k & 1 == 0 { low[k] } else { high[k] } as f32).to_vec();
        let positions: Vec<f32> = (0..8).flat_map(corner).collect();
        let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let indices: Vec<u32> = quads.iter().flat_map(|q| [q[0], q[1], q[2], q[0], q[2], q[3]]).collect();
        soup.add(&positions, &indices, |p| p);
        soup
    }

    #[test]
    fn stretches_inside_a_box() {
        let mesh = cuboid([0.0; 3], [4.0, 2.0, 1.0]);
        assert!((mesh.volume() - 8.0).abs() < 1e-6);
        // Through the diagonal of a face, an edge, and beside it.
        for (point, length) in [([1.0, 1.0, 0.5], 2.0), ([1.0, 1.0, 0.0], 2.0), ([9.0, 1.0, 0.5], 0.0)] {
            let line = ProbeLine::new(point.into(), Vec3::y());
            let inside: f64 = line.inside(&mesh, true).unwrap().iter().map(|s| s[1] - s[0]).sum();
            assert!((inside - length).abs() < 1e-9 || point[2] == 0.0, "{point:?}: {inside}");
        }
        let mut open = mesh.clone();
        open.triangles.truncate(10);
        assert!(ProbeLine::new([2.0, 0.7, 0.3].into(), Vec3::x()).inside(&open, true).is_none());
    }

    #[test]
    fn stretches_reckoned() {
        assert_eq!(without(&[[0.0, 4.0]], &[[1.0, 2.0], [3.0, 9.0]]), [[0.0, 1.0], [2.0, 3.0]]);
        assert_eq!(union(vec![[2.0, 3.0], [0.0, 1.0], [0.5, 2.0]]), [[0.0, 3.0]]);
    }
}
