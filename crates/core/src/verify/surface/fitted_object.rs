//! Which of the seen samples show the object's own surface, and how far off it is there.

use super::compact::CompactDeviation;
use super::fitted_face::FittedFace;
use super::fitted_surface::FittedSurface;
use super::observations::{Observations, SeenSample};
use super::station_shares::StationShares;
use super::surface_trend::SurfaceTrend;
use crate::verify::evidence::{Evidence, FoundFace};
use crate::verify::model::EvidenceModel;
use crate::{Interrupt, Result, poll, room};

/// The seen samples and the built surfaces that they show. Holds for every level of accuracy.
#[derive(Debug)]
pub struct FittedObject {
    pub observations: Observations,
    /// For each seen sample how far off the object's own surface is, metres; none where it is not seen.
    pub on_surface: Vec<CompactDeviation>,
    /// For each smooth surface.
    pub surfaces: Vec<FittedSurface>,
    /// All of them as one.
    pub whole: FittedSurface,
    /// For each face where it is.
    pub faces: Vec<FittedFace>,
    /// Displaced by its own thickness, no beam aimed at the object meets it.
    pub is_slim: bool,
    /// Samples in front of which something stands that is not the object's own surface.
    pub in_front_unexplained: u64,
    /// The face that a second look found elsewhere.
    pub found: Option<FoundFace>,
}

impl FittedObject {
    /// Fits every smooth surface of the object.
    pub fn of(e: &Evidence, model: &EvidenceModel, interrupt: Interrupt) -> Result<Self> {
        let observations = Observations::of(e, model, interrupt)?;
        // What a trend is fitted through: a place and a deviation a sample.
        room::<[f64; 6]>(observations.seen.len(), interrupt)?;
        let shares = shares_by_surface(e, &observations);
        let mut on_surface = Vec::with_capacity(observations.seen.len());
        let mut surfaces = Vec::with_capacity(shares.len());
        let mut all = StationShares::default();
        // The runs of the surfaces follow each other.
        for (run, shares) in observations.surfaces.iter().zip(&shares) {
            poll(interrupt)?;
            let seen = &observations.seen[run.clone()];
            let found = match SurfaceTrend::of(e, &observations, seen, shares.samples, interrupt)? {
                Some(trend) => trend.deviations(e, &observations, seen, interrupt)?,
                None => None,
            };
            let coherent = found.is_some();
            let deviations = found.unwrap_or_else(|| vec![CompactDeviation::NONE; seen.len()]);
            surfaces.push(FittedSurface::of(coherent, seen, &deviations, shares, model, interrupt)?);
            on_surface.extend(deviations);
            all.add(shares);
        }
        let coherent = surfaces.iter().any(|s| s.coherent);
        let whole = FittedSurface::of(coherent, &observations.seen, &on_surface, &all, model, interrupt)?;
        let unexplained = |(s, on_surface): &(&SeenSample, &CompactDeviation)| {
            !on_surface.is_some() && observations.surface_body(s).is_some_and(|(_, d)| d > 0.0)
        };
        let seen_in_front = observations.seen.iter().zip(&on_surface).filter(unexplained).count() as u64;
        let in_front_unexplained = observations.in_front_unseen + seen_in_front;
        let faces = FittedFace::all(e, &observations, &on_surface, &surfaces, model, interrupt)?;
        let is_slim = e.samples.is_slim();
        Ok(Self { observations, on_surface, surfaces, whole, faces, is_slim, in_front_unexplained, found: e.found })
    }
}

/// For each smooth surface its samples and the stations of all its faces.
fn shares_by_surface(e: &Evidence, observations: &Observations) -> Vec<StationShares> {
    let mut out = vec![StationShares::default(); observations.surfaces.len()];
    for (face, surface) in e.samples.surface_of_face.iter().enumerate() {
        if let Some(shares) = out.get_mut(*surface as usize) {
            shares.add(&observations.stations_of_face[face]);
        }
    }
    out
}
