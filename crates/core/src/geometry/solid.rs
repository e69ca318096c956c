//! A building object's geometry: a triangle mesh with what it encloses.

use super::closedness::closedness;
use super::coordinate::check_coordinates;
use super::weld::weld;
use super::{Aabb, Closedness, Vec3};
use crate::error::{Error, Limited, Result};
use crate::num::bytes::{ByteReader, Put};
use crate::num::sections::{self, BODY, HEADER, begin, checksum, header_end, put_section};
use crate::{Grow, Interrupt, NEVER, poll_now_and_then};

const TY: &str = "ab_solid";

/// A triangle mesh, world coordinates in metres, triangles counter-clockwise seen from outside.
///
/// Stored as a container of sections (`num/sections.rs`), version 2, letter `'S'`, whose first note is the closedness.
/// The header's content, little-endian: vertex count u32, triangle count u32, box 6×f64, area f64, volume f64 (NaN when
/// open); the body: vertices 3×f64, triangles 3×u32. Version 1 is read: the letter, closedness u8, 0 u8, both counts,
/// CRC-32 of the body u32, the rest of the header, the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    bounds: Aabb,
    area: f64,
    volume: f64,
    closedness: Closedness,
}

impl Solid {
    /// Layout version written by this release.
    pub const VERSION: u8 = 2;
    /// Bytes that suffice for [`Solid::header`], whatever the version.
    pub const HEADER_LEN: usize = header_end(72);
    /// Bytes of the header of version 1.
    const FLAT_HEADER_LEN: usize = 80;
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
            area += 0.5 * (b - a).cross(&(c - a)).norm();
            six_volume += a.dot(&b.cross(&c));
        }
        if closedness != Closedness::Open && six_volume < 0.0 {
            triangles.iter_mut().for_each(|t| t.swap(1, 2));
            six_volume = -six_volume;
        }
        let volume = if closedness == Closedness::Open { f64::NAN } else { six_volume / 6.0 };
        Ok(Self { vertices, triangles, bounds, area, volume, closedness })
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

    /// Enclosed volume, m³.
    pub fn volume(&self) -> Result<f64> {
        if self.closedness == Closedness::Open { Err(Error::OpenSurface) } else { Ok(self.volume) }
    }

    /// Checksum over vertices and triangles, to tell two geometries apart.
    pub fn fingerprint(&self, interrupt: Interrupt) -> Result<u32> {
        let mut payload = Vec::new();
        payload.grow(self.payload_len(), interrupt)?;
        self.put_payload(&mut payload, interrupt)?;
        checksum(&[&payload], interrupt)
    }

    fn payload_len(&self) -> usize {
        24 * self.vertices.len() + 12 * self.triangles.len()
    }

    fn put_payload(&self, out: &mut Vec<u8>, interrupt: Interrupt) -> Result<()> {
        for (i, v) in self.vertices.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            out.put_vec3(v);
        }
        for (i, t) in self.triangles.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            t.iter().for_each(|&i| out.put_u32(i));
        }
        Ok(())
    }

    /// The stored and transmitted form.
    pub fn to_bytes(&self, interrupt: Interrupt) -> Result<Vec<u8>> {
        let mut out = Vec::new();
        out.grow(Self::HEADER_LEN + 12 + self.payload_len(), interrupt)?;
        begin(Self::VERSION, b'S', [self.closedness as u8, 0], &mut out);
        put_section(HEADER, &mut out, interrupt, |out| {
            out.put_u32(self.vertices.len() as u32);
            out.put_u32(self.triangles.len() as u32);
            self.bounds.min.iter().chain(&self.bounds.max).for_each(|&c| out.put_f64(c));
            out.put_f64(self.area);
            out.put_f64(self.volume);
            Ok(())
        })?;
        put_section(BODY, &mut out, interrupt, |out| self.put_payload(out, interrupt))?;
        Ok(out)
    }

    /// Reads bytes from outside: everything that can be derived is derived anew, so nothing in them is trusted.
    pub fn from_bytes(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let (vertices, triangles) = Self::mesh_of(bytes, interrupt)?;
        Self::interruptible(vertices, triangles, interrupt)
    }

    /// Reads bytes that this database wrote: the mesh is checked, what the header says about it is taken as it is.
    pub fn from_stored(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let (vertices, triangles) = Self::mesh_of(bytes, interrupt)?;
        check(&vertices, &triangles, interrupt)?;
        let SolidHeader { bounds, area, volume, closedness, .. } = Self::header(bytes)?;
        Ok(Self { vertices, triangles, bounds, area, volume, closedness })
    }

    fn mesh_of(bytes: &[u8], interrupt: Interrupt) -> Result<(Vec<Vec3>, Vec<[u32; 3]>)> {
        let (_, n_vertices, n_triangles) = Self::open(bytes)?;
        let mut r = ByteReader::new(Self::payload_of(bytes, interrupt)?, TY);
        if r.remaining() as u64 != 24 * n_vertices as u64 + 12 * n_triangles as u64 {
            return Err(r.bad(format!("{n_vertices} vertices and {n_triangles} triangles do not fill its length")));
        }
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        vertices.grow(n_vertices, interrupt)?;
        for i in 0..n_vertices {
            poll_now_and_then(i, interrupt)?;
            vertices.push(r.vec3()?);
        }
        triangles.grow(n_triangles, interrupt)?;
        for i in 0..n_triangles {
            poll_now_and_then(i, interrupt)?;
            triangles.push([r.u32()?, r.u32()?, r.u32()?]);
        }
        Ok((vertices, triangles))
    }

    /// Box, area, volume and closedness from the first [`Solid::HEADER_LEN`] bytes alone.
    pub fn header(bytes: &[u8]) -> Result<SolidHeader> {
        let (mut r, vertices, triangles) = Self::open(bytes)?;
        let closedness = Closedness::from_u8(bytes[2]).ok_or_else(|| r.bad("unknown closedness"))?;
        let (min, max) = (r.vec3()?, r.vec3()?);
        let bounds = Aabb { min: min.into(), max: max.into() };
        Ok(SolidHeader { bounds, area: r.f64()?, volume: r.f64()?, closedness, vertices, triangles })
    }

    /// Numbers of vertices and triangles, and what follows them in the header.
    fn open(bytes: &[u8]) -> Result<(ByteReader<'_>, usize, usize)> {
        let mut r = ByteReader::new(bytes, TY);
        let version = r.u8()?;
        if r.u8()? != b'S' {
            return Err(r.bad("it does not start as a solid does"));
        }
        if version == 0 || version > Self::VERSION {
            return Err(Error::Version { ty: TY, found: version, known: Self::VERSION });
        }
        r.take(2)?;
        let is_flat = version == 1;
        let mut r = if is_flat { r } else { sections::header(bytes, TY, NEVER)? };
        let (vertices, triangles) = (r.u32()? as usize, r.u32()? as usize);
        if is_flat {
            r.u32()?;
        }
        Ok((r, vertices, triangles))
    }

    /// Vertices and triangles as they are stored, their checksum checked.
    fn payload_of<'a>(bytes: &'a [u8], interrupt: Interrupt) -> Result<&'a [u8]> {
        if bytes.first() == Some(&Self::VERSION) {
            return sections::read(bytes, TY, [HEADER, BODY], interrupt).map(|[_, body]| body);
        }
        let mut r = ByteReader::new(bytes, TY);
        let (_, expected) = (r.take(12)?, r.u32()?);
        r.take(Self::FLAT_HEADER_LEN - 16)?;
        let payload = r.take(r.remaining())?;
        if checksum(&[payload], interrupt)? == expected {
            Ok(payload)
        } else {
            Err(Error::corrupted(TY, "the checksum does not match"))
        }
    }
}

