//! Which stations a mean deviation rests on.

use crate::verify::model::EvidenceModel;

/// Samples of a face, or of a smooth surface, and the stations that their deviations came from.
#[derive(Debug, Clone, Default)]
pub struct StationShares {
    /// All samples, seen or not.
    pub samples: u64,
    /// By station, the sum of its shares in the samples' deviations.
    shares: Vec<(u32, f64)>,
}

impl StationShares {
    /// Share of each station in the mean deviation; they add up to 1.
    pub fn shares(&self) -> impl Iterator<Item = (usize, f64)> {
        let all: f64 = self.shares.iter().map(|s| s.1).sum();
        self.shares.iter().map(move |&(station, share)| (station as usize, share / all))
    }

    /// Variance that a mean over these samples shares.
    pub fn common_variance(&self, model: &EvidenceModel) -> f64 {
        let squares: f64 = if self.shares.is_empty() { 1.0 } else { self.shares().map(|(_, w)| w * w).sum() };
        model.common_variance(squares)
    }

    /// Adds those of another face of the same surface.
    pub fn add(&mut self, other: &Self) {
        self.samples += other.samples;
        for &(station, share) in &other.shares {
            self.add_share(station, share);
        }
    }

    /// Adds a station's share in one sample.
    pub fn add_share(&mut self, station: u32, share: f64) {
        match self.shares.iter_mut().find(|s| s.0 == station) {
            Some(s) => s.1 += share,
            None => self.shares.push((station, share)),
        }
    }
}
