//! The stored and transmitted form of evidence.
//!
//! A container of sections (`num/sections.rs`), version 4, letter `'E'`, notes: two-sided; and the sum of 1 where it
//! knows its neighbours, 2 where it says why it was not seen, 4 where it says which face was found elsewhere, 8 where
//! some faces are of leaves or panes. The header's content, little-endian: fingerprint, faces, blocks, samples and
//! stations u32, reference 3×f64, box 6×f64, model. The body: per face its normal 3×f64 and its smooth surface
//! (varint, at most its own number); blocks as (face varint, length u8); samples 3×f32; per station its number i64,
//! origin 3×f64 (NaN: none, infinity: many), step f32, blocks present u32, and per block its number (varint,
//! difference) and per sample the beams (varint) and, unless 0, five signed varints; then the seven shares of why it
//! was not seen, f32, and the face that was found: face and samples u32, deviation and its σ f64; and for each face
//! its kind u8 (0 fixed, 1 movable, 2 transparent). Versions 1 to 3 are read: preamble, header and body one after the
//! other, without checksums; versions 1 and 2 have no surfaces (every face is one) and no steps.

use super::station::StationEvidence;
use super::value::Evidence;
use crate::num::bytes::Put;
use crate::num::sections::{BODY, HEADER, begin, header_end, put_section};
use crate::verify::model::EvidenceModel;
use crate::{Grow, Interrupt, Result, poll_now_and_then};

/// Most bytes of the sums of one sample: five varints of ten bytes, and the beams.
const MAX_SUMS_BYTES: usize = 56;

impl Evidence {
    /// Layout version that this release writes; it reads the ones before too.
    pub const VERSION: u8 = 4;
    /// Bytes of the header's content.
    pub(super) const HEADER_CONTENT: usize = 20 + 72 + EvidenceModel::LEN;
    /// Bytes that suffice for [`Evidence::header`], whatever the version.
    pub const HEADER_LEN: usize = header_end(Self::HEADER_CONTENT);

    /// The stored and transmitted form; equal evidence has equal bytes.
    pub fn to_bytes(&self, interrupt: Interrupt) -> Result<Vec<u8>> {
        let s = &self.samples;
        let mut out = Vec::new();
        // The sums come on top, by as much as each takes.
        out.grow(Self::HEADER_LEN + 25 * s.normals.len() + 12 * s.len(), interrupt)?;
        let told = [self.knows_neighbours, self.unseen.is_some(), self.found.is_some(), s.has_optional()];
        let known = told.iter().rev().fold(0, |bits, told| 2 * bits + u8::from(*told));
        begin(Self::VERSION, b'E', [u8::from(s.two_sided), known], &mut out);
        put_section(HEADER, &mut out, interrupt, |out| {
            out.put_u32(self.fingerprint);
            for n in [s.normals.len(), s.blocks.len(), s.len(), self.stations.len()] {
                out.put_u32(n as u32);
            }
            out.put_vec3(&s.reference);
            self.bounds.min.iter().chain(&self.bounds.max).for_each(|&c| out.put_f64(c));
            self.model.write(out);
            Ok(())
        })?;
        put_section(BODY, &mut out, interrupt, |out| self.put_body(out, interrupt))?;
        Ok(out)
    }

    fn put_body(&self, out: &mut Vec<u8>, interrupt: Interrupt) -> Result<()> {
        let s = &self.samples;
        for (n, surface) in s.normals.iter().zip(&s.surface_of_face) {
            out.put_vec3(n);
            out.put_varint(u64::from(*surface));
        }
        for (i, b) in s.blocks.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            out.put_varint(u64::from(b.face));
            out.put(&[b.len as u8]);
        }
        s.positions.iter().flatten().for_each(|&c| out.put_f32(c));
        for station in &self.stations {
            write_station(station, out, interrupt)?;
        }
        if let Some(unseen) = &self.unseen {
            unseen.write(out);
        }
        if let Some(found) = &self.found {
            found.write(out);
        }
        if s.has_optional() {
            s.kinds.iter().for_each(|kind| out.put(&[*kind as u8]));
        }
        Ok(())
    }
}

fn write_station(station: &StationEvidence, out: &mut Vec<u8>, interrupt: Interrupt) -> Result<()> {
    out.put_i64(station.id);
    out.put_vec3(&station.place.to_vec3());
    out.put_f32(station.step);
    out.put_u32(station.blocks.len() as u32);
    let mut next = 0;
    for (round, (&i, sums)) in station.blocks.iter().enumerate() {
        poll_now_and_then(round, interrupt)?;
        out.grow(10 + MAX_SUMS_BYTES * sums.len(), interrupt)?;
        out.put_varint(u64::from(i - next));
        next = i + 1;
        for s in sums.iter() {
            out.put_varint(u64::from(s.beams()));
            if !s.is_empty() {
                s.parts().into_iter().for_each(|p| out.put_varint_signed(p));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::geometry::{Solid, Vec3};
    use crate::scan::{Beam, Patch};
    use crate::verify::{Collector, EvidenceModel};

    fn small() -> Evidence {
        let solid = Solid::cuboid([3.0, -0.1, -0.1], [3.1, 0.1, 0.1]).unwrap();
        let mut collector = Collector::new(&solid, EvidenceModel::default(), NEVER).unwrap();
        for (station, y) in [(1, 0.0), (2, 0.5)] {
            let end = |i: i32| Vec3::new(2.998, f64::from(i % 10) * 0.02 - 0.09 - y, f64::from(i / 10) * 0.02 - 0.09);
            let beams: Vec<Beam> = (0..100).map(|i| Beam { offset: end(i), returned: i % 7 != 0 }).collect();
            let patch = Patch::encode(station, Vec3::new(0.0, y, 0.0), 6e-3, 1e-4, &beams).unwrap();
            collector.absorb(&patch.to_bytes(), NEVER).unwrap();
        }
        collector.into_evidence()
    }

    #[test]
    fn bytes_round_trip() {
        let evidence = small();
        assert!(evidence.stations().len() == 2);
        let bytes = evidence.to_bytes(NEVER).unwrap();
        let back = Evidence::from_bytes(&bytes, NEVER).unwrap();
        assert_eq!(back, evidence);
        assert_eq!(back.to_bytes(NEVER).unwrap(), bytes);
        let header = Evidence::header(&bytes[..Evidence::HEADER_LEN]).unwrap();
        assert_eq!(
            (header.samples as usize, header.stations, header.bounds),
            (evidence.samples.len(), 2, evidence.bounds)
        );
    }

    /// No byte can be another without being noticed: version and notes stand before the first checksum.
    #[test]
    fn every_flipped_byte_is_an_error() {
        let good = small().to_bytes(NEVER).unwrap();
        for at in 0..good.len() {
            let flips: Vec<u8> = if at < 4 { (1..=255).collect() } else { vec![1, 0x10, 0x80, 0xff] };
            for flip in flips {
                let mut bytes = good.clone();
                bytes[at] ^= flip;
                assert!(Evidence::from_bytes(&bytes, NEVER).is_err(), "byte {at} ^ {flip:#x}");
                let header = Evidence::header(&bytes[..Evidence::HEADER_LEN]);
                assert!(
                    at >= Evidence::HEADER_LEN || at == 0 || header.is_err(),
                    "byte {at} ^ {flip:#x} of the header"
                );
            }
        }
        for len in 0..good.len() {
            assert!(Evidence::from_bytes(&good[..len], NEVER).is_err(), "{len} bytes");
        }
    }
}
