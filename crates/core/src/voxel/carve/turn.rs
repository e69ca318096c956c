//! Bits of a block turned from the axes of a bundle to those of the lattice.

use crate::voxel::lattice::Bits;

/// Rows to columns.
pub fn crossed(layers: &[[u8; 8]; 8]) -> [[u8; 8]; 8] {
    let mut out = [[0; 8]; 8];
    for (k, layer) in layers.iter().enumerate() {
        for (j, byte) in layer.iter().enumerate() {
            out[j][k] = *byte;
        }
    }
    out
}

/// Sets the bits from `from` on, up to `end`.
pub fn set_bits(bytes: &mut [u8], from: usize, end: usize) {
    if from >= end {
        return;
    }
    let (first, last) = (from / 8, (end - 1) / 8);
    let (head, tail) = (0xffu8 << (from % 8), 0xffu8 >> (7 - (end - 1) % 8));
    if first == last {
        bytes[first] |= head & tail;
    } else {
        bytes[first] |= head;
        bytes[first + 1..last].fill(0xff);
        bytes[last] |= tail;
    }
}

/// From (bit, byte, word) = (along, across, across) to (x, y, z).
pub fn oriented(bits: Bits, along: usize) -> Bits {
    match along {
        0 => bits,
        1 => bits.map(transposed),
        _ => {
            let by_y = bits.map(|word| transposed(word).to_le_bytes());
            std::array::from_fn(|z| u64::from_le_bytes(std::array::from_fn(|y| by_y[y][z])))
        }
    }
}

/// Swaps bits and bytes of a word: bit j of byte i becomes bit i of byte j (Hacker's Delight, 7-3).
pub fn transposed(x: u64) -> u64 {
    let swap = |x: u64, shift: u32, mask: u64| {
        let t = (x ^ (x >> shift)) & mask;
        x ^ t ^ (t << shift)
    };
    let x = swap(x, 7, 0x00aa_00aa_00aa_00aa);
    let x = swap(x, 14, 0x0000_cccc_0000_cccc);
    swap(x, 28, 0x0000_0000_f0f0_f0f0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn bit(bits: &Bits, [bit, byte, word]: [usize; 3]) -> bool {
        bits[word] >> (8 * byte + bit) & 1 == 1
    }

    proptest! {
        /// Voxel by voxel.
        #[test]
        fn every_bit_finds_its_place(bits: Bits, along in 0usize..3, from in 0usize..64, len in 0usize..64) {
            let turned = oriented(bits, along);
            for (i, j, k) in (0..512).map(|n| (n % 8, n / 8 % 8, n / 64)) {
                // (along, across, across) of the bundle, in the order of the lattice.
                let there = [[i, j, k], [j, i, k], [j, k, i]][along];
                prop_assert_eq!(bit(&bits, [i, j, k]), bit(&turned, there));
            }
            let layers = bits.map(u64::to_le_bytes);
            for (i, j, k) in (0..512).map(|n| (n % 8, n / 8 % 8, n / 64)) {
                prop_assert_eq!(layers[k][j] >> i & 1, crossed(&layers)[j][k] >> i & 1);
            }
            let end = (from + len).min(64);
            let mut bytes = [0u8; 8];
            set_bits(&mut bytes, from, end);
            let word = u64::from_le_bytes(bytes);
            prop_assert!((0..64).all(|i| (word >> i & 1 == 1) == (from..end).contains(&i)));
        }
    }
}
