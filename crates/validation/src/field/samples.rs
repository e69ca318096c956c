//! Places on the surface of a drawn object, evenly over its area.

use anyhow::Result;
use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Vec3, group_faces};

use super::layout::Object;

/// One place for so much area, m².
const AREA_M2: f64 = 0.0025;
/// Fewest and most places of an object.
const FEWEST: usize = 150;
const MOST: usize = 2500;
/// Fractional parts of the R₂ sequence (Roberts 2018).
const R2: [f64; 2] = [0.754_877_666_246_693, 0.569_840_290_998_053];

/// A place on a drawn surface.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    /// World metres.
    pub place: Vec3,
    /// Unit normal, outward where the object is closed.
    pub normal: Vec3,
    /// Triangle.
    pub triangle: usize,
    /// Plane face.
    pub face: usize,
    /// Area that it stands for, m².
    pub area: f64,
}

/// The places of an object.
pub fn samples(object: &Object) -> Result<Vec<Sample>> {
    let solid = &object.solid;
    let faces = group_faces(solid, NEVER)?;
    let mut sums = Vec::with_capacity(solid.triangles().len());
    let mut total = 0.0;
    for t in 0..solid.triangles().len() {
        total += twice_area(&solid.corners(t)).norm() * 0.5;
        sums.push(total);
    }
    let count = ((total / AREA_M2) as usize).clamp(FEWEST, MOST);
    let mut out = Vec::with_capacity(count);
    for i in 0..count {
        let at = (i as f64 + 0.5) / count as f64 * total;
        let t = sums.partition_point(|s| *s < at).min(sums.len() - 1);
        let corners = solid.corners(t);
        let Some(normal) = twice_area(&corners).try_normalize(0.0) else { continue };
        let [mut u, mut v] = R2.map(|r| (r * i as f64).fract());
        if u + v > 1.0 {
            (u, v) = (1.0 - u, 1.0 - v);
        }
        let place = corners[0] + (corners[1] - corners[0]) * u + (corners[2] - corners[0]) * v;
        out.push(Sample {
            place,
            normal,
            triangle: t,
            face: faces.of_triangle[t] as usize,
            area: total / count as f64,
        });
    }
    Ok(out)
}

fn twice_area([a, b, c]: &[Vec3; 3]) -> Vec3 {
    (b - a).cross(&(c - a))
}
