//! The tile that is carved: its blocks, and one ray through them.

use super::local_origin::LocalOrigin;
use super::ray::Ray;
use super::traverse::traverse;
use crate::voxel::lattice::bits::{Bits, common, slot_of};
use crate::voxel::lattice::block_map::block_of;
use crate::voxel::lattice::{BlockMap, Grid, VoxelBlock, VoxelBox};
use crate::{Interrupt, Result, poll};

/// Voxels of a lone ray between two looks at interrupt and memory.
const PIECE: f64 = 1024.0;

/// What beams saw of a tile so far.
pub struct CarvedTile<'a> {
    /// The lattice, and the rules of carving.
    pub grid: &'a Grid,
    /// The voxels of the tile.
    pub span: VoxelBox,
    /// Returns and traversals.
    pub blocks: &'a mut BlockMap<VoxelBlock>,
}

impl CarvedTile<'_> {
    /// The block numbered `key`, made where it is missing.
    pub fn block(&mut self, key: [i32; 3], interrupt: Interrupt) -> Result<&mut VoxelBlock> {
        self.blocks.made(key, interrupt)
    }

    /// Notes voxels of a block as traversed, as far as they belong to the tile.
    pub fn traverse_block(&mut self, key: [i32; 3], bits: &Bits, interrupt: Interrupt) -> Result<()> {
        let inside = common(bits, &self.span.of_block(key));
        if inside.iter().any(|&w| w != 0) {
            let block = self.block(key, interrupt)?;
            block.traversed.iter_mut().zip(inside).for_each(|(a, b)| *a |= b);
        }
        Ok(())
    }

    /// Notes the voxels of one ray as traversed, as far as it lies in the tile.
    pub fn carve_ray(&mut self, ray: &Ray, origin: &LocalOrigin, interrupt: Interrupt) -> Result<()> {
        poll(interrupt)?;
        let Some(ray) = ray.clipped(&origin.span(&self.span)) else { return Ok(()) };
        let way = ray.stop - ray.start;
        let pieces = (way.amax() / PIECE).ceil().max(1.0);
        for piece in 0..pieces as u64 {
            poll(interrupt)?;
            let [from, to] = [piece, piece + 1].map(|i| ray.start + way * (i as f64 / pieces));
            let mut refused = Ok(());
            traverse(&from, &to, |local| {
                let voxel = origin.world(local);
                if self.span.holds(voxel) {
                    match self.block(block_of(voxel), interrupt) {
                        Ok(block) => block.traverse(slot_of(voxel)),
                        Err(e) => refused = Err(e),
                    }
                }
            });
            refused?;
        }
        Ok(())
    }
}
