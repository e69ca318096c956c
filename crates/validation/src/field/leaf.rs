//! Which triangles of a door are its leaves.

use std::cmp::Ordering;
use std::collections::HashMap;

use asbuilt_core::geometry::{Solid, Vec3};

/// Vertices on the same cell of this grid are one, metres.
const WELD_M: f64 = 1e-4;
/// Least width and height of a leaf, as shares of the door's.
const MIN_WIDTH: f64 = 0.35;
const MIN_HEIGHT: f64 = 0.7;
/// Least share of its outline that a leaf covers, seen from the front; a ring with a pane in it covers less.
const MIN_COVERED: f64 = 0.5;
/// A ring as wide as this share of the door is its lining; a narrower one is a leaf's own frame.
const LINING: f64 = 0.97;
/// What lies within a leaf's outline turns with it: handles, panels, panes; metres of grace.
const GRACE_M: f64 = 0.01;

/// The number of the leaf that each triangle turns with; `parts`: number of the representation item of each.
pub fn leaves(door: &Solid, parts: &[usize]) -> Vec<Option<usize>> {
    let Some(across) = main_normal(door) else { return vec![None; door.triangles().len()] };
    let component = components(door, parts);
    let mut pieces: HashMap<usize, Piece> = HashMap::new();
    for (t, root) in component.iter().enumerate() {
        pieces.entry(*root).or_default().add(&door.corners(t), &across);
    }
    let mut whole = Piece::default();
    pieces.values().for_each(|p| whole.join(p));
    let mut leaves: Vec<&Piece> = pieces.values().filter(|p| p.is_leaf(&whole)).collect();
    // The widest first: a pane turns with the frame around it.
    leaves.sort_by(|a, b| (b.width(), a.min.x).partial_cmp(&(a.width(), b.min.x)).unwrap_or(Ordering::Equal));
    let turns_with = |piece: &Piece| {
        let leaf = leaves.iter().position(|l| piece.is_within(l));
        leaf.filter(|_| !piece.is_lining(&whole))
    };
    let leaf_of: HashMap<usize, Option<usize>> = pieces.iter().map(|(root, p)| (*root, turns_with(p))).collect();
    component.iter().map(|root| leaf_of[root]).collect()
}

/// The extent of connected triangles, in the door's own axes: along its width, up, across.
#[derive(Debug, Clone)]
struct Piece {
    min: Vec3,
    max: Vec3,
    /// Its triangles, along the width and up.
    outline: Vec<[[f64; 2]; 3]>,
}

impl Default for Piece {
    fn default() -> Self {
        Self { min: Vec3::repeat(f64::INFINITY), max: Vec3::repeat(f64::NEG_INFINITY), outline: Vec::new() }
    }
}

impl Piece {
    fn add(&mut self, corners: &[Vec3; 3], across: &Vec3) {
        let along = across.cross(&Vec3::z());
        let own = corners.map(|c| Vec3::new(c.dot(&along), c.z, c.dot(across)));
        own.iter().for_each(|c| (self.min, self.max) = (self.min.inf(c), self.max.sup(c)));
        self.outline.push(own.map(|c| [c.x, c.y]));
    }

    fn join(&mut self, other: &Self) {
        (self.min, self.max) = (self.min.inf(&other.min), self.max.sup(&other.max));
    }

    fn width(&self) -> f64 {
        self.max.x - self.min.x
    }

    fn is_leaf(&self, whole: &Self) -> bool {
        let (size, all) = (self.max - self.min, whole.max - whole.min);
        let is_large = size.x >= MIN_WIDTH * all.x && size.y >= MIN_HEIGHT * all.y && size.z < 0.5 * size.x;
        is_large && !self.is_lining(whole)
    }

    fn is_lining(&self, whole: &Self) -> bool {
        self.width() >= LINING * whole.width() && self.covered() < MIN_COVERED
    }

    /// Share of its outline's box that it covers, seen from the front, on a lattice of points.
    fn covered(&self) -> f64 {
        const LATTICE: usize = 15;
        let size = self.max - self.min;
        let at = |i: usize, k: usize| self.min[k] + size[k] * (i as f64 + 0.5) / LATTICE as f64;
        let points = (0..LATTICE * LATTICE).map(|i| [at(i % LATTICE, 0), at(i / LATTICE, 1)]);
        let hits = points.filter(|p| self.outline.iter().any(|t| holds(t, *p))).count();
        hits as f64 / (LATTICE * LATTICE) as f64
    }

    fn is_within(&self, leaf: &Self) -> bool {
        (0..2).all(|k| self.min[k] >= leaf.min[k] - GRACE_M && self.max[k] <= leaf.max[k] + GRACE_M)
            && self.min.z > leaf.min.z - 0.15
            && self.max.z < leaf.max.z + 0.15
    }
}

/// Whether a triangle holds a point, whichever way it turns.
fn holds(t: &[[f64; 2]; 3], p: [f64; 2]) -> bool {
    let side = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    let sides = [side(t[0], t[1]), side(t[1], t[2]), side(t[2], t[0])];
    sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0)
}

/// The horizontal direction in which most of a door's upright surface looks.
fn main_normal(door: &Solid) -> Option<Vec3> {
    let upright: Vec<(Vec3, f64)> = (0..door.triangles().len())
        .filter_map(|t| {
            let [a, b, c] = door.corners(t);
            let twice = (b - a).cross(&(c - a));
            let normal = twice.try_normalize(1e-12)?;
            (normal.z.abs() < 0.1).then(|| (Vec3::new(normal.x, normal.y, 0.0).normalize(), twice.norm()))
        })
        .collect();
    let mut largest = upright.clone();
    largest.sort_by(|a, b| b.1.total_cmp(&a.1));
    let weight = |n: &Vec3| upright.iter().filter(|(m, _)| m.dot(n).abs() > 0.99).map(|(_, a)| a).sum::<f64>();
    largest.iter().take(40).map(|(n, _)| *n).max_by(|a, b| weight(a).total_cmp(&weight(b)))
}

