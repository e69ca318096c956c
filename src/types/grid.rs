//! `ab_grid`: `name=value` words.

use asbuilt_core::error::Limited;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::num::words::Words;
use asbuilt_core::scan::NO_RETURN_REACH_M;
use asbuilt_core::voxel::Grid;
use asbuilt_core::{Budget, Error, Result};

use super::{box_bytes, box_from};
use crate::pg::{Args, Backend, Field, Rows, SqlValue, sql_functions};

/// Most tiles that `ab_tiles` returns.
const MAX_TILES: f64 = 1e7;

const WORDS: Words = Words { ty: "ab_grid", letter: b'G' };

/// The stored form. Zero has no sign: equal grids are equal bytes.
pub fn grid_ret(grid: &Grid) -> Result<SqlValue> {
    let tile = Aabb { min: grid.tile.min.map(|c| c + 0.0), max: grid.tile.max.map(|c| c + 0.0) };
    let (margin, no_return_range) = (grid.margin + 0.0, grid.no_return_range + 0.0);
    let text = Grid { tile, margin, no_return_range, ..*grid }.to_text();
    Ok(SqlValue::Bytes(WORDS.encode(&text)?))
}

/// The grid in argument `i`.
pub fn grid_arg(args: &Args, i: usize) -> Result<Grid> {
    WORDS.decode(args.bytes(i), Grid::from_text)
}

/// The box in argument `i`, or all space.
pub fn tile_arg(args: &Args, i: usize) -> Aabb {
    if args.is_null(i) { Grid::EVERYWHERE } else { box_from(&args.fixed(i)) }
}

/// Numbers of the tiles of `size` that meet a box along an axis: the first, and the one after the last.
fn numbers(area: &Aabb, axis: usize, size: f64) -> [f64; 2] {
    let first = (area.min[axis] / size).floor();
    [first, (area.max[axis] / size).ceil().max(first + 1.0)]
}

sql_functions! {
    fn ab_grid_in(args) { grid_ret(&Grid::from_text(&args.cstring(0))?) }

    fn ab_grid_out(args) { Ok(SqlValue::CString(grid_arg(args, 0)?.to_text())) }

    fn ab_grid_recv(args) { grid_ret(&WORDS.decode(args.message(0), Grid::from_text)?) }

    fn ab_grid_send(args) { Ok(args.copied(0)) }

    /// ab_grid(voxel, tile, margin, no_return_range, exact)
    fn ab_grid_make(args) {
        if [0, 2, 3, 4].iter().any(|&i| args.is_null(i)) {
            return Ok(SqlValue::Null);
        }
        let range = args.f64(3);
        let range = if range == f64::INFINITY { NO_RETURN_REACH_M } else { range };
        grid_ret(&Grid { exact: args.bool(4), ..Grid::new(args.f64(0), tile_arg(args, 1), args.f64(2), range)? })
    }

    /// ab_tiles(area, size)
    fn ab_tiles(args) {
        let mut rows = Rows::new(args)?;
        let (area, size) = (box_from(&args.fixed(0)), args.f64(1));
        if !(size > 0.0 && size.is_finite()) {
            return Err(Error::argument("the size of a tile", "more than 0 m, and finite", size));
        }
        let [x, y, z] = [0, 1, 2].map(|axis| numbers(&area, axis, size));
        let count = [x, y, z].map(|[first, end]| end - first).iter().product::<f64>();
        if count.is_nan() || count > MAX_TILES {
            let limit = format!("{MAX_TILES:e}");
            return Err(Error::Limit { what: Limited::Tiles, value: format!("{count:e}"), limit });
        }
        let along = |[first, end]: [f64; 2]| (0..(end - first) as i64).map(move |i| first + i as f64);
        for (i, j) in along(x).flat_map(|i| along(y).map(move |j| (i, j))) {
            Backend.poll()?;
            for k in along(z) {
                Backend.poll()?;
                let low = [i, j, k].map(|n| n * size);
                let high = [i, j, k].map(|n| (n + 1.0) * size);
                rows.push(&[Field::Fixed(box_bytes(&Aabb::new(low, high)?))]);
            }
        }
        Ok(SqlValue::Null)
    }
}
