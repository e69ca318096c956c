//! What changed between two epochs, or between model and epoch: SQL's `ab_change`.

use super::class::ChangeClass;
use super::classes::Classes;
use super::judge::Judge;
use super::settings::ChangeSettings;
use crate::error::{Error, LatticeMismatch, Result};
use crate::geometry::Aabb;
use crate::voxel::lattice::bits::{common, slot_of, slots};
use crate::voxel::lattice::block_map::{block_of, voxel_at};
use crate::voxel::lattice::{BlockMap, Grid};
use crate::voxel::occupancy::Occupancy;
use crate::{Interrupt, poll_now_and_then};

/// Voxels of a tile that are occupied in at least one of two epochs, with what became of them.
#[derive(Debug, Clone, PartialEq)]
pub struct VoxelChange {
    pub(super) grid: Grid,
    pub(super) settings: ChangeSettings,
    /// Whether the older side is a drawn model.
    pub(super) against_model: bool,
    pub(super) blocks: BlockMap<Classes>,
}

impl VoxelChange {
    /// Compares the voxels that both tiles have. The older side may be a drawn model, the newer one too.
    pub fn between(old: &Occupancy, new: &Occupancy, settings: ChangeSettings, interrupt: Interrupt) -> Result<Self> {
        let (old_tile, new_tile) = (&old.grid().tile, &new.grid().tile);
        old.grid().same_lattice(new.grid())?;
        let span = old.span().common(new.span());
        let judge = Judge { sides: [old, new], settings, steps: settings.steps(old.grid().voxel)?, span };
        let mut grid = *new.grid();
        for axis in 0..3 {
            grid.tile.min[axis] = old_tile.min[axis].max(new_tile.min[axis]);
            grid.tile.max[axis] = old_tile.max[axis].min(new_tile.max[axis]).max(grid.tile.min[axis]);
        }
        let mut out = Self { grid, settings, against_model: old.is_model(), blocks: BlockMap::default() };
        if span.is_empty() {
            return Ok(out);
        }
        let only_new = new.keys().filter(|key| old.block(*key).is_none());
        for (round, key) in old.keys().chain(only_new).enumerate() {
            poll_now_and_then(if judge.steps.len() > 27 { 0 } else { 16 * round }, interrupt)?;
            let classes = judge.block(key);
            if classes != Classes::default() {
                out.blocks.insert(key, classes, interrupt)?;
            }
        }
        Ok(out)
    }

    /// The lattice, and the tile that both sides have.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// How it was compared.
    pub fn settings(&self) -> ChangeSettings {
        self.settings
    }

    /// SQL text of a class: against a model `unmodelled` and `absent` for `new` and `disappeared`.
    pub fn class_name(&self, class: ChangeClass) -> &'static str {
        match class {
            ChangeClass::New if self.against_model => "unmodelled",
            ChangeClass::Disappeared if self.against_model => "absent",
            _ => class.name(),
        }
    }

    /// ChangeClass of a voxel; `None` for one that is occupied in neither epoch.
    pub fn class(&self, voxel: [i64; 3]) -> Option<ChangeClass> {
        self.blocks.get(&block_of(voxel))?.get(slot_of(voxel))
    }

    /// Calls `visit(voxel, class)` for every voxel that is occupied in one of the epochs, in the order of blocks.
    pub fn for_each(&self, interrupt: Interrupt, mut visit: impl FnMut([i64; 3], ChangeClass)) -> Result<()> {
        for (round, (key, classes)) in self.blocks.in_order(interrupt, |classes| classes)?.into_iter().enumerate() {
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
            let mine = self.blocks.made(*key, interrupt)?;
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

    /// The voxels whose centres lie in a box.
    pub fn clipped(&self, tile: &Aabb, interrupt: Interrupt) -> Result<Self> {
        let grid = self.grid.clipped(tile)?;
        let span = grid.span();
        let mut out = Self { grid, blocks: BlockMap::default(), ..*self };
        for (round, (key, classes)) in self.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            let inside = span.of_block(*key);
            let part = Classes(classes.0.map(|plane| common(&plane, &inside)));
            if part != Classes::default() {
                out.blocks.insert(*key, part, interrupt)?;
            }
        }
        Ok(out)
    }
}
