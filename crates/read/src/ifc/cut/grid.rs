//! Boxes cut out of a box of the same orientation, whatever it is: a grid of their faces' planes, whose cells are solid
//! or not. Exact, closed, and complete.

use asbuilt_core::geometry::Vec3;

use crate::ifc::soup::Soup;

/// A mesh with a vertex farther than this from the corners of a box is not a box, metres.
const CORNER_M: f64 = 5e-5;
/// Planes nearer to each other than this are one, metres: rounding must leave no skin.
const SAME_M: f64 = 1e-4;
const MAX_CELLS: usize = 1 << 20;

/// What is left of a box.
pub struct GridCut {
    pub soup: Soup,
    pub volume: f64,
}

/// `None` where host and openings are not all boxes of the same orientation.
pub fn cut(host: &Soup, tools: &[Soup]) -> Option<GridCut> {
    let frame = BoxAxes::of(host)?;
    let outer = frame.cuboid(host)?;
    let holes = tools.iter().map(|t| frame.cuboid(t)).collect::<Option<Vec<_>>>()?;
    let planes: [Vec<f64>; 3] = std::array::from_fn(|k| planes(outer[k], holes.iter().map(|h| h[k])));
    let counts = planes.each_ref().map(|p| p.len() - 1);
    (counts.iter().product::<usize>() <= MAX_CELLS).then_some(())?;
    let is_solid = |cell: [usize; 3]| {
        let middle: [f64; 3] = std::array::from_fn(|k| (planes[k][cell[k]] + planes[k][cell[k] + 1]) / 2.0);
        !holes.iter().any(|h| (0..3).all(|k| h[k][0] < middle[k] && middle[k] < h[k][1]))
    };
    let mut out = GridCut { soup: Soup::default(), volume: 0.0 };
    let cells = (0..counts[0]).flat_map(|i| (0..counts[1]).flat_map(move |j| (0..counts[2]).map(move |k| [i, j, k])));
    for cell in cells.filter(|&c| is_solid(c)) {
        out.volume += (0..3).map(|k| planes[k][cell[k] + 1] - planes[k][cell[k]]).product::<f64>();
        for axis in 0..3 {
            for up in [false, true] {
                let mut beside = cell;
                beside[axis] = if up { cell[axis] + 1 } else { cell[axis].wrapping_sub(1) };
                if beside[axis] >= counts[axis] || !is_solid(beside) {
                    face(&mut out.soup, &frame, &planes, cell, axis, up);
                }
            }
        }
    }
    Some(out)
}

/// A face of a cell, seen from outside.
fn face(soup: &mut Soup, frame: &BoxAxes, planes: &[Vec<f64>; 3], cell: [usize; 3], axis: usize, up: bool) {
    let corner = |u: usize, v: usize| {
        let mut at = cell;
        at[axis] += usize::from(up);
        at[(axis + 1) % 3] += u;
        at[(axis + 2) % 3] += v;
        frame.world([0, 1, 2].map(|k| planes[k][at[k]]))
    };
    let ids = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)].map(|c| soup.vertex(c));
    if let [Some(a), Some(b), Some(c), Some(d)] = ids {
        let [b, d] = if up { [b, d] } else { [d, b] };
        soup.triangle([a, b, c]);
        soup.triangle([a, c, d]);
    }
}

/// The planes across an axis: the host's own, and the openings' within them.
fn planes(outer: [f64; 2], holes: impl Iterator<Item = [f64; 2]>) -> Vec<f64> {
    let mut all = outer.to_vec();
    for at in holes.flatten() {
        if outer[0] < at && at < outer[1] && all.iter().all(|p| (p - at).abs() > SAME_M) {
            all.push(at);
        }
    }
    all.sort_by(f64::total_cmp);
    all
}

/// The directions of a box.
struct BoxAxes {
    origin: Vec3,
    axes: [Vec3; 3],
}

impl BoxAxes {
    /// Taken from its largest face and the largest one perpendicular to it.
    fn of(host: &Soup) -> Option<Self> {
        let normals: Vec<Vec3> = (0..host.triangles.len()).map(|t| host.normal(t)).collect();
        let size = |n: &&Vec3| n.norm_squared();
        let largest = |found: Option<&Vec3>| found.filter(|n| size(n) > 0.0).map(|n| n.normalize());
        let first = largest(normals.iter().max_by(|a, b| size(a).total_cmp(&size(b))))?;
        let is_across = |n: &&Vec3| n.dot(&first).powi(2) < 1e-6 * size(n);
        let across = largest(normals.iter().filter(is_across).max_by(|a, b| size(a).total_cmp(&size(b))))?;
        let second = (across - first * across.dot(&first)).normalize();
        Some(Self { origin: (*host.vertices.first()?).into(), axes: [first, second, first.cross(&second)] })
    }

    fn local(&self, world: [f64; 3]) -> Vec3 {
        let d = Vec3::from(world) - self.origin;
        self.axes.map(|axis| axis.dot(&d)).into()
    }

    fn world(&self, local: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = self.axes;
        (self.origin + (x * local[0] + y * local[1] + z * local[2])).into()
    }

    /// The extent of a box along these directions; `None` if it is not a box of this orientation.
    fn cuboid(&self, mesh: &Soup) -> Option<[[f64; 2]; 3]> {
        let local: Vec<Vec3> = mesh.vertices.iter().map(|&v| self.local(v)).collect();
        let range =
            |k: usize| local.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |r, v| [r[0].min(v[k]), r[1].max(v[k])]);
        let ranges = [range(0), range(1), range(2)];
        let is_corner = |v: &Vec3| (0..3).all(|k| ranges[k].iter().any(|end| (end - v[k]).abs() < CORNER_M));
        let volume: f64 = ranges.iter().map(|r| r[1] - r[0]).product();
        let is_whole = volume > 0.0 && (mesh.volume().abs() / volume - 1.0).abs() < 1e-3;
        (is_whole && local.iter().all(is_corner)).then_some(ranges)
    }
}

#[cfg(test)]
mod tests {
    use super::super::line::tests::cuboid;
    use super::*;

    fn turned(mut soup: Soup, degrees: f64) -> Soup {
        let (sin, cos) = degrees.to_radians().sin_cos();
        for v in &mut soup.vertices {
            (v[0], v[1]) = (cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]);
        }
        soup
    }

    #[test]
    fn a_recess_and_a_window_at_any_angle() {
        for degrees in [0.0, 0.001, 0.5, 33.0, 90.0] {
            let host = turned(cuboid([0.0, -0.2, 0.0], [4.0, 0.2, 3.0]), degrees);
            let recess = turned(cuboid([1.0, -0.2, 0.5], [3.0, -0.05, 2.5]), degrees);
            let window = turned(cuboid([1.5, -0.3, 1.0], [2.5, 0.3, 2.0]), degrees);
            let left = cut(&host, &[recess, window]).unwrap();
            assert!((left.volume - 3.95).abs() < 1e-5, "{degrees}: {}", left.volume);
            assert!((left.soup.volume() - left.volume).abs() < 1e-9);
        }
    }

    #[test]
    fn what_lies_otherwise_is_not_for_the_grid() {
        let host = cuboid([0.0; 3], [4.0, 0.2, 3.0]);
        assert!(cut(&host, &[turned(cuboid([1.0, -1.0, 1.0], [2.0, 1.0, 2.0]), 1.0)]).is_none());
        assert!(cut(&host, &[cuboid([-1.0; 3], [9.0; 3])]).unwrap().soup.triangles.is_empty());
    }
}
