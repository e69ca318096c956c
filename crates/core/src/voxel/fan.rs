//! The space between neighbouring rays of one origin, filled without drawing the rays.
//!
//! Seen from the origin of a patch, rays are points of a plane: the slopes of their directions against an axis of the
//! lattice. The plane is cut into cells a little larger than the distance between neighbouring rays, and each cell knows
//! how far its rays and those of the eight cells around it all reach. A voxel whose centre is seen in a cell that reaches
//! beyond it is passed: by a ray where rays are denser than voxels, else between rays that all pass. Rays themselves need
//! drawing only from where their surroundings stop reaching: before surfaces, at edges, at the border of the patch.

use super::slab::{Frame, Line};
use crate::geometry::Vec3;

/// Edge of a cell over the distance of neighbouring rays: a square lattice leaves no square of √2 empty.
const CELL: f64 = 1.5;
/// Most cells a ray; beyond, the rays are no raster.
const MOST_CELLS_A_RAY: usize = 4;

/// Rays of one origin, as a map of slopes.
#[derive(Debug)]
pub struct Fan {
    /// Where all start: along the axis, and across it, voxels.
    origin: [f64; 3],
    low: [f64; 2],
    /// Slopes to cells.
    scale: [f64; 2],
    size: [usize; 2],
    /// How far along the axis every ray of the cell and its surroundings reaches; nothing where the cell has no ray.
    clear: Vec<f64>,
    rows: Vec<Row>,
}

/// A row of cells along the first slope.
#[derive(Debug, Clone, Copy)]
struct Row {
    /// The cells with rays, when they follow each other without a gap.
    whole: [usize; 2],
    /// How far all of them reach; nothing where there is a gap.
    least: f64,
}

