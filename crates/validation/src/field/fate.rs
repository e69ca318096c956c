//! What becomes of an object: built as drawn, elsewhere, open, or not at all; and never quite as drawn.

use std::f64::consts::{PI, TAU};

use asbuilt_core::geometry::Vec3;
use nalgebra::Rotation3;
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::layout::{Kind, Layout, Object};
use super::leaf::hinge;

/// Standard deviation of where anything is built, metres along each axis.
const TOLERANCE_M: f64 = 0.0015;
/// Displacements, metres: as many of 2 to 4 mm as of 100 to 200 mm.
const DISPLACED_M: std::ops::Range<f64> = 0.002..0.2;
/// How far a leaf stands open, radians.
const OPEN: std::ops::Range<f64> = 0.6..1.75;
/// Largest unevenness of a slab, metres.
const MAX_WAVE_M: f64 = 0.004;

/// What was done to an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Deed {
    AsDrawn,
    Displaced,
    Missing,
    Open,
}

impl Deed {
    /// In words.
    pub fn name(self) -> &'static str {
        ["as drawn", "displaced", "missing", "open"][self as usize]
    }
}

/// A leaf turned about an upright axis.
#[derive(Debug, Clone, Copy)]
pub struct Turn {
    /// A point of the axis, world metres.
    pub hinge: Vec3,
    /// Angle, radians.
    pub angle: f64,
}

/// An uneven slab: waves along two directions.
#[derive(Debug, Clone, Copy)]
pub struct Wave {
    amplitude_m: f64,
    length_m: f64,
    phase: [f64; 2],
}

/// What of an object was built: on one side of a plane.
#[derive(Debug, Clone, Copy)]
pub struct Cut {
    /// A point of the plane, world metres.
    pub through: Vec3,
    /// Unit normal, away from what was built.
    pub normal: Vec3,
}

impl Cut {
    /// How far a place lies on the side that was not built, metres; negative on the other.
    pub fn beyond(&self, p: &Vec3) -> f64 {
        (p - self.through).dot(&self.normal)
    }
}

/// An object's fate.
#[derive(Debug, Clone)]
pub struct Fate {
    /// What was done.
    pub deed: Deed,
    /// Displacement on purpose, metres.
    pub displaced: Vec3,
    /// Displacement of the whole, what nobody meant included; metres.
    pub shift: Vec3,
    /// Unevenness.
    pub wave: Option<Wave>,
    /// Leaves that stand open, by their number.
    pub turns: Vec<Option<Turn>>,
    /// Where building stopped.
    pub cut: Option<Cut>,
}

impl Fate {
    /// Whether the point of the object drawn at `p` was not built.
    pub fn is_missing(&self, p: &Vec3) -> bool {
        self.deed == Deed::Missing || self.cut.is_some_and(|cut| cut.beyond(p) > 0.0)
    }

    /// Where the point of the object drawn at `p` was built; world metres.
    pub fn place(&self, p: &Vec3, leaf: Option<usize>) -> Vec3 {
        let turn = leaf.and_then(|n| self.turns.get(n).copied().flatten());
        let turned =
            turn.map_or(*p, |t| t.hinge + Rotation3::from_axis_angle(&Vec3::z_axis(), t.angle) * (p - t.hinge));
        turned + self.shift + Vec3::z() * self.wave.map_or(0.0, |w| w.height(p))
    }

    /// Whether a leaf stands elsewhere than drawn.
    pub fn is_turned(&self, leaf: Option<usize>) -> bool {
        leaf.is_some_and(|n| self.turns.get(n).is_some_and(Option::is_some))
    }
}

impl Wave {
    fn height(&self, p: &Vec3) -> f64 {
        let wave = |x: f64, phase: f64| (TAU * x / self.length_m + phase).sin();
        self.amplitude_m * wave(p.x, self.phase[0]) * wave(p.y, self.phase[1])
    }
}

/// The fates of all objects of a building.
pub fn fates(layout: &Layout, rng: &mut ChaCha8Rng) -> Vec<Fate> {
    layout.objects.iter().map(|o| fate(o, rng)).collect()
}

