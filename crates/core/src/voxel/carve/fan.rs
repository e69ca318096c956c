//! The space between neighbouring rays of one origin, filled without drawing the rays.
//!
//! Seen from the origin of a patch, rays are points of a plane: the slopes of their directions against an axis of the
//! lattice. The plane is cut into cells a little larger than the distance between neighbouring rays, and each cell
//! knows how far its rays and those of the eight cells around it all reach. A voxel whose centre is seen in a cell that
//! reaches beyond it is passed: by a ray where rays are denser than voxels, else between rays that all pass. At the
//! border of the patch a ray stands for half a step around it, so that neighbouring patches leave no seam. Rays
//! themselves need drawing only from where their surroundings stop reaching: before surfaces and at edges. A ray that
//! grazes the surface it hits says nothing of the voxels that the surface runs through ([`Incidence`]).
//!
//! Against drawing every ray: voxels between rays are passed too, and a voxel that only the outermost rays of the field
//! of view graze, with its centre outside, is not.

use super::incidence::Incidence;
use super::line::{SlabAxes, SlabLine};
use super::raster::Raster;
use crate::geometry::Vec3;
use crate::num::whole::{ceil, floor};

/// Edge of a cell over the distance of neighbouring rays: a square lattice leaves no square of √2 empty.
const CELL: f64 = 1.5;
/// Part of a cell that a ray at the border stands for: half a step.
const HALF_STEP: f64 = 0.5 / CELL;
/// So far from their origin, voxels along the axis, voxels are wider than all rays together.
const NEAR: f64 = 2.0;
/// There, one ray in so many is drawn.
const DRAWN_NEAR: usize = 16;
/// Most cells without rays amid others, as a part of those that have some.
const MAX_HOLES: f64 = 0.25;
/// Most cells per ray; beyond, the rays are no raster.
const MAX_CELLS_PER_RAY: usize = 4;

/// Rays of one origin, as a map of slopes.
#[derive(Debug)]
pub struct Fan {
    /// Where all start: along the axis, and across it, voxels.
    origin: [f64; 3],
    /// The cells along either slope.
    axes: [Raster; 2],
    /// How far along the axis every ray of the cell and its surroundings reaches; nothing where the cell has no ray.
    clear: Vec<f64>,
    /// From where along the axis the rays of a cell are drawn: where one of the cells around it is no longer filled.
    drawn: Vec<f64>,
    rows: Vec<CellRow>,
}

/// A row of cells along the first slope.
#[derive(Debug, Clone, Copy)]
struct CellRow {
    /// The cells with rays, when they follow each other without a gap.
    whole: [usize; 2],
    /// How far all of them reach; nothing where there is a gap.
    least: f64,
}

impl Fan {
    /// The rays of a bundle that start at `start` (voxels), neighbours `step` radians apart; and the number of the cell
    /// of each. `None` where they are too few or too scattered.
    pub fn new(lines: &mut [SlabLine], axes: &SlabAxes, start: &Vec3, step: f64) -> Option<(Self, Vec<usize>)> {
        if lines.len() < 64 || !(step > 0.0 && step < 0.2) {
            return None;
        }
        let origin = [axes.sign * start[axes.along], start[axes.across[0]], start[axes.across[1]]];
        let mut fan = Self::over(lines, origin, step)?;
        let cells: Vec<usize> = lines.iter().map(|l| fan.number(&l.slope)).collect();
        let incidence = Incidence::new(&fan.axes, fan.origin[0], lines, &cells);
        let mut reach = vec![f64::INFINITY; fan.axes[0].len() * fan.axes[1].len()];
        for (line, &cell) in lines.iter_mut().zip(&cells) {
            line.stop_before(incidence.tangent(line, cell));
            reach[cell] = reach[cell].min(line.to);
        }
        fan.survey(&reach);
        (!fan.has_holes()).then_some((fan, cells))
    }

    /// Whether many cells amid others have no ray: where beams did not return, the others are drawn one by one.
    fn has_holes(&self) -> bool {
        let [columns, rows] = [0, 1].map(|k| self.axes[k].len());
        let there = |i: usize, j: usize| self.clear[j * columns + i] > f64::NEG_INFINITY;
        let hole = |i: usize, j: usize| {
            !there(i, j)
                && there(i - 1, j) as u8 + there(i + 1, j) as u8 + there(i, j - 1) as u8 + there(i, j + 1) as u8 >= 2
        };
        let inner = (1..rows.max(1) - 1).flat_map(|j| (1..columns.max(1) - 1).map(move |i| (i, j)));
        let holes = inner.filter(|&(i, j)| hole(i, j)).count();
        holes as f64 > MAX_HOLES * self.clear.iter().filter(|c| **c > f64::NEG_INFINITY).count() as f64
    }

