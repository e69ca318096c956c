//! What the stations saw at one sample, before any tolerance is asked.
//!
//! Every station measured the deviation d of the built surface, or saw through the face. Stations whose deviations
//! agree are combined on the real line, where each is a normal density, and only then asked whether d lies within ±T:
//! coarsening first and combining then, as one mass a station, would throw away by how much each of them missed T
//! (Shafer 1976, ch. 6: combination commutes with refinement, not with coarsening). Stations that do not agree are
//! bodies of evidence that contradict each other, for Dempster's rule.

use super::evidence::{Place, Station};
use super::model::{EvidenceModel, ModelKind};
use super::sums::Sums;
use super::surface_sums::SurfaceReading;
use super::{ray_sums, surface_sums};
use crate::evidence::{LogCommonality, Mass, SurfaceObservation};
use crate::geometry::Vec3;

/// Deviations farther apart than this many of their σ are not of one surface: 99.9 % of those of one are nearer.
const SAME_SURFACE_SIGMAS: f64 = 3.3;
/// … nor those farther apart than this is precise: surfaces are rough, and edges are sampled by few beams, metres.
const SAME_SURFACE_M: f64 = 0.002;
/// Beams on one surface scatter by this much beyond their noise at the most: plaster, a slope between them, metres.
const ROUGHNESS_M: f64 = 0.005;
/// How much of the reliability a surface in front of the face keeps: it may be furniture.
const IN_FRONT_RELIABILITY: f64 = 0.9;
/// The ray model calls a sample seen when this much of its mass is committed: its kernel is narrow, and belief
/// rarely comes near the confidence.
const SEEN_BY_RAYS: f64 = 0.5;

/// A body of evidence: stations that agree.
#[derive(Debug, Clone, Copy)]
pub struct Body {
    /// Deviation of the built surface along the outward normal, metres; NaN where all saw through the face.
    pub deviation: f32,
    /// Its variance from the beams' noise, m² …
    pub random_variance: f32,
    /// … and what it shares with other samples: registration, the model itself.
    pub common_variance: f32,
    /// The most belief that it can give: reliability and coverage.
    pub trust: f32,
    /// Share of the beams that met a surface; the others pierced the face.
    pub hit_share: f32,
    /// Whether it can speak of emptiness: points without rays cannot.
    pub has_rays: bool,
    /// How many stations.
    pub stations: u8,
}

/// What one station says: an observation that is its own body as long as none agrees with it.
#[derive(Debug, Clone)]
struct Voice {
    station: usize,
    deviation: f64,
    random_variance: f64,
    trust: f64,
    hit_share: f64,
    has_rays: bool,
}

/// Everything about a sample that does not depend on the level of accuracy.
#[derive(Debug, Clone, Default)]
pub struct Reading {
    /// By falling trust; the first is the main one.
    pub bodies: Vec<Body>,
    /// Beams that spoke.
    pub beams: u32,
    /// For the ray model: all its beams combined.
    pub rays: Option<LogCommonality>,
    /// Whether so many beams spoke that belief could reach the confidence, had they all said the same.
    pub seen: bool,
    /// (Station, its share in the main body's deviation).
    pub shares: Vec<(usize, f64)>,
    /// How many samples' worth of independent measurements this one has, at most 1.
    pub independence: f64,
    voices: Vec<Voice>,
}

impl Reading {
    /// Reads sample `i` of the block that the stations `heard` spoke about. Reuses its own memory.
    pub fn read(
        &mut self,
        heard: &[(usize, &Station, &[Sums])],
        i: usize,
        position: &Vec3,
        normal: &Vec3,
        model: &EvidenceModel,
    ) {
        self.bodies.clear();
        self.shares.clear();
        self.voices.clear();
        (self.beams, self.rays, self.independence) = (0, None, 0.0);
        let mut not_covered = 1.0;
        for (number, station, sums) in heard {
            let sums = &sums[i];
            if sums.is_empty() {
                continue;
            }
            self.beams = self.beams.saturating_add(sums.beams);
            match model.kind {
                ModelKind::Surface => {
                    let Some(voice) = self.hear(*number, station, sums, position, normal, model) else { continue };
                    not_covered *= 1.0 - voice.trust;
                    self.voices.push(voice);
                }
                ModelKind::Meyer2022 => {
                    let own = ray_sums::reading(sums);
                    not_covered *= own.mass().unwrap_or(Mass::VACUOUS).unknown;
                    self.rays.get_or_insert_default().add(&own);
                }
            }
        }
        self.gather_bodies(model);
        let least = if model.kind == ModelKind::Surface { model.confidence } else { SEEN_BY_RAYS };
        self.seen = 1.0 - not_covered >= least;
    }

