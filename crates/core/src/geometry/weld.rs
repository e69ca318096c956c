//! Vertices that coincide, as one.

use std::collections::HashMap;

use super::Vec3;
use crate::{Grow, Interrupt, Result, poll_now_and_then, room};

/// Vertices nearer than this are one vertex: modellers repeat them per face, rounded to single precision.
const WELD_M: f64 = 1e-5;

/// For each vertex the number of the first vertex at the same place (within 10 µm). Metres, in any frame.
pub fn weld(vertices: &[Vec3], interrupt: Interrupt) -> Result<Vec<u32>> {
    let cell = |v: &Vec3| [0, 1, 2].map(|i| (v[i] / WELD_M).floor() as i64);
    let mut first_in_cell: HashMap<[i64; 3], u32> = HashMap::new();
    first_in_cell.grow(vertices.len(), interrupt)?;
    room::<u32>(2 * vertices.len(), interrupt)?;
    vertices
        .iter()
        .enumerate()
        .map(|(i, v)| {
            poll_now_and_then(i, interrupt)?;
            let c = cell(v);
            let near = neighbours(c, v).find_map(|k| {
                let &j = first_in_cell.get(&k)?;
                ((vertices[j as usize] - v).norm() <= WELD_M).then_some(j)
            });
            Ok(near.unwrap_or_else(|| *first_in_cell.entry(c).or_insert(i as u32)))
        })
        .collect()
}

/// The cells within the welding distance of `v`: 1 to 8, its own first.
fn neighbours(c: [i64; 3], v: &Vec3) -> impl Iterator<Item = [i64; 3]> {
    let towards = [0, 1, 2].map(|i| if v[i] / WELD_M - (c[i] as f64) < 0.5 { -1 } else { 1 });
    (0..8u32).map(move |m| [0, 1, 2].map(|i| c[i] + if m >> i & 1 == 1 { towards[i] } else { 0 }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;

    #[test]
    fn near_vertices_are_one_wherever_the_cell_borders_lie() {
        for shift in 0..50 {
            let x = 1.0 + shift as f64 * 1e-6;
            let v = [Vec3::new(x, 0.0, 0.0), Vec3::new(x + 3e-6, -2e-6, 1e-6), Vec3::new(x + 1e-3, 0.0, 0.0)];
            assert_eq!(weld(&v, NEVER).unwrap(), [0, 0, 2], "{shift}");
        }
    }
}
