//! Patches made from patches: filtered, thinned, moved, joined, cut anew. Beams that are kept keep their coordinates to
//! half a quantum; beams that are dropped leave nothing behind.

use std::collections::HashSet;

use super::beam::MAX_BEAMS;
use super::beams::Beams;
use super::header::PatchHeader;
use super::origins::Origins;
use super::patch::Patch;
use super::patch_spec::PatchSpec;
use crate::error::{Error, Limited, Result};
use crate::geometry::{Aabb, Vec3};
use crate::uncertain::UncertainPose;
use crate::{Interrupt, poll_now_and_then};

/// Most beams cut anew in one call: they are in memory, unpacked.
const MAX_RETILED: usize = 10_000_000;

impl Patch {
    /// The beams, by number, for which `keep` is true; `None` where none is left. Wherever some are kept, all around are:
    /// they stay as far apart.
    pub fn cropped(bytes: &[u8], keep: impl FnMut(&PatchHeader, &Beams, usize) -> bool) -> Result<Option<Self>> {
        let Some((header, content)) = kept(bytes, keep)? else { return Ok(None) };
        Self::pack(&header.setting(), &content).map(Some)
    }

    /// The same where any may be kept: how far apart they are is found anew.
    pub fn filtered(bytes: &[u8], keep: impl FnMut(&PatchHeader, &Beams, usize) -> bool) -> Result<Option<Self>> {
        let Some((header, content)) = kept(bytes, keep)? else { return Ok(None) };
        Self::pack(&spaced(&header, &content), &content).map(Some)
    }

    /// Beams whose return lies in `bounds` (world metres).
    pub fn within(bytes: &[u8], bounds: &Aabb) -> Result<Option<Self>> {
        if !PatchHeader::read(bytes)?.points.overlaps(bounds) {
            return Ok(None);
        }
        Self::cropped(bytes, |h, c, i| c.beams[i].returned && bounds.holds(&(c.end(i) + h.origin)))
    }

    /// Beams whose return is at least `min` and at most `max` metres away.
    pub fn between(bytes: &[u8], min: f64, max: f64) -> Result<Option<Self>> {
        if PatchHeader::read(bytes)?.origins() == Origins::Unknown {
            let expected = "of beams whose origin is known";
            return Err(Error::argument("a filter by range", expected, "of points without origin"));
        }
        Self::cropped(bytes, |_, c, i| c.beams[i].returned && (min..=max).contains(&c.beams[i].offset.norm()))
    }

    /// The first beam of every cube of side `spacing` (metres, lattice of the reference system) that a return lies in,
    /// and every beam without return.
    pub fn thinned(bytes: &[u8], spacing: f64) -> Result<Option<Self>> {
        if !(1e-6..=1e6).contains(&spacing) {
            return Err(Error::argument("the spacing", "from 0.000001 to 1000000 m", spacing));
        }
        let mut taken = HashSet::new();
        Self::filtered(bytes, |h, c, i| {
            let cube: [i64; 3] = (c.end(i) + h.origin).map(|x| (x / spacing).floor() as i64).into();
            !c.beams[i].returned || taken.insert(cube)
        })
    }

    /// The patch seen through a pose; its covariance is not carried.
    pub fn moved(bytes: &[u8], pose: &UncertainPose) -> Result<Self> {
        let (header, mut content) = Self::content_of(bytes)?;
        let linear = pose.matrix() * pose.scale;
        content.beams.iter_mut().for_each(|b| b.offset = linear * b.offset);
        content.starts.iter_mut().flatten().for_each(|s| *s = linear * *s);
        let mut setting = header.setting();
        setting.origin = pose.apply(&header.origin);
        setting.spacing = setting.spacing.scaled(pose.scale);
        Self::pack(&setting, &content)
    }

    /// Patches of one station joined into one.
    pub fn union(patches: &[&[u8]], interrupt: Interrupt) -> Result<Option<Self>> {
        let Some((header, content)) = joined(patches, MAX_BEAMS, interrupt)? else { return Ok(None) };
        Self::pack(&spaced(&header, &content), &content).map(Some)
    }

    /// The beams of many patches of one station, cut anew into tiles of neighbours.
    pub fn retiled(patches: &[&[u8]], interrupt: Interrupt) -> Result<Vec<Self>> {
        let Some((header, content)) = joined(patches, MAX_RETILED, interrupt)? else { return Ok(Vec::new()) };
        content.packed(header.origins(), interrupt, |own| spaced(&header, own))
    }
}

/// The beams of a patch for which `keep` is true; `None` where none is left.
fn kept(
    bytes: &[u8],
    mut keep: impl FnMut(&PatchHeader, &Beams, usize) -> bool,
) -> Result<Option<(PatchHeader, Beams)>> {
    let (header, content) = Patch::content_of(bytes)?;
    let kept: Vec<u32> = (0..content.len() as u32).filter(|&i| keep(&header, &content, i as usize)).collect();
    Ok((!kept.is_empty()).then(|| (header, content.select(&kept))))
}

/// A patch's setting, with these beams as far apart as they are.
fn spaced(header: &PatchHeader, content: &Beams) -> PatchSpec {
    PatchSpec { spacing: content.spacing(header.origins()), ..header.setting() }
}

