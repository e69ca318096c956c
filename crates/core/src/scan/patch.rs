//! A packed angular tile of beams: SQL's `ab_scan`.

use super::Cone;
use super::bitpack;
use super::header::{Header, JOIN_MARGIN_M, NO_RETURN_REACH_M, TY};
use super::tile::MAX_BEAMS;
use crate::error::{Error, Result};
use crate::geometry::{Aabb, Vec3};
use crate::num::bytes::Reader;

/// One laser beam relative to its origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    /// From the origin to the return, metres; for a beam without return any vector along it.
    pub offset: Vec3,
    /// Whether something came back.
    pub returned: bool,
}

/// A tile of beams from one origin, packed. See [`Header`] for the layout; the payload holds a bitmap of returns
/// (only with [`Header::FLAG_NO_RETURNS`]), the leading axis u8 (3: none), and the three columns of quantised offsets,
/// the leading one first.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    header: Header,
    payload: Vec<u8>,
}

/// A beam without return is stored as its direction, this long: fine enough to keep the direction to 5 µrad.
const NO_RETURN_LENGTH_M: f64 = 20.0;
/// Beams must look into one half-space: wider tiles have no useful angular grid.
const MAX_HALF_ANGLE: f64 = 1.3;

impl Patch {
    /// Default unit of the packed coordinates: 0.1 mm, so at most 0.05 mm off per axis.
    pub const QUANTUM_M: f64 = 1e-4;

    /// Packs beams that start at `origin`; `step` is the angle between neighbours, radians.
    pub fn encode(station: i64, origin: Vec3, step: f64, quantum: f64, beams: &[Beam]) -> Result<Self> {
        Self::pack(0, station, origin, step, quantum, beams)
    }

    /// Packs points that were not seen from one place, relative to `reference`; `spacing` in metres.
    pub fn encode_cloud(station: i64, reference: Vec3, spacing: f64, quantum: f64, points: &[Vec3]) -> Result<Self> {
        let beams: Vec<Beam> = points.iter().map(|p| Beam { offset: p - reference, returned: true }).collect();
        Self::pack(Header::FLAG_NO_ORIGIN, station, reference, spacing, quantum, &beams)
    }

    fn pack(kind: u8, station: i64, origin: Vec3, step: f64, quantum: f64, beams: &[Beam]) -> Result<Self> {
        check(&origin, step, quantum, beams)?;
        let quanta = quantise(beams, quantum)?;
        let all_returned = beams.iter().all(|b| b.returned);
        let mut payload = Vec::with_capacity(4 * beams.len());
        if !all_returned {
            for eight in beams.chunks(8) {
                payload.push(eight.iter().enumerate().map(|(i, b)| u8::from(b.returned) << i).sum());
            }
        }
        let lead = if kind & Header::FLAG_NO_ORIGIN == 0 { leading_axis(&quanta) } else { NO_LEAD };
        payload.push(lead);
        let column = |axis: u8| quanta.iter().map(|q| q[usize::from(axis)]).collect::<Vec<i32>>();
        let leading = (lead != NO_LEAD).then(|| column(lead));
        if let Some(leading) = &leading {
            bitpack::pack(leading, None, &mut payload);
        }
        for axis in (0..3).filter(|&axis| axis != lead) {
            bitpack::pack(&column(axis), leading.as_deref(), &mut payload);
        }
        let flags = kind | if all_returned { 0 } else { Header::FLAG_NO_RETURNS };
        let header = describe(flags, station, origin, step, quantum, &restore(&quanta, beams, quantum), &payload)?;
        Ok(Self { header, payload })
    }

    /// The header.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The stored and transmitted form.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(Header::LEN + self.payload.len());
        self.header.write(&mut out);
        out.extend_from_slice(&self.payload);
        out
    }

    /// Reads bytes that this database wrote: checksum and structure are checked, the header is taken as it is.
    pub fn beams_of(bytes: &[u8]) -> Result<(Header, Vec<Beam>)> {
        let header = Header::read(bytes)?;
        let payload = bytes.get(Header::LEN..).unwrap_or_default();
        let beams = decode(&header, payload).map_err(|e| match e {
            Error::Binary { reason, .. } => Error::corrupted(TY, reason),
            other => other,
        })?;
        Ok((header, beams))
    }

    /// Reads foreign bytes: the header must describe the beams, to the rounding of other machines.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        let (header, beams) = Self::beams_of(bytes)?;
        let payload = bytes[Header::LEN..].to_vec();
        check(&header.origin, f64::from(header.step), header.quantum, &beams)?;
        let derived = describe(
            header.flags,
            header.station,
            header.origin,
            f64::from(header.step),
            header.quantum,
            &beams,
            &payload,
        )?;
        if !header.agrees_with(&derived) {
            return Err(Error::binary(TY, "its header does not describe its beams"));
        }
        Ok(Self { header, payload })
    }
}

