//! Patches made from patches: filtered, thinned, moved, joined, cut anew. What is kept keeps its coordinates to half a
//! quantum; nothing is kept of beams that are dropped.

use std::collections::HashSet;

use super::{Beam, Header, Patch, tiles};
use crate::error::{Error, Result};
use crate::geometry::{Aabb, Vec3};
use crate::uncertain::Pose;
use crate::{Interrupt, poll_now_and_then};

impl Patch {
    /// The beams that `keep` says yes to; `None` where none is left.
    pub fn filtered(bytes: &[u8], mut keep: impl FnMut(&Header, &Beam) -> bool) -> Result<Option<Self>> {
        let (header, mut beams) = Self::beams_of(bytes)?;
        beams.retain(|b| keep(&header, b));
        if beams.is_empty() { Ok(None) } else { Self::alike(&header, &beams).map(Some) }
    }

    /// Beams whose return lies in `bounds` (world metres).
    pub fn within(bytes: &[u8], bounds: &Aabb) -> Result<Option<Self>> {
        if !Header::read(bytes)?.points.overlaps(bounds) {
            return Ok(None);
        }
        Self::filtered(bytes, |h, b| b.returned && bounds.holds(&(b.offset + h.origin)))
    }

    /// Beams whose return is at least `min` and at most `max` metres away.
    pub fn between(bytes: &[u8], min: f64, max: f64) -> Result<Option<Self>> {
        Self::filtered(bytes, |_, b| b.returned && (min..=max).contains(&b.offset.norm()))
    }

    /// The first beam of every cube of side `spacing` (metres, lattice of the reference system) that a return lies in,
    /// and every beam without return.
    pub fn thinned(bytes: &[u8], spacing: f64) -> Result<Option<Self>> {
        if !(spacing > 0.0 && spacing.is_finite()) {
            return Err(Error::argument("the spacing", "positive and finite", spacing));
        }
        let mut taken = HashSet::new();
        Self::filtered(bytes, |h, b| {
            let cube: [i64; 3] = (b.offset + h.origin).map(|c| (c / spacing).floor() as i64).into();
            !b.returned || taken.insert(cube)
        })
    }

    /// The patch seen through a pose; its covariance is not carried.
    pub fn moved(bytes: &[u8], pose: &Pose) -> Result<Self> {
        let (mut header, mut beams) = Self::beams_of(bytes)?;
        let linear = pose.matrix() * pose.scale;
        beams.iter_mut().for_each(|b| b.offset = linear * b.offset);
        header.origin = pose.apply(&header.origin);
        if !header.has_origin() {
            header.step *= pose.scale as f32;
        }
        Self::alike(&header, &beams)
    }

    /// The beams of many patches of one station and origin, cut anew into tiles of neighbours.
    pub fn retiled(patches: &[&[u8]], interrupt: Interrupt) -> Result<Vec<Self>> {
        let mut first: Option<Header> = None;
        let mut all = Vec::new();
        for (i, bytes) in patches.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            let (header, beams) = Self::beams_of(bytes)?;
            let of = |h: &Header| (h.station, h.origin, h.has_origin());
            match &first {
                Some(f) if of(f) != of(&header) => {
                    return Err(Error::argument("the patches of a union", "of one station and origin", "of several"));
                }
                Some(_) => {}
                None => first = Some(header),
            }
            all.extend(beams);
        }
        let Some(header) = first else { return Ok(Vec::new()) };
        tiles(&all)
            .into_iter()
            .map(|tile| Self::alike(&header, &tile.iter().map(|&i| all[i as usize]).collect::<Vec<_>>()))
            .collect()
    }

    /// Packs beams as a patch of the same station, origin, step and quantum.
    fn alike(header: &Header, beams: &[Beam]) -> Result<Self> {
        let (station, step, quantum) = (header.station, f64::from(header.step), header.quantum);
        if header.has_origin() {
            return Self::encode(station, header.origin, step, quantum, beams);
        }
        let points: Vec<Vec3> = beams.iter().map(|b| b.offset + header.origin).collect();
        Self::encode_cloud(station, header.origin, step, quantum, &points)
    }
}

impl Header {
    /// Whether a beam of the patch can come within `margin` metres of a box: by cone and range, against the ball around
    /// the box. Never says no where one does.
    pub fn sees(&self, bounds: &Aabb, margin: f64) -> bool {
        if !self.has_origin() {
            return self.points.expanded(margin).overlaps(bounds);
        }
        let offset = bounds.centre() - self.origin;
        let radius = 0.5 * bounds.diagonal() + margin;
        let returns = if self.returns > 0 { f64::from(self.range[1]) } else { 0.0 };
        let reach = if self.flags & Self::FLAG_NO_RETURNS != 0 { f64::INFINITY } else { returns };
        offset.norm() - radius <= reach && self.cone.meets_ball(&offset, radius, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
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
        let pose =
            Pose::new([q.w, q.i, q.j, q.k], Vec3::new(10.0, -5.0, 2.0), 1.0, &crate::uncertain::Matrix7::zeros());
        let pose = pose.unwrap();
        let there = Patch::moved(&bytes, &pose).unwrap();
        let back = Patch::moved(&there.to_bytes(), &pose.inverse().unwrap()).unwrap();
        let ((h, a), (g, b)) = (Patch::beams_of(&bytes).unwrap(), Patch::beams_of(&back.to_bytes()).unwrap());
        for (a, b) in a.iter().zip(&b).filter(|(a, _)| a.returned) {
            assert!((a.offset + h.origin - b.offset - g.origin).amax() < 1.01e-4 + 2e-9);
        }
    }

    #[test]
    fn retiling_loses_no_beam() {
        let bytes = patch();
        let halves = [0, 1].map(|k| {
            let mut i = 0;
            Patch::filtered(&bytes, |_, _| {
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
        /// Brute force: a beam that comes near the box is never denied.
        #[test]
        fn sees_whatever_a_beam_comes_near(x in 0.0..8.0f64, y in -3.0..3.0f64, z in -3.0..3.0f64, side in 0.01..1.0f64, margin in 0.0..0.3f64) {
            let bytes = patch();
            let (header, beams) = Patch::beams_of(&bytes).unwrap();
            let corner = header.origin + Vec3::new(x, y, z);
            let bounds = Aabb::new(corner.into(), (corner + Vec3::repeat(side)).into()).unwrap();
            let grown = bounds.expanded(margin);
            let near = beams.iter().filter(|b| b.returned).any(|b| {
                (0..=200).any(|k| grown.holds(&(header.origin + b.offset * (f64::from(k) / 200.0))))
            });
            prop_assert!(!near || header.sees(&bounds, margin));
        }
    }
}
