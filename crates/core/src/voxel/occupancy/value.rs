//! What is known of a tile of space: SQL's `ab_occupancy`.

use super::known::{KnownAround, KnownBlock, KnownTile};
use crate::error::{Error, LatticeMismatch, Result};
use crate::geometry::Aabb;
use crate::scan::PatchHeader;
use crate::voxel::carve::{self, CarvedTile};
use crate::voxel::lattice::bits::{self, slot_of};
use crate::voxel::lattice::block_map::{block_of, voxel_at};
use crate::voxel::lattice::{BlockMap, Grid, VoxelBlock, VoxelBox, VoxelState};
use crate::voxel::model::VoxelSet;
use crate::{Interrupt, poll, poll_now_and_then};

/// What an epoch's beams say of a tile, or a model drawn in it. Mergeable, and the same whatever the order of patches.
#[derive(Debug, Clone, PartialEq)]
pub struct Occupancy {
    pub(super) grid: Grid,
    /// The voxels of the grid's tile.
    pub(super) span: VoxelBox,
    pub(super) known: KnownTile,
}

impl Occupancy {
    /// Nothing is known.
    pub fn new(grid: Grid) -> Self {
        Self { grid, span: grid.span(), known: KnownTile::Seen(BlockMap::default()) }
    }

    /// A drawn model that fills no voxel yet.
    pub fn of_model(grid: Grid) -> Self {
        Self { grid, span: grid.span(), known: KnownTile::Drawn(VoxelSet::default()) }
    }

    /// Whether it is a drawn model, of which everything is known.
    pub fn is_model(&self) -> bool {
        matches!(self.known, KnownTile::Drawn(_))
    }

    /// The lattice and the tile.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The voxels of the tile.
    pub(crate) fn span(&self) -> &VoxelBox {
        &self.span
    }

    /// State of a voxel.
    pub fn state(&self, voxel: [i64; 3], threshold: u8) -> VoxelState {
        let known = self.block(block_of(voxel)).map(|b| b.state(slot_of(voxel), threshold));
        let of_none = if self.is_model() && self.span.holds(voxel) { VoxelState::Empty } else { VoxelState::Unknown };
        known.filter(|&state| state != VoxelState::Unknown).unwrap_or(of_none)
    }

    /// What is known of a block.
    pub(crate) fn block(&self, key: [i32; 3]) -> Option<KnownBlock<'_>> {
        self.known.block(key)
    }

    /// What is known of a block and its neighbours.
    pub(crate) fn around(&self, key: [i32; 3]) -> KnownAround<'_> {
        self.known.around(key)
    }

    /// The numbers of the blocks of which something is known, in no order.
    pub(crate) fn keys(&self) -> impl Iterator<Item = [i32; 3]> {
        self.known.iter().map(|(key, _)| key)
    }

    /// The blocks of which something is known, in the order of their numbers.
    pub fn sorted(&self, interrupt: Interrupt) -> Result<Vec<([i32; 3], KnownBlock<'_>)>> {
        self.known.sorted(interrupt)
    }

    /// Calls `visit(voxel, state, returns)` for every voxel that is not unknown.
    pub fn for_each(
        &self,
        threshold: u8,
        interrupt: Interrupt,
        mut visit: impl FnMut([i64; 3], VoxelState, u8),
    ) -> Result<()> {
        for (round, (key, block)) in self.sorted(interrupt)?.into_iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            for slot in bits::slots(&block.known()) {
                let state = block.state(slot, threshold);
                if state != VoxelState::Unknown {
                    visit(voxel_at(key, slot), state, block.count(slot));
                }
            }
        }
        Ok(())
    }

    /// Whether a patch can say anything of the tile, by its header alone.
    pub fn concerns(&self, header: &PatchHeader) -> bool {
        carve::concerns(&self.grid, header)
    }

    /// Adds what a packed patch says: returns are counted, and what the beams pass on their way is empty.
    /// An error for a drawn model, of which everything is known.
    pub fn absorb(&mut self, patch: &[u8], interrupt: Interrupt) -> Result<()> {
        match &mut self.known {
            KnownTile::Seen(blocks) => {
                carve::absorb(&mut CarvedTile { grid: &self.grid, span: self.span, blocks }, patch, interrupt)
            }
            KnownTile::Drawn(_) => Err(two_kinds()),
        }
    }

    /// Adds another of the same lattice and rules; the tile grows to hold both.
    pub fn merge(&mut self, other: &Self, interrupt: Interrupt) -> Result<()> {
        self.grid.same_rules(&other.grid)?;
        match (&mut self.known, &other.known) {
            (KnownTile::Drawn(mine), KnownTile::Drawn(theirs)) => {
                if !join(&self.grid.tile, &other.grid.tile) {
                    let [a, b] = [&self.grid, &other.grid].map(|g| g.tile.to_text());
                    return Err(Error::Lattice(LatticeMismatch::TilesApart(a, b)));
                }
                mine.unite(theirs, interrupt)?;
            }
            (KnownTile::Seen(mine), KnownTile::Seen(theirs)) => add(mine, theirs, interrupt)?,
            _ => return Err(two_kinds()),
        }
        self.grid.tile = self.grid.tile.union(&other.grid.tile);
        self.span = self.grid.span();
        Ok(())
    }
}

