//! Patches from rows that arrive one by one: the state of SQL's `ab_scan_agg`.

use super::beam::Beam;
use super::beams::Beams;
use super::origins::Origins;
use super::patch::Patch;
use super::patch_spec::PatchSpec;
use crate::error::{Error, Limited, Result};
use crate::geometry::{Vec3, check_coordinates};
use crate::num::bytes::{ByteReader, Put};
use crate::{Grow, Interrupt, room};

/// Most rows of one state: they are in memory, about 60 bytes each.
pub const MAX_ROWS: usize = 10_000_000;

const TY: &str = "a group of returns";

/// One return.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Return {
    /// World metres.
    pub point: Vec3,
    /// Where its beam started, world metres, if known.
    pub origin: Option<Vec3>,
    /// As the sensor gave it.
    pub intensity: Option<u16>,
    /// Red, green, blue.
    pub colour: Option<[u8; 3]>,
}

/// Returns of one station, gathered.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PatchBuilder {
    station: i64,
    /// Whether origins are known; `None` before the first row.
    has_rays: Option<bool>,
    /// The first origin, or a place near the first point.
    reference: Vec3,
    content: Beams,
}

impl PatchBuilder {
    /// Adds a row. A second origin makes the rows those of a moving platform; a second station is an error.
    pub fn push(&mut self, station: i64, r: &Return, interrupt: Interrupt) -> Result<()> {
        check_coordinates("a scan coordinate", r.point.iter().chain(r.origin.iter().flatten()))?;
        if self.has_rays.is_none() {
            let reference = r.origin.unwrap_or_else(|| r.point.map(f64::round));
            *self = Self { station, has_rays: Some(r.origin.is_some()), reference, content: Beams::default() };
            self.content.intensity = r.intensity.map(|_| Vec::new());
            self.content.colour = r.colour.map(|_| Vec::new());
        }
        self.agree(station, r.origin.is_some())?;
        self.check_size(1)?;
        let start = r.origin.map_or_else(Vec3::zeros, |o| o - self.reference);
        if start != Vec3::zeros() {
            self.move_from_here();
        }
        self.make_room(interrupt)?;
        self.content.beams.push(Beam { offset: r.point - self.reference - start, returned: true });
        self.content.starts.iter_mut().for_each(|s| s.push(start));
        self.content.intensity.iter_mut().for_each(|p| p.push(r.intensity.unwrap_or_default()));
        self.content.colour.iter_mut().for_each(|p| p.push(r.colour.unwrap_or_default()));
        Ok(())
    }

    fn make_room(&mut self, interrupt: Interrupt) -> Result<()> {
        let c = &mut self.content;
        c.beams.grow(1, interrupt)?;
        c.starts.iter_mut().try_for_each(|s| s.grow(1, interrupt))?;
        c.intensity.iter_mut().try_for_each(|p| p.grow(1, interrupt))?;
        c.colour.iter_mut().try_for_each(|p| p.grow(1, interrupt))
    }

    /// Appends the rows of another.
    pub fn merge(&mut self, other: &Self, interrupt: Interrupt) -> Result<()> {
        room::<[Return; 1]>(other.content.len(), interrupt)?;
        let Some(has_rays) = other.has_rays else { return Ok(()) };
        if self.has_rays.is_none() {
            *self = other.clone();
            return Ok(());
        }
        self.agree(other.station, has_rays)?;
        self.check_size(other.content.len())?;
        let shift = other.reference - self.reference;
        let mut theirs = other.clone();
        if has_rays && (shift != Vec3::zeros() || theirs.content.starts.is_some() || self.content.starts.is_some()) {
            self.move_from_here();
            theirs.move_from_here();
            theirs.content.starts.iter_mut().flatten().for_each(|s| *s += shift);
        } else {
            theirs.content.beams.iter_mut().for_each(|b| b.offset += shift);
        }
        self.content.append(theirs.content, interrupt)
    }

    /// Gives every row an origin of its own.
    fn move_from_here(&mut self) {
        let n = self.content.len();
        self.content.starts.get_or_insert_with(|| vec![Vec3::zeros(); n]);
    }

    fn agree(&self, station: i64, has_rays: bool) -> Result<()> {
        if self.station != station {
            return Err(Error::argument("the station", "the same for all rows of a group", "several"));
        }
        match self.has_rays == Some(has_rays) {
            true => Ok(()),
            false => Err(Error::argument("the origin", "known for all rows or none", "mixed")),
        }
    }

    fn check_size(&self, more: usize) -> Result<()> {
        let n = self.content.len() + more;
        if n <= MAX_ROWS {
            return Ok(());
        }
        let (value, limit) = (n.to_string(), MAX_ROWS.to_string());
        Err(Error::Limit { what: Limited::GroupReturns, value, limit })
    }

    fn origins(&self) -> Origins {
        match (self.has_rays, &self.content.starts) {
            (Some(true), None) => Origins::One,
            (Some(true), Some(_)) => Origins::Each,
            _ => Origins::Unknown,
        }
    }

    /// Packed patches of neighbours: by direction from one origin, otherwise by place.
    pub fn patches(&self, interrupt: Interrupt) -> Result<Vec<Patch>> {
        let origins = self.origins();
        let (station, origin, quantum) = (self.station, self.reference, Patch::QUANTUM_M);
        self.content.packed(origins, interrupt, |own| {
            let spacing = own.spacing(origins);
            PatchSpec { origins, station, origin, spacing, quantum }
        })
    }