/// No axis leads: points that were not seen along beams.
const NO_LEAD: u8 = 3;

/// The axis along which the beams reach farthest; noise along the beams shows there, and the other two follow.
fn leading_axis(quanta: &[[i32; 3]]) -> u8 {
    let reach = |axis: usize| quanta.iter().map(|q| i64::from(q[axis]).abs()).sum::<i64>();
    (0..3u8).max_by_key(|&axis| reach(usize::from(axis))).unwrap_or(0)
}

fn check(origin: &Vec3, step: f64, quantum: f64, beams: &[Beam]) -> Result<()> {
    if beams.is_empty() {
        return Err(Error::Empty { what: "the scan patch" });
    }
    if beams.len() > MAX_BEAMS {
        return Err(Error::Limit {
            what: "the number of beams of a patch",
            value: beams.len().to_string(),
            limit: MAX_BEAMS.to_string(),
        });
    }
    if !(1e-7..=1e3).contains(&step) {
        return Err(Error::argument("the step", "between 1e-7 and 1000", step));
    }
    if !(1e-9..=1.0).contains(&quantum) {
        return Err(Error::argument("the quantum", "between 1e-9 and 1 m", quantum));
    }
    let coordinates = origin.iter().chain(beams.iter().flat_map(|b| b.offset.iter()));
    match coordinates.into_iter().find(|x| !(-1e9..=1e9).contains(*x)) {
        Some(x) => Err(Error::argument("a scan coordinate", "finite and within 1e9 m", x)),
        None => Ok(()),
    }
}

fn quantise(beams: &[Beam], quantum: f64) -> Result<Vec<[i32; 3]>> {
    beams
        .iter()
        .map(|b| {
            let v = if b.returned {
                b.offset
            } else {
                b.offset.try_normalize(1e-12).unwrap_or_else(Vec3::x) * NO_RETURN_LENGTH_M
            };
            let q = v.map(|c| (c / quantum).round());
            if q.amax() > f64::from(i32::MAX) {
                return Err(Error::Limit {
                    what: "the offset of a point from its origin",
                    value: format!("{} m", v.amax()),
                    limit: format!("{} m at a quantum of {quantum} m", f64::from(i32::MAX) * quantum),
                });
            }
            Ok([q.x as i32, q.y as i32, q.z as i32])
        })
        .collect()
}

/// The beams as a reader will see them.
fn restore(quanta: &[[i32; 3]], beams: &[Beam], quantum: f64) -> Vec<Beam> {
    let one =
        |(q, b): (&[i32; 3], &Beam)| Beam { offset: Vec3::from(q.map(f64::from)) * quantum, returned: b.returned };
    quanta.iter().zip(beams).map(one).collect()
}

fn describe(
    flags: u8,
    station: i64,
    origin: Vec3,
    step: f64,
    quantum: f64,
    beams: &[Beam],
    payload: &[u8],
) -> Result<Header> {
    let returns: Vec<Vec3> = beams.iter().filter(|b| b.returned).map(|b| b.offset).collect();
    let world: Vec<Vec3> = returns.iter().map(|p| p + origin).collect();
    let has_origin = flags & Header::FLAG_NO_ORIGIN == 0;
    let mut points = Aabb::around(&world);
    if world.is_empty() {
        points = Aabb { min: origin.into(), max: origin.into() };
    }
    let mut hull = points;
    if has_origin {
        hull.grow(&origin);
        let looked = |b: &Beam| b.offset * (NO_RETURN_REACH_M / b.offset.norm().max(1e-9));
        beams.iter().filter(|b| !b.returned).for_each(|b| hull.grow(&(origin + looked(b))));
    }
    let range = returns.iter().map(|p| p.norm()).fold([f64::INFINITY, 0.0], |[lo, hi], r| [lo.min(r), hi.max(r)]);
    let range = if world.is_empty() { [0.0, 0.0] } else { [round_down(range[0]), round_up(range[1])] };
    let cone = if has_origin { cone(beams)? } else { Cone { axis: Vec3::x(), half_angle: f64::from(4f32) } };
    Ok(Header {
        flags,
        beams: beams.len() as u32,
        returns: returns.len() as u32,
        payload_len: payload.len() as u32,
        checksum: crc32fast::hash(payload),
        range,
        step: step as f32,
        station,
        origin,
        quantum,
        points,
        hull: hull.expanded(JOIN_MARGIN_M),
        cone,
    })
}

