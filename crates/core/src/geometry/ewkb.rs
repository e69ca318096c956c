//! Solids as PostGIS writes surfaces: EWKB of POLYHEDRALSURFACE Z and TIN Z (and of polygons).

use super::triangulate::triangulate;
use super::{Solid, Vec3};
use crate::error::{Error, Result};
use crate::num::bytes::{ByteReader, Put};
use crate::num::piece_map::PieceMap;
use crate::{Grow, Interrupt, poll_now_and_then};

const TY: &str = "geometry";
const HAS_Z: u32 = 0x8000_0000;
const HAS_M: u32 = 0x4000_0000;
const HAS_SRID: u32 = 0x2000_0000;

const POLYGON: u32 = 3;
const MULTIPOLYGON: u32 = 6;
const POLYHEDRAL_SURFACE: u32 = 15;
const TIN: u32 = 16;
const TRIANGLE: u32 = 17;

/// The triangles of a face must cover its area to within this fraction, or it is refused: a hole lies outside it, or
/// the face is not plane.
const AREA_TOLERANCE: f64 = 0.01;

/// How a surface is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SurfaceKind {
    /// POLYHEDRALSURFACE Z.
    Polyhedral,
    /// TIN Z.
    Tin,
}

impl Solid {
    /// The surface as EWKB, little-endian, without SRID; one face per triangle.
    pub fn to_ewkb(&self, kind: SurfaceKind, interrupt: Interrupt) -> Result<Vec<u8>> {
        let (surface, face) = match kind {
            SurfaceKind::Polyhedral => (POLYHEDRAL_SURFACE, POLYGON),
            SurfaceKind::Tin => (TIN, TRIANGLE),
        };
        let triangles = self.triangles().len();
        let mut out = Vec::new();
        out.grow(9 + 109 * triangles, interrupt)?;
        let put_head = |out: &mut Vec<u8>, ty: u32, count: usize| {
            out.put(&[1]);
            out.put_u32(ty | HAS_Z);
            out.put_u32(count as u32);
        };
        put_head(&mut out, surface, triangles);
        for t in 0..triangles {
            poll_now_and_then(t, interrupt)?;
            put_head(&mut out, face, 1);
            out.put_u32(4);
            let [a, b, c] = self.corners(t);
            [a, b, c, a].iter().for_each(|v| out.put_vec3(v));
        }
        Ok(out)
    }

    /// Reads POLYHEDRALSURFACE Z, TIN Z, MULTIPOLYGON Z, POLYGON Z or TRIANGLE Z in EWKB or ISO WKB. Faces of more than
    /// three corners are cut into triangles; corners with the same coordinates become one vertex.
    pub fn from_ewkb(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let mut cursor = Cursor { r: ByteReader::new(bytes, TY), big_endian: false };
        let mut mesh = PolygonMesh::default();
        match cursor.head()? {
            ty @ (POLYGON | TRIANGLE) => mesh.add_face(&mut cursor, ty, interrupt)?,
            MULTIPOLYGON | POLYHEDRAL_SURFACE | TIN => {
                for i in 0..cursor.u32()? {
                    poll_now_and_then(i as usize, interrupt)?;
                    match cursor.head()? {
                        ty @ (POLYGON | TRIANGLE) => mesh.add_face(&mut cursor, ty, interrupt)?,
                        other => return Err(cursor.r.bad(format!("a face of geometry type {other}"))),
                    }
                }
            }
            other => {
                let expected = "a POLYHEDRALSURFACE Z, TIN Z, MULTIPOLYGON Z, POLYGON Z or TRIANGLE Z";
                return Err(Error::argument("the geometry of a solid", expected, format!("geometry type {other}")));
            }
        }
        cursor.r.finish()?;
        Self::interruptible(mesh.vertices, mesh.triangles, interrupt)
    }
}

/// Reads numbers in the byte order of the geometry at hand.
struct Cursor<'a> {
    r: ByteReader<'a>,
    big_endian: bool,
}

