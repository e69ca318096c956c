//! Occupancy cut to a tile, made smoother or coarser.

use super::known::KnownTile;
use super::value::Occupancy;
use crate::error::{Error, LatticeMismatch, Result};
use crate::geometry::Aabb;
use crate::voxel::lattice::bits::{holds, slot_of, slots};
use crate::voxel::lattice::block_map::{block_of, voxel_at};
use crate::voxel::lattice::{Around, Bits, BlockMap, Grid, VoxelBlock, VoxelBox, steps_within};
use crate::voxel::model::VoxelSet;
use crate::{Interrupt, poll_now_and_then};

impl Occupancy {
    /// The voxels whose centres lie in a box.
    pub fn clipped(&self, tile: &Aabb, interrupt: Interrupt) -> Result<Self> {
        let grid = self.grid.clipped(tile)?;
        let span = grid.span();
        let known = match &self.known {
            KnownTile::Seen(blocks) => KnownTile::Seen(clipped(blocks, &span, interrupt)?),
            KnownTile::Drawn(set) => KnownTile::Drawn(set.within(&span, interrupt)?),
        };
        Ok(Self { grid, span, known })
    }

    /// Without the returns of voxels that have fewer than `neighbours` occupied ones among the 26 around them: lone
    /// returns of rain, dust and mixed pixels. A voxel counts as occupied from `threshold` returns on.
    pub fn denoised(&self, neighbours: u32, threshold: u8, interrupt: Interrupt) -> Result<Self> {
        let steps: Vec<[i64; 3]> = steps_within(0.5).into_iter().filter(|s| *s != [0; 3]).collect();
        let has_enough = |around: &Around<Bits>, slot: usize| {
            steps.iter().filter(|&&step| around.holds(slot, step)).count() as u32 >= neighbours
        };
        let known = match &self.known {
            KnownTile::Seen(blocks) => KnownTile::Seen(denoised(blocks, threshold, interrupt, has_enough)?),
            KnownTile::Drawn(set) => KnownTile::Drawn(set.filtered(interrupt, has_enough)?),
        };
        Ok(Self { known, ..*self })
    }

    /// On the lattice of voxels twice as large: returns are added up; a large voxel was passed where one of its eight
    /// was. A tile's border must lie on the larger lattice.
    pub fn downsampled(&self, interrupt: Interrupt) -> Result<Self> {
        if self.is_cut() {
            let (tile, voxel) = (self.grid.tile.to_text(), 2.0 * self.grid.voxel);
            return Err(Error::Lattice(LatticeMismatch::CutVoxels { tile, voxel }));
        }
        let grid = Grid {
            exact: self.grid.exact,
            ..Grid::new(2.0 * self.grid.voxel, self.grid.tile, self.grid.margin, self.grid.no_return_range)?
        };
        let known = match &self.known {
            KnownTile::Seen(blocks) => KnownTile::Seen(downsampled(blocks, interrupt)?),
            KnownTile::Drawn(set) => KnownTile::Drawn(downsampled_set(set, interrupt)?),
        };
        Ok(Self { grid, span: grid.span(), known })
    }

    /// Whether the tile ends between the two voxels of a larger one.
    fn is_cut(&self) -> bool {
        self.grid.is_bounded() && self.span.0.iter().flatten().any(|i| i.rem_euclid(2) != 0)
    }
}

fn clipped(blocks: &BlockMap<VoxelBlock>, span: &VoxelBox, interrupt: Interrupt) -> Result<BlockMap<VoxelBlock>> {
    let mut out = BlockMap::default();
    for (round, (key, block)) in blocks.iter().enumerate() {
        poll_now_and_then(round, interrupt)?;
        let inside = span.of_block(*key);
        let mut part = block.clone();
        (0..8).for_each(|word| part.traversed[word] &= inside[word]);
        if let Some(hits) = &mut part.hits {
            (0..512).filter(|&slot| !holds(&inside, slot)).for_each(|slot| hits[slot] = 0);
        }
        if let Some(part) = part.tidied() {
            out.insert(*key, part, interrupt)?;
        }
    }
    Ok(out)
}

fn denoised(
    blocks: &BlockMap<VoxelBlock>,
    threshold: u8,
    interrupt: Interrupt,
    has_enough: impl Fn(&Around<Bits>, usize) -> bool,
) -> Result<BlockMap<VoxelBlock>> {
    let mut occupied = BlockMap::default();
    for (round, (key, block)) in blocks.iter().enumerate() {
        poll_now_and_then(round, interrupt)?;
        occupied.insert(*key, block.occupied(threshold), interrupt)?;
    }
    let mut out = BlockMap::default();
    for (round, (key, block)) in blocks.iter().enumerate() {
        poll_now_and_then(16 * round, interrupt)?;
        let mut kept = block.clone();
        let around = Around::new(&occupied, *key);
        if let Some(hits) = &mut kept.hits {
            let returns = block.occupied(1);
            slots(&returns).filter(|&slot| !has_enough(&around, slot)).for_each(|slot| hits[slot] = 0);
        }
        if let Some(kept) = kept.tidied() {
            out.insert(*key, kept, interrupt)?;
        }
    }
    Ok(out)
}

/// The voxel of twice the size that holds a voxel.
fn larger(key: [i32; 3], slot: usize) -> [i64; 3] {
    voxel_at(key, slot).map(|i| i.div_euclid(2))
}

fn downsampled(blocks: &BlockMap<VoxelBlock>, interrupt: Interrupt) -> Result<BlockMap<VoxelBlock>> {
    let mut out = BlockMap::default();
    for (round, (key, block)) in blocks.iter().enumerate() {
        poll_now_and_then(16 * round, interrupt)?;
        for slot in 0..512 {
            let (returns, is_traversed) = (block.count(slot), block.is_traversed(slot));
            if returns == 0 && !is_traversed {
                continue;
            }
            let voxel = larger(*key, slot);
            let whole: &mut VoxelBlock = out.made(block_of(voxel), interrupt)?;
            if is_traversed {
                whole.traverse(slot_of(voxel));
            }
            if returns > 0 {
                whole.hit(slot_of(voxel), returns);
            }
        }
    }
    Ok(out)
}

fn downsampled_set(set: &VoxelSet, interrupt: Interrupt) -> Result<VoxelSet> {
    let mut out = VoxelSet::default();
    for (round, (key, filled)) in set.blocks().iter().enumerate() {
        poll_now_and_then(16 * round, interrupt)?;
        for slot in slots(filled) {
            out.insert(larger(*key, slot), interrupt)?;
        }
    }
    Ok(out)
}
