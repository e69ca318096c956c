//! A deviation or none, in four bytes.

/// A deviation in metres, or none: kept by the million, so none is a NaN that nobody sees.
#[derive(Debug, Clone, Copy)]
pub struct CompactDeviation(f32);

impl CompactDeviation {
    /// No deviation.
    pub const NONE: Self = Self(f32::NAN);

    /// In single precision. Metres.
    pub fn new(deviation: f64) -> Self {
        Self(deviation as f32)
    }

    /// The deviation, metres.
    pub fn get(self) -> Option<f32> {
        (!self.0.is_nan()).then_some(self.0)
    }

    /// Whether there is one.
    pub fn is_some(self) -> bool {
        !self.0.is_nan()
    }
}

impl From<Option<f64>> for CompactDeviation {
    fn from(deviation: Option<f64>) -> Self {
        deviation.map_or(Self::NONE, Self::new)
    }
}
