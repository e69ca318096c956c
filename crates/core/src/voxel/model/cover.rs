//! The voxels that a solid fills: those inside, those of its surface, or both.

use super::columns::LocalSolid;
use super::fill_rule::FillRule;
use super::inside::fill;
use super::surface::for_each_on_surface;
use super::voxel_set::VoxelSet;
use crate::error::{Error, Result};
use crate::geometry::{Closedness, Solid};
use crate::voxel::lattice::{Grid, VoxelBox};
use crate::{Interrupt, poll};

impl VoxelSet {
    /// The voxels of a grid's tile that a solid fills.
    pub fn of(solid: &Solid, grid: &Grid, rule: FillRule, interrupt: Interrupt) -> Result<Self> {
        if rule != FillRule::Surface && solid.closedness() == Closedness::Open {
            return Err(Error::OpenSurface);
        }
        let mut out = Self::default();
        let bounds = solid.bounds();
        let (low, high) = (grid.index(&bounds.min.into())?, grid.index(&bounds.max.into())?);
        let span = grid.span().common(&VoxelBox::between(low, high));
        if span.is_empty() {
            return Ok(out);
        }
        let local = LocalSolid::new(solid, grid, low);
        if rule != FillRule::Surface {
            fill(&mut out, &local, &span, interrupt)?;
        }
        if rule != FillRule::Centre {
            for t in 0..solid.triangles().len() {
                poll(interrupt)?;
                for_each_on_surface(&local.corners(t), &span.counted_from(low), interrupt, |v| {
                    out.insert([0, 1, 2].map(|i| v[i] + low[i]), interrupt)
                })?;
            }
        }
        Ok(out)
    }
}
