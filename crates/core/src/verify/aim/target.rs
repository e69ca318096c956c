//! A solid made ready for beams: its triangles, who their neighbours are, and balls to cull them by.

use super::triangle::TargetTriangle;
use super::triangle_index::TriangleIndex;
use crate::geometry::{Aabb, Adjacency, BLUNT_EDGE_COS, Closedness, FaceKind, Solid, Vec3};
use crate::{Grow, Interrupt, Result, poll_now_and_then, room};

/// Triangles of one culling chunk.
const CHUNK: usize = 32;
/// Corners nearer to each other than this are one, metres.
const SAME_CORNER_M: f64 = 1e-6;

/// A solid made ready to be crossed. World metres.
#[derive(Debug)]
pub struct Target {
    pub triangles: Vec<TargetTriangle>,
    /// A ball around each run of [`CHUNK`] triangles.
    chunks: Vec<Ball>,
    /// The faces are seen from both sides (an open surface).
    pub two_sided: bool,
    /// Some triangles count only where beams met them.
    pub has_optional: bool,
    /// The triangles by place.
    pub(super) index: TriangleIndex,
}

#[derive(Debug)]
struct Ball {
    centre: Vec3,
    radius: f64,
}

impl Target {
    /// Sorts the triangles with an area into chunks of neighbours.
    pub fn new(solid: &Solid, interrupt: Interrupt) -> Result<Self> {
        let mut triangles = Vec::new();
        triangles.grow(solid.triangles().len(), interrupt)?;
        let place = fill(solid, &mut triangles, interrupt)?;
        let adjacency = Adjacency::of(solid, interrupt)?;
        for t in 0..place.len() {
            poll_now_and_then(t, interrupt)?;
            let across =
                adjacency.neighbours(t).iter().map(|&u| place[u as usize]).filter(|u| *u != TargetTriangle::NONE);
            if place[t] != TargetTriangle::NONE {
                link(place[t] as usize, across, &mut triangles);
            }
        }
        let mut chunks = Vec::with_capacity(triangles.len().div_ceil(CHUNK));
        for chunk in triangles.chunks(CHUNK) {
            poll_now_and_then(chunks.len(), interrupt)?;
            chunks.push(Ball::around(chunk));
        }
        let has_optional = triangles.iter().any(TargetTriangle::is_optional);
        let two_sided = solid.closedness() == Closedness::Open;
        Ok(Self { triangles, chunks, two_sided, has_optional, index: TriangleIndex::default() })
    }

    /// Whether a place on a triangle (world metres) is so near to the outline of the object, as a beam in this direction
    /// sees it, that the beam may pass beside.
    pub fn is_near_outline(&self, triangle: u32, place_world: &Vec3, direction: &Vec3, within: f64) -> bool {
        let triangle = &self.triangles[triangle as usize];
        (0..3).any(|k| {
            let ends = match triangle.across[k] {
                TargetTriangle::NONE => true,
                next => !self.two_sided && self.triangles[next as usize].normal.dot(direction) >= 0.0,
            };
            ends && (triangle.on_edge(k, place_world) - place_world).norm() < within
        })
    }

    /// The numbers of the triangles in each chunk whose ball (centre, radius; world metres) `concerns` lets through.
    pub fn chunks(&self, concerns: impl Fn(&Vec3, f64) -> bool) -> impl Iterator<Item = std::ops::Range<usize>> {
        let run = |i: usize| i * CHUNK..((i + 1) * CHUNK).min(self.triangles.len());
        self.chunks.iter().enumerate().filter(move |(_, b)| concerns(&b.centre, b.radius)).map(move |(i, _)| run(i))
    }
}

/// Adds the triangles with an area, without neighbours yet; for each of the solid's its place, or
/// [`TargetTriangle::NONE`].
fn fill(solid: &Solid, triangles: &mut Vec<TargetTriangle>, interrupt: Interrupt) -> Result<Vec<u32>> {
    let count = solid.triangles().len();
    room::<[u64; 4]>(count, interrupt)?;
    let mut place = vec![TargetTriangle::NONE; count];
    for (t, place) in place.iter_mut().enumerate() {
        poll_now_and_then(t, interrupt)?;
        let corners = solid.corners(t);
        let n = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
        if let Some(normal) = n.try_normalize(1e-12) {
            *place = triangles.len() as u32;
            let kind = FaceKind::of(solid, t);
            let none = [TargetTriangle::NONE; 3];
            triangles.push(TargetTriangle { corners, normal, neighbours: none, across: none, kind });
        }
    }
    Ok(place)
}

