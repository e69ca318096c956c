//! What became of the voxels of a block, by what is known of it on both sides.

use super::class::ChangeClass;
use super::classes::Classes;
use super::settings::ChangeSettings;
use crate::voxel::lattice::bits::slots;
use crate::voxel::lattice::{Bits, VoxelBox};
use crate::voxel::occupancy::{KnownAround, Occupancy};

/// Compares block by block.
pub struct Judge<'a> {
    /// Old and new.
    pub sides: [&'a Occupancy; 2],
    /// How they are compared.
    pub settings: ChangeSettings,
    /// The steps to the voxels within the tolerance.
    pub steps: Vec<[i64; 3]>,
    /// The voxels that both tiles have.
    pub span: VoxelBox,
}

impl Judge<'_> {
    /// What became of a block.
    pub fn block(&self, key: [i32; 3]) -> Classes {
        let own = self.sides.map(|side| side.block(key));
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
        let block = other.block(key);
        let around = (!self.steps.is_empty()).then(|| other.around(key));
        for slot in slots(alone) {
            let near = around.as_ref().map(|a| self.most_near(a, slot));
            let seen_empty = other.is_model() || block.is_some_and(|b| b.is_traversed(slot));
            out.set(slot, one_sided(side == 1, seen_empty, near, self.settings.threshold));
        }
    }

    /// The most returns of a voxel within the tolerance; as many as the threshold suffice.
    fn most_near(&self, around: &KnownAround, slot: usize) -> u8 {
        let mut most = 0;
        for &step in &self.steps {
            most = most.max(around.count(slot, step));
            if most >= self.settings.threshold {
                break;
            }
        }
        most
    }
}

/// ChangeClass of a voxel that is occupied in one epoch alone, by what the other says of it and around it: whether
/// beams passed, and the most returns within the tolerance.
fn one_sided(in_new: bool, passed: bool, most_near: Option<u8>, threshold: u8) -> ChangeClass {
    match (most_near, passed) {
        (Some(most), _) if most >= threshold => ChangeClass::Confirmed,
        (Some(most), true) if most > 0 => ChangeClass::Ambiguous,
        (_, false) => ChangeClass::Unknown,
        (_, true) if in_new => ChangeClass::New,
        (_, true) => ChangeClass::Disappeared,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every reason of a class, at a threshold of 3 returns.
    #[test]
    fn voxels_occupied_on_one_side() {
        use ChangeClass::*;
        for (in_new, passed, most_near, class) in [
            (true, true, None, New),
            (false, true, None, Disappeared),
            (true, false, None, Unknown),
            (true, true, Some(0), New),
            (true, true, Some(2), Ambiguous),
            (false, true, Some(2), Ambiguous),
            (true, false, Some(2), Unknown),
            (true, true, Some(3), Confirmed),
            (false, false, Some(3), Confirmed),
        ] {
            assert_eq!(one_sided(in_new, passed, most_near, 3), class, "{in_new} {passed} {most_near:?}");
        }
    }
}
