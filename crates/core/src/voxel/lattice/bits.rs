//! A bit for every voxel of a block: eight by eight by eight.

/// Voxels along an edge of a block.
pub const EDGE: i64 = 8;

/// Bit x of byte y of word z.
pub type Bits = [u64; 8];

/// Number of a voxel in its block: of its bit, and of its count.
pub fn slot_of(voxel: [i64; 3]) -> usize {
    let [x, y, z] = voxel.map(|i| i.rem_euclid(EDGE) as usize);
    (z * 8 + y) * 8 + x
}

/// Whether the bit of a slot is set.
pub fn holds(bits: &Bits, slot: usize) -> bool {
    bits[slot / 64] >> (slot % 64) & 1 == 1
}

/// Sets the bit of a slot.
pub fn put(bits: &mut Bits, slot: usize) {
    bits[slot / 64] |= 1 << (slot % 64);
}

/// Clears the bit of a slot.
pub fn take(bits: &mut Bits, slot: usize) {
    bits[slot / 64] &= !(1 << (slot % 64));
}

/// The bits that both have.
pub fn common(a: &Bits, b: &Bits) -> Bits {
    std::array::from_fn(|word| a[word] & b[word])
}

/// Number of set bits.
pub fn count(bits: &Bits) -> u64 {
    bits.iter().map(|word| u64::from(word.count_ones())).sum()
}

/// The slots whose bits are set.
pub fn slots(bits: &Bits) -> impl Iterator<Item = usize> {
    bits.iter().enumerate().flat_map(|(word, &bits)| {
        let rest = |b: &u64| Some(b & (b - 1)).filter(|&b| b != 0);
        let left = std::iter::successors(Some(bits).filter(|&b| b != 0), rest);
        left.map(move |b| 64 * word + b.trailing_zeros() as usize)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slots_of_bits() {
        let mut bits = [0; 8];
        bits[0] = 1;
        bits[7] = 1 << 63 | 1 << 5;
        assert_eq!(slots(&bits).collect::<Vec<_>>(), [0, 453, 511]);
        take(&mut bits, 453);
        assert!(holds(&bits, 511) && !holds(&bits, 453));
        assert_eq!((count(&bits), common(&bits, &[1; 8])), (2, [1, 0, 0, 0, 0, 0, 0, 0]));
        assert_eq!(slot_of([-1, 9, 3]), (3 * 8 + 1) * 8 + 7);
    }
}
