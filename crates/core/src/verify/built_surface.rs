//! Which of the seen samples show the object's own surface, and how far off it is there.

use std::cmp::Ordering;

use super::consensus::{Consensus, Observed};
use super::evidence::Evidence;
use super::face::FaceReport;
use super::model::EvidenceModel;
use super::observe::{Heard, Observations, Seen};
use crate::num::normal::cdf;
use crate::num::stats::median;
use crate::{Interrupt, Result, poll, poll_now_and_then, room};

/// Share of a surface's seen samples that must follow one course for that course to be the built surface: of those
/// that nothing in front of it hides …
const MAJORITY: f64 = 0.5;
/// … and of all.
const LEAST_SHARE: f64 = 0.2;
/// A sample follows the course within so many σ, of its own or of all.
const AGREES_SIGMAS: f64 = 3.0;
/// … but no farther off than this, metres: rough surfaces, not clutter.
const MAX_ROUGHNESS_M: f64 = 0.015;
const MIN_ROUGHNESS_M: f64 = 0.001;
/// Where the neighbours are not known, a surface that was met in front of the drawn one is the built one only if this
/// share of it was seen: of an edge that a neighbour covers, a strip beside the neighbour's end is.
const BARED: f64 = 0.25;
/// Samples by which a course is judged, at the most; spread evenly over the surface.
const MAX_JUDGED: usize = 20_000;
/// USIBD: a class holds when this share of the deviations keeps its bound.
const WITHIN: f64 = 0.95;
/// Most of a surface.
const BULK: f64 = 0.75;

/// One smooth surface of the object, as built.
#[derive(Debug)]
pub struct BuiltSurface {
    /// Most of the seen samples follow one course.
    pub coherent: bool,
    /// Samples on it, and how many independent measurements they are worth.
    pub own: u64,
    pub independent: f64,
    /// 95 %, and most, of the deviations are no larger than this, metres.
    pub quantile: f64,
    pub bulk: f64,
    /// Standard deviation of where it is, metres: registration, the model, and the mean of the samples.
    pub sd: f64,
}

/// The seen samples and the built surfaces that they show. Holds for every level of accuracy.
#[derive(Debug)]
pub struct Built {
    pub observations: Observations,
    /// For each seen sample how far off the object's own surface is, metres; NaN where it is not seen.
    pub own: Vec<f32>,
    /// For each smooth surface.
    pub surfaces: Vec<BuiltSurface>,
    /// All of them as one.
    pub whole: BuiltSurface,
    /// Displaced by its own thickness, no beam aimed at the object meets it.
    pub is_slim: bool,
    /// Samples in front of which something stands that is not the object's own surface.
    pub before: u64,
    /// For each face where it is; its samples are not counted yet.
    pub(super) located: Vec<FaceReport>,
}

impl Built {
    /// Fits every smooth surface of the object.
    pub fn of(e: &Evidence, model: &EvidenceModel, interrupt: Interrupt) -> Result<Self> {
        let observations = Observations::of(e, model, interrupt)?;
        // What a course is fitted through: a place and a deviation a sample.
        room::<[f64; 6]>(observations.seen.len(), interrupt)?;
        let mut own = vec![f32::NAN; observations.seen.len()];
        let mut heard = vec![Heard::default(); observations.surfaces.len()];
        for (face, surface) in e.samples.surface_of_face.iter().enumerate() {
            if let Some(h) = heard.get_mut(*surface as usize) {
                h.add(&observations.heard[face]);
            }
        }
        let mut surfaces = Vec::with_capacity(heard.len());
        let mut all = Heard::default();
        for (run, heard) in observations.surfaces.iter().zip(&heard) {
            poll(interrupt)?;
            let (seen, own) = (&observations.seen[run.clone()], &mut own[run.clone()]);
            let coherent = match Course::of(e, &observations, seen, heard, interrupt)? {
                Some(course) => course.write(e, &observations, seen, own, interrupt)?,
                None => false,
            };
            if !coherent {
                own.fill(f32::NAN);
            }
            surfaces.push(BuiltSurface::of(coherent, seen, own, heard, model, interrupt)?);
            all.add(heard);
        }
        let coherent = surfaces.iter().any(|s| s.coherent);
        let whole = BuiltSurface::of(coherent, &observations.seen, &own, &all, model, interrupt)?;
        let met_before =
            |(s, own): &(&Seen, &f32)| own.is_nan() && observations.surface_body(s).is_some_and(|b| b.deviation > 0.0);
        let before = observations.before_unseen + observations.seen.iter().zip(&own).filter(met_before).count() as u64;
        let is_slim = e.samples.is_slim();
        let mut built = Self { observations, own, surfaces, whole, is_slim, before, located: Vec::new() };
        built.locate(e, model, interrupt)?;
        Ok(built)
    }
}

