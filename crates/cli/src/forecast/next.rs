//! Where one more station would see most of what is still unseen.

use asbuilt_core::geometry::{Aabb, Vec3};
use asbuilt_core::verify::{EvidenceModel, PlannedStation};
use rayon::prelude::*;

use super::room::Room;

/// Most places that are tried; on a large site the grid is wider.
const MAX_CANDIDATES: f64 = 900.0;
/// Samples by which they are judged.
const MAX_JUDGES: usize = 12_000;

/// A sample that no station sees yet, with the area that it represents.
#[derive(Debug, Clone, Copy)]
pub struct Unseen {
    pub position: Vec3,
    pub normal: Vec3,
    /// Square metres.
    pub area: f64,
}

/// A place and the area that becomes visible from it, square metres.
#[derive(Debug, Clone, Copy)]
pub struct Candidate {
    pub origin: Vec3,
    pub gain: f64,
}

/// The best of a grid of places at this height above the building's foot; `None` where no place sees anything new.
pub fn best_place(
    room: &Room,
    bounds: &Aabb,
    unseen: &[Unseen],
    like: &PlannedStation,
    height: f64,
    grid: f64,
    model: &EvidenceModel,
) -> Option<Candidate> {
    let stride = unseen.len().div_ceil(MAX_JUDGES).max(1);
    let judges: Vec<&Unseen> = unseen.iter().step_by(stride).collect();
    let gain = |origin: Vec3| {
        let station = PlannedStation { origin, ..*like };
        let sees = |u: &&&Unseen| station.faces(&u.position, &u.normal, model) && room.is_free(&origin, &u.position);
        Candidate { origin, gain: judges.iter().filter(sees).map(|u| u.area).sum::<f64>() * stride as f64 }
    };
    let better = |a: Candidate, b: Candidate| if b.gain > a.gain { b } else { a };
    let nothing = || Candidate { origin: Vec3::zeros(), gain: 0.0 };
    let places = places(bounds, height, grid);
    let best = places.into_par_iter().filter(|p| room.can_stand(p)).map(gain).reduce(nothing, better);
    (best.gain > 0.0).then_some(best)
}

fn places(bounds: &Aabb, height: f64, grid: f64) -> Vec<Vec3> {
    let extent = [0, 1].map(|k| bounds.max[k] - bounds.min[k]);
    let step = grid.max((extent[0] * extent[1] / MAX_CANDIDATES).sqrt());
    let count = extent.map(|e| (e / step).ceil().max(1.0));
    let at = |k: usize, i: u32| bounds.min[k] + (f64::from(i) + 0.5) * extent[k] / count[k];
    (0..count[0] as u32)
        .flat_map(|i| (0..count[1] as u32).map(move |j| (i, j)))
        .map(|(i, j)| Vec3::new(at(0, i), at(1, j), bounds.min[2] + height))
        .collect()
}
