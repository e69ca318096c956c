//! From the sums of all stations to the belief at one sample.

use super::evidence::{Evidence, Place, Station};
use super::model::{EvidenceModel, ModelKind};
use super::ray_sums;
use super::sums::Sums;
use super::surface_sums::SurfaceReading;
use crate::evidence::{LogCommonality, Mass, SurfaceObservation};
use crate::geometry::Vec3;
use crate::{Interrupt, Result, poll};

/// The ray model calls a sample seen when this much of its mass is committed: its kernel is narrow, and belief
/// rarely comes near the confidence.
const SEEN_BY_RAYS: f64 = 0.5;
/// How much of the reliability a surface in front of the face keeps: it may be furniture.
const IN_FRONT_RELIABILITY: f64 = 0.9;

/// What is believed at one sample.
#[derive(Debug, Clone, Copy)]
pub struct SampleBelief {
    /// Combined mass: is the built surface within ±T of the face here?
    pub mass: Mass,
    /// Belief that a surface stands in front of the face, beyond T: displaced object or clutter.
    pub in_front: f64,
    /// Share of the beams that pierced the face.
    pub pierced: f64,
    /// Deviation of the built surface along the outward normal, metres, and its standard deviation.
    pub deviation: Option<(f64, f64)>,
    /// Beams that spoke.
    pub beams: u32,
    /// Stations that saw a surface here.
    pub stations: u32,
    /// Whether so many beams spoke that belief could reach the confidence, had they all said the same.
    pub seen: bool,
    /// Mean conflict between pairs of stations.
    pub conflict: f64,
}

/// Adds up stations at one sample.
struct Accumulator {
    commonality: LogCommonality,
    not_in_front: f64,
    /// 1 − the most belief that the stations could give together.
    not_covered: f64,
    hit: f64,
    through: f64,
    /// Σ d/σ² and Σ 1/σ².
    weighted_deviation: f64,
    precision: f64,
    beams: u32,
    stations: u32,
    /// For the conflict between pairs of stations: how many, Σo, Σe, Σoe.
    spoke: f64,
    sum_occupied: f64,
    sum_empty: f64,
    sum_product: f64,
}

impl Evidence {
    /// Calls `visit(position, normal, belief)` for every sample, with the tolerance of `model`.
    pub fn for_each_sample(
        &self,
        model: &EvidenceModel,
        interrupt: Interrupt,
        mut visit: impl FnMut(&Vec3, &Vec3, &SampleBelief),
    ) -> Result<()> {
        for (b, block) in self.samples.blocks.iter().enumerate() {
            poll(interrupt)?;
            let normal = &self.samples.normals[block.face as usize];
            let heard = self.heard(b);
            for i in 0..block.len as usize {
                let position = self.samples.position(block.start as usize + i);
                visit(&position, normal, &belief(&heard, i, &position, normal, model));
            }
        }
        Ok(())
    }

    /// The stations that spoke about block `b`, with their sums.
    pub(super) fn heard(&self, b: usize) -> Vec<(&Station, &[Sums])> {
        self.stations.iter().filter_map(|s| Some((s, &**s.blocks.get(&(b as u32))?))).collect()
    }
}

/// Belief at sample `i` of the block that the stations `heard` spoke about, with the tolerance of `model` (which may
/// ask for another level of accuracy than the evidence was made for).
pub(super) fn belief(
    heard: &[(&Station, &[Sums])],
    i: usize,
    position: &Vec3,
    normal: &Vec3,
    model: &EvidenceModel,
) -> SampleBelief {
    let mut acc = Accumulator::new();
    for (station, sums) in heard {
        let sums = &sums[i];
        if sums.is_empty() {
            continue;
        }
        acc.beams = acc.beams.saturating_add(sums.beams);
        match model.kind {
            ModelKind::Surface => acc.add_surface(station, sums, position, normal, model),
            ModelKind::Meyer2022 => acc.add_rays(sums),
        }
    }
    acc.finish(model)
}

impl Accumulator {
    fn new() -> Self {
        Self {
            commonality: LogCommonality::default(),
            not_in_front: 1.0,
            not_covered: 1.0,
            hit: 0.0,
            through: 0.0,
            weighted_deviation: 0.0,
            precision: 0.0,
            beams: 0,
            stations: 0,
            spoke: 0.0,
            sum_occupied: 0.0,
            sum_empty: 0.0,
            sum_product: 0.0,
        }
    }

