//! A packed angular tile of beams: SQL's `ab_scan`.

use super::beam::{Beam, MAX_BEAMS};
use super::beams::Beams;
use super::encode::{NO_LEAD, check, describe, encode};
use super::header::{PatchHeader, TY};
use super::origins::Origins;
use super::patch_spec::PatchSpec;
use super::spacing::Spacing;
use super::{bitpack, planes};
use crate::NEVER;
use crate::error::{Error, Result};
use crate::geometry::Vec3;
use crate::num::bytes::ByteReader;
use crate::num::sections::{BODY, put_section};

/// A tile of beams, packed. See [`PatchHeader`] for the layout; the payload holds a bitmap of returns (only with
/// [`PatchHeader::FLAG_NO_RETURNS`]), the leading axis u8 (3: none), the three columns of quantised offsets, the
/// leading one first, and the optional attributes in the order of their flags.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    header: PatchHeader,
    payload: Vec<u8>,
}

impl Patch {
    /// Default unit of the packed coordinates: 0.1 mm, so at most 0.05 mm off per axis.
    pub const QUANTUM_M: f64 = 1e-4;

    /// Packs beams with their attributes. Coordinates of returns are kept to half a quantum per axis.
    pub fn pack(setting: &PatchSpec, content: &Beams) -> Result<Self> {
        let (header, payload) = encode(setting, content)?;
        Ok(Self { header, payload })
    }

    /// Packs beams that start at `origin`; `step` is the angle between neighbours, radians.
    pub fn encode(station: i64, origin: Vec3, step: f64, quantum: f64, beams: &[Beam]) -> Result<Self> {
        let spacing = Spacing::Angle(step);
        let setting = PatchSpec { origins: Origins::One, station, origin, spacing, quantum };
        Self::pack(&setting, &Beams::of(beams.to_vec()))
    }

    /// The header.
    pub fn header(&self) -> &PatchHeader {
        &self.header
    }

    /// The stored and transmitted form.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(PatchHeader::LEN + 12 + self.payload.len());
        let written = self.header.write(&mut out).and_then(|()| {
            put_section(BODY, &mut out, NEVER, |out| {
                out.extend_from_slice(&self.payload);
                Ok(())
            })
        });
        debug_assert!(written.is_ok(), "a patch of at most {MAX_BEAMS} beams takes some hundred kilobytes");
        out
    }

    /// The beams in bytes that this database wrote, without intensity and colour: checksum and structure are checked,
    /// the header is taken as it is.
    pub fn beams_of(bytes: &[u8]) -> Result<(PatchHeader, Beams)> {
        read(bytes, false)
    }

    /// The same with all attributes.
    pub fn content_of(bytes: &[u8]) -> Result<(PatchHeader, Beams)> {
        read(bytes, true)
    }

    /// Reads bytes from outside: the header must describe the beams, up to the rounding of other machines.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        let (header, content) = Self::content_of(bytes)?;
        let payload = PatchHeader::payload(bytes)?.to_vec();
        let setting = header.setting();
        check(&setting, &content)?;
        if !header.agrees_with(&describe(header.flags, &setting, &content)?) {
            return Err(Error::binary(TY, "its header does not describe its beams"));
        }
        Ok(Self { header, payload })
    }
}

fn read(bytes: &[u8], all_planes: bool) -> Result<(PatchHeader, Beams)> {
    let header = PatchHeader::read(bytes)?;
    let content =
        PatchHeader::payload(bytes).and_then(|payload| decode(&header, payload, all_planes)).map_err(|e| match e {
            Error::Binary { reason, .. } => Error::corrupted(TY, reason),
            other => other,
        })?;
    Ok((header, content))
}

