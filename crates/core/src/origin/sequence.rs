//! Points in the order in which they were measured, or in the opposite one.

use crate::geometry::Vec3;
use crate::scan::Beam;

/// Points in one of two orders: scan lines go upward in one of them.
#[derive(Clone, Copy)]
pub struct Sequence<'a> {
    beams: &'a [Beam],
    is_reversed: bool,
}

impl<'a> Sequence<'a> {
    pub fn new(beams: &'a [Beam]) -> Self {
        Self { beams, is_reversed: false }
    }

    pub fn reversed(self) -> Self {
        Self { is_reversed: !self.is_reversed, ..self }
    }

    pub fn len(&self) -> usize {
        self.beams.len()
    }

    /// The place of a point, metres from the anchor, along the axes of the world.
    pub fn point(&self, i: usize) -> Vec3 {
        self.beams[if self.is_reversed { self.beams.len() - 1 - i } else { i }].offset
    }
}
