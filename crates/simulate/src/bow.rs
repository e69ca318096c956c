//! Bending a body.

use asbuilt_core::Result;
use asbuilt_core::geometry::{Parts, Solid, Vec3};
use nalgebra::{Matrix3, SymmetricEigen};

/// Pieces along the body's longest extent: the chords of a 60 mm bow then lie within 0.1 mm of the curve.
const PIECES: f64 = 32.0;

/// A body whose middle, along its longest extent, is displaced by `bow` (m), as half a sine wave.
pub fn bowed(solid: &Solid, bow: &Vec3) -> Result<Solid> {
    let axis = longest_axis(solid);
    let along = |v: &Vec3| v.dot(&axis);
    let (low, high) = solid
        .vertices()
        .iter()
        .map(along)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    let most = (high - low) / PIECES;
    let (mut vertices, mut parts) = (Vec::new(), Vec::new());
    for t in 0..solid.triangles().len() {
        cut(solid.corners(t), &along, most, &mut vertices);
        parts.resize(vertices.len() / 3, solid.parts().map_or(0, |parts| parts.number_of(t) as u16));
    }
    let bend = |v: &Vec3| v + bow * (std::f64::consts::PI * (along(v) - low) / (high - low)).sin();
    let bent: Vec<Vec3> = vertices.iter().map(bend).collect();
    let triangles = (0..bent.len() as u32 / 3).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let bent = Solid::new(bent, triangles)?;
    solid.parts().map_or(Ok(bent.clone()), |told| bent.with_parts(Parts::new(parts, told.list().to_vec())?))
}

/// Halves the edge that extends farthest along the axis until none exceeds `most`. Neighbours cut a shared edge in the
/// same way.
fn cut(corners: [Vec3; 3], along: &impl Fn(&Vec3) -> f64, most: f64, out: &mut Vec<Vec3>) {
    let extent = |k: usize| (along(&corners[(k + 1) % 3]) - along(&corners[k])).abs();
    let k = (0..3).max_by(|&a, &b| extent(a).total_cmp(&extent(b))).unwrap_or(0);
    if extent(k) <= most {
        return out.extend(corners);
    }
    let [a, b, c] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
    let middle = 0.5 * (a + b);
    cut([a, middle, c], along, most, out);
    cut([middle, b, c], along, most, out);
}

/// Main axis of the surface: the direction of largest second moment.
fn longest_axis(solid: &Solid) -> Vec3 {
    let centre = solid.bounds().centre();
    let mut moment = Matrix3::zeros();
    for t in 0..solid.triangles().len() {
        let corners = solid.corners(t).map(|c| c - centre);
        let area = (corners[1] - corners[0]).cross(&(corners[2] - corners[0])).norm();
        // ∫ x xᵀ over a triangle is A/12 (Σ c cᵀ + s sᵀ), s = Σ c.
        let sum: Vec3 = corners.iter().sum();
        moment += (corners.iter().map(|c| c * c.transpose()).sum::<Matrix3<f64>>() + sum * sum.transpose()) * area;
    }
    let eigen = SymmetricEigen::new(moment);
    eigen.eigenvectors.column(eigen.eigenvalues.imax()).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use asbuilt_core::geometry::{Closedness, Part};

    #[test]
    fn a_wall_bends_in_its_middle_and_stays_closed() {
        let wall = Solid::cuboid([0.0; 3], [6.0, 0.2, 3.0]).unwrap();
        let pane = Part { is_transparent: true, ..Part::default() };
        let numbers = (0..12).map(|t| u16::from(t < 2)).collect();
        let wall = wall.with_parts(Parts::new(numbers, vec![Part::default(), pane]).unwrap()).unwrap();
        let bent = bowed(&wall, &Vec3::new(0.0, 0.03, 0.0)).unwrap();
        let (before, after) = (wall.part_measures()[1], bent.part_measures()[1]);
        assert!(after.0 > before.0 && (after.1 - before.1).abs() < 0.01, "{before:?} {after:?}");
        assert_ne!(bent.closedness(), Closedness::Open);
        for v in bent.vertices() {
            let want = 0.03 * (std::f64::consts::PI * v.x / 6.0).sin();
            let off = v.y - want;
            assert!((-1e-9..=0.2 + 1e-9).contains(&off), "{v}");
        }
        assert!((bent.volume().unwrap() - 3.6).abs() < 1e-9);
    }
}
