//! Does a mesh bound a volume? Judged by the balance of its edges, not by trust in the modeller.

use std::collections::HashMap;

use super::{Aabb, Vec3};
use crate::num::sort::sort;
use crate::{Grow, Interrupt, Result, poll_now_and_then};

/// How well a triangle mesh encloses space.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Closedness {
    /// Every edge is matched by its reverse.
    Closed = 0,
    /// Edges meet other edges part-way (T-junctions), but no gap is left: volume is defined.
    TJunctions = 1,
    /// A surface with a border: area is defined, volume and inside are not.
    Open = 2,
}

impl Closedness {
    /// SQL text: `closed`, `closed but for T-junctions`, `open surface`.
    pub fn label(self) -> &'static str {
        match self {
            Self::Closed => "closed",
            Self::TJunctions => "closed but for T-junctions",
            Self::Open => "open surface",
        }
    }

    /// The variant with this number.
    pub fn from_u8(n: u8) -> Option<Self> {
        [Self::Closed, Self::TJunctions, Self::Open].into_iter().find(|c| *c as u8 == n)
    }
}

/// Judges a mesh by its border: the directed edges left over when every edge is cancelled by its reverse.
///
/// No border: closed. Otherwise the border may still cancel piecewise along its lines (T-junctions). A chain of
/// segments that cancels has vanishing moments ∮ xᵢ dx and ∮ xᵢxⱼ dx; the first are the area vector, the second
/// tell apart such pairs as two parallel plates, whose area vectors cancel although a gap is left.
/// Vertices in metres.
pub fn closedness(
    vertices: &[Vec3],
    welded: &[u32],
    triangles: &[[u32; 3]],
    interrupt: Interrupt,
) -> Result<Closedness> {
    let border = border_edges(welded, triangles, interrupt)?;
    if border.is_empty() {
        return Ok(Closedness::Closed);
    }
    let bounds = Aabb::around(border.iter().flat_map(|(a, b)| [&vertices[*a as usize], &vertices[*b as usize]]));
    let scale = 0.5 * bounds.diagonal();
    let centre = bounds.centre();
    let local = |i: u32| (vertices[i as usize] - centre) / scale;
    let mut length = 0.0;
    let mut first = nalgebra::Matrix3::zeros();
    let mut second = [nalgebra::Matrix3::zeros(); 3];
    for (i, &(a, b)) in border.iter().enumerate() {
        poll_now_and_then(i, interrupt)?;
        let (p, q) = (local(a), local(b));
        let step = q - p;
        length += step.norm();
        first += (p + q) * 0.5 * step.transpose();
        // ∫ x xᵀ along the segment, exact for the quadratic.
        let xx = (p * p.transpose() + q * q.transpose() + (p + q) * (p + q).transpose()) / 6.0;
        for (k, m) in second.iter_mut().enumerate() {
            *m += xx * step[k];
        }
    }
    // Vertices are known to about 10 µm, so a moment is to this part of the border's length.
    let tolerance = length * (2e-5 / scale).max(1e-9);
    let vanishes = |m: &nalgebra::Matrix3<f64>| m.amax() <= tolerance;
    // The symmetric part of ∮ x dxᵀ is exact and always 0; what counts is the area vector.
    if vanishes(&(first - first.transpose())) && second.iter().all(vanishes) {
        Ok(Closedness::TJunctions)
    } else {
        Ok(Closedness::Open)
    }
}

/// Directed edges that no reverse cancels, repeated as often as they are left over.
fn border_edges(welded: &[u32], triangles: &[[u32; 3]], interrupt: Interrupt) -> Result<Vec<(u32, u32)>> {
    let mut balance: HashMap<(u32, u32), i32> = HashMap::new();
    balance.grow(triangles.len() * 2, interrupt)?;
    for (i, t) in triangles.iter().enumerate() {
        poll_now_and_then(i, interrupt)?;
        for k in 0..3 {
            let (a, b) = (welded[t[k] as usize], welded[t[(k + 1) % 3] as usize]);
            if a != b {
                *balance.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
            }
        }
    }
    let mut left = Vec::new();
    for (i, ((a, b), n)) in balance.into_iter().enumerate() {
        poll_now_and_then(i, interrupt)?;
        let edge = if n > 0 { (a, b) } else { (b, a) };
        left.grow(n.unsigned_abs() as usize, interrupt)?;
        left.extend(std::iter::repeat_n(edge, n.unsigned_abs() as usize));
    }
    sort(&mut left, interrupt)?;
    Ok(left)
}

#[cfg(test)]
mod tests {
    use super::super::weld::weld;
    use super::*;
    use crate::NEVER;
    use crate::geometry::Solid;

    fn judge(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> Closedness {
        let v: Vec<Vec3> = vertices.iter().map(|p| Vec3::from(*p)).collect();
        judge_solid(&v, triangles)
    }

    fn judge_solid(v: &[Vec3], triangles: &[[u32; 3]]) -> Closedness {
        closedness(v, &weld(v, NEVER).unwrap(), triangles, NEVER).unwrap()
    }

    #[test]
    fn cube_is_closed_and_without_a_face_open() {
        let cube = Solid::cuboid([0.0; 3], [1.0, 2.0, 3.0]).unwrap();
        let v: Vec<Vec3> = cube.vertices().to_vec();
        assert_eq!(judge_solid(&v, cube.triangles()), Closedness::Closed);
        assert_eq!(judge_solid(&v, &cube.triangles()[2..]), Closedness::Open);
    }

    #[test]
    fn t_junction_is_told_from_a_gap() {
        // A tetrahedron one edge of which is split on one side only.
        let v = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.], [0.5, 0., 0.]];
        let split = [[0, 2, 4], [4, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        assert_eq!(judge(&v, &split), Closedness::TJunctions);
        assert_eq!(judge(&v, &split[..4]), Closedness::Open);
    }

    #[test]
    fn two_parallel_plates_are_open_although_their_area_vectors_cancel() {
        let v = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.], [1., 0., 1.], [0., 1., 1.]];
        assert_eq!(judge(&v, &[[0, 1, 2], [3, 5, 4]]), Closedness::Open);
    }
}
