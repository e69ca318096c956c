//! Which of the seen samples show the object's own surface, and how far off it is there.

use super::consensus::{Consensus, Observed};
use super::evidence::Evidence;
use super::model::EvidenceModel;
use super::observe::{Heard, Observations, Seen};
use crate::num::normal::cdf;
use crate::num::stats::median;
use crate::{Interrupt, Result, poll, poll_now_and_then};

/// Share of a surface's seen samples that must follow one course for that course to be the built surface.
const MAJORITY: f64 = 0.5;
/// A sample follows the course within so many σ, of its own or of all.
const AGREES_SIGMAS: f64 = 3.0;
/// … but no farther off than this, metres: rough surfaces, not clutter.
const MAX_ROUGHNESS_M: f64 = 0.015;
const MIN_ROUGHNESS_M: f64 = 0.001;
/// A surface that was met in front of the drawn one is the built one only where this share of it was seen: of an edge
/// that a neighbour covers, a strip beside the neighbour's end is.
const BARED: f64 = 0.25;
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
    /// For each seen sample the deviation of the object's own surface, metres; NaN where it is not seen.
    pub own: Vec<f32>,
    /// For each smooth surface.
    pub surfaces: Vec<BuiltSurface>,
    /// All of them as one.
    pub whole: BuiltSurface,
}

impl Built {
    /// Fits every smooth surface of the object.
    pub fn of(e: &Evidence, model: &EvidenceModel, interrupt: Interrupt) -> Result<Self> {
        let observations = Observations::of(e, model, interrupt)?;
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
            let fit = fit(e, &observations, run, heard, interrupt)?;
            let coherent = fit.is_some();
            if let Some(fit) = fit {
                own[run.clone()].copy_from_slice(&fit);
            }
            surfaces.push(BuiltSurface::of(coherent, &observations.seen[run.clone()], &own[run.clone()], heard, model));
            all.add(heard);
        }
        let coherent = surfaces.iter().any(|s| s.coherent);
        let whole = BuiltSurface::of(coherent, &observations.seen, &own, &all, model);
        Ok(Self { observations, own, surfaces, whole })
    }
}

/// The samples of one smooth surface that follow its course, with their deviations; `None` where most do not.
fn fit(
    e: &Evidence,
    observations: &Observations,
    run: &std::ops::Range<usize>,
    heard: &Heard,
    interrupt: Interrupt,
) -> Result<Option<Vec<f32>>> {
    let observed = |s: &Seen| {
        let body = observations.surface_body(s)?;
        let deviation = f64::from(body.deviation);
        let o = Observed { position: Observations::position(s), normal: e.samples.normals[s.face as usize], deviation };
        // However unsure of itself, what lies far off the course does not confirm it.
        let reach =
            (AGREES_SIGMAS * body.sd()).min(MAX_ROUGHNESS_M + AGREES_SIGMAS * f64::from(body.common_variance).sqrt());
        Some((o, reach, f64::from(body.random_variance)))
    };
    let seen = &observations.seen[run.clone()];
    let mut met = Vec::with_capacity(seen.len());
    for (i, s) in seen.iter().enumerate() {
        poll_now_and_then(i, interrupt)?;
        met.push(observed(s));
    }
    let surface: Vec<Observed> = met.iter().flatten().map(|m| m.0).collect();
    let Some(course) = Consensus::fit(&surface, interrupt)? else { return Ok(None) };
    let scatter = (AGREES_SIGMAS * course.spread).clamp(MIN_ROUGHNESS_M, MAX_ROUGHNESS_M);
    let agrees = |(o, reach, _): &(Observed, f64, f64)| course.residual(o).abs() <= reach.max(scatter);
    let following: Vec<bool> = met.iter().map(|m| m.as_ref().is_some_and(agrees)).collect();
    let own = || met.iter().zip(&following).filter(|(_, f)| **f).filter_map(|(m, _)| m.as_ref());
    let count = own().count();
    if (count as f64) < MAJORITY * seen.len() as f64 || !course.is_surface(own().map(|m| &m.0)) {
        return Ok(None);
    }
    let centre = median(&mut own().map(|m| course.at(&m.0)).collect::<Vec<_>>()).unwrap_or(0.0);
    if centre > MAX_ROUGHNESS_M && (seen.len() as f64) < BARED * heard.samples as f64 {
        return Ok(None);
    }
    let noise = median(&mut own().map(|m| m.2).collect::<Vec<_>>()).unwrap_or(0.0);
    // Of what a sample differs from the course, so much is the surface's and not the measurement's.
    let kept = 1.0 - noise / course.spread.powi(2).max(noise).max(1e-12);
    let deviation = |(m, follows): (&Option<(Observed, f64, f64)>, &bool)| match m {
        Some((o, ..)) if *follows => (course.at(o) + kept * course.residual(o)) as f32,
        _ => f32::NAN,
    };
    Ok(Some(met.iter().zip(&following).map(deviation).collect()))
}

impl BuiltSurface {
    fn of(coherent: bool, seen: &[Seen], own: &[f32], heard: &Heard, model: &EvidenceModel) -> Self {
        let on = || seen.iter().zip(own).filter(|(_, d)| !d.is_nan());
        let independent: f64 = on().map(|(s, _)| f64::from(s.independence)).sum();
        let mut size: Vec<f32> = on().map(|(_, d)| d.abs()).collect();
        let mut quantile = |share: f64| match size.len() {
            0 => 0.0,
            n => f64::from(*size.select_nth_unstable_by(((n as f64 * share) as usize).min(n - 1), f32::total_cmp).1),
        };
        let (most, bulk) = (quantile(WITHIN), quantile(BULK));
        let spread = median(&mut on().map(|(_, d)| f64::from(d.abs())).collect::<Vec<_>>()).unwrap_or(0.0);
        let random = spread.min(MAX_ROUGHNESS_M).powi(2) / independent.max(1.0);
        let sd = (heard.common_variance(model) + random).sqrt();
        Self { coherent, own: size.len() as u64, independent, quantile: most, bulk, sd }
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
