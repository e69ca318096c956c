//! At which angle rays of a fan meet the surface they hit, by what their neighbours hit.

use super::line::SlabLine;
use super::raster::Raster;

/// Beyond 87° the tangent says nothing more.
const MAX_TANGENT: f64 = 20.0;
/// Returns of a plane are off its inverse depths by less than this part of what these change across a cell.
const SPREAD: f64 = 0.25;

/// The slope of the surface in every cell of a fan.
///
/// In the plane of slopes the inverse depth of a plane is linear: with (u, v) the slopes and z the depth of a point,
/// a·x + b·y + c·z = 1 is 1/z = a·u + b·v + c. At the edge of a thing its own side counts, so of the differences to
/// either neighbour the smaller is taken, and none where they disagree in sign (the minmod limiter of Roe 1986).
#[derive(Debug)]
pub struct Incidence {
    /// (a, b) of every cell.
    gradient: Vec<[f64; 2]>,
    /// Mean of the inverse depths of a cell, and of the slopes they are seen at.
    mean: Vec<[f64; 3]>,
    /// By how much an inverse depth may be off the plane of its cell.
    spread: Vec<f64>,
    origin_depth: f64,
}

impl Incidence {
    /// From the returns of all rays, each in a cell of the axes (in rows along the first), that start at a place along
    /// the slabs' axis.
    pub fn new(axes: &[Raster; 2], start: f64, lines: &[SlabLine], cells: &[usize]) -> Self {
        let [columns, rows] = axes.each_ref().map(Raster::len);
        let mut sums = vec![([0.0f64; 3], 0.0f64); columns * rows];
        for (line, &cell) in lines.iter().zip(cells) {
            let own = [1.0 / (line.end - start).max(1e-3), line.slope[0], line.slope[1]];
            (0..3).for_each(|i| sums[cell].0[i] += own[i]);
            sums[cell].1 += 1.0;
        }
        let mean: Vec<[f64; 3]> = sums.iter().map(|(sum, n)| sum.map(|s| s / n.max(1.0))).collect();
        let inverse: Vec<Option<f64>> = sums.iter().zip(&mean).map(|(s, m)| (s.1 > 0.0).then_some(m[0])).collect();
        let [a, b] = [0, 1].map(|axis| slopes([columns, rows], &inverse, &mean, axis));
        let gradient: Vec<[f64; 2]> = a.into_iter().zip(b).map(|(a, b)| [a, b]).collect();
        let width = |axis: usize, number: usize| {
            let [low, high] = axes[axis].slopes([number, number + 1], 0.0);
            high - low
        };
        let across =
            |cell: usize, g: &[f64; 2]| g[0].abs() * width(0, cell % columns) + g[1].abs() * width(1, cell / columns);
        let spread = gradient.iter().enumerate().map(|(cell, g)| SPREAD * across(cell, g)).collect();
        Self { gradient, mean, spread, origin_depth: 0.0 - start }
    }

    /// Tangent of the angle between a ray of a cell and the normal of what it hits; 0 where the cell's returns lie on
    /// no plane, as at the edge of a thing.
    pub fn tangent(&self, line: &SlabLine, cell: usize) -> f64 {
        let ([a, b], [u, v]) = (self.gradient[cell], line.slope);
        let inverse = 1.0 / (line.end + self.origin_depth).max(1e-3);
        let [mean, mean_u, mean_v] = self.mean[cell];
        if (inverse - mean - a * (u - mean_u) - b * (v - mean_v)).abs() > self.spread[cell] {
            return 0.0;
        }
        let c = inverse - a * u - b * v;
        let square = (a * a + b * b + c * c) * line.length_squared() / (inverse * inverse) - 1.0;
        square.max(0.0).sqrt().min(MAX_TANGENT)
    }
}

/// How much inverse depths change with one of the slopes, in every cell.
fn slopes(size: [usize; 2], inverse: &[Option<f64>], mean: &[[f64; 3]], axis: usize) -> Vec<f64> {
    // Between the places that were seen, not the middles of cells: these hold one column of a raster or two.
    let slope = |cell: usize, sides: [Option<usize>; 2]| {
        let own = inverse[cell]?;
        let towards = |side: Option<usize>| {
            let there = side?;
            let apart = mean[there][1 + axis] - mean[cell][1 + axis];
            Some((inverse[there]? - own) / apart).filter(|s| s.is_finite())
        };
        let [before, after] = sides.map(towards);
        Some(minmod(before, after))
    };
    let slopes: Vec<Option<f64>> = along(size, axis).map(|(cell, sides)| slope(cell, sides)).collect();
    // A cell with returns of two things looks steep; its neighbours do not.
    let least = |(cell, sides): (usize, [Option<usize>; 2])| {
        let [before, after] = sides.map(|side| side.and_then(|c| slopes[c]));
        minmod(Some(minmod(before, slopes[cell])), Some(minmod(slopes[cell], after)))
    };
    along(size, axis).map(least).collect()
}

/// Every cell with those before and after it on an axis.
fn along([columns, rows]: [usize; 2], axis: usize) -> impl Iterator<Item = (usize, [Option<usize>; 2])> {
    let (stride, length) = if axis == 0 { (1, columns) } else { (columns, rows) };
    (0..columns * rows).map(move |cell| {
        let number = cell / stride % length;
        (cell, [(number > 0).then(|| cell - stride), (number + 1 < length).then(|| cell + stride)])
    })
}

/// The smaller of two differences of one sign, else 0; the one that there is.
fn minmod(a: Option<f64>, b: Option<f64>) -> f64 {
    match (a, b) {
        (Some(a), Some(b)) if a * b > 0.0 => {
            if a.abs() < b.abs() {
                a
            } else {
                b
            }
        }
        (Some(_), Some(_)) | (None, None) => 0.0,
        (Some(one), None) | (None, Some(one)) => one,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smaller_difference_counts() {
        assert_eq!(minmod(Some(1.0), Some(3.0)), 1.0);
        assert_eq!(minmod(Some(-1.0), Some(-0.5)), -0.5);
        assert_eq!(minmod(Some(-1.0), Some(0.5)), 0.0);
        assert_eq!((minmod(None, Some(0.5)), minmod(None, None)), (0.5, 0.0));
    }
}
