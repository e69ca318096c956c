//! What is asked of evidence.

use crate::evidence::Loa;

/// What is asked of evidence: it can be asked anew without gathering it again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// The level of accuracy that the object must keep.
    pub loa: Loa,
    /// Belief from which a sample counts as confirmed or refuted.
    pub confidence: f64,
}

impl Default for Question {
    fn default() -> Self {
        Self { loa: Loa::Loa30, confidence: 0.95 }
    }
}

impl Question {
    /// Tolerance ±T, metres.
    pub fn tolerance(&self) -> f64 {
        self.loa.upper()
    }
}
