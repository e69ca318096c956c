//! The voxels whose centres lie inside a closed mesh: layer by layer of columns along x.

use super::columns::{ColumnCrossing, LocalSolid};
use super::voxel_set::VoxelSet;
use crate::error::{Error, Result};
use crate::voxel::lattice::{EDGE, VoxelBox};
use crate::{Interrupt, poll_now_and_then};

/// Attempts at a column that hits a seam of the mesh, each a little aside.
const ATTEMPTS: u32 = 8;

/// Sets the voxels of a box whose centres lie inside, eight layers at a time.
pub fn fill(set: &mut VoxelSet, local: &LocalSolid, span: &VoxelBox, interrupt: Interrupt) -> Result<()> {
    let [_, _, [first, end]] = span.0;
    let mut z = first;
    while z < end {
        let above = (z.div_euclid(EDGE) + 1) * EDGE;
        let layers = [z, above.min(end)];
        let crossings = local.crossings(layers, span.0[1], 0.0, interrupt)?;
        for (round, column) in crossings.chunk_by(|a, b| a.column == b.column).enumerate() {
            poll_now_and_then(round, interrupt)?;
            match runs(column) {
                Some(runs) => fill_runs(set, &runs, column[0].column, local, span, interrupt)?,
                None => fill_seam(set, column[0].column, local, span, interrupt)?,
            }
        }
        z = above;
    }
    Ok(())
}

/// A column whose crossings do not add up: it passes through a seam of the mesh. A little aside it does not.
fn fill_seam(
    set: &mut VoxelSet,
    column: [i64; 2],
    local: &LocalSolid,
    span: &VoxelBox,
    interrupt: Interrupt,
) -> Result<()> {
    for attempt in 1..=ATTEMPTS {
        let aside = 1e-7 * f64::from(attempt * attempt);
        let [z, y] = column;
        let crossings = local.crossings([z, z + 1], [y, y + 1], aside, interrupt)?;
        if let Some(runs) = runs(&crossings) {
            return fill_runs(set, &runs, column, local, span, interrupt);
        }
    }
    let reason = "its mesh has a gap that a column of voxels passes through; the rule 'surface' needs no inside".into();
    Err(Error::Degenerate { what: "the inside of the solid", reason })
}

/// Sets the voxels of a column whose centres lie between two crossings, in voxels from `low`.
fn fill_runs(
    set: &mut VoxelSet,
    runs: &[[f64; 2]],
    [z, y]: [i64; 2],
    local: &LocalSolid,
    span: &VoxelBox,
    interrupt: Interrupt,
) -> Result<()> {
    for [from, to] in runs {
        let number = |x: f64| (x - 0.5).ceil().clamp(-1e10, 1e10) as i64 + local.low[0];
        let (first, end) = (number(*from).max(span.0[0][0]), number(*to).min(span.0[0][1]));
        set.insert_run([first, end], [y, z], interrupt)?;
    }
    Ok(())
}

/// The parts of a column inside the mesh, by winding number; `None` where the crossings do not add up to 0.
fn runs(crossings: &[ColumnCrossing]) -> Option<Vec<[f64; 2]>> {
    let (mut winding, mut from, mut out) = (0, 0.0, Vec::new());
    for c in crossings {
        let before = winding;
        winding += c.winding;
        match (before, winding) {
            (0, _) => from = c.x,
            (_, 0) => out.push([from, c.x]),
            _ => {}
        }
    }
    (winding == 0).then_some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn crossings(of: &[(f64, i32)]) -> Vec<ColumnCrossing> {
        of.iter().map(|&(x, winding)| ColumnCrossing { column: [0, 0], x, winding }).collect()
    }

    #[test]
    fn parts_inside_are_where_the_winding_number_is_not_0() {
        assert_eq!(runs(&crossings(&[(1.0, 1), (2.0, -1), (3.0, 1), (4.0, -1)])), Some(vec![[1.0, 2.0], [3.0, 4.0]]));
        // Two closed parts that overlap are one.
        assert_eq!(runs(&crossings(&[(1.0, 1), (2.0, 1), (3.0, -1), (4.0, -1)])), Some(vec![[1.0, 4.0]]));
        // Turned inside out.
        assert_eq!(runs(&crossings(&[(1.0, -1), (2.0, 1)])), Some(vec![[1.0, 2.0]]));
        assert_eq!(runs(&crossings(&[(1.0, 1)])), None);
    }
}
