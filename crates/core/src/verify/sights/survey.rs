//! Where the beams of all stations ended, and second looks.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::far_face::FarFaces;
use super::second_look::{Looked, Outlook};
use super::sight_map::SightMap;
use crate::scan::RangeImage;
use crate::verify::evidence::{Evidence, FoundFace, Unseen, Why};
use crate::{Interrupt, Result, poll_now_and_then};

/// Stations that are remembered, at 3 MB each; what only later ones looked at counts as not looked at.
const MAX_STATIONS: usize = 256;
/// Samples of an object that are looked at a second time; spread evenly over it.
const MAX_LOOKS: usize = 2_000;

/// Where the beams of a survey ended.
#[derive(Debug, Default)]
pub struct Sights {
    /// By station and origin.
    maps: BTreeMap<(i64, [u64; 3]), SightMap>,
    /// Beams came of which nobody knows, or none remembers, where they start.
    are_some_unknown: bool,
}

impl Sights {
    /// Remembers the beams of a patch.
    pub(in crate::verify) fn add(&mut self, view: &RangeImage) {
        let key = (view.header.station, view.header.origin.map(f64::to_bits).into());
        if self.maps.len() >= MAX_STATIONS && !self.maps.contains_key(&key) {
            return self.add_unknown();
        }
        let map = self.maps.entry(key).or_insert_with(|| SightMap::new(view.header.origin));
        for slot in (0..view.len()).step_by(SightMap::stride(view.step())) {
            map.add(&view.directions[slot], view.ranges[slot]);
        }
    }

    /// Remembers that there are beams which do not start at one known place.
    pub(in crate::verify) fn add_unknown(&mut self) {
        self.are_some_unknown = true;
    }

    /// The stations by their distance from an object: what the near ones tell saves asking the far ones.
    fn nearest_first(&self, evidence: &Evidence) -> Vec<Outlook<'_>> {
        let (centre, radius) = (evidence.bounds.centre(), 0.5 * evidence.bounds.diagonal());
        let mut maps: Vec<(f64, &SightMap)> =
            self.maps.values().map(|map| ((map.origin_world - centre).norm(), map)).collect();
        maps.sort_by(|a, b| a.0.total_cmp(&b.0));
        let model = &evidence.model;
        maps.into_iter()
            .map(|(distance, map)| {
                // A beam that is as far off the plane of a face as the model looks, in a direction that a map's cell is off.
                let off = model.farthest() + 2.0 * SightMap::CELL * (distance + radius);
                Outlook { map, may_meet: map.may_meet(&centre, radius, off / model.max_incidence.cos()) }
            })
            .collect()
    }

    /// For an object that was not found where it is drawn, or without a number: its face that stands within the model's
    /// reach of there.
    pub(in crate::verify) fn far_face(
        &self,
        evidence: &Evidence,
        looked: &Looked<'_>,
        interrupt: Interrupt,
    ) -> Result<Option<FoundFace>> {
        let outlooks = self.nearest_first(evidence);
        FarFaces { looked, outlooks: &outlooks, evidence, stride: stride(evidence) }.find(interrupt)
    }

    /// Why the object of which `evidence` is was not seen, and the object that hides most of what is hidden by one.
    pub(in crate::verify) fn unseen(
        &self,
        evidence: &Evidence,
        looked: &Looked<'_>,
        interrupt: Interrupt,
    ) -> Result<(Option<Unseen>, Option<u32>)> {
        let samples = &evidence.samples;
        let outlooks = self.nearest_first(evidence);
        let (mut counts, mut hiders) = ([0u32; 7], BTreeMap::new());
        let stride = stride(evidence);
        let is_expected = samples.expects();
        for (round, (i, face)) in samples.face_of_each().enumerate().step_by(stride).enumerate() {
            poll_now_and_then(round, interrupt)?;
            if !is_expected(face) {
                continue;
            }
            let (why, hider) = looked.why(&outlooks, &samples.position(i), &samples.normals[face]);
            counts[why as usize] += 1;
            hider.into_iter().for_each(|h| *hiders.entry(h).or_insert(0u32) += 1);
        }
        let most = hiders.into_iter().max_by_key(|(object, n)| (*n, Reverse(*object)));
        // Whoever was not looked at from a known place may have been from another.
        let is_known = |unseen: &Unseen| !self.are_some_unknown || unseen.main() != Why::NotLookedAt;
        let unseen = Unseen::of(&counts).filter(is_known);
        Ok((unseen, most.filter(|_| unseen.is_some()).map(|(object, _)| object)))
    }
}

/// Of so many samples of an object one is looked at a second time.
fn stride(evidence: &Evidence) -> usize {
    evidence.samples.len().div_ceil(MAX_LOOKS).max(1)
}
