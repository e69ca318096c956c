//! Evidence as a value: samples and, per station, the sums that belief is made from.

use std::collections::BTreeMap;

use super::model::EvidenceModel;
use super::sample::{BLOCK, Samples};
use super::sums::Sums;
use crate::error::{Error, Limited, Mismatch, Result};
use crate::geometry::{Aabb, Vec3};
use crate::{Interrupt, poll_now_and_then};

/// Most sums (48 bytes each in memory) of one value: more than PostgreSQL's 1 GB holds at 16 bytes a sum.
pub(super) const MAX_SUMS: usize = 64_000_000;

/// Where the beams of a station start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// At one point, world metres.
    At(Vec3),
    /// Along the way of a moving platform.
    Many,
    /// Nobody knows: points without rays.
    Unknown,
}

impl Place {
    /// As three numbers: the point, infinity for many, NaN for unknown.
    pub(super) fn to_vec3(self) -> Vec3 {
        match self {
            Self::At(origin) => origin,
            Self::Many => Vec3::repeat(f64::INFINITY),
            Self::Unknown => Vec3::repeat(f64::NAN),
        }
    }

    /// The mirror of [`Place::to_vec3`]; `None` for numbers that are no place.
    pub(super) fn from_vec3(v: Vec3) -> Option<Self> {
        match v {
            v if v.iter().all(|c| c.is_finite()) => Some(Self::At(v)),
            v if v.iter().all(|c| *c == f64::INFINITY) => Some(Self::Many),
            v if v.iter().all(|c| c.is_nan()) => Some(Self::Unknown),
            _ => None,
        }
    }
}

/// What one station's beams add up to, by block of samples; blocks it never saw are absent.
#[derive(Debug, Clone, PartialEq)]
pub struct Station {
    /// The station's number, as in its patches.
    pub id: i64,
    /// Where its beams start. With the number, what tells stations apart.
    pub place: Place,
    /// Widest angle between neighbouring beams, radians; 0 where it is not known.
    pub(super) step: f32,
    pub(super) blocks: BTreeMap<u32, Box<[Sums]>>,
}

impl Station {
    pub(super) fn new(id: i64, place: Place) -> Self {
        Self { id, place, step: 0.0, blocks: BTreeMap::new() }
    }

    /// Order of stations in a value: by number, then by place.
    pub(super) fn key(&self) -> (i64, [u64; 3]) {
        let place = match self.place {
            Place::At(origin) => origin.map(f64::to_bits).into(),
            Place::Many => [u64::MAX - 1; 3],
            Place::Unknown => [u64::MAX; 3],
        };
        (self.id, place)
    }

    fn add(&mut self, other: &Self, interrupt: Interrupt) -> Result<()> {
        self.step = self.step.max(other.step);
        for (round, (block, theirs)) in other.blocks.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            self.add_block(*block, theirs);
        }
        Ok(())
    }

    /// The sums of a block of `len` samples, zeros if it has none yet.
    pub(super) fn block(&mut self, block: u32, len: u32) -> &mut [Sums] {
        self.blocks.entry(block).or_insert_with(|| vec![Sums::default(); len as usize].into())
    }

    /// Adds the sums of a block of samples.
    pub(super) fn add_block(&mut self, block: u32, theirs: &[Sums]) {
        match self.blocks.get_mut(&block) {
            Some(mine) => mine.iter_mut().zip(theirs).for_each(|(a, b)| a.add(b)),
            None => {
                self.blocks.insert(block, theirs.into());
            }
        }
    }
}

/// What the stations' beams say about one solid: SQL's `ab_evidence`. Mergeable; belief is computed when asked.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    pub(super) model: EvidenceModel,
    /// Checksum of the solid the samples lie on.
    pub(super) fingerprint: u32,
    pub(super) bounds: Aabb,
    pub(super) samples: Samples,
    /// Whether beams that other objects explain were left out: all parts came from a [`super::Verifier`].
    pub(super) knows_neighbours: bool,
    /// Ordered by number, then origin, so that equal evidence has equal bytes.
    pub(super) stations: Vec<Station>,
}

/// What a stored evidence tells without its samples.
#[derive(Debug, Clone, Copy)]
pub struct EvidenceHeader {
    /// Box of the solid.
    pub bounds: Aabb,
    /// Number of samples.
    pub samples: u32,
    /// Number of stations that saw the solid.
    pub stations: u32,
    /// The parameters.
    pub model: EvidenceModel,
}

impl Evidence {
    /// The parameters.
    pub fn model(&self) -> &EvidenceModel {
        &self.model
    }

    /// The samples.
    pub fn samples(&self) -> &Samples {
        &self.samples
    }

    /// Checksum of the solid that the samples lie on.
    pub fn fingerprint(&self) -> u32 {
        self.fingerprint
    }

    /// The stations that spoke.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// The place of a station in [`Evidence::stations`], made if it is new.
    pub(super) fn station_index(&mut self, id: i64, place: Place) -> usize {
        if let Some(i) = self.stations.iter().position(|s| s.id == id && s.place == place) {
            return i;
        }
        let fresh = Station::new(id, place);
        let at = self.stations.partition_point(|s| s.key() < fresh.key());
        self.stations.insert(at, fresh);
        at
    }

    /// The same samples and parameters; no station has spoken.
    pub fn without_stations(&self) -> Self {
        Self { samples: self.samples.clone(), stations: Vec::new(), ..*self }
    }

    /// Fails where stations and samples together are more than a value may hold.
    pub(super) fn check_size(&self) -> Result<()> {
        let blocks = self.stations.iter().map(|s| s.blocks.len()).sum::<usize>();
        let sums = blocks * BLOCK;
        if sums > MAX_SUMS {
            let value = format!("{sums} (samples times stations)");
            return Err(Error::Limit { what: Limited::Evidence, value, limit: MAX_SUMS.to_string() });
        }
        Ok(())
    }

    /// Adds evidence about the same solid. Sums are integers: the result does not depend on order or grouping.
    pub fn merge(&mut self, other: &Self, interrupt: Interrupt) -> Result<()> {
        if self.fingerprint != other.fingerprint {
            return Err(Error::Mismatch(Mismatch::Solids));
        }
        if self.model != other.model {
            return Err(Error::Mismatch(Mismatch::Models(self.model.difference(&other.model))));
        }
        if !self.samples.are_those_of(&other.samples) {
            return Err(Error::Mismatch(Mismatch::Samples));
        }
        self.samples.join_surfaces(&other.samples);
        self.knows_neighbours &= other.knows_neighbours;
        for theirs in &other.stations {
            let i = self.station_index(theirs.id, theirs.place);
            self.stations[i].add(theirs, interrupt)?;
            self.check_size()?;
        }
        Ok(())
    }
}