/// All beams of patches of one station, from the first one's origin, at the finest quantum of all; `None` where there
/// is no patch.
fn joined(patches: &[&[u8]], most: usize, interrupt: Interrupt) -> Result<Option<(PatchHeader, Beams)>> {
    let mut all: Option<(PatchHeader, Beams)> = None;
    for (i, bytes) in patches.iter().enumerate() {
        poll_now_and_then(i, interrupt)?;
        let (header, mut content) = Patch::content_of(bytes)?;
        let Some((first, joint)) = &mut all else {
            all = Some((header, content));
            continue;
        };
        let shift = header.origin - first.origin;
        let one_origin = first.origins() == Origins::One;
        if (first.station, first.origins()) != (header.station, header.origins())
            || (one_origin && shift != Vec3::zeros())
        {
            return Err(Error::argument("the patches of a union", "of one station and origin", "of several"));
        }
        first.quantum = first.quantum.min(header.quantum);
        match &mut content.starts {
            Some(starts) => starts.iter_mut().for_each(|s| *s += shift),
            None => content.beams.iter_mut().for_each(|b| b.offset += shift),
        }
        if joint.len() + content.len() > most {
            let value = format!("at least {}", joint.len() + content.len());
            return Err(Error::Limit { what: Limited::UnionBeams, value, limit: most.to_string() });
        }
        joint.append(content, interrupt)?;
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::scan::Beam;
    use nalgebra::UnitQuaternion;
    use proptest::prelude::*;

    fn patch() -> Vec<u8> {
        let beam = |i: i32| {
            let (u, v) = (f64::from(i % 40) * 0.01 - 0.2, f64::from(i / 40) * 0.01 - 0.2);
            Beam { offset: Vec3::new(1.0, u, v) * (4.0 + 0.05 * f64::from(i % 7)), returned: i % 50 != 0 }
        };
        let beams: Vec<Beam> = (0..1600).map(beam).collect();
        Patch::encode(3, Vec3::new(6e5, 5.3e6, 500.0), 0.01, Patch::QUANTUM_M, &beams).unwrap().to_bytes()
    }

    #[test]
    fn filters_keep_what_they_should() {
        let bytes = patch();
        let (header, beams) = Patch::beams_of(&bytes).unwrap();
        let bounds = Aabb::new([6e5 + 4.0, 5.3e6 - 0.3, 499.0], [6e5 + 4.16, 5.3e6 + 0.2, 501.0]).unwrap();
        let beams = beams.beams;
        let inside = |b: &&Beam| b.returned && bounds.holds(&(b.offset + header.origin));
        let kept = Patch::within(&bytes, &bounds).unwrap().unwrap();
        assert_eq!(kept.header().beams as usize, beams.iter().filter(inside).count());
        assert!(kept.header().beams > 100 && kept.header().station == 3);
        assert!(Patch::within(&bytes, &Aabb::new([0.0; 3], [1.0; 3]).unwrap()).unwrap().is_none());
        let near = Patch::between(&bytes, 0.0, 4.1).unwrap().unwrap();
        assert!(f64::from(near.header().range[1]) <= 4.1001);
        let thin = Patch::thinned(&bytes, 0.2).unwrap().unwrap();
        assert!(thin.header().returns < header.returns / 3 && thin.header().returns > 100);
        assert_eq!(thin.header().beams - thin.header().returns, header.beams - header.returns);
        assert!(Patch::thinned(&bytes, 0.0).is_err());
    }

    #[test]
    fn moved_there_and_back() {
        let bytes = patch();
        let q = UnitQuaternion::from_scaled_axis(Vec3::new(0.3, -0.2, 1.1));
        let pose = UncertainPose::new(
            [q.w, q.i, q.j, q.k],
            Vec3::new(10.0, -5.0, 2.0),
            1.0,
            &crate::uncertain::Matrix7::zeros(),
        );
        let pose = pose.unwrap();
        let there = Patch::moved(&bytes, &pose).unwrap();
        let back = Patch::moved(&there.to_bytes(), &pose.inverse().unwrap()).unwrap();
        let ((h, a), (g, b)) = (Patch::beams_of(&bytes).unwrap(), Patch::beams_of(&back.to_bytes()).unwrap());
        for (a, b) in a.beams.iter().zip(&b.beams).filter(|(a, _)| a.returned) {
            assert!((a.offset + h.origin - b.offset - g.origin).amax() < 1.01e-4 + 2e-9);
        }
    }

    #[test]
    fn retiling_loses_no_beam() {
        let bytes = patch();
        let halves = [0, 1].map(|k| {
            let mut i = 0;
            Patch::filtered(&bytes, |_, _, _| {
                i += 1;
                i % 2 == k
            })
        });
        let halves: Vec<Vec<u8>> = halves.into_iter().map(|h| h.unwrap().unwrap().to_bytes()).collect();
        let parts: Vec<&[u8]> = halves.iter().map(|h| &**h).collect();
        let whole = Patch::retiled(&parts, NEVER).unwrap();
        assert_eq!(whole.iter().map(|p| p.header().beams).sum::<u32>(), 1600);
        assert!(Patch::retiled(&[], NEVER).unwrap().is_empty());
    }

    proptest! {
        /// Brute force: a beam that comes near the box is never missed.
        #[test]
        fn sees_whatever_a_beam_comes_near(
            x in 0.0..8.0f64,
            y in -3.0..3.0f64,
            z in -3.0..3.0f64,
            side in 0.01..1.0f64,
            margin in 0.0..0.3f64,
        ) {
            let bytes = patch();
            let (header, beams) = Patch::beams_of(&bytes).unwrap();
            let corner = header.origin + Vec3::new(x, y, z);
            let bounds = Aabb::new(corner.into(), (corner + Vec3::repeat(side)).into()).unwrap();
            let grown = bounds.expanded(margin);
            let near = beams.beams.iter().filter(|b| b.returned).any(|b| {
                (0..=200).any(|k| grown.holds(&(header.origin + b.offset * (f64::from(k) / 200.0))))
            });
            prop_assert!(!near || header.sees(&bounds, margin));
        }
    }
}
