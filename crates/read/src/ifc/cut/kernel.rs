//! Openings cut by an independent kernel, `boolmesh`, after Manifold's method.

use std::panic::{AssertUnwindSafe, catch_unwind};

use boolmesh::prelude::{Manifold, OpType, compute_boolean};

use super::clean::{enlarged, stitched};
use crate::ifc::soup::Soup;

/// How far openings are enlarged, metres: less than the accuracy of any wall, more than the library's rounding.
pub const OUTWARDS_M: [f64; 2] = [5e-5, 2e-4];

/// What is left of the host, with the openings that were cut, one attempt for each amount by which openings are
/// enlarged. Within an attempt every opening is enlarged by a slightly different amount, so that no faces share a plane
/// and no skins are left.
pub fn all_ways<'a>(host: &Soup, tools: &[Soup], by: &'a [f64]) -> impl Iterator<Item = (Soup, Vec<Soup>)> + use<'a> {
    let host = stitched(host);
    // One without thickness cuts nothing; enlarged it would be a slit.
    let tools: Vec<Soup> = tools.iter().filter(|tool| !is_flat(tool)).map(stitched).collect();
    by.iter().filter_map(move |by| {
        let larger = |(k, tool): (usize, &Soup)| enlarged(tool, by * (1.0 + 0.07 * (k % 10) as f64));
        let larger: Vec<Soup> = tools.iter().enumerate().map(larger).collect();
        Some((subtract(&host, &larger)?, larger))
    })
}

fn is_flat(tool: &Soup) -> bool {
    let area: f64 = (0..tool.triangles.len()).map(|t| tool.normal(t)).map(|n| n.norm() / 2.0).sum();
    tool.volume().abs() < 1e-4 * area
}

/// What is left of the host; `None` where the kernel fails.
fn subtract(host: &Soup, tools: &[Soup]) -> Option<Soup> {
    let zero = *host.vertices.first()?;
    let work = || {
        let mut left = manifold(host, zero)?;
        for tool in tools {
            left = compute_boolean(&left, &manifold(tool, zero)?, OpType::Subtract).ok()?;
        }
        Some(left)
    };
    let left = catch_unwind(AssertUnwindSafe(work)).ok()??;
    let mut soup = Soup::default();
    let ids: Vec<Option<u32>> =
        left.ps.iter().map(|p| soup.vertex([p.x + zero[0], p.y + zero[1], p.z + zero[2]])).collect();
    for face in left.hs.chunks_exact(3) {
        let id = |i: usize| ids.get(face[i].tail).copied().flatten();
        soup.triangle([id(0)?, id(1)?, id(2)?]);
    }
    Some(soup)
}

fn manifold(mesh: &Soup, zero: [f64; 3]) -> Option<Manifold> {
    let is_inside_out = mesh.volume() < 0.0;
    let positions: Vec<f64> = mesh.vertices.iter().flat_map(|v| [0, 1, 2].map(|k| v[k] - zero[k])).collect();
    let corner = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| i as usize);
        if is_inside_out { [a, c, b] } else { [a, b, c] }
    };
    let indices: Vec<usize> = mesh.triangles.iter().flat_map(corner).collect();
    Manifold::new(&positions, &indices).ok()
}

#[cfg(test)]
mod tests {
    use super::super::line::tests::cuboid;
    use super::*;

    #[test]
    fn a_hole() {
        let left = subtract(&cuboid([0.0; 3], [4.0, 1.0, 3.0]), &[cuboid([1.0, -1.0, 1.0], [2.0, 2.0, 2.0])]).unwrap();
        assert!((left.volume() - 11.0).abs() < 1e-6);
    }
}
