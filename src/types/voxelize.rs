//! Solids in voxels, and the accuracy of voxels.

use asbuilt_core::geometry::Aabb;
use asbuilt_core::voxel::{FillRule, Grid, VoxelAccuracy, VoxelSet};

use super::occupancy::occupancy_ret;
use super::solid::SolidArg;
use crate::pg::{Account, Backend, RowField, SqlValue, sql_functions};

sql_functions! {
    on Account::Grid;

    fn ab_voxelize(solid: SolidArg, voxel: f64, rule: String, tile: Option<Aabb>) {
        let grid = Grid::new(voxel, tile.unwrap_or(Grid::EVERYWHERE), 0.0, 0.0)?;
        let rule = FillRule::parse(&rule)?;
        let mask = VoxelSet::of(&solid.read()?, &grid, rule, &Backend)?;
        occupancy_ret(&mask.into_model(grid, &Backend)?)
    }

    fn ab_voxel_accuracy(voxel: f64) {
        let a = VoxelAccuracy::of(voxel)?;
        let levels = [a.absolute, a.relative, a.relative_linear].map(|l| RowField::or_null(l, RowField::Loa));
        Ok(SqlValue::Row([RowField::F64(a.max_error)].into_iter().chain(levels).collect()))
    }
}
