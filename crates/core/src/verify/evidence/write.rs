//! The stored and transmitted form of evidence.
//!
//! A container of sections (`num/sections.rs`), version 4, letter `'E'`, notes: two-sided, knows its neighbours. The
//! header's content, little-endian: fingerprint, faces, blocks, samples and stations u32, reference 3×f64, box 6×f64,
//! model. The body: per face its normal 3×f64 and its smooth surface (varint, at most its own number); blocks as (face
//! varint, length u8); samples 3×f32; per station its number i64, origin 3×f64 (NaN: none, infinity: many), step f32,
//! blocks present u32, and per block its number (varint, difference) and per sample the beams (varint) and, unless 0,
//! five signed varints. Versions 1 to 3 are read: preamble, header and body one after the other, without checksums;
//! versions 1 and 2 have no surfaces (every face is one) and no steps.

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
        begin(Self::VERSION, b'E', [u8::from(s.two_sided), u8::from(self.knows_neighbours)], &mut out);
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
