//! Occupancy and change cut to a tile; occupancy made smoother or coarser.

use super::block::Block;
use super::blocks::{Around, BlockMap, block_of, has, slots, steps_within, voxel_at};
use super::change::Change;
use super::class::Classes;
use super::grid::Grid;
use super::occupancy::Occupancy;
use crate::error::{Error, LatticeMismatch, Result};
use crate::geometry::Aabb;
use crate::{Grow, Interrupt, poll_now_and_then};

impl Change {
    /// The voxels whose centres lie in a box.
    pub fn clipped(&self, tile: &Aabb, interrupt: Interrupt) -> Result<Self> {
        let grid = clipped(&self.grid, tile)?;
        let span = grid.span();
        let mut out = Self { grid, blocks: BlockMap::default(), ..*self };
        for (round, (key, classes)) in self.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            let inside = span.of_block(*key);
            let part = Classes(classes.0.map(|plane| std::array::from_fn(|word| plane[word] & inside[word])));
            if part != Classes::default() {
                out.insert(*key, part, interrupt)?;
            }
        }
        Ok(out)
    }
}

/// A grid with the part of its tile that lies in a box.
fn clipped(grid: &Grid, tile: &Aabb) -> Result<Grid> {
    let own = &grid.tile;
    let min = [0, 1, 2].map(|i| own.min[i].max(tile.min[i]));
    let max = [0, 1, 2].map(|i| own.max[i].min(tile.max[i]).max(min[i]));
    let part = Grid::new(grid.voxel, Aabb { min, max }, grid.margin, grid.no_return_range)?;
    Ok(Grid { exact: grid.exact, ..part })
}

impl Occupancy {
    /// The voxels whose centres lie in a box.
    pub fn clipped(&self, tile: &Aabb, interrupt: Interrupt) -> Result<Self> {
        let mut out = self.empty_on(clipped(&self.grid, tile)?);
        for (round, (key, block)) in self.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            let inside = out.span.of_block(*key);
            let mut part = block.clone();
            (0..8).for_each(|word| part.traversed[word] &= inside[word]);
            if let Some(hits) = &mut part.hits {
                (0..512).filter(|&slot| !has(&inside, slot)).for_each(|slot| hits[slot] = 0);
            }
            if let Some(part) = part.tidied() {
                out.insert(*key, part, interrupt)?;
            }
        }
        Ok(out)
    }

    /// Without the returns of voxels that have fewer than `neighbours` occupied ones among the 26 around them: lone
    /// returns of rain, dust and mixed pixels. A voxel counts as occupied from `threshold` returns on.
    pub fn denoised(&self, neighbours: u32, threshold: u8, interrupt: Interrupt) -> Result<Self> {
        let mut occupied = BlockMap::default();
        occupied.grow(self.blocks.len(), interrupt)?;
        occupied.extend(self.blocks.iter().map(|(key, b)| (*key, b.occupied(threshold))));
        let steps: Vec<[i64; 3]> = steps_within(0.5).into_iter().filter(|s| *s != [0; 3]).collect();
        let mut out = self.empty_on(self.grid);
        for (round, (key, block)) in self.blocks.iter().enumerate() {
            poll_now_and_then(16 * round, interrupt)?;
            let mut block = block.clone();
            let around = Around::new(&occupied, *key);
            if let Some(hits) = &mut block.hits {
                for slot in slots(&self.blocks[key].occupied(1)) {
                    let there = steps.iter().filter(|&&step| around.has(slot, step)).count();
                    if (there as u32) < neighbours {
                        hits[slot] = 0;
                    }
                }
            }
            if let Some(block) = block.tidied() {
                out.insert(*key, block, interrupt)?;
            }
        }
        Ok(out)
    }

    /// On the lattice of voxels twice as large: returns are added up; a large voxel was passed where one of its eight was.
    /// A tile's border must lie on the larger lattice.
    pub fn downsampled(&self, interrupt: Interrupt) -> Result<Self> {
        if self.is_cut() {
            let (tile, voxel) = (self.grid.tile.to_text(), 2.0 * self.grid.voxel);
            return Err(Error::Lattice(LatticeMismatch::CutVoxels { tile, voxel }));
        }
        let grid = Grid {
            exact: self.grid.exact,
            ..Grid::new(2.0 * self.grid.voxel, self.grid.tile, self.grid.margin, self.grid.no_return_range)?
        };
        let mut out = self.empty_on(grid);
        for (round, (key, block)) in self.blocks.iter().enumerate() {
            poll_now_and_then(16 * round, interrupt)?;
            for slot in slots(&block.known()) {
                let voxel = voxel_at(*key, slot).map(|i| i.div_euclid(2));
                let (larger, place) = (out.block(block_of(voxel), interrupt)?, Block::slot(voxel));
                if block.is_traversed(slot) {
                    larger.traverse(place);
                }
                if block.count(slot) > 0 {
                    larger.hit(place, block.count(slot));
                }
            }
        }
        Ok(out)
    }

    /// Whether the tile ends between the two voxels of a larger one.
    fn is_cut(&self) -> bool {
        self.grid.is_bounded() && self.span.0.iter().flatten().any(|i| i.rem_euclid(2) != 0)
    }
}
