//! Which of the seen samples of a smooth surface follow one trend.

use std::cmp::Ordering;

use super::basis::DeviationSample;
use super::compact::CompactDeviation;
use super::fitted_surface::MAX_ROUGHNESS_M;
use super::observations::{Observations, SeenSample};
use super::trend::DeviationTrend;
use crate::num::stats::median;
use crate::verify::evidence::Evidence;
use crate::{Interrupt, Result, poll_now_and_then};

/// Share of a surface's seen samples that must follow one trend for that trend to be the built surface, of those that
/// nothing in front of it hides.
const MAJORITY: f64 = 0.5;
/// Share of all of a surface's seen samples that must follow one trend for that trend to be the built surface.
const MIN_SHARE: f64 = 0.2;
/// A sample follows the trend within so many σ, of its own or of all; but no farther off than [`MAX_ROUGHNESS_M`].
const AGREES_SIGMAS: f64 = 3.0;
/// Samples that are no farther off follow the trend, however precise they are, metres.
const MIN_ROUGHNESS_M: f64 = 0.001;
/// Where the neighbours are not known, a surface that was met in front of the drawn one is the built one only if this
/// share of it was seen: of an edge that a neighbour covers, a strip beside the neighbour's end is.
const EXPOSED: f64 = 0.25;
/// Samples by which a trend is judged, at the most; spread evenly over the surface.
const MAX_JUDGED: usize = 20_000;

/// The trend of one smooth surface, as its seen samples show it.
pub struct SurfaceTrend {
    band: Band,
    /// Its median deviation over the samples that follow it, metres.
    centre: f64,
    /// Of what a sample differs from the trend, so much is the surface's and not the measurement's.
    kept: f64,
}

/// A trend, and what follows it.
struct Band {
    trend: DeviationTrend,
    /// What lies no farther off follows it however precise it is, metres.
    scatter: f64,
}

/// A sample at which a surface was met.
struct MeasuredSample {
    sample: DeviationSample,
    /// It may follow a trend that is no farther off, metres.
    reach: f64,
    random_variance: f64,
}

/// The place of a sample, as drawn.
fn as_designed(e: &Evidence, s: &SeenSample) -> DeviationSample {
    DeviationSample { position_local: s.position(), normal: e.samples.normals[s.face as usize], deviation: 0.0 }
}

impl MeasuredSample {
    fn of(e: &Evidence, observations: &Observations, s: &SeenSample) -> Option<Self> {
        let (body, deviation) = observations.surface_body(s)?;
        let common = AGREES_SIGMAS * f64::from(body.common_variance).sqrt();
        Some(Self {
            sample: DeviationSample { deviation, ..as_designed(e, s) },
            // However unsure of itself, what lies far off the trend does not confirm it.
            reach: (AGREES_SIGMAS * body.sd()).min(MAX_ROUGHNESS_M + common),
            random_variance: f64::from(body.random_variance),
        })
    }
}

impl Band {
    /// Whether a sample lies behind the trend, follows it, or stands in front of it.
    fn side_of(&self, m: &MeasuredSample) -> Ordering {
        let (residual, reach) = (self.trend.residual(&m.sample), m.reach.max(self.scatter));
        if residual.abs() <= reach { Ordering::Equal } else { residual.total_cmp(&0.0) }
    }

    /// Whether a lateral surface with this trend is missed here by beams aimed at the drawn one: its lee side.
    fn leaves_empty(&self, place: &DeviationSample) -> bool {
        self.trend.is_curved() && self.trend.at(place) < -self.scatter
    }
}

impl SurfaceTrend {
    /// The trend that most of the seen samples of a surface of `samples` follow; `None` where they do not.
    pub fn of(
        e: &Evidence,
        observations: &Observations,
        seen: &[SeenSample],
        samples: u64,
        interrupt: Interrupt,
    ) -> Result<Option<Self>> {
        let few: Vec<MeasuredSample> = seen
            .iter()
            .step_by(seen.len().div_ceil(MAX_JUDGED).max(1))
            .filter_map(|s| MeasuredSample::of(e, observations, s))
            .collect();
        let few: Vec<&MeasuredSample> = few.iter().collect();
        let Some(first) = Self::through(&few, interrupt)? else { return Ok(None) };
        let chosen = first.or_behind(&few, interrupt)?;
        let exposed = seen.len() as f64 >= EXPOSED * samples as f64;
        let displaced_forwards = chosen.centre > MAX_ROUGHNESS_M;
        Ok((exposed || e.knows_neighbours || !displaced_forwards).then_some(chosen))
    }