impl Fan {
    /// The rays of a bundle that start at `start` (voxels), neighbours `step` radians apart; and for each ray how far its
    /// surroundings reach. `None` where they are too few or too scattered.
    pub fn new(lines: &[Line], frame: &Frame, start: &Vec3, step: f64) -> Option<(Self, Vec<f64>)> {
        if lines.len() < 64 || !(step > 0.0 && step < 0.2) {
            return None;
        }
        let (mut low, mut high, mut stretch) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2], [0.0f64; 2]);
        for line in lines {
            let square = 1.0 + line.slope[0].powi(2) + line.slope[1].powi(2);
            for k in 0..2 {
                low[k] = low[k].min(line.slope[k]);
                high[k] = high[k].max(line.slope[k]);
                // |∂slope/∂angle| = √(1 + slope²) · √(1 + both²).
                stretch[k] = stretch[k].max((1.0 + line.slope[k].powi(2)) * square);
            }
        }
        let scale = stretch.map(|s| 1.0 / (CELL * step * s.sqrt()));
        let size = [0, 1].map(|k| ((high[k] - low[k]) * scale[k]) as usize + 1);
        if size[0].saturating_mul(size[1]) > MOST_CELLS_A_RAY * lines.len() {
            return None;
        }
        let origin = [frame.sign * start[frame.along], start[frame.across[0]], start[frame.across[1]]];
        let mut fan = Self { origin, low, scale, size, clear: Vec::new(), rows: Vec::new() };
        let cells: Vec<usize> = lines.iter().map(|l| fan.cell(&l.slope)).collect();
        let mut reach = vec![f64::INFINITY; size[0] * size[1]];
        for (line, &cell) in lines.iter().zip(&cells) {
            reach[cell] = reach[cell].min(line.to);
        }
        let surroundings = fan.survey(&reach);
        let clear = cells.into_iter().map(|cell| surroundings[cell]).collect();
        Some((fan, clear))
    }

    fn cell(&self, slope: &[f64; 2]) -> usize {
        let number = |k: usize| (((slope[k] - self.low[k]) * self.scale[k]) as usize).min(self.size[k] - 1);
        number(1) * self.size[0] + number(0)
    }

    /// From how far each cell reaches to how far its surroundings do: for filling those that have rays, and, returned, for
    /// drawing, where a cell without rays reaches nowhere.
    fn survey(&mut self, reach: &[f64]) -> Vec<f64> {
        let [columns, rows] = self.size;
        let nothing = f64::NEG_INFINITY;
        self.clear = vec![nothing; reach.len()];
        let mut to_draw = vec![nothing; reach.len()];
        for j in 0..rows {
            for i in 0..columns {
                let cell = j * columns + i;
                if reach[cell] == f64::INFINITY {
                    continue;
                }
                let (mut least, mut empty) = (reach[cell], i == 0 || j == 0 || i + 1 == columns || j + 1 == rows);
                for b in j.saturating_sub(1)..(j + 2).min(rows) {
                    for a in i.saturating_sub(1)..(i + 2).min(columns) {
                        let there = reach[b * columns + a];
                        empty |= there == f64::INFINITY;
                        least = least.min(there);
                    }
                }
                self.clear[cell] = least;
                to_draw[cell] = if empty { nothing } else { least };
            }
        }
        self.rows = self.clear.chunks(columns).map(Row::of).collect();
        to_draw
    }

    /// Calls `set(row, first, end)` for the voxels of a layer, by numbers across the axis, that lie between rays which all
    /// reach beyond it. `layer` is a number along the axis; `rows` are those across it that are asked for.
    pub fn fill_layer(&self, layer: i64, rows: [i64; 2], mut set: impl FnMut(i64, i64, i64)) {
        let depth = layer as f64 + 0.5 - self.origin[0];
        if depth < 0.5 {
            return;
        }
        let beyond = (layer + 1) as f64;
        let (mut last, mut runs): (usize, Vec<[usize; 2]>) = (usize::MAX, Vec::new());
        let seen = |k: usize, slope: f64| self.origin[1 + k] + depth * slope - 0.5;
        let first = rows[0].max(seen(1, self.low[1]).ceil() as i64);
        let end = rows[1].min(seen(1, self.low[1] + self.size[1] as f64 / self.scale[1]).ceil() as i64);
        for row in first..end {
            let slope = (row as f64 + 0.5 - self.origin[2]) / depth;
            let number = (slope - self.low[1]) * self.scale[1];
            if !(0.0..self.size[1] as f64).contains(&number) {
                continue;
            }
            let number = number as usize;
            if number != last {
                runs.clear();
                self.runs(number, beyond, &mut runs);
                last = number;
            }
            for [from, to] in &runs {
                let voxel = |cell: usize| seen(0, self.low[0] + cell as f64 / self.scale[0]).ceil() as i64;
                set(row, voxel(*from), voxel(*to));
            }
        }
    }

    /// The cells of a row that reach `beyond`.
    fn runs(&self, row: usize, beyond: f64, out: &mut Vec<[usize; 2]>) {
        if self.rows[row].least >= beyond {
            out.push(self.rows[row].whole);
            return;
        }
        let clear = &self.clear[row * self.size[0]..(row + 1) * self.size[0]];
        let mut from = None;
        for (i, &c) in clear.iter().chain([&f64::NEG_INFINITY]).enumerate() {
            match (from, c >= beyond) {
                (None, true) => from = Some(i),
                (Some(first), false) => {
                    out.push([first, i]);
                    from = None;
                }
                _ => {}
            }
        }
    }
}

impl Row {
    fn of(clear: &[f64]) -> Self {
        let there = |c: &f64| *c > f64::NEG_INFINITY;
        let first = clear.iter().position(there).unwrap_or(0);
        let end = clear.iter().rposition(there).map_or(first, |i| i + 1);
        let least = clear[first..end].iter().copied().fold(f64::INFINITY, f64::min);
        Self { whole: [first, end], least: if first == end { f64::NEG_INFINITY } else { least } }
    }
}
