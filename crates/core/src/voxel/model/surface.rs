//! The voxels that a triangle passes through.

use crate::error::Result;
use crate::geometry::Vec3;
use crate::voxel::lattice::VoxelBox;
use crate::{Interrupt, poll_now_and_then};

/// Calls `visit` for every voxel of `span` that the triangle (in voxels) passes through. A voxel owns its lower faces,
/// as points do, so that a wall on a lattice plane lies in one layer of voxels.
///
/// Column by column along the axis that the triangle faces most, and there by the separating axes of triangle and box
/// (Akenine-Möller 2001).
pub fn for_each_on_surface(
    corners: &[Vec3; 3],
    span: &VoxelBox,
    interrupt: Interrupt,
    mut visit: impl FnMut([i64; 3]) -> Result<()>,
) -> Result<()> {
    let edges = [corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]];
    let normal = edges[0].cross(&edges[1]);
    let axis = normal.iamax();
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    let low = corners[0].inf(&corners[1]).inf(&corners[2]);
    let high = corners[0].sup(&corners[1]).sup(&corners[2]);
    let range = |k: usize| [number(low[k]).max(span.0[k][0]), number(high[k]).min(span.0[k][1] - 1)];
    let (along, across) = (range(axis), [range(u), range(v)]);
    let plane = normal.dot(&corners[0]);
    let slack = 0.5 * (normal[u].abs() + normal[v].abs()) / normal[axis].abs() + 1e-6;
    let mut round = 0;
    for i in across[0][0]..=across[0][1] {
        for j in across[1][0]..=across[1][1] {
            round += 1;
            poll_now_and_then(round, interrupt)?;
            let height = (plane - normal[u] * (i as f64 + 0.5) - normal[v] * (j as f64 + 0.5)) / normal[axis];
            // A triangle without area has no plane.
            let reach = match normal[axis] == 0.0 {
                true => along,
                false => [number(height - slack).max(along[0]), number(height + slack).min(along[1])],
            };
            for k in reach[0]..=reach[1] {
                let mut voxel = [0; 3];
                (voxel[axis], voxel[u], voxel[v]) = (k, i, j);
                if passes(corners, &edges, &normal, voxel) {
                    visit(voxel)?;
                }
            }
        }
    }
    Ok(())
}

/// Number of the voxel that holds a coordinate.
fn number(c: f64) -> i64 {
    c.floor().clamp(-2e9, 2e9) as i64
}

/// Whether a triangle meets a voxel: no axis separates them.
fn passes(corners: &[Vec3; 3], edges: &[Vec3; 3], normal: &Vec3, voxel: [i64; 3]) -> bool {
    let centre = Vec3::from(voxel.map(|i| i as f64 + 0.5));
    let c = corners.map(|p| p - centre);
    let extent = |axis: &Vec3| {
        c.iter().map(|p| axis.dot(p)).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], d| [a.min(d), b.max(d)])
    };
    let faces = (0..3).all(|k| {
        let [low, high] = extent(&Vec3::ith(k, 1.0));
        low < 0.5 && high >= -0.5
    });
    let apart = |axis: &Vec3| {
        let [low, high] = extent(axis);
        let reach = 0.5 * axis.abs().sum();
        low > reach || high < -reach
    };
    faces && !apart(normal) && edges.iter().all(|e| (0..3).all(|k| !apart(&e.cross(&Vec3::ith(k, 1.0)))))
}
