//! `ab_occupancy`: core's byte form, on disk and on the wire; in hexadecimal as text; and the functions on it.

use asbuilt_core::geometry::Aabb;
use asbuilt_core::voxel::{ChangeSettings, FillRule, Grid, Occupancy, TileHeader, VoxelSet, VoxelState};
use asbuilt_core::{Error, Result};

use super::box_bytes;
use super::grid::{GridArg, grid_ret};
use super::hex::{hex_in, hex_out};
use super::overlap::TileArg;
use super::rollup::rolled_up;
use super::solid::SolidArg;
use crate::pg::{Account, Backend, Message, RowField, SqlValue, TextArray, TextInput, Varlena, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_occupancy:1:";

fn read(bytes: &[u8]) -> Result<Occupancy> {
    Occupancy::from_bytes(bytes, &Backend)
}

/// An occupancy.
pub type OccupancyArg<'a> = Varlena<'a, Occupancy>;

impl OccupancyArg<'_> {
    /// The whole of it.
    pub fn read(&self) -> Result<Occupancy> {
        read(self.bytes())
    }

    /// Its header alone.
    fn header(&self) -> Result<TileHeader> {
        Occupancy::header(self.prefix(TileHeader::LEN))
    }
}

/// The stored form.
pub fn occupancy_ret(occupancy: &Occupancy) -> Result<SqlValue> {
    Ok(SqlValue::Bytes(occupancy.to_bytes(&Backend)?))
}

/// The voxels of a grid, and within `margin` metres around its tile, that a solid touches; for an open
/// solid those of its surface.
pub fn cover(solid: &SolidArg, grid: &Grid, margin: f64) -> Result<VoxelSet> {
    let tile = grid.tile.expanded(margin + grid.voxel);
    let grid = &Grid { tile, ..*grid };
    let solid = solid.read()?;
    let rule = if solid.volume().is_ok() { FillRule::Cover } else { FillRule::Surface };
    VoxelSet::of(&solid, grid, rule, &Backend)
}

/// Number of voxels of the tile; `None` for an unbounded tile.
fn voxels_of_tile(grid: &Grid) -> Option<u64> {
    let sides = grid.span().0.map(|[first, end]| (end - first) as u64);
    grid.is_bounded().then(|| sides.iter().try_fold(1u64, |n, &side| n.checked_mul(side))).flatten()
}

