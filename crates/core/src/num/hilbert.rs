//! Cells along a Hilbert curve: neighbours on the curve are neighbours in space.

/// Place of a cell of an `N`-dimensional lattice along the Hilbert curve of order `BITS`; coordinates have `BITS` bits,
/// and `N`·`BITS` ≤ 64. After J. Skilling, Programming the Hilbert curve (2004).
pub fn place_of<const BITS: u32, const N: usize>(cell: [u32; N]) -> u64 {
    interleaved::<BITS, N>(transposed::<BITS, N>(cell))
}

/// The same in the plane for coordinates of up to 32 bits: curves whose orders differ by an even number begin alike, so
/// that coordinates of few bits need few steps.
pub fn place_in_plane(cell: [u32; 2]) -> u64 {
    match (cell[0] | cell[1]).leading_zeros() {
        24.. => place_of::<8, 2>(cell),
        20.. => place_of::<12, 2>(cell),
        16.. => place_of::<16, 2>(cell),
        _ => place_of::<32, 2>(cell),
    }
}

/// Coordinates to the transposed index (AxestoTranspose).
fn transposed<const BITS: u32, const N: usize>(mut x: [u32; N]) -> [u32; N] {
    let mut q = 1 << (BITS - 1);
    while q > 1 {
        let p = q - 1;
        for i in 0..N {
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
    for i in 1..N {
        x[i] ^= x[i - 1];
    }
    let t = (1..BITS).filter(|&k| x[N - 1] >> k & 1 == 1).fold(0, |t, k| t ^ ((1 << k) - 1));
    x.map(|c| c ^ t)
}

fn interleaved<const BITS: u32, const N: usize>(x: [u32; N]) -> u64 {
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
    use proptest::prelude::*;

    /// The curve visits every cell once and goes to a neighbour each time.
    fn fills_without_a_jump<const BITS: u32, const N: usize>(side: u32) {
        let cell = |i: u32| std::array::from_fn::<u32, N, _>(|k| i / side.pow(k as u32) % side);
        let mut cells: Vec<(u64, [u32; N])> =
            (0..side.pow(N as u32)).map(cell).map(|c| (place_of::<BITS, N>(c), c)).collect();
        cells.sort_unstable();
        for (k, pair) in cells.windows(2).enumerate() {
            assert_eq!(pair[0].0 + 1, pair[1].0, "place {k}");
            let steps: u32 = pair[0].1.iter().zip(&pair[1].1).map(|(a, b)| a.abs_diff(*b)).sum();
            assert_eq!(steps, 1, "{:?} to {:?}", pair[0].1, pair[1].1);
        }
    }

    #[test]
    fn the_curve_fills_a_square_and_a_cube() {
        fills_without_a_jump::<32, 2>(64);
        fills_without_a_jump::<21, 3>(16);
    }

    /// In the plane by turning quadrants (Hamilton & Rau-Chaplin): samples of stored evidence are in this order.
    fn by_rotation(mut x: u32, mut y: u32) -> u64 {
        let mut place = 0u64;
        for bit in (0..32).rev() {
            let (rx, ry) = (x >> bit & 1, y >> bit & 1);
            place = place << 2 | u64::from((3 * rx) ^ ry);
            if ry == 0 {
                if rx == 1 {
                    (x, y) = (!x, !y);
                }
                (x, y) = (y, x);
            }
        }
        place
    }

    proptest! {
        #[test]
        fn the_plane_is_ordered_as_by_rotation(x: u32, y: u32) {
            prop_assert_eq!(place_of::<32, 2>([x, y]), by_rotation(x, y));
            for bits in 0..32 {
                prop_assert_eq!(place_in_plane([x >> bits, y >> bits]), by_rotation(x >> bits, y >> bits));
            }
        }
    }
}
