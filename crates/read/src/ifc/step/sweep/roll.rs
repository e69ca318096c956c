//! How a profile is turned about the line that it follows: its x axis lies along the normal of a surface, or along a
//! direction, as far as that is perpendicular to the line (ISO 10303-42, surface_curve_swept_area_solid).

use ifc_lite_geometry::{Point3, Vector3};

use super::path::Path;

#[derive(Debug)]
pub enum Roll {
    /// One direction for the whole line.
    Fixed(Vector3<f64>),
    /// The normal of an extruded curve: its points and the direction of the extrusion.
    Extruded(Vec<Point3<f64>>, Vector3<f64>),
    /// Carried along without a twist.
    Carried,
}

/// The profile's axes in a segment.
pub type ProfileAxes = [Vector3<f64>; 2];

impl Roll {
    /// The axes of every segment; `None` where the direction runs along the line.
    pub fn axes(&self, path: &Path) -> Option<Vec<ProfileAxes>> {
        let tangents = path.tangents();
        if matches!(self, Roll::Carried) {
            return Some(carried(path, &tangents));
        }
        let along = |i: usize| {
            let [a, b] = path.segment(i);
            let normal = match self {
                Roll::Extruded(curve, direction) => nearest_normal(curve, *direction, &a.lerp(&b, 0.5))?,
                Roll::Fixed(direction) => *direction,
                Roll::Carried => return None,
            };
            square_to(&tangents[i], &normal)
        };
        (0..path.segments()).map(along).collect()
    }
}

fn square_to(tangent: &Vector3<f64>, normal: &Vector3<f64>) -> Option<ProfileAxes> {
    let x = (normal - tangent * tangent.dot(normal)).try_normalize(1e-6 * normal.norm())?;
    Some([x, tangent.cross(&x)])
}

/// Mirrored at the plane between two segments, a direction perpendicular to one becomes a direction perpendicular to
/// the other, without a twist (Wang et al. 2008, "Computation of rotation minimizing frames").
fn carried(path: &Path, tangents: &[Vector3<f64>]) -> Vec<ProfileAxes> {
    let start = tangents[0];
    let helper = if start.z.abs() < 0.9 { Vector3::z() } else { Vector3::x() };
    let mut axes = vec![square_to(&start, &helper).unwrap_or([Vector3::x(), Vector3::y()])];
    for i in 1..path.segments() {
        let across = (tangents[i - 1] + tangents[i]).normalize();
        axes.push(axes[i - 1].map(|axis| axis - across * (2.0 * across.dot(&axis))));
    }
    axes
}

/// The surface's normal where its curve comes nearest to a place, seen along the extrusion.
fn nearest_normal(curve: &[Point3<f64>], direction: Vector3<f64>, place: &Point3<f64>) -> Option<Vector3<f64>> {
    let d = direction.try_normalize(0.0)?;
    let flat = |p: &Point3<f64>| p.coords - d * d.dot(&p.coords);
    let at = flat(place);
    let steps = curve.windows(2).map(|w| (flat(&w[0]), flat(&w[1]) - flat(&w[0])));
    let nearest = steps.filter(|(_, step)| step.norm_squared() > 0.0).min_by(|a, b| {
        let off = |(from, step): &(Vector3<f64>, Vector3<f64>)| {
            let part = ((at - from).dot(step) / step.norm_squared()).clamp(0.0, 1.0);
            (at - (from + step * part)).norm()
        };
        off(a).total_cmp(&off(b))
    });
    nearest.map(|(_, step)| step.cross(&d))
}
