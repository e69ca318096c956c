//! The voxels that a triangle passes through.

use crate::error::Result;
use crate::geometry::Vec3;
use crate::voxel::lattice::VoxelBox;
use crate::{Interrupt, poll_now_and_then};

/// A triangle's bounds are widened by so much before voxels are chosen by them, in voxels.
const SLACK: f64 = 1e-6;

/// Calls `visit` for every voxel of `span` that the triangle (in voxels) passes through. A voxel owns its lower faces, as
/// points do, so that a wall on a lattice plane lies in one layer of voxels.
///
/// Layer by layer along the longer of the triangle's extents across the axis that it faces most, there row by row, and
/// in them by the separating axes of triangle and box (Akenine-Möller 2001).
pub fn for_each_on_surface(
    corners: &[Vec3; 3],
    span: &VoxelBox,
    interrupt: Interrupt,
    mut visit: impl FnMut([i64; 3]) -> Result<()>,
) -> Result<()> {
    let triangle = DominantAxisTriangle::new(corners);
    let [axis, u, v] = triangle.axes;
    let [low, high] = triangle.bounds();
    let numbers = |k: usize, [low, high]: [f64; 2]| {
        let number = |c: f64| c.floor().clamp(-2e9, 2e9) as i64;
        number(low).max(span.0[k][0])..=number(high).min(span.0[k][1] - 1)
    };
    let mut round = 0;
    for i in numbers(u, [low[u], high[u]]) {
        round += 1;
        poll_now_and_then(round, interrupt)?;
        let Some([low, high]) = triangle.within(i as f64) else { continue };
        for j in numbers(v, [low[v], high[v]]) {
            let [near, far] = triangle.heights(i as f64 + 0.5, j as f64 + 0.5);
            for k in numbers(axis, [near.max(low[axis]), far.min(high[axis])]) {
                round += 1;
                poll_now_and_then(round, interrupt)?;
                let mut voxel = [0; 3];
                (voxel[axis], voxel[u], voxel[v]) = (k, i, j);
                if triangle.passes(voxel) {
                    visit(voxel)?;
                }
            }
            round += 1;
            poll_now_and_then(round, interrupt)?;
        }
    }
    Ok(())
}

/// A triangle and the order in which its voxels are gone through.
struct DominantAxisTriangle<'a> {
    corners: &'a [Vec3; 3],
    edges: [Vec3; 3],
    normal: Vec3,
    /// How far rounding moves its plane, in voxels: of a sliver far, and without area everywhere. 0 where it is nothing.
    plane_error: f64,
    /// The axis that it faces most, the longer of its extents across that, the other. One without area faces none: its
    /// longest extent is the second.
    axes: [usize; 3],
}

