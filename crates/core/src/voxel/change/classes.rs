//! The classes of a block's voxels, in three planes of bits.

use super::class::ChangeClass;
use crate::voxel::lattice::Bits;

/// The classes of a block's voxels: bit `i` of the class's number in plane `i`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Classes(pub [Bits; 3]);

impl Classes {
    /// Gives a voxel that has none its class.
    pub fn set(&mut self, slot: usize, class: ChangeClass) {
        for (plane, bits) in self.0.iter_mut().enumerate() {
            bits[slot / 64] |= u64::from(class as u8 >> plane & 1) << (slot % 64);
        }
    }

    /// ChangeClass of a voxel; `None` for one that is occupied in neither.
    pub fn get(&self, slot: usize) -> Option<ChangeClass> {
        let number = (0..3).fold(0, |n, plane| n | (self.0[plane][slot / 64] >> (slot % 64) & 1) << plane);
        ChangeClass::ALL.into_iter().find(|c| *c as u64 == number)
    }

    /// Voxels of a class.
    pub fn of(&self, class: ChangeClass) -> Bits {
        std::array::from_fn(|word| {
            (0..3).fold(u64::MAX, |bits, plane| {
                let own = self.0[plane][word];
                bits & if class as u8 >> plane & 1 == 1 { own } else { !own }
            })
        })
    }

    /// Voxels that have a class.
    pub fn any(&self) -> Bits {
        std::array::from_fn(|word| self.0.iter().fold(0, |bits, plane| bits | plane[word]))
    }

    /// Whether every number is that of a class or none.
    pub fn are_valid(&self) -> bool {
        (0..8).all(|word| self.0[2][word] & self.0[1][word] == 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxel::lattice::bits::slots;

    #[test]
    fn planes_hold_classes() {
        let mut c = Classes::default();
        for (i, class) in ChangeClass::ALL.into_iter().enumerate() {
            c.set(100 * i + 7, class);
        }
        for (i, class) in ChangeClass::ALL.into_iter().enumerate() {
            assert_eq!(c.get(100 * i + 7), Some(class));
            assert_eq!(slots(&c.of(class)).collect::<Vec<_>>(), [100 * i + 7]);
            assert_eq!(ChangeClass::parse(class.name()), Ok(class));
        }
        assert_eq!(c.get(0), None);
        assert!(c.are_valid() && ChangeClass::parse("gone").is_err());
        assert_eq!(slots(&c.any()).count(), 5);
        c.0[1][0] |= 1;
        c.0[2][0] |= 1;
        assert!(!c.are_valid());
    }
}