/// For every triangle the number of the connected piece it belongs to; a leaf that fits its lining is a part of its own.
fn components(solid: &Solid, parts: &[usize]) -> Vec<usize> {
    let mut known: HashMap<(usize, [i64; 3]), usize> = HashMap::new();
    let mut welded = |t: usize| {
        solid.corners(t).map(|v| {
            let next = known.len();
            *known.entry((parts[t], [v.x, v.y, v.z].map(|c| (c / WELD_M).round() as i64))).or_insert(next)
        })
    };
    let corners: Vec<[usize; 3]> = (0..solid.triangles().len()).map(&mut welded).collect();
    let mut parent: Vec<usize> = (0..known.len()).collect();
    for t in &corners {
        let [a, b, c] = t.map(|v| root(&mut parent, v));
        parent[b] = a;
        let c = root(&mut parent, c);
        parent[c] = a;
    }
    corners.iter().map(|t| root(&mut parent, t[0])).collect()
}

fn root(parent: &mut [usize], mut at: usize) -> usize {
    while parent[at] != at {
        parent[at] = parent[parent[at]];
        at = parent[at];
    }
    at
}

/// The hinge of a leaf, a point on its axis, and the sense in which it turns: at its end nearest to the door's end; of a
/// single leaf at either (`other_end`). World metres.
pub fn hinge(door: &Solid, leaf: &[Option<usize>], number: usize, other_end: bool) -> Option<Vec3> {
    let across = main_normal(door)?;
    let along = across.cross(&Vec3::z());
    let (mut whole, mut own) = (Piece::default(), Piece::default());
    for (t, of) in leaf.iter().enumerate() {
        whole.add(&door.corners(t), &across);
        if *of == Some(number) {
            own.add(&door.corners(t), &across);
        }
    }
    let is_single = leaf.iter().flatten().all(|n| *n == number);
    let at_low = own.min.x - whole.min.x <= whole.max.x - own.max.x;
    let at_low = if is_single { other_end } else { at_low };
    let end = if at_low { own.min.x } else { own.max.x };
    Some(along * end + across * (0.5 * (own.min.z + own.max.z)) + Vec3::z() * own.min.y)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn boxes(all: &[([f64; 3], [f64; 3])]) -> Solid {
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for (min, max) in all {
            let cuboid = Solid::cuboid(*min, *max).unwrap();
            let first = vertices.len() as u32;
            vertices.extend_from_slice(cuboid.vertices());
            triangles.extend(cuboid.triangles().iter().map(|t| t.map(|v| v + first)));
        }
        Solid::new(vertices, triangles).unwrap()
    }

    #[test]
    fn a_leaf_in_its_lining_with_a_handle() {
        let lining = [([0.0, 0.0, 0.0], [0.05, 0.1, 2.1]), ([0.95, 0.0, 0.0], [1.0, 0.1, 2.1])];
        let leaf = ([0.052, 0.02, 0.01], [0.948, 0.06, 2.04]);
        let handle = ([0.8, -0.04, 1.0], [0.9, 0.015, 1.05]);
        let door = boxes(&[lining[0], lining[1], leaf, handle]);
        let leaf = leaves(&door, &vec![0; door.triangles().len()]);
        let (fixed, turns) = leaf.split_at(24);
        assert!(fixed.iter().all(Option::is_none) && turns.iter().all(|l| *l == Some(0)), "{leaf:?}");
        let hinge = hinge(&door, &leaf, 0, true).unwrap();
        assert!((hinge.x - 0.052).abs() < 1e-9 || (hinge.x - 0.948).abs() < 1e-9, "{hinge}");
    }

    #[test]
    fn a_glazed_leaf_turns_with_its_pane_and_its_lining_does_not() {
        let ring = |low: f64, high: f64, top: f64, y: [f64; 2]| {
            let jamb = |x: f64| ([x, y[0], 0.0], [x + 0.1, y[1], top]);
            [jamb(low), jamb(high - 0.1), ([low, y[0], top - 0.1], [high, y[1], top])]
        };
        let pane = ([0.15, 0.04, 0.1], [0.85, 0.06, 1.9]);
        let door = boxes(&[&ring(0.0, 1.0, 2.1, [0.0, 0.1])[..], &[pane]].concat());
        let leaf = leaves(&door, &vec![0; door.triangles().len()]);
        let count = leaf.iter().filter(|l| l.is_some()).count();
        assert_eq!(count, 12, "the pane alone is large enough to be a leaf: {leaf:?}");
    }

    #[test]
    fn two_leaves_turn_at_their_outer_ends() {
        let door = boxes(&[([0.0, 0.0, 0.0], [0.7, 0.04, 2.0]), ([0.71, 0.0, 0.0], [1.4, 0.04, 2.0])]);
        let leaf = leaves(&door, &vec![0; door.triangles().len()]);
        let ends: Vec<f64> = [0, 1].map(|n| hinge(&door, &leaf, n, false).unwrap().x).into();
        assert!(ends.iter().any(|e| e.abs() < 1e-9) && ends.iter().any(|e| (e - 1.4).abs() < 1e-9), "{ends:?}");
    }
}
