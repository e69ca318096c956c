//! Reading stored evidence, of this layout and of older ones: see `write` for what they are.

use super::found_face::FoundFace;
use super::header::EvidenceHeader;
use super::samples::{BLOCK, SampleBlock, Samples};
use super::station::{StationEvidence, StationOrigin};
use super::unseen::Unseen;
use super::value::{Evidence, MAX_SUMS};
use crate::error::{Error, Result};
use crate::geometry::{Aabb, FaceKind, Vec3};
use crate::num::bytes::ByteReader;
use crate::num::sections::{self, BODY, HEADER};
use crate::verify::model::{BeamModel, EvidenceModel, ModelKind, Sums, with_model};
use crate::{Grow, Interrupt, NEVER, poll_now_and_then};

const TY: &str = "ab_evidence";

impl Evidence {
    /// The header alone.
    pub fn header(bytes: &[u8]) -> Result<EvidenceHeader> {
        let h = read_header(bytes)?;
        Ok(EvidenceHeader { bounds: h.bounds, samples: h.counts[2], stations: h.counts[3], model: h.model })
    }

    /// Reads bytes, foreign ones too: nothing is read past them, and no more is allocated than `MAX_SUMS` allows.
    pub fn from_bytes(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let h = read_header(bytes)?;
        let mut r = ByteReader::new(body(bytes, h.version, interrupt)?, TY);
        let [faces, blocks, samples, stations] = h.counts.map(|c| c as usize);
        let least = 24 * faces as u64 + 2 * blocks as u64 + 12 * samples as u64 + 36 * stations as u64;
        if least > r.remaining() as u64 {
            return Err(r.bad(format!("{samples} samples and {stations} stations do not fit its length")));
        }
        let mut samples = read_samples(&mut r, &h, interrupt)?;
        let mut room = MAX_SUMS / BLOCK;
        let stations = (0..stations)
            .map(|_| read_station(&mut r, &samples, &h, &mut room, interrupt))
            .collect::<Result<Vec<_>>>()?;
        if stations.windows(2).any(|w| w[0].key() >= w[1].key()) {
            return Err(r.bad("its stations are not in order"));
        }
        let unseen = h.is_unseen.then(|| Unseen::read(&mut r)).transpose()?;
        let found = h.is_found.then(|| FoundFace::read(&mut r, samples.normals.len())).transpose()?;
        if h.has_kinds {
            samples.kinds = read_kinds(&mut r, samples.normals.len(), interrupt)?;
        }
        r.finish()?;
        let (fingerprint, bounds, knows_neighbours) = (h.fingerprint, h.bounds, h.knows_neighbours);
        Ok(Self { model: h.model, fingerprint, bounds, samples, knows_neighbours, unseen, found, stations })
    }
}

/// The header as it is written.
struct RawHeader {
    version: u8,
    two_sided: bool,
    knows_neighbours: bool,
    /// Why it was not seen follows the stations.
    is_unseen: bool,
    /// The face that was found elsewhere follows that.
    is_found: bool,
    /// The kinds of the faces follow that.
    has_kinds: bool,
    fingerprint: u32,
    /// Faces, blocks, samples and stations.
    counts: [u32; 4],
    reference: Vec3,
    bounds: Aabb,
    model: EvidenceModel,
}

fn read_header(bytes: &[u8]) -> Result<RawHeader> {
    let mut r = ByteReader::new(bytes, TY);
    let version = r.u8()?;
    if r.u8()? != b'E' {
        return Err(r.bad("it does not start as evidence does"));
    }
    if version == 0 || version > Evidence::VERSION {
        return Err(Error::Version { ty: TY, found: version, known: Evidence::VERSION });
    }
    let (two_sided, known) = (r.u8()? != 0, r.u8()?);
    if known > if version > LAST_FLAT { 15 } else { 1 } {
        return Err(r.bad(format!("note {known}")));
    }
    let [knows_neighbours, is_unseen, is_found, has_kinds] = [1, 2, 4, 8].map(|bit| known & bit != 0);
    if version > LAST_FLAT {
        r = sections::header(bytes, TY, NEVER)?;
    }
    let fingerprint = r.u32()?;
    let counts = [r.u32()?, r.u32()?, r.u32()?, r.u32()?];
    let reference = r.vec3()?;
    let bounds = Aabb { min: r.vec3()?.into(), max: r.vec3()?.into() };
    let coordinates = reference.iter().chain(&bounds.min).chain(&bounds.max);
    if !coordinates.into_iter().all(|c| c.is_finite()) {
        return Err(r.bad("a coordinate is not finite"));
    }
    let model = EvidenceModel::read(&mut r)?;
    Ok(RawHeader {
        version,
        two_sided,
        knows_neighbours,
        is_unseen,
        is_found,
        has_kinds,
        fingerprint,
        counts,
        reference,
        bounds,
        model,
    })
}

