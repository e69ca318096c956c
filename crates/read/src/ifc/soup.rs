//! Triangles in which coinciding vertices are one.

use std::collections::HashMap;

use asbuilt_core::geometry::{Closedness, Vec3};
use rustc_hash::{FxHashMap, FxHashSet};
use serde::{Deserialize, Serialize};

use super::Product;

/// A mesh, world metres.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Soup {
    pub vertices: Vec<[f64; 3]>,
    pub triangles: Vec<[u32; 3]>,
    /// For each triangle the number of the item that it is of.
    pub part_numbers: Vec<u16>,
    /// The item of triangles that are added next.
    #[serde(skip)]
    part: u16,
    #[serde(skip)]
    known: HashMap<[u64; 3], u32>,
}

impl Soup {
    /// Adds triangles whose vertices `place` transforms into the world; those that are not finite or have no area are
    /// left out.
    pub fn add(&mut self, positions: &[f32], indices: &[u32], place: impl Fn([f64; 3]) -> [f64; 3]) {
        let ids: Vec<Option<u32>> =
            positions.chunks_exact(3).map(|p| self.vertex(place([p[0], p[1], p[2]].map(f64::from)))).collect();
        for t in indices.chunks_exact(3) {
            let id = |i: usize| ids.get(t[i] as usize).copied().flatten();
            if let (Some(a), Some(b), Some(c)) = (id(0), id(1), id(2)) {
                self.triangle([a, b, c]);
            }
        }
    }

    /// What is added from here on is of that item.
    pub fn begin_part(&mut self, part: u16) {
        self.part = part;
    }

    /// Takes the items of another mesh of the same object: for each triangle that of the nearest there.
    pub fn take_parts(&mut self, other: &Self) {
        let of_one = other.part_numbers.first().filter(|first| other.part_numbers.iter().all(|p| p == *first));
        self.part_numbers = match of_one {
            Some(&only) => vec![only; self.triangles.len()],
            None => (0..self.triangles.len()).map(|t| other.part_near(self.middle(t))).collect(),
        };
    }

    fn middle(&self, triangle: usize) -> Vec3 {
        self.corners(triangle).into_iter().map(Vec3::from).sum::<Vec3>() / 3.0
    }

    fn part_near(&self, place: Vec3) -> u16 {
        let distance = |t: &usize| distance(&self.corners(*t).map(Vec3::from), &place);
        let nearest = (0..self.part_numbers.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.map_or(0, |t| self.part_numbers[t])
    }

    pub fn vertex(&mut self, world: [f64; 3]) -> Option<u32> {
        let next = self.vertices.len() as u32;
        world.iter().all(|c| c.is_finite()).then(|| {
            *self.known.entry(world.map(|c| (c + 0.0).to_bits())).or_insert_with(|| {
                self.vertices.push(world);
                next
            })
        })
    }

    pub fn triangle(&mut self, [a, b, c]: [u32; 3]) {
        if a != b && b != c && c != a {
            self.triangles.push([a, b, c]);
            self.part_numbers.push(self.part);
        }
    }

    /// Whether every edge is matched by its reverse.
    pub fn is_closed(&self) -> bool {
        self.balance().values().all(|n| *n == 0)
    }

    /// Directed edges that no reverse matches.
    pub fn border(&self) -> FxHashSet<(u32, u32)> {
        let left = self.balance().into_iter().filter(|(_, n)| *n != 0);
        left.map(|((a, b), n)| if n > 0 { (a, b) } else { (b, a) }).collect()
    }

    fn balance(&self) -> FxHashMap<(u32, u32), i32> {
        let mut balance: FxHashMap<(u32, u32), i32> = FxHashMap::default();
        for t in &self.triangles {
            for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                *balance.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
            }
        }
        balance
    }

    /// Whether it has gaps, by the same rule as the finished product.
    pub fn is_open(&self) -> bool {
        if self.is_closed() {
            return false;
        }
        let product =
            Product { vertices: self.vertices.clone(), triangles: self.triangles.clone(), ..Product::default() };
        product.solid().is_ok_and(|s| s.is_some_and(|s| s.closedness() == Closedness::Open))
    }

    pub fn corners(&self, triangle: usize) -> [[f64; 3]; 3] {
        self.triangles[triangle].map(|i| self.vertices[i as usize])
    }

    /// The outward vector perpendicular to a triangle, twice its area long.
    pub fn normal(&self, triangle: usize) -> Vec3 {
        let [a, b, c] = self.corners(triangle).map(Vec3::from);
        (b - a).cross(&(c - a))
    }

    /// The box around it; inside out for an empty mesh.
    pub fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        let start = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        self.vertices.iter().fold(start, |(low, high), v| {
            (std::array::from_fn(|k| low[k].min(v[k])), std::array::from_fn(|k| high[k].max(v[k])))
        })
    }

    /// The volume by the divergence theorem; meaningless for a mesh that is not closed.
    pub fn volume(&self) -> f64 {
        let Some(&o) = self.vertices.first() else { return 0.0 };
        let six = (0..self.triangles.len()).map(|t| {
            let [a, b, c] = self.corners(t).map(|p| [p[0] - o[0], p[1] - o[1], p[2] - o[2]]);
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        });
        six.sum::<f64>() / 6.0
    }
}

/// From a triangle to a place, metres.
fn distance([a, b, c]: &[Vec3; 3], place: &Vec3) -> f64 {
    let normal = (b - a).cross(&(c - a));
    let is_beside = |p: &Vec3, q: &Vec3| (q - p).cross(&(place - p)).dot(&normal) < 0.0;
    let edges = [(a, b), (b, c), (c, a)];
    if !edges.iter().any(|(p, q)| is_beside(p, q)) && normal != Vec3::zeros() {
        return (place - a).dot(&normal.normalize()).abs();
    }
    let to_edge = |(p, q): &(&Vec3, &Vec3)| {
        let along = *q - *p;
        let share = ((place - *p).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        (*p + along * share - place).norm()
    };
    edges.iter().map(to_edge).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_made_anew_takes_the_items_of_the_nearest_triangles() {
        let sheet = |z: f64, part: u16, soup: &mut Soup| {
            soup.begin_part(part);
            let at = |x: f64, y: f64| [x, y, z];
            let ids = [at(0.0, 0.0), at(4.0, 0.0), at(0.0, 4.0)].map(|v| soup.vertex(v).unwrap());
            soup.triangle(ids);
        };
        let (mut old, mut new) = (Soup::default(), Soup::default());
        sheet(0.0, 0, &mut old);
        sheet(1.0, 3, &mut old);
        sheet(0.9, 0, &mut new);
        sheet(0.1, 0, &mut new);
        new.take_parts(&old);
        assert_eq!(new.part_numbers, [3, 0]);
        assert!((distance(&old.corners(0).map(Vec3::from), &Vec3::new(-3.0, -4.0, 0.0)) - 5.0).abs() < 1e-12);
    }
}
