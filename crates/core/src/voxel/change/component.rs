//! What is new or gone, as connected things.

use super::class::ChangeClass;
use super::value::VoxelChange;
use crate::error::{Error, Result};
use crate::geometry::{Aabb, Vec3};
use crate::voxel::lattice::bits::{self, slot_of, slots};
use crate::voxel::lattice::block_map::{block_of, voxel_at};
use crate::voxel::lattice::{Bits, BlockMap, steps_within};
use crate::{Grow, Interrupt, poll_now_and_then};

/// Voxels of one class that hang together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChangeComponent {
    /// Their class.
    pub class: ChangeClass,
    /// How many they are.
    pub voxels: u64,
    /// Around the voxels, world metres.
    pub bounds: Aabb,
    /// Mean of their centres, world metres.
    pub centroid: Vec3,
}

impl VoxelChange {
    /// The connected parts of a class with at least `least` voxels, largest first. Two voxels hang together when the
    /// gap between them is less than `gap` metres; 0 for those that touch, were it at a corner.
    pub fn components(
        &self,
        class: ChangeClass,
        least: u64,
        gap: f64,
        interrupt: Interrupt,
    ) -> Result<Vec<ChangeComponent>> {
        if !(0.0..=8.0 * self.grid.voxel).contains(&gap) {
            return Err(Error::argument("the gap", "from 0 to 8 voxels", format!("{gap} m")));
        }
        let steps = steps_within((gap / self.grid.voxel).max(0.5));
        let mut left: BlockMap<Bits> = BlockMap::default();
        for (round, (key, classes)) in self.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            left.insert(*key, classes.of(class), interrupt)?;
        }
        let mut out = Vec::new();
        for (round, (key, classes)) in self.blocks.in_order(interrupt, |classes| classes)?.into_iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            for slot in slots(&classes.of(class)) {
                let seed = voxel_at(key, slot);
                if take(&mut left, seed) {
                    out.push(self.flood(class, seed, &mut left, &steps, interrupt)?);
                }
            }
        }
        out.retain(|c| c.voxels >= least);
        out.sort_by(|a, b| b.voxels.cmp(&a.voxels).then(a.bounds.min[0].total_cmp(&b.bounds.min[0])));
        Ok(out)
    }

    fn flood(
        &self,
        class: ChangeClass,
        seed: [i64; 3],
        left: &mut BlockMap<Bits>,
        steps: &[[i64; 3]],
        interrupt: Interrupt,
    ) -> Result<ChangeComponent> {
        let mut open = vec![seed];
        let (mut low, mut high, mut sum, mut n) = (seed, seed, Vec3::zeros(), 0u64);
        while let Some(voxel) = open.pop() {
            poll_now_and_then(n as usize, interrupt)?;
            open.grow(steps.len(), interrupt)?;
            n += 1;
            sum += self.grid.centre(voxel) - self.grid.centre(seed);
            for axis in 0..3 {
                low[axis] = low[axis].min(voxel[axis]);
                high[axis] = high[axis].max(voxel[axis]);
            }
            for step in steps {
                let next = [0, 1, 2].map(|i| voxel[i] + step[i]);
                if take(left, next) {
                    open.push(next);
                }
            }
        }
        let bounds =
            Aabb { min: low.map(|i| i as f64 * self.grid.voxel), max: high.map(|i| (i + 1) as f64 * self.grid.voxel) };
        Ok(ChangeComponent { class, voxels: n, bounds, centroid: self.grid.centre(seed) + sum / n as f64 })
    }
}

/// Takes a voxel out, if it is there.
fn take(left: &mut BlockMap<Bits>, voxel: [i64; 3]) -> bool {
    let slot = slot_of(voxel);
    let Some(own) = left.get_mut(&block_of(voxel)) else { return false };
    let there = bits::holds(own, slot);
    bits::take(own, slot);
    there
}
