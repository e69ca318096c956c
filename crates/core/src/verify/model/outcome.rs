//! What each beam of a patch met where it would cross the solid, laid out for the samples around.

use super::ownership::{HIDDEN_M, Ownership, RATHER, ownership, three_sigma};
use super::parameters::EvidenceModel;
use super::surface_sums::DEVIATION;
use crate::geometry::{BLUNT_EDGE_COS, Vec3};
use crate::scan::{AngularGrid, RangeImage};
use crate::verify::aim::{AimedAt, BeamCrossing, Foot, foot};
use crate::{Interrupt, Result, poll_now_and_then};

/// A pane mirrors a sixth of the light and more that comes at 60° and more from its normal (Fresnel, both sides).
const GLANCING_COS: f64 = 0.5;
/// A return farther off the surface at its foot tells of where it was aimed, metres.
const MAX_DEVIATION_M: f64 = 1.0;
/// Parts of an object whose normals differ by less (30°) may be taken for each other where it is displaced.
const PARALLEL_COS: f64 = 0.866;

/// Places that are compared with a sample at once.
pub const LANES: usize = 8;

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
    /// Place on the drawn surface relative to the scanner, metres: x, y and z of all, and [`LANES`] behind them that are
    /// none.
    places_scanner: [Vec<f32>; 3],
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
        interrupt: Interrupt,
    ) -> Result<Option<Self>> {
        let classifier =
            Classifier { view, aimed, model, min_cos: model.max_incidence.cos(), noise: three_sigma(model) };
        let mut widest: f64 = 0.0;
        let mut all = Vec::new();
        for (i, crossing) in aimed.crossings.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            let Some(placed) = classifier.placed(crossing) else { continue };
            let Some(outcome) = classifier.of_this_place(crossing, placed.outcome).and_then(&keep) else { continue };
            let aimed_scanner = view.directions[crossing.slot as usize] * crossing.distance;
            widest = widest.max((placed.place_scanner - aimed_scanner).norm());
            all.push(PlacedOutcome { outcome, ..placed });
        }
        Ok((!all.is_empty()).then(|| Self::laid_out(&all, view.step(), widest)))
    }

    fn laid_out(all: &[PlacedOutcome], step: f64, widest: f64) -> Self {
        let image: Vec<[f64; 2]> = all.iter().map(|e| e.uv).collect();
        let (grid, slots) = AngularGrid::sort(&image, step);
        let zeros = || vec![0f32; all.len() + LANES];
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

    /// x, y and z of the places from a slot on, metres from the scanner.
    #[inline(always)]
    pub fn lanes(&self, first: usize) -> Option<[&[f32; LANES]; 3]> {
        let [xs, ys, zs] = &self.places_scanner;
        Some([xs.get(first..)?.first_chunk()?, ys.get(first..)?.first_chunk()?, zs.get(first..)?.first_chunk()?])
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
    /// What is left of an outcome once every other surface drawn near the return is known: other objects' and the
    /// object's own.
    fn of_this_place(&self, crossing: &BeamCrossing, outcome: BeamOutcome) -> Option<BeamOutcome> {
        let met = match outcome {
            BeamOutcome::Surface { deviation, .. } => Some(f64::from(deviation) / DEVIATION),
            BeamOutcome::SeenThrough { .. } => None,
        };
        let is_behind = met.is_none_or(|deviation| deviation < -self.noise.max(HIDDEN_M));
        if is_behind && (self.may_be_mirrored(crossing) || self.may_pass_beside(crossing)) {
            return None;
        }
        let Some(deviation) = met else { return Some(outcome) };
        let slot = crossing.slot as usize;
        let others = self.aimed.others.map_or(f64::INFINITY, |others| others.deviation(slot));
        match ownership(deviation, others, self.noise) {
            Ownership::MayBeOwn => Some(outcome).filter(|_| !self.is_of_another_part(crossing, deviation)),
            Ownership::Shared | Ownership::Hides => None,
            Ownership::SeenThrough => Some(BeamOutcome::SeenThrough { weight: 1.0 }),
        }
    }

    /// Whether what a beam seems to have met behind a face may be the image of something in the pane before it: where the
    /// pane is met at a glancing angle, and where it ends farther behind than a part would be displaced.
    fn may_be_mirrored(&self, crossing: &BeamCrossing) -> bool {
        let Some(cos) = crossing.pane_cos else { return false };
        let slot = crossing.slot as usize;
        let normal = crossing.normal(self.aimed.target);
        let behind = (crossing.distance - self.view.ranges[slot]) * self.view.directions[slot].dot(&normal);
        cos < GLANCING_COS || behind > self.model.reach
    }

    /// Whether the object, built where it is drawn, may be missed by the beam: then what it met behind says nothing.
    fn may_pass_beside(&self, crossing: &BeamCrossing) -> bool {
        let direction = &self.view.directions[crossing.slot as usize];
        let aimed_world = direction * crossing.distance + self.view.header.origin;
        let within = self.noise.max(HIDDEN_M);
        self.aimed.target.is_near_outline(crossing.triangle, &aimed_world, direction, within)
    }

    /// Whether a return `deviation` metres off the face belongs to another part of the object: it does not say how far
    /// off the face is. A part that is parallel to the face may be the face itself, displaced.
    fn is_of_another_part(&self, crossing: &BeamCrossing, deviation: f64) -> bool {
        let slot = crossing.slot as usize;
        let direction = &self.view.directions[slot];
        if deviation.abs() <= self.noise.max(HIDDEN_M) {
            return false;
        }
        let met_world = direction * self.view.ranges[slot] + self.view.header.origin;
        let nearer = self.aimed.target.met_part(&met_world, direction, deviation.abs() / RATHER);
        nearer.is_some_and(|(_, normal)| {
            let along = normal.dot(&crossing.normal(self.aimed.target)).abs();
            deviation > 0.0 || along < PARALLEL_COS
        })
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
        let deviation = (met_world - place_world).dot(&there);
        let outcome = met(deviation, share);
        if is_near && deviation.abs() <= MAX_DEVIATION_M { self.at(place_world - origin, there, outcome) } else { None }
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

#[cfg(test)]
mod tests {
    use super::super::intensity::IntensityNoise;
    use super::*;
    use crate::NEVER;
    use crate::geometry::Solid;
    use crate::scan::{Beam, Patch};
    use crate::verify::aim::{Claims, Depth, Target, crossings};

    /// A wall whose face is drawn at x = `face`.
    fn wall(face: f64) -> Target {
        Target::new(&Solid::cuboid([face, -60.0, -1.0], [face + 0.2, 60.0, 1.0]).unwrap(), NEVER).unwrap()
    }

    fn view(beam: Beam, intensity: u16) -> RangeImage {
        let header = Patch::encode(0, Vec3::zeros(), 5e-3, 1e-4, &[beam]).unwrap().header().clone();
        RangeImage::with_intensities(header, &[beam], Some(&[intensity]))
    }

    /// What a beam met that is aimed at a wall 3 m away, with another wall where `other` says.
    fn outcomes(beam: Beam, other: Option<f64>, model: &EvidenceModel) -> Option<BeamOutcomes> {
        let (view, target) = (view(beam, 500), wall(3.0));
        let mut claims = Claims::none(view.len());
        if let Some(face) = other {
            let other = wall(face);
            claims.stake_all(&view, &other, &crossings(&other, &view, &Depth::EVERYWHERE, NEVER).unwrap(), 1);
        }
        let crossings = crossings(&target, &view, &Depth::EVERYWHERE, NEVER).unwrap();
        let others = other.map(|_| claims.of_others_than(0));
        BeamOutcomes::of(&view, &AimedAt { target: &target, crossings: &crossings, others }, model, Some, NEVER)
            .unwrap()
    }

    fn at(x: f64) -> Beam {
        Beam { offset: Vec3::new(x, 0.0, 0.0), returned: true }
    }

    fn surface(deviation: f64) -> Option<BeamOutcome> {
        Some(met(deviation, 1.0))
    }

    #[test]
    fn what_a_beam_met() {
        let model = EvidenceModel::default();
        let (front, behind) = (model.band_in_front(), model.band_behind());
        let nothing = |x: f64| Beam { offset: Vec3::new(x, 0.0, 0.0), returned: false };
        let seen_through = |weight: f32| Some(BeamOutcome::SeenThrough { weight });
        let far = EvidenceModel { no_return_range: 2.9, ..model };
        for (beam, other, model, expected, what) in [
            (at(3.0), None, model, surface(0.0), "the face where it is drawn"),
            (at(2.98), None, model, surface(0.02), "in front of it"),
            (at(3.03), None, model, surface(-0.03), "behind it"),
            (at(3.0 - front + 1e-3), None, model, surface(front - 1e-3), "at the end of the band in front"),
            (at(3.0 - front - 1e-3), None, model, None, "hidden"),
            (at(3.0 + behind - 1e-3), None, model, surface(1e-3 - behind), "at the end of the band behind"),
            (at(3.0 + behind + 1e-3), None, model, seen_through(1.0), "seen through"),
            (nothing(3.0), None, model, seen_through(0.25), "no return"),
            (nothing(3.0), None, far, None, "no return, too far to tell"),
            (at(2.95), Some(2.95), model, None, "another object in front"),
            (at(3.05), Some(3.05), model, seen_through(1.0), "another object behind"),
            (at(3.0), Some(3.05), model, surface(0.0), "itself, before another object"),
            (at(3.05), Some(3.15), model, surface(-0.05), "behind, and not at the other object either"),
            (Beam { offset: Vec3::new(3.0, 30.0, 0.0), returned: true }, None, model, None, "too steep"),
            (Beam { offset: Vec3::new(3.0, 0.0, 2.0), returned: true }, None, model, None, "past the wall"),
        ] {
            assert_eq!(outcomes(beam, other, &model).map(|o| o.outcomes[0]), expected, "{what}");
        }
    }

    /// A slanting beam tells of the foot of its return, its deviation is the distance from there.
    #[test]
    fn a_slanting_beam_tells_of_the_foot() {
        let met_scanner = Vec3::new(2.97, 2.0, 0.1);
        let found = outcomes(Beam { offset: met_scanner, returned: true }, None, &EvidenceModel::default()).unwrap();
        assert_eq!(found.outcomes, [met(0.03, 1.0)]);
        let place = found.places_scanner.each_ref().map(|all| f64::from(all[0]));
        assert!((Vec3::from(place) - Vec3::new(3.0, 2.0, 0.1)).norm() < 1e-6, "{place:?}");
        assert_eq!(found.normals, [[-1.0, 0.0, 0.0]]);
        let aimed = met_scanner * (3.0 / met_scanner.x);
        assert!((found.widest - (Vec3::new(3.0, 2.0, 0.1) - aimed).norm()).abs() < 1e-12);
    }

    #[test]
    fn a_dark_beam_is_worth_its_share() {
        let noise = IntensityNoise::new(1000, 1.0).unwrap();
        let model = EvidenceModel { intensity: Some(noise), ..EvidenceModel::default() };
        let found = outcomes(at(3.0), None, &model).unwrap();
        assert_eq!(found.outcomes, [BeamOutcome::Surface { deviation: 0, share: 0.5 }]);
    }

    #[test]
    fn what_is_not_kept_tells_nothing() {
        let (view, target, model) = (view(at(3.0), 0), wall(3.0), EvidenceModel::default());
        let crossings = crossings(&target, &view, &Depth::EVERYWHERE, NEVER).unwrap();
        let aimed = AimedAt { target: &target, crossings: &crossings, others: None };
        assert!(BeamOutcomes::of(&view, &aimed, &model, |_| None, NEVER).unwrap().is_none());
        let weaker = |_| Some(BeamOutcome::SeenThrough { weight: 0.5 });
        let found = BeamOutcomes::of(&view, &aimed, &model, weaker, NEVER).unwrap().unwrap();
        assert_eq!(found.outcomes, [BeamOutcome::SeenThrough { weight: 0.5 }]);
        let slots = found.slots_in([-0.01; 2], [0.01; 2]).flatten().collect::<Vec<_>>();
        assert_eq!(slots, [0]);
    }
}
