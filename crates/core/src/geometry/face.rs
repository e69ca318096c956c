//! Faces: the nearly plane pieces of a mesh, each judged as one.

use std::cmp::Reverse;

use super::adjacency::Adjacency;
use super::{FaceKind, Solid, Vec3};
use crate::num::piece_map::PieceMap;
use crate::num::sort::sort;
use crate::{Interrupt, Result, poll_now_and_then, room};

/// Triangles may share a face only if their normals differ from its first triangle's by no more than this.
const MAX_TURN_COS: f64 = 0.990_268_068_741_570; // cos 8°
/// Triangles may share a face only if their corners lie no farther than this from its plane.
const MAX_OFF_PLANE_M: f64 = 0.005;
/// Across an edge that turns by no more than 30° a surface continues. A bit less than √3/2, so that the lateral surface
/// of a column with twelve facets is smooth however it is rounded.
pub(crate) const BLUNT_EDGE_COS: f64 = 0.866;

/// The faces of a solid.
#[derive(Debug, Clone)]
pub struct Faces {
    /// For each triangle its face; degenerate triangles (no area) have [`Faces::NONE`].
    pub of_triangle: Vec<u32>,
    /// For each face its unit normal, outward where the solid is closed.
    pub normals: Vec<Vec3>,
    /// For each face the smooth surface that it is a facet of, counted from 0. A plane face is a smooth surface by
    /// itself.
    pub surface_of_face: Vec<u32>,
    /// For each face what it belongs to.
    pub kinds: Vec<FaceKind>,
}

impl Faces {
    /// The face of a triangle that has no area.
    pub const NONE: u32 = u32::MAX;
}

/// Groups triangles into nearly plane faces: grows each over shared edges, largest triangles first, then joins
/// faces of one plane (both sides of a door, tops of many parts).
pub fn group_faces(solid: &Solid, interrupt: Interrupt) -> Result<Faces> {
    // Planes, faces, order and parents of as many triangles.
    room::<[u64; 16]>(solid.triangles().len(), interrupt)?;
    let planes = planes(solid, interrupt)?;
    let adjacency = Adjacency::of(solid, interrupt)?;
    let of_triangle = vec![Faces::NONE; planes.len()];
    let mut faces = Faces { of_triangle, normals: Vec::new(), surface_of_face: Vec::new(), kinds: Vec::new() };
    let mut by_plane: PieceMap<([i64; 4], FaceKind), u32> = PieceMap::default();
    let centre = solid.bounds().centre();
    for (round, seed) in largest_first(&planes, interrupt)?.into_iter().enumerate() {
        poll_now_and_then(round, interrupt)?;
        let Some(plane) = planes[seed as usize] else { continue };
        if faces.of_triangle[seed as usize] != Faces::NONE {
            continue;
        }
        let (fresh, kind) = (faces.normals.len() as u32, FaceKind::of(solid, seed as usize));
        let face = *by_plane.made_by((plane.key(&centre), kind), || fresh, interrupt)?;
        if face == fresh {
            faces.normals.push(plane.normal);
            faces.kinds.push(kind);
        }
        let joins = |t: usize| {
            FaceKind::of(solid, t) == kind
                && planes[t].is_some_and(|p| p.normal.dot(&plane.normal) >= MAX_TURN_COS)
                && solid.corners(t).iter().all(|c| (c - plane.point).dot(&plane.normal).abs() <= MAX_OFF_PLANE_M)
        };
        grow(seed, face, &adjacency, joins, &mut faces.of_triangle, interrupt)?;
    }
    faces.surface_of_face = smooth_surfaces(&faces, &planes, &adjacency, interrupt)?;
    Ok(faces)
}

/// Joins faces that meet at a blunt edge: the facets of a column, a pipe, a bent wall.
fn smooth_surfaces(
    faces: &Faces,
    planes: &[Option<TrianglePlane>],
    adjacency: &Adjacency,
    interrupt: Interrupt,
) -> Result<Vec<u32>> {
    let mut parent: Vec<u32> = (0..faces.normals.len() as u32).collect();
    for (t, &f) in faces.of_triangle.iter().enumerate() {
        poll_now_and_then(t, interrupt)?;
        for &u in adjacency.neighbours(t) {
            let g = faces.of_triangle[u as usize];
            let (Some(a), Some(b)) = (planes[t], planes[u as usize]) else { continue };
            let alike = g != Faces::NONE && faces.kinds[f.min(g) as usize] == faces.kinds[g as usize];
            if f < g && alike && a.normal.dot(&b.normal) >= BLUNT_EDGE_COS {
                let (f, g) = (root(&mut parent, f), root(&mut parent, g));
                parent[f.max(g) as usize] = f.min(g);
            }
        }
    }
    // Roots come before their members: number them as they come.
    let mut number = vec![0; parent.len()];
    let mut count = 0;
    for f in 0..parent.len() as u32 {
        let r = root(&mut parent, f);
        if r == f {
            number[f as usize] = count;
            count += 1;
        } else {
            number[f as usize] = number[r as usize];
        }
    }
    Ok(number)
}

