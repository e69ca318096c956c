//! A profile turned about an axis in its plane: a part of a turn, or a whole one, which has no ends.

use ifc_lite_geometry::{Matrix4, Point3, Vector3};

use super::rings::Ring;
use super::section::Section;
use super::skin::Skin;

/// As a fraction of the profile's reach: a point this near to the axis lies on it.
const ON_AXIS: f64 = 1e-6;

pub struct Axis {
    pub origin: Point3<f64>,
    pub along: Vector3<f64>,
}

impl Axis {
    /// How far each point of a profile lies on one side of the axis; `None` where the profile lies on both sides, or
    /// the axis is not in its plane.
    fn off(&self, section: &Section) -> Option<Vec<f64>> {
        let (o, a) = (self.origin, self.along);
        let off: Vec<f64> = section.points.iter().map(|p| (p.x - o.x) * a.y - (p.y - o.y) * a.x).collect();
        let reach = off.iter().fold(0.0f64, |m, d| m.max(d.abs()));
        let least = |sign: f64| off.iter().map(|d| sign * d).fold(f64::INFINITY, f64::min);
        let is_flat = a.z.abs() <= 1e-9 && o.z.abs() <= ON_AXIS * reach;
        let is_beside = least(1.0).max(least(-1.0)) >= -ON_AXIS * reach;
        (is_flat && is_beside && reach > 0.0).then(|| off.iter().map(|d| d.abs() / reach).collect())
    }
}

/// The profile moved step by step; after a whole turn the last step is the first.
pub fn skin(section: &Section, axis: &Axis, moves: &[Matrix4<f64>], is_whole: bool) -> Option<Skin> {
    let off = axis.off(section)?;
    let ring = |by: &Matrix4<f64>| -> Ring {
        section.points.iter().map(|p| by.transform_point(&Point3::new(p.x, p.y, 0.0))).collect()
    };
    let count = moves.len() - usize::from(is_whole);
    let rings: Vec<Ring> = moves[..count].iter().map(ring).collect();
    let mut skin = Skin::new([section, section], &rings, is_whole);
    // A point on the axis is one in all rings; triangles that it makes lines of are none.
    let size = off.len();
    skin.triangles.iter_mut().flatten().filter(|i| off[**i % size] <= ON_AXIS).for_each(|i| *i %= size);
    skin.triangles.retain(|&[a, b, c]| a != b && b != c && c != a);
    Some(skin)
}
