//! Bodies of one thickness over a raster: walls with openings, stairs, steel profiles.

use std::collections::HashMap;

use anyhow::Result;
use asbuilt_core::geometry::{Solid, Vec3};

/// Raster lines along u and v, and the extent along w, metres (or radians, where `place` bends it).
pub struct Panel {
    pub us: Vec<f64>,
    pub vs: Vec<f64>,
    pub ws: [f64; 2],
}

/// A rectangle in u and v.
#[derive(Debug, Clone, Copy)]
pub struct Opening {
    pub u: [f64; 2],
    pub v: [f64; 2],
}

impl Panel {
    /// A rectangle of this extent, thick from `ws[0]` to `ws[1]`, with raster lines along all openings.
    pub fn with_openings(u: [f64; 2], v: [f64; 2], ws: [f64; 2], openings: &[Opening]) -> Self {
        let lines = |ends: [f64; 2], of: fn(&Opening) -> [f64; 2]| {
            let mut all: Vec<f64> = ends.into_iter().chain(openings.iter().flat_map(of)).collect();
            all.sort_by(f64::total_cmp);
            all.dedup();
            all
        };
        Self { us: lines(u, |o| o.u), vs: lines(v, |o| o.v), ws }
    }

    /// The body of the cells whose centres (u, v) are `filled`. `place` maps (u, v, w) to the plan and keeps the
    /// orientation.
    pub fn solid(&self, filled: impl Fn(f64, f64) -> bool, place: impl Fn(Vec3) -> Vec3) -> Result<Solid> {
        let (columns, rows) = (self.us.len() - 1, self.vs.len() - 1);
        let middle = |lines: &[f64], i: usize| 0.5 * (lines[i] + lines[i + 1]);
        let is_filled =
            |i: usize, j: usize| i < columns && j < rows && filled(middle(&self.us, i), middle(&self.vs, j));
        let mut mesh = Mesh::default();
        let mut quad = |corners: [[usize; 3]; 4]| {
            mesh.quad(corners, |[i, j, k]| place(Vec3::new(self.us[i], self.vs[j], self.ws[k])));
        };
        for i in 0..columns {
            for j in (0..rows).filter(|&j| is_filled(i, j)) {
                let [a, b, c, d] = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
                let at = |[i, j]: [usize; 2], k: usize| [i, j, k];
                quad([at(a, 1), at(b, 1), at(c, 1), at(d, 1)]);
                quad([at(a, 0), at(d, 0), at(c, 0), at(b, 0)]);
                let beside = [(a, b, is_filled(i, j.wrapping_sub(1))), (b, c, is_filled(i + 1, j))];
                let others = [(c, d, is_filled(i, j + 1)), (d, a, is_filled(i.wrapping_sub(1), j))];
                for (from, to, goes_on) in beside.into_iter().chain(others) {
                    if !goes_on {
                        quad([at(from, 0), at(to, 0), at(to, 1), at(from, 1)]);
                    }
                }
            }
        }
        Ok(Solid::new(mesh.vertices, mesh.triangles)?)
    }

    /// The body without its openings.
    pub fn pierced(&self, openings: &[Opening], place: impl Fn(Vec3) -> Vec3) -> Result<Solid> {
        self.solid(|u, v| !openings.iter().any(|o| o.contains(u, v)), place)
    }
}

impl Opening {
    fn contains(&self, u: f64, v: f64) -> bool {
        (self.u[0]..self.u[1]).contains(&u) && (self.v[0]..self.v[1]).contains(&v)
    }
}

#[derive(Default)]
struct Mesh {
    number: HashMap<[usize; 3], u32>,
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    fn quad(&mut self, corners: [[usize; 3]; 4], place: impl Fn([usize; 3]) -> Vec3) {
        let [a, b, c, d] = corners.map(|corner| {
            *self.number.entry(corner).or_insert_with(|| {
                self.vertices.push(place(corner));
                self.vertices.len() as u32 - 1
            })
        });
        self.triangles.extend([[a, b, c], [a, c, d]]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asbuilt_core::geometry::Closedness;

    #[test]
    fn a_wall_with_a_door_and_a_window_is_closed() {
        let openings = [Opening { u: [1.0, 2.0], v: [0.0, 2.0] }, Opening { u: [3.0, 4.0], v: [1.0, 2.0] }];
        let panel = Panel::with_openings([0.0, 5.0], [0.0, 3.0], [0.0, 0.2], &openings);
        let wall = panel.pierced(&openings, |p| p).unwrap();
        assert_ne!(wall.closedness(), Closedness::Open);
        assert!((wall.volume().unwrap() - 0.2 * (15.0 - 3.0)).abs() < 1e-9);
    }
}