impl VoxelSet {
    /// As an occupancy of which everything is known.
    pub fn into_model(self, grid: Grid, interrupt: Interrupt) -> Result<Occupancy> {
        poll(interrupt)?;
        Ok(Occupancy { known: KnownTile::Drawn(self), ..Occupancy::of_model(grid) })
    }
}

fn two_kinds() -> Error {
    Error::Lattice(LatticeMismatch::DrawnAndSeen)
}

/// Adds what beams saw elsewhere or from elsewhere.
fn add(mine: &mut BlockMap<VoxelBlock>, theirs: &BlockMap<VoxelBlock>, interrupt: Interrupt) -> Result<()> {
    for (round, (key, block)) in theirs.iter().enumerate() {
        poll_now_and_then(round, interrupt)?;
        match mine.get_mut(key) {
            Some(own) => own.add(block),
            None => mine.insert(*key, block.clone(), interrupt)?,
        }
    }
    Ok(())
}

/// Whether the box around two tiles holds nothing beside them.
fn join(a: &Aabb, b: &Aabb) -> bool {
    let alike = (0..3).filter(|&i| a.min[i] == b.min[i] && a.max[i] == b.max[i]).count();
    a.contains(b) || b.contains(a) || alike >= 2 && a.overlaps(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::geometry::Vec3;
    use crate::scan::{Beam, Patch};

    #[test]
    fn what_does_not_belong_together() {
        let tile = |a: f64, b: f64| Grid::new(0.1, Aabb { min: [a, 0.0, 0.0], max: [b, 1.0, 1.0] }, 0.0, 0.0).unwrap();
        let (mut model, mut seen) = (Occupancy::of_model(tile(0.0, 1.0)), Occupancy::new(tile(0.0, 1.0)));
        assert!(model.merge(&seen, NEVER).is_err() && seen.merge(&model, NEVER).is_err());
        assert!(model.merge(&Occupancy::of_model(tile(2.0, 3.0)), NEVER).is_err(), "a gap");
        model.merge(&Occupancy::of_model(tile(1.0, 2.0)), NEVER).unwrap();
        assert_eq!(model.grid().tile, tile(0.0, 2.0).tile);
        assert_eq!([15, 25].map(|x| model.state([x, 0, 0], 1)), [VoxelState::Empty, VoxelState::Unknown]);
        let beam = Beam { offset: Vec3::new(1.5, 0.5, 0.5), returned: true };
        let patch = Patch::encode(1, Vec3::zeros(), 0.01, 1e-4, &[beam]).unwrap().to_bytes();
        assert!(model.absorb(&patch, NEVER).is_err() && seen.absorb(&patch, NEVER).is_ok());
    }
}
