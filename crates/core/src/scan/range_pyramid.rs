//! How far the beams of an image got, at the most, within a rectangle: a pyramid of maxima (Greene, Kass & Miller 1993,
//! "Hierarchical Z-buffer visibility").

use std::ops::Range;

use super::angular_grid::AngularGrid;

/// Cells of a rectangle that are looked at in each direction, at the most one more.
const CELLS_ACROSS: usize = 4;

/// Farthest ranges of the cells of a grid, of 2 × 2 of them, of 4 × 4 and so on.
#[derive(Debug)]
pub struct RangePyramid {
    levels: Vec<Level>,
}

#[derive(Debug)]
struct Level {
    columns: usize,
    /// Metres; −∞ in a cell without beams.
    farthest: Vec<f64>,
}

impl RangePyramid {
    /// Of ranges (metres) that lie in the order of the grid's slots.
    pub fn of(grid: &AngularGrid, ranges: &[f64]) -> Self {
        let [columns, _] = grid.size();
        let farthest = |slots: Range<usize>| ranges[slots].iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mut levels = vec![Level { columns, farthest: grid.cells().map(farthest).collect() }];
        while let Some(coarser) = levels.last().and_then(Level::halved) {
            levels.push(coarser);
        }
        Self { levels }
    }

    /// At least the farthest range of the beams in these columns and rows of the grid, metres; −∞ without beams.
    pub fn farthest(&self, [columns, rows]: [Range<usize>; 2]) -> f64 {
        if columns.is_empty() || rows.is_empty() {
            return f64::NEG_INFINITY;
        }
        let across = columns.len().max(rows.len()).div_ceil(CELLS_ACROSS);
        let number = (across.next_power_of_two().trailing_zeros() as usize).min(self.levels.len() - 1);
        let level = &self.levels[number];
        let at = |cells: &Range<usize>| cells.start >> number..((cells.end - 1) >> number) + 1;
        let row = |r: usize| &level.farthest[r * level.columns..][at(&columns)];
        at(&rows).flat_map(row).copied().fold(f64::NEG_INFINITY, f64::max)
    }
}

impl Level {
    /// The maxima of 2 × 2 cells each; `None` of a single cell.
    fn halved(&self) -> Option<Self> {
        let (columns, rows) = (self.columns, self.farthest.len() / self.columns.max(1));
        let half = columns.div_ceil(2);
        let mut farthest = vec![f64::NEG_INFINITY; half * rows.div_ceil(2)];
        for (i, range) in self.farthest.iter().enumerate() {
            let cell = &mut farthest[(i / columns / 2) * half + i % columns / 2];
            *cell = cell.max(*range);
        }
        (self.farthest.len() > 1).then_some(Self { columns: half, farthest })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Never less than the farthest beam in the rectangle, never more than the farthest of all.
        #[test]
        fn bounds_what_a_full_search_finds(
            beams in prop::collection::vec((-1.0..1.0f64, -0.6..0.6f64, 0.5..9.0f64), 1..400),
            from in (-1.2..1.2f64, -1.2..1.2f64), size in (0.0..1.0f64, 0.0..1.0f64), step in 0.004..0.1f64)
        {
            let places: Vec<[f64; 2]> = beams.iter().map(|b| [b.0, b.1]).collect();
            let (grid, slots) = AngularGrid::sort(&places, step);
            let mut ranges = vec![0.0; beams.len()];
            slots.iter().zip(&beams).for_each(|(slot, beam)| ranges[*slot as usize] = beam.2);
            let (min, max) = ([from.0, from.1], [from.0 + size.0, from.1 + size.1]);
            let within = |p: &[f64; 2]| (0..2).all(|k| (min[k]..=max[k]).contains(&p[k]));
            let farthest = |keep: &dyn Fn(&[f64; 2]) -> bool| {
                beams.iter().zip(&places).filter(|(_, p)| keep(p)).map(|(b, _)| b.2).fold(f64::NEG_INFINITY, f64::max)
            };
            let bound = RangePyramid::of(&grid, &ranges).farthest(grid.cells_in(min, max));
            prop_assert!(bound >= farthest(&within) && bound <= farthest(&|_| true));
        }
    }
}