/// The course of one smooth surface, as its seen samples show it.
struct Course {
    consensus: Consensus,
    /// What lies no farther off follows it however precise it is, metres.
    scatter: f64,
    /// Its median deviation over the samples that follow it, metres.
    centre: f64,
    /// Of what a sample differs from the course, so much is the surface's and not the measurement's.
    kept: f64,
}

/// A sample at which a surface was met.
struct Met {
    observed: Observed,
    /// It may follow a course that is no farther off, metres.
    reach: f64,
    random_variance: f64,
}

impl Observed {
    /// The place of a sample, without a surface.
    fn nothing(e: &Evidence, s: &Seen) -> Self {
        let (position, normal) = (Observations::position(s), e.samples.normals[s.face as usize]);
        Self { position, normal, deviation: 0.0 }
    }
}

impl Met {
    fn of(e: &Evidence, observations: &Observations, s: &Seen) -> Option<Self> {
        let body = observations.surface_body(s)?;
        let common = AGREES_SIGMAS * f64::from(body.common_variance).sqrt();
        Some(Self {
            observed: Observed { deviation: f64::from(body.deviation), ..Observed::nothing(e, s) },
            // However unsure of itself, what lies far off the course does not confirm it.
            reach: (AGREES_SIGMAS * body.sd()).min(MAX_ROUGHNESS_M + common),
            random_variance: f64::from(body.random_variance),
        })
    }
}

impl Course {
    /// The course that most of the samples of a run follow; `None` where they do not.
    fn of(
        e: &Evidence,
        observations: &Observations,
        seen: &[Seen],
        heard: &Heard,
        interrupt: Interrupt,
    ) -> Result<Option<Self>> {
        let few: Vec<Met> = seen
            .iter()
            .step_by(seen.len().div_ceil(MAX_JUDGED).max(1))
            .filter_map(|s| Met::of(e, observations, s))
            .collect();
        let few: Vec<&Met> = few.iter().collect();
        let Some(mut course) = Self::through(&few, interrupt)? else { return Ok(None) };
        if course.centre > MAX_ROUGHNESS_M {
            // What hides a face stands in front of it: where there is a course behind this one, that is the face.
            let behind: Vec<&Met> = few.iter().copied().filter(|m| course.side_of(m).is_lt()).collect();
            if behind.len() as f64 >= LEAST_SHARE * few.len() as f64
                && let Some(rear) = Self::through(&behind, interrupt)?
                && rear.centre.abs() < course.centre
            {
                course = rear;
            }
        }
        let bared = seen.len() as f64 >= BARED * heard.samples as f64;
        let displaced_forwards = course.centre > MAX_ROUGHNESS_M;
        Ok((bared || e.knows_neighbours || !displaced_forwards).then_some(course))
    }

    /// The course that most of these follow; `None` where it could not be a built surface.
    fn through(met: &[&Met], interrupt: Interrupt) -> Result<Option<Self>> {
        let observed: Vec<Observed> = met.iter().map(|m| m.observed).collect();
        let Some(consensus) = Consensus::fit(&observed, interrupt)? else { return Ok(None) };
        let scatter = (AGREES_SIGMAS * consensus.spread).clamp(MIN_ROUGHNESS_M, MAX_ROUGHNESS_M);
        let mut course = Self { consensus, scatter, kept: 0.0, centre: 0.0 };
        let own: Vec<&Met> = met.iter().copied().filter(|m| course.side_of(m).is_eq()).collect();
        if !course.consensus.is_surface(own.iter().map(|m| &m.observed)) {
            return Ok(None);
        }
        let middle =
            |of: &dyn Fn(&Met) -> f64| median(&mut own.iter().map(|m| of(m)).collect::<Vec<_>>()).unwrap_or(0.0);
        let noise = middle(&|m| m.random_variance);
        course.centre = middle(&|m| course.consensus.at(&m.observed));
        course.kept = 1.0 - noise / course.consensus.spread.powi(2).max(noise).max(1e-12);
        Ok(Some(course))
    }

