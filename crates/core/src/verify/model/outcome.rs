//! What each beam of a patch met where it would cross the solid, laid out for the samples around.

use super::ownership::{Ownership, ownership, three_sigma};
use super::parameters::EvidenceModel;
use super::surface_sums::DEVIATION;
use crate::geometry::{BLUNT_EDGE_COS, Vec3};
use crate::scan::{AngularGrid, RangeImage};
use crate::verify::aim::{AimedAt, BeamCrossing, Foot, foot};

/// What one beam met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BeamOutcome {
    /// A surface so far in front of the face (fixed point; towards the scanner), worth this share of a bright beam.
    Surface { deviation: i32, share: f32 },
    /// Empty space where the face is drawn, with this weight.
    SeenThrough { weight: f32 },
}

/// The beams that tell something, in the cells of an angular grid by the place that they tell of.
#[derive(Debug)]
pub struct BeamOutcomes {
    /// Place on the drawn surface relative to the scanner, metres: x, y and z of all.
    pub places_scanner: [Vec<f32>; 3],
    /// Unit normal there, towards the scanner.
    pub normals: Vec<[f32; 3]>,
    pub outcomes: Vec<BeamOutcome>,
    grid: AngularGrid,
    /// Farthest that any place lies from where its beam was aimed, metres.
    pub widest: f64,
}

/// One beam's outcome, and the place of which it tells.
struct PlacedOutcome {
    place_scanner: Vec3,
    normal: Vec3,
    outcome: BeamOutcome,
    /// The place in the image.
    uv: [f64; 2],
}

impl BeamOutcomes {
    /// Classifies every beam of the view against its crossing; `None` if none tells anything. `keep` may take back
    /// some of it.
    pub fn of(
        view: &RangeImage,
        aimed: &AimedAt<'_>,
        model: &EvidenceModel,
        keep: impl Fn(BeamOutcome) -> Option<BeamOutcome>,
    ) -> Option<Self> {
        let classifier =
            Classifier { view, aimed, model, min_cos: model.max_incidence.cos(), noise: three_sigma(model) };
        let mut widest: f64 = 0.0;
        let mut all = Vec::new();
        for crossing in aimed.crossings {
            let Some(placed) = classifier.placed(crossing) else { continue };
            let Some(outcome) = classifier.of_this_object(crossing, placed.outcome).and_then(&keep) else { continue };
            let aimed_scanner = view.directions[crossing.slot as usize] * crossing.distance;
            widest = widest.max((placed.place_scanner - aimed_scanner).norm());
            all.push(PlacedOutcome { outcome, ..placed });
        }
        (!all.is_empty()).then(|| Self::laid_out(&all, f64::from(view.header.step), widest))
    }

    fn laid_out(all: &[PlacedOutcome], step: f64, widest: f64) -> Self {
        let image: Vec<[f64; 2]> = all.iter().map(|e| e.uv).collect();
        let (grid, slots) = AngularGrid::sort(&image, step);
        let zeros = || vec![0f32; all.len()];
        let mut places_scanner = [zeros(), zeros(), zeros()];
        let mut normals = vec![[0.0; 3]; all.len()];
        let mut outcomes = vec![BeamOutcome::SeenThrough { weight: 0.0 }; all.len()];
        for (e, slot) in all.iter().zip(slots) {
            let slot = slot as usize;
            for (all, one) in places_scanner.iter_mut().zip(&e.place_scanner) {
                all[slot] = *one as f32;
            }
            normals[slot] = e.normal.map(|c| c as f32).into();
            outcomes[slot] = e.outcome;
        }
        Self { places_scanner, normals, outcomes, grid, widest }
    }

    /// Slot ranges that hold all places within the image rectangle (and some around it).
    /// In the image plane at unit distance from the scanner.
    pub fn slots_in(&self, min: [f64; 2], max: [f64; 2]) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        self.grid.slots_in(min, max)
    }
}

