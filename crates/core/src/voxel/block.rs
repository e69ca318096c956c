//! Eight by eight by eight voxels.

use super::blocks::{Bits, has, put};
use crate::error::{Error, Result};

/// Voxels along an edge of a block.
pub const EDGE: i64 = 8;

/// What is known of a voxel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// At least as many returns as the threshold.
    Occupied,
    /// The same, but beams passed through as well: grazed surfaces, voxels that a surface shares with space before it.
    Ambiguous,
    /// Beams passed through, and too few returned.
    Empty,
    /// Nobody looked.
    Unknown,
}

impl State {
    /// SQL text: `occupied`, `ambiguous`, `empty`, `unknown`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Occupied => "occupied",
            Self::Ambiguous => "ambiguous",
            Self::Empty => "empty",
            Self::Unknown => "unknown",
        }
    }

    /// Reads [`State::name`].
    pub fn parse(text: &str) -> Result<Self> {
        [Self::Occupied, Self::Ambiguous, Self::Empty, Self::Unknown]
            .into_iter()
            .find(|s| s.name() == text)
            .ok_or_else(|| Error::argument("a state", "occupied, ambiguous, empty or unknown", text))
    }

    /// Whether something is there.
    pub fn is_occupied(self) -> bool {
        matches!(self, Self::Occupied | Self::Ambiguous)
    }
}

/// Returns and traversals of the voxels of a block. A voxel is bit x of byte y of word z, and counts are in that order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Block {
    /// Voxels that a beam passed through.
    pub traversed: Bits,
    /// Returns in each voxel, as many as 255; `None` where there is none.
    pub hits: Option<Box<[u8; 512]>>,
}

impl Block {
    /// Number of a voxel in its block.
    pub fn slot(voxel: [i64; 3]) -> usize {
        let [x, y, z] = voxel.map(|i| i.rem_euclid(EDGE) as usize);
        (z * 8 + y) * 8 + x
    }

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
        has(&self.traversed, slot)
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

    /// Voxels with a return or a traversal.
    pub fn known(&self) -> Bits {
        let hit = self.occupied(1);
        std::array::from_fn(|word| self.traversed[word] | hit[word])
    }

    /// State of a voxel: occupied from `threshold` returns on.
    pub fn state(&self, slot: usize, threshold: u8) -> State {
        match (self.count(slot) >= threshold.max(1), self.is_traversed(slot)) {
            (true, false) => State::Occupied,
            (true, true) => State::Ambiguous,
            (false, true) => State::Empty,
            (false, false) => State::Unknown,
        }
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
        let mut b = Block::default();
        let slot = Block::slot([-1, 9, 3]);
        assert_eq!(slot, (3 * 8 + 1) * 8 + 7);
        assert_eq!(b.state(slot, 1), State::Unknown);
        b.hit(slot, 1);
        b.hit(slot, 1);
        assert_eq!((b.state(slot, 2), b.state(slot, 3)), (State::Occupied, State::Unknown));
        b.traverse(slot);
        assert_eq!((b.state(slot, 2), b.state(slot, 3)), (State::Ambiguous, State::Empty));
        (0..300).for_each(|_| b.hit(slot, 1));
        assert_eq!(b.count(slot), 255);
        let mut sum = b.clone();
        sum.add(&b);
        assert_eq!(sum, b);
    }
}
