//! What a station states at one sample.

use crate::evidence::LogCommonality;

/// What a station states at one sample.
#[derive(Debug, Clone, Copy)]
pub enum Statement {
    /// Where the built surface is, or that the face was seen through.
    Deviation(StationObservation),
    /// Belief as it is, by the commonalities of all the station's beams.
    Belief(LogCommonality),
}

/// What one station measured: a body of evidence as long as no other station agrees with it.
#[derive(Debug, Clone, Copy)]
pub struct StationObservation {
    /// Deviation of the built surface along the outward normal, metres; `None` where the face was seen through.
    pub deviation: Option<f64>,
    /// Its variance from the beams' noise, m².
    pub random_variance: f64,
    /// The most belief that it can give: reliability and coverage.
    pub trust: f64,
    /// Share of the beams that met a surface; the others passed through the face.
    pub hit_share: f64,
    /// Whether it can tell of emptiness.
    pub has_rays: bool,
    /// How many samples' worth of independent measurements it is, at most 1.
    pub independence: f64,
}
