//! A door or a window in its own plane: its outline, and the pieces that it consists of.

use std::collections::BTreeMap;

use asbuilt_core::geometry::Vec3;

use super::Product;

/// Places that differ by less than this share of the object's extent are the same: 5 mm of 1 m.
const SAME: f64 = 0.005;
/// What stands on the floor, as a threshold does, ends as far below as the object, metres; a leaf hangs higher.
const ON_FLOOR_M: f64 = 0.002;
/// Cosine between directions that are the same.
const PARALLEL: f64 = 0.999;
/// Most directions that an object's faces are sorted into: its own are among the largest.
const MAX_DIRECTIONS: usize = 64;

/// From the smallest to the largest, along each axis of the outline.
type Extent = [[f64; 2]; 3];

/// A piece of an object.
#[derive(Debug, Clone)]
pub struct Unit {
    pub part: u16,
    pub triangles: Vec<usize>,
    /// Across, upwards and through the object's plane; metres, as everything here.
    extent: Extent,
}

impl Unit {
    /// What surrounds them all.
    pub fn around(units: &[&Self]) -> Self {
        let triangles = units.iter().flat_map(|u| u.triangles.iter().copied()).collect();
        let extent = units.iter().fold(NOTHING, |all, u| join(&all, &u.extent));
        Self { part: units.first().map_or(0, |u| u.part), triangles, extent }
    }
}

const NOTHING: Extent = [[f64::INFINITY, f64::NEG_INFINITY]; 3];

fn join(a: &Extent, b: &Extent) -> Extent {
    std::array::from_fn(|k| [a[k][0].min(b[k][0]), a[k][1].max(b[k][1])])
}

/// An object's plane, and how far it extends in it.
#[derive(Debug)]
pub struct Outline {
    /// Across, upwards, and perpendicular to the plane; world directions.
    axes: [Vec3; 3],
    origin: Vec3,
    extent: Extent,
}

impl Outline {
    /// The plane that most of the surface is parallel to; `None` for a mesh without area.
    pub fn of(product: &Product) -> Option<Self> {
        let directions = directions(product);
        let through = largest(&directions, |_| true)?;
        let up = Vec3::z() - through * through.z;
        let up = match up.try_normalize(0.3) {
            Some(up) => up,
            None => {
                let aside = largest(&directions, |n| n.dot(&through).abs() < 0.1).unwrap_or(Vec3::x());
                (aside - through * aside.dot(&through)).try_normalize(1e-6)?
            }
        };
        let origin = Vec3::from(*product.vertices.first()?);
        let mut outline = Self { axes: [up.cross(&through), up, through], origin, extent: NOTHING };
        outline.extent = outline.extent_of(product, 0..product.triangles.len());
        Some(outline)
    }

    fn local(&self, v: [f64; 3]) -> [f64; 3] {
        self.axes.map(|axis| axis.dot(&(Vec3::from(v) - self.origin)))
    }

    fn corners(&self, product: &Product, t: usize) -> [[f64; 3]; 3] {
        product.triangles[t].map(|i| self.local(product.vertices[i as usize]))
    }

    fn extent_of(&self, product: &Product, triangles: impl Iterator<Item = usize>) -> Extent {
        let corners = triangles.flat_map(|t| self.corners(product, t));
        corners.fold(NOTHING, |all, c| join(&all, &c.map(|x| [x, x])))
    }

    fn unit(&self, product: &Product, part: u16, triangles: Vec<usize>) -> Unit {
        let extent = self.extent_of(product, triangles.iter().copied());
        Unit { part, triangles, extent }
    }

    pub fn units_by_part(&self, product: &Product) -> Vec<Unit> {
        let mut of_part: Vec<Vec<usize>> = vec![Vec::new(); product.parts.len()];
        product.part_numbers.iter().enumerate().for_each(|(t, &p)| of_part[usize::from(p)].push(t));
        let drawn = of_part.into_iter().enumerate().filter(|(_, triangles)| !triangles.is_empty());
        drawn.map(|(p, triangles)| self.unit(product, p as u16, triangles)).collect()
    }

    /// The pieces of each part that hang together by their vertices.
    pub fn units_by_component(&self, product: &Product) -> Vec<Unit> {
        let mut all = Vec::new();
        for unit in self.units_by_part(product) {
            let mut joined = Joined::new(product.vertices.len());
            for &t in &unit.triangles {
                let [a, b, c] = product.triangles[t].map(|v| v as usize);
                joined.join(a, b);
                joined.join(b, c);
            }
            let mut pieces: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
            for &t in &unit.triangles {
                pieces.entry(joined.root(product.triangles[t][0] as usize)).or_default().push(t);
            }
            all.extend(pieces.into_values().map(|triangles| self.unit(product, unit.part, triangles)));
        }
        all
    }

    /// What is the same along an axis, metres.
    fn same(&self, k: usize) -> f64 {
        SAME * (self.extent[k][1] - self.extent[k][0])
    }