/// What decides about the beams of one view.
struct Classifier<'a> {
    view: &'a RangeImage,
    aimed: &'a AimedAt<'a>,
    model: &'a EvidenceModel,
    /// Of the steepest admitted incidence.
    min_cos: f64,
    /// Three sigmas of a beam, metres.
    noise: f64,
}

impl Classifier<'_> {
    /// What is left of an outcome where other objects are known.
    fn of_this_object(&self, crossing: &BeamCrossing, outcome: BeamOutcome) -> Option<BeamOutcome> {
        let (Some(others), BeamOutcome::Surface { deviation, .. }) = (self.aimed.others, outcome) else {
            return Some(outcome);
        };
        match ownership(f64::from(deviation) / DEVIATION, others.distance(crossing.slot as usize), self.noise) {
            Ownership::MayBeOwn => Some(outcome),
            Ownership::Hides => None,
            Ownership::SeenThrough => Some(BeamOutcome::SeenThrough { weight: 1.0 }),
        }
    }

    /// What the beam met, with the place of which it tells; `None` where it tells nothing.
    fn placed(&self, crossing: &BeamCrossing) -> Option<PlacedOutcome> {
        let (view, model) = (self.view, self.model);
        let slot = crossing.slot as usize;
        let (t, range, direction) = (crossing.distance, view.ranges[slot], &view.directions[slot]);
        let normal = crossing.normal(self.aimed.target);
        let cos = -direction.dot(&normal);
        if cos < self.min_cos {
            return None;
        }
        let aimed_scanner = direction * t;
        if range.is_infinite() {
            let weight = if t <= model.no_return_range { model.no_return_weight } else { 0.0 };
            let empty = || self.at(aimed_scanner, normal, BeamOutcome::SeenThrough { weight: weight as f32 });
            return if weight > 0.0 { empty() } else { None };
        }
        let deviation = (t - range) * cos;
        if deviation > model.band_in_front() {
            return None;
        }
        if deviation < -model.band_behind() {
            return self.at(aimed_scanner, normal, BeamOutcome::SeenThrough { weight: 1.0 });
        }
        let share = self.share(slot);
        let at_foot = self.at_foot(crossing, &normal, share);
        at_foot.or_else(|| self.at(aimed_scanner, normal, met(deviation, share)))
    }

    /// A surface, told of at the foot of the return; `None` where the drawn surface has none near.
    fn at_foot(&self, crossing: &BeamCrossing, normal: &Vec3, share: f32) -> Option<PlacedOutcome> {
        let (target, origin) = (self.aimed.target, self.view.header.origin);
        let slot = crossing.slot as usize;
        let met_world = self.view.directions[slot] * self.view.ranges[slot] + origin;
        let Foot { triangle, place_world } = foot(target, crossing.triangle, &met_world)?;
        let there = crossing.turned(target, triangle);
        // Moved by as much as it is round, its nearest places crowd on few facets and leave the others without beams.
        let is_near = there.dot(normal) >= BLUNT_EDGE_COS;
        let outcome = met((met_world - place_world).dot(&there), share);
        if is_near { self.at(place_world - origin, there, outcome) } else { None }
    }

    /// What this beam is worth beside a bright one.
    fn share(&self, slot: usize) -> f32 {
        match (&self.model.intensity, &self.view.intensities) {
            (Some(noise), Some(intensities)) => noise.share(intensities[slot]),
            _ => 1.0,
        }
    }

    fn at(&self, place_scanner: Vec3, normal: Vec3, outcome: BeamOutcome) -> Option<PlacedOutcome> {
        let uv = self.view.project(&place_scanner)?;
        Some(PlacedOutcome { place_scanner, normal, outcome, uv })
    }
}

fn met(deviation: f64, share: f32) -> BeamOutcome {
    BeamOutcome::Surface { deviation: (deviation * DEVIATION).round() as i32, share }
}
