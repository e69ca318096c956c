//! What becomes of an object between two epochs.

use asbuilt_core::geometry::Vec3;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::field::fate::{self, Cut, Fate, displacement, fate_of};
use crate::field::layout::{Layout, Object};

/// Of an object that was built in part, this share of its longest side stands.
const BUILT: std::ops::Range<f64> = 0.25..0.75;

/// What was done to an object between the epochs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Done {
    /// Nothing; it stands.
    Stands,
    /// Nothing; it is missing.
    Missing,
    Appeared,
    Gone,
    Moved,
    /// More of it stands, or less.
    Partly,
    /// A door whose leaf stands otherwise.
    Turned,
}

impl Done {
    /// All of them.
    pub const ALL: [Self; 7] =
        [Self::Stands, Self::Missing, Self::Appeared, Self::Gone, Self::Moved, Self::Partly, Self::Turned];

    /// In words.
    pub fn name(self) -> &'static str {
        ["stands as before", "missing as before", "appeared", "gone", "moved", "in part", "door turned"][self as usize]
    }
}

/// What was done to an object, and its fate in both epochs.
#[derive(Debug, Clone)]
pub struct Deed {
    pub done: Done,
    pub fates: [Fate; 2],
}

/// For every object of a building.
pub fn deeds(layout: &Layout, rng: &mut ChaCha8Rng) -> Vec<Deed> {
    layout.objects.iter().map(|o| deed(o, rng)).collect()
}

fn done(object: &Object, rng: &mut ChaCha8Rng) -> Done {
    let dice = rng.random_range(0..100);
    match dice {
        _ if object.class == "IfcSite" => Done::Stands,
        0..30 if object.can_open() => Done::Turned,
        0..50 => Done::Stands,
        50..55 => Done::Missing,
        55..67 => Done::Appeared,
        67..79 => Done::Gone,
        79..91 => Done::Moved,
        _ => Done::Partly,
    }
}

fn deed(object: &Object, rng: &mut ChaCha8Rng) -> Deed {
    let done = done(object, rng);
    // One in ten of those that stand does so elsewhere than drawn.
    let stands = if rng.random_bool(0.1) { fate::Deed::Displaced } else { fate::Deed::AsDrawn };
    let there = fate_of(stands, object, rng);
    let missing = Fate { deed: fate::Deed::Missing, ..there.clone() };
    let swaps = rng.random_bool(0.5);
    let fates = match done {
        Done::Stands => [there.clone(), there],
        Done::Missing => [missing.clone(), missing],
        Done::Appeared => [missing, there],
        Done::Gone => [there, missing],
        Done::Moved => {
            let by = displacement(object, rng);
            let moved = Fate {
                deed: fate::Deed::Displaced,
                displaced: there.displaced + by,
                shift: there.shift + by,
                ..there.clone()
            };
            if swaps { [moved, there] } else { [there, moved] }
        }
        Done::Partly => {
            let part = Fate { cut: Some(cut(object, rng)), ..there.clone() };
            if swaps { [part, there] } else { [there, part] }
        }
        Done::Turned => {
            let open = fate_of(fate::Deed::Open, object, rng);
            let open = Fate { displaced: there.displaced, shift: there.shift, ..open };
            if swaps { [open, there] } else { [there, open] }
        }
    };
    Deed { done, fates }
}

/// Across the longest side of its box.
fn cut(object: &Object, rng: &mut ChaCha8Rng) -> Cut {
    let bounds = object.solid.bounds();
    let size = Vec3::from_fn(|i, _| bounds.max[i] - bounds.min[i]);
    let axis = size.imax();
    let sense = if rng.random_bool(0.5) && axis != 2 { -1.0 } else { 1.0 };
    let share = rng.random_range(BUILT);
    let mut through = bounds.centre();
    through[axis] += sense * (share - 0.5) * size[axis];
    Cut { through, normal: Vec3::ith(axis, sense) }
}