sql_functions! {
    on Account::Grid;

    fn ab_occupancy_in(text: TextInput) { occupancy_ret(&read(&hex_in(&text, "ab_occupancy", PREFIX)?)?) }

    fn ab_occupancy_out(occupancy: OccupancyArg) { hex_out(&occupancy, PREFIX) }

    fn ab_occupancy_recv(message: Message) { occupancy_ret(&read(message.rest())?) }

    fn ab_occupancy_send(occupancy: OccupancyArg) { Ok(occupancy.copied()) }

    fn ab_occupancy_empty(grid: GridArg, model: bool) {
        let grid = grid.read()?;
        occupancy_ret(&if model { Occupancy::of_model(grid) } else { Occupancy::new(grid) })
    }

    fn ab_occupancy_clip(occupancy: OccupancyArg, tile: Aabb) {
        occupancy_ret(&occupancy.read()?.clipped(&tile, &Backend)?)
    }

    fn ab_occupancy_grid(occupancy: OccupancyArg) { grid_ret(&occupancy.header()?.grid) }

    /// ab_box(occupancy), ab_box(change)
    fn ab_tile_box(tile: TileArg) {
        let bounds = TileHeader::read(tile.prefix(TileHeader::LEN))?.bounds();
        Ok(bounds.map_or(SqlValue::Null, |b| SqlValue::Fixed(box_bytes(&b))))
    }

    fn ab_occupancy_rollup(o1: Option<OccupancyArg>, o2: Option<OccupancyArg>) {
        rolled_up(o1, o2, |o1, o2| {
            let mut sum = o1.read()?;
            sum.merge(&o2.read()?, &Backend)?;
            occupancy_ret(&sum)
        })
    }

    fn ab_occupancy_state(occupancy: OccupancyArg, x: f64, y: f64, z: f64, threshold: i32) {
        let point = [x, y, z].into();
        let header = occupancy.header()?;
        let (voxel, threshold) = (header.grid.index(&point)?, ChangeSettings::threshold(threshold)?);
        Ok(SqlValue::text(occupancy.read()?.state(voxel, threshold).name()))
    }

    fn ab_occupancy_voxels(rows: Rows; occupancy: OccupancyArg, states: TextArray, threshold: i32) {
        let states = states.words("the states")?;
        let states: Vec<VoxelState> = states.iter().map(|w| VoxelState::parse(w)).collect::<Result<_>>()?;
        if states.contains(&VoxelState::Unknown) {
            return Err(Error::argument("a state", "occupied, ambiguous or empty: unknown space has no end", "unknown"));
        }
        let occupancy = occupancy.read()?;
        occupancy.for_each(ChangeSettings::threshold(threshold)?, &Backend, |voxel, state, hits| {
            if states.contains(&state) {
                let centre = occupancy.grid().centre(voxel);
                let place = [0, 1, 2].map(|i| RowField::F64(centre[i]));
                let [x, y, z] = place;
                rows.push(&[x, y, z, RowField::Text(state.name().into()), RowField::I32(hits.into())]);
            }
        })?;
        Ok(SqlValue::Null)
    }

    fn ab_occupancy_slice(occupancy: OccupancyArg, name: String, at: f64, threshold: i32) {
        let Some(axis) = ["x", "y", "z"].iter().position(|a| *a == name) else {
            return Err(Error::argument("the axis", "x, y or z", name));
        };
        let slice = occupancy.read()?.slice(axis, at, ChangeSettings::threshold(threshold)?, &Backend)?;
        Ok(SqlValue::I32Array(slice.states, vec![slice.rows as i32, slice.columns as i32]))
    }

    fn ab_occupancy_summary(occupancy: OccupancyArg, threshold: i32, solid: Option<SolidArg>) {
        let (occupancy, threshold) = (occupancy.read()?, ChangeSettings::threshold(threshold)?);
        let mask = solid.map(|s| cover(&s, occupancy.grid(), 0.0)).transpose()?;
        let tally = occupancy.tally(threshold, mask.as_ref(), &Backend)?;
        let known = tally.occupied + tally.ambiguous + tally.empty;
        let span = occupancy.grid().span();
        let all = mask.map_or_else(|| voxels_of_tile(occupancy.grid()), |m| Some(m.len_within(&span)));
        let rest = all.filter(|n| i64::try_from(*n).is_ok()).map(|n| n.saturating_sub(known));
        let of_model = occupancy.is_model();
        let empty = tally.empty + if of_model { rest.unwrap_or(0) } else { 0 };
        let unknown = if of_model { Some(0) } else { rest };
        let voxels = [Some(tally.occupied), Some(tally.ambiguous), Some(empty), unknown];
        let volume = occupancy.grid().voxel_volume();
        let counts = voxels.map(|n| RowField::or_null(n, |n| RowField::I64(n as i64)));
        let volumes = voxels.map(|n| RowField::or_null(n, |n| RowField::F64(n as f64 * volume)));
        Ok(SqlValue::Row(counts.into_iter().chain(volumes).collect()))
    }

    fn ab_occupancy_denoise(occupancy: OccupancyArg, neighbours: i32, threshold: i32) {
        let Some(count) = u32::try_from(neighbours).ok().filter(|n| *n <= 26) else {
            return Err(Error::argument("the number of neighbours", "from 0 to 26", neighbours));
        };
        let threshold = ChangeSettings::threshold(threshold)?;
        occupancy_ret(&occupancy.read()?.denoised(count, threshold, &Backend)?)
    }

    fn ab_occupancy_downsample(occupancy: OccupancyArg) { occupancy_ret(&occupancy.read()?.downsampled(&Backend)?) }
}
