//! What one station's beams add up to at one sample, in integers.
//!
//! Integer sums are associative to the last bit: evidence does not depend on the order of patches, on parallel
//! workers, or on whether it was rolled up from parts.

/// Sums of one station at one sample. Their meaning belongs to the model: see `surface_sums` and `ray_sums`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Sums {
    /// Beams that spoke.
    pub beams: u32,
    /// Fixed-point sums.
    pub parts: [i64; 5],
}

impl Sums {
    /// Adds another set of sums.
    pub fn add(&mut self, o: &Self) {
        self.beams = self.beams.saturating_add(o.beams);
        for (a, b) in self.parts.iter_mut().zip(&o.parts) {
            *a = a.saturating_add(*b);
        }
    }

    /// Whether no beam spoke.
    pub fn is_empty(&self) -> bool {
        self.beams == 0
    }
}
