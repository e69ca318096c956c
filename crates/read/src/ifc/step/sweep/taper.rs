//! From one profile to another with the same number of corners.

use ifc_lite_geometry::{Matrix4, Point2, Point3};

use super::section::Section;
use super::skin::Skin;

/// The solid between two profiles, moved step by step; `None` where their loops have different numbers of corners.
pub fn skin(start: &Section, end: &Section, moves: &[Matrix4<f64>]) -> Option<Skin> {
    let pairs = paired(start, end)?;
    let end = start.at(&pairs.iter().map(|p| p[1]).collect::<Vec<_>>())?;
    let last = (moves.len() - 1) as f64;
    let ring = |(k, by): (usize, &Matrix4<f64>)| {
        let flat = pairs.iter().map(|[a, b]| a.lerp(b, k as f64 / last));
        flat.map(|p| by.transform_point(&Point3::new(p.x, p.y, 0.0))).collect()
    };
    let rings: Vec<_> = moves.iter().enumerate().map(ring).collect();
    Some(Skin::new([start, &end], &rings, false))
}

/// Corners that belong together.
fn paired(start: &Section, end: &Section) -> Option<Vec<[Point2<f64>; 2]>> {
    if start.loops != end.loops {
        return None;
    }
    let mut pairs = Vec::with_capacity(start.points.len());
    for range in &start.loops {
        let (from, to) = (&start.points[range.clone()], &end.points[range.clone()]);
        let shift = best_shift(from, to);
        pairs.extend((0..from.len()).map(|i| [from[i], to[(i + shift) % to.len()]]));
    }
    Some(pairs)
}

/// By how many corners the second begins later, with both scaled to one size about their centres. The corners are
/// matched as written unless another match is better.
fn best_shift(from: &[Point2<f64>], to: &[Point2<f64>]) -> usize {
    let (from, to) = (of_one_size(from), of_one_size(to));
    let n = from.len();
    let off = |shift: usize| (0..n).map(|i| (from[i] - to[(i + shift) % n]).norm_squared()).sum::<f64>();
    let written = off(0);
    let best = (0..n).map(|s| (off(s), s)).min_by(|a, b| a.0.total_cmp(&b.0));
    best.filter(|(off, _)| *off < 0.25 * written).map_or(0, |(_, shift)| shift)
}

fn of_one_size(points: &[Point2<f64>]) -> Vec<Point2<f64>> {
    let n = points.len() as f64;
    let middle = points.iter().fold(Point2::origin().coords, |sum, p| sum + p.coords) / n;
    let size = points.iter().map(|p| (p.coords - middle).norm_squared()).sum::<f64>().sqrt().max(f64::MIN_POSITIVE);
    points.iter().map(|p| Point2::from((p.coords - middle) / size)).collect()
}
