//! Where columns of voxels pass through a mesh.

use std::cmp::Ordering;

use crate::error::Result;
use crate::geometry::{Solid, Vec3};
use crate::num::sort::sort;
use crate::voxel::lattice::Grid;
use crate::{Grow, Interrupt, poll, poll_now_and_then};

/// Where a column along x passes through the mesh.
#[derive(Debug, Clone, Copy)]
pub struct ColumnCrossing {
    /// Numbers of its voxels along z and y.
    pub column: [i64; 2],
    /// Where, in voxels from the solid's [`LocalSolid::low`].
    pub x: f64,
    /// +1 into the solid, -1 out of it.
    pub winding: i32,
}

impl ColumnCrossing {
    fn place(&self) -> ([i64; 2], f64, i32) {
        (self.column, self.x, self.winding)
    }
}

impl PartialEq for ColumnCrossing {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for ColumnCrossing {}

impl PartialOrd for ColumnCrossing {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for ColumnCrossing {
    /// By column, then along it.
    fn cmp(&self, other: &Self) -> Ordering {
        let ((a, x, v), (b, y, w)) = (self.place(), other.place());
        a.cmp(&b).then(x.total_cmp(&y)).then(v.cmp(&w))
    }
}

/// The columns along x of one layer.
struct LayerColumns {
    layer: i64,
    /// Its height, in voxels from `low`.
    z: f64,
    /// Numbers of the first, and of the one behind the last.
    y: [i64; 2],
    /// How far off their centres, in voxels.
    aside: f64,
}

/// A solid in voxels, counted from one of its own.
pub struct LocalSolid<'a> {
    solid: &'a Solid,
    vertices: Vec<Vec3>,
    /// The voxel from which it is counted, near its lower corner.
    pub low: [i64; 3],
}

impl<'a> LocalSolid<'a> {
    /// Of a solid whose lower corner lies in the voxel `low`.
    pub fn new(solid: &'a Solid, grid: &Grid, low: [i64; 3]) -> Self {
        let at = |v: &Vec3| Vec3::from_fn(|i, _| v[i] / grid.voxel - low[i] as f64);
        Self { solid, vertices: solid.vertices().iter().map(at).collect(), low }
    }

    /// The corners of a triangle. In voxels, from the local origin.
    pub fn corners(&self, t: usize) -> [Vec3; 3] {
        self.solid.triangles()[t].map(|i| self.vertices[i as usize])
    }

    /// The crossings of columns `y` in layers `z`, sorted by column and then along it. Edges are half-open and each is
    /// evaluated alike for both its triangles, so that a closed mesh is crossed an even number of times; `aside` moves
    /// the columns off their centres. In voxels, from the local origin.
    pub fn crossings(&self, z: [i64; 2], y: [i64; 2], aside: f64, interrupt: Interrupt) -> Result<Vec<ColumnCrossing>> {
        let mut out = Vec::new();
        for t in 0..self.solid.triangles().len() {
            poll_now_and_then(t, interrupt)?;
            let corners = self.corners(t);
            let [low, high] = extent(&corners, 2);
            let first = ((low - 1.0).floor().clamp(-1e10, 1e10) as i64 + self.low[2]).max(z[0]);
            let last = ((high + 1.0).ceil().clamp(-1e10, 1e10) as i64 + self.low[2]).min(z[1] - 1);
            for layer in first..=last {
                let at_z = (layer - self.low[2]) as f64 + 0.5 + 0.618 * aside;
                poll(interrupt)?;
                self.cross_layer(&corners, &LayerColumns { layer, z: at_z, y, aside }, &mut out, interrupt)?;
            }
        }
        sort(&mut out, interrupt)?;
        Ok(out)
    }

    /// The columns of one layer that a triangle crosses.
    fn cross_layer(
        &self,
        c: &[Vec3; 3],
        columns: &LayerColumns,
        out: &mut Vec<ColumnCrossing>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let &LayerColumns { layer, z, y, aside } = columns;
        let mut ends: [Option<(f64, i32)>; 3] = [None; 3];
        for (i, end) in ends.iter_mut().enumerate() {
            let (p, q) = (&c[i], &c[(i + 1) % 3]);
            if (p[2] <= z) != (q[2] <= z) {
                // From its lower end, whichever triangle asks.
                let (a, b) = if p[2] < q[2] { (p, q) } else { (q, p) };
                *end = Some((a[1] + (z - a[2]) / (b[2] - a[2]) * (b[1] - a[1]), if p[2] < q[2] { 1 } else { -1 }));
            }
        }
        let mut ends = ends.into_iter().flatten();
        let (Some(a), Some(b)) = (ends.next(), ends.next()) else { return Ok(()) };
        let ((left, winding), (right, _)) = if a.0 <= b.0 { (a, b) } else { (b, a) };
        let number = |at: f64| (at - 0.5 - aside).ceil().clamp(-1e10, 1e10) as i64 + self.low[1];
        let normal = (c[1] - c[0]).cross(&(c[2] - c[0]));
        let [x_low, x_high] = extent(c, 0);
        for row in number(left).max(y[0])..number(right).min(y[1]) {
            let at_y = (row - self.low[1]) as f64 + 0.5 + aside;
            let x = c[0][0] - (normal[1] * (at_y - c[0][1]) + normal[2] * (z - c[0][2])) / normal[0];
            let x = if x.is_finite() { x.clamp(x_low, x_high) } else { x_low };
            out.grow(1, interrupt)?;
            out.push(ColumnCrossing { column: [layer, row], x, winding });
        }
        Ok(())
    }
}

fn extent(corners: &[Vec3; 3], axis: usize) -> [f64; 2] {
    corners.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], c| [a.min(c[axis]), b.max(c[axis])])
}
