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

/// At most `wanted` of `len` places, scattered so that no period appears in them (Fibonacci hashing, Knuth 1973, 6.4).
pub fn scattered(len: usize, wanted: usize) -> impl Iterator<Item = usize> {
    let every = (len as f64 / wanted as f64).max(1.0);
    let count = len.min(wanted);
    (0..count).map(move |i| {
        let jitter = (i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40;
        let within = if every > 1.0 { jitter as f64 / (1u64 << 24) as f64 } else { 0.0 };
        (((i as f64 + within) * every) as usize).min(len - 1)
    })
}
