//! From beams to the header and payload of a patch.

use super::beam::{Beam, MAX_BEAMS};
use super::beams::Beams;
use super::cone::Cone;
use super::header::{JOIN_MARGIN_M, NO_RETURN_REACH_M, PatchHeader};
use super::origins::Origins;
use super::patch_spec::PatchSpec;
use super::spacing::Spacing;
use super::{bitpack, planes};
use crate::error::{Error, Limited, Result};
use crate::geometry::{Aabb, Vec3, check_coordinates};

/// A beam without return is stored as its direction, this long: fine enough to keep the direction to 5 µrad.
const NO_RETURN_LENGTH_M: f64 = 20.0;
/// Beams of one origin must point into one half-space: wider tiles have no useful angular grid.
const MAX_HALF_ANGLE: f64 = 1.3;
/// No axis leads: the points were not seen along beams.
pub const NO_LEAD: u8 = 3;

/// Coordinates of a patch in quanta.
struct Quanta {
    offsets: Vec<[i32; 3]>,
    starts: Option<Vec<[i32; 3]>>,
}

/// Header and payload.
pub fn encode(setting: &PatchSpec, content: &Beams) -> Result<(PatchHeader, Vec<u8>)> {
    check(setting, content)?;
    let quanta = quantise(content, setting.quantum)?;
    let all_returned = content.beams.iter().all(|b| b.returned);
    let mut payload = Vec::with_capacity(4 * content.len());
    if !all_returned {
        for eight in content.beams.chunks(8) {
            payload.push(eight.iter().enumerate().map(|(i, b)| u8::from(b.returned) << i).sum());
        }
    }
    let lead = if setting.origins == Origins::Unknown { NO_LEAD } else { leading_axis(&quanta.offsets) };
    payload.push(lead);
    pack_columns(&quanta.offsets, lead, &mut payload);
    if let Some(starts) = &quanta.starts {
        pack_columns(starts, NO_LEAD, &mut payload);
    }
    planes::pack(content, &mut payload);
    let no_origin = if setting.origins == Origins::Unknown { PatchHeader::FLAG_NO_ORIGIN } else { 0 };
    let no_returns = if all_returned { 0 } else { PatchHeader::FLAG_NO_RETURNS };
    let flags = PatchHeader::flags_of(content) | no_origin | no_returns;
    let header = describe(flags, setting, &quanta.restored(content, setting.quantum))?;
    Ok((header, payload))
}

fn pack_columns(quanta: &[[i32; 3]], lead: u8, out: &mut Vec<u8>) {
    let column = |axis: u8| quanta.iter().map(|q| q[usize::from(axis)]).collect::<Vec<i32>>();
    let leading = (lead != NO_LEAD).then(|| column(lead));
    if let Some(leading) = &leading {
        bitpack::pack(leading, None, out);
    }
    for axis in (0..3).filter(|&axis| axis != lead) {
        bitpack::pack(&column(axis), leading.as_deref(), out);
    }
}

/// The axis along which the beams reach farthest; noise along the beams shows there, and the other two follow.
fn leading_axis(quanta: &[[i32; 3]]) -> u8 {
    let reach = |axis: usize| quanta.iter().map(|q| i64::from(q[axis]).abs()).sum::<i64>();
    (0..3u8).max_by_key(|&axis| reach(usize::from(axis))).unwrap_or(0)
}

/// Fails where there are more beams than a patch holds.
pub fn check_count(n: usize) -> Result<()> {
    if n <= MAX_BEAMS {
        return Ok(());
    }
    let (value, limit) = (n.to_string(), MAX_BEAMS.to_string());
    Err(Error::Limit { what: Limited::PatchBeams, value, limit })
}

/// Fails where beams and setting cannot be those of a patch.
pub fn check(setting: &PatchSpec, content: &Beams) -> Result<()> {
    let n = content.len();
    if n == 0 {
        return Err(Error::Empty { what: "the scan patch" });
    }
    check_count(n)?;
    let step = setting.spacing.number();
    if !(1e-7..=1e3).contains(&step) {
        return Err(Error::argument("the step", "between 1e-7 and 1000", step));
    }
    if setting.spacing != Spacing::of(setting.origins, step) {
        return Err(Error::argument("the step", "an angle, for points without origin a distance", "the other"));
    }
    if !(1e-9..=1.0).contains(&setting.quantum) {
        return Err(Error::argument("the quantum", "between 1e-9 and 1 m", setting.quantum));
    }
    if content.starts.is_some() != (setting.origins == Origins::Each) {
        return Err(Error::argument(
            "an origin for every beam",
            "given for a moving platform, and only there",
            "not so",
        ));
    }
    one_a_beam("the origins", content.starts.as_ref().map(Vec::len), n)?;
    one_a_beam("the intensities", content.intensity.as_ref().map(Vec::len), n)?;
    one_a_beam("the colours", content.colour.as_ref().map(Vec::len), n)?;
    let starts = content.starts.iter().flatten().flat_map(|s| s.iter());
    let offsets = content.beams.iter().flat_map(|b| b.offset.iter());
    check_coordinates("a scan coordinate", setting.origin.iter().chain(offsets).chain(starts))
}

