//! A hall, and what stands and hangs in it.

use anyhow::Result;
use asbuilt_core::geometry::{Solid, Vec3};
use nalgebra::Rotation3;
use rand::Rng;

use super::draft::Draft;
use super::{Footprint, Kind};

impl Draft<'_> {
    /// Draws everything.
    pub fn storey(&mut self) -> Result<()> {
        self.shell()?;
        self.partitions()?;
        self.posts()?;
        self.bars()?;
        self.boards()
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
    pub(super) fn boards(&mut self) -> Result<()> {
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
}