fn fate(object: &Object, rng: &mut ChaCha8Rng) -> Fate {
    let deed = deed(object, rng);
    fate_of(deed, object, rng)
}

/// The fate of an object of which this was done.
pub fn fate_of(deed: Deed, object: &Object, rng: &mut ChaCha8Rng) -> Fate {
    let normal =
        |rng: &mut ChaCha8Rng| TOLERANCE_M * <StandardNormal as Distribution<f64>>::sample(&StandardNormal, rng);
    let tolerance = Vec3::new(normal(rng), normal(rng), normal(rng));
    let displaced = if deed == Deed::Displaced { displacement(object, rng) } else { Vec3::zeros() };
    let is_slab = ["IfcSlab", "IfcCovering"].contains(&object.class.as_str());
    let wave = (is_slab && rng.random_bool(0.7)).then(|| Wave {
        amplitude_m: rng.random_range(0.0..MAX_WAVE_M),
        length_m: rng.random_range(2.0..8.0),
        phase: [rng.random_range(0.0..TAU), rng.random_range(0.0..TAU)],
    });
    let turns = if deed == Deed::Open { turns(object, rng) } else { Vec::new() };
    Fate { deed, displaced, shift: displaced + tolerance, wave, turns, cut: None }
}

fn deed(object: &Object, rng: &mut ChaCha8Rng) -> Deed {
    let dice = rng.random_range(0..100);
    if object.can_open() && dice < 65 {
        return Deed::Open;
    }
    match dice {
        65..85 if object.class != "IfcSite" => Deed::Missing,
        85..100 => Deed::Displaced,
        _ => Deed::AsDrawn,
    }
}

/// Somewhere within [`DISPLACED_M`]; most flat things across themselves.
pub fn displacement(object: &Object, rng: &mut ChaCha8Rng) -> Vec3 {
    let length = DISPLACED_M.start * (DISPLACED_M.end / DISPLACED_M.start).powf(rng.random_range(0.0..1.0));
    let flat = main_direction(object);
    let any: Vec3 = if object.kind == Kind::Structure || object.kind == Kind::Glazed || object.kind == Kind::Door {
        flat
    } else {
        let heading = rng.random_range(0.0..TAU);
        Vec3::new(heading.cos(), heading.sin(), 0.0)
    };
    let direction = if rng.random_bool(0.8) { any } else { random_direction(rng) };
    direction * length * if rng.random_bool(0.5) { 1.0 } else { -1.0 }
}

/// The normal of the largest triangle.
fn main_direction(object: &Object) -> Vec3 {
    let twice = (0..object.solid.triangles().len()).map(|t| {
        let [a, b, c] = object.solid.corners(t);
        (b - a).cross(&(c - a))
    });
    twice.max_by(|a, b| a.norm().total_cmp(&b.norm())).and_then(|n| n.try_normalize(0.0)).unwrap_or_else(Vec3::z)
}

fn random_direction(rng: &mut ChaCha8Rng) -> Vec3 {
    let (heading, z) = (rng.random_range(0.0..2.0 * PI), rng.random_range(-1.0f64..1.0));
    let level = (1.0 - z * z).sqrt();
    Vec3::new(level * heading.cos(), level * heading.sin(), z)
}

pub fn turns(object: &Object, rng: &mut ChaCha8Rng) -> Vec<Option<Turn>> {
    let count = object.leaf.iter().flatten().max().map_or(0, |n| n + 1);
    let sense = if rng.random_bool(0.5) { 1.0 } else { -1.0 };
    let other_end = rng.random_bool(0.5);
    (0..count)
        .map(|n| {
            let hinge = hinge(&object.solid, &object.leaf, n, other_end)?;
            // Two leaves turn to the same side: in opposite senses.
            let mirrored = if n % 2 == 0 { 1.0 } else { -1.0 };
            Some(Turn { hinge, angle: sense * mirrored * rng.random_range(OPEN) })
        })
        .collect()
}