/// The representative of the set (union-find with path halving).
fn root(parent: &mut [u32], mut i: u32) -> u32 {
    while parent[i as usize] != i {
        parent[i as usize] = parent[parent[i as usize] as usize];
        i = parent[i as usize];
    }
    i
}

/// Floods `face` from `seed` over shared edges to the triangles without a face that may join.
fn grow(
    seed: u32,
    face: u32,
    adjacency: &Adjacency,
    joins: impl Fn(usize) -> bool,
    face_of: &mut [u32],
    interrupt: Interrupt,
) -> Result<()> {
    face_of[seed as usize] = face;
    let mut stack = vec![seed];
    let mut round = 0;
    while let Some(t) = stack.pop() {
        poll_now_and_then(round, interrupt)?;
        round += 1;
        for &u in adjacency.neighbours(t as usize) {
            if face_of[u as usize] == Faces::NONE && joins(u as usize) {
                face_of[u as usize] = face;
                stack.push(u);
            }
        }
    }
    Ok(())
}

/// The triangles that have an area, largest first.
fn largest_first(planes: &[Option<TrianglePlane>], interrupt: Interrupt) -> Result<Vec<u32>> {
    // The bits of a positive number order as the number does.
    let by_area = |(t, p): (usize, &Option<TrianglePlane>)| p.map(|p| (Reverse(p.area.to_bits()), t as u32));
    let mut order: Vec<_> = planes.iter().enumerate().filter_map(by_area).collect();
    sort(&mut order, interrupt)?;
    Ok(order.into_iter().map(|(_, t)| t).collect())
}

fn planes(solid: &Solid, interrupt: Interrupt) -> Result<Vec<Option<TrianglePlane>>> {
    let plane = |t: usize| poll_now_and_then(t, interrupt).map(|()| TrianglePlane::of(solid, t));
    (0..solid.triangles().len()).map(plane).collect()
}

#[derive(Clone, Copy)]
struct TrianglePlane {
    point: Vec3,
    normal: Vec3,
    area: f64,
}

impl TrianglePlane {
    fn of(solid: &Solid, t: usize) -> Option<Self> {
        let [a, b, c] = solid.corners(t);
        let n = (b - a).cross(&(c - a));
        let twice_area = n.norm();
        (twice_area > 1e-12).then(|| Self { point: a, normal: n / twice_area, area: 0.5 * twice_area })
    }

    /// Equal for triangles of one plane (about 0.3° and 1 mm); a plane split by rounding is joined again.
    fn key(&self, centre: &Vec3) -> [i64; 4] {
        let n = self.normal;
        let offset = n.dot(&(self.point - centre));
        [n.x * 200.0, n.y * 200.0, n.z * 200.0, offset * 1000.0].map(|v| v.round() as i64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;

    #[test]
    fn cuboid_has_six_faces() {
        let cube = Solid::cuboid([0.0; 3], [1.0, 2.0, 3.0]).unwrap();
        let faces = group_faces(&cube, NEVER).unwrap();
        assert_eq!(faces.normals.len(), 6);
        for (t, &f) in faces.of_triangle.iter().enumerate() {
            let [a, b, c] = cube.corners(t);
            let n = (b - a).cross(&(c - a)).normalize();
            assert!((n - faces.normals[f as usize]).norm() < 1e-12);
        }
        assert_eq!(faces.surface_of_face, [0, 1, 2, 3, 4, 5]);
    }

    #[test]
    fn a_cylinder_is_a_mantle_and_two_ends() {
        let column = Solid::cylinder([0.0; 3], 0.2, 3.0, 48).unwrap();
        let faces = group_faces(&column, NEVER).unwrap();
        assert_eq!(faces.surface_of_face.iter().max(), Some(&2));
        let of = |f: &(usize, &Vec3)| faces.surface_of_face[f.0];
        let mantle: Vec<u32> =
            faces.normals.iter().enumerate().filter(|(_, n)| n.z.abs() < 0.5).map(|f| of(&f)).collect();
        assert!(mantle.len() > 10 && mantle.iter().all(|s| *s == mantle[0]));
    }

    #[test]
    fn coarse_cylinder_keeps_its_facets_and_fine_one_joins_some() {
        for (sections, at_least, at_most) in [(16, 18, 18), (128, 20, 100)] {
            let n = group_faces(&Solid::cylinder([0.0; 3], 0.2, 3.0, sections).unwrap(), NEVER).unwrap().normals.len();
            assert!((at_least..=at_most).contains(&n), "{sections}: {n}");
        }
    }
}
