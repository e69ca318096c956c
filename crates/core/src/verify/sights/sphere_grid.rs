//! All directions, cut into cells of about the same size.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::geometry::Vec3;

/// Rows of equal height, each of cells as wide as high.
#[derive(Debug)]
pub struct SphereGrid {
    /// Height of a row and width of a cell, radians.
    cell: f64,
    /// First cell of each row, and behind the last.
    rows: Vec<u32>,
}

impl SphereGrid {
    /// With cells so high, radians.
    pub fn new(cell: f64) -> Self {
        let mut rows = vec![0];
        for row in 0..(PI / cell).ceil() as usize {
            let elevation = (row as f64 + 0.5) * cell - FRAC_PI_2;
            rows.push(rows[row] + (TAU * elevation.cos().max(0.0) / cell).ceil().max(4.0) as u32);
        }
        Self { cell, rows }
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.rows.last().map_or(0, |end| *end as usize)
    }

    /// The cell of a unit direction, and its squared distance from the cell's middle in cells.
    pub fn place(&self, direction: &Vec3) -> (usize, f32) {
        let row = (direction.z.clamp(-1.0, 1.0).asin() + FRAC_PI_2) / self.cell;
        let row_number = (row as usize).min(self.rows.len() - 2);
        let (start, end) = (self.rows[row_number], self.rows[row_number + 1]);
        let columns = f64::from(end - start);
        let column = (direction.y.atan2(direction.x) + PI) / TAU * columns;
        let column_number = (column as u32).min(end - start - 1);
        let off = (row - row_number as f64 - 0.5).powi(2) + (column - f64::from(column_number) - 0.5).powi(2);
        ((start + column_number) as usize, off as f32)
    }

    /// The unit directions in the middles of all cells.
    pub fn middles(&self) -> impl Iterator<Item = Vec3> {
        self.rows.windows(2).enumerate().flat_map(|(row, ends)| {
            let (sin, cos) = ((row as f64 + 0.5) * self.cell - FRAC_PI_2).sin_cos();
            let columns = ends[1] - ends[0];
            (0..columns).map(move |column| {
                let (y, x) = ((f64::from(column) + 0.5) / f64::from(columns) * TAU - PI).sin_cos();
                Vec3::new(x * cos, y * cos, sin)
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// No direction is farther from the middle of its cell than one and a half of its height.
        #[test]
        fn cells_are_small(direction in prop::array::uniform3(-1.0..1.0f64), cell in 0.01..0.2f64) {
            let direction = Vec3::from(direction);
            prop_assume!(direction.norm() > 0.1);
            let (direction, grid) = (direction.normalize(), SphereGrid::new(cell));
            let middles: Vec<Vec3> = grid.middles().collect();
            prop_assert_eq!(middles.len(), grid.len());
            let middle = &middles[grid.place(&direction).0];
            prop_assert!(middle.angle(&direction) <= 1.5 * cell);
        }
    }
}
