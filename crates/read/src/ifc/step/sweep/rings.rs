//! A profile along a line: where two segments meet, it is cut at the plane between them.

use ifc_lite_geometry::{Point3, Vector3};

use super::path::Path;
use super::roll::Roll;
use super::section::Section;

pub type Ring = Vec<Point3<f64>>;

/// Rings that are joined.
pub struct Run {
    pub rings: Vec<Ring>,
    /// The last ring is joined to the first.
    pub is_closed: bool,
}

/// The rings along a line: one run, or more where the profile is turned from one segment to the next. `None` where the
/// profile would meet itself.
pub fn mitred(section: &Section, path: &Path, roll: &Roll) -> Option<Vec<Run>> {
    if path.goes_back() {
        return None;
    }
    let pieces = pieces(section, path, roll)?;
    let n = pieces.len();
    let reach = section.points.iter().map(|p| p.coords.norm()).fold(0.0, f64::max);
    let meets = |a: usize, b: usize| {
        pieces[a][1].iter().zip(&pieces[b][0]).all(|(end, start)| (end - start).norm() <= 1e-4 * reach)
    };
    if path.is_closed && path.joints().all(|(a, b)| meets(a, b)) {
        return Some(vec![Run { rings: pieces.into_iter().map(|[start, _]| start).collect(), is_closed: true }]);
    }
    let starts: Vec<bool> = (0..n).map(|i| i == 0 || !meets(i - 1, i)).collect();
    let mut runs: Vec<Run> = Vec::new();
    for (i, [start, end]) in pieces.into_iter().enumerate() {
        if starts[i] {
            runs.push(Run { rings: vec![start], is_closed: false });
        }
        runs.last_mut()?.rings.push(end);
    }
    Some(runs)
}

/// The first and the last ring of each segment, on the planes between it and its neighbours.
fn pieces(section: &Section, path: &Path, roll: &Roll) -> Option<Vec<[Ring; 2]>> {
    let (tangents, axes) = (path.tangents(), roll.axes(path)?);
    let n = path.segments();
    let normal = |before: Option<usize>, after: Option<usize>| {
        let sum: Vector3<f64> = before.into_iter().chain(after).map(|i| tangents[i]).sum();
        sum.normalize()
    };
    let ring = |i: usize, at: Point3<f64>, normal: Vector3<f64>| -> Ring {
        let [x, y] = axes[i];
        let flat = section.points.iter().map(|p| x * p.x + y * p.y);
        flat.map(|v| at + v - tangents[i] * (v.dot(&normal) / tangents[i].dot(&normal))).collect()
    };
    let piece = |i: usize| {
        let [a, b] = path.segment(i);
        let before = if path.is_closed { Some((i + n - 1) % n) } else { i.checked_sub(1) };
        let after = if path.is_closed { Some((i + 1) % n) } else { Some(i + 1).filter(|&k| k < n) };
        let (start, end) = (ring(i, a, normal(before, Some(i))), ring(i, b, normal(Some(i), after)));
        let is_sound = start.iter().zip(&end).all(|(s, e)| (e - s).dot(&tangents[i]) > 0.0);
        is_sound.then_some([start, end])
    };
    (0..n).map(piece).collect()
}