impl Cursor<'_> {
    /// Byte order and type of the next geometry; only those with Z and without M are let through.
    fn head(&mut self) -> Result<u32> {
        self.big_endian = match self.r.u8()? {
            0 => true,
            1 => false,
            other => return Err(self.r.bad(format!("byte order {other}"))),
        };
        let word = self.u32()?;
        if word & HAS_SRID != 0 {
            self.u32()?;
        }
        let ty = word & 0xffff;
        let (plain, iso) = (ty % 1000, ty / 1000);
        let has_z = word & HAS_Z != 0 || iso == 1;
        if !has_z || word & HAS_M != 0 || iso > 1 {
            return Err(Error::argument("the geometry of a solid", "of three dimensions, x y z", "of others"));
        }
        Ok(plain)
    }

    fn u32(&mut self) -> Result<u32> {
        let v = self.r.u32()?;
        Ok(if self.big_endian { v.swap_bytes() } else { v })
    }

    fn point(&mut self) -> Result<Vec3> {
        let v = self.r.vec3()?;
        Ok(if self.big_endian { v.map(|c| f64::from_bits(c.to_bits().swap_bytes())) } else { v })
    }

    /// A ring without its closing point.
    fn ring(&mut self) -> Result<Vec<Vec3>> {
        let n = self.u32()? as usize;
        // Points are read below; more than there are bytes for would only be asked memory for.
        if n > self.r.remaining() / 24 {
            return Err(self.r.bad(format!("a ring of {n} points that is cut short")));
        }
        if n < 3 {
            return Err(self.r.bad(format!("a ring of {n} points")));
        }
        let mut ring = (0..n).map(|_| self.point()).collect::<Result<Vec<Vec3>>>()?;
        if let Some(c) = ring.iter().flatten().find(|c| !c.is_finite()) {
            return Err(Error::argument("a coordinate", "finite", c));
        }
        if ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        Ok(ring)
    }
}

/// A mesh being built.
#[derive(Default)]
struct PolygonMesh {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    number_of: PieceMap<[u64; 3], u32>,
}

impl PolygonMesh {
    fn number(&mut self, v: Vec3, interrupt: Interrupt) -> Result<u32> {
        // Zero has two forms.
        let key = v.map(|c| (c + 0.0).to_bits()).into();
        let fresh = || {
            self.vertices.push(v);
            self.vertices.len() as u32 - 1
        };
        self.number_of.made_by(key, fresh, interrupt).copied()
    }

    /// Adds the polygon or triangle whose head was read.
    fn add_face(&mut self, cursor: &mut Cursor, ty: u32, interrupt: Interrupt) -> Result<()> {
        let rings = cursor.u32()?;
        let mut corners = Vec::new();
        let mut holes = Vec::new();
        for i in 0..rings {
            if i > 0 {
                holes.push(corners.len());
            }
            poll_now_and_then(i as usize, interrupt)?;
            corners.extend(cursor.ring()?);
        }
        let outer = holes.first().copied().unwrap_or(corners.len());
        if ty == TRIANGLE && corners.len() != 3 {
            return Err(cursor.r.bad(format!("a triangle of {} corners", corners.len())));
        }
        let whole = corners.len() == 3 && holes.is_empty();
        let enclosed = enclosed(&corners, &holes);
        let cut = if whole {
            vec![[0, 1, 2]]
        } else {
            triangulate(&corners, &holes, &normal(&corners[..outer]), interrupt)?.ok_or_else(|| bad(&corners))?
        };
        let area = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|i| corners[i]);
            (b - a).cross(&(c - a)).norm()
        };
        let covered: f64 = cut.iter().map(area).sum();
        if cut.is_empty() || (covered - enclosed).abs() > AREA_TOLERANCE * enclosed {
            return Err(bad(&corners));
        }
        self.vertices.grow(corners.len(), interrupt)?;
        self.triangles.grow(cut.len(), interrupt)?;
        let numbers = corners.into_iter().map(|c| self.number(c, interrupt)).collect::<Result<Vec<u32>>>()?;
        self.triangles.extend(cut.iter().map(|t| t.map(|i| numbers[i])));
        Ok(())
    }
}