    /// The cells, without what they know.
    fn over(lines: &[SlabLine], origin: [f64; 3], step: f64) -> Option<Self> {
        let (mut low, mut high, mut stretch) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2], [0.0f64; 2]);
        for line in lines {
            for k in 0..2 {
                low[k] = low[k].min(line.slope[k]);
                high[k] = high[k].max(line.slope[k]);
                // |∂ atan(slope) / ∂angle|².
                stretch[k] = stretch[k].max(line.length_squared() / (1.0 + line.slope[k].powi(2)));
            }
        }
        let most = MAX_CELLS_PER_RAY * lines.len();
        let raster = |k: usize| Raster::new(low[k], high[k], CELL * step * stretch[k].sqrt(), most);
        let axes = [raster(0)?, raster(1)?];
        let few = axes[0].len() * axes[1].len() <= most;
        few.then(|| Self { origin, axes, clear: Vec::new(), drawn: Vec::new(), rows: Vec::new() })
    }

    /// From the origin along the axis, voxels.
    fn depth(&self, along: f64) -> f64 {
        along - self.origin[0]
    }

    fn number(&self, slope: &[f64; 2]) -> usize {
        self.axes[1].cell(slope[1]) * self.axes[0].len() + self.axes[0].cell(slope[0])
    }

    /// The parts of a ray, by its number and cell, that need drawing: up to the first, and from the second on.
    /// In voxels along the carving axis.
    pub fn drawn(&self, ray: usize, cell: usize) -> [f64; 2] {
        let near = if ray.is_multiple_of(DRAWN_NEAR) { self.origin[0] + NEAR } else { f64::NEG_INFINITY };
        [near, self.drawn[cell]]
    }

    /// The rows of voxels across the axis that its rays pass between two places along it, and one more on every side.
    pub fn extent(&self, along: [f64; 2]) -> [[i64; 2]; 2] {
        [0, 1].map(|k| {
            let slopes = self.axes[k].all(HALF_STEP);
            let depths = along.map(|a| self.depth(a).max(0.0));
            let all = slopes.map(|slope| depths.map(|depth| self.origin[1 + k] + slope * depth));
            let all = [all[0][0], all[0][1], all[1][0], all[1][1]];
            let low = all.iter().copied().fold(f64::INFINITY, f64::min);
            let high = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            [floor(low) - 1, floor(high) + 1]
        })
    }

    /// From how far each cell reaches to how far its surroundings do.
    fn survey(&mut self, reach: &[f64]) {
        self.clear = self.least_around(reach);
        let filled: Vec<f64> =
            self.clear.iter().map(|&c| if c == f64::NEG_INFINITY { f64::INFINITY } else { c }).collect();
        self.drawn = self.least_around(&filled).into_iter().map(f64::floor).collect();
        self.rows = self.clear.chunks(self.axes[0].len()).map(CellRow::of).collect();
    }

    /// The least of every cell and the eight around it, of those that have one; -∞ for a cell that has none itself (∞).
    fn least_around(&self, of: &[f64]) -> Vec<f64> {
        let [columns, rows] = [0, 1].map(|k| self.axes[k].len());
        let window = |i: usize, n: usize| i.saturating_sub(1)..(i + 2).min(n);
        let row_wise: Vec<f64> = (0..of.len())
            .map(|cell| {
                let (i, start) = (cell % columns, cell - cell % columns);
                window(i, columns).fold(f64::INFINITY, |least, a| least.min(of[start + a]))
            })
            .collect();
        (0..of.len())
            .map(|cell| match of[cell] {
                f64::INFINITY => f64::NEG_INFINITY,
                _ => window(cell / columns, rows)
                    .fold(f64::INFINITY, |least, b| least.min(row_wise[b * columns + cell % columns])),
            })
            .collect()
    }

    /// Calls `set(row, first, end)` for the voxels of a layer, by numbers across the axis, that lie between rays which
    /// all reach beyond it. `layer` is a number along the axis; `rows` are those across it that are asked for.
    pub fn fill_layer(&self, layer: i64, rows: [i64; 2], mut set: impl FnMut(i64, i64, i64)) {
        let depth = layer as f64 + 0.5 - self.origin[0];
        if depth < 0.5 {
            return;
        }
        let beyond = (layer + 1) as f64;
        let seen = |k: usize, slope: f64| ceil(self.origin[1 + k] + depth * slope - 0.5);
        let [first, end] = self.axes[1].all(HALF_STEP).map(|slope| seen(1, slope));
        let (first, end) = (rows[0].max(first), rows[1].min(end));
        let (mut number, mut runs): (Option<usize>, Vec<[i64; 2]>) = (None, Vec::new());
        let inverse = 1.0 / depth;
        for row in first..end {
            let slope = (row as f64 + 0.5 - self.origin[2]) * inverse;
            let own = self.axes[1].cell_from(number.unwrap_or(0), slope);
            // Rows in one row of cells are alike.
            if number != Some(own) {
                runs.clear();
                self.runs(own, beyond, |slopes| runs.push(slopes.map(|slope| seen(0, slope))));
                number = Some(own);
            }
            runs.iter().for_each(|[from, end]| set(row, *from, *end));
        }
    }

    /// The slopes of a row's cells that reach `beyond`.
    fn runs(&self, row: usize, beyond: f64, mut run: impl FnMut([f64; 2])) {
        let slopes = |cells: [usize; 2]| self.axes[0].slopes(cells, HALF_STEP);
        if self.rows[row].least >= beyond {
            run(slopes(self.rows[row].whole));
            return;
        }
        let columns = self.axes[0].len();
        let clear = &self.clear[row * columns..(row + 1) * columns];
        let mut from = None;
        for (i, &c) in clear.iter().chain([&f64::NEG_INFINITY]).enumerate() {
            match (from, c >= beyond) {
                (None, true) => from = Some(i),
                (Some(first), false) => {
                    run(slopes([first, i]));
                    from = None;
                }
                _ => {}
            }
        }
    }
}

impl CellRow {
    fn of(clear: &[f64]) -> Self {
        let there = |c: &f64| *c > f64::NEG_INFINITY;
        let first = clear.iter().position(there).unwrap_or(0);
        let end = clear.iter().rposition(there).map_or(first, |i| i + 1);
        let least = clear[first..end].iter().copied().fold(f64::INFINITY, f64::min);
        Self { whole: [first, end], least: if first == end { f64::NEG_INFINITY } else { least } }
    }
}
