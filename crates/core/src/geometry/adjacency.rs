//! Which triangles share an edge.

use super::Solid;
use super::weld::weld;
use crate::num::sort::sort;
use crate::{Grow, Interrupt, Result, poll_now_and_then, room};

/// An edge shared by more triangles than this is the spine of a fan or junk; pairing all of them would be quadratic.
const MAX_SHARED: usize = 16;

/// For each triangle the triangles across its edges, in one flat list.
#[derive(Debug)]
pub struct Adjacency {
    /// Where each triangle's neighbours start in `list`; one more entry than triangles.
    starts: Vec<u32>,
    list: Vec<u32>,
}

impl Adjacency {
    /// Finds the neighbours by sorting the edges, vertices welded.
    pub fn of(solid: &Solid, interrupt: Interrupt) -> Result<Self> {
        let edges = sorted_edges(solid, interrupt)?;
        room::<[u32; 6]>(solid.triangles().len(), interrupt)?;
        let mut starts = vec![0u32; solid.triangles().len() + 1];
        for_each_shared(&edges, interrupt, |t, _| starts[t as usize + 1] += 1)?;
        for t in 1..starts.len() {
            starts[t] += starts[t - 1];
        }
        let mut next = starts.clone();
        let mut list = vec![0; starts[starts.len() - 1] as usize];
        for_each_shared(&edges, interrupt, |t, u| {
            list[next[t as usize] as usize] = u;
            next[t as usize] += 1;
        })?;
        Ok(Self { starts, list })
    }

    /// The triangles across the edges of triangle `t`; one that shares two edges appears twice.
    pub fn neighbours(&self, t: usize) -> &[u32] {
        &self.list[self.starts[t] as usize..self.starts[t + 1] as usize]
    }
}

/// (Lower vertex, higher vertex, triangle) of every edge of every triangle, sorted.
fn sorted_edges(solid: &Solid, interrupt: Interrupt) -> Result<Vec<[u32; 3]>> {
    let welded = weld(solid.vertices(), interrupt)?;
    let mut edges = Vec::new();
    edges.grow(3 * solid.triangles().len(), interrupt)?;
    for (t, tri) in solid.triangles().iter().enumerate() {
        poll_now_and_then(t, interrupt)?;
        for k in 0..3 {
            let (a, b) = (welded[tri[k] as usize], welded[tri[(k + 1) % 3] as usize]);
            edges.push([a.min(b), a.max(b), t as u32]);
        }
    }
    sort(&mut edges, interrupt)?;
    Ok(edges)
}

/// Calls `pair(t, u)` for all ordered pairs of triangles that share an edge.
fn for_each_shared(edges: &[[u32; 3]], interrupt: Interrupt, mut pair: impl FnMut(u32, u32)) -> Result<()> {
    let same_edge = |a: &[u32; 3], b: &[u32; 3]| a[..2] == b[..2];
    for (round, shared) in edges.chunk_by(same_edge).enumerate() {
        poll_now_and_then(round, interrupt)?;
        if shared.len() > MAX_SHARED {
            continue;
        }
        for [.., t] in shared {
            shared.iter().map(|e| e[2]).filter(|u| u != t).for_each(|u| pair(*t, u));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::geometry::Vec3;

    /// Brute force over all pairs of triangles: those with two corners at the same places.
    #[test]
    fn equals_brute_force() {
        for solid in
            [Solid::cuboid([0.0; 3], [1.0; 3]).unwrap(), Solid::cylinder([5.0, 1.0, 2.0], 0.3, 2.0, 40).unwrap()]
        {
            let adjacency = Adjacency::of(&solid, NEVER).unwrap();
            let n = solid.triangles().len();
            let common = |t: usize, u: usize| {
                let near = |p: &Vec3| solid.corners(u).iter().any(|q| (p - q).norm() < 1e-9);
                solid.corners(t).iter().filter(|p| near(p)).count()
            };
            for t in 0..n {
                let want: Vec<u32> = (0..n).filter(|&u| u != t && common(t, u) >= 2).map(|u| u as u32).collect();
                let mut got = adjacency.neighbours(t).to_vec();
                got.sort_unstable();
                assert_eq!(got, want, "triangle {t}");
                assert_eq!(got.len(), 3);
            }
        }
    }

    #[test]
    fn a_spine_of_very_many_triangles_is_no_neighbourhood() {
        let fan = |n: u32| {
            let rim = (0..n).map(|i| Vec3::new(f64::from(i), 1.0, f64::from(i * i)));
            let vertices = [Vec3::zeros(), Vec3::z()].into_iter().chain(rim).collect();
            Solid::new(vertices, (0..n).map(|i| [0, 1, 2 + i]).collect()).unwrap()
        };
        assert_eq!(Adjacency::of(&fan(16), NEVER).unwrap().neighbours(3).len(), 15);
        assert_eq!(Adjacency::of(&fan(17), NEVER).unwrap().neighbours(3).len(), 0);
    }
}
