//! The blocks of a tile, whether beams saw them or a model was drawn.

use crate::voxel::lattice::bits::{self, Bits};
use crate::voxel::lattice::{Around, BlockMap, VoxelBlock, VoxelState};
use crate::voxel::model::VoxelSet;
use crate::{Interrupt, Result};

/// Returns that a voxel of a drawn model counts for: enough for every threshold.
pub const DRAWN: u8 = u8::MAX;

/// What is known of a tile, block by block.
#[derive(Debug, Clone, PartialEq)]
pub enum KnownTile {
    /// What beams saw: of the rest nothing is known.
    Seen(BlockMap<VoxelBlock>),
    /// A drawn model: what it does not fill is empty, everywhere in the tile.
    Drawn(VoxelSet),
}

impl KnownTile {
    /// A block, where something is known of it.
    pub fn block(&self, key: [i32; 3]) -> Option<KnownBlock<'_>> {
        match self {
            Self::Seen(blocks) => blocks.get(&key).map(KnownBlock::Seen),
            Self::Drawn(set) => set.blocks().get(&key).map(KnownBlock::Drawn),
        }
    }

    /// All blocks, in no order.
    pub fn iter(&self) -> impl Iterator<Item = ([i32; 3], KnownBlock<'_>)> {
        let (seen, drawn) = match self {
            Self::Seen(blocks) => (Some(blocks), None),
            Self::Drawn(set) => (None, Some(set.blocks())),
        };
        let seen = seen.into_iter().flat_map(BlockMap::iter).map(|(key, block)| (*key, KnownBlock::Seen(block)));
        seen.chain(drawn.into_iter().flat_map(BlockMap::iter).map(|(key, bits)| (*key, KnownBlock::Drawn(bits))))
    }

    /// All blocks, in the order of their numbers.
    pub fn sorted(&self, interrupt: Interrupt) -> Result<Vec<([i32; 3], KnownBlock<'_>)>> {
        match self {
            Self::Seen(blocks) => blocks.in_order(interrupt, KnownBlock::Seen),
            Self::Drawn(set) => set.blocks().in_order(interrupt, KnownBlock::Drawn),
        }
    }

    /// A block and its neighbours.
    pub fn around(&self, key: [i32; 3]) -> KnownAround<'_> {
        match self {
            Self::Seen(blocks) => KnownAround::Seen(Around::new(blocks, key)),
            Self::Drawn(set) => KnownAround::Drawn(Around::new(set.blocks(), key)),
        }
    }
}

/// What is known of a block.
#[derive(Debug, Clone, Copy)]
pub enum KnownBlock<'a> {
    /// Returns and traversals.
    Seen(&'a VoxelBlock),
    /// The voxels that a model fills.
    Drawn(&'a Bits),
}

impl KnownBlock<'_> {
    /// Returns in a voxel.
    pub fn count(&self, slot: usize) -> u8 {
        match self {
            Self::Seen(block) => block.count(slot),
            Self::Drawn(filled) => {
                if bits::holds(filled, slot) {
                    DRAWN
                } else {
                    0
                }
            }
        }
    }

    /// Voxels with at least `threshold` returns.
    pub fn occupied(&self, threshold: u8) -> Bits {
        match self {
            Self::Seen(block) => block.occupied(threshold),
            Self::Drawn(filled) => **filled,
        }
    }

    /// Voxels that a beam passed through.
    pub fn traversed(&self) -> Bits {
        match self {
            Self::Seen(block) => block.traversed,
            Self::Drawn(_) => [0; 8],
        }
    }

    /// Whether a beam passed through a voxel.
    pub fn is_traversed(&self, slot: usize) -> bool {
        match self {
            Self::Seen(block) => block.is_traversed(slot),
            Self::Drawn(_) => false,
        }
    }

    /// Voxels with a return or a traversal.
    pub fn known(&self) -> Bits {
        let (occupied, traversed) = (self.occupied(1), self.traversed());
        std::array::from_fn(|word| traversed[word] | occupied[word])
    }

    /// State of a voxel by itself: occupied from `threshold` returns on.
    pub fn state(&self, slot: usize, threshold: u8) -> VoxelState {
        VoxelState::of(self.count(slot) >= threshold.max(1), self.is_traversed(slot))
    }
}

/// A block and its neighbours.
pub enum KnownAround<'a> {
    /// What beams saw.
    Seen(Around<'a, VoxelBlock>),
    /// A drawn model.
    Drawn(Around<'a, Bits>),
}

impl KnownAround<'_> {
    /// Returns in the voxel `step` away.
    pub fn count(&self, slot: usize, step: [i64; 3]) -> u8 {
        match self {
            Self::Seen(around) => {
                let (block, slot) = around.at(slot, step);
                block.map_or(0, |b| b.count(slot))
            }
            Self::Drawn(around) => {
                if around.holds(slot, step) {
                    DRAWN
                } else {
                    0
                }
            }
        }
    }
}