    /// This trend, or one behind it: what hides a face stands in front of it, and is not the face.
    fn or_behind(self, few: &[&MeasuredSample], interrupt: Interrupt) -> Result<Self> {
        if self.centre <= MAX_ROUGHNESS_M {
            return Ok(self);
        }
        let behind: Vec<&MeasuredSample> = few.iter().copied().filter(|m| self.band.side_of(m).is_lt()).collect();
        if (behind.len() as f64) < MIN_SHARE * few.len() as f64 {
            return Ok(self);
        }
        let rear = Self::through(&behind, interrupt)?;
        Ok(rear.filter(|rear| rear.centre.abs() < self.centre).unwrap_or(self))
    }

    /// The trend that most of these follow; `None` where it could not be a built surface.
    fn through(measured: &[&MeasuredSample], interrupt: Interrupt) -> Result<Option<Self>> {
        let samples: Vec<DeviationSample> = measured.iter().map(|m| m.sample).collect();
        let Some(trend) = DeviationTrend::fit(&samples, interrupt)? else { return Ok(None) };
        let scatter = (AGREES_SIGMAS * trend.spread).clamp(MIN_ROUGHNESS_M, MAX_ROUGHNESS_M);
        let band = Band { trend, scatter };
        let inliers: Vec<&MeasuredSample> = measured.iter().copied().filter(|m| band.side_of(m).is_eq()).collect();
        if !band.trend.is_surface(inliers.iter().map(|m| &m.sample)) {
            return Ok(None);
        }
        let middle = |of: &dyn Fn(&MeasuredSample) -> f64| {
            median(&mut inliers.iter().map(|m| of(m)).collect::<Vec<_>>()).unwrap_or(0.0)
        };
        let noise = middle(&|m| m.random_variance);
        let centre = middle(&|m| band.trend.at(&m.sample));
        let kept = 1.0 - noise / band.trend.spread.powi(2).max(noise).max(1e-12);
        Ok(Some(Self { band, centre, kept }))
    }

    /// For every sample how far off the surface is, if it follows; `None` where most do not, but for those that the
    /// trend leaves to what stands in front or to emptiness.
    pub fn deviations(
        &self,
        e: &Evidence,
        observations: &Observations,
        seen: &[SeenSample],
        interrupt: Interrupt,
    ) -> Result<Option<Vec<CompactDeviation>>> {
        let (mut count, mut excused) = (0u64, 0u64);
        let mut out = Vec::with_capacity(seen.len());
        for (i, s) in seen.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            let (deviation, side) = match MeasuredSample::of(e, observations, s) {
                Some(m) => self.deviation_of(&m),
                None => self.deviation_of_nothing(&as_designed(e, s)),
            };
            count += u64::from(side.is_eq());
            excused += u64::from(side.is_gt());
            out.push(deviation);
        }
        let (count, all) = (count as f64, seen.len() as f64);
        let coherent = count >= MIN_SHARE * all && count >= MAJORITY * (all - excused as f64);
        Ok(coherent.then_some(out))
    }

    /// How far off the surface is at a sample that follows; and whether one does, or stands before it or behind it.
    fn deviation_of(&self, m: &MeasuredSample) -> (CompactDeviation, Ordering) {
        let side = self.band.side_of(m);
        if side.is_ne() {
            return (CompactDeviation::NONE, side);
        }
        let trend = &self.band.trend;
        let residual = trend.residual(&m.sample);
        let deviation = m.sample.deviation - (1.0 - self.kept) * residual;
        (CompactDeviation::new(deviation.abs().max(trend.displacement(&m.sample))), side)
    }

    /// The same where no surface was met: the lee side of what is displaced is no reason against the trend.
    fn deviation_of_nothing(&self, place: &DeviationSample) -> (CompactDeviation, Ordering) {
        if self.band.leaves_empty(place) {
            (CompactDeviation::new(self.band.trend.displacement(place)), Ordering::Greater)
        } else {
            (CompactDeviation::NONE, Ordering::Less)
        }
    }
}
