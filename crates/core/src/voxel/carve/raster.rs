//! Cells of nearly equal angle along a slope.

/// Bins of the table that finds a cell, for every cell.
const BINS_PER_CELL: usize = 4;
/// Least part of a cell that the last one is.
const MIN_LAST_CELL: f64 = 0.1;
/// Cells tried one after the other before the table is asked.
const NEARBY: usize = 3;

/// One axis of the plane of slopes, cut into cells that are equally wide as angles.
#[derive(Debug, Clone)]
pub struct Raster {
    /// Slopes where cells begin, and where the last one ends.
    edges: Vec<f64>,
    /// For equal parts of the axis, the cell at their beginning.
    bins: Vec<u32>,
    bins_per_slope: f64,
}

impl Raster {
    /// Cells of an `angle` (radians) from a slope to another; `None` for more than `most`.
    pub fn new(low: f64, high: f64, angle: f64, most: usize) -> Option<Self> {
        let first = low.atan();
        let cells = ((high.atan() - first) / angle) as usize + 1;
        if cells > most {
            return None;
        }
        let mut edges: Vec<f64> = (0..=cells).map(|i| (first + i as f64 * angle).tan()).collect();
        // The last cell ends with the last ray.
        edges[cells] = high.max(edges[cells - 1] + MIN_LAST_CELL * (edges[cells] - edges[cells - 1]));
        let width = edges[cells] - edges[0];
        if width.is_nan() || width <= 0.0 {
            return None;
        }
        let count = BINS_PER_CELL * cells;
        let begin = |bin: usize| edges[0] + width * bin as f64 / count as f64;
        let bins = (0..count).map(|bin| edges.partition_point(|e| *e <= begin(bin)).saturating_sub(1) as u32).collect();
        let bins_per_slope = count as f64 / width;
        Some(Self { edges, bins, bins_per_slope })
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.edges.len() - 1
    }

    /// Number of the cell that holds a slope; the nearest one for a slope beside all.
    /// A tangent against the carving axis.
    pub fn cell(&self, slope: f64) -> usize {
        let bin = ((slope - self.edges[0]) * self.bins_per_slope).max(0.0) as usize;
        let mut cell = self.bins[bin.min(self.bins.len() - 1)] as usize;
        while cell + 1 < self.len() && slope >= self.edges[cell + 1] {
            cell += 1;
        }
        cell
    }

    /// The same for a slope that lies not before the cell `start`: quick where it lies near.
    /// Slopes are tangents against the carving axis.
    pub fn cell_from(&self, start: usize, slope: f64) -> usize {
        let near =
            (start..self.len()).take(NEARBY).find(|&cell| cell + 1 == self.len() || slope < self.edges[cell + 1]);
        near.unwrap_or_else(|| self.cell(slope))
    }

    /// The slopes of cells `from` up to `end`, widened by a part of a cell. Tangents against the carving axis.
    pub fn slopes(&self, [from, end]: [usize; 2], widened: f64) -> [f64; 2] {
        [self.edges[from] - widened * self.width(from), self.edges[end] + widened * self.width(end - 1)]
    }

    /// The slopes of all cells. Tangents against the carving axis.
    pub fn all(&self, widened: f64) -> [f64; 2] {
        self.slopes([0, self.len()], widened)
    }

    /// Width of a cell; of the last, which may be cut short, that of the one before it.
    fn width(&self, cell: usize) -> f64 {
        let whole = if cell + 1 == self.len() { cell.saturating_sub(1) } else { cell };
        self.edges[whole + 1] - self.edges[whole]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn cells_hold_their_slopes(
            low in -1.7..1.0f64,
            width in 0.001..0.8f64,
            angle in 0.001..0.1f64,
            at in 0.0..1.0f64,
        ) {
            let r = Raster::new(low, low + width, angle, 100_000).unwrap();
            let slope = low + width * at;
            let cell = r.cell(slope);
            let [from, to] = r.slopes([cell, cell + 1], 0.0);
            prop_assert!(from <= slope + 1e-12 && slope <= to + 1e-12, "{from} {slope} {to}");
            prop_assert!(to.atan() - from.atan() < angle + 1e-9);
            prop_assert!(cell + 1 == r.len() || (to.atan() - from.atan() - angle).abs() < 1e-9);
            prop_assert!((0..=cell).all(|start| r.cell_from(start, slope) == cell));
            prop_assert_eq!((r.cell(low - 1.0), r.cell(low + 9.0)), (0, r.len() - 1));
        }
    }

    #[test]
    fn too_many_are_refused() {
        assert!(Raster::new(-1.0, 1.0, 1e-9, 1000).is_none());
        assert!(Raster::new(0.5, 0.5, 0.1, 1000).is_some());
    }
}
