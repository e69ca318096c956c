//! Surfaces in EWKB whose rings cross, touch, repeat and fold back: what cuts faces into triangles must end.

use rand::Rng;
use rand_chacha::ChaCha8Rng;

type Ring = Vec<[f64; 3]>;

const POLYGON: u32 = 0x8000_0003;
const SURFACE: u32 = 0x8000_000f;

fn polygon(rings: &[Ring]) -> Vec<u8> {
    let mut b = head(POLYGON, rings.len());
    for ring in rings {
        b.extend((ring.len() as u32).to_le_bytes());
        b.extend(ring.iter().flatten().flat_map(|c| c.to_le_bytes()));
    }
    b
}

fn head(ty: u32, count: usize) -> Vec<u8> {
    let mut b = vec![1];
    b.extend(ty.to_le_bytes());
    b.extend((count as u32).to_le_bytes());
    b
}

/// A polygon on which the triangulation once did not end.
fn known() -> Vec<u8> {
    polygon(&[
        vec![[2.5, 0.0, 0.0], [1.75, 0.75, 0.0], [3.25, 0.25, 0.0], [2.5, 0.0, 0.0]],
        vec![[0.0, 0.0, 0.0], [2.5, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
        vec![[3.5, 1.75, 0.0], [0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.5, 1.75, 0.0]],
    ])
}

/// A closed ring on a coarse grid, so that points, edges and whole rings fall together.
fn ring(rng: &mut ChaCha8Rng, upright: bool) -> Ring {
    let n = rng.random_range(3..9);
    let mut quarter = || f64::from(rng.random_range(0..16)) * 0.25;
    let mut ring: Ring =
        (0..n).map(|_| if upright { [quarter(), 0.0, quarter()] } else { [quarter(), quarter(), 0.0] }).collect();
    ring.push(ring[0]);
    ring
}

fn random(rng: &mut ChaCha8Rng) -> Vec<u8> {
    let upright = rng.random_bool(0.3);
    let rings: Vec<Ring> = (0..rng.random_range(1..5)).map(|_| ring(rng, upright)).collect();
    if rng.random_bool(0.7) {
        return polygon(&rings);
    }
    let mut surface = head(SURFACE, rings.len());
    rings.iter().for_each(|r| surface.extend(polygon(std::slice::from_ref(r))));
    surface
}

/// The known one and others of its kind, as hex.
pub fn polygons(rng: &mut ChaCha8Rng, n: usize) -> Vec<String> {
    let mut all = vec![known()];
    all.extend((0..n).map(|_| random(rng)));
    all.iter().map(|b| crate::session::hex(b)).collect()
}
