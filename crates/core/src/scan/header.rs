//! What a patch tells without its payload.

use super::beams::Beams;
use super::cone::Cone;
use super::origins::Origins;
use super::patch_spec::PatchSpec;
use super::spacing::Spacing;
use crate::NEVER;
use crate::error::{Error, Result};
use crate::geometry::{Aabb, Vec3};
use crate::num::bytes::{ByteReader, Put};
use crate::num::sections::{self, BODY, HEADER, begin, header_end, put_section};

pub(super) const TY: &str = "ab_scan";

/// How far the beams' hull is grown on every side: the widest search band. A surface up to this far behind the returns
/// is still joined with them by `&&`, so that an object built in front of where it was drawn is found.
pub const JOIN_MARGIN_M: f64 = 0.25;
/// A beam without return counts as having looked this far; the hull of a patch extends to there.
pub const NO_RETURN_REACH_M: f64 = 30.0;

/// How far from the beams of a patch a box may lie, so that they can still tell of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vicinity {
    /// Around the hull of beams that start at many places, and around points without origin, metres.
    pub around: f64,
    /// Radius of the ball that stands for the box where beams start at one place, metres.
    pub radius: f64,
    /// From that place to the ball, metres.
    pub reach: f64,
    /// From the beams' cone to the ball, metres,
    pub beside: f64,
    /// and radians.
    pub beside_angle: f64,
}

/// Header of a patch: fixed size, readable alone.
///
/// A container of sections (`num/sections.rs`), version 3, whose first note holds the flags. The header's content,
/// little-endian: beams u32, returns u32, half-angle f32, spacing f32, range min and max f32, station i64, origin
/// 3×f64, quantum f64, point box 6×f64, hull 6×f64, axis 3×f64. Versions 1 (without attributes) and 2 are read: flags
/// u8 and 0 u8 after the letter, then beams, returns, payload length and CRC-32 u32, half-angle, spacing, range f32,
/// (pad) u32, the rest as now, and the payload.
#[derive(Debug, Clone, PartialEq)]
pub struct PatchHeader {
    /// See the `FLAG_` constants.
    pub flags: u8,
    /// Beams, those without return included.
    pub beams: u32,
    /// Beams with a return.
    pub returns: u32,
    /// Smallest and largest range of a return, metres; `[0, 0]` when there is none.
    pub range: [f32; 2],
    /// How far neighbouring beams are apart; kept in single precision.
    pub spacing: Spacing,
    /// The scanner position's number, as the user keeps it.
    pub station: i64,
    /// Where the beams start, world metres; a reference point where they do not start at one place.
    pub origin: Vec3,
    /// Unit of the packed coordinates, metres; a coordinate is off by at most half of it.
    pub quantum: f64,
    /// Box of the returns, world metres; flat at the origin when there is none.
    pub points: Aabb,
    /// Hull of origin and returns, grown by [`JOIN_MARGIN_M`]: what `&&` compares.
    pub hull: Aabb,
    /// Directions of the beams.
    pub cone: Cone,
}

impl PatchHeader {
    /// Newest layout version that this release reads, and writes.
    pub const VERSION: u8 = 3;
    /// Bytes of its content in the header's section.
    const CONTENT: usize = 184;
    /// Bytes that suffice for [`PatchHeader::read`], whatever the version.
    pub const LEN: usize = header_end(Self::CONTENT);
    /// Bytes of a header of versions 1 and 2.
    const FLAT_LEN: usize = 200;
    /// Some beams have no return.
    pub const FLAG_NO_RETURNS: u8 = 1;
    /// The points have no origin: [`Origins::Unknown`].
    pub const FLAG_NO_ORIGIN: u8 = 2;
    /// An origin for every beam: [`Origins::Each`].
    pub const FLAG_ORIGIN_EACH: u8 = 4;
    /// An intensity for every beam.
    pub const FLAG_INTENSITY: u8 = 8;
    /// A colour for every beam.
    pub const FLAG_COLOUR: u8 = 16;
    /// Flags of version 1; the others make a patch one of version 2.
    const FIRST_FLAGS: u8 = Self::FLAG_NO_RETURNS | Self::FLAG_NO_ORIGIN;
    const KNOWN_FLAGS: u8 = 31;

