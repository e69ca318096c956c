//! One face, as built: how far off it is, whatever the level of accuracy.

use super::compact::CompactDeviation;
use super::fitted_surface::FittedSurface;
use super::observations::Observations;
use crate::geometry::Vec3;
use crate::num::stats::median_and_spread;
use crate::verify::evidence::Evidence;
use crate::verify::model::EvidenceModel;
use crate::{Interrupt, Result, poll, poll_now_and_then};

/// Standard deviation of a median against that of a mean, for a normal sample: √(π/2).
const MEDIAN_SD: f64 = 1.2533;

/// Where one face is.
#[derive(Debug, Clone)]
pub struct FittedFace {
    /// Outward unit normal.
    pub normal: Vec3,
    /// The smooth surface that it is a facet of.
    pub smooth_surface: u32,
    /// All samples.
    pub samples: u64,
    /// Samples at which any surface was seen within the search band.
    pub with_surface: u64,
    /// Most of the seen samples of its surface follow one trend.
    pub coherent: bool,
    /// Median deviation along the outward normal, metres, and its standard deviation.
    pub deviation: Option<(f64, f64)>,
    /// The part of that standard deviation that is the face's own: without registration and model.
    pub random_sd: f64,
    /// Share of each station in that deviation.
    pub stations: Vec<(usize, f64)>,
}

/// What was measured at the samples of a face that count for its deviation.
#[derive(Default)]
struct Measured {
    with_surface: u64,
    deviations: Vec<f64>,
    /// Sum of the variances of the beams' noise, m².
    noise: f64,
    independent: f64,
}

impl FittedFace {
    /// Every face of an object.
    pub fn all(
        e: &Evidence,
        observations: &Observations,
        on_surface: &[CompactDeviation],
        surfaces: &[FittedSurface],
        model: &EvidenceModel,
        interrupt: Interrupt,
    ) -> Result<Vec<Self>> {
        let face = |face: usize| {
            poll(interrupt)?;
            let smooth_surface = e.samples.surface_of_face[face];
            let coherent = surfaces.get(smooth_surface as usize).is_some_and(|s| s.coherent);
            let measured = Measured::at(face, observations, on_surface, coherent, interrupt)?;
            poll(interrupt)?;
            let shares = &observations.stations_of_face[face];
            let (with_surface, common) = (measured.with_surface, shares.common_variance(model));
            let (location, random_sd) = measured.location(coherent);
            let with_sd = |d: f64| (d, (random_sd.powi(2) + common).sqrt().hypot(model.second_order_sd(d)));
            Ok(Self {
                normal: e.samples.normals[face],
                smooth_surface,
                samples: shares.samples,
                with_surface,
                coherent,
                deviation: location.map(with_sd),
                random_sd,
                stations: shares.shares().collect(),
            })
        };
        (0..observations.faces.len()).map(face).collect()
    }
}

impl Measured {
    fn at(
        face: usize,
        observations: &Observations,
        on_surface: &[CompactDeviation],
        coherent: bool,
        interrupt: Interrupt,
    ) -> Result<Self> {
        let run = observations.faces[face].clone();
        let mut out = Self::default();
        for (i, (s, on_surface)) in observations.seen[run.clone()].iter().zip(&on_surface[run]).enumerate() {
            poll_now_and_then(i, interrupt)?;
            let Some((body, deviation)) = observations.surface_body(s) else { continue };
            out.with_surface += 1;
            // Where the surface is known, what else was met there does not count.
            if !coherent || on_surface.is_some() {
                out.deviations.push(deviation);
                out.noise += f64::from(body.random_variance);
                out.independent += f64::from(s.independence);
            }
        }
        Ok(out)
    }

    /// The median deviation, metres, and the standard deviation that is the face's own.
    fn location(mut self, coherent: bool) -> (Option<f64>, f64) {
        let count = self.deviations.len();
        let location = median_and_spread(&mut self.deviations);
        // The median of what is independent; a bent face spreads by its shape, which is not noise.
        let scatter = if coherent { self.noise / count.max(1) as f64 } else { location.map_or(0.0, |l| l.1.powi(2)) };
        let random_sd = MEDIAN_SD * (scatter / f64::max(self.independent, 1.0)).sqrt();
        (location.map(|l| l.0), random_sd)
    }
}