    fn hear(
        &mut self,
        number: usize,
        station: &Station,
        sums: &Sums,
        position: &Vec3,
        normal: &Vec3,
        model: &EvidenceModel,
    ) -> Option<Voice> {
        let r = &SurfaceReading::of(sums)?;
        let brightness = brightness(r, sums, model);
        // Without one place that sees it, a sample counts along the normal and has no range.
        let (sight, range) = match station.place {
            Place::At(origin) => (position - origin, (position - origin).norm().max(1e-6)),
            Place::Many | Place::Unknown => (-normal, 0.0),
        };
        let cos = sight.dot(normal).abs() / sight.norm().max(1e-6);
        self.independence = (self.independence + independence(station, range, cos, model)).min(1.0);
        // Sums count towards the scanner; values count along the outward normal.
        let outward = if sight.dot(normal) <= 0.0 { r.deviation } else { -r.deviation };
        Some(Voice {
            station: number,
            deviation: if r.hit >= r.through { outward } else { f64::NAN },
            // The observed scatter, where that is larger than the noise.
            random_variance: (beam_variance(range, cos, model) / brightness).max(r.variance) / r.effective.max(1.0),
            trust: model.reliability
                * (1.0 - (-(r.hit + r.through) / brightness).exp())
                * unmixed(r, range, cos, model),
            hit_share: r.hit / (r.hit + r.through),
            has_rays: station.place != Place::Unknown,
        })
    }

    /// The most trusted voice first, then whoever agrees with it; what is left starts the next body.
    fn gather_bodies(&mut self, model: &EvidenceModel) {
        let order = |a: &Voice, b: &Voice| b.trust.total_cmp(&a.trust).then(a.station.cmp(&b.station));
        self.voices.sort_by(order);
        let station_variance = model.sigma_station * model.sigma_station;
        while !self.voices.is_empty() {
            let first = &self.voices[0];
            let (d, variance, through, rays) =
                (first.deviation, first.random_variance, first.deviation.is_nan(), first.has_rays);
            let agrees = |v: &Voice| {
                let spread = (v.random_variance + variance + 2.0 * station_variance).sqrt();
                v.has_rays == rays
                    && v.deviation.is_nan() == through
                    && (through || (v.deviation - d).abs() <= (SAME_SURFACE_SIGMAS * spread).max(SAME_SURFACE_M))
            };
            let mut sum = BodySum { not_trusted: 1.0, ..BodySum::default() };
            self.voices.retain(|v| {
                let joins = agrees(v);
                if joins {
                    sum.add(v, station_variance);
                }
                !joins
            });
            if self.bodies.is_empty() {
                self.shares.extend(sum.weights.iter().map(|(s, w)| (*s, w / sum.weight)));
            }
            self.bodies.push(sum.body(rays, model));
        }
    }

    /// Combined mass at `model`'s tolerance, and the belief that a surface stands in front of the face beyond it.
    pub fn mass(&self, model: &EvidenceModel) -> (Mass, f64) {
        if let Some(rays) = &self.rays {
            return (rays.mass().unwrap_or(Mass::VACUOUS), 0.0);
        }
        mass_of(&self.bodies, model)
    }

    /// Shafer's conflict between the bodies, by the share of pairs of stations that stand against each other. (The
    /// conflict of all together grows with their number although they agree.)
    pub fn conflict(&self, model: &EvidenceModel) -> f64 {
        let all: f64 = self.bodies.iter().map(|b| f64::from(b.stations)).sum();
        if self.bodies.len() < 2 || all < 2.0 {
            return 0.0;
        }
        let mut sum = 0.0;
        for (i, a) in self.bodies.iter().enumerate() {
            let m = a.mass(model).0;
            for b in &self.bodies[..i] {
                let n = b.mass(model).0;
                let against = m.occupied * n.empty + m.empty * n.occupied;
                sum += against * f64::from(a.stations) * f64::from(b.stations);
            }
        }
        sum / (0.5 * all * (all - 1.0))
    }
}

