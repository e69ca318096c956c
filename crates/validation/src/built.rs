//! Buildings as built: what is displaced, missing, hidden or added.

use anyhow::Result;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_simulate::Change;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::building::{Building, Kind, Object, free_place};

/// What was done to an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Case {
    AsDrawn,
    Shifted,
    Tilted,
    Bowed,
    Missing,
    HalfHidden,
}

impl Case {
    pub const ALL: [Self; 6] =
        [Self::AsDrawn, Self::Shifted, Self::Tilted, Self::Bowed, Self::Missing, Self::HalfHidden];

    pub fn name(self) -> &'static str {
        ["as drawn", "shifted", "tilted", "bowed", "missing", "half hidden"][self as usize]
    }
}

/// An object's fate.
#[derive(Debug)]
pub struct Fate {
    pub case: Case,
    pub change: Change,
    /// `None` if missing.
    pub solid: Option<Solid>,
}

/// What stands there.
#[derive(Debug)]
pub struct Built {
    /// One for each object, in the same order.
    pub fates: Vec<Fate>,
    /// What is not in the drawing.
    pub clutter: Vec<Solid>,
}

impl Built {
    pub fn of(building: &Building, rng: &mut ChaCha8Rng) -> Result<Self> {
        let mut fates = Vec::new();
        let mut clutter = loose_clutter(building, rng)?;
        for object in &building.objects {
            let fate = fate(object, rng)?;
            if fate.case == Case::HalfHidden {
                clutter.push(screen(object, building, rng)?);
            }
            fates.push(fate);
        }
        Ok(Self { fates, clutter })
    }

    pub fn solids(&self) -> Vec<Solid> {
        self.fates.iter().filter_map(|f| f.solid.as_ref()).chain(&self.clutter).cloned().collect()
    }
}

fn fate(object: &Object, rng: &mut ChaCha8Rng) -> Result<Fate> {
    let case = match rng.random_range(0..100) {
        0..36 => Case::AsDrawn,
        36..62 => Case::Shifted,
        62..70 => Case::Tilted,
        70..78 => Case::Bowed,
        78..90 if object.kind != Kind::Slab => Case::Missing,
        90..100 if object.kind == Kind::Plate => Case::HalfHidden,
        _ => Case::AsDrawn,
    };
    let off = rng.random_range(0.002..0.06);
    let direction = likely_direction(object, rng);
    let mut change = Change::default();
    match case {
        Case::AsDrawn | Case::HalfHidden => {}
        Case::Shifted => change.shift = (direction * off).into(),
        Case::Tilted => {
            // So that the far end is off by `off`.
            let b = object.solid.bounds();
            let lever = (b.max[2] - b.min[2]).max(0.3 * b.diagonal());
            change.tilt_deg = (off / lever).to_degrees();
            let axis = direction.cross(&Vec3::z());
            change.tilt_axis = if axis.norm() > 0.1 { axis.normalize().into() } else { [1.0, 0.0, 0.0] };
        }
        Case::Bowed => change.bow = (direction * off).into(),
        Case::Missing => change.missing = true,
    }
    Ok(Fate { case, solid: change.apply(&object.solid)?, change })
}

fn likely_direction(object: &Object, rng: &mut ChaCha8Rng) -> Vec3 {
    let sign = if rng.random_bool(0.5) { 1.0 } else { -1.0 };
    let turn = rng.random_range(0.0..std::f64::consts::TAU);
    let horizontal = Vec3::new(turn.cos(), turn.sin(), 0.0);
    match object.kind {
        Kind::Slab => Vec3::z() * sign,
        Kind::Plate if rng.random_bool(0.8) => object.axis * sign,
        Kind::Plate | Kind::Post => horizontal,
        Kind::Bar => {
            let side = object.axis.cross(&Vec3::z());
            side * turn.cos() + Vec3::z() * turn.sin()
        }
    }
}

/// Boxes on the floor.
fn loose_clutter(building: &Building, rng: &mut ChaCha8Rng) -> Result<Vec<Solid>> {
    let mut taken = building.standing.clone();
    let mut out = Vec::new();
    for _ in 0..rng.random_range(1..7) {
        let extent = [rng.random_range(0.2..1.2), rng.random_range(0.2..1.2)];
        if let Some(f) = free_place(rng, &building.size, extent, 0.02, &taken) {
            taken.push(f);
            let top = rng.random_range(0.2..1.8);
            let plan = Solid::cuboid([f.min[0], f.min[1], 0.0], [f.max[0], f.max[1], top])?;
            out.push(building.world_from_plan.solid(&plan)?);
        }
    }
    Ok(out)
}

/// A board in front of about half of a plate, on the side of the room's middle.
fn screen(object: &Object, building: &Building, rng: &mut ChaCha8Rng) -> Result<Solid> {
    let to_plan = building.world_from_plan.rotation.inverse();
    let corners: Vec<Vec3> =
        object.solid.vertices().iter().map(|v| to_plan * (v - building.world_from_plan.offset)).collect();
    let (low, high) = corners.iter().fold((corners[0], corners[0]), |(l, h), c| (l.inf(c), h.sup(c)));
    let across = usize::from((to_plan * object.axis).y.abs() > 0.5);
    let along = 1 - across;
    let gap = rng.random_range(0.03..0.5);
    let (mut min, mut max) = (low, high);
    if 0.5 * (low[across] + high[across]) < 0.5 * building.size[across] {
        min[across] = high[across] + gap;
    } else {
        min[across] = low[across] - gap - 0.03;
    }
    max[across] = min[across] + 0.03;
    let middle = low[along] + (high[along] - low[along]) * rng.random_range(0.35..0.65);
    if rng.random_bool(0.5) {
        max[along] = middle
    } else {
        min[along] = middle
    }
    min.z = 0.0;
    max.z = 0.9 * high.z;
    building.world_from_plan.solid(&Solid::cuboid(min.into(), max.into())?)
}
