//! Cutting points that were not seen from one place into patches: by place.

use super::beam::MAX_BEAMS;
use super::beams::Beams;
use super::halve::halve;
use crate::geometry::{Aabb, Vec3};
use crate::{Interrupt, Result};

/// Cuts points into clusters of at most [`MAX_BEAMS`] that lie together: halved across the longest side of their box
/// until they are small. Each is a list of point numbers in the order given; every point is in exactly one.
/// Metres, in any frame.
pub fn clusters(points: &[Vec3], interrupt: Interrupt) -> Result<Vec<Vec<u32>>> {
    let mut all: Vec<u32> = (0..points.len() as u32).collect();
    let mut out = Vec::new();
    let at = |i: &u32, axis: usize| points[*i as usize][axis];
    let wide = |own: &[u32]| {
        if own.len() <= MAX_BEAMS {
            return None;
        }
        let b = Aabb::around(own.iter().map(|&i| &points[i as usize]));
        (0..3).max_by(|&i, &j| (b.max[i] - b.min[i]).total_cmp(&(b.max[j] - b.min[j])))
    };
    halve(&mut all, &|&i| i, &at, &wide, &mut out, interrupt)?;
    Ok(out)
}

/// Distance between neighbouring points, metres, when it is not given: points lie on surfaces, and a surface covers
/// about the largest side of their box.
pub fn spacing<'a>(points: impl ExactSizeIterator<Item = &'a Vec3>) -> f64 {
    let n = points.len();
    let b = Aabb::around(points);
    let side = |i: usize| b.max[i] - b.min[i];
    let area = [side(0) * side(1), side(1) * side(2), side(2) * side(0)].into_iter().fold(1e-6, f64::max);
    (area / n.max(1) as f64).sqrt().clamp(1e-6, 1e3)
}

/// Angle between neighbouring beams of a moving platform, radians, when it is not given: their [`spacing`] at the mean
/// range.
pub fn angular_spacing(content: &Beams) -> f64 {
    let returned: Vec<usize> = (0..content.len()).filter(|&i| content.beams[i].returned).collect();
    let ends: Vec<Vec3> = returned.iter().map(|&i| content.end(i)).collect();
    let range = returned.iter().map(|&i| content.beams[i].offset.norm()).sum::<f64>() / returned.len().max(1) as f64;
    (spacing(ends.iter()) / range.max(0.1)).clamp(1e-6, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;

    #[test]
    fn every_point_is_in_one_small_cluster() {
        let points: Vec<Vec3> = (0..20_000)
            .map(|i| Vec3::new(f64::from(i % 200) * 0.1, f64::from(i / 200) * 0.1, f64::from(i * 7919 % 13) * 1e-3))
            .collect();
        let clusters = clusters(&points, NEVER).unwrap();
        let mut seen = vec![0; points.len()];
        clusters.iter().flatten().for_each(|&i| seen[i as usize] += 1);
        assert!(seen.iter().all(|&n| n == 1));
        assert!(clusters.iter().all(|c| c.len() <= MAX_BEAMS && c.len() > MAX_BEAMS / 2 && c.is_sorted()));
        assert!((spacing(points.iter()) / 0.1 - 1.0).abs() < 0.02);
        assert!(super::clusters(&[], NEVER).unwrap().is_empty());
        assert_eq!(
            super::clusters(&vec![Vec3::zeros(); 10_000], NEVER).unwrap().iter().map(Vec::len).sum::<usize>(),
            10_000
        );
    }
}
