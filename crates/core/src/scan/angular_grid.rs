//! Directions sorted into the cells of a grid in the image plane.

use std::ops::Range;

/// Most cells per side; a patch of 4096 beams needs far fewer.
const MAX_CELLS: f64 = 256.0;

/// A grid over image coordinates; the contents of one cell, and of neighbouring cells of a row, are adjacent.
#[derive(Debug)]
pub struct AngularGrid {
    low: [f64; 2],
    cell: f64,
    columns: usize,
    rows: usize,
    /// First slot of each cell, row by row, and the end.
    starts: Vec<u32>,
}

impl AngularGrid {
    /// Sorts image coordinates into cells two `step`s wide. Also returns the slot of each.
    /// Places in the image plane at unit distance, the step in radians.
    pub fn sort(places: &[[f64; 2]], step: f64) -> (Self, Vec<u32>) {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for uv in places {
            for k in 0..2 {
                low[k] = low[k].min(uv[k]);
                high[k] = high[k].max(uv[k]);
            }
        }
        if places.is_empty() {
            (low, high) = ([0.0; 2], [0.0; 2]);
        }
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        let cell = (2.0 * step).max(extent / MAX_CELLS).max(1e-9);
        let count = |k: usize| ((high[k] - low[k]) / cell) as usize + 1;
        let mut grid = Self { low, cell, columns: count(0), rows: count(1), starts: Vec::new() };
        let cell_of: Vec<usize> = places.iter().map(|uv| grid.cell_of(uv)).collect();
        let mut starts = vec![0u32; grid.rows * grid.columns + 1];
        cell_of.iter().for_each(|&c| starts[c + 1] += 1);
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let slots = cell_of
            .iter()
            .map(|&c| {
                next[c] += 1;
                next[c] - 1
            })
            .collect();
        grid.starts = starts;
        (grid, slots)
    }

    fn cell_of(&self, uv: &[f64; 2]) -> usize {
        let [c, r] = [0, 1].map(|k| ((uv[k] - self.low[k]) / self.cell) as usize);
        r.min(self.rows - 1) * self.columns + c.min(self.columns - 1)
    }

    /// Slot ranges, one per row of cells, that hold everything within the image rectangle (and some around it).
    /// Tangents of angles from the cone's axis: unit distance in front of the scanner.
    pub fn slots_in(&self, min: [f64; 2], max: [f64; 2]) -> impl Iterator<Item = Range<usize>> + '_ {
        let [columns, rows] = self.cells_in(min, max);
        let rows = if columns.is_empty() { 0..0 } else { rows };
        rows.map(move |r| {
            let row = r * self.columns;
            self.starts[row + columns.start] as usize..self.starts[row + columns.end] as usize
        })
    }

    /// Columns and rows of the cells that hold everything within the rectangle of the image plane at unit distance.
    pub fn cells_in(&self, min: [f64; 2], max: [f64; 2]) -> [Range<usize>; 2] {
        let along = |k: usize, count: usize| {
            let cell = |x: f64| ((x - self.low[k]) / self.cell).clamp(0.0, count as f64) as usize;
            let end = if max[k] < self.low[k] { 0 } else { (cell(max[k]) + 1).min(count) };
            let first = cell(min[k]);
            first..end.max(first)
        };
        [along(0, self.columns), along(1, self.rows)]
    }

    /// The rectangle that holds all, in the image plane at unit distance.
    pub fn extent(&self) -> ([f64; 2], [f64; 2]) {
        let [columns, rows] = self.size().map(|count| count as f64 * self.cell);
        (self.low, [self.low[0] + columns, self.low[1] + rows])
    }

    /// Number of columns and rows.
    pub fn size(&self) -> [usize; 2] {
        [self.columns, self.rows]
    }

    /// The slots of each cell, row by row.
    pub fn cells(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        self.starts.windows(2).map(|ends| ends[0] as usize..ends[1] as usize)
    }
}
