//! Why one sample was not seen, from where the beams of each station ended.

use super::sight_map::SightMap;
use crate::geometry::Vec3;
use crate::verify::evidence::Why;
use crate::verify::model::{EvidenceModel, as_designed};

/// What measures less than so many cells may be missed by the beam that a map remembers.
const FEW_CELLS: f64 = 3.0;

/// Whose drawn surface lies where a beam ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Owner {
    /// The object's that is looked at.
    Own,
    /// Another object's, by its number.
    Other(u32),
    /// Nobody drew anything there.
    Nobody,
}

/// The object that is looked at.
pub struct Looked<'a> {
    /// Whose surface is drawn at a place, as a beam in this direction meets it. World metres.
    pub owner: &'a dyn Fn(&Vec3, &Vec3) -> Owner,
    /// Whether the surface of another object is drawn within so many metres of a place, as a beam in this direction meets
    /// it.
    pub is_anothers: &'a dyn Fn(&Vec3, &Vec3, f64) -> bool,
    /// Its faces are seen from both sides.
    pub two_sided: bool,
    /// Some of its parts are panes or leaves.
    pub has_optional: bool,
    /// Its largest extent, metres.
    pub extent: f64,
    pub model: &'a EvidenceModel,
}

/// What a station saw of an object.
pub struct Outlook<'a> {
    pub map: &'a SightMap,
    /// Whether its beams may have got as far as the object. If not, something hides it wherever they were sent towards it.
    pub may_meet: bool,
}

/// A place as a station sees it.
pub struct Sighted {
    /// From where its beams start, metres.
    pub place_scanner: Vec3,
    pub range: f64,
    pub direction: Vec3,
    /// Of the angle of incidence; not positive where it is seen from behind.
    pub cos: f64,
    /// 1 where the normal looks at the station, else −1.
    pub side: f64,
}

/// What kept one station from a sample, from the least to the most that had to change for it to be seen.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kept {
    Shared,
    Reached,
    NothingReturned,
    Steep,
    Hidden {
        by: Option<u32>,
        /// How far the station is, metres: of several that are kept away the nearest counts.
        range: f64,
    },
    Aside,
}

impl Kept {
    fn is_less_than(&self, other: &Self) -> bool {
        let (a, b) = (self.order(), other.order());
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).is_lt()
    }

    fn order(&self) -> (u8, f64) {
        match self {
            Self::Shared => (0, 0.0),
            Self::Reached => (1, 0.0),
            Self::NothingReturned => (2, 0.0),
            Self::Steep => (3, 0.0),
            Self::Hidden { range, .. } => (4, *range),
            Self::Aside => (5, 0.0),
        }
    }
}

impl Looked<'_> {
    /// Why a sample was not seen, and which object hides it. World metres.
    pub fn why(&self, outlooks: &[Outlook<'_>], position_world: &Vec3, normal: &Vec3) -> (Why, Option<u32>) {
        let mut least = Kept::Aside;
        for Outlook { map, may_meet } in outlooks {
            let range = (position_world - map.origin_world).norm();
            if !may_meet && !(Kept::Hidden { by: None, range }).is_less_than(&least) {
                continue;
            }
            let kept = self.kept(map, position_world, normal, &least);
            if kept.is_less_than(&least) {
                least = kept;
            }
        }
        match least {
            Kept::Shared => (Why::SharedFace, None),
            Kept::Reached => (Why::TooFew, None),
            Kept::NothingReturned => (Why::NoReturn, None),
            Kept::Steep => (Why::TooSteep, None),
            Kept::Hidden { by: None, .. } => (Why::HiddenByOther, None),
            Kept::Hidden { by, .. } => (Why::HiddenByObject, by),
            Kept::Aside => (Why::NotLookedAt, None),
        }
    }

    /// A place on a face with this normal. World metres.
    pub fn sighted(&self, map: &SightMap, position_world: &Vec3, normal: &Vec3) -> Sighted {
        let place_scanner = position_world - map.origin_world;
        let range = place_scanner.norm();
        let (direction, towards) = (place_scanner / range, -place_scanner.dot(normal) / range);
        let cos = if self.two_sided { towards.abs() } else { towards };
        Sighted { place_scanner, range, direction, cos, side: towards.signum() }
    }

    /// What kept a station from a sample; beyond what another one was kept by it is not asked whose it is.
    fn kept(&self, map: &SightMap, position_world: &Vec3, normal: &Vec3, least: &Kept) -> Kept {
        let Sighted { place_scanner, range, direction, cos, side } = self.sighted(map, position_world, normal);
        let Some(beam) = (cos > 0.0).then(|| map.towards(&direction)).flatten() else { return Kept::Aside };
        let Some(met) = beam.met() else {
            // The one beam that is remembered here may have passed beside what is as small.
            let is_small = self.extent < FEW_CELLS * SightMap::CELL * range;
            return if is_small { Kept::Reached } else { Kept::NothingReturned };
        };
        // In front of the sample's plane, on the station's side.
        let height = (met - place_scanner).dot(normal) * side;
        let as_designed = as_designed(self.model);
        let (met_world, beam_direction) = (met + map.origin_world, met.normalize());
        // At a glancing incidence little height is much on the way.
        let before = range - met.norm();
        if before > 0.0 && (height > as_designed || before > self.model.farthest() / self.model.max_incidence.cos()) {
            if !(Kept::Hidden { by: None, range }).is_less_than(least) {
                return Kept::Aside;
            }
            match (self.owner)(&met_world, &beam_direction) {
                Owner::Own => {}
                Owner::Other(object) => return Kept::Hidden { by: Some(object), range },
                Owner::Nobody => return Kept::Hidden { by: None, range },
            }
        }
        match () {
            () if cos < self.model.max_incidence.cos() => Kept::Steep,
            () if height.abs() <= as_designed && (self.is_anothers)(&met_world, &beam_direction, as_designed) => {
                Kept::Shared
            }
            // What passes a pane, or where a leaf is drawn, says nothing of it.
            () if height < -as_designed && self.has_optional => Kept::NothingReturned,
            () => Kept::Reached,
        }
    }
}