impl<'a> DominantAxisTriangle<'a> {
    fn new(corners: &'a [Vec3; 3]) -> Self {
        let edges = [corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]];
        let normal = edges[0].cross(&edges[1]);
        let longest = edges.iter().map(|e| e.norm()).fold(0.0, f64::max);
        let error = 4.0 * f64::EPSILON * longest.powi(3) / normal.norm();
        let plane_error = if error <= SLACK { 0.0 } else { error };
        let mut out = Self { corners, edges, normal, plane_error, axes: [0; 3] };
        let [low, high] = out.bounds();
        let extent = high - low;
        let axis = if normal[normal.iamax()] == 0.0 { extent.imin() } else { normal.iamax() };
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        out.axes = if extent[u] >= extent[v] { [axis, u, v] } else { [axis, v, u] };
        out
    }

    fn bounds(&self) -> [Vec3; 2] {
        let [a, b, c] = self.corners;
        [a.inf(b).inf(c), a.sup(b).sup(c)]
    }

    /// The bounds of what lies between `start` and `start` + 1 along the second axis: of the edges cut there, which hold
    /// the corners of the rest.
    fn within(&self, start: f64) -> Option<[Vec3; 2]> {
        let (u, walls) = (self.axes[1], [start - SLACK, start + 1.0 + SLACK]);
        let mut out: Option<[Vec3; 2]> = None;
        for (from, edge) in self.corners.iter().zip(&self.edges) {
            let at = |wall: f64| (wall - from[u]) / edge[u];
            let [first, last] = match edge[u] {
                0.0 if (walls[0]..=walls[1]).contains(&from[u]) => [0.0, 1.0],
                0.0 => continue,
                rise if rise > 0.0 => [at(walls[0]).max(0.0), at(walls[1]).min(1.0)],
                _ => [at(walls[1]).max(0.0), at(walls[0]).min(1.0)],
            };
            if first > last {
                continue;
            }
            for place in [first, last] {
                let p = from + edge * place;
                let [low, high] = out.unwrap_or([p, p]);
                out = Some([low.inf(&p), high.sup(&p)]);
            }
        }
        // The places are rounded as the coordinates are.
        let slack = SLACK + 1e-12 * self.bounds().iter().map(|b| b.amax()).fold(0.0, f64::max);
        out.map(|[low, high]| [low.add_scalar(-slack), high.add_scalar(slack)])
    }

    /// How far along the first axis the triangle's plane lies over a row of voxels, by their middle on the others.
    fn heights(&self, i: f64, j: f64) -> [f64; 2] {
        let ([axis, u, v], n) = (self.axes, &self.normal);
        if n[axis] == 0.0 {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        let height = (n.dot(&self.corners[0]) - n[u] * i - n[v] * j) / n[axis];
        let slack = 0.5 * (n[u].abs() + n[v].abs()) / n[axis].abs() + SLACK + 2.0 * self.plane_error;
        [height - slack, height + slack]
    }

    /// Whether it meets a voxel: no axis separates them.
    fn passes(&self, voxel: [i64; 3]) -> bool {
        let centre = Vec3::from(voxel.map(|i| i as f64 + 0.5));
        let c = self.corners.map(|p| p - centre);
        let extent = |axis: &Vec3| {
            c.iter().map(|p| axis.dot(p)).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], d| [a.min(d), b.max(d)])
        };
        let faces = (0..3).all(|k| {
            let [low, high] = extent(&Vec3::ith(k, 1.0));
            low < 0.5 && high >= -0.5
        });
        let apart = |axis: &Vec3, error: f64| {
            let [low, high] = extent(axis);
            let reach = 0.5 * axis.abs().sum() + error;
            low > reach || high < -reach
        };
        let across = |e: &Vec3| (0..3).any(|k| apart(&e.cross(&Vec3::ith(k, 1.0)), 0.0));
        let off_plane = || self.plane_error.is_finite() && apart(&self.normal, self.plane_error * self.normal.norm());
        faces && !off_plane() && !self.edges.iter().any(across)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

    use super::*;
    use crate::NEVER;
    use proptest::prelude::*;

    fn visited(corners: &[Vec3; 3], span: &VoxelBox) -> Vec<[i64; 3]> {
        let mut all = Vec::new();
        for_each_on_surface(corners, span, NEVER, |v| {
            all.push(v);
            Ok(())
        })
        .unwrap();
        all
    }

    /// Every voxel of the span by the separating axes.
    fn by_brute_force(corners: &[Vec3; 3], span: &VoxelBox) -> BTreeSet<[i64; 3]> {
        let triangle = DominantAxisTriangle::new(corners);
        let along = |k: usize| span.0[k][0]..span.0[k][1];
        let all = along(0).flat_map(|x| along(1).flat_map(move |y| along(2).map(move |z| [x, y, z])));
        all.filter(|&voxel| triangle.passes(voxel)).collect()
    }

    proptest! {
        /// Of any triangle, slivers and such without area among them.
        #[test]
        fn no_voxel_is_missed_and_none_met_twice(
            numbers in prop::array::uniform9(-6.0..6.0f64), round in 0..4, sliver in 0..4, place in 0.0..1.0f64)
        {
            let corner = |i: usize| Vec3::from([0, 1, 2].map(|k| match round {
                0 => numbers[3 * i + k].round(),
                1 => (2.0 * numbers[3 * i + k]).round() / 2.0,
                _ => numbers[3 * i + k],
            }));
            let (a, b) = (corner(0), corner(1));
            let c = match sliver { 0 => a + (b - a) * place, 1 => a, 2 => a + (b - a) * place + corner(2) * 1e-7, _ => corner(2) };
            let span = VoxelBox([[-5, 7]; 3]);
            let corners = [a, b, c];
            let got = visited(&corners, &span);
            let as_set: BTreeSet<[i64; 3]> = got.iter().copied().collect();
            prop_assert_eq!(got.len(), as_set.len());
            prop_assert_eq!(as_set, by_brute_force(&corners, &span));
        }
    }

    proptest! {
        /// By places on the triangle, which ask no axis.
        #[test]
        fn every_place_on_the_triangle_lies_in_a_voxel_that_was_met(
            numbers in prop::array::uniform9(-6.0..6.0f64), places in prop::collection::vec((0.0..1.0f64, 0.0..1.0f64), 50))
        {
            let [a, b, c] = [0, 3, 6].map(|i| Vec3::new(numbers[i], numbers[i + 1], numbers[i + 2]));
            let met: BTreeSet<[i64; 3]> = visited(&[a, b, c], &VoxelBox([[-7, 7]; 3])).into_iter().collect();
            for (s, t) in places {
                let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
                let p = a + (b - a) * s + (c - a) * t;
                let on_border = p.iter().any(|x| (x - x.round()).abs() < 1e-9);
                prop_assert!(on_border || met.contains(&[0, 1, 2].map(|k| p[k].floor() as i64)), "{p}");
            }
        }
    }

    /// A segment a million voxels long costs some steps a voxel, and asks whether to go on as it does.
    #[test]
    fn a_long_sliver_is_a_line_of_voxels() {
        let span = VoxelBox([[0, 1_000_000]; 3]);
        let polls = AtomicU64::new(0);
        let count = || {
            polls.fetch_add(1, Relaxed);
            false
        };
        let mut met = 0u64;
        for end in [Vec3::new(9e5, 8e5, 7e5), Vec3::new(1e5, 9e5, 0.5), Vec3::new(0.0, 1.0, 9e5)] {
            let corners = [Vec3::zeros(), end, end * 0.5];
            for_each_on_surface(&corners, &span, &count, |_| {
                met += 1;
                Ok(())
            })
            .unwrap();
        }
        assert!((2_700_000..6_000_000).contains(&met), "{met}");
        assert!(polls.load(Relaxed) < 60_000, "{polls:?}");
        // Beside the span: a million rows without a voxel, and as often asked.
        polls.store(0, Relaxed);
        let corners = [Vec3::zeros(), Vec3::new(9e5, -9e5, 0.5), Vec3::new(1.0, -2.0, 0.0)];
        for_each_on_surface(&corners, &span, &count, |_| Ok(())).unwrap();
        assert!(polls.load(Relaxed) > 800, "{polls:?}");
    }
}
