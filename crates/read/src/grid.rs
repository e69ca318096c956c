//! Directions of beams without return, from the scan's grid.
//!
//! A scanner turns a mirror (rows) while its head rotates (columns). Where a cell of the grid returned nothing, its
//! direction follows from the other cells of its row and column.

use std::f64::consts::PI;

use asbuilt_core::geometry::Vec3;
use asbuilt_core::num::stats::median;

/// A cell of the scan's grid; `None` where nothing returned.
#[derive(Debug, Clone, Copy)]
pub struct GridCell {
    pub row: u32,
    pub column: u32,
    /// Return in the scanner's frame.
    pub point: Option<Vec3>,
}

/// Unit directions (scanner's frame) of the cells without return whose row and column are known well enough.
///
/// Empty when the grid does not fit the model of elevation by row and azimuth by column: a wrong direction would
/// claim empty space where nobody looked.
pub fn missing_directions(cells: &[GridCell]) -> Vec<Vec3> {
    let Some(fit) = Fit::of(cells) else { return Vec::new() };
    if !fit.holds(cells) {
        return Vec::new();
    }
    cells.iter().filter(|c| c.point.is_none()).filter_map(|c| fit.direction(c)).collect()
}

/// Number of cells by which a fit is judged: enough for a median.
const MAX_CHECKED: usize = 100_000;

struct Fit {
    azimuths: Vec<Option<f64>>,
    elevations: Vec<Option<f64>>,
}

impl Fit {
    fn of(cells: &[GridCell]) -> Option<Self> {
        let size = |f: fn(&GridCell) -> u32| cells.iter().map(f).max().map(|m| m as usize + 1);
        let (rows, columns) = (size(|c| c.row)?, size(|c| c.column)?);
        if rows < 2 || columns < 2 {
            return None; // a list
        }
        if rows.saturating_mul(columns) > cells.len().saturating_mul(4).max(64) {
            return None; // not a filled grid
        }
        let mut elevations: Vec<Vec<f64>> = vec![Vec::new(); rows];
        let mut headings: Vec<Vec<Vec3>> = vec![Vec::new(); columns];
        for c in cells {
            let Some(p) = c.point else { continue };
            elevations[c.row as usize].push(p.z.atan2(p.x.hypot(p.y)));
            // Near the pole the azimuth of a noisy point is arbitrary.
            if p.x.hypot(p.y) > 0.1 * p.norm() {
                headings[c.column as usize].push(Vec3::new(p.x, p.y, 0.0).normalize());
            }
        }
        let azimuth = |h: &Vec<Vec3>| {
            let sum: Vec3 = h.iter().sum();
            (h.len() >= 3 && sum.norm() > 0.5 * h.len() as f64).then(|| sum.y.atan2(sum.x))
        };
        let elevation = |e: &mut Vec<f64>| if e.len() >= 3 { median(e) } else { None };
        Some(Self {
            azimuths: headings.iter().map(azimuth).collect(),
            elevations: elevations.iter_mut().map(elevation).collect(),
        })
    }

    fn direction(&self, c: &GridCell) -> Option<Vec3> {
        let (azimuth, elevation) = (self.azimuths[c.column as usize]?, self.elevations[c.row as usize]?);
        let flat = elevation.cos();
        Some(Vec3::new(flat * azimuth.cos(), flat * azimuth.sin(), elevation.sin()))
    }

    /// Whether the fit predicts the direction of the cells that did return, to half a step of the grid.
    fn holds(&self, cells: &[GridCell]) -> bool {
        let known: Vec<f64> = self.elevations.iter().flatten().copied().collect();
        let steps = known.windows(2).map(|w| (w[1] - w[0]).abs()).filter(|s| *s > 0.0 && *s < PI / 8.0);
        let Some(step) = median(&mut steps.collect::<Vec<_>>()) else { return false };
        let some = cells.iter().step_by(cells.len().div_ceil(MAX_CHECKED).max(1));
        let mut errors: Vec<f64> =
            some.filter_map(|c| Some((self.direction(c)? - c.point?.try_normalize(1e-9)?).norm())).collect();
        median(&mut errors).is_some_and(|e| e <= 0.5 * step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn direction(row: u32, column: u32) -> Vec3 {
        let (el, az) = (f64::from(row) * 0.02 - 0.5, f64::from(column) * 0.02 - 3.0);
        Vec3::new(el.cos() * az.cos(), el.cos() * az.sin(), el.sin())
    }

    #[test]
    fn missing_cells_get_their_direction() {
        let cells: Vec<GridCell> = (0..40 * 300)
            .map(|i| (i / 300, i % 300))
            .map(|(row, column)| {
                let hole = (10..20).contains(&row) && (100..120).contains(&column);
                GridCell { row, column, point: (!hole).then(|| direction(row, column) * (3.0 + f64::from(column % 7))) }
            })
            .collect();
        let got = missing_directions(&cells);
        assert_eq!(got.len(), 200);
        let want: Vec<Vec3> = cells.iter().filter(|c| c.point.is_none()).map(|c| direction(c.row, c.column)).collect();
        assert!(got.iter().zip(&want).all(|(a, b)| (a - b).norm() < 1e-3));
    }

    #[test]
    fn a_grid_that_is_no_scan_grid_gives_nothing() {
        let cells: Vec<GridCell> = (0..400u32)
            .map(|i| {
                let p = Vec3::new(f64::from(i * 7 % 13) - 6.0, f64::from(i * 5 % 11) - 5.0, f64::from(i % 9) - 4.0);
                GridCell { row: i / 20, column: i % 20, point: (i % 10 != 0).then_some(p) }
            })
            .collect();
        assert!(missing_directions(&cells).is_empty());
        assert!(missing_directions(&[]).is_empty());
    }
}
