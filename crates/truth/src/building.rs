//! Buildings as drawn: a seed makes a layout nobody has tuned anything to.

use std::f64::consts::TAU;

use anyhow::Result;
use asbuilt_core::geometry::{Solid, Vec3};
use nalgebra::Rotation3;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// What an object is: tells in which direction it could plausibly be off.
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
    /// Unit vector: a plate's normal, a bar's length; else z.
    pub axis: Vec3,
}

/// A storey with its objects, in a frame turned and moved against the plan's.
#[derive(Debug)]
pub struct Building {
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
        let vertices = plan.vertices().iter().map(|v| self.point(v)).collect();
        Ok(Solid::new(vertices, plan.triangles().to_vec())?)
    }
}

/// A plan under the pencil.
struct Draft<'a> {
    rng: &'a mut ChaCha8Rng,
    objects: Vec<Object>,
    standing: Vec<Footprint>,
    hanging: Vec<Footprint>,
    size: Vec3,
}

impl Building {
    /// One storey with slabs, walls, partitions, columns, pipes, ducts, beams, boards, a tank and a plinth.
    pub fn draw(rng: &mut ChaCha8Rng) -> Result<Self> {
        let size = Vec3::new(rng.random_range(6.0..15.0), rng.random_range(5.0..10.0), rng.random_range(2.6..4.0));
        let far = if rng.random_bool(0.5) { [600_000.0, 5_400_000.0, 500.0] } else { [0.0; 3] };
        let world_from_plan = Placement {
            rotation: Rotation3::from_axis_angle(&Vec3::z_axis(), rng.random_range(0.0..TAU)),
            offset: Vec3::from(far),
        };
        let mut draft = Draft { rng, objects: Vec::new(), standing: Vec::new(), hanging: Vec::new(), size };
        draft.shell()?;
        draft.partitions()?;
        draft.posts()?;
        draft.bars()?;
        draft.boards()?;
        let Draft { objects, standing, .. } = draft;
        let place = |o: Object| -> Result<Object> {
            Ok(Object { solid: world_from_plan.solid(&o.solid)?, axis: world_from_plan.rotation * o.axis, ..o })
        };
        let objects = objects.into_iter().map(place).collect::<Result<_>>()?;
        Ok(Self { objects, world_from_plan, size, standing })
    }
}

