//! A building object's geometry: a triangle mesh with what it encloses.

use super::closedness::closedness;
use super::coordinate::check_coordinates;
use super::weld::weld;
use super::{Aabb, Closedness, Parts, Vec3};
use crate::error::{Error, Limited, Result};
use crate::{Interrupt, NEVER, poll_now_and_then};

/// A triangle mesh, world coordinates in metres, triangles counter-clockwise seen from outside.
///
/// Its triangles may be told apart as [`Parts`].
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    pub(super) vertices: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) bounds: Aabb,
    pub(super) area: f64,
    /// NaN when open.
    pub(super) volume: f64,
    pub(super) closedness: Closedness,
    /// None for a solid of one part about which nothing is known.
    pub(super) parts: Option<Parts>,
}

impl Solid {
    /// Most vertices or triangles of one solid; keeps a value within PostgreSQL's 1 GB.
    pub const MAX_ELEMENTS: usize = 20_000_000;

    /// Checks and measures a mesh. A closed mesh that is inside out is turned. World metres.
    pub fn new(vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self> {
        Self::interruptible(vertices, triangles, NEVER)
    }

    /// [`Solid::new`] for meshes of any size: asks `interrupt` at intervals. World metres.
    pub fn interruptible(vertices: Vec<Vec3>, mut triangles: Vec<[u32; 3]>, interrupt: Interrupt) -> Result<Self> {
        check(&vertices, &triangles, interrupt)?;
        let bounds = Aabb::around(&vertices);
        let welded = weld(&vertices, interrupt)?;
        let closedness = closedness(&vertices, &welded, &triangles, interrupt)?;
        let centre = bounds.centre();
        let (mut area, mut six_volume) = (0.0, 0.0);
        for (i, t) in triangles.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            let [a, b, c] = t.map(|i| vertices[i as usize] - centre);
            area += area_of(&[a, b, c]);
            six_volume += a.dot(&b.cross(&c));
        }
        if closedness != Closedness::Open && six_volume < 0.0 {
            triangles.iter_mut().for_each(|t| t.swap(1, 2));
            six_volume = -six_volume;
        }
        let volume = if closedness == Closedness::Open { f64::NAN } else { six_volume / 6.0 };
        Ok(Self { vertices, triangles, bounds, area, volume, closedness, parts: None })
    }

    /// A cuboid between two corners, 12 triangles. World metres.
    pub fn cuboid(min: [f64; 3], max: [f64; 3]) -> Result<Self> {
        let b = Aabb::new(min, max)?;
        let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).collect();
        Self::new(b.corners().to_vec(), triangles)
    }

    /// An upright cylinder on `foot`, its circle approximated by `sections` inscribed chords. World metres.
    pub fn cylinder(foot: [f64; 3], radius: f64, height: f64, sections: u32) -> Result<Self> {
        let foot = Vec3::from(foot);
        let rim = |i: u32, z: f64| {
            let a = f64::from(i) * std::f64::consts::TAU / f64::from(sections);
            foot + Vec3::new(radius * a.cos(), radius * a.sin(), z)
        };
        let mut vertices = vec![foot, foot + Vec3::new(0.0, 0.0, height)];
        let mut triangles = Vec::new();
        for i in 0..sections {
            vertices.extend([rim(i, 0.0), rim(i, height)]);
            let (low, high) = (2 + 2 * i, 3 + 2 * i);
            let next = (i + 1) % sections;
            let (next_low, next_high) = (2 + 2 * next, 3 + 2 * next);
            triangles.extend([
                [0, next_low, low],
                [1, high, next_high],
                [low, next_low, next_high],
                [low, next_high, high],
            ]);
        }
        Self::new(vertices, triangles)
    }

    /// Vertices, metres.
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }

    /// Triangles as vertex numbers from 0.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The three corners of triangle `t`. World metres.
    pub fn corners(&self, t: usize) -> [Vec3; 3] {
        self.triangles[t].map(|i| self.vertices[i as usize])
    }

    /// Box around all vertices.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Surface area, m².
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Whether the mesh bounds a volume.
    pub fn closedness(&self) -> Closedness {
        self.closedness
    }

    /// Its parts; `None` for a solid of one part about which nothing is known.
    pub fn parts(&self) -> Option<&Parts> {
        self.parts.as_ref()
    }

    /// The same solid with these parts, one number for each triangle; parts that tell nothing are none.
    pub fn with_parts(mut self, parts: Parts) -> Result<Self> {
        let (told, triangles) = (parts.triangles(), self.triangles.len());
        if told != triangles {
            let value = format!("{told} numbers for {triangles} triangles");
            return Err(Error::argument("the list of part numbers", "of one number for each triangle", value));
        }
        self.parts = Some(parts).filter(|parts| !parts.is_plain());
        Ok(self)
    }

    /// Whether triangle `t` belongs to a part that most beams pass.
    pub fn is_transparent(&self, t: usize) -> bool {
        self.parts.as_ref().is_some_and(|parts| parts.part_of(t).is_transparent)
    }

    /// Whether triangle `t` belongs to a part that may stand elsewhere than drawn.
    pub fn is_movable(&self, t: usize) -> bool {
        self.parts.as_ref().is_some_and(|parts| parts.part_of(t).is_movable)
    }

    /// Number of triangles and area, m², of each part; of the whole for a solid without parts.
    pub fn part_measures(&self) -> Vec<(usize, f64)> {
        let mut measures = vec![(0, 0.0); self.parts.as_ref().map_or(1, |parts| parts.list().len())];
        for t in 0..self.triangles.len() {
            let (triangles, area) = &mut measures[self.parts.as_ref().map_or(0, |parts| parts.number_of(t))];
            *triangles += 1;
            *area += area_of(&self.corners(t));
        }
        measures
    }

    /// The solid with every vertex where `place` puts it, its parts kept. World metres.
    pub fn placed(&self, place: impl Fn(&Vec3) -> Vec3, interrupt: Interrupt) -> Result<Self> {
        let vertices = self.vertices.iter().map(place).collect();
        let parts = self.parts.clone();
        Ok(Self { parts, ..Self::interruptible(vertices, self.triangles.clone(), interrupt)? })
    }

    /// Enclosed volume, m³.
    pub fn volume(&self) -> Result<f64> {
        if self.closedness == Closedness::Open { Err(Error::OpenSurface) } else { Ok(self.volume) }
    }
}

