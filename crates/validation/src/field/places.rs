//! Where a surveyor sets up: on free floor in rooms and around the building, where most is seen that was not seen yet.

use asbuilt_core::geometry::Vec3;
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use super::layout::Layout;
use super::samples::Sample;

/// Height of the scanner above the floor, metres.
const EYE_M: f64 = 1.6;
/// Distance between places that are considered, metres, in rooms and outdoors.
const APART_M: [f64; 2] = [0.9, 3.0];
/// Least height of a room, and most, metres.
const ROOM_M: std::ops::Range<f64> = 1.9..9.0;
/// Free space around the scanner, metres.
const CLEARANCE_M: f64 = 0.45;
/// Distances from the building outdoors, metres.
const OUTDOORS_M: [f64; 2] = [4.5, 8.0];
/// Most samples whose view is planned.
const PLANNED: usize = 5000;
/// A station that shows less than this share of all samples anew is not worth its while.
const MIN_GAIN: f64 = 0.004;
/// Most places that are considered.
const MAX_PLACES: usize = 260;

/// A free place on a floor.
#[derive(Debug, Clone, Copy)]
pub struct Standpoint {
    /// On the floor, world metres.
    pub floor: Vec3,
    /// Whether nothing is above it.
    pub outdoors: bool,
}

impl Standpoint {
    /// Where a scanner on its tripod would be, world metres.
    pub fn eye(&self) -> Vec3 {
        self.floor + Vec3::z() * EYE_M
    }
}

/// Free places in rooms and around the building.
pub fn standpoints(layout: &Layout, rng: &mut ChaCha8Rng) -> Vec<Standpoint> {
    let b = layout.bounds;
    let mut out = Vec::new();
    let offset = [rng.random_range(0.0..APART_M[0]), rng.random_range(0.0..APART_M[0])];
    let steps = |k: usize| ((b.max[k] - b.min[k]) / APART_M[0]).ceil().max(1.0) as usize;
    for i in 0..steps(0) {
        for j in 0..steps(1) {
            let x = b.min[0] + offset[0] + i as f64 * APART_M[0];
            let y = b.min[1] + offset[1] + j as f64 * APART_M[0];
            out.extend(floors(layout, x, y).into_iter().map(|floor| Standpoint { floor, outdoors: false }));
        }
    }
    out.extend(around(layout));
    out.retain(|p| layout.tree.distance(&p.eye(), CLEARANCE_M, |_| true).is_none());
    out
}

/// Floors with a ceiling above them on an upright line.
fn floors(layout: &Layout, x: f64, y: f64) -> Vec<Vec3> {
    let (mut out, mut at) = (Vec::new(), Vec3::new(x, y, layout.bounds.max[2] + 1.0));
    let mut above: Option<f64> = None;
    while let Some(hit) = layout.tree.first(&at, &-Vec3::z(), 1e-4) {
        let z = at.z - hit.range;
        let is_level = hit.normal.z.abs() > 0.9;
        if is_level && above.is_some_and(|a| ROOM_M.contains(&(a - z))) {
            out.push(Vec3::new(x, y, z));
        }
        above = Some(z);
        at.z = z;
    }
    out
}

/// Places around the building, on the terrain or, without one, at the height of its doors.
fn around(layout: &Layout) -> Vec<Standpoint> {
    let b = layout.bounds;
    let ground = layout.ground();
    let mut out = Vec::new();
    for off in OUTDOORS_M {
        let (low, high) = ([b.min[0] - off, b.min[1] - off], [b.max[0] + off, b.max[1] + off]);
        let mut push = |x: f64, y: f64| {
            let from = Vec3::new(x, y, b.max[2] + 5.0);
            let terrain = layout.tree.first(&from, &-Vec3::z(), 0.0).map(|h| from.z - h.range);
            let z = terrain.filter(|z| (z - ground).abs() < 2.0).unwrap_or(ground);
            out.push(Standpoint { floor: Vec3::new(x, y, z), outdoors: true });
        };
        for k in 0..2 {
            let count = ((high[k] - low[k]) / APART_M[1]).ceil().max(1.0) as usize;
            for i in 0..=count {
                let along = low[k] + (high[k] - low[k]) * i as f64 / count as f64;
                for across in [low[1 - k], high[1 - k]] {
                    if k == 0 { push(along, across) } else { push(across, along) }
                }
            }
        }
    }
    out
}

/// At most `count` places, each the one that shows most of what those before it do not.
pub fn chosen(
    layout: &Layout,
    samples: &[Vec<Sample>],
    all: &[Standpoint],
    count: usize,
    rng: &mut ChaCha8Rng,
) -> Vec<Standpoint> {
    let total: usize = samples.iter().map(Vec::len).sum();
    let keep = (PLANNED as f64 / total.max(1) as f64).min(1.0);
    let planned: Vec<(Vec3, Vec3)> =
        samples.iter().flatten().filter(|_| rng.random_bool(keep)).map(|s| (s.place, s.normal)).collect();
    let share = (MAX_PLACES as f64 / all.len().max(1) as f64).min(1.0);
    let candidates: Vec<&Standpoint> = all.iter().filter(|_| rng.random_bool(share)).collect();
    let views: Vec<Vec<u32>> = candidates.par_iter().map(|c| view(layout, &c.eye(), &planned)).collect();
    let mut seen = vec![false; planned.len()];
    let mut out: Vec<Standpoint> = Vec::new();
    while out.len() < count {
        let gain = |v: &Vec<u32>| v.iter().filter(|i| !seen[**i as usize]).count();
        let Some(best) = (0..views.len()).max_by_key(|i| gain(&views[*i])) else { break };
        if (gain(&views[best]) as f64) < MIN_GAIN * planned.len() as f64 {
            break;
        }
        views[best].iter().for_each(|i| seen[*i as usize] = true);
        out.push(*candidates[best]);
    }
    out
}

/// Which samples are seen well from a place in the building as drawn.
fn view(layout: &Layout, eye: &Vec3, samples: &[(Vec3, Vec3)]) -> Vec<u32> {
    const MIN_COS: f64 = 0.26;
    const FAR_M: f64 = 25.0;
    let sees = |(place, normal): &(Vec3, Vec3)| {
        let sight = place - eye;
        let range = sight.norm();
        let direction = sight / range;
        range < FAR_M
            && -direction.dot(normal) > MIN_COS
            && layout.tree.first(eye, &direction, 0.0).is_none_or(|h| h.range > range - 0.003)
    };
    (0..samples.len() as u32).filter(|i| sees(&samples[*i as usize])).collect()
}