    /// Whether a piece reaches the object's outline; below only if it is no higher than this share of the object.
    pub fn is_reached_by(&self, unit: &Unit, highest: f64) -> bool {
        let reaches = |k: usize, end: usize| (unit.extent[k][end] - self.extent[k][end]).abs() <= self.same(k);
        let height = |e: &Extent| e[1][1] - e[1][0];
        let is_low = height(&unit.extent) <= highest * height(&self.extent);
        let is_on_floor = (unit.extent[1][0] - self.extent[1][0]).abs() <= ON_FLOOR_M;
        reaches(0, 0) || reaches(0, 1) || reaches(1, 1) || (is_on_floor && is_low)
    }

    /// Whether a piece lies within another, seen along the normal of the plane.
    pub fn is_within(&self, unit: &Unit, other: &Unit) -> bool {
        (0..2).all(|k| {
            let [low, high] = other.extent[k];
            unit.extent[k][0] >= low - self.same(k) && unit.extent[k][1] <= high + self.same(k)
        })
    }

    /// Whether pieces together are at least this share of the object, across and upwards.
    pub fn is_large(&self, units: &[&Unit], share: f64) -> bool {
        let around = Unit::around(units).extent;
        (0..2).all(|k| around[k][1] - around[k][0] >= share * (self.extent[k][1] - self.extent[k][0]))
    }

    /// How much of the rectangle around a piece its front fills.
    pub fn fill(&self, unit: &Unit, product: &Product) -> f64 {
        let front = |&t: &usize| {
            let [a, b, c] = self.corners(product, t);
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])).max(0.0)
        };
        let [u, v, _] = unit.extent.map(|[low, high]| high - low);
        unit.triangles.iter().map(front).sum::<f64>() / (u * v).max(f64::MIN_POSITIVE)
    }

    /// Along which shares of their left, right and lower side pieces stand.
    pub fn sides(&self, units: &[&Unit], product: &Product) -> [f64; 3] {
        let around = Unit::around(units);
        [(0, 0), (0, 1), (1, 0)].map(|(k, end)| {
            let (along, edge) = (1 - k, around.extent[k][end]);
            let is_at_edge = |c: &[f64; 3]| (c[k] - edge).abs() <= 2.0 * self.same(k);
            let span = |&t: &usize| {
                let ends = self.corners(product, t).into_iter().filter(is_at_edge).map(|c| c[along]);
                ends.fold([f64::INFINITY, f64::NEG_INFINITY], |s, x| [s[0].min(x), s[1].max(x)])
            };
            let spans = around.triangles.iter().map(span).filter(|s| s[0] < s[1]).collect();
            covered(spans) / (around.extent[along][1] - around.extent[along][0]).max(f64::MIN_POSITIVE)
        })
    }

    /// Pieces that touch each other, together.
    pub fn groups<'u>(&self, units: Vec<&'u Unit>) -> Vec<Vec<&'u Unit>> {
        let mut joined = Joined::new(units.len());
        for (i, a) in units.iter().enumerate() {
            for (j, b) in units.iter().enumerate().skip(i + 1) {
                let near = |k: usize| {
                    let gap = a.extent[k][0].max(b.extent[k][0]) - a.extent[k][1].min(b.extent[k][1]);
                    gap <= self.same(k.min(1))
                };
                if (0..3).all(near) {
                    joined.join(i, j);
                }
            }
        }
        let mut groups: BTreeMap<usize, Vec<&Unit>> = BTreeMap::new();
        units.iter().enumerate().for_each(|(i, u)| groups.entry(joined.root(i)).or_default().push(u));
        groups.into_values().collect()
    }
}

/// Total length of intervals, overlaps once.
fn covered(mut spans: Vec<[f64; 2]>) -> f64 {
    spans.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (mut sum, mut to) = (0.0, f64::NEG_INFINITY);
    for [low, high] in spans {
        sum += (high - low.max(to)).max(0.0);
        to = to.max(high);
    }
    sum
}

/// Sets of numbers that are joined step by step.
struct Joined(Vec<usize>);

impl Joined {
    fn new(n: usize) -> Self {
        Self((0..n).collect())
    }

    fn root(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
    }
}

/// Directions of faces, signs apart, with the areas that look there.
fn directions(product: &Product) -> Vec<(Vec3, f64)> {
    let mut found: Vec<(Vec3, f64)> = Vec::new();
    for t in &product.triangles {
        let [a, b, c] = t.map(|i| Vec3::from(product.vertices[i as usize]));
        let normal = (b - a).cross(&(c - a));
        let Some(n) = normal.try_normalize(1e-12) else { continue };
        let area = 0.5 * normal.norm();
        match found.iter().position(|(known, _)| known.dot(&n).abs() > PARALLEL) {
            Some(known) => found[known].1 += area,
            None if found.len() < MAX_DIRECTIONS => found.push((n, area)),
            None => {}
        }
    }
    found
}

fn largest(directions: &[(Vec3, f64)], is_asked: impl Fn(&Vec3) -> bool) -> Option<Vec3> {
    let asked = directions.iter().filter(|(n, _)| is_asked(n));
    asked.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(n, _)| *n)
}
