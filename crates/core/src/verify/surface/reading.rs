//! What the stations state at one sample, before any tolerance is asked.
//!
//! Every station measured the deviation d of the built surface, or saw through the face. Stations whose deviations
//! agree are combined on the real line, where each is a normal density, and only then asked whether d lies within ±T:
//! coarsening first and combining then, as one mass a station, would throw away by how much each of them missed T
//! (Shafer 1976, ch. 6: combination commutes with refinement, not with coarsening). Stations that do not agree are
//! bodies of evidence that contradict each other, for Dempster's rule.

use super::body::{EvidenceBody, EvidenceBodySum, mass_of};
use crate::evidence::{LogCommonality, Mass};
use crate::geometry::Vec3;
use crate::verify::evidence::StationEvidence;
use crate::verify::model::{BeamModel, EvidenceModel, Statement, StationObservation, Sums, with_model};

/// Deviations farther apart than this many of their σ are not of one surface: 99.9 % of those of one are nearer.
const SAME_SURFACE_SIGMAS: f64 = 3.3;
/// Nor are those farther apart than this that are precise: surfaces are rough, and edges are sampled by few beams,
/// metres.
const SAME_SURFACE_M: f64 = 0.002;

/// Everything about a sample that does not depend on the level of accuracy. Read anew for sample after sample.
#[derive(Debug, Clone, Default)]
pub struct SampleReading {
    /// By falling trust; the first is the main one.
    pub bodies: Vec<EvidenceBody>,
    /// Beams of all stations.
    pub beams: u32,
    /// Of models that state belief: all stations combined.
    pub belief: Option<LogCommonality>,
    /// Whether so many beams were there that belief could reach the confidence, had they all said the same.
    pub seen: bool,
    /// (Station, its share in the main body's deviation).
    pub shares: Vec<(usize, f64)>,
    /// How many samples' worth of independent measurements this one has, at most 1.
    pub independence: f64,
    /// (Station, what it observed) while they are not in a body.
    observations: Vec<(usize, StationObservation)>,
}

impl SampleReading {
    /// Reads sample `i` of the block that these `stations` saw. Reuses its own memory. The position in world metres.
    pub fn read(
        &mut self,
        stations: &[(usize, &StationEvidence, &[Sums])],
        i: usize,
        position_world: &Vec3,
        normal: &Vec3,
        model: &EvidenceModel,
    ) {
        self.bodies.clear();
        self.shares.clear();
        self.observations.clear();
        (self.beams, self.belief, self.independence) = (0, None, 0.0);
        let mut not_covered = 1.0;
        for (number, station, sums) in stations {
            let sums = &sums[i];
            if sums.is_empty() {
                continue;
            }
            self.beams = self.beams.saturating_add(sums.beams());
            let view = station.viewing_geometry(position_world, normal);
            let statement = with_model!(model.kind, M => M::read(sums, &view, model));
            if let Some(statement) = statement {
                not_covered *= self.add_station(*number, statement);
            }
        }
        self.gather_bodies(model);
        self.seen = 1.0 - not_covered >= with_model!(model.kind, M => M::least_belief_of_seen(model));
    }

    /// Adds what a station states; returns how much of the belief it leaves open at the least.
    fn add_station(&mut self, number: usize, statement: Statement) -> f64 {
        match statement {
            Statement::Deviation(observation) => {
                self.independence = (self.independence + observation.independence).min(1.0);
                self.observations.push((number, observation));
                1.0 - observation.trust
            }
            Statement::Belief(commonality) => {
                self.belief.get_or_insert_default().add(&commonality);
                commonality.mass().unwrap_or(Mass::VACUOUS).unknown
            }
        }
    }

    /// The most trusted station first, then whichever agrees with it; what is left starts the next body.
    fn gather_bodies(&mut self, model: &EvidenceModel) {
        type Numbered = (usize, StationObservation);
        let order = |a: &Numbered, b: &Numbered| b.1.trust.total_cmp(&a.1.trust).then(a.0.cmp(&b.0));
        self.observations.sort_by(order);
        let station_variance = model.sigma_station * model.sigma_station;
        while let Some(&(_, first)) = self.observations.first() {
            let mut sum = EvidenceBodySum::like(&first);
            self.observations.retain(|(station, o)| {
                let joins = agree(o, &first, station_variance);
                if joins {
                    sum.add_station(*station, o, station_variance);
                }
                !joins
            });
            if self.bodies.is_empty() {
                self.shares.extend(sum.shares());
            }
            self.bodies.push(sum.body(model));
        }
    }

    /// Combined mass at `model`'s tolerance, and the belief that a surface stands in front of the face beyond it.
    pub fn mass(&self, model: &EvidenceModel) -> (Mass, f64) {
        if let Some(belief) = &self.belief {
            return (belief.mass().unwrap_or(Mass::VACUOUS), 0.0);
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

/// Whether two stations observed the same.
fn agree(a: &StationObservation, b: &StationObservation, station_variance: f64) -> bool {
    let spread = (a.random_variance + b.random_variance + 2.0 * station_variance).sqrt();
    a.has_rays == b.has_rays
        && match (a.deviation, b.deviation) {
            (Some(a), Some(b)) => (a - b).abs() <= (SAME_SURFACE_SIGMAS * spread).max(SAME_SURFACE_M),
            (a, b) => a.is_none() && b.is_none(),
        }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn observed(deviation: Option<f64>, trust: f64) -> StationObservation {
        let hit_share = if deviation.is_some() { 1.0 } else { 0.0 };
        StationObservation { deviation, random_variance: 1e-8, trust, hit_share, has_rays: true, independence: 0.4 }
    }

    #[test]
    fn stations_that_agree_are_one_body_and_the_others_contradict() {
        let model = EvidenceModel::default();
        let mut reading = SampleReading::default();
        let all = [Some(0.0301), None, Some(0.0), Some(0.0005)].map(|d| observed(d, 0.9));
        for (station, observation) in all.into_iter().enumerate() {
            reading.add_station(station, Statement::Deviation(observation));
        }
        reading.gather_bodies(&model);
        let bodies: Vec<_> = reading.bodies.iter().map(|b| (b.deviation.get(), b.stations)).collect();
        assert_eq!(bodies, [(Some(0.0301), 1), (None, 1), (Some(0.00025), 2)]);
        assert_eq!(reading.independence, 1.0);
        let conflict = reading.conflict(&model);
        assert!((0.25..0.35).contains(&conflict), "{conflict}");
    }
}