    /// Where the beams start.
    pub fn origins(&self) -> Origins {
        Self::origins_by(self.flags)
    }

    fn origins_by(flags: u8) -> Origins {
        match flags & (Self::FLAG_NO_ORIGIN | Self::FLAG_ORIGIN_EACH) {
            0 => Origins::One,
            Self::FLAG_ORIGIN_EACH => Origins::Each,
            _ => Origins::Unknown,
        }
    }

    /// The flags of the planes that beams have.
    pub(super) fn flags_of(content: &Beams) -> u8 {
        let flag = |there: bool, flag: u8| if there { flag } else { 0 };
        flag(content.starts.is_some(), Self::FLAG_ORIGIN_EACH)
            | flag(content.intensity.is_some(), Self::FLAG_INTENSITY)
            | flag(content.colour.is_some(), Self::FLAG_COLOUR)
    }

    /// What the beams have in common.
    pub fn setting(&self) -> PatchSpec {
        let (station, origin, quantum) = (self.station, self.origin, self.quantum);
        PatchSpec { origins: self.origins(), station, origin, spacing: self.spacing, quantum }
    }

    /// Whether a beam of the patch can come within `margin` metres of a box: by cone and range, against the ball around
    /// the box. Never says no where one does.
    pub fn sees(&self, bounds: &Aabb, margin: f64) -> bool {
        // Room for rounding: of differences of coordinates, and of the header's single precision.
        let rounding = 1e-6 + 1e-9 * self.origin.amax().max(bounds.centre().amax());
        let grown = 0.5 * bounds.expanded(margin).diagonal() + rounding;
        let returns = if self.returns > 0 { f64::from(self.range[1]) } else { 0.0 };
        let reach = if self.flags & Self::FLAG_NO_RETURNS != 0 { f64::INFINITY } else { returns };
        self.can_tell_of(bounds, &Vicinity { around: margin, radius: grown, reach, beside: 0.0, beside_angle: 1e-7 })
    }

    /// Whether a box lies in the vicinity of the patch's beams: by their hull or their returns where they do not start
    /// at one place, else by cone and range against the ball around the box. Never says no where it does.
    pub fn can_tell_of(&self, bounds: &Aabb, vicinity: &Vicinity) -> bool {
        match self.origins() {
            Origins::One => {
                let centre_scanner = bounds.centre() - self.origin;
                centre_scanner.norm() - vicinity.radius <= vicinity.reach
                    && self.cone.meets_ball(&centre_scanner, vicinity.radius + vicinity.beside, vicinity.beside_angle)
            }
            Origins::Each => self.hull.expanded(vicinity.around).overlaps(bounds),
            Origins::Unknown => self.points.expanded(vicinity.around).overlaps(bounds),
        }
    }

