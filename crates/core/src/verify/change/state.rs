//! What one epoch says at a sample that it saw.

/// What one epoch says at a sample that it saw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SampleState {
    /// The object is there; with where its surface was met, if the evidence tells.
    There(Option<MetSurface>),
    /// Its place was seen empty.
    Empty,
    /// Something else was met, or nothing is sure.
    Open,
}

/// Where a surface was met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MetSurface {
    /// Deviation along the outward normal, metres.
    pub deviation: f64,
    /// Its variance from the beams' noise, m².
    pub random_variance: f64,
    /// The variance that it shares with other samples of the epoch, m².
    pub common_variance: f64,
    /// How many samples' worth of independent measurements, at most 1.
    pub independence: f64,
}