impl Draft<'_> {
    fn add(&mut self, name: &str, kind: Kind, axis: Vec3, solid: Solid) {
        let name = format!("{name} {}", self.objects.len() + 1);
        self.objects.push(Object { name, kind, solid, axis });
    }

    fn cuboid(&mut self, name: &str, kind: Kind, axis: Vec3, min: [f64; 3], max: [f64; 3]) -> Result<()> {
        self.add(name, kind, axis, Solid::cuboid(min, max)?);
        Ok(())
    }

    fn shell(&mut self) -> Result<()> {
        let [w, d, h] = self.size.into();
        let t = self.rng.random_range(0.1..0.4);
        let slab = self.rng.random_range(0.15..0.35);
        self.cuboid("floor", Kind::Slab, Vec3::z(), [-t, -t, -slab], [w + t, d + t, 0.0])?;
        self.cuboid("ceiling", Kind::Slab, Vec3::z(), [-t, -t, h], [w + t, d + t, h + slab])?;
        self.cuboid("wall", Kind::Plate, Vec3::x(), [-t, 0.0, 0.0], [0.0, d, h])?;
        self.cuboid("wall", Kind::Plate, Vec3::x(), [w, 0.0, 0.0], [w + t, d, h])?;
        self.cuboid("wall", Kind::Plate, Vec3::y(), [-t, -t, 0.0], [w + t, 0.0, h])?;
        self.cuboid("wall", Kind::Plate, Vec3::y(), [-t, d, 0.0], [w + t, d + t, h])
    }

    /// Thin walls across the room that leave a passage.
    fn partitions(&mut self) -> Result<()> {
        let [w, d, h] = self.size.into();
        let count = ((w / 4.5) as u32).min(3);
        for i in 1..=count {
            let x = w * f64::from(i) / f64::from(count + 1) + self.rng.random_range(-0.3..0.3);
            let t = self.rng.random_range(0.04..0.16);
            let length = d * self.rng.random_range(0.4..0.75);
            let (from, to) = if self.rng.random_bool(0.5) { (0.0, length) } else { (d - length, d) };
            self.cuboid("partition", Kind::Plate, Vec3::x(), [x, from, 0.0], [x + t, to, h])?;
            let footprint = Footprint { min: [x, from], max: [x + t, to] };
            self.standing.push(footprint);
            self.hanging.push(footprint);
        }
        Ok(())
    }

    fn posts(&mut self) -> Result<()> {
        let h = self.size.z;
        for i in 0..self.rng.random_range(5..8) {
            let (name, half, top) = match i {
                0 => ("tank", self.rng.random_range(0.3..0.6), self.rng.random_range(1.0..2.0)),
                1 => ("plinth", self.rng.random_range(0.25..0.6), self.rng.random_range(0.2..0.9)),
                _ => ("column", self.rng.random_range(0.08..0.25), h),
            };
            let Some(f) = self.free([2.0 * half; 2], true) else { continue };
            let round = name == "tank" || (name == "column" && self.rng.random_bool(0.5));
            if round {
                let foot = [f.min[0] + half, f.min[1] + half, 0.0];
                self.add(name, Kind::Post, Vec3::z(), Solid::cylinder(foot, half, top, 48)?);
            } else {
                self.cuboid(name, Kind::Post, Vec3::z(), [f.min[0], f.min[1], 0.0], [f.max[0], f.max[1], top])?;
            }
            if top == h {
                self.hanging.push(f);
            }
        }
        Ok(())
    }

    /// What hangs below the ceiling.
    fn bars(&mut self) -> Result<()> {
        let h = self.size.z;
        for i in 0..self.rng.random_range(4..8) {
            let name = ["pipe", "duct", "beam"][i % 3];
            let half = if name == "pipe" { self.rng.random_range(0.03..0.1) } else { self.rng.random_range(0.1..0.2) };
            let length = self.rng.random_range(1.5..4.0);
            let along_x = self.rng.random_bool(0.5);
            let extent = if along_x { [length, 2.0 * half] } else { [2.0 * half, length] };
            let Some(f) = self.free(extent, false) else { continue };
            let axis = if along_x { Vec3::x() } else { Vec3::y() };
            let top = if name == "beam" { h } else { h - self.rng.random_range(0.08..0.3) };
            let bottom = top - 2.0 * half;
            if name == "pipe" {
                let start = if along_x {
                    Vec3::new(f.min[0], f.min[1] + half, bottom + half)
                } else {
                    Vec3::new(f.min[0] + half, f.min[1], bottom + half)
                };
                let upright = Solid::cylinder([0.0; 3], half, length, 32)?;
                let turn = Rotation3::rotation_between(&Vec3::z(), &axis).unwrap_or_default();
                let vertices = upright.vertices().iter().map(|v| turn * v + start).collect();
                self.add(name, Kind::Bar, axis, Solid::new(vertices, upright.triangles().to_vec())?);
            } else {
                self.cuboid(name, Kind::Bar, axis, [f.min[0], f.min[1], bottom], [f.max[0], f.max[1], top])?;
            }
        }
        Ok(())
    }

    /// Free-standing thin boards: two faces near each other.
    fn boards(&mut self) -> Result<()> {
        for _ in 0..self.rng.random_range(1..4) {
            let (t, length, top) =
                (self.rng.random_range(0.02..0.06), self.rng.random_range(0.8..1.6), self.rng.random_range(1.2..2.2));
            let across_x = self.rng.random_bool(0.5);
            let extent = if across_x { [t, length] } else { [length, t] };
            let Some(f) = self.free(extent, true) else { continue };
            let axis = if across_x { Vec3::x() } else { Vec3::y() };
            self.cuboid("board", Kind::Plate, axis, [f.min[0], f.min[1], 0.0], [f.max[0], f.max[1], top])?;
        }
        Ok(())
    }

    /// A place where nothing stands (or hangs) yet, taken from now on.
    fn free(&mut self, extent: [f64; 2], standing: bool) -> Option<Footprint> {
        let taken = if standing { &mut self.standing } else { &mut self.hanging };
        let found = free_place(self.rng, &self.size, extent, 0.35, taken)?;
        taken.push(found);
        Some(found)
    }
}

/// A rectangle of this extent (m) that keeps `gap` from walls and from what is `taken`; `None` after 40 tries.
pub fn free_place(
    rng: &mut ChaCha8Rng,
    size: &Vec3,
    extent: [f64; 2],
    gap: f64,
    taken: &[Footprint],
) -> Option<Footprint> {
    for _ in 0..40 {
        let [room_x, room_y] = [0, 1].map(|k| size[k] - extent[k] - 2.0 * gap);
        if room_x <= 0.0 || room_y <= 0.0 {
            return None;
        }
        let min = [gap + rng.random_range(0.0..room_x), gap + rng.random_range(0.0..room_y)];
        let f = Footprint { min, max: [min[0] + extent[0], min[1] + extent[1]] };
        if !taken.iter().any(|t| t.near(&f, gap)) {
            return Some(f);
        }
    }
    None
}
