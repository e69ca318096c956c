//! Place of a box along a space-filling curve, by which index pages are packed.

use super::Aabb;
use crate::num::hilbert;

/// Bits per axis; three axes fill an integer.
const BITS: u32 = 21;
/// Side of a cell, metres. The curve repeats after 524 km: a project lies in one period, or across the border of two.
const CELL_M: f64 = 0.25;

/// Place of the centre of `b` on a Hilbert curve of three dimensions.
pub fn hilbert(b: &Aabb) -> u64 {
    let cell = |i: usize| (0.5 * (b.min[i] + b.max[i]) / CELL_M).floor() as i64 as u32 & ((1 << BITS) - 1);
    hilbert::place_of::<BITS, 3>([cell(0), cell(1), cell(2)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The curve visits every cell of a cube once and goes to a neighbour each time.
    #[test]
    fn the_curve_fills_a_cube_without_a_jump() {
        let n = 16;
        let mut cells: Vec<(u64, [i64; 3])> = (0..n * n * n)
            .map(|i| {
                let c = [i % n, i / n % n, i / n / n];
                let at = c.map(|k| (k as f64 + 0.5) * CELL_M);
                (hilbert(&Aabb { min: at, max: at }), c)
            })
            .collect();
        cells.sort_unstable();
        for (k, pair) in cells.windows(2).enumerate() {
            assert_eq!(pair[0].0 + 1, pair[1].0, "place {k}");
            let steps: i64 = (0..3).map(|i| (pair[0].1[i] - pair[1].1[i]).abs()).sum();
            assert_eq!(steps, 1, "{:?} to {:?}", pair[0].1, pair[1].1);
        }
    }

    #[test]
    fn far_and_odd_boxes_have_a_place() {
        for x in [0.0, -1e9, 1e300, f64::INFINITY, f64::NAN] {
            hilbert(&Aabb { min: [x; 3], max: [x; 3] });
        }
    }
}
