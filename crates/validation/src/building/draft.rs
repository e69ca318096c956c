//! A plan being drawn.

use anyhow::Result;
use asbuilt_core::geometry::{Solid, Vec3};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use super::{Footprint, Kind, Object};

/// Objects so far, and the places that they occupy.
pub struct Draft<'a> {
    pub rng: &'a mut ChaCha8Rng,
    pub objects: Vec<Object>,
    pub standing: Vec<Footprint>,
    pub hanging: Vec<Footprint>,
    pub size: Vec3,
}

impl<'a> Draft<'a> {
    /// An empty plan of this inner size, metres.
    pub fn new(size: Vec3, rng: &'a mut ChaCha8Rng) -> Self {
        Self { rng, objects: Vec::new(), standing: Vec::new(), hanging: Vec::new(), size }
    }

    pub fn add(&mut self, name: &str, kind: Kind, axis: Vec3, solid: Solid) {
        let name = format!("{name} {}", self.objects.len() + 1);
        self.objects.push(Object { name, kind, solid, axis });
    }

    pub fn cuboid(&mut self, name: &str, kind: Kind, axis: Vec3, min: [f64; 3], max: [f64; 3]) -> Result<()> {
        self.add(name, kind, axis, Solid::cuboid(min, max)?);
        Ok(())
    }

    /// A place where nothing stands (or hangs) yet; it counts as taken afterwards.
    pub fn free(&mut self, extent: [f64; 2], standing: bool) -> Option<Footprint> {
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
