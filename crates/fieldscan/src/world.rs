//! What stands there: for good, and while one station measured.

use asbuilt_core::geometry::{Solid, Vec3};

use crate::material::{Material, Optics};
use crate::tree::{Hit, Tree};
use crate::triangle::Triangle;

/// Surfaces nearer to each other along a ray lie at one place, metres.
const ONE_PLACE_M: f64 = 1e-5;

/// A surface of one material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Its material.
    pub material: Material,
    /// Whose it is, as its maker numbers things.
    pub owner: u32,
}

/// Water on a floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Puddle {
    /// Its middle, world metres.
    pub centre: Vec3,
    /// Its radius, metres.
    pub radius: f64,
}

/// Surfaces prepared for rays.
#[derive(Debug, Default)]
pub struct World {
    surfaces: Vec<Surface>,
    triangles: Vec<Triangle>,
    tree: Tree,
    puddles: Vec<Puddle>,
}

impl World {
    /// Adds a surface made of triangles, world metres.
    pub fn add(&mut self, surface: Surface, triangles: impl IntoIterator<Item = [Vec3; 3]>) {
        let number = self.surfaces.len() as u32;
        self.surfaces.push(surface);
        self.triangles.extend(triangles.into_iter().map(|corners| Triangle { corners, surface: number }));
    }

    /// Adds a body of one material.
    pub fn add_solid(&mut self, surface: Surface, solid: &Solid) {
        self.add(surface, (0..solid.triangles().len()).map(|t| solid.corners(t)));
    }

    /// Adds water.
    pub fn add_puddle(&mut self, puddle: Puddle) {
        self.puddles.push(puddle);
    }

    /// Sorts what was added: to be called once, before rays are sent.
    pub fn built(mut self) -> Self {
        self.tree = Tree::new(std::mem::take(&mut self.triangles));
        self
    }

    /// Its triangles, sorted.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// A surface by the number that hits tell.
    pub fn surface(&self, number: u32) -> &Surface {
        &self.surfaces[number as usize]
    }

    /// What a ray meets first beyond some metres; of surfaces at one place rather one that is not of glass: the edge of a
    /// pane lies on its frame.
    fn first(&self, origin: &Vec3, direction: &Vec3, beyond: f64) -> Option<Hit> {
        let is_glass = |surface: u32| self.surface(surface).material.optics == Optics::Glass;
        let hit = self.tree.first(origin, direction, beyond)?;
        if !is_glass(hit.surface) {
            return Some(hit);
        }
        let frame = self.tree.first_of(origin, direction, beyond.max(hit.range - ONE_PLACE_M), |s| !is_glass(s));
        Some(frame.filter(|frame| frame.range <= hit.range + ONE_PLACE_M).unwrap_or(hit))
    }

    /// The material at a place of a surface: wet within a puddle, on what looks up.
    fn material_at(&self, hit: &Hit, place: &Vec3) -> Material {
        let material = self.surface(hit.surface).material;
        let is_in = |p: &Puddle| (place - p.centre).xy().norm() < p.radius && (place - p.centre).z.abs() < 0.02;
        let is_wet = hit.normal.z.abs() > 0.99 && self.puddles.iter().any(is_in);
        if is_wet { material.wet() } else { material }
    }
}

/// What a ray met, with its material and owner.
#[derive(Debug, Clone, Copy)]
pub struct Met {
    /// Distance along the ray, metres.
    pub range: f64,
    /// Unit normal as drawn.
    pub normal: Vec3,
    /// The material there.
    pub material: Material,
    /// Whose surface it is.
    pub owner: u32,
}

/// What one station sees: the world, and what only stood there while it measured.
#[derive(Debug, Clone, Copy)]
pub struct View<'a> {
    /// What stands there for good.
    pub fixed: &'a World,
    /// What does not: people, vehicles.
    pub passing: &'a World,
}

impl View<'_> {
    /// What a ray meets first beyond some metres.
    pub fn first(&self, origin: &Vec3, direction: &Vec3, beyond: f64) -> Option<Met> {
        let met = |world: &World| {
            let hit = world.first(origin, direction, beyond)?;
            let material = world.material_at(&hit, &(origin + direction * hit.range));
            let owner = world.surface(hit.surface).owner;
            Some(Met { range: hit.range, normal: hit.normal, material, owner })
        };
        let (a, b) = (met(self.fixed), met(self.passing));
        match (a, b) {
            (Some(a), Some(b)) => Some(if a.range <= b.range { a } else { b }),
            _ => a.or(b),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whichever was added first.
    #[test]
    fn a_frame_stands_before_the_edge_of_its_pane() {
        let square = [Vec3::new(2.0, -1.0, -1.0), Vec3::new(2.0, 3.0, -1.0), Vec3::new(2.0, -1.0, 3.0)];
        let surface = |material, owner| Surface { material, owner };
        let (glass, frame) = (surface(Material::glass(), 1), surface(Material::matt(0.5, 0.0), 2));
        for order in [[glass, frame], [frame, glass]] {
            let mut world = World::default();
            order.into_iter().for_each(|s| world.add(s, [square]));
            let (world, nothing) = (world.built(), World::default().built());
            let view = View { fixed: &world, passing: &nothing };
            let met = view.first(&Vec3::zeros(), &Vec3::x(), 0.0).unwrap();
            assert_eq!((met.range, met.owner), (2.0, 2));
        }
        let mut world = World::default();
        world.add(glass, [square]);
        let (world, nothing) = (world.built(), World::default().built());
        let view = View { fixed: &world, passing: &nothing };
        assert_eq!(view.first(&Vec3::zeros(), &Vec3::x(), 0.0).unwrap().owner, 1);
    }
}