fn bad(corners: &[Vec3]) -> Error {
    let n = corners.len();
    Error::binary(TY, format!("a face of {n} corners that encloses nothing, is not plane or crosses itself"))
}

/// Twice the area inside the outer ring and outside the holes, by Newell's normals.
fn enclosed(corners: &[Vec3], holes: &[usize]) -> f64 {
    let starts = std::iter::once(0).chain(holes.iter().copied());
    let ends = holes.iter().copied().chain(std::iter::once(corners.len()));
    let ring = |(start, end): (usize, usize)| normal(&corners[start..end]).norm();
    let mut areas = starts.zip(ends).map(ring);
    areas.next().unwrap_or(0.0) - areas.sum::<f64>()
}

/// Newell's normal of a ring; its length is twice the area.
fn normal(ring: &[Vec3]) -> Vec3 {
    let turn = |i: usize| (ring[i] - ring[0]).cross(&(ring[(i + 1) % ring.len()] - ring[0]));
    (0..ring.len()).map(turn).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use proptest::prelude::*;

    fn write(ty: u32, faces: &[Vec<Vec<[f64; 3]>>], big_endian: bool) -> Vec<u8> {
        let mut out = Vec::new();
        let word = |out: &mut Vec<u8>, v: u32| out.extend(if big_endian { v.to_be_bytes() } else { v.to_le_bytes() });
        let head = |out: &mut Vec<u8>, ty: u32| {
            out.push(u8::from(!big_endian));
            word(out, ty | HAS_Z);
        };
        head(&mut out, ty | HAS_SRID);
        word(&mut out, 25832);
        word(&mut out, faces.len() as u32);
        for rings in faces {
            head(&mut out, POLYGON);
            word(&mut out, rings.len() as u32);
            for ring in rings {
                word(&mut out, ring.len() as u32 + 1);
                for c in ring.iter().chain(&ring[..1]).flatten() {
                    out.extend(if big_endian { c.to_be_bytes() } else { c.to_le_bytes() });
                }
            }
        }
        out
    }

    /// A plate 4 x 4 x 1 with a square hole 2 x 2 through it: volume 12.
    fn plate_with_hole() -> Vec<Vec<Vec<[f64; 3]>>> {
        let (o, i) =
            ([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], [[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]]);
        let at = |p: [f64; 2], z: f64| [p[0] + 6e5, p[1] + 5.3e6, z];
        let ring = |r: [[f64; 2]; 4], z: f64, back: bool| -> Vec<[f64; 3]> {
            let up = r.map(|p| at(p, z));
            if back { up.into_iter().rev().collect() } else { up.to_vec() }
        };
        let mut faces =
            vec![vec![ring(o, 1.0, false), ring(i, 1.0, true)], vec![ring(o, 0.0, true), ring(i, 0.0, false)]];
        for k in 0..4 {
            let (a, b) = (o[k], o[(k + 1) % 4]);
            faces.push(vec![vec![at(a, 0.0), at(b, 0.0), at(b, 1.0), at(a, 1.0)]]);
            let (a, b) = (i[(k + 1) % 4], i[k]);
            faces.push(vec![vec![at(a, 0.0), at(b, 0.0), at(b, 1.0), at(a, 1.0)]]);
        }
        faces
    }

    #[test]
    fn faces_with_holes_in_either_byte_order() {
        for big_endian in [false, true] {
            for ty in [POLYHEDRAL_SURFACE, MULTIPOLYGON] {
                let s = Solid::from_ewkb(&write(ty, &plate_with_hole(), big_endian), NEVER).unwrap();
                assert!((s.volume().unwrap() - 12.0).abs() < 1e-9, "{:?}", s.volume());
                assert!((s.area() - 2.0 * 12.0 - 24.0).abs() < 1e-9);
                assert_eq!(s.vertices().len(), 16);
            }
        }
    }

    #[test]
    fn there_and_back_keeps_every_triangle() {
        let s = Solid::cylinder([6e5, 5.3e6, 1.0], 0.3, 2.5, 24).unwrap();
        for kind in [SurfaceKind::Polyhedral, SurfaceKind::Tin] {
            let back = Solid::from_ewkb(&s.to_ewkb(kind, NEVER).unwrap(), NEVER).unwrap();
            assert_eq!(back.triangles().len(), s.triangles().len());
            assert!((0..s.triangles().len()).all(|t| back.corners(t) == s.corners(t)));
            assert_eq!(back.closedness(), s.closedness());
        }
    }

    #[test]
    fn faces_that_are_none() {
        let face = |rings: &[&[[f64; 2]]]| -> Vec<Vec<Vec<[f64; 3]>>> {
            vec![rings.iter().map(|r| r.iter().map(|p| [p[0], p[1], 1.0]).collect()).collect()]
        };
        let square: &[[f64; 2]] = &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let crossed = face(&[&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0], [-1.0, 2.0]]]);
        let outside = face(&[square, &[[6.0, 0.0], [7.0, 0.0], [7.0, 1.0]]]);
        let flat = face(&[&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]]);
        for faces in [crossed, outside, flat] {
            assert!(Solid::from_ewkb(&write(POLYHEDRAL_SURFACE, &faces, false), NEVER).is_err());
        }
        assert!(Solid::from_ewkb(&write(POLYHEDRAL_SURFACE, &face(&[square]), false), NEVER).is_ok());
    }

    #[test]
    fn what_is_no_surface() {
        let flat = [1u8, 3, 0, 0, 0, 0, 0, 0, 0];
        assert!(Solid::from_ewkb(&flat, NEVER).unwrap_err().to_string().contains("three dimensions"));
        let point = [&[1u8][..], &(1 | HAS_Z).to_le_bytes(), &[0; 24]].concat();
        assert!(Solid::from_ewkb(&point, NEVER).unwrap_err().to_string().contains("geometry type 1"));
        assert!(matches!(Solid::from_ewkb(&write(TIN, &[], false), NEVER), Err(Error::Empty { .. })));
        let mut huge = write(POLYHEDRAL_SURFACE, &plate_with_hole(), false);
        huge[9..13].copy_from_slice(&u32::MAX.to_le_bytes());
        assert!(matches!(Solid::from_ewkb(&huge, NEVER), Err(Error::Binary { .. })));
        let nan = vec![vec![vec![[f64::NAN, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]]];
        assert!(matches!(Solid::from_ewkb(&write(TIN, &nan, false), NEVER), Err(Error::Argument { .. })));
    }

    proptest! {
        #[test]
        fn damaged_bytes_never_panic(at in any::<usize>(), x in 1u8.., cut in 0usize..400) {
            let mut bytes = write(POLYHEDRAL_SURFACE, &plate_with_hole(), false);
            let n = bytes.len();
            bytes[at % n] ^= x;
            bytes.truncate(n - cut);
            let _ = Solid::from_ewkb(&bytes, NEVER);
        }

        /// Star-shaped polygons, convex or not: the triangles fill them.
        #[test]
        fn triangles_fill_the_polygon(radii in prop::collection::vec(0.2..3.0f64, 3..40), tilt in -1.0..1.0f64) {
            let n = radii.len();
            let corner = |(k, r): (usize, &f64)| {
                let a = std::f64::consts::TAU * k as f64 / n as f64;
                Vec3::new(r * a.cos(), r * a.sin(), 5.0 + tilt * r * a.cos())
            };
            let corners: Vec<Vec3> = radii.iter().enumerate().map(corner).collect();
            let turn = |i: usize| corners[i].cross(&corners[(i + 1) % n]);
            let expected = 0.5 * (0..n).map(turn).sum::<Vec3>().dot(&Vec3::new(-tilt, 0.0, 1.0).normalize());
            let cut = triangulate(&corners, &[], &normal(&corners), NEVER).unwrap().unwrap();
            let area: f64 = cut.iter().map(|t| {
                let [a, b, c] = t.map(|i| corners[i]);
                0.5 * (b - a).cross(&(c - a)).dot(&Vec3::new(-tilt, 0.0, 1.0).normalize())
            }).sum();
            prop_assert!((area - expected).abs() < 1e-9 * expected.abs().max(1.0), "{} {}", area, expected);
        }
    }
}
