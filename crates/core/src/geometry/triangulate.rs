//! A plane polygon with holes, cut into triangles.

use std::collections::HashMap;

use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

use super::Vec3;
use crate::{Interrupt, Result, poll, room};

type PlaneTriangulation = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// Corner numbers of triangles that fill a polygon, turning about `normal` as its outer ring does; `None` for rings
/// that cross themselves or each other, or have fewer than three corners. `holes`: where each further ring starts.
///
/// A constrained Delaunay triangulation, one corner and one edge at a time: the triangles are those that an odd number
/// of edges separates from the outside. What runs to and fro (a slit to a hole) separates nothing.
pub fn triangulate(
    corners: &[Vec3],
    holes: &[usize],
    normal: &Vec3,
    interrupt: Interrupt,
) -> Result<Option<Vec<[usize; 3]>>> {
    // A corner of a triangulation: its place, six half-edges and two faces, their places in maps.
    room::<[u64; 64]>(corners.len(), interrupt)?;
    let mut plane = PlaneTriangulation::new();
    let Some((handles, corner_of)) = insert(corners, normal, &mut plane, interrupt)? else { return Ok(None) };
    let Some(parting) = parting_edges(&handles, holes, &mut plane, interrupt)? else { return Ok(None) };
    inside(&plane, &parting, &corner_of, interrupt).map(Some)
}

/// Handle of every corner, and the first corner of every handle; `None` where the plane cannot hold them.
type Inserted = (Vec<FixedVertexHandle>, HashMap<FixedVertexHandle, usize>);

fn insert(
    corners: &[Vec3],
    normal: &Vec3,
    plane: &mut PlaneTriangulation,
    interrupt: Interrupt,
) -> Result<Option<Inserted>> {
    let dropped = normal.iamax();
    let (u, v) = ((dropped + 1) % 3, (dropped + 2) % 3);
    // Seen from the normal's tip, the outer ring turns to the left.
    let (u, v) = if normal[dropped] < 0.0 { (v, u) } else { (u, v) };
    let (mut handles, mut corner_of) = (Vec::with_capacity(corners.len()), HashMap::new());
    for (i, corner) in corners.iter().enumerate() {
        poll(interrupt)?;
        let local = corner - corners[0];
        let Ok(handle) = plane.insert(Point2::new(representable(local[u]), representable(local[v]))) else {
            return Ok(None);
        };
        // Above each other: the polygon is not plane.
        if corners[*corner_of.entry(handle).or_insert(i)] != *corner {
            return Ok(None);
        }
        handles.push(handle);
    }
    Ok(Some((handles, corner_of)))
}

/// The triangulation's predicates are exact for numbers that are not vanishingly small.
fn representable(x: f64) -> f64 {
    if x.abs() < 1e-30 { 0.0 } else { x }
}

/// The edges that separate inside from outside: those along which an odd number of the rings' edges run. `None` where
/// edges cross.
fn parting_edges(
    handles: &[FixedVertexHandle],
    holes: &[usize],
    plane: &mut PlaneTriangulation,
    interrupt: Interrupt,
) -> Result<Option<Vec<bool>>> {
    let starts = std::iter::once(0).chain(holes.iter().copied());
    let ends = holes.iter().copied().chain(std::iter::once(handles.len()));
    let mut parts: Vec<[FixedVertexHandle; 2]> = Vec::new();
    for (start, end) in starts.zip(ends) {
        for i in start..end {
            poll(interrupt)?;
            let (from, to) = (handles[i], handles[if i + 1 == end { start } else { i + 1 }]);
            if from == to {
                continue;
            }
            let along = plane.try_add_constraint(from, to);
            if along.is_empty() {
                return Ok(None);
            }
            parts.extend(along.iter().map(|&edge| plane.directed_edge(edge).vertices().map(|v| v.fix())));
        }
    }
    // Numbers of edges change while edges are added.
    let mut parting = vec![false; plane.num_undirected_edges()];
    for [from, to] in parts {
        let Some(edge) = plane.get_edge_from_neighbors(from, to) else { return Ok(None) };
        let number = edge.as_undirected().fix().index();
        parting[number] = !parting[number];
    }
    Ok(Some(parting))
}

/// The triangles that an odd number of such edges separates from the outside.
fn inside(
    plane: &PlaneTriangulation,
    parting: &[bool],
    corner_of: &HashMap<FixedVertexHandle, usize>,
    interrupt: Interrupt,
) -> Result<Vec<[usize; 3]>> {
    let outer = plane.outer_face().fix();
    let mut visited = vec![false; plane.num_all_faces()];
    visited[outer.index()] = true;
    let (mut open, mut out) = (Vec::new(), Vec::new());
    for edge in plane.convex_hull() {
        open.push((edge.rev().face().fix(), parting[edge.as_undirected().fix().index()]));
        open.push((edge.face().fix(), parting[edge.as_undirected().fix().index()]));
    }
    while let Some((face, side)) = open.pop() {
        poll(interrupt)?;
        if std::mem::replace(&mut visited[face.index()], true) {
            continue;
        }
        let Some(triangle) = plane.face(face).as_inner() else { continue };
        if side {
            out.push(triangle.vertices().map(|v| corner_of[&v.fix()]));
        }
        for edge in triangle.adjacent_edges() {
            open.push((edge.rev().face().fix(), side != parting[edge.as_undirected().fix().index()]));
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;

    fn flat(points: &[[f64; 2]]) -> Vec<Vec3> {
        points.iter().map(|p| Vec3::new(p[0], p[1], 1.0)).collect()
    }

    fn area(points: &[[f64; 2]], holes: &[usize]) -> Option<f64> {
        let corners = flat(points);
        let cut = triangulate(&corners, holes, &Vec3::z(), NEVER).unwrap()?;
        let turned = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|i| corners[i]);
            (b - a).cross(&(c - a)).z
        };
        assert!(cut.iter().all(|t| turned(t) > 0.0), "a triangle is turned over");
        Some(cut.iter().map(|t| 0.5 * turned(t)).sum())
    }

    #[test]
    fn slits_touching_holes_and_corners_on_edges() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        assert_eq!(area(&square, &[]), Some(16.0));
        // To a hole and back along the same edge.
        let slit = [
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
            [0.0, 0.0],
            [1.0, 1.0],
            [1.0, 3.0],
            [3.0, 3.0],
            [3.0, 1.0],
            [1.0, 1.0],
        ];
        assert_eq!(area(&slit, &[]), Some(12.0));
        // A hole whose corner touches the outer ring between two of its corners.
        let touching = [square.as_slice(), &[[0.0, 2.0], [1.0, 1.0], [1.0, 3.0]]].concat();
        assert_eq!(area(&touching, &[4]), Some(15.0));
        // A corner in the middle of a straight edge.
        let straight = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        assert_eq!(area(&straight, &[]), Some(16.0));
    }

    #[test]
    fn crossing_rings_are_none() {
        assert_eq!(area(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]], &[]), None);
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let across = [square.as_slice(), &[[3.0, 1.0], [5.0, 1.0], [5.0, 2.0]]].concat();
        assert_eq!(area(&across, &[4]), None);
    }
}
