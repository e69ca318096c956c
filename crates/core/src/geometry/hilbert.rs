//! Place of a box along a space-filling curve: neighbours on the curve are neighbours in space.

use super::Aabb;

/// Bits per axis; three axes fill an integer.
const BITS: u32 = 21;
/// Side of a cell, metres. The curve repeats after 524 km: a project lies in one period, or across the border of two.
const CELL_M: f64 = 0.25;

/// Place of the centre of `b` on a Hilbert curve of three dimensions.
pub fn hilbert(b: &Aabb) -> u64 {
    let cell = |i: usize| (0.5 * (b.min[i] + b.max[i]) / CELL_M).floor() as i64 as u32 & ((1 << BITS) - 1);
    interleaved(transposed([cell(0), cell(1), cell(2)]))
}

/// Coordinates to the transposed index (J. Skilling, Programming the Hilbert curve, 2004, AxestoTranspose).
fn transposed(mut x: [u32; 3]) -> [u32; 3] {
    let mut q = 1 << (BITS - 1);
    while q > 1 {
        let p = q - 1;
        for i in 0..3 {
            if x[i] & q != 0 {
                x[0] ^= p;
            } else {
                let t = (x[0] ^ x[i]) & p;
                x[0] ^= t;
                x[i] ^= t;
            }
        }
        q >>= 1;
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    let t = (1..BITS).filter(|&k| x[2] >> k & 1 == 1).fold(0, |t, k| t ^ ((1 << k) - 1));
    x.map(|c| c ^ t)
}

fn interleaved(x: [u32; 3]) -> u64 {
    let mut out = 0;
    for k in (0..BITS).rev() {
        for c in x {
            out = out << 1 | u64::from(c >> k & 1);
        }
    }
    out
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
