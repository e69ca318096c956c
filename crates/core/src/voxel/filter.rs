//! Occupancy made smoother or coarser.

use super::block::Block;
use super::blocks::{Around, BlockMap, slots, steps_within, voxel_at};
use super::grid::Grid;
use super::occupancy::Occupancy;
use crate::error::{Error, Result};
use crate::{Interrupt, poll_now_and_then};

impl Occupancy {
    /// Without the returns of voxels that have fewer than `neighbours` occupied ones among the 26 around them: lone
    /// returns of rain, dust and mixed pixels. A voxel counts as occupied from `threshold` returns on.
    pub fn denoised(&self, neighbours: u32, threshold: u8, interrupt: Interrupt) -> Result<Self> {
        let occupied: BlockMap<_> = self.blocks.iter().map(|(key, b)| (*key, b.occupied(threshold))).collect();
        let steps: Vec<[i64; 3]> = steps_within(0.5).into_iter().filter(|s| *s != [0; 3]).collect();
        let mut out = self.empty_on(self.grid);
        for (round, (key, block)) in self.blocks.iter().enumerate() {
            poll_now_and_then(16 * round, interrupt)?;
            let mut block = block.clone();
            let around = Around::new(&occupied, *key);
            if let Some(hits) = &mut block.hits {
                for slot in slots(&self.blocks[key].occupied(1)) {
                    let there = |&&step: &&[i64; 3]| {
                        let (bits, slot) = around.at(slot, step);
                        bits.is_some_and(|b| b[slot / 64] >> (slot % 64) & 1 == 1)
                    };
                    if (steps.iter().filter(there).count() as u32) < neighbours {
                        hits[slot] = 0;
                    }
                }
            }
            block.hits = block.hits.filter(|h| h.iter().any(|&n| n > 0));
            if block != Block::default() {
                out.insert(*key, block);
            }
        }
        Ok(out)
    }

    /// On the lattice of voxels twice as large: returns are added up; a large voxel was passed where one of its eight was.
    /// A tile's border must lie on the larger lattice.
    pub fn downsampled(&self, interrupt: Interrupt) -> Result<Self> {
        if self.is_cut() {
            let reason = format!("the tile {} cuts voxels of {} m", self.grid.tile.to_text(), 2.0 * self.grid.voxel);
            return Err(Error::Lattice { reason });
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
                if block.traversed[slot / 64] >> (slot % 64) & 1 == 1 {
                    out.traverse(voxel);
                }
                if block.count(slot) > 0 {
                    out.hit(voxel, block.count(slot));
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