/// Dempster's rule over bodies of evidence.
pub fn mass_of(bodies: &[Body], model: &EvidenceModel) -> (Mass, f64) {
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

impl Body {
    /// The first that tells where the surface is; `None` where no beam met one.
    pub fn that_met(bodies: &[Self]) -> Option<&Self> {
        bodies.iter().find(|b| !b.deviation.is_nan())
    }

    /// σ of the deviation, metres.
    pub fn sd(&self) -> f64 {
        f64::from(self.random_variance + self.common_variance).sqrt()
    }

    /// Mass that the built surface lies within ±T, and belief that it stands in front of the face.
    fn mass(&self, model: &EvidenceModel) -> (Mass, f64) {
        let trust = f64::from(self.trust);
        if self.deviation.is_nan() {
            return (Mass { occupied: 0.0, empty: trust, unknown: 1.0 - trust }, 0.0);
        }
        let seen = SurfaceObservation {
            deviation: f64::from(self.deviation),
            sd: self.sd().max(1e-6),
            coverage: trust,
            hit_share: f64::from(self.hit_share),
        };
        let (mass, in_front) = seen.mass(model.tolerance(), 1.0);
        let mass = if self.has_rays { mass } else { Mass { empty: 0.0, unknown: mass.unknown + mass.empty, ..mass } };
        (mass, IN_FRONT_RELIABILITY * in_front)
    }
}

#[derive(Default)]
struct BodySum {
    weights: Vec<(usize, f64)>,
    weight: f64,
    deviation: f64,
    random: f64,
    common: f64,
    /// Product of 1 − trust.
    not_trusted: f64,
    trust: f64,
    hit: f64,
}

impl BodySum {
    fn add(&mut self, v: &Voice, station_variance: f64) {
        // A voice that is hardly heard has hardly a say, however precise its few beams are.
        let weight = v.trust / (v.random_variance + station_variance).max(1e-12);
        self.weights.push((v.station, weight));
        self.weight += weight;
        self.deviation += weight * v.deviation;
        self.random += weight * weight * v.random_variance;
        self.common += weight * weight * station_variance;
        self.not_trusted *= 1.0 - v.trust;
        self.trust += v.trust;
        self.hit += v.trust * v.hit_share;
    }

    fn body(&self, has_rays: bool, model: &EvidenceModel) -> Body {
        let w2 = self.weight * self.weight;
        Body {
            deviation: (self.deviation / self.weight) as f32,
            random_variance: (self.random / w2) as f32,
            // The model's own error is common to all stations.
            common_variance: (self.common / w2 + model.sigma_model.powi(2)) as f32,
            trust: (1.0 - self.not_trusted) as f32,
            hit_share: (self.hit / self.trust) as f32,
            has_rays,
            stations: self.weights.len().min(255) as u8,
        }
    }
}

/// How many samples' worth of independent measurements a station gives one sample, at most 1: samples nearer to each
/// other than the kernel is wide hear the same beams. `range` in metres, 0 where it is unknown.
pub(super) fn independence(station: &Station, range: f64, cos: f64, model: &EvidenceModel) -> f64 {
    let beam_spacing_squared = (f64::from(station.step) * range).powi(2) / cos.max(0.05);
    if beam_spacing_squared > 0.0 {
        (model.spacing * model.spacing / (beam_spacing_squared * surface_sums::BEAMS_IN_KERNEL)).min(1.0)
    } else {
        1.0
    }
}

/// Mean share of the beams' weights that their intensities left: dark beams cover a place as well as bright ones.
fn brightness(r: &SurfaceReading, sums: &Sums, model: &EvidenceModel) -> f64 {
    let unweighted = f64::from(sums.beams) * surface_sums::MEAN_WEIGHT;
    if model.intensity.is_some() { ((r.hit + r.through) / unweighted).clamp(1.0 / 64.0, 1.0) } else { 1.0 }
}

/// Variance of one beam's deviation, from range and angle, m².
fn beam_variance(range: f64, cos: f64, model: &EvidenceModel) -> f64 {
    let sin = (1.0 - cos * cos).max(0.0).sqrt();
    (model.sigma_range * cos).powi(2) + (model.sigma_angle * range * sin).powi(2)
}

/// How far the beams around a sample met one surface: where they scatter by more than noise and roughness, some met
/// the edge's other side or what stands before it, and their mean is the place of nothing.
fn unmixed(r: &SurfaceReading, range: f64, cos: f64, model: &EvidenceModel) -> f64 {
    let of_one_surface = 9.0 * beam_variance(range, cos, model) + ROUGHNESS_M * ROUGHNESS_M;
    (of_one_surface / r.variance.max(of_one_surface)).powi(2)
}
