//! What became of a voxel between two epochs, or between model and epoch.

use super::blocks::Bits;
use crate::error::{Error, Result};

/// Class of a voxel that is occupied in at least one of two epochs (Meyer, 4.1.2 and 4.1.3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Class {
    /// Occupied in both, to the tolerance.
    Confirmed = 1,
    /// Seen empty before, occupied now; against a model: built, but not drawn.
    New = 2,
    /// Occupied before, seen empty now; against a model: drawn, but seen empty.
    Disappeared = 3,
    /// Occupied in one, not seen in the other.
    Unknown = 4,
    /// Occupied in one; in the other beams passed, but some returned nearby, too few for the threshold.
    Ambiguous = 5,
}

impl Class {
    /// All classes, in the order of Meyer's Table 7.3.
    pub const ALL: [Self; 5] = [Self::Confirmed, Self::New, Self::Disappeared, Self::Unknown, Self::Ambiguous];

    /// SQL text between two epochs.
    pub fn name(self) -> &'static str {
        ["confirmed", "new", "disappeared", "unknown", "ambiguous"][self as usize - 1]
    }

    /// Reads [`Class::name`]; a change against a model may say `unmodelled` and `absent` or `demolished` too.
    pub fn parse(text: &str) -> Result<Self> {
        match text {
            "unmodelled" => Ok(Self::New),
            "absent" | "demolished" => Ok(Self::Disappeared),
            _ => Self::ALL
                .into_iter()
                .find(|c| c.name() == text)
                .ok_or_else(|| Error::argument("a class", "confirmed, new, disappeared, unknown or ambiguous", text)),
        }
    }
}

/// The classes of a block's voxels: bit `i` of the class's number in plane `i`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Classes(pub [Bits; 3]);

impl Classes {
    /// Gives a voxel that has none its class.
    pub fn set(&mut self, slot: usize, class: Class) {
        for (plane, bits) in self.0.iter_mut().enumerate() {
            bits[slot / 64] |= u64::from(class as u8 >> plane & 1) << (slot % 64);
        }
    }

    /// Class of a voxel; `None` for one that is occupied in neither.
    pub fn get(&self, slot: usize) -> Option<Class> {
        let number = (0..3).fold(0, |n, plane| n | (self.0[plane][slot / 64] >> (slot % 64) & 1) << plane);
        Class::ALL.into_iter().find(|c| *c as u64 == number)
    }

    /// Voxels of a class.
    pub fn of(&self, class: Class) -> Bits {
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

/// Class of a voxel that is occupied in one epoch alone, by what the other says of it and around it: whether beams
/// passed, and the most returns within the tolerance.
pub(super) fn one_sided(in_new: bool, passed: bool, most_near: Option<u8>, threshold: u8) -> Class {
    match (most_near, passed) {
        (Some(most), _) if most >= threshold => Class::Confirmed,
        (Some(most), true) if most > 0 => Class::Ambiguous,
        (_, false) => Class::Unknown,
        (_, true) if in_new => Class::New,
        (_, true) => Class::Disappeared,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_hold_classes() {
        let mut c = Classes::default();
        for (i, class) in Class::ALL.into_iter().enumerate() {
            c.set(100 * i + 7, class);
        }
        for (i, class) in Class::ALL.into_iter().enumerate() {
            assert_eq!(c.get(100 * i + 7), Some(class));
            assert_eq!(super::super::blocks::slots(&c.of(class)).collect::<Vec<_>>(), [100 * i + 7]);
            assert_eq!(Class::parse(class.name()), Ok(class));
        }
        assert_eq!(c.get(0), None);
        assert!(c.are_valid() && Class::parse("gone").is_err());
        assert_eq!(super::super::blocks::slots(&c.any()).count(), 5);
        c.0[1][0] |= 1;
        c.0[2][0] |= 1;
        assert!(!c.are_valid());
    }
}