fn cone(beams: &[Beam]) -> Result<Cone> {
    let directions: Vec<Vec3> = beams.iter().filter_map(|b| b.offset.try_normalize(1e-12)).collect();
    let mut cone = Cone::around(&directions);
    if cone.half_angle > MAX_HALF_ANGLE {
        return Err(Error::Limit {
            what: "the half-angle of the patch's cone",
            value: format!("{:.2} rad", cone.half_angle),
            limit: format!("{MAX_HALF_ANGLE} rad"),
        });
    }
    cone.half_angle = f64::from(round_up(cone.half_angle));
    Ok(cone)
}

fn round_up(x: f64) -> f32 {
    let f = x as f32;
    if f64::from(f) < x { f.next_up() } else { f }
}

fn round_down(x: f64) -> f32 {
    let f = x as f32;
    if f64::from(f) > x { f.next_down() } else { f }
}

fn decode(header: &Header, payload: &[u8]) -> Result<Vec<Beam>> {
    let n = header.beams as usize;
    if n == 0 || n > MAX_BEAMS {
        return Err(Error::binary(TY, format!("{n} beams, but a patch holds 1 to {MAX_BEAMS}")));
    }
    if payload.len() != header.payload_len as usize {
        let reason = format!("{} bytes of payload, but the header announces {}", payload.len(), header.payload_len);
        return Err(Error::binary(TY, reason));
    }
    if crc32fast::hash(payload) != header.checksum {
        return Err(Error::binary(TY, "the checksum does not match"));
    }
    let mut r = Reader::new(payload, TY);
    let bitmap = if header.flags & Header::FLAG_NO_RETURNS != 0 { Some(r.take(n.div_ceil(8))?) } else { None };
    let columns = columns(&mut r, n)?;
    r.finish()?;
    let q = header.quantum;
    Ok((0..n)
        .map(|i| Beam {
            offset: Vec3::from_fn(|axis, _| f64::from(columns[axis][i]) * q),
            returned: bitmap.is_none_or(|b| b[i / 8] >> (i % 8) & 1 == 1),
        })
        .collect())
}

fn columns(r: &mut Reader, n: usize) -> Result<[Vec<i32>; 3]> {
    let lead = r.u8()?;
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
            for (a, b) in beams.iter().zip(&back) {
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
            let beams: Vec<Beam> = (0..500).map(|i| Beam { offset: Vec3::new(5.0, 0.01 * f64::from(i), 0.3), returned: i % 50 != 0 }).collect();
            let good = Patch::encode(1, Vec3::zeros(), 2e-3, 1e-4, &beams).unwrap().to_bytes();
            let mut bytes = good.clone();
            let n = bytes.len();
            bytes[at % n] ^= x;
            bytes.truncate(n - cut);
            match Patch::from_bytes(&bytes) {
                Ok(p) => prop_assert!(cut == 0 && p.header().beams == 500),
                Err(e) => prop_assert!(!e.to_string().is_empty()),
            }
        }
    }

    #[test]
    fn edge_cases() {
        let beam = |x: f64| Beam { offset: Vec3::new(x, 0.0, 0.0), returned: true };
        let encode = |b: &[Beam]| Patch::encode(0, Vec3::zeros(), 1e-3, 1e-4, b);
        assert!(matches!(encode(&[]), Err(Error::Empty { .. })));
        assert!(encode(&[beam(f64::NAN)]).is_err());
        assert!(matches!(encode(&[beam(1e6)]), Err(Error::Limit { .. })));
        assert!(encode(&vec![beam(1.0); MAX_BEAMS + 1]).is_err());
        assert!(encode(&[beam(0.0), beam(10_000.0)]).is_ok());
        assert!(matches!(encode(&[beam(1.0), beam(-1.0)]), Err(Error::Limit { .. })));
        let nothing = Beam { offset: Vec3::new(0.0, 1.0, 0.0), returned: false };
        let p = encode(&[nothing]).unwrap();
        assert_eq!((p.header().beams, p.header().returns), (1, 0));
        let mut newer = p.to_bytes();
        newer[0] = 2;
        assert!(matches!(Patch::from_bytes(&newer), Err(Error::Version { found: 2, .. })));
    }
}
