//! `ab_grid`: `name=value` words.

use asbuilt_core::error::Limited;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::num::words::Words;
use asbuilt_core::scan::NO_RETURN_REACH_M;
use asbuilt_core::voxel::Grid;
use asbuilt_core::{Budget, Error, Result};

use super::box_bytes;
use crate::pg::{Backend, Message, RowField, SqlValue, TextInput, Varlena, sql_functions};

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

/// A grid.
pub type GridArg<'a> = Varlena<'a, Grid>;

impl GridArg<'_> {
    /// The grid.
    pub fn read(&self) -> Result<Grid> {
        WORDS.decode(self.bytes(), Grid::from_text)
    }
}

/// Numbers of the tiles of `size` that meet a box along an axis: the first, and the one after the last.
fn numbers(area: &Aabb, axis: usize, size: f64) -> [f64; 2] {
    let first = (area.min[axis] / size).floor();
    [first, (area.max[axis] / size).ceil().max(first + 1.0)]
}

sql_functions! {
    fn ab_grid_in(text: TextInput) { grid_ret(&Grid::from_text(&text.text())?) }

    fn ab_grid_out(grid: GridArg) { Ok(SqlValue::CString(grid.read()?.to_text())) }

    fn ab_grid_recv(message: Message) { grid_ret(&WORDS.decode(message.rest(), Grid::from_text)?) }

    fn ab_grid_send(grid: GridArg) { Ok(grid.copied()) }

    fn ab_grid_make(voxel: f64, tile: Option<Aabb>, margin: f64, range: f64, exact: bool) {
        let range = if range == f64::INFINITY { NO_RETURN_REACH_M } else { range };
        grid_ret(&Grid { exact, ..Grid::new(voxel, tile.unwrap_or(Grid::EVERYWHERE), margin, range)? })
    }

    fn ab_tiles(rows: Rows; area: Aabb, size: f64) {
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
                rows.push(&[RowField::Fixed(box_bytes(&Aabb::new(low, high)?))]);
            }
        }
        Ok(SqlValue::Null)
    }
}
