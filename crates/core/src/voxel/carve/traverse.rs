//! Exact traversal of a segment, voxel by voxel (Amanatides and Woo 1987).

use crate::geometry::Vec3;

/// Calls `visit` for every voxel that the segment from `start` to `end` (in voxels) passes through, in order. A voxel
/// of which it only touches an edge or a corner may be visited or not. Boundaries are computed from their numbers, not
/// by adding up steps, so that nothing drifts along a long beam.
pub fn traverse(start: &Vec3, end: &Vec3, mut visit: impl FnMut([i64; 3])) {
    let direction = end - start;
    let mut at: [i64; 3] = start.map(|c| c.floor() as i64).into();
    let inverse = direction.map(f64::recip);
    let next = |axis: usize, i: i64| match direction[axis] {
        d if d > 0.0 => ((i + 1) as f64 - start[axis]) * inverse[axis],
        d if d < 0.0 => (i as f64 - start[axis]) * inverse[axis],
        _ => f64::INFINITY,
    };
    let mut boundary = [0, 1, 2].map(|axis| next(axis, at[axis]));
    visit(at);
    loop {
        let axis = if boundary[0] < boundary[1] { 0 } else { 1 };
        let axis = if boundary[2] < boundary[axis] { 2 } else { axis };
        if boundary[axis].is_nan() || boundary[axis] >= 1.0 {
            return;
        }
        at[axis] += if direction[axis] > 0.0 { 1 } else { -1 };
        boundary[axis] = next(axis, at[axis]);
        visit(at);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::HashSet;

    /// Length of the segment inside a voxel, by clipping it against the six faces.
    fn length_inside(start: &Vec3, end: &Vec3, voxel: [i64; 3]) -> f64 {
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for axis in 0..3 {
            let (lo, hi) = (voxel[axis] as f64, (voxel[axis] + 1) as f64);
            let (s, d) = (start[axis], end[axis] - start[axis]);
            if d == 0.0 {
                if s < lo || s > hi {
                    return -1.0;
                }
                continue;
            }
            let (a, b) = ((lo - s) / d, (hi - s) / d);
            from = from.max(a.min(b));
            to = to.min(a.max(b));
        }
        (to - from) * (end - start).norm()
    }

    proptest! {
        /// Every voxel that a segment passes through is visited once, and no other.
        #[test]
        fn nothing_is_missed(
            s in prop::array::uniform3(-9.0..9.0f64),
            e in prop::array::uniform3(-9.0..9.0f64),
            flat in 0usize..8,
            whole: bool,
        ) {
            let round = |c: f64| if whole { c.round() } else { c };
            let start = Vec3::from(s.map(round));
            let mut end = Vec3::from(e.map(round));
            (0..3).filter(|axis| flat >> axis & 1 == 1).for_each(|axis| end[axis] = start[axis]);
            let mut visited = Vec::new();
            traverse(&start, &end, |v| visited.push(v));
            let set: HashSet<[i64; 3]> = visited.iter().copied().collect();
            prop_assert_eq!(set.len(), visited.len());
            for x in -10..10 { for y in -10..10 { for z in -10..10 {
                let inside = length_inside(&start, &end, [x, y, z]);
                // Along a face or an edge of voxels it lies in all of them: one is enough.
                let along = (0..3).any(|k| end[k] == start[k] && start[k] == start[k].round());
                let visited = set.contains(&[x, y, z]);
                prop_assert!(inside <= 1e-9 || along || visited, "{:?} missed {}", [x, y, z], inside);
                prop_assert!(inside >= -1e-9 || !visited, "{:?} wrongly visited {}", [x, y, z], inside);
            }}}
        }
    }
}