fn decode(header: &PatchHeader, payload: &[u8], all_planes: bool) -> Result<Beams> {
    let n = header.beams as usize;
    if n == 0 || n > MAX_BEAMS {
        return Err(Error::binary(TY, format!("{n} beams, but a patch holds 1 to {MAX_BEAMS}")));
    }
    let mut r = ByteReader::new(payload, TY);
    let bitmap = if header.flags & PatchHeader::FLAG_NO_RETURNS != 0 { Some(r.take(n.div_ceil(8))?) } else { None };
    let returned = |i: usize| bitmap.is_none_or(|b| b[i / 8] >> (i % 8) & 1 == 1);
    let lead = r.u8()?;
    let offsets = columns(&mut r, n, lead)?;
    let beam = |i: usize| Beam { offset: metres(&offsets, i, header.quantum), returned: returned(i) };
    let mut content = Beams::of((0..n).map(beam).collect());
    if header.origins() == Origins::Each {
        let starts = columns(&mut r, n, NO_LEAD)?;
        content.starts = Some((0..n).map(|i| metres(&starts, i, header.quantum)).collect());
    }
    if all_planes || header.flags & (PatchHeader::FLAG_INTENSITY | PatchHeader::FLAG_COLOUR) == 0 {
        planes::unpack(&mut r, header.flags, &mut content)?;
        r.finish()?;
    }
    Ok(content)
}

/// The next three columns, of which `lead` comes first, by axis.
fn columns(r: &mut ByteReader, n: usize, lead: u8) -> Result<[Vec<i32>; 3]> {
    if lead > NO_LEAD {
        return Err(r.bad(format!("axis {lead} leads")));
    }
    let leading = if lead == NO_LEAD { None } else { Some(bitpack::unpack(r, n, None)?) };
    let mut columns: [Vec<i32>; 3] = Default::default();
    for axis in (0..3u8).filter(|&axis| axis != lead) {
        columns[usize::from(axis)] = bitpack::unpack(r, n, leading.as_deref())?;
    }
    if let Some(leading) = leading {
        columns[usize::from(lead)] = leading;
    }
    Ok(columns)
}

