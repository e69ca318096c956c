//! Rooms on a corridor under a pitched roof.

use std::f64::consts::FRAC_PI_2;

use anyhow::Result;
use asbuilt_core::geometry::{Solid, Vec3};
use rand::Rng;

use super::draft::Draft;
use super::panel::{Opening, Panel};
use super::{Footprint, Kind};

/// How a wall's outline (u along it, v up, w across) is placed in the plan.
#[derive(Clone, Copy)]
enum Along {
    /// Along x; w counts from y downwards.
    X(f64),
    /// Along y; w counts from x upwards.
    Y(f64),
}

impl Along {
    fn place(self, p: &Vec3) -> Vec3 {
        match self {
            Self::X(y) => Vec3::new(p.x, y - p.z, p.y),
            Self::Y(x) => Vec3::new(x + p.z, p.x, p.y),
        }
    }

    fn normal(self) -> Vec3 {
        if matches!(self, Self::X(_)) { Vec3::y() } else { Vec3::x() }
    }
}

impl Draft<'_> {
    /// Draws everything.
    pub fn rooms(&mut self) -> Result<()> {
        let rise = self.rng.random_range(0.0..0.12);
        self.floor_and_roof(rise)?;
        self.outer_walls(rise)?;
        self.inner_walls(rise)?;
        self.stair()?;
        self.curved_wall()?;
        self.profiles(rise)?;
        self.boards()
    }

    /// A floor with a shaft, a roof that rises along x, with a window in it.
    fn floor_and_roof(&mut self, rise: f64) -> Result<()> {
        let [w, d, h] = self.size.into();
        let thick = self.rng.random_range(0.15..0.3);
        let hole = |f: Footprint| Opening { u: [f.min[0], f.max[0]], v: [f.min[1], f.max[1]] };
        let shaft: Vec<Opening> = self.free([1.1, 0.8], true).map(hole).into_iter().collect();
        let floor = Panel::with_openings([-0.3, w + 0.3], [-0.3, d + 0.3], [-thick, 0.0], &shaft);
        self.add("floor", Kind::Slab, Vec3::z(), floor.pierced(&shaft, |p| p)?);
        let light: Vec<Opening> = self.free([0.8, 1.2], false).map(hole).into_iter().collect();
        let roof = Panel::with_openings([-0.3, w + 0.3], [-0.3, d + 0.3], [h, h + thick], &light);
        self.add("roof", Kind::Slab, Vec3::z(), roof.pierced(&light, |p| p + Vec3::z() * (rise * p.x))?);
        Ok(())
    }

    fn outer_walls(&mut self, rise: f64) -> Result<()> {
        let [w, d, _] = self.size.into();
        let t = self.rng.random_range(0.15..0.4);
        for along in [Along::X(0.0), Along::X(d + t), Along::Y(-t), Along::Y(w)] {
            let length = if matches!(along, Along::X(_)) { w } else { d };
            let windows = self.openings(length, [0.9, 0.9]);
            self.wall("wall", along, [0.0, length], t, &windows, rise)?;
        }
        Ok(())
    }

    /// A wall along the corridor, and walls between the rooms.
    fn inner_walls(&mut self, rise: f64) -> Result<()> {
        let [w, d, _] = self.size.into();
        let t = self.rng.random_range(0.08..0.2);
        let y = d * self.rng.random_range(0.25..0.4);
        let doors = self.openings(w, [0.0, 0.0]);
        self.wall("corridor wall", Along::X(y + t), [0.0, w], t, &doors, rise)?;
        self.standing.push(Footprint { min: [0.0, y], max: [w, y + t] });
        self.hanging.push(Footprint { min: [0.0, y], max: [w, y + t] });
        for i in 1..=((w / 4.5) as u32).min(3) {
            let x = w * f64::from(i) / (f64::from((w / 4.5) as u32) + 1.0) + self.rng.random_range(-0.4..0.4);
            let thin = self.rng.random_range(0.06..0.15);
            let door = if self.rng.random_bool(0.4) { self.openings(d - y - t, [0.0, 0.0]) } else { Vec::new() };
            let door: Vec<Opening> =
                door.iter().map(|o| Opening { u: [o.u[0] + y + t, o.u[1] + y + t], ..*o }).collect();
            self.wall("room wall", Along::Y(x), [y + t, d], thin, &door, rise)?;
            let footprint = Footprint { min: [x, y + t], max: [x + thin, d] };
            self.standing.push(footprint);
            self.hanging.push(footprint);
        }
        Ok(())
    }

    /// Doors or windows about every three metres; sills between these heights.
    fn openings(&mut self, length: f64, sill: [f64; 2]) -> Vec<Opening> {
        let count = (length / 3.2) as u32;
        let bay = length / f64::from(count.max(1));
        let mut out = Vec::new();
        for i in 0..count {
            if self.rng.random_bool(0.7) {
                let wide = self.rng.random_range(0.7..1.4f64).min(0.6 * bay);
                let from = f64::from(i) * bay + self.rng.random_range(0.2..bay - wide - 0.2);
                let low = self.rng.random_range(sill[0]..=sill[1]);
                out.push(Opening { u: [from, from + wide], v: [low, self.rng.random_range(1.9..2.1)] });
            }
        }
        out
    }

    /// A wall whose top follows the roof.
    fn wall(
        &mut self,
        name: &str,
        along: Along,
        length: [f64; 2],
        thickness: f64,
        openings: &[Opening],
        rise: f64,
    ) -> Result<()> {
        let h = self.size.z;
        let panel = Panel::with_openings(length, [0.0, h], [0.0, thickness], openings);
        let solid = panel.pierced(openings, |p| {
            let placed = along.place(&p);
            if p.y == h { placed + Vec3::z() * (rise * placed.x) } else { placed }
        })?;
        self.add(name, Kind::Plate, along.normal(), solid);
        Ok(())
    }

    fn stair(&mut self) -> Result<()> {
        let (steps, wide) = (self.rng.random_range(5..11), self.rng.random_range(0.8..1.2));
        let (tread, riser) = (self.rng.random_range(0.25..0.3), self.rng.random_range(0.15..0.19));
        let lines = |unit: f64| (0..=steps).map(|i| f64::from(i) * unit).collect::<Vec<_>>();
        let panel = Panel { us: lines(tread), vs: lines(riser), ws: [0.0, wide] };
        let Some(f) = self.free([f64::from(steps) * tread, wide], true) else { return Ok(()) };
        let stair = panel.solid(
            |u, v| (v / riser).floor() <= (u / tread).floor(),
            |p| Vec3::new(f.min[0] + p.x, f.max[1] - p.z, p.y),
        )?;
        self.add("stair", Kind::Post, Vec3::z(), stair);
        Ok(())
    }

    /// A quarter of a circle.
    fn curved_wall(&mut self) -> Result<()> {
        let (radius, t) = (self.rng.random_range(0.8..1.8), self.rng.random_range(0.06..0.2));
        let top = self.rng.random_range(1.0..2.2);
        let Some(f) = self.free([radius + t; 2], true) else { return Ok(()) };
        let quadrant = self.rng.random_range(0..4);
        let start = f64::from(quadrant) * FRAC_PI_2;
        // The corner of the footprint that the circle is around.
        let centre = [
            if quadrant == 0 || quadrant == 3 { f.min[0] } else { f.max[0] },
            if quadrant < 2 { f.min[1] } else { f.max[1] },
        ];
        let facets = 24;
        let us = (0..=facets).map(|i| start + FRAC_PI_2 * f64::from(i) / f64::from(facets)).collect();
        let panel = Panel { us, vs: vec![0.0, top], ws: [radius, radius + t] };
        let wall =
            panel.solid(|_, _| true, |p| Vec3::new(centre[0] + p.z * p.x.cos(), centre[1] + p.z * p.x.sin(), p.y))?;
        self.add("curved wall", Kind::Post, Vec3::z(), wall);
        Ok(())
    }

    /// Steel columns (H), round ones of few facets, and girders below the roof.
    fn profiles(&mut self, rise: f64) -> Result<()> {
        let h = self.size.z;
        for i in 0..self.rng.random_range(3..7) {
            let size = self.rng.random_range(0.12..0.3);
            if i % 3 == 1 {
                let Some(f) = self.free([size; 2], true) else { continue };
                let foot = [f.min[0] + 0.5 * size, f.min[1] + 0.5 * size, 0.0];
                let column = Solid::cylinder(foot, 0.5 * size, h, self.rng.random_range(12..40))?;
                self.add("column", Kind::Post, Vec3::z(), column);
                continue;
            }
            let steel = self.rng.random_range(0.012..0.03);
            let lines = vec![0.0, steel, 0.5 * (size - steel), 0.5 * (size + steel), size - steel, size];
            let web = |u: f64, v: f64| v < steel || v > size - steel || (u - 0.5 * size).abs() < 0.5 * steel;
            if i % 3 == 0 {
                let Some(f) = self.free([size; 2], true) else { continue };
                let panel = Panel { us: lines.clone(), vs: lines, ws: [0.0, h] };
                let column = panel.solid(web, |p| Vec3::new(f.min[0] + p.x, f.min[1] + p.y, p.z))?;
                self.add("steel column", Kind::Post, Vec3::z(), column);
                continue;
            }
            let length = self.rng.random_range(1.5..4.0);
            let Some(f) = self.free([size, length], false) else { continue };
            let panel = Panel { us: lines.clone(), vs: lines, ws: [0.0, length] };
            let under = h + rise * f.min[0] - size;
            let girder = panel.solid(|u, v| web(v, u), |p| Vec3::new(f.min[0] + p.y, f.min[1] + p.z, under + p.x))?;
            self.add("girder", Kind::Bar, Vec3::y(), girder);
        }
        Ok(())
    }
}
