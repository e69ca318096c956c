//! What one station's beams add up to at one sample, in integers.
//!
//! Integer sums are associative to the last bit: evidence does not depend on the order of patches, on parallel
//! workers, or on whether it was rolled up from parts.

/// Sums of one station at one sample. What the parts mean is the model's: `SurfaceSums` and `RaySums` name them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Sums {
    beams: u32,
    parts: [i64; Sums::PARTS],
}

impl Sums {
    /// Fixed-point numbers of one set.
    pub const PARTS: usize = 5;

    /// Sums of so many beams.
    pub fn new(beams: u32, parts: [i64; Self::PARTS]) -> Self {
        Self { beams, parts }
    }

    /// Beams that were added.
    pub fn beams(&self) -> u32 {
        self.beams
    }

    /// The fixed-point sums.
    pub fn parts(&self) -> [i64; Self::PARTS] {
        self.parts
    }

    /// Adds what one beam says. Inlined: the parts that a model leaves at zero cost nothing.
    #[inline(always)]
    pub fn add_beam(&mut self, parts: [i64; Self::PARTS]) {
        self.add(&Self { beams: 1, parts });
    }

    /// Adds another set of sums.
    #[inline(always)]
    pub fn add(&mut self, other: &Self) {
        self.beams = self.beams.saturating_add(other.beams);
        for (a, b) in self.parts.iter_mut().zip(&other.parts) {
            *a = a.saturating_add(*b);
        }
    }

    /// Whether no beam was added.
    pub fn is_empty(&self) -> bool {
        self.beams == 0
    }
}