fn metres(quanta: &[Vec<i32>; 3], i: usize, quantum: f64) -> Vec3 {
    Vec3::from_fn(|axis, _| f64::from(quanta[axis][i]) * quantum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_beam() -> impl Strategy<Value = Beam> {
        let near = (0.5..100.0f64, -1.0..1.0f64, -1.0..1.0f64);
        (near, prop::bool::weighted(0.9))
            .prop_map(|((x, y, z), returned)| Beam { offset: Vec3::new(x, x * y, x * z), returned })
    }

    proptest! {
        #[test]
        fn beams_are_kept_to_half_a_quantum(beams in prop::collection::vec(any_beam(), 1..300)) {
            let p = Patch::encode(7, Vec3::new(6e5, 5.3e6, 500.0), 1e-3, Patch::QUANTUM_M, &beams);
            prop_assume!(p.is_ok());
            let bytes = p.clone().unwrap().to_bytes();
            prop_assert_eq!(Patch::from_bytes(&bytes).unwrap(), p.unwrap());
            let (header, back) = Patch::beams_of(&bytes).unwrap();
            prop_assert_eq!(header.beams as usize, beams.len());
            for (a, b) in beams.iter().zip(&back.beams) {
                prop_assert_eq!(a.returned, b.returned);
                if a.returned {
                    prop_assert!((a.offset - b.offset).amax() <= 0.5 * Patch::QUANTUM_M + 1e-12);
                    let world = b.offset + header.origin;
                    prop_assert!((0..3).all(|i| header.points.min[i] <= world[i] && world[i] <= header.points.max[i]));
                } else {
                    prop_assert!((a.offset.normalize() - b.offset.normalize()).norm() < 1e-5);
                }
                let r = b.offset.norm();
                prop_assert!(!b.returned || (r >= f64::from(header.range[0]) && r <= f64::from(header.range[1])));
            }
        }

        #[test]
        fn damage_is_noticed(at in 0usize..10_000, x in 1u8.., cut in 0usize..3) {
            let offset = |i: i32| Vec3::new(5.0, 0.01 * f64::from(i), 0.3);
            let beams: Vec<Beam> = (0..500).map(|i| Beam { offset: offset(i), returned: i % 50 != 0 }).collect();
            let good = Patch::encode(1, Vec3::zeros(), 2e-3, 1e-4, &beams).unwrap().to_bytes();
            let mut bytes = good.clone();
            let n = bytes.len();
            bytes[at % n] ^= x;
            bytes.truncate(n - cut);
            prop_assert!(Patch::from_bytes(&bytes).is_err() && Patch::content_of(&bytes).is_err());
            // The header alone tells of damage to itself.
            let header = PatchHeader::read(&bytes[..PatchHeader::LEN]);
            prop_assert!(at % n >= PatchHeader::LEN || cut > 0 || header.is_err());
        }
    }

    type Reading = ((f64, f64, f64), (f64, f64, f64), u16, [u8; 3], bool);

    fn any_reading() -> impl Strategy<Value = Reading> {
        let place = || (-50.0..50.0f64, -50.0..50.0f64, -3.0..3.0f64);
        (place(), place(), any::<u16>(), any::<[u8; 3]>(), prop::bool::weighted(0.9))
    }

    proptest! {
        /// Ends of moving beams are kept as precisely as those of one origin, and attributes to the bit.
        #[test]
        fn planes_round_trip(
            readings in prop::collection::vec(any_reading(), 1..300),
            intensity: bool,
            colour: bool,
            at in any::<usize>(),
            x in 1u8..,
        ) {
            let vec = |(x, y, z): (f64, f64, f64)| Vec3::new(x, y, z);
            let content = Beams {
                starts: Some(readings.iter().map(|r| vec(r.0)).collect()),
                intensity: intensity.then(|| readings.iter().map(|r| r.2).collect()),
                colour: colour.then(|| readings.iter().map(|r| r.3).collect()),
                ..Beams::of(readings.iter().map(|r| Beam { offset: vec(r.1), returned: r.4 }).collect())
            };
            let origin = Vec3::new(6e6, 6e6, 0.0);
            let spacing = Spacing::Angle(1e-3);
            let setting = PatchSpec { origins: Origins::Each, station: -3, origin, spacing, quantum: 1e-4 };
            let patch = Patch::pack(&setting, &content).unwrap();
            let bytes = patch.to_bytes();
            prop_assert_eq!(&Patch::from_bytes(&bytes).unwrap(), &patch);
            let (header, back) = Patch::content_of(&bytes).unwrap();
            prop_assert_eq!(header.setting(), PatchSpec { spacing: Spacing::Angle(f64::from(1e-3f32)), ..setting });
            prop_assert_eq!((&back.intensity, &back.colour), (&content.intensity, &content.colour));
            for i in 0..content.len() {
                prop_assert_eq!(content.beams[i].returned, back.beams[i].returned);
                prop_assert!((content.start(i) - back.start(i)).amax() <= 0.5e-4 + 1e-12);
                let off = (content.end(i) - back.end(i)).amax();
                prop_assert!(!content.beams[i].returned || off <= 0.5e-4 + 1e-12, "{}", off);
                prop_assert!(!content.beams[i].returned || header.hull.holds(&(origin + back.end(i))));
                prop_assert!(header.hull.holds(&(origin + back.start(i))));
            }
            // A changed payload is damage, whatever the plane.
            let mut damaged = bytes.clone();
            let place = PatchHeader::LEN + at % (bytes.len() - PatchHeader::LEN);
            damaged[place] ^= x;
            let noticed = matches!(Patch::beams_of(&damaged), Err(Error::Corrupted { .. }));
            prop_assert!(noticed);
        }

        /// Even where the checksum is right, a nonsensical payload gives an error or beams, and takes no memory beyond
        /// them.
        #[test]
        fn nonsense_under_a_right_checksum(
            payload in prop::collection::vec(any::<u8>(), 0..600),
            flags in 0u8..32,
            n in 1u32..5000,
        ) {
            let beams = [Beam { offset: Vec3::new(5.0, 0.0, 0.3), returned: true }];
            let mut header = Patch::encode(1, Vec3::zeros(), 2e-3, 1e-4, &beams).unwrap().header().clone();
            (header.flags, header.beams) = (flags, n);
            let bytes = Patch { header, payload }.to_bytes();
            if let Ok((_, content)) = Patch::content_of(&bytes) {
                prop_assert!(content.len() == n as usize);
            }
            let _ = Patch::from_bytes(&bytes);
        }
    }

    /// Whoever forges a checksum still cannot make a header claim other boxes than its beams have; station and step are
    /// taken as stated.
    #[test]
    fn forged_headers_are_refused() {
        let beams: Vec<Beam> =
            (0..50).map(|i| Beam { offset: Vec3::new(5.0, 0.01 * f64::from(i), 0.3), returned: true }).collect();
        let good = Patch::encode(1, Vec3::zeros(), 2e-3, 1e-4, &beams).unwrap();
        let forged = |forge: &dyn Fn(&mut PatchHeader)| {
            let mut patch = good.clone();
            forge(&mut patch.header);
            Patch::from_bytes(&patch.to_bytes())
        };
        for forge in [
            &(|h: &mut PatchHeader| h.returns -= 1) as &dyn Fn(&mut PatchHeader),
            &|h| h.points.max[0] += 1e-3,
            &|h| h.hull.min[2] -= 1e-3,
            &|h| h.range[1] *= 1.01,
            &|h| h.cone.half_angle *= 1.01,
            &|h| h.origin.x += 1e-3,
        ] {
            assert!(forged(forge).is_err());
        }
        assert!(forged(&|h| (h.station, h.spacing) = (7, Spacing::Angle(3e-3))).is_ok());
    }

    #[test]
    fn planes_fit_their_beams() {
        let one = Beam { offset: Vec3::x(), returned: true };
        let (origin, spacing) = (Vec3::zeros(), Spacing::Angle(1e-3));
        let setting = PatchSpec { origins: Origins::One, station: 0, origin, spacing, quantum: 1e-4 };
        let content = Beams { intensity: Some(vec![1, 2]), ..Beams::of(vec![one]) };
        assert!(Patch::pack(&setting, &content).is_err());
        let points = PatchSpec { origins: Origins::Unknown, ..setting };
        assert!(Patch::pack(&points, &Beams::of(vec![one])).is_err(), "an angle between points without origin");
        assert!(Patch::pack(&PatchSpec { spacing: Spacing::Distance(0.01), ..points }, &Beams::of(vec![one])).is_ok());
        // Starts and the kind of origin belong together.
        assert!(Patch::pack(&PatchSpec { origins: Origins::Each, ..setting }, &Beams::of(vec![one])).is_err());
        let content = Beams { starts: Some(vec![Vec3::zeros()]), ..Beams::of(vec![one]) };
        assert!(Patch::pack(&setting, &content).is_err());
    }

    #[test]
    fn edge_cases() {
        let beam = |x: f64| Beam { offset: Vec3::new(x, 0.0, 0.0), returned: true };
        let encode = |b: &[Beam]| Patch::encode(0, Vec3::zeros(), 1e-3, 1e-4, b);
        assert!(matches!(encode(&[]), Err(Error::Empty { .. })));
        assert!(encode(&[beam(f64::NAN)]).is_err());
        assert!(matches!(encode(&[beam(1e6)]), Err(Error::Limit { .. })));
        assert!(encode(&vec![beam(1.0); MAX_BEAMS + 1]).is_err());
        let far = encode(&[beam(0.0), beam(10_000.0)]).unwrap();
        assert_eq!(far.header().range, [0.0, 10_000.0]);
        let same = encode(&[beam(3.0); MAX_BEAMS]).unwrap();
        assert!(same.to_bytes().len() < 1250 && same.header().cone.half_angle == 0.0);
        assert_eq!(Patch::beams_of(&same.to_bytes()).unwrap().1.beams, [beam(3.0); MAX_BEAMS]);
        assert!(matches!(encode(&[beam(1.0), beam(-1.0)]), Err(Error::Limit { .. })));
        let nothing = Beam { offset: Vec3::new(0.0, 1.0, 0.0), returned: false };
        let p = encode(&[nothing]).unwrap();
        assert_eq!((p.header().beams, p.header().returns), (1, 0));
        let mut newer = p.to_bytes();
        newer[0] = PatchHeader::VERSION + 1;
        assert!(matches!(Patch::from_bytes(&newer), Err(Error::Version { .. })));
    }
}