    /// Whether a sample lies behind the course, follows it, or stands in front of it.
    fn side_of(&self, m: &Met) -> Ordering {
        let (residual, reach) = (self.consensus.residual(&m.observed), m.reach.max(self.scatter));
        if residual.abs() <= reach { Ordering::Equal } else { residual.total_cmp(&0.0) }
    }

    /// Whether a mantle that took this course is missed here by beams aimed at the drawn one: its lee side.
    fn leaves_empty(&self, place: &Observed) -> bool {
        self.consensus.is_curved() && self.consensus.at(place) < -self.scatter
    }

    /// Writes the deviation of every sample that follows; whether most do, but for those that the course leaves to
    /// what stands in front or to emptiness.
    fn write(
        &self,
        e: &Evidence,
        observations: &Observations,
        seen: &[Seen],
        own: &mut [f32],
        interrupt: Interrupt,
    ) -> Result<bool> {
        let (mut count, mut excused) = (0u64, 0u64);
        for (i, (s, own)) in seen.iter().zip(own).enumerate() {
            poll_now_and_then(i, interrupt)?;
            let Some(m) = Met::of(e, observations, s) else {
                let place = Observed::nothing(e, s);
                if self.leaves_empty(&place) {
                    *own = self.consensus.displacement(&place) as f32;
                    excused += 1;
                }
                continue;
            };
            match self.side_of(&m) {
                Ordering::Equal => {
                    let residual = self.consensus.residual(&m.observed);
                    let deviation = m.observed.deviation - (1.0 - self.kept) * residual;
                    *own = deviation.abs().max(self.consensus.displacement(&m.observed)) as f32;
                    count += 1;
                }
                Ordering::Greater => excused += 1,
                Ordering::Less => {}
            }
        }
        let (count, all) = (count as f64, seen.len() as f64);
        Ok(count >= LEAST_SHARE * all && count >= MAJORITY * (all - excused as f64))
    }
}

impl BuiltSurface {
    fn of(
        coherent: bool,
        seen: &[Seen],
        own: &[f32],
        heard: &Heard,
        model: &EvidenceModel,
        interrupt: Interrupt,
    ) -> Result<Self> {
        let mut size = Vec::with_capacity(own.len());
        let mut independent = 0.0;
        for (i, (s, d)) in seen.iter().zip(own).enumerate() {
            poll_now_and_then(i, interrupt)?;
            if !d.is_nan() {
                size.push(d.abs());
                independent += f64::from(s.independence);
            }
        }
        let mut quantile = |share: f64| match size.len() {
            0 => 0.0,
            n => f64::from(*size.select_nth_unstable_by(((n as f64 * share) as usize).min(n - 1), f32::total_cmp).1),
        };
        let (most, bulk, half) = (quantile(WITHIN), quantile(BULK), quantile(0.5));
        let random = half.min(MAX_ROUGHNESS_M).powi(2) / independent.max(1.0);
        let sd = (heard.common_variance(model) + random).sqrt();
        Ok(Self { coherent, own: size.len() as u64, independent, quantile: most, bulk, sd })
    }

    /// How likely the surface keeps ±`tolerance` metres in the sense of USIBD.
    pub fn holds(&self, tolerance: f64) -> f64 {
        within(self.quantile, self.sd, tolerance)
    }

    /// Whether most of it more likely keeps ±`tolerance` metres than not, by measurements that can tell.
    pub fn is_known_to_hold(&self, tolerance: f64) -> bool {
        self.coherent && 1.96 * self.sd <= tolerance && within(self.bulk, self.sd, tolerance) >= 0.5
    }
}

/// Probability that what was measured as `deviation` lies within ±`tolerance`.
fn within(deviation: f64, sd: f64, tolerance: f64) -> f64 {
    let below = |x: f64| cdf((x - deviation) / sd.max(1e-9));
    below(tolerance) - below(-tolerance)
}
