//! What beams say of eight by eight by eight voxels.

use super::bits::{Bits, holds, put};
use super::state::VoxelState;

/// Returns and traversals of the voxels of a block, by their slots.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct VoxelBlock {
    /// Voxels that a beam passed through.
    pub traversed: Bits,
    /// Returns in each voxel, as many as 255; `None` where there is none.
    pub hits: Option<Box<[u8; 512]>>,
}

impl VoxelBlock {
    /// Adds returns.
    pub fn hit(&mut self, slot: usize, returns: u8) {
        let count = &mut self.hits.get_or_insert_with(|| Box::new([0; 512]))[slot];
        *count = count.saturating_add(returns);
    }

    /// Notes that a beam passed through.
    pub fn traverse(&mut self, slot: usize) {
        put(&mut self.traversed, slot);
    }

    /// Whether a beam passed through.
    pub fn is_traversed(&self, slot: usize) -> bool {
        holds(&self.traversed, slot)
    }

    /// Without counts that are all 0; `None` where nothing is left.
    pub fn tidied(mut self) -> Option<Self> {
        self.hits = self.hits.filter(|h| h.iter().any(|&n| n > 0));
        Some(self).filter(|b| *b != Self::default())
    }

    /// Returns in a voxel.
    pub fn count(&self, slot: usize) -> u8 {
        self.hits.as_ref().map_or(0, |h| h[slot])
    }

    /// Voxels with at least `threshold` returns.
    pub fn occupied(&self, threshold: u8) -> Bits {
        let Some(hits) = &self.hits else { return [0; 8] };
        std::array::from_fn(|word| {
            let counts = hits[64 * word..64 * word + 64].iter().enumerate();
            counts.fold(0, |bits, (i, &n)| bits | u64::from(n >= threshold.max(1)) << i)
        })
    }

    /// State of a voxel: occupied from `threshold` returns on.
    pub fn state(&self, slot: usize, threshold: u8) -> VoxelState {
        VoxelState::of(self.count(slot) >= threshold.max(1), self.is_traversed(slot))
    }

    /// Adds what another knows of the same place.
    pub fn add(&mut self, other: &Self) {
        self.traversed.iter_mut().zip(&other.traversed).for_each(|(a, b)| *a |= b);
        if let Some(theirs) = &other.hits {
            let mine = self.hits.get_or_insert_with(|| Box::new([0; 512]));
            mine.iter_mut().zip(theirs.iter()).for_each(|(a, b)| *a = a.saturating_add(*b));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_follow_the_threshold() {
        let (mut b, slot) = (VoxelBlock::default(), 207);
        assert_eq!(b.state(slot, 1), VoxelState::Unknown);
        b.hit(slot, 1);
        b.hit(slot, 1);
        assert_eq!((b.state(slot, 2), b.state(slot, 3)), (VoxelState::Occupied, VoxelState::Unknown));
        b.traverse(slot);
        assert_eq!((b.state(slot, 2), b.state(slot, 3)), (VoxelState::Ambiguous, VoxelState::Empty));
        (0..300).for_each(|_| b.hit(slot, 1));
        assert_eq!(b.count(slot), 255);
        let mut sum = b.clone();
        sum.add(&b);
        assert_eq!(sum, b);
    }
}
