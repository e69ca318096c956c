//! What an epoch's beams say of a tile of space: SQL's `ab_occupancy`.

use super::block::{Block, State};
use super::blocks::{Bits, BlockMap, block_of, in_order, slots, voxel_at};
use super::grid::{Grid, Span};
use crate::error::{Error, LatticeMismatch, Result};
use crate::geometry::Aabb;
use crate::{Grow, Interrupt, poll_now_and_then};

/// Blocks of a tile of which something is known. Mergeable, and the same whatever the order of patches.
#[derive(Debug, Clone, PartialEq)]
pub struct Occupancy {
    pub(super) grid: Grid,
    /// The voxels of the grid's tile.
    pub(super) span: Span,
    /// A drawn model: what it does not hold is empty, everywhere in the tile.
    pub(super) model: bool,
    pub(super) blocks: BlockMap<Block>,
}

impl Occupancy {
    /// Nothing is known.
    pub fn new(grid: Grid) -> Self {
        Self { grid, span: grid.span(), model: false, blocks: BlockMap::default() }
    }

    /// A drawn model that fills no voxel yet.
    pub fn of_model(grid: Grid) -> Self {
        Self { model: true, ..Self::new(grid) }
    }

    /// Whether it is a drawn model, of which everything is known.
    pub fn is_model(&self) -> bool {
        self.model
    }

    /// The lattice and the tile.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// State of a voxel.
    pub fn state(&self, voxel: [i64; 3], threshold: u8) -> State {
        let known = self.blocks.get(&block_of(voxel)).map(|b| b.state(Block::slot(voxel), threshold));
        let of_none = if self.model && self.span.holds(voxel) { State::Empty } else { State::Unknown };
        known.filter(|&state| state != State::Unknown).unwrap_or(of_none)
    }

    /// The blocks of which something is known, in the order of their numbers.
    pub fn sorted(&self, interrupt: Interrupt) -> Result<Vec<([i32; 3], &Block)>> {
        in_order(&self.blocks, interrupt)
    }

    /// Calls `visit(voxel, state, returns)` for every voxel that is not unknown.
    pub fn for_each(
        &self,
        threshold: u8,
        interrupt: Interrupt,
        mut visit: impl FnMut([i64; 3], State, u8),
    ) -> Result<()> {
        for (round, (key, block)) in self.sorted(interrupt)?.into_iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            for slot in slots(&block.known()) {
                let state = block.state(slot, threshold);
                if state != State::Unknown {
                    visit(voxel_at(key, slot), state, block.count(slot));
                }
            }
        }
        Ok(())
    }

    /// Adds another of the same lattice and rules; the tile grows to hold both.
    pub fn merge(&mut self, other: &Self, interrupt: Interrupt) -> Result<()> {
        self.grid.same_rules(&other.grid)?;
        if self.model != other.model {
            return Err(Error::Lattice(LatticeMismatch::DrawnAndSeen));
        }
        if self.model && !join(&self.grid.tile, &other.grid.tile) {
            return Err(Error::Lattice(LatticeMismatch::TilesApart(
                self.grid.tile.to_text(),
                other.grid.tile.to_text(),
            )));
        }
        self.grid.tile = self.grid.tile.union(&other.grid.tile);
        self.span = self.grid.span();
        for (round, (key, theirs)) in other.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            match self.blocks.get_mut(key) {
                Some(mine) => mine.add(theirs),
                None => self.insert(*key, theirs.clone(), interrupt)?,
            }
        }
        Ok(())
    }

    /// Puts a block that is not there yet.
    pub(super) fn insert(&mut self, key: [i32; 3], block: Block, interrupt: Interrupt) -> Result<()> {
        self.blocks.grow(1, interrupt)?;
        self.blocks.insert(key, block);
        Ok(())
    }

    /// Nothing is known yet, on another grid.
    pub(super) fn empty_on(&self, grid: Grid) -> Self {
        Self { model: self.model, ..Self::new(grid) }
    }

    /// The block numbered `key`, made where it is missing.
    pub(super) fn block(&mut self, key: [i32; 3], interrupt: Interrupt) -> Result<&mut Block> {
        self.blocks.grow(1, interrupt)?;
        Ok(self.blocks.entry(key).or_default())
    }

    /// Notes voxels of a block as traversed, as far as they belong to the tile.
    pub(super) fn traverse_block(&mut self, key: [i32; 3], bits: &Bits, interrupt: Interrupt) -> Result<()> {
        let inside = self.span.of_block(key);
        let masked: Bits = std::array::from_fn(|z| bits[z] & inside[z]);
        if masked.iter().any(|&w| w != 0) {
            let block = self.block(key, interrupt)?;
            block.traversed.iter_mut().zip(masked).for_each(|(a, b)| *a |= b);
        }
        Ok(())
    }
}

/// Whether the box around two tiles holds nothing beside them.
fn join(a: &Aabb, b: &Aabb) -> bool {
    let alike = (0..3).filter(|&i| a.min[i] == b.min[i] && a.max[i] == b.max[i]).count();
    a.contains(b) || b.contains(a) || alike >= 2 && a.overlaps(b)
}
