//! What changed between two epochs, or between model and epoch: SQL's `ab_change`.

use super::block::Block;
use super::blocks::{Around, Bits, BlockMap, in_order, slots, steps_within, voxel_at};
use super::class::{Class, Classes, one_sided};
use super::grid::{Grid, Span};
use super::occupancy::Occupancy;
use crate::error::{Error, LatticeMismatch, Result};
use crate::{Grow, Interrupt, poll_now_and_then};

/// Voxels of a tile that are occupied in at least one of two epochs, with what became of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    pub(super) grid: Grid,
    pub(super) settings: Settings,
    /// Whether the older side is a drawn model.
    pub(super) against_model: bool,
    pub(super) blocks: BlockMap<Classes>,
}

/// How two epochs are compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Returns from which a voxel is occupied, 1 to 255.
    pub threshold: u8,
    /// A voxel counts as changed only if the other epoch has nothing occupied within this gap, metres; 0 compares voxel by
    /// voxel, as published.
    pub tolerance: f64,
}

impl Settings {
    /// Checks a threshold from SQL.
    pub fn threshold(n: i32) -> Result<u8> {
        let checked = u8::try_from(n).ok().filter(|&n| n > 0);
        checked.ok_or_else(|| Error::argument("the threshold", "from 1 to 255 returns", n))
    }

    /// The steps to the voxels within the tolerance; none for 0.
    fn steps(&self, voxel: f64) -> Result<Vec<[i64; 3]>> {
        if !(0.0..=8.0 * voxel).contains(&self.tolerance) {
            return Err(Error::argument("the tolerance", "from 0 to 8 voxels", format!("{} m", self.tolerance)));
        }
        Ok(if self.tolerance > 0.0 { steps_within(self.tolerance / voxel) } else { Vec::new() })
    }
}

impl Change {
    /// Compares the voxels that both tiles have. The older side may be a drawn model, the newer one too.
    pub fn between(old: &Occupancy, new: &Occupancy, settings: Settings, interrupt: Interrupt) -> Result<Self> {
        old.grid.same_lattice(&new.grid)?;
        let span = old.span.common(&new.span);
        let judge = Judge { sides: [old, new], settings, steps: settings.steps(old.grid.voxel)?, span };
        let mut grid = new.grid;
        for axis in 0..3 {
            grid.tile.min[axis] = old.grid.tile.min[axis].max(new.grid.tile.min[axis]);
            grid.tile.max[axis] = old.grid.tile.max[axis].min(new.grid.tile.max[axis]).max(grid.tile.min[axis]);
        }
        let mut out = Self { grid, settings, against_model: old.model, blocks: BlockMap::default() };
        if span.is_empty() {
            return Ok(out);
        }
        let only_new = new.blocks.keys().filter(|key| !old.blocks.contains_key(*key));
        for (round, &key) in old.blocks.keys().chain(only_new).enumerate() {
            poll_now_and_then(if judge.steps.len() > 27 { 0 } else { 16 * round }, interrupt)?;
            let classes = judge.block(key);
            if classes != Classes::default() {
                out.insert(key, classes, interrupt)?;
            }
        }
        Ok(out)
    }

    /// The lattice, and the tile that both sides have.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// How it was compared.
    pub fn settings(&self) -> Settings {
        self.settings
    }

    /// SQL text of a class: against a model `unmodelled` and `absent` for `new` and `disappeared`.
    pub fn class_name(&self, class: Class) -> &'static str {
        match class {
            Class::New if self.against_model => "unmodelled",
            Class::Disappeared if self.against_model => "absent",
            _ => class.name(),
        }
    }

    /// Class of a voxel; `None` for one that is occupied in neither epoch.
    pub fn class(&self, voxel: [i64; 3]) -> Option<Class> {
        self.blocks.get(&super::blocks::block_of(voxel))?.get(Block::slot(voxel))
    }

    /// Calls `visit(voxel, class)` for every voxel that is occupied in one of the epochs, in the order of blocks.
    pub fn for_each(&self, interrupt: Interrupt, mut visit: impl FnMut([i64; 3], Class)) -> Result<()> {
        for (round, (key, classes)) in in_order(&self.blocks, interrupt)?.into_iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            for slot in slots(&classes.any()) {
                if let Some(class) = classes.get(slot) {
                    visit(voxel_at(key, slot), class);
                }
            }
        }
        Ok(())
    }

    /// Adds the change of another tile, compared alike; tiles that share voxels are refused.
    pub fn merge(&mut self, other: &Self, interrupt: Interrupt) -> Result<()> {
        self.grid.same_lattice(&other.grid)?;
        if (self.settings, self.against_model) != (other.settings, other.against_model) {
            return Err(Error::Lattice(LatticeMismatch::ChangeSettings));
        }
        for (round, (key, theirs)) in other.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            self.blocks.grow(1, interrupt)?;
            let mine = self.blocks.entry(*key).or_default();
            if mine.any().iter().zip(theirs.any()).any(|(a, b)| a & b != 0) {
                return Err(Error::Lattice(LatticeMismatch::SharedVoxels));
            }
            for (a, b) in mine.0.iter_mut().flatten().zip(theirs.0.iter().flatten()) {
                *a |= b;
            }
        }
        self.grid.tile = self.grid.tile.union(&other.grid.tile);
        Ok(())
    }

    /// Puts a block that is not there yet.
    pub(super) fn insert(&mut self, key: [i32; 3], classes: Classes, interrupt: Interrupt) -> Result<()> {
        self.blocks.grow(1, interrupt)?;
        self.blocks.insert(key, classes);
        Ok(())
    }
}

/// Compares block by block.
struct Judge<'a> {
    /// Old and new.
    sides: [&'a Occupancy; 2],
    settings: Settings,
    steps: Vec<[i64; 3]>,
    span: Span,
}

impl Judge<'_> {
    fn block(&self, key: [i32; 3]) -> Classes {
        let own = self.sides.map(|side| side.blocks.get(&key));
        let inside = self.span.of_block(key);
        let occupied = own.map(|block| block.map_or([0; 8], |b| b.occupied(self.settings.threshold)));
        let only = |side: usize| -> Bits {
            std::array::from_fn(|word| occupied[side][word] & !occupied[1 - side][word] & inside[word])
        };
        let mut out = Classes::default();
        for word in 0..8 {
            out.0[0][word] = occupied[0][word] & occupied[1][word] & inside[word];
        }
        for side in 0..2 {
            let alone = only(side);
            if alone != [0; 8] {
                self.judge_alone(key, side, &alone, &mut out);
            }
        }
        out
    }

    /// Voxels that are occupied on one side alone.
    fn judge_alone(&self, key: [i32; 3], side: usize, alone: &Bits, out: &mut Classes) {
        let other = self.sides[1 - side];
        let block = other.blocks.get(&key);
        let around = (!self.steps.is_empty()).then(|| Around::new(&other.blocks, key));
        for slot in slots(alone) {
            let near = around.as_ref().map(|a| self.most_near(a, slot));
            let seen_empty = other.model || block.is_some_and(|b| b.is_traversed(slot));
            out.set(slot, one_sided(side == 1, seen_empty, near, self.settings.threshold));
        }
    }

    /// The most returns of a voxel within the tolerance; as many as the threshold suffice.
    fn most_near(&self, around: &Around<Block>, slot: usize) -> u8 {
        let mut most = 0;
        for &step in &self.steps {
            let (block, slot) = around.at(slot, step);
            most = most.max(block.map_or(0, |b| b.count(slot)));
            if most >= self.settings.threshold {
                break;
            }
        }
        most
    }
}
