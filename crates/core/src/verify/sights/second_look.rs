//! Why one sample was not seen, from where the beams of each station ended.

use super::sight_map::{NOBODY, SightMap};
use crate::geometry::Vec3;
use crate::verify::evidence::Why;
use crate::verify::model::{EvidenceModel, as_designed};

/// The object that is looked at.
pub struct Looked<'a> {
    /// Its number.
    pub object: u32,
    /// Its faces are seen from both sides.
    pub two_sided: bool,
    /// Some of its parts are panes or leaves.
    pub has_optional: bool,
    pub model: &'a EvidenceModel,
}

/// What kept one station from a sample, from the least to the most that had to change for it to be seen.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
enum Kept {
    Shared,
    Reached,
    NothingReturned,
    Steep,
    /// By an object or [`NOBODY`], from so far away.
    Hidden(f64, u32),
    Aside,
}

impl Looked<'_> {
    /// Why a sample was not seen, and which object hides it. World metres.
    pub fn why(&self, maps: &[&SightMap], position_world: &Vec3, normal: &Vec3) -> (Why, Option<u32>) {
        let kept = maps.iter().map(|map| self.kept(map, position_world, normal));
        let least = kept.min_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal)).unwrap_or(Kept::Aside);
        match least {
            Kept::Shared => (Why::SharedFace, None),
            Kept::Reached => (Why::TooFew, None),
            Kept::NothingReturned => (Why::NoReturn, None),
            Kept::Steep => (Why::TooSteep, None),
            Kept::Hidden(_, NOBODY) => (Why::HiddenByOther, None),
            Kept::Hidden(_, object) => (Why::HiddenByObject, Some(object)),
            Kept::Aside => (Why::NotLookedAt, None),
        }
    }

    fn kept(&self, map: &SightMap, position_world: &Vec3, normal: &Vec3) -> Kept {
        let sight = position_world - map.origin_world;
        let range = sight.norm();
        let towards = -sight.dot(normal) / range;
        let cos = if self.two_sided { towards.abs() } else { towards };
        let Some(beam) = (cos > 0.0).then(|| map.towards(&(sight / range))).flatten() else { return Kept::Aside };
        let Some(met) = beam.met() else { return Kept::NothingReturned };
        // In front of the sample's plane, on the station's side.
        let height = (met - sight).dot(normal) * towards.signum();
        let as_designed = as_designed(self.model);
        if height > as_designed && met.norm() < range && beam.owner != self.object {
            return Kept::Hidden(range, beam.owner);
        }
        match () {
            () if cos < self.model.max_incidence.cos() => Kept::Steep,
            () if height.abs() <= as_designed && beam.owner != NOBODY && beam.owner != self.object => Kept::Shared,
            // What passes a pane, or where a leaf is drawn, says nothing of it.
            () if height < -as_designed && self.has_optional => Kept::NothingReturned,
            () => Kept::Reached,
        }
    }
}