    /// Whether two headers say the same, except for rounding in the last digits of what is computed.
    pub(super) fn agrees_with(&self, o: &Self) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 + 4.0 * f64::EPSILON * b.abs();
        let near_f32 = |a: f64, b: f64| (a - b).abs() <= 2.0 * f64::from(f32::EPSILON) * b.abs();
        let boxes = [(&self.points, &o.points), (&self.hull, &o.hull)];
        let same_boxes =
            boxes.iter().all(|(a, b)| (0..3).all(|i| near(a.min[i], b.min[i]) && near(a.max[i], b.max[i])));
        let exact = |h: &Self| (h.flags, h.beams, h.returns, h.station);
        exact(self) == exact(o)
            && same_boxes
            && (0..2).all(|i| near_f32(f64::from(self.range[i]), f64::from(o.range[i])))
            && (self.cone.axis - o.cone.axis).norm() <= 1e-9
            && near_f32(self.cone.half_angle, o.cone.half_angle)
    }

    pub(super) fn write(&self, out: &mut Vec<u8>) -> Result<()> {
        begin(Self::VERSION, b'P', [self.flags, 0], out);
        put_section(HEADER, out, NEVER, |out| {
            [self.beams, self.returns].iter().for_each(|&v| out.put_u32(v));
            out.put_f32(self.cone.half_angle as f32);
            out.put_f32(self.spacing.number() as f32);
            self.range.iter().for_each(|&v| out.put_f32(v));
            out.put_i64(self.station);
            out.put_vec3(&self.origin);
            out.put_f64(self.quantum);
            for b in [&self.points, &self.hull] {
                b.min.iter().chain(&b.max).for_each(|&c| out.put_f64(c));
            }
            out.put_vec3(&self.cone.axis);
            Ok(())
        })
    }

    /// Reads a header from the first [`PatchHeader::LEN`] bytes (or more) of a patch.
    pub fn read(bytes: &[u8]) -> Result<Self> {
        let mut r = ByteReader::new(bytes.get(..Self::LEN).unwrap_or(bytes), TY);
        let version = r.u8()?;
        if r.u8()? != b'P' {
            return Err(r.bad("it does not start as a scan patch does"));
        }
        if version == 0 || version > Self::VERSION {
            return Err(Error::Version { ty: TY, found: version, known: Self::VERSION });
        }
        let flags = r.u8()?;
        let origins = Self::FLAG_NO_ORIGIN | Self::FLAG_ORIGIN_EACH;
        let known = if version == 1 { Self::FIRST_FLAGS } else { Self::KNOWN_FLAGS };
        if flags & !known != 0 || flags & origins == origins {
            return Err(r.bad(format!("flags {flags:#04x}")));
        }
        if version < 3 {
            r.u8()?;
            Self::read_fields(flags, r, true)
        } else {
            Self::read_fields(flags, sections::header(bytes, TY, NEVER)?, false)
        }
    }

    /// What follows the flags; `is_flat`: with length and checksum of the payload and a pad, as versions 1 and 2 have
    /// them.
    fn read_fields(flags: u8, mut r: ByteReader, is_flat: bool) -> Result<Self> {
        let [beams, returns] = [r.u32()?, r.u32()?];
        r.take(if is_flat { 8 } else { 0 })?;
        let half_angle = f64::from(r.f32()?);
        let spacing = Spacing::of(Self::origins_by(flags), f64::from(r.f32()?));
        let range = [r.f32()?, r.f32()?];
        r.take(if is_flat { 4 } else { 0 })?;
        let station = r.i64()?;
        let origin = r.vec3()?;
        let quantum = r.f64()?;
        let mut aabb = || Ok::<_, Error>(Aabb { min: r.vec3()?.into(), max: r.vec3()?.into() });
        let (points, hull) = (aabb()?, aabb()?);
        let axis = r.vec3()?;
        let cone = Cone { axis, half_angle };
        Ok(Self { flags, beams, returns, range, spacing, station, origin, quantum, points, hull, cone })
    }

    /// Payload of a patch of any version, its checksum checked.
    pub(super) fn payload(bytes: &[u8]) -> Result<&[u8]> {
        if bytes.first() == Some(&Self::VERSION) {
            return sections::read(bytes, TY, [HEADER, BODY], NEVER).map(|[_, body]| body);
        }
        let mut r = ByteReader::new(bytes, TY);
        r.take(12)?;
        let [len, checksum] = [r.u32()?, r.u32()?];
        let payload = bytes.get(Self::FLAT_LEN..).unwrap_or_default();
        if payload.len() != len as usize {
            let reason = format!("{} bytes of payload, but the header announces {len}", payload.len());
            return Err(r.bad(reason));
        }
        if crc32fast::hash(payload) == checksum { Ok(payload) } else { Err(r.bad("the checksum does not match")) }
    }
}
