//! Bodies of evidence: stations that agree, and what they say together.

use super::compact::CompactDeviation;
use crate::evidence::{LogCommonality, Mass, SurfaceObservation};
use crate::verify::model::{EvidenceModel, StationObservation};

/// How much of the reliability a surface in front of the face keeps: it may be furniture.
const IN_FRONT_RELIABILITY: f64 = 0.9;

/// A body of evidence: stations that agree.
#[derive(Debug, Clone, Copy)]
pub struct EvidenceBody {
    /// Deviation of the built surface along the outward normal, metres; none where all saw through the face.
    pub deviation: CompactDeviation,
    /// Its variance from the beams' noise, m².
    pub random_variance: f32,
    /// The variance that it shares with other samples: registration, the model itself, m².
    pub common_variance: f32,
    /// The most belief that it can give: reliability and coverage.
    pub trust: f32,
    /// Share of the beams that met a surface; the others passed through the face.
    pub hit_share: f32,
    /// Whether it can tell of emptiness: points without rays cannot.
    pub has_rays: bool,
    /// How many stations.
    pub stations: u8,
}

impl EvidenceBody {
    /// The first that tells where the surface is, and how far off; `None` where no beam met one. Metres.
    pub fn on_surface(bodies: &[Self]) -> Option<(&Self, f64)> {
        bodies.iter().find_map(|b| Some((b, f64::from(b.deviation.get()?))))
    }

    /// σ of the deviation, metres.
    pub fn sd(&self) -> f64 {
        f64::from(self.random_variance + self.common_variance).sqrt()
    }

    /// Mass that the built surface lies within ±T, and belief that it stands in front of the face.
    pub fn mass(&self, model: &EvidenceModel) -> (Mass, f64) {
        let trust = f64::from(self.trust);
        let Some(deviation) = self.deviation.get() else {
            return (Mass { occupied: 0.0, empty: trust, unknown: 1.0 - trust }, 0.0);
        };
        let observation = SurfaceObservation {
            deviation: f64::from(deviation),
            sd: self.sd().max(1e-6),
            coverage: trust,
            hit_share: f64::from(self.hit_share),
        };
        let (mass, in_front) = observation.mass(model.question.tolerance(), 1.0);
        let mass = if self.has_rays { mass } else { Mass { empty: 0.0, unknown: mass.unknown + mass.empty, ..mass } };
        (mass, IN_FRONT_RELIABILITY * in_front)
    }
}

/// Dempster's rule over bodies of evidence; and the belief that a surface stands in front of the face.
pub fn mass_of(bodies: &[EvidenceBody], model: &EvidenceModel) -> (Mass, f64) {
    match bodies {
        [] => (Mass::VACUOUS, 0.0),
        [one] => one.mass(model),
        many => {
            let mut sum = LogCommonality::default();
            let mut not_in_front = 1.0;
            for body in many {
                let (mass, in_front) = body.mass(model);
                sum.add(&mass.log_commonality());
                not_in_front *= 1.0 - in_front;
            }
            (sum.mass().unwrap_or(Mass::VACUOUS), 1.0 - not_in_front)
        }
    }
}

/// Stations that agree, being added up to a body.
pub struct EvidenceBodySum {
    /// (Station, its weight in the deviation).
    weights: Vec<(usize, f64)>,
    weight: f64,
    /// `None` where they saw through the face.
    deviation: Option<f64>,
    random: f64,
    common: f64,
    /// Product of 1 − trust.
    not_trusted: f64,
    trust: f64,
    hit: f64,
    has_rays: bool,
}

impl EvidenceBodySum {
    /// A body to which observations like this one will be added.
    pub fn like(first: &StationObservation) -> Self {
        Self {
            weights: Vec::new(),
            weight: 0.0,
            deviation: first.deviation.map(|_| 0.0),
            random: 0.0,
            common: 0.0,
            not_trusted: 1.0,
            trust: 0.0,
            hit: 0.0,
            has_rays: first.has_rays,
        }
    }

    /// Adds what a station observed. Variances in m².
    pub fn add_station(&mut self, station: usize, o: &StationObservation, station_variance: f64) {
        // A station that is hardly trusted has hardly a say, however precise its few beams are.
        let weight = o.trust / (o.random_variance + station_variance).max(1e-12);
        self.weights.push((station, weight));
        self.weight += weight;
        self.deviation = self.deviation.zip(o.deviation).map(|(sum, d)| sum + weight * d);
        self.random += weight * weight * o.random_variance;
        self.common += weight * weight * station_variance;
        self.not_trusted *= 1.0 - o.trust;
        self.trust += o.trust;
        self.hit += o.trust * o.hit_share;
    }

    /// (Station, its share in the deviation).
    pub fn shares(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.weights.iter().map(|(s, w)| (*s, w / self.weight))
    }

    /// All of them as one.
    pub fn body(&self, model: &EvidenceModel) -> EvidenceBody {
        let w2 = self.weight * self.weight;
        EvidenceBody {
            deviation: self.deviation.map(|sum| sum / self.weight).into(),
            random_variance: (self.random / w2) as f32,
            // The model's own error is common to all stations.
            common_variance: (self.common / w2 + model.sigma_model.powi(2)) as f32,
            trust: (1.0 - self.not_trusted) as f32,
            hit_share: (self.hit / self.trust) as f32,
            has_rays: self.has_rays,
            stations: self.weights.len().min(255) as u8,
        }
    }
}
