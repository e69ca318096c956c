//! Directions sorted into the cells of a grid in the image plane.

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
    pub fn slots_in(&self, min: [f64; 2], max: [f64; 2]) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        let index = |k: usize, x: f64, n: usize| ((x - self.low[k]) / self.cell).floor().clamp(-1.0, n as f64) as isize;
        let c0 = index(0, min[0], self.columns).max(0);
        let c1 = index(0, max[0], self.columns).min(self.columns as isize - 1);
        let r0 = index(1, min[1], self.rows).max(0);
        let r1 = index(1, max[1], self.rows).min(self.rows as isize - 1);
        let rows = if c0 <= c1 && r0 <= r1 { r0..r1 + 1 } else { 0..0 };
        rows.map(move |r| {
            let row = r as usize * self.columns;
            self.starts[row + c0 as usize] as usize..self.starts[row + c1 as usize + 1] as usize
        })
    }
}
