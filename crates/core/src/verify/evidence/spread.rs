//! Spreading points evenly over a mesh, and putting them in an order in which neighbours lie together.

use crate::geometry::{Faces, Solid, Vec3};
use crate::num::hilbert;
use crate::num::sort::sort;
use crate::{Grow, Interrupt, Result, poll_now_and_then, room};

/// Spreads points over each triangle by its area. What a triangle owes or has too much is carried to the next
/// (error diffusion), so that a fine mesh gets as many samples as a coarse one.
/// The spacing in metres; points in world metres.
pub fn spread(solid: &Solid, faces: &Faces, spacing: f64, interrupt: Interrupt, out: &mut [Vec<Vec3>]) -> Result<()> {
    let mut owed = 0.5;
    for (t, &face) in faces.of_triangle.iter().enumerate() {
        if face == Faces::NONE {
            continue;
        }
        poll_now_and_then(t, interrupt)?;
        let [a, b, c] = solid.corners(t);
        owed += 0.5 * (b - a).cross(&(c - a)).norm() / (spacing * spacing);
        let n = owed.floor();
        owed -= n;
        for i in 0..n as u64 {
            poll_now_and_then(i as usize, interrupt)?;
            let (u, v) = r2(i);
            // Fold the unit square onto the triangle.
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let points = &mut out[face as usize];
            points.grow(1, interrupt)?;
            points.push(a + (b - a) * u + (c - a) * v);
        }
    }
    if out.iter().all(Vec::is_empty) {
        // An object smaller than one sample is still an object.
        if let Some((t, &face)) = faces.of_triangle.iter().enumerate().find(|(_, f)| **f != Faces::NONE) {
            let [a, b, c] = solid.corners(t);
            out[face as usize].push((a + b + c) / 3.0);
        }
    }
    Ok(())
}

/// M. Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018): the R₂ sequence, evenly spread.
fn r2(i: u64) -> (f64, f64) {
    const PLASTIC: f64 = 1.324_717_957_244_746;
    let at = |alpha: f64| (0.5 + (i + 1) as f64 * alpha).fract();
    (at(1.0 / PLASTIC), at(1.0 / (PLASTIC * PLASTIC)))
}

/// Orders points along a Hilbert curve in the face's plane, so that a block is compact. The spacing in metres.
pub fn sort_along_curve(points: &mut Vec<Vec3>, normal: &Vec3, spacing: f64, interrupt: Interrupt) -> Result<()> {
    let drop = normal.iamax();
    let (i, j) = ((drop + 1) % 3, (drop + 2) % 3);
    let low = points.iter().fold([f64::INFINITY; 2], |l, p| [l[0].min(p[i]), l[1].min(p[j])]);
    let cell = |x: f64, lo: f64| ((x - lo) / spacing) as u32;
    let mut order = Vec::new();
    order.grow(points.len(), interrupt)?;
    for (k, p) in points.iter().enumerate() {
        poll_now_and_then(k, interrupt)?;
        order.push((hilbert::place_in_plane([cell(p[i], low[0]), cell(p[j], low[1])]), k as u32));
    }
    sort(&mut order, interrupt)?;
    room::<Vec3>(points.len(), interrupt)?;
    *points = order.into_iter().map(|(_, k)| points[k as usize]).collect();
    Ok(())
}