/// Newest version without sections.
const LAST_FLAT: u8 = 3;

/// What follows the header.
fn body<'a>(bytes: &'a [u8], version: u8, interrupt: Interrupt) -> Result<&'a [u8]> {
    if version > LAST_FLAT {
        return sections::read(bytes, TY, [HEADER, BODY], interrupt).map(|[_, body]| body);
    }
    Ok(bytes.get(4 + Evidence::HEADER_CONTENT..).unwrap_or_default())
}

fn read_samples(r: &mut ByteReader, h: &RawHeader, interrupt: Interrupt) -> Result<Samples> {
    let [faces, blocks, samples, _] = h.counts.map(|c| c as usize);
    let (normals, surface_of_face) = read_faces(r, faces, h.version, interrupt)?;
    let blocks = read_blocks(r, blocks, faces, samples, interrupt)?;
    let mut positions = Vec::new();
    positions.grow(samples, interrupt)?;
    for i in 0..samples {
        poll_now_and_then(i, interrupt)?;
        positions.push(finite_position(r)?);
    }
    let (reference, two_sided, kinds) = (h.reference, h.two_sided, vec![FaceKind::Fixed; normals.len()]);
    Ok(Samples { reference, positions, normals, surface_of_face, kinds, blocks, two_sided })
}

/// The kind of each face, not all of them fixed.
fn read_kinds(r: &mut ByteReader, faces: usize, interrupt: Interrupt) -> Result<Vec<FaceKind>> {
    let mut kinds = Vec::new();
    kinds.grow(faces, interrupt)?;
    for face in 0..faces {
        poll_now_and_then(face, interrupt)?;
        let number = r.u8()?;
        kinds.push(FaceKind::of_number(number).ok_or_else(|| r.bad(format!("face {face} of kind {number}")))?);
    }
    if kinds.iter().any(|kind| *kind != FaceKind::Fixed) { Ok(kinds) } else { Err(r.bad("no face of a kind")) }
}

fn unit(r: &mut ByteReader) -> Result<Vec3> {
    let n = r.vec3()?;
    if (n.norm() - 1.0).abs() < 1e-6 { Ok(n) } else { Err(r.bad("a normal is not a unit vector")) }
}

fn read_faces(r: &mut ByteReader, count: usize, version: u8, interrupt: Interrupt) -> Result<(Vec<Vec3>, Vec<u32>)> {
    let (mut normals, mut surfaces) = (Vec::new(), Vec::new());
    normals.grow(count, interrupt)?;
    surfaces.grow(count, interrupt)?;
    for face in 0..count as u32 {
        poll_now_and_then(face as usize, interrupt)?;
        normals.push(unit(r)?);
        let surface = if version < 3 { u64::from(face) } else { r.varint()? };
        if surface > u64::from(face) {
            return Err(r.bad(format!("face {face} on surface {surface}")));
        }
        surfaces.push(surface as u32);
    }
    Ok((normals, surfaces))
}

fn finite_position(r: &mut ByteReader) -> Result<[f32; 3]> {
    let p = [r.f32()?, r.f32()?, r.f32()?];
    if p.iter().all(|c| c.is_finite()) { Ok(p) } else { Err(r.bad("a sample is not finite")) }
}

fn read_blocks(
    r: &mut ByteReader,
    count: usize,
    faces: usize,
    samples: usize,
    interrupt: Interrupt,
) -> Result<Vec<SampleBlock>> {
    let mut start = 0u64;
    let mut out = Vec::new();
    out.grow(count, interrupt)?;
    for round in 0..count {
        poll_now_and_then(round, interrupt)?;
        let (face, len) = (r.varint()?, u32::from(r.u8()?));
        if face >= faces as u64 || len == 0 || len as usize > BLOCK {
            return Err(r.bad(format!("a block of {len} samples on face {face} of {faces}")));
        }
        out.push(SampleBlock { start: start as u32, len, face: face as u32 });
        start += u64::from(len);
        if start > samples as u64 {
            break;
        }
    }
    if start == samples as u64 { Ok(out) } else { Err(r.bad("its blocks do not hold its samples")) }
}

