//! Where the beams of all stations ended, and second looks.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::second_look::Looked;
use super::sight_map::SightMap;
use crate::scan::RangeImage;
use crate::verify::evidence::{Evidence, Unseen};
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
}

impl Sights {
    /// Remembers the beams of a patch.
    pub(in crate::verify) fn add(&mut self, view: &RangeImage) {
        let key = (view.header.station, view.header.origin.map(f64::to_bits).into());
        if self.maps.len() >= MAX_STATIONS && !self.maps.contains_key(&key) {
            return;
        }
        let map = self.maps.entry(key).or_insert_with(|| SightMap::new(view.header.origin));
        for slot in (0..view.len()).step_by(SightMap::stride(view.step())) {
            map.add(&view.directions[slot], view.ranges[slot]);
        }
    }

    /// Looks a second time at the object of which `evidence` is, and notes there why it was not seen; returns the object
    /// that hides most of what is hidden by one.
    pub(in crate::verify) fn second_look(
        &self,
        evidence: &mut Evidence,
        looked: &Looked<'_>,
        interrupt: Interrupt,
    ) -> Result<Option<u32>> {
        let samples = &evidence.samples;
        let maps: Vec<&SightMap> = self.maps.values().collect();
        let (mut counts, mut hiders) = ([0u32; 7], BTreeMap::new());
        let stride = samples.len().div_ceil(MAX_LOOKS).max(1);
        for (i, face) in samples.face_of_each().enumerate().step_by(stride) {
            poll_now_and_then(i / stride, interrupt)?;
            let (why, hider) = looked.why(&maps, &samples.position(i), &samples.normals[face]);
            counts[why as usize] += 1;
            hider.into_iter().for_each(|h| *hiders.entry(h).or_insert(0u32) += 1);
        }
        evidence.unseen = Unseen::of(&counts);
        let most = hiders.into_iter().max_by_key(|(object, n)| (*n, Reverse(*object)));
        Ok(most.map(|(object, _)| object))
    }
}