    /// One station as one body of evidence: docs/method.md, "surface".
    fn add_surface(&mut self, station: &Station, sums: &Sums, position: &Vec3, normal: &Vec3, model: &EvidenceModel) {
        let Some(r) = SurfaceReading::of(sums) else { return };
        // Without one place that sees it, a sample counts along the normal and has no range.
        let (sight, range) = match station.place {
            Place::At(origin) => (position - origin, (position - origin).norm().max(1e-6)),
            Place::Many | Place::Unknown => (-normal, 0.0),
        };
        let cos = sight.dot(normal).abs() / sight.norm().max(1e-6);
        let covered = 1.0 - (-(r.hit + r.through)).exp();
        let hit_share = r.hit / (r.hit + r.through);
        let sigma = deviation_sigma(&r, range, cos, model);
        let seen = SurfaceObservation { deviation: r.deviation, sd: sigma, coverage: covered, hit_share };
        let (mut mass, in_front) = seen.mass(model.tolerance(), model.reliability);
        if station.place == Place::Unknown {
            // No ray, no emptiness.
            mass = Mass { empty: 0.0, unknown: mass.unknown + mass.empty, ..mass };
        }
        self.add_mass(&mass);
        self.not_in_front *= 1.0 - IN_FRONT_RELIABILITY * in_front;
        self.not_covered *= 1.0 - model.reliability * covered;
        self.hit += r.hit;
        self.through += r.through;
        if r.hit > 0.0 {
            // Sums count towards the scanner; the value reported counts along the outward normal.
            let outward = if sight.dot(normal) <= 0.0 { r.deviation } else { -r.deviation };
            let own = (sigma * sigma - model.sigma_model.powi(2)).max(1e-12);
            let weight = r.hit.min(1.0) / own;
            self.weighted_deviation += weight * outward;
            self.precision += weight;
            self.stations += 1;
        }
    }

    fn add_mass(&mut self, mass: &Mass) {
        self.commonality.add(&mass.log_commonality());
        self.spoke += 1.0;
        self.sum_occupied += mass.occupied;
        self.sum_empty += mass.empty;
        self.sum_product += mass.occupied * mass.empty;
    }

    /// Mean of Shafer's conflict over the pairs of stations. (The conflict of all together grows with their number
    /// although they agree.)
    fn conflict(&self) -> f64 {
        let pairs = 0.5 * self.spoke * (self.spoke - 1.0);
        if pairs > 0.0 { ((self.sum_occupied * self.sum_empty - self.sum_product) / pairs).max(0.0) } else { 0.0 }
    }

    fn add_rays(&mut self, sums: &Sums) {
        let own = ray_sums::reading(sums).mass().unwrap_or(Mass::VACUOUS);
        self.add_mass(&own);
        self.not_covered *= own.unknown;
        self.hit += own.occupied;
        self.through += own.empty;
    }

    fn finish(self, model: &EvidenceModel) -> SampleBelief {
        // The model's own error is common to all stations.
        let sd = || self.precision.sqrt().recip().hypot(model.sigma_model);
        let deviation = (self.precision > 0.0).then(|| (self.weighted_deviation / self.precision, sd()));
        let spoke = self.hit + self.through;
        SampleBelief {
            mass: self.commonality.mass().unwrap_or(Mass::VACUOUS),
            in_front: 1.0 - self.not_in_front,
            pierced: if spoke > 0.0 { self.through / spoke } else { 0.0 },
            deviation,
            beams: self.beams,
            stations: self.stations,
            seen: 1.0 - self.not_covered
                >= match model.kind {
                    ModelKind::Surface => model.confidence,
                    ModelKind::Meyer2022 => SEEN_BY_RAYS,
                },
            conflict: self.conflict(),
        }
    }
}

/// σ of a station's mean deviation at a sample: noise of range and angle (or the observed scatter, if that is
/// larger) averaged over the beams, then what all its beams share, registration and the model itself.
fn deviation_sigma(r: &SurfaceReading, range: f64, cos: f64, model: &EvidenceModel) -> f64 {
    let sin = (1.0 - cos * cos).max(0.0).sqrt();
    let one_beam = (model.sigma_range * cos).powi(2) + (model.sigma_angle * range * sin).powi(2);
    let averaged = one_beam.max(r.variance) / r.effective.max(1.0);
    (averaged + model.sigma_station.powi(2) + model.sigma_model.powi(2)).sqrt().max(1e-6)
}
