//! Solids in voxels, and the accuracy of voxels.

use asbuilt_core::geometry::Solid;
use asbuilt_core::voxel::{Grid, Mask, Rule, VoxelAccuracy};

use super::grid::tile_arg;
use super::occupancy::occupancy_ret;
use crate::pg::{Account, Backend, Field, SqlValue, sql_functions};

sql_functions! {
    on Account::Grid;

    /// ab_voxelize(solid, voxel, rule, tile)
    fn ab_voxelize(args) {
        if (0..3).any(|i| args.is_null(i)) {
            return Ok(SqlValue::Null);
        }
        let grid = Grid::new(args.f64(1), tile_arg(args, 3), 0.0, 0.0)?;
        let rule = Rule::parse(&args.text(2))?;
        let solid = Solid::from_stored(args.bytes(0), &Backend)?;
        let mask = Mask::of(&solid, &grid, rule, &Backend)?;
        occupancy_ret(&mask.into_model(grid, &Backend)?)
    }

    fn ab_voxel_accuracy(args) {
        let a = VoxelAccuracy::of(args.f64(0))?;
        let levels = [a.absolute, a.relative, a.relative_linear].map(|l| Field::or_null(l, Field::Loa));
        Ok(SqlValue::Row([Field::F64(a.max_error)].into_iter().chain(levels).collect()))
    }
}