    /// For another process of this server.
    pub fn to_bytes(&self, interrupt: Interrupt) -> Result<Vec<u8>> {
        let c = &self.content;
        let mut out = Vec::new();
        out.grow(64 + 53 * c.len(), interrupt)?;
        let flags = [self.has_rays.is_some(), self.has_rays == Some(true), c.starts.is_some()];
        flags.iter().chain(&[c.intensity.is_some(), c.colour.is_some()]).for_each(|&f| out.push(f.into()));
        out.put_i64(self.station);
        out.put_vec3(&self.reference);
        out.put_u32(c.len() as u32);
        c.beams.iter().for_each(|b| out.put_vec3(&b.offset));
        c.starts.iter().flatten().for_each(|s| out.put_vec3(s));
        c.intensity.iter().flatten().for_each(|v| out.put(&v.to_le_bytes()));
        c.colour.iter().flatten().for_each(|v| out.put(v));
        Ok(out)
    }

    /// The mirror of [`PatchBuilder::to_bytes`].
    pub fn from_bytes(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let mut r = ByteReader::new(bytes, TY);
        let [some, rays, starts, intensity, colour] = [r.u8()?, r.u8()?, r.u8()?, r.u8()?, r.u8()?].map(|f| f != 0);
        let (station, reference, n) = (r.i64()?, r.vec3()?, r.u32()? as usize);
        if n > MAX_ROWS {
            return Err(r.bad(format!("{n} rows")));
        }
        room::<[Return; 2]>(n, interrupt)?;
        let mut vectors = || (0..n).map(|_| r.vec3()).collect::<Result<Vec<Vec3>>>();
        let beams = vectors()?.into_iter().map(|offset| Beam { offset, returned: true }).collect();
        let starts = starts.then(vectors).transpose()?;
        let intensity = if intensity { Some(r.take(2 * n)?.as_chunks::<2>().0) } else { None };
        let colour = if colour { Some(r.take(3 * n)?.as_chunks::<3>().0.to_vec()) } else { None };
        r.finish()?;
        let intensity = intensity.map(|p| p.iter().map(|b| u16::from_le_bytes(*b)).collect());
        Ok(Self {
            station,
            has_rays: some.then_some(rays),
            reference,
            content: Beams { beams, starts, intensity, colour },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use proptest::prelude::*;

    /// Rows of a station: `kind` 0 has no origin, 1 has one, 2 has many.
    fn rows(kind: u8, n: usize) -> Vec<Return> {
        let one = |i: usize| {
            let (u, v) = ((i % 70) as f64 * 0.01, (i / 70) as f64 * 0.01);
            let origin = Vec3::new(6e5, 5.3e6 + if kind == 2 { 0.001 * i as f64 } else { 0.0 }, 500.0);
            Return {
                point: Vec3::new(6e5 + 4.0, 5.3e6 + u, 500.0 + v),
                origin: (kind > 0).then_some(origin),
                intensity: Some(i as u16),
                colour: Some([i as u8, 7, 9]),
            }
        };
        (0..n).map(one).collect()
    }

    fn gathered(rows: &[Return]) -> PatchBuilder {
        let mut g = PatchBuilder::default();
        rows.iter().for_each(|r| g.push(3, r, NEVER).unwrap());
        PatchBuilder::from_bytes(&g.to_bytes(NEVER).unwrap(), NEVER).unwrap()
    }

    proptest! {
        #[test]
        fn parts_merge_to_the_whole(kind in 0u8..3, n in 0usize..9000, at in 0usize..9000) {
            let rows = rows(kind, n);
            let (a, b) = rows.split_at(at.min(n));
            let mut merged = gathered(a);
            merged.merge(&gathered(b), NEVER).unwrap();
            let patches = merged.patches(NEVER).unwrap();
            let mut back: Vec<(u16, [u8; 3], Vec3, Option<Vec3>)> = Vec::new();
            for patch in &patches {
                let (h, c) = Patch::content_of(&patch.to_bytes()).unwrap();
                prop_assert_eq!((h.station, h.origins()), (3, merged.origins()));
                for i in 0..c.len() {
                    let start = (kind > 0).then(|| h.origin + c.start(i));
                    let (intensity, colour) = (c.intensity.as_ref().unwrap()[i], c.colour.as_ref().unwrap()[i]);
                    back.push((intensity, colour, h.origin + c.end(i), start));
                }
            }
            back.sort_by_key(|r| r.0);
            prop_assert_eq!(back.len(), n);
            for (row, (intensity, colour, point, start)) in rows.iter().zip(back) {
                prop_assert_eq!((row.intensity, row.colour), (Some(intensity), Some(colour)));
                prop_assert!((row.point - point).amax() <= 0.5e-4 + 2e-9);
                prop_assert!(start.is_none_or(|s| (s - row.origin.unwrap()).amax() <= 0.5e-4 + 2e-9));
            }
        }

        #[test]
        fn damaged_states_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
            let _ = PatchBuilder::from_bytes(&bytes, NEVER);
        }
    }

    #[test]
    fn what_does_not_belong_together() {
        let mut g = gathered(&rows(1, 5));
        assert!(g.push(4, &rows(1, 1)[0], NEVER).is_err());
        assert!(g.push(3, &rows(0, 1)[0], NEVER).is_err());
        assert!(g.push(3, &Return { point: Vec3::repeat(f64::NAN), ..rows(1, 1)[0] }, NEVER).is_err());
        assert!(g.merge(&gathered(&rows(0, 5)), NEVER).is_err());
        assert_eq!(g, gathered(&rows(1, 5)));
    }
}
