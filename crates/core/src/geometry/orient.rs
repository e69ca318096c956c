//! Turning triangles so that all look outward.

use std::collections::{HashMap, VecDeque};

use super::Vec3;
use super::weld::weld;
use crate::NEVER;

/// Turns triangles so that neighbours agree across every edge that exactly two share, and so that each
/// connected part encloses a positive volume. Returns how many triangles were turned.
///
/// For meshes whose orientation was spoilt by the modeller or by the cut of an opening. A part that is a cavity is
/// turned too, so use it only where the mesh is not closed as it stands.
pub fn orient(vertices: &[Vec3], triangles: &mut [[u32; 3]]) -> usize {
    let Ok(welded) = weld(vertices, NEVER) else { return 0 };
    let neighbours = neighbours_by_edge(&welded, triangles);
    let mut turned: Vec<Option<bool>> = vec![None; triangles.len()];
    let mut count = 0;
    for seed in 0..triangles.len() {
        if turned[seed].is_some() {
            continue;
        }
        let mut part = vec![seed];
        turned[seed] = Some(false);
        let mut queue = VecDeque::from([seed]);
        while let Some(t) = queue.pop_front() {
            for &(other, same_direction) in &neighbours[t] {
                if turned[other].is_none() {
                    turned[other] = Some((turned[t] == Some(true)) ^ same_direction);
                    part.push(other);
                    queue.push_back(other);
                }
            }
        }
        count += apply(vertices, triangles, &turned, &part);
    }
    count
}

/// Per triangle: its neighbour across each two-sided edge, and whether both run along it in the same direction
/// (then one of them must be turned).
fn neighbours_by_edge(welded: &[u32], triangles: &[[u32; 3]]) -> Vec<Vec<(usize, bool)>> {
    let mut users: HashMap<(u32, u32), Vec<(usize, bool)>> = HashMap::new();
    for (t, tri) in triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (welded[tri[k] as usize], welded[tri[(k + 1) % 3] as usize]);
            users.entry((a.min(b), a.max(b))).or_default().push((t, a < b));
        }
    }
    let mut out = vec![Vec::new(); triangles.len()];
    for pair in users.values() {
        if let [(t, along), (u, also)] = pair[..] {
            out[t].push((u, along == also));
            out[u].push((t, along == also));
        }
    }
    out
}

fn apply(vertices: &[Vec3], triangles: &mut [[u32; 3]], turned: &[Option<bool>], part: &[usize]) -> usize {
    let origin = vertices[triangles[part[0]][0] as usize];
    let volume: f64 = part
        .iter()
        .map(|&t| {
            let [a, b, c] = triangles[t].map(|i| vertices[i as usize] - origin);
            a.dot(&b.cross(&c)) * if turned[t] == Some(true) { -1.0 } else { 1.0 }
        })
        .sum();
    let mut count = 0;
    for &t in part {
        if (turned[t] == Some(true)) ^ (volume < 0.0) {
            triangles[t].swap(1, 2);
            count += 1;
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Closedness, Solid};

    #[test]
    fn spoilt_cube_is_mended() {
        let cube = Solid::cuboid([0.0; 3], [1.0, 1.0, 1.0]).unwrap();
        for mask in [0b1u32, 0b101010101010, 0b111111111111] {
            let mut t = cube.triangles().to_vec();
            for (i, tri) in t.iter_mut().enumerate() {
                if mask >> i & 1 == 1 {
                    tri.swap(0, 1);
                }
            }
            orient(cube.vertices(), &mut t);
            let mended = Solid::new(cube.vertices().to_vec(), t).unwrap();
            assert_eq!(mended.closedness(), Closedness::Closed, "{mask:b}");
            assert!((mended.volume().unwrap() - 1.0).abs() < 1e-12);
        }
    }
}