/// Notes which neighbours go on across which edge.
fn link(t: usize, across: impl Iterator<Item = u32>, triangles: &mut [TargetTriangle]) {
    for u in across {
        let (here, there) = (&triangles[t], &triangles[u as usize]);
        let shared = |c: &Vec3| there.corners.iter().any(|d| (c - d).norm_squared() <= SAME_CORNER_M * SAME_CORNER_M);
        let [a, b, c] = [0, 1, 2].map(|k| shared(&here.corners[k]));
        let edge = match [a, b, c] {
            [true, true, _] => 0,
            [_, true, true] => 1,
            [true, _, true] => 2,
            _ => continue,
        };
        let goes_on = here.normal.dot(&there.normal) >= BLUNT_EDGE_COS && here.is_optional() == there.is_optional();
        triangles[t].across[edge] = u;
        if goes_on {
            triangles[t].neighbours[edge] = u;
        }
    }
}

impl Ball {
    fn around(triangles: &[TargetTriangle]) -> Self {
        let corners = || triangles.iter().flat_map(|t| t.corners.iter());
        let centre = Aabb::around(corners()).centre();
        Self { centre, radius: corners().map(|c| (c - centre).norm()).fold(0.0, f64::max) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use proptest::prelude::*;

    fn shared_corners(a: &TargetTriangle, b: &TargetTriangle) -> usize {
        a.corners.iter().filter(|c| b.corners.iter().any(|d| (*c - d).norm() < 1e-9)).count()
    }

    /// Across blunt edges the surface goes on, and back; across sharp ones it ends.
    #[test]
    fn neighbours_are_those_that_a_search_finds() {
        let column = Solid::cylinder([0.0; 3], 0.2, 3.0, 48).unwrap();
        let cube = Solid::cuboid([0.0; 3], [1.0; 3]).unwrap();
        for (solid, lateral_edges) in [(column, 3), (cube, 1)] {
            let target = Target::new(&solid, NEVER).unwrap();
            let all = &target.triangles;
            for (i, t) in all.iter().enumerate() {
                let mut found: Vec<u32> = t.neighbours.into_iter().filter(|n| *n != TargetTriangle::NONE).collect();
                found.sort_unstable();
                let goes_on = |(j, u): &(usize, &TargetTriangle)| {
                    *j != i && shared_corners(t, u) == 2 && t.normal.dot(&u.normal) >= BLUNT_EDGE_COS
                };
                let searched: Vec<u32> = all.iter().enumerate().filter(goes_on).map(|(j, _)| j as u32).collect();
                assert_eq!(found, searched, "triangle {i}");
                assert!(found.len() <= lateral_edges && !found.is_empty());
                for (k, &n) in t.neighbours.iter().enumerate().filter(|(_, n)| **n != TargetTriangle::NONE) {
                    assert!(all[n as usize].neighbours.contains(&(i as u32)));
                    let [a, b] = [k, (k + 1) % 3].map(|c| t.corners[c]);
                    let has = |c: Vec3| all[n as usize].corners.iter().any(|d| (c - d).norm() < 1e-9);
                    assert!(has(a) && has(b), "edge {k} of triangle {i}");
                }
            }
        }
    }

    proptest! {
        /// No triangle near a point is in a chunk that is left out.
        #[test]
        fn chunks_lose_nothing(at in prop::array::uniform3(-1.0..4.0f64), radius in 0.0..1.5f64) {
            let target = Target::new(&Solid::cylinder([0.0; 3], 0.2, 3.0, 200).unwrap(), NEVER).unwrap();
            let at = Vec3::from(at);
            let near = |centre: &Vec3, r: f64| (centre - at).norm() <= r + radius;
            let found: Vec<usize> = target.chunks(near).flatten().collect();
            for (t, triangle) in target.triangles.iter().enumerate() {
                let is_near = triangle.corners.iter().any(|c| (c - at).norm() <= radius);
                prop_assert!(!is_near || found.contains(&t));
            }
            prop_assert_eq!(target.chunks(|_, _| true).flatten().count(), target.triangles.len());
        }
    }
}