/// What a solid's header tells without its mesh.
#[derive(Debug, Clone, Copy)]
pub struct SolidHeader {
    /// Box around all vertices.
    pub bounds: Aabb,
    /// Surface area, m².
    pub area: f64,
    /// Volume, m³; NaN for an open surface.
    pub volume: f64,
    /// Whether the mesh bounds a volume.
    pub closedness: Closedness,
    /// Number of vertices.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
}

fn check(vertices: &[Vec3], triangles: &[[u32; 3]], interrupt: Interrupt) -> Result<()> {
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
    use proptest::prelude::*;

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
    fn bytes_round_trip_and_header_agrees() {
        let s = Solid::cylinder([1.0, 2.0, 3.0], 0.2, 3.0, 24).unwrap();
        let bytes = s.to_bytes(NEVER).unwrap();
        assert_eq!(Solid::from_bytes(&bytes, NEVER).unwrap(), s);
        assert_eq!(Solid::from_stored(&bytes, NEVER).unwrap(), s);
        let h = Solid::header(&bytes[..Solid::HEADER_LEN]).unwrap();
        assert_eq!((h.bounds, h.area, h.closedness), (s.bounds, s.area, s.closedness));
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
    fn damage_is_noticed() {
        let good = Solid::cuboid([0.0; 3], [1.0; 3]).unwrap().to_bytes(NEVER).unwrap();
        for at in 0..good.len() {
            for x in [1, 2, 3, 0x80, 0xff] {
                let mut bytes = good.clone();
                bytes[at] ^= x;
                assert!(Solid::from_bytes(&bytes, NEVER).is_err(), "byte {at}");
                assert!(Solid::from_stored(&bytes, NEVER).is_err(), "byte {at}");
            }
        }
    }

    proptest! {
        #[test]
        fn damaged_bytes_never_panic(
            cut in 0usize..400,
            flips in prop::collection::vec((0usize..400, any::<u8>()), 0..8),
        ) {
            let mut bytes = Solid::cuboid([0.0; 3], [1.0; 3]).unwrap().to_bytes(NEVER).unwrap();
            for (at, x) in flips {
                let n = bytes.len();
                bytes[at % n] ^= x;
            }
            bytes.truncate(bytes.len().saturating_sub(cut % 50));
            let _ = Solid::from_bytes(&bytes, NEVER);
            let _ = Solid::from_stored(&bytes, NEVER);
            let _ = Solid::header(&bytes);
        }
    }
}
