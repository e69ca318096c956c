//! What each beam of a patch saw where it would cross the solid, laid out for the samples around.

use super::claims::{Claims, MAX_CLAIM_M};
use super::crossing::Crossing;
use super::foot::Foot;
use super::model::EvidenceModel;
use super::target::Target;
use crate::geometry::{BLUNT_EDGE_COS, Vec3};
use crate::scan::{AngularGrid, View};

/// Fixed-point unit of a weight.
pub const WEIGHT: f64 = 65_536.0;
/// Fixed-point unit of a deviation: 1/131072 m, 7.6 µm.
pub const DEVIATION: f64 = 131_072.0;

/// A beam met an object where it is drawn within this, or within 3 σ, metres.
const AS_DRAWN_M: f64 = 0.01;
/// What stands farther in front of a face than this, or than 3 σ, and is rather another object's hides it, metres …
const HIDDEN_M: f64 = 0.005;
/// … and farther behind it, where that object was drawn, pierced it, metres.
const PIERCED_M: f64 = 0.02;
/// It is another object's where it lies so many times nearer to that one's drawn surface.
const RATHER: f64 = 2.0;

/// What one beam saw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Seen {
    /// A surface this far (fixed-point) in front of the face, measured with this weight.
    Surface(i32, f32),
    /// Empty space, with this weight.
    Through(f32),
}

/// The beams that say something, in the cells of an angular grid by the place that they speak of.
#[derive(Debug)]
pub struct Encounters {
    /// Place on the drawn surface relative to the scanner, metres: x, y and z of all.
    pub places: [Vec<f32>; 3],
    /// Unit normal there, towards the scanner.
    pub normals: Vec<[f32; 3]>,
    pub seen: Vec<Seen>,
    grid: AngularGrid,
    /// Farthest that any place lies from where its beam was aimed, metres.
    pub widest: f64,
}

struct Encounter {
    place: Vec3,
    normal: Vec3,
    seen: Seen,
    uv: [f64; 2],
}

impl Encounters {
    /// Classifies every beam of the view against its crossing; `None` if none has anything to say. `adjust` may take
    /// back some of it; `others` tells of every beam how far (m) another object's drawn surface is from what it met.
    pub fn of(
        view: &View,
        target: &Target,
        crossings: &[Crossing],
        model: &EvidenceModel,
        others: Option<&dyn Fn(usize) -> f64>,
        adjust: impl Fn(Seen) -> Option<Seen>,
    ) -> Option<Self> {
        let (min_cos, noise) = (model.max_incidence.cos(), three_sigma(model));
        let mut widest: f64 = 0.0;
        let mut all = Vec::new();
        for crossing in crossings {
            let slot = crossing.slot as usize;
            let Some(mut e) = encounter(view, target, crossing, min_cos, model) else { continue };
            if let (Some(others), Seen::Surface(d, _)) = (others, e.seen) {
                let (d, other) = (f64::from(d) / DEVIATION, others(slot));
                if RATHER * other < d && d > noise.max(HIDDEN_M) {
                    continue;
                }
                // It passed the face on its way to the other object.
                if RATHER * other < -d && -d > noise.max(PIERCED_M) && other <= noise.max(AS_DRAWN_M) {
                    e.seen = Seen::Through(1.0);
                }
            }
            let Some(seen) = adjust(e.seen) else { continue };
            e.seen = seen;
            widest = widest.max((e.place - view.directions[slot] * crossing.distance).norm());
            all.push(e);
        }
        (!all.is_empty()).then(|| Self::laid_out(&all, f64::from(view.header.step), widest))
    }

    fn laid_out(all: &[Encounter], step: f64, widest: f64) -> Self {
        let image: Vec<[f64; 2]> = all.iter().map(|e| e.uv).collect();
        let (grid, slots) = AngularGrid::sort(&image, step);
        let zeros = || vec![0f32; all.len()];
        let mut out = Self {
            places: [zeros(), zeros(), zeros()],
            normals: vec![[0.0; 3]; all.len()],
            seen: vec![Seen::Through(0.0); all.len()],
            grid,
            widest,
        };
        for (slot, e) in slots.into_iter().zip(all) {
            let slot = slot as usize;
            for k in 0..3 {
                out.places[k][slot] = e.place[k] as f32;
            }
            out.normals[slot] = e.normal.map(|c| c as f32).into();
            out.seen[slot] = e.seen;
        }
        out
    }

    /// Slot ranges that hold all places within the image rectangle (and some around it).
    pub fn slots_in(&self, min: [f64; 2], max: [f64; 2]) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        self.grid.slots_in(min, max)
    }
}

/// Claims for `object` the beams that met something near where it is drawn.
pub fn claim(view: &View, target: &Target, crossings: &[Crossing], object: u32, claims: &mut Claims) {
    for crossing in crossings {
        let slot = crossing.slot as usize;
        let cos = -view.directions[slot].dot(&crossing.normal(target));
        let distance = ((crossing.distance - view.ranges[slot]) * cos).abs() as f32;
        if distance <= MAX_CLAIM_M {
            claims.stake(slot, object, distance);
        }
    }
}

/// Whether a return beside an object, `own` metres from its drawn surface and `other` from another one's, may be the
/// other's.
pub fn may_be_anothers(own: f64, other: f64, model: &EvidenceModel) -> bool {
    other < RATHER * own.max(three_sigma(model)).max(AS_DRAWN_M)
}

fn three_sigma(model: &EvidenceModel) -> f64 {
    3.0 * model.sigma_range.hypot(model.sigma_station)
}

fn encounter(
    view: &View,
    target: &Target,
    crossing: &Crossing,
    min_cos: f64,
    model: &EvidenceModel,
) -> Option<Encounter> {
    let slot = crossing.slot as usize;
    let (t, range, direction) = (crossing.distance, view.ranges[slot], &view.directions[slot]);
    let normal = crossing.normal(target);
    let cos = -direction.dot(&normal);
    if cos < min_cos {
        return None;
    }
    let at =
        |place: Vec3, normal: Vec3, seen: Seen| view.project(&place).map(|uv| Encounter { place, normal, seen, uv });
    let aimed = direction * t;
    if range.is_infinite() {
        let weight = if t <= model.no_return_range { model.no_return_weight } else { 0.0 };
        return if weight > 0.0 { at(aimed, normal, Seen::Through(weight as f32)) } else { None };
    }
    let deviation = (t - range) * cos;
    if deviation > model.band_in_front() {
        return None;
    }
    if deviation < -model.band_behind() {
        return at(aimed, normal, Seen::Through(1.0));
    }
    let share = match (&model.intensity, &view.intensities) {
        (Some(noise), Some(intensities)) => noise.share(intensities[slot]),
        _ => 1.0,
    };
    let fixed = |d: f64| Seen::Surface((d * DEVIATION).round() as i32, share);
    let origin = view.header.origin;
    let met = direction * range + origin;
    if let Some(Foot { triangle, place }) = target.foot(crossing.triangle, &met) {
        let there = crossing.turned(target, triangle);
        // Moved by as much as it is round, its nearest places crowd on few facets and leave the others unheard.
        let near = there.dot(&normal) >= BLUNT_EDGE_COS;
        if let (true, Some(e)) = (near, at(place - origin, there, fixed((met - place).dot(&there)))) {
            return Some(e);
        }
    }
    at(aimed, normal, fixed(deviation))
}
