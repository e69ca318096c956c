//! Buildings as drawn: a seed makes a layout to which nothing has been tuned.

mod draft;
mod panel;
mod rooms;
mod storey;

use std::f64::consts::TAU;

use anyhow::Result;
use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Solid, Vec3};
use nalgebra::Rotation3;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use draft::Draft;
pub use draft::free_place;

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd)]
pub enum Layout {
    /// One hall: slabs, walls, partitions, columns, pipes, ducts, beams, boards, a tank and a plinth.
    Storey,
    /// Rooms on a corridor under a pitched roof: walls with doors and windows, a stair, steel profiles, a curved wall.
    Rooms,
}

impl Layout {
    /// The layout of scene `i` of a set: every third has rooms.
    pub fn number(i: usize) -> Self {
        if i % 3 == 2 { Self::Rooms } else { Self::Storey }
    }

    pub fn name(self) -> &'static str {
        ["hall", "rooms"][self as usize]
    }
}

/// What an object is, which tells in which direction it could plausibly be displaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Floor or ceiling: up or down.
    Slab,
    /// Wall or board: across its thickness, mostly.
    Plate,
    /// Column, tank or plinth: in any horizontal direction.
    Post,
    /// Pipe, duct or beam: across its length.
    Bar,
}

/// An object as drawn.
#[derive(Debug)]
pub struct Object {
    pub name: String,
    pub kind: Kind,
    pub solid: Solid,
    /// Unit vector: a plate's normal, a bar's direction; otherwise z.
    pub axis: Vec3,
}

/// A storey with its objects, in a frame rotated and moved relative to the plan's.
#[derive(Debug)]
pub struct Building {
    pub layout: Layout,
    pub objects: Vec<Object>,
    pub world_from_plan: Placement,
    /// Inner size of the plan, metres.
    pub size: Vec3,
    /// Footprints of what stands on the floor, plan metres.
    pub standing: Vec<Footprint>,
}

/// Heading and offset.
#[derive(Debug, Clone, Copy)]
pub struct Placement {
    pub rotation: Rotation3<f64>,
    pub offset: Vec3,
}

/// An upright rectangle in plan.
#[derive(Debug, Clone, Copy)]
pub struct Footprint {
    pub min: [f64; 2],
    pub max: [f64; 2],
}

impl Footprint {
    /// Whether two are nearer to each other than `gap` metres.
    pub fn near(&self, other: &Self, gap: f64) -> bool {
        (0..2).all(|k| self.min[k] - gap < other.max[k] && other.min[k] - gap < self.max[k])
    }
}

impl Placement {
    pub fn point(&self, plan: &Vec3) -> Vec3 {
        self.rotation * plan + self.offset
    }

    pub fn solid(&self, plan: &Solid) -> Result<Solid> {
        Ok(plan.placed(|v| self.point(v), NEVER)?)
    }
}

impl Building {
    /// A building of this layout.
    pub fn draw(layout: Layout, rng: &mut ChaCha8Rng) -> Result<Self> {
        let size = Vec3::new(rng.random_range(6.0..15.0), rng.random_range(5.0..10.0), rng.random_range(2.6..4.0));
        let far = if rng.random_bool(0.5) { [600_000.0, 5_400_000.0, 500.0] } else { [0.0; 3] };
        let world_from_plan = Placement {
            rotation: Rotation3::from_axis_angle(&Vec3::z_axis(), rng.random_range(0.0..TAU)),
            offset: Vec3::from(far),
        };
        let mut draft = Draft::new(size, rng);
        match layout {
            Layout::Storey => draft.storey()?,
            Layout::Rooms => draft.rooms()?,
        }
        let Draft { objects, standing, .. } = draft;
        let place = |o: Object| -> Result<Object> {
            Ok(Object { solid: world_from_plan.solid(&o.solid)?, axis: world_from_plan.rotation * o.axis, ..o })
        };
        let objects = objects.into_iter().map(place).collect::<Result<_>>()?;
        Ok(Self { layout, objects, world_from_plan, size, standing })
    }
}
