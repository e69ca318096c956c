//! Solids as bytes, stored and transmitted.
//!
//! A container of sections (`num/sections.rs`), version 2, letter `'S'`, whose first note is the closedness, the second 1
//! where there are parts, else 0. The header's content, little-endian: vertex count u32, triangle count u32, box 6×f64,
//! area f64, volume f64 (NaN when open); the body: vertices 3×f64, triangles 3×u32; the optional section 3: parts
//! (`parts.rs`). Version 1 is read: the letter, closedness u8, 0 u8, both counts, CRC-32 of the body u32, the rest of the
//! header, the body.

use super::solid::check;
use super::{Aabb, Closedness, Parts, Solid, Vec3};
use crate::error::{Error, Result};
use crate::num::bytes::{ByteReader, Put};
use crate::num::sections::{self, BODY, HEADER, begin, checksum, header_end, put_section};
use crate::{Grow, Interrupt, NEVER, poll_now_and_then};

const TY: &str = "ab_solid";
/// The section of parts: who does not know it reads the mesh without.
const PARTS: u32 = 3;

impl Solid {
    /// Layout version written by this release.
    pub const VERSION: u8 = 2;
    /// Bytes that suffice for [`Solid::header`], whatever the version.
    pub const HEADER_LEN: usize = header_end(72);
    /// Bytes of the header of version 1.
    const FLAT_HEADER_LEN: usize = 80;

    /// Checksum over vertices and triangles, to tell two geometries apart; parts do not count.
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
        let notes = [self.closedness as u8, u8::from(self.parts.is_some())];
        begin(Self::VERSION, b'S', notes, &mut out);
        put_section(HEADER, &mut out, interrupt, |out| {
            out.put_u32(self.vertices.len() as u32);
            out.put_u32(self.triangles.len() as u32);
            self.bounds.min.iter().chain(&self.bounds.max).for_each(|&c| out.put_f64(c));
            out.put_f64(self.area);
            out.put_f64(self.volume);
            Ok(())
        })?;
        put_section(BODY, &mut out, interrupt, |out| self.put_payload(out, interrupt))?;
        if let Some(parts) = &self.parts {
            put_section(PARTS, &mut out, interrupt, |out| parts.put(out, interrupt))?;
        }
        Ok(out)
    }

    /// Reads bytes from outside: everything that can be derived is derived anew, so nothing in them is trusted.
    pub fn from_bytes(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let Stored { vertices, triangles, parts } = Stored::of(bytes, interrupt)?;
        let solid = Self::interruptible(vertices, triangles, interrupt)?;
        Ok(Self { parts, ..solid })
    }

    /// Reads bytes that this database wrote: the mesh is checked, what the header says about it is taken as it is.
    pub fn from_stored(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let Stored { vertices, triangles, parts } = Stored::of(bytes, interrupt)?;
        check(&vertices, &triangles, interrupt)?;
        let SolidHeader { bounds, area, volume, closedness, .. } = Self::header(bytes)?;
        Ok(Self { vertices, triangles, bounds, area, volume, closedness, parts })
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

/// What stands in a solid's bytes besides the header; its checksums are checked.
struct Stored {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// None where they tell nothing.
    parts: Option<Parts>,
}

impl Stored {
    fn of(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let (_, n_vertices, n_triangles) = Solid::open(bytes)?;
        let (body, parts) = contents(bytes, interrupt)?;
        let mut r = ByteReader::new(body, TY);
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
        let parts = parts.map(|parts| Parts::read(parts, TY, n_triangles, interrupt)).transpose()?;
        Ok(Self { vertices, triangles, parts: parts.filter(|parts| !parts.is_plain()) })
    }
}

/// The bytes of the mesh and, where there are any, of the parts.
fn contents<'a>(bytes: &'a [u8], interrupt: Interrupt) -> Result<(&'a [u8], Option<&'a [u8]>)> {
    if bytes.first() == Some(&Solid::VERSION) {
        let [header, body, parts] = sections::find(bytes, TY, [HEADER, BODY, PARTS], interrupt)?;
        let (Some(_), Some(body)) = (header, body) else { return Err(Error::binary(TY, "a section is missing")) };
        // A value cut short just before its parts would else be a whole one without.
        if bytes[3] != u8::from(parts.is_some()) {
            return Err(Error::binary(TY, "its parts are missing, or not announced"));
        }
        return Ok((body, parts));
    }
    let mut r = ByteReader::new(bytes, TY);
    let (_, expected) = (r.take(12)?, r.u32()?);
    r.take(Solid::FLAT_HEADER_LEN - 16)?;
    let payload = r.take(r.remaining())?;
    if checksum(&[payload], interrupt)? == expected {
        Ok((payload, None))
    } else {
        Err(Error::corrupted(TY, "the checksum does not match"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Part;
    use proptest::prelude::*;

    fn with_parts(solid: Solid) -> Solid {
        let numbers = (0..solid.triangles().len()).map(|t| [0, 2, 2, 1][t % 4]).collect();
        let pane = Part { name: Some("pane".into()), is_transparent: true, ..Part::default() };
        let leaf = Part { is_movable: true, ..Part::default() };
        solid.with_parts(Parts::new(numbers, vec![Part::default(), pane, leaf]).unwrap()).unwrap()
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
    fn parts_are_a_section_behind_the_rest() {
        let plain = Solid::cuboid([0.0; 3], [1.0; 3]).unwrap();
        let solid = with_parts(plain.clone());
        let (bytes, without) = (solid.to_bytes(NEVER).unwrap(), plain.to_bytes(NEVER).unwrap());
        assert_eq!(Solid::from_bytes(&bytes, NEVER).unwrap(), solid);
        assert_eq!(Solid::from_stored(&bytes, NEVER).unwrap(), solid);
        assert_eq!(Solid::from_bytes(&bytes, NEVER).unwrap().to_bytes(NEVER).unwrap(), bytes);
        // A reader that does not know the section finds the same mesh.
        let seen = sections::read(&bytes, TY, [HEADER, BODY], NEVER).unwrap();
        assert_eq!(seen, sections::read(&without, TY, [HEADER, BODY], NEVER).unwrap());
        assert_eq!(solid.fingerprint(NEVER).unwrap(), plain.fingerprint(NEVER).unwrap());
        // Cut off in front of the section, or the section where none is announced.
        assert!(Solid::from_stored(&bytes[..without.len()], NEVER).is_err());
        let unannounced = [&without[..], &bytes[without.len()..]].concat();
        assert!(Solid::from_bytes(&unannounced, NEVER).is_err());
    }

    /// A solid without parts is stored as it was before there were any.
    #[test]
    fn without_parts_nothing_is_added() {
        let bytes = Solid::cuboid([0.0; 3], [1.0; 3]).unwrap().to_bytes(NEVER).unwrap();
        assert_eq!(bytes.len(), Solid::HEADER_LEN + 12 + 8 * 24 + 12 * 12);
        assert_eq!(bytes[..4], [2, b'S', 0, 0]);
        assert_eq!(crc32fast::hash(&bytes), 3_222_229_291);
    }

    #[test]
    fn damage_is_noticed() {
        let good = with_parts(Solid::cuboid([0.0; 3], [1.0; 3]).unwrap()).to_bytes(NEVER).unwrap();
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
            let mut bytes = with_parts(Solid::cuboid([0.0; 3], [1.0; 3]).unwrap()).to_bytes(NEVER).unwrap();
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