fn one_a_beam(what: &'static str, given: Option<usize>, beams: usize) -> Result<()> {
    match given {
        Some(n) if n != beams => Err(Error::argument(what, "one for every point", format!("{n} for {beams} points"))),
        _ => Ok(()),
    }
}

fn quantise(content: &Beams, quantum: f64) -> Result<Quanta> {
    let starts = content.starts.as_ref().map(|all| all.iter().map(|s| rounded(s, quantum)).collect::<Result<Vec<_>>>());
    let starts = starts.transpose()?;
    let offset = |(i, b): (usize, &Beam)| {
        if !b.returned {
            let direction = b.offset.try_normalize(1e-12).unwrap_or_else(Vec3::x);
            return rounded(&(direction * NO_RETURN_LENGTH_M), quantum);
        }
        let Some(start) = starts.as_ref().map(|s| s[i]) else { return rounded(&b.offset, quantum) };
        // The end is rounded, not the offset: a return is off by half a quantum wherever its beam starts.
        let end = rounded(&content.end(i), quantum)?;
        match [0, 1, 2].map(|k| end[k].checked_sub(start[k])) {
            [Some(x), Some(y), Some(z)] => Ok([x, y, z]),
            _ => Err(too_far(&b.offset, quantum)),
        }
    };
    let offsets = content.beams.iter().enumerate().map(offset).collect::<Result<_>>()?;
    Ok(Quanta { offsets, starts })
}

fn rounded(v: &Vec3, quantum: f64) -> Result<[i32; 3]> {
    let q = v.map(|c| (c / quantum).round());
    if q.amax() > f64::from(i32::MAX) { Err(too_far(v, quantum)) } else { Ok(q.map(|c| c as i32).into()) }
}

fn too_far(v: &Vec3, quantum: f64) -> Error {
    Error::Limit {
        what: Limited::Offset,
        value: format!("{} m", v.amax()),
        limit: format!("{} m at a quantum of {quantum} m", f64::from(i32::MAX) * quantum),
    }
}

impl Quanta {
    /// The beams as a reader will see them.
    fn restored(&self, content: &Beams, quantum: f64) -> Beams {
        let metres = |q: &[i32; 3]| Vec3::from(q.map(f64::from)) * quantum;
        let beam = |(q, b): (&[i32; 3], &Beam)| Beam { offset: metres(q), returned: b.returned };
        let beams = self.offsets.iter().zip(&content.beams).map(beam).collect();
        Beams { starts: self.starts.as_ref().map(|s| s.iter().map(metres).collect()), ..Beams::of(beams) }
    }
}

/// The header of beams as a reader sees them.
pub fn describe(flags: u8, setting: &PatchSpec, content: &Beams) -> Result<PatchHeader> {
    let PatchSpec { origins, station, origin, spacing, quantum } = *setting;
    let returned = || (0..content.len()).filter(|&i| content.beams[i].returned);
    let world: Vec<Vec3> = returned().map(|i| origin + content.end(i)).collect();
    let flat = Aabb { min: origin.into(), max: origin.into() };
    let points = if world.is_empty() { flat } else { Aabb::around(&world) };
    let range = returned().map(|i| content.beams[i].offset.norm());
    let range = range.fold([f64::INFINITY, 0.0], |[lo, hi], r| [lo.min(r), hi.max(r)]);
    let range = if world.is_empty() { [0.0, 0.0] } else { [round_down(range[0]), round_up(range[1])] };
    let cone = if origins == Origins::One { cone(&content.beams)? } else { Cone::EVERYWHERE };
    Ok(PatchHeader {
        flags,
        beams: content.len() as u32,
        returns: world.len() as u32,
        range,
        spacing: spacing.stored(),
        station,
        origin,
        quantum,
        points,
        hull: hull(origins, &origin, content, points).expanded(JOIN_MARGIN_M),
        cone,
    })
}

/// The returns, where their beams start, and how far beams without return looked.
fn hull(origins: Origins, origin: &Vec3, content: &Beams, points: Aabb) -> Aabb {
    if origins == Origins::Unknown {
        return points;
    }
    let returned = content.beams.iter().any(|b| b.returned);
    let mut hull = if returned { points } else { Aabb::EMPTY };
    for (i, b) in content.beams.iter().enumerate() {
        let start = origin + content.start(i);
        hull.grow(&start);
        if !b.returned {
            hull.grow(&(start + b.offset * (NO_RETURN_REACH_M / b.offset.norm().max(1e-9))));
        }
    }
    hull
}

fn cone(beams: &[Beam]) -> Result<Cone> {
    let directions: Vec<Vec3> = beams.iter().filter_map(|b| b.offset.try_normalize(1e-12)).collect();
    let mut cone = Cone::around(&directions);
    if cone.half_angle > MAX_HALF_ANGLE {
        let (value, limit) = (format!("{:.2} rad", cone.half_angle), format!("{MAX_HALF_ANGLE} rad"));
        return Err(Error::Limit { what: Limited::ConeAngle, value, limit });
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
