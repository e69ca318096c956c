//! Solids prepared for a kernel that needs every edge matched and no two faces in one plane.

use std::collections::HashMap;

use asbuilt_core::geometry::Vec3;

use crate::ifc::soup::Soup;

/// Vertices nearer than this to each other coincide, and to an edge lie on it, metres.
const WELD_M: f64 = 1e-6;
const ON_EDGE_M: f64 = 1e-5;

/// The mesh with vertices welded, and with triangles split where other vertices lie on their edges: the library's
/// half-spaces leave such edges.
pub fn stitched(mesh: &Soup) -> Soup {
    let mut soup = welded(mesh);
    for _ in 0..8 {
        if !split_border(&mut soup) {
            break;
        }
    }
    soup
}

fn welded(mesh: &Soup) -> Soup {
    let mut cells: HashMap<[i64; 3], u32> = HashMap::new();
    let mut soup = Soup::default();
    let ids: Vec<Option<u32>> = mesh
        .vertices
        .iter()
        .map(|&v| {
            let cell = v.map(|c| (c / WELD_M).round() as i64);
            let near = (0..27).map(|n| [cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1]);
            let known = near.filter_map(|c| cells.get(&c)).next().copied();
            let id = known.or_else(|| soup.vertex(v))?;
            cells.entry(cell).or_insert(id);
            Some(id)
        })
        .collect();
    for t in &mesh.triangles {
        if let [Some(a), Some(b), Some(c)] = t.map(|i| ids[i as usize]) {
            soup.triangle([a, b, c]);
        }
    }
    soup
}

/// Splits a triangle at each edge that no other matches and on which vertices lie.
fn split_border(soup: &mut Soup) -> bool {
    let border = soup.border();
    let ends: Vec<u32> = {
        let mut all: Vec<u32> = border.iter().flat_map(|(a, b)| [*a, *b]).collect();
        all.sort_unstable();
        all.dedup();
        all
    };
    let (mut out, mut is_split) = (Vec::new(), false);
    for &t in &soup.triangles {
        let edge = (0..3).find_map(|k| {
            let [a, b, c] = [t[k], t[(k + 1) % 3], t[(k + 2) % 3]];
            let on = if border.contains(&(a, b)) { between(soup, &ends, a, b) } else { Vec::new() };
            // A vertex opposite on the edge itself would leave nothing but a sliver turned over.
            (!on.is_empty() && !on.contains(&c)).then_some((a, b, c, on))
        });
        let Some((a, b, c, on)) = edge else {
            out.push(t);
            continue;
        };
        is_split = true;
        let chain: Vec<u32> = std::iter::once(a).chain(on).chain([b]).collect();
        out.extend(chain.windows(2).map(|w| [w[0], w[1], c]));
    }
    soup.triangles = out;
    is_split
}

/// Which of some vertices lie on an edge, in order.
fn between(soup: &Soup, vertices: &[u32], a: u32, b: u32) -> Vec<u32> {
    let at = |i: u32| Vec3::from(soup.vertices[i as usize]);
    let (start, along) = (at(a), at(b) - at(a));
    let place = |i: u32| {
        let d = at(i) - start;
        let s = d.dot(&along) / along.norm_squared();
        let off = d - along * s;
        (s > 0.0 && s < 1.0 && off.norm_squared() < ON_EDGE_M * ON_EDGE_M).then_some((s, i))
    };
    let mut on: Vec<(f64, u32)> = vertices.iter().filter(|&&i| i != a && i != b).filter_map(|&i| place(i)).collect();
    on.sort_by(|x, y| x.0.total_cmp(&y.0));
    on.into_iter().map(|(_, i)| i).collect()
}

/// A solid whose faces are moved outwards by this much, so that no face stays in the plane of another solid's.
pub fn enlarged(mesh: &Soup, by: f64) -> Soup {
    let by = if mesh.volume() < 0.0 { -by } else { by };
    let mut normals: Vec<Vec<Vec3>> = vec![Vec::new(); mesh.vertices.len()];
    for (t, triangle) in mesh.triangles.iter().enumerate() {
        let normal = mesh.normal(t);
        if normal.norm_squared() > 0.0 {
            triangle.iter().for_each(|&i| normals[i as usize].push(normal.normalize()));
        }
    }
    let mut soup = mesh.clone();
    for (vertex, normals) in soup.vertices.iter_mut().zip(&normals) {
        let mut step = Vec3::zeros();
        for _ in 0..24 {
            for n in normals {
                step += n * (by - n.dot(&step));
            }
        }
        let length = step.norm();
        let short = if length > 4.0 * by.abs() { 4.0 * by.abs() / length } else { 1.0 };
        (0..3).for_each(|k| vertex[k] += short * step[k]);
    }
    soup
}

#[cfg(test)]
mod tests {
    use super::super::line::tests::cuboid;
    use super::*;

    #[test]
    fn an_edge_that_is_split_on_one_side_is_split_on_both() {
        let mut soup = cuboid([0.0; 3], [4.0, 1.0, 3.0]);
        let [a, b, c] = soup.triangles[0];
        let middle: [f64; 3] =
            std::array::from_fn(|k| (soup.vertices[a as usize][k] + soup.vertices[b as usize][k]) / 2.0);
        let m = soup.vertex(middle).unwrap();
        soup.triangles[0] = [a, m, c];
        soup.triangle([m, b, c]);
        assert!(!soup.is_closed());
        let mended = stitched(&soup);
        assert!(mended.is_closed() && (mended.volume() - 12.0).abs() < 1e-9);
    }

    #[test]
    fn a_box_grows_on_all_sides() {
        let soup = enlarged(&cuboid([0.0; 3], [1.0; 3]), 0.01);
        assert!((soup.volume() - 1.02f64.powi(3)).abs() < 1e-9, "{}", soup.volume());
    }
}
