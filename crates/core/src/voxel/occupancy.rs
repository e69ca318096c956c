//! What an epoch's beams say of a tile of space: SQL's `ab_occupancy`.

use std::collections::HashMap;

use super::block::{Block, EDGE, State};
use super::grid::{Grid, Span};
use crate::error::{Error, Result};
use crate::{Interrupt, poll_now_and_then};

/// Bytes that a block takes in memory with its counts, about.
const BLOCK_BYTES: usize = 112;
const COUNTS_BYTES: usize = 528;

/// Blocks of a tile of which something is known. Mergeable, and the same whatever the order of patches.
#[derive(Debug, Clone, PartialEq)]
pub struct Occupancy {
    pub(super) grid: Grid,
    /// The voxels of the grid's tile.
    pub(super) span: Span,
    pub(super) blocks: HashMap<[i32; 3], Block>,
    /// Blocks with counts.
    counted: usize,
}

impl Occupancy {
    /// Nothing is known.
    pub fn new(grid: Grid) -> Self {
        Self { grid, span: grid.span(), blocks: HashMap::new(), counted: 0 }
    }

    /// The lattice and the tile.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Number of the block that holds a voxel.
    pub fn block_of(voxel: [i64; 3]) -> [i32; 3] {
        voxel.map(|i| i.div_euclid(EDGE) as i32)
    }

    /// State of a voxel.
    pub fn state(&self, voxel: [i64; 3], threshold: u8) -> State {
        let block = self.blocks.get(&Self::block_of(voxel));
        block.map_or(State::Unknown, |b| b.state(Block::slot(voxel), threshold))
    }

    /// The blocks of which something is known, in the order of their numbers.
    pub fn sorted(&self) -> Vec<([i32; 3], &Block)> {
        let mut all: Vec<_> = self.blocks.iter().map(|(key, block)| (*key, block)).collect();
        all.sort_unstable_by_key(|(key, _)| *key);
        all
    }

    /// Calls `visit(voxel, state, returns)` for every voxel that is not unknown.
    pub fn for_each(
        &self,
        threshold: u8,
        interrupt: Interrupt,
        mut visit: impl FnMut([i64; 3], State, u8),
    ) -> Result<()> {
        for (round, (key, block)) in self.sorted().into_iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            for slot in 0..512 {
                let state = block.state(slot, threshold);
                if state != State::Unknown {
                    let within = [slot % 8, slot / 8 % 8, slot / 64];
                    let voxel = [0, 1, 2].map(|i| i64::from(key[i]) * EDGE + within[i] as i64);
                    visit(voxel, state, block.count(slot));
                }
            }
        }
        Ok(())
    }

    /// Adds another of the same lattice and tile.
    pub fn merge(&mut self, other: &Self, interrupt: Interrupt) -> Result<()> {
        if self.grid != other.grid {
            return Err(Error::Mismatch { reason: "their grids differ".into() });
        }
        for (round, (key, theirs)) in other.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            match self.blocks.get_mut(key) {
                Some(mine) => {
                    self.counted += usize::from(mine.hits.is_none() && theirs.hits.is_some());
                    mine.add(theirs);
                }
                None => self.insert(*key, theirs.clone()),
            }
        }
        Ok(())
    }

    /// Bytes in memory, about.
    pub fn memory(&self) -> usize {
        self.blocks.len() * BLOCK_BYTES + self.counted * COUNTS_BYTES
    }

    /// Fails where more than `most` bytes are in memory.
    pub fn check_memory(&self, most: usize) -> Result<()> {
        if self.memory() <= most {
            return Ok(());
        }
        let mib = |bytes: usize| format!("{} MiB", bytes >> 20);
        Err(Error::Limit { what: "the memory of a voxel grid", value: mib(self.memory()), limit: mib(most) })
    }

    /// Puts a block that is not there yet.
    pub(super) fn insert(&mut self, key: [i32; 3], block: Block) {
        self.counted += usize::from(block.hits.is_some());
        if self.blocks.insert(key, block).is_some_and(|old| old.hits.is_some()) {
            self.counted -= 1;
        }
    }

    pub(super) fn hit(&mut self, voxel: [i64; 3]) {
        let block = self.blocks.entry(Self::block_of(voxel)).or_default();
        self.counted += usize::from(block.hits.is_none());
        block.hit(Block::slot(voxel));
    }

    pub(super) fn traverse(&mut self, voxel: [i64; 3]) {
        self.blocks.entry(Self::block_of(voxel)).or_default().traverse(Block::slot(voxel));
    }
}