/// Area of a triangle, m².
fn area_of([a, b, c]: &[Vec3; 3]) -> f64 {
    0.5 * (b - a).cross(&(c - a)).norm()
}

/// What every mesh must keep to: enough of everything, no more than fits, no index beyond the vertices.
pub(super) fn check(vertices: &[Vec3], triangles: &[[u32; 3]], interrupt: Interrupt) -> Result<()> {
    if triangles.is_empty() {
        return Err(Error::Empty { what: "the solid's list of triangles" });
    }
    if vertices.len().max(triangles.len()) > Solid::MAX_ELEMENTS {
        return Err(Error::Limit {
            what: Limited::Triangles,
            value: vertices.len().max(triangles.len()).to_string(),
            limit: Solid::MAX_ELEMENTS.to_string(),
        });
    }
    check_coordinates("a vertex coordinate", vertices.iter().flatten())?;
    for (t, tri) in triangles.iter().enumerate() {
        poll_now_and_then(t, interrupt)?;
        if let Some(&i) = tri.iter().find(|&&i| i as usize >= vertices.len()) {
            return Err(Error::TriangleIndex { triangle: t, index: i64::from(i), vertices: vertices.len() });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Part;

    #[test]
    fn cuboid_measures() {
        let s = Solid::cuboid([6e5, 5.3e6, 500.0], [6e5 + 1.0, 5.3e6 + 2.0, 503.0]).unwrap();
        assert!((s.area() - 22.0).abs() < 1e-9);
        assert!((s.volume().unwrap() - 6.0).abs() < 1e-9);
        assert_eq!(s.closedness(), Closedness::Closed);
    }

    #[test]
    fn inside_out_is_turned() {
        let s = Solid::cuboid([0.0; 3], [1.0; 3]).unwrap();
        let flipped = s.triangles.iter().map(|t| [t[0], t[2], t[1]]).collect();
        assert_eq!(Solid::new(s.vertices.clone(), flipped).unwrap().volume().unwrap(), s.volume().unwrap());
    }

    #[test]
    fn bad_meshes_are_refused() {
        let v = vec![Vec3::zeros(), Vec3::x(), Vec3::y()];
        assert!(matches!(Solid::new(v.clone(), vec![]), Err(Error::Empty { .. })));
        let e = Solid::new(v.clone(), vec![[0, 1, 3]]).unwrap_err();
        assert_eq!(e.to_string(), "triangle 0 refers to vertex 3, but the solid has 3 vertices");
        let nan = vec![Vec3::new(f64::NAN, 0.0, 0.0), Vec3::x(), Vec3::y()];
        assert!(Solid::new(nan, vec![[0, 1, 2]]).is_err());
        let open = Solid::new(v, vec![[0, 1, 2]]).unwrap();
        assert_eq!(open.volume(), Err(Error::OpenSurface));
        assert_eq!(open.area(), 0.5);
    }

    #[test]
    fn parts_go_with_their_triangles() {
        let cube = Solid::cuboid([0.0; 3], [1.0, 2.0, 3.0]).unwrap();
        let pane = Part { name: Some("pane".into()), is_transparent: true, is_movable: true };
        let numbers: Vec<u16> = (0..12).map(|t| u16::from(t < 4)).collect();
        let parts = Parts::new(numbers, vec![Part::default(), pane]).unwrap();
        let s = cube.clone().with_parts(parts.clone()).unwrap();
        assert!(s.is_transparent(3) && s.is_movable(0) && !s.is_transparent(4) && !cube.is_transparent(0));
        // Its floor and ceiling.
        assert_eq!(s.part_measures(), [(8, 18.0), (4, 4.0)]);
        assert_eq!(cube.part_measures(), [(12, 22.0)]);
        // A mirror image is turned to look outward: its triangles stay in their places.
        let mirrored = s.placed(|v| Vec3::new(-v.x, v.y, v.z), NEVER).unwrap();
        assert_eq!((mirrored.parts(), mirrored.part_measures()), (s.parts(), s.part_measures()));
        assert_ne!(s, cube);
        let e = Solid::new(cube.vertices.clone(), cube.triangles[1..].to_vec()).unwrap().with_parts(parts);
        let words = "the list of part numbers must be of one number for each triangle, not 12 numbers for 11 triangles";
        assert_eq!(e.unwrap_err().to_string(), words);
        let plain = Parts::new(vec![0; 12], vec![Part::default()]).unwrap();
        assert_eq!(cube.clone().with_parts(plain).unwrap(), cube);
    }
}
