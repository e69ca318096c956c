//! `ab_occupancy`: core's byte form, on disk and on the wire; in hexadecimal as text; and the functions on it.

use asbuilt_core::geometry::Solid;
use asbuilt_core::voxel::{Grid, Mask, Occupancy, Rule, Settings, State, TileHeader};
use asbuilt_core::{Error, Result};

use super::grid::{grid_arg, grid_ret};
use super::hex::{hex_in, hex_out};
use super::rollup::rolled_up;
use super::{box_bytes, box_from};
use crate::pg::{Account, Args, Backend, Field, Rows, SqlValue, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_occupancy:1:";

fn read(bytes: &[u8]) -> Result<Occupancy> {
    Occupancy::from_bytes(bytes, &Backend)
}

/// The occupancy in argument `i`.
pub fn occupancy_arg(args: &Args, i: usize) -> Result<Occupancy> {
    read(args.bytes(i))
}

/// The stored form.
pub fn occupancy_ret(occupancy: &Occupancy) -> Result<SqlValue> {
    Ok(SqlValue::Bytes(occupancy.to_bytes(&Backend)?))
}

/// The words of a `text[]`.
pub fn words(args: &Args, i: usize, what: &'static str) -> Result<Vec<String>> {
    let words = args.bytes_array(i, what)?;
    Ok(words.into_iter().map(|w| String::from_utf8_lossy(w).into_owned()).collect())
}

/// The voxels of a grid, and within `margin` metres around its tile, that the solid in argument `i` touches; for an
/// open solid those of its surface.
pub fn cover(args: &Args, i: usize, grid: &Grid, margin: f64) -> Result<Mask> {
    let tile = grid.tile.expanded(margin + grid.voxel);
    let grid = &Grid { tile, ..*grid };
    let solid = Solid::from_stored(args.bytes(i), &Backend)?;
    let rule = if solid.volume().is_ok() { Rule::Cover } else { Rule::Surface };
    Mask::of(&solid, grid, rule, &Backend)
}

/// Number of voxels of the tile; `None` for an unbounded tile.
fn voxels_of_tile(grid: &Grid) -> Option<u64> {
    let sides = grid.span().0.map(|[first, end]| (end - first) as u64);
    grid.is_bounded().then(|| sides.iter().try_fold(1u64, |n, &side| n.checked_mul(side))).flatten()
}

sql_functions! {
    on Account::Grid;

    fn ab_occupancy_in(args) { occupancy_ret(&read(&hex_in(args, "ab_occupancy", PREFIX)?)?) }

    fn ab_occupancy_out(args) { hex_out(args, PREFIX) }

    fn ab_occupancy_recv(args) { occupancy_ret(&read(args.message(0))?) }

    fn ab_occupancy_send(args) { Ok(args.copied(0)) }

    /// ab_occupancy(grid, model)
    fn ab_occupancy_empty(args) {
        let grid = grid_arg(args, 0)?;
        occupancy_ret(&if args.bool(1) { Occupancy::of_model(grid) } else { Occupancy::new(grid) })
    }

    fn ab_occupancy_clip(args) {
        occupancy_ret(&occupancy_arg(args, 0)?.clipped(&box_from(&args.fixed(1)), &Backend)?)
    }

    fn ab_occupancy_grid(args) { grid_ret(&Occupancy::header(args.prefix(0, TileHeader::LEN))?.grid) }

    /// ab_box(occupancy), ab_box(change)
    fn ab_tile_box(args) {
        let bounds = TileHeader::read(args.prefix(0, TileHeader::LEN))?.bounds();
        Ok(bounds.map_or(SqlValue::Null, |b| SqlValue::Fixed(box_bytes(&b))))
    }

    /// ab_rollup(occupancy, occupancy)
    fn ab_occupancy_rollup(args) {
        rolled_up(args, || {
            let mut sum = occupancy_arg(args, 0)?;
            sum.merge(&occupancy_arg(args, 1)?, &Backend)?;
            occupancy_ret(&sum)
        })
    }

    /// ab_state(occupancy, x, y, z, threshold)
    fn ab_occupancy_state(args) {
        let point = [1, 2, 3].map(|i| args.f64(i)).into();
        let header = Occupancy::header(args.prefix(0, TileHeader::LEN))?;
        let (voxel, threshold) = (header.grid.index(&point)?, Settings::threshold(args.i32(4))?);
        Ok(SqlValue::text(occupancy_arg(args, 0)?.state(voxel, threshold).name()))
    }

    /// ab_voxels(occupancy, states, threshold)
    fn ab_occupancy_voxels(args) {
        let mut rows = Rows::new(args)?;
        let states: Vec<State> = words(args, 1, "the states")?.iter().map(|w| State::parse(w)).collect::<Result<_>>()?;
        if states.contains(&State::Unknown) {
            return Err(Error::argument("a state", "occupied, ambiguous or empty: unknown space has no end", "unknown"));
        }
        let occupancy = occupancy_arg(args, 0)?;
        occupancy.for_each(Settings::threshold(args.i32(2))?, &Backend, |voxel, state, hits| {
            if states.contains(&state) {
                let centre = occupancy.grid().centre(voxel);
                let place = [0, 1, 2].map(|i| Field::F64(centre[i]));
                let [x, y, z] = place;
                rows.push(&[x, y, z, Field::Text(state.name().into()), Field::I32(hits.into())]);
            }
        })?;
        Ok(SqlValue::Null)
    }

    /// ab_slice(occupancy, axis, at, threshold)
    fn ab_occupancy_slice(args) {
        let name = args.text(1);
        let Some(axis) = ["x", "y", "z"].iter().position(|a| *a == name) else {
            return Err(Error::argument("the axis", "x, y or z", name));
        };
        let slice = occupancy_arg(args, 0)?.slice(axis, args.f64(2), Settings::threshold(args.i32(3))?, &Backend)?;
        Ok(SqlValue::I32Array(slice.states, vec![slice.rows as i32, slice.columns as i32]))
    }

    /// ab_summary(occupancy, threshold, solid)
    fn ab_occupancy_summary(args) {
        if args.is_null(0) || args.is_null(1) {
            return Ok(SqlValue::Null);
        }
        let (occupancy, threshold) = (occupancy_arg(args, 0)?, Settings::threshold(args.i32(1))?);
        let mask = if args.is_null(2) { None } else { Some(cover(args, 2, occupancy.grid(), 0.0)?) };
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
        let counts = voxels.map(|n| Field::or_null(n, |n| Field::I64(n as i64)));
        let volumes = voxels.map(|n| Field::or_null(n, |n| Field::F64(n as f64 * volume)));
        Ok(SqlValue::Row(counts.into_iter().chain(volumes).collect()))
    }

    /// ab_denoise(occupancy, neighbours, threshold)
    fn ab_occupancy_denoise(args) {
        let Some(neighbours) = u32::try_from(args.i32(1)).ok().filter(|n| *n <= 26) else {
            return Err(Error::argument("the number of neighbours", "from 0 to 26", args.i32(1)));
        };
        let threshold = Settings::threshold(args.i32(2))?;
        occupancy_ret(&occupancy_arg(args, 0)?.denoised(neighbours, threshold, &Backend)?)
    }

    fn ab_occupancy_downsample(args) { occupancy_ret(&occupancy_arg(args, 0)?.downsampled(&Backend)?) }
}
