//! The objects as they were built, as surfaces that a scanner sees.

use asbuilt_core::geometry::Vec3;
use asbuilt_fieldscan::{Material, Surface, Tree, Triangle, World};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::fate::{Cut, Deed, Fate};
use super::layout::{Kind, Layout, Object};

/// An uneven slab is made of triangles with edges of at most this, metres.
const PIECE_M: f64 = 0.4;
/// Standard deviation of what ranges to an object have wrong by its material, metres.
pub const SIGMA_BIAS_M: f64 = 0.0005;

/// One built object: its triangles with the number of the drawn one in their place of the surface's.
#[derive(Debug, Default)]
pub struct Standing {
    /// Empty for a missing object.
    pub tree: Tree,
}

/// Objects as built, one for each, in their order.
pub fn standing(layout: &Layout, fates: &[Fate]) -> Vec<Standing> {
    layout.objects.iter().zip(fates).map(|(o, f)| Standing { tree: Tree::new(built(o, f)) }).collect()
}

/// Adds what stands to a world; the owner of a surface is the object's number.
pub fn furnish(world: &mut World, layout: &Layout, standing: &[Standing], rng: &mut ChaCha8Rng) {
    for (i, (object, own)) in layout.objects.iter().zip(standing).enumerate() {
        let matt = paint(object, rng);
        for (clear, material) in [(false, matt), (true, Material::glass())] {
            let triangles: Vec<[Vec3; 3]> = own
                .tree
                .triangles()
                .iter()
                .filter(|t| object.transparent[t.surface as usize] == clear)
                .map(|t| t.corners)
                .collect();
            if !triangles.is_empty() {
                world.add(Surface { material, owner: i as u32 }, triangles);
            }
        }
    }
}

fn built(object: &Object, fate: &Fate) -> Vec<Triangle> {
    if fate.deed == Deed::Missing {
        return Vec::new();
    }
    let mut out = Vec::new();
    for t in 0..object.solid.triangles().len() {
        let mut pieces = Vec::new();
        let most = if fate.wave.is_some() { PIECE_M } else { f64::INFINITY };
        let mut kept = Vec::new();
        clip(object.solid.corners(t), fate.cut.as_ref(), object, &mut kept);
        kept.into_iter().for_each(|corners| cut(corners, most, &mut pieces));
        let place = |c: [Vec3; 3]| c.map(|p| fate.place(&p, object.leaf[t]));
        out.extend(pieces.into_iter().map(|c| Triangle { corners: place(c), surface: t as u32 }));
    }
    out
}

/// What lies on the built side of a cut, and the part of the cut's face that belongs to it: from the middle of the object
/// on the plane, which closes what is convex.
fn clip(corners: [Vec3; 3], cut: Option<&Cut>, object: &Object, out: &mut Vec<[Vec3; 3]>) {
    let Some(cut) = cut else { return out.push(corners) };
    let beyond = corners.map(|c| cut.beyond(&c));
    let (mut kept, mut edge) = (Vec::new(), Vec::new());
    for k in 0..3 {
        let (a, b) = (beyond[k], beyond[(k + 1) % 3]);
        if a <= 0.0 {
            kept.push(corners[k]);
        }
        if (a <= 0.0) != (b <= 0.0) {
            let crossing = corners[k] + (corners[(k + 1) % 3] - corners[k]) * (a / (a - b));
            kept.push(crossing);
            edge.push(crossing);
        }
    }
    out.extend((2..kept.len()).map(|k| [kept[0], kept[k - 1], kept[k]]));
    if let [a, b] = edge[..] {
        let centre = object.solid.bounds().centre();
        let middle = centre - cut.normal * cut.beyond(&centre);
        let faces_out = (a - middle).cross(&(b - middle)).dot(&cut.normal) > 0.0;
        out.push(if faces_out { [middle, a, b] } else { [middle, b, a] });
    }
}

/// Halves the longest edge until none exceeds `most` metres; neighbours cut a common edge in the same way.
fn cut(corners: [Vec3; 3], most: f64, out: &mut Vec<[Vec3; 3]>) {
    let length = |k: usize| (corners[(k + 1) % 3] - corners[k]).norm();
    let k = (0..3).max_by(|&a, &b| length(a).total_cmp(&length(b))).unwrap_or(0);
    if length(k) <= most {
        return out.push(corners);
    }
    let [a, b, c] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
    let middle = 0.5 * (a + b);
    cut([a, middle, c], most, out);
    cut([middle, b, c], most, out);
}

/// How bright a kind of object is, in the near infrared; each one a little otherwise.
fn paint(object: &Object, rng: &mut ChaCha8Rng) -> Material {
    let bright = match object.kind {
        Kind::Structure => 0.6,
        Kind::Glazed => 0.55,
        Kind::Door => 0.45,
        Kind::Furniture => [0.12, 0.35, 0.5, 0.7][rng.random_range(0..4)],
        Kind::Slim => 0.35,
    };
    let reflectivity = (bright * rng.random_range(0.7..1.3f64)).clamp(0.05, 0.9);
    let bias: f64 = StandardNormal.sample(rng);
    Material::matt(reflectivity, SIGMA_BIAS_M * bias)
}

impl Standing {
    /// Distance, metres, of a place from the surface that looks within 45° of `normal` there (or away from it, where
    /// triangles do not tell their outside); `None` beyond `reach`.
    pub fn distance(&self, place: &Vec3, normal: &Vec3, is_closed: bool, reach: f64) -> Option<f64> {
        self.tree.distance(place, reach, |t| turn(t, normal, is_closed) > MIN_TURN_COS)
    }

    /// Where the surface crosses the normal of a place, metres along it: the crossing nearest to it, within `reach`.
    pub fn deviation(&self, place: &Vec3, normal: &Vec3, is_closed: bool, reach: f64) -> Option<f64> {
        let mut best: Option<f64> = None;
        self.tree.near(place, reach, |t| {
            if turn(t, normal, is_closed) <= MIN_TURN_COS {
                return;
            }
            let crossing = t.crossing(place, normal).filter(|d| d.abs() <= reach);
            if let Some(d) = crossing.filter(|d| best.is_none_or(|b: f64| d.abs() < b.abs())) {
                best = Some(d);
            }
        });
        best
    }
}

/// A built surface belongs to a drawn one that looks its way.
const MIN_TURN_COS: f64 = 0.7;

fn turn(t: &Triangle, normal: &Vec3, is_closed: bool) -> f64 {
    let cos = t.normal().dot(normal);
    if is_closed { cos } else { cos.abs() }
}
