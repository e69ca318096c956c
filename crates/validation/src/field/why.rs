//! Why a place is not seen, as an ideal observer knows it: by rays in the scene as it stood.

use asbuilt_core::verify::Why;

use super::observer::{Look, MAX_INCIDENCE, Outcome, Sight};
use super::samples::Sample;
use super::scene::Scene;

/// A reason, or a hiding object, is right that has this share of the one with the largest: which of two like ones is
/// named does not matter.
const AS_GOOD: f64 = 0.8;

/// What kept the stations from a place: of all stations the least that had to change for it to be seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Kept {
    pub why: Why,
    /// By whose surface.
    pub by: Option<u32>,
}

/// What kept all stations from the drawn place of a sample.
pub fn kept(scene: &Scene, number: usize, sample: &Sample, is_shared: bool) -> Kept {
    let objects = scene.layout.objects.len() as u32;
    let (mut best, mut nearest) = ((5, Kept { why: Why::NotLookedAt, by: None }), f64::INFINITY);
    for (i, station) in scene.stations.iter().enumerate() {
        let both_sides = !scene.layout.objects[number].is_closed;
        let look = Look { scene, view: scene.view(i), eye: station.place, both_sides };
        let Some(sight) = look.towards(&sample.place, &sample.normal) else { continue };
        let is_pane = scene.layout.objects[number].transparent[sample.triangle];
        let (order, kept) = of_station(&look, &sight, [is_shared, is_pane], objects);
        let is_nearer = order == 4 && best.0 == 4 && sight.range < nearest;
        if order < best.0 || is_nearer {
            (best, nearest) = ((order, kept), sight.range);
        }
    }
    best.1
}

fn of_station(look: &Look<'_>, sight: &Sight, [is_shared, is_pane]: [bool; 2], objects: u32) -> (u8, Kept) {
    let plain = |why| Kept { why, by: None };
    match look.outcome(sight) {
        Outcome::Hidden(by) if by < objects => (4, Kept { why: Why::HiddenByObject, by: Some(by) }),
        Outcome::Hidden(_) => (4, plain(Why::HiddenByOther)),
        _ if sight.cos < MAX_INCIDENCE.cos() => (3, plain(Why::TooSteep)),
        Outcome::There | Outcome::Past if is_shared => (0, plain(Why::SharedFace)),
        // Whether it stands there or not.
        Outcome::Through if is_pane => (2, plain(Why::NoReturn)),
        Outcome::There | Outcome::Past | Outcome::Through => (1, plain(Why::TooFew)),
        Outcome::Nothing => (2, plain(Why::NoReturn)),
    }
}

/// What was said of why an object is unobserved, against what kept its samples.
#[derive(Debug, Clone, Copy)]
pub struct ReasonSaid {
    pub said: Why,
    /// Share of the samples with the reason that was said, and the largest of all shares.
    pub share: f64,
    pub largest: f64,
    /// Where an object was named that hides it: whether it is the one, or as good as it.
    pub hider_is_right: Option<bool>,
}

impl ReasonSaid {
    /// Of an object with these samples.
    pub fn of(said: Why, hidden_by: Option<u32>, truth: &[Kept]) -> Self {
        let count = |is: &dyn Fn(&Kept) -> bool| truth.iter().filter(|k| is(k)).count() as f64;
        let all = truth.len().max(1) as f64;
        let largest = Why::ALL.into_iter().map(|why| count(&|k| k.why == why)).fold(0.0, f64::max);
        let by = |object: Option<u32>| count(&|k| k.by.is_some() && k.by == object);
        let most = truth.iter().filter_map(|k| k.by).map(|o| by(Some(o))).fold(0.0, f64::max);
        let names_one = said == Why::HiddenByObject;
        Self {
            said,
            share: count(&|k| k.why == said) / all,
            largest: largest / all,
            hider_is_right: names_one.then(|| by(hidden_by) >= AS_GOOD * most && most > 0.0),
        }
    }

    /// Whether it is the reason, or as good as it.
    pub fn is_right(&self) -> bool {
        self.share >= AS_GOOD * self.largest
    }
}