fn read_station(
    r: &mut ByteReader,
    samples: &Samples,
    header: &RawHeader,
    room: &mut usize,
    interrupt: Interrupt,
) -> Result<StationEvidence> {
    let id = r.i64()?;
    let place = StationOrigin::from_vec3(r.vec3()?).ok_or_else(|| r.bad("a station's origin is not finite"))?;
    let mut station = StationEvidence::new(id, place);
    if header.version >= 3 {
        station.step = r.f32()?;
        if !(0.0..=1e3).contains(&station.step) {
            return Err(r.bad(format!("a station's step of {} rad", station.step)));
        }
    }
    let present = r.u32()?;
    if present == 0 {
        return Err(r.bad("a station that saw nothing"));
    }
    let mut next = 0u64;
    for round in 0..present {
        poll_now_and_then(round as usize, interrupt)?;
        let i = next.saturating_add(r.varint()?);
        let place = usize::try_from(i).unwrap_or(usize::MAX);
        let block = samples.blocks.get(place).ok_or_else(|| r.bad(format!("sums for block {i}")))?;
        *room = room.checked_sub(1).ok_or_else(|| r.bad(format!("more than {MAX_SUMS} sums")))?;
        let sums = (0..block.len).map(|_| read_sums(r, header.model.kind)).collect::<Result<Box<[Sums]>>>()?;
        station.blocks.insert(i as u32, sums);
        next = i + 1;
    }
    Ok(station)
}

fn read_sums(r: &mut ByteReader, kind: ModelKind) -> Result<Sums> {
    let beams = u32::try_from(r.varint()?).map_err(|_| r.bad("too many beams"))?;
    let mut parts = [0; Sums::PARTS];
    if beams > 0 {
        for p in &mut parts {
            *p = r.varint_signed()?;
        }
    }
    let sums = Sums::new(beams, parts);
    let possible = with_model!(kind, M => M::are_possible(&sums));
    if possible { Ok(sums) } else { Err(r.bad("sums that no beams can add up to")) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Solid;
    use crate::scan::{Beam, Patch};
    use crate::verify::Collector;

    /// Layouts 1 and 2 are layout 3 without the faces' surfaces and the stations' steps, and that is 4 without
    /// sections.
    #[test]
    fn older_layouts_are_read_and_add_up_with_new_ones() {
        let column = Solid::cylinder([4.0, 0.0, -1.0], 0.3, 2.0, 16).unwrap();
        let beams: Vec<Beam> = (0..400)
            .map(|i| Vec3::new(3.7, f64::from(i % 20) * 0.02 - 0.2, f64::from(i / 20) * 0.02))
            .map(|offset| Beam { offset, returned: true })
            .collect();
        let patch = Patch::encode(7, Vec3::zeros(), 5e-3, 1e-4, &beams).unwrap().to_bytes();
        let mut collector = Collector::new(&column, EvidenceModel::default(), NEVER).unwrap();
        collector.absorb(&patch, NEVER).unwrap();
        let new = collector.into_evidence();
        let bytes = new.to_bytes(NEVER).unwrap();
        let (faces, s) = (new.samples.normals.len(), &new.samples);
        let [header, mut rest] = sections::read(&bytes, TY, [HEADER, BODY], NEVER).unwrap();
        let third = [&[3], &bytes[1..4], header, rest].concat();
        assert_eq!(Evidence::from_bytes(&third, NEVER).unwrap(), new);
        let mut old = third[..4 + Evidence::HEADER_CONTENT].to_vec();
        old[0] = 1;
        for _ in 0..faces {
            old.extend(&rest[..24]);
            rest = &rest[25..];
        }
        let to_step = 2 * s.blocks.len() + 12 * s.len() + 8 + 24;
        old.extend(&rest[..to_step]);
        old.extend(&rest[to_step + 4..]);
        let mut read = Evidence::from_bytes(&old, NEVER).unwrap();
        assert_eq!(read.stations[0].blocks, new.stations[0].blocks);
        assert!(read.stations[0].step == 0.0 && read.samples.surface_of_face != new.samples.surface_of_face);
        read.merge(&new.without_stations(), NEVER).unwrap();
        assert_eq!(read.samples, new.samples);
    }
}
