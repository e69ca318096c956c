//! Evidence as a value: samples and, per station, the sums that belief is made from.

use super::found_face::FoundFace;
use super::samples::{BLOCK, Samples};
use super::station::{StationEvidence, StationOrigin};
use super::unseen::Unseen;
use crate::Interrupt;
use crate::error::{Error, Limited, Mismatch, Result};
use crate::geometry::{Aabb, Solid};
use crate::verify::model::{EvidenceModel, Question, Sums};

/// Most sums (48 bytes each in memory) of one value: more than PostgreSQL's 1 GB holds at 16 bytes a sum.
pub(super) const MAX_SUMS: usize = 64_000_000;

/// What the stations' beams tell of one solid: SQL's `ab_evidence`. Mergeable; belief is computed when asked.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    pub(in crate::verify) model: EvidenceModel,
    /// Checksum of the solid the samples lie on.
    pub(in crate::verify) fingerprint: u32,
    pub(in crate::verify) bounds: Aabb,
    pub(in crate::verify) samples: Samples,
    /// Whether beams that other objects explain were left out: all parts came from a
    /// [`Verifier`](crate::verify::Verifier).
    pub(in crate::verify) knows_neighbours: bool,
    /// Why it stayed unobserved, where somebody looked a second time.
    pub(in crate::verify) unseen: Option<Unseen>,
    /// Where it stands instead of its place, where somebody looked a second time.
    pub(in crate::verify) found: Option<FoundFace>,
    /// Ordered by number, then origin, so that equal evidence has equal bytes.
    pub(in crate::verify) stations: Vec<StationEvidence>,
}

impl Evidence {
    /// Evidence about a solid that no station saw yet; samples as far apart as `model` says.
    pub(in crate::verify) fn about(
        solid: &Solid,
        model: EvidenceModel,
        knows_neighbours: bool,
        interrupt: Interrupt,
    ) -> Result<Self> {
        let samples = Samples::on(solid, model.spacing, interrupt)?;
        let fingerprint = solid.fingerprint(interrupt)?;
        let (bounds, stations) = (solid.bounds(), Vec::new());
        // What lies farther off is no sum; a second look finds it.
        let model = EvidenceModel { reach: EvidenceModel::default().reach, ..model };
        Ok(Self { model, fingerprint, bounds, samples, knows_neighbours, unseen: None, found: None, stations })
    }

    /// The parameters.
    pub fn model(&self) -> &EvidenceModel {
        &self.model
    }

    /// The samples.
    pub fn samples(&self) -> &Samples {
        &self.samples
    }

    /// Why the object stayed unobserved, where somebody looked a second time.
    pub fn unseen(&self) -> Option<Unseen> {
        self.unseen
    }

    /// The face that stands farther off than sums tell, where somebody looked a second time.
    pub fn found(&self) -> Option<FoundFace> {
        self.found
    }

    /// Checksum of the solid that the samples lie on.
    pub fn fingerprint(&self) -> u32 {
        self.fingerprint
    }

    /// The stations that saw anything of the solid.
    pub fn stations(&self) -> &[StationEvidence] {
        &self.stations
    }

    /// The stations that saw anything of block `b`, with their places in the list and their sums.
    pub(in crate::verify) fn stations_of_block(&self, b: usize) -> Vec<(usize, &StationEvidence, &[Sums])> {
        self.stations.iter().enumerate().filter_map(|(i, s)| Some((i, s, &**s.blocks.get(&(b as u32))?))).collect()
    }

    /// The parameters with another question.
    pub(in crate::verify) fn asked(&self, question: &Question) -> EvidenceModel {
        EvidenceModel { question: *question, ..self.model }
    }

    /// The place of a station in [`Evidence::stations`], made if it is new.
    pub(in crate::verify) fn station_index(&mut self, id: i64, place: StationOrigin) -> usize {
        if let Some(i) = self.stations.iter().position(|s| s.id == id && s.place == place) {
            return i;
        }
        let fresh = StationEvidence::new(id, place);
        let at = self.stations.partition_point(|s| s.key() < fresh.key());
        self.stations.insert(at, fresh);
        at
    }

    /// The same samples and parameters; no station yet.
    pub fn without_stations(&self) -> Self {
        Self { samples: self.samples.clone(), unseen: None, found: None, stations: Vec::new(), ..*self }
    }

    /// Fails where stations and samples together are more than a value may hold.
    pub(in crate::verify) fn check_size(&self) -> Result<()> {
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
        if !other.stations.is_empty() {
            (self.unseen, self.found) = (None, None);
        }
        for theirs in &other.stations {
            let i = self.station_index(theirs.id, theirs.place);
            self.stations[i].add(theirs, interrupt)?;
            self.check_size()?;
        }
        Ok(())
    }
}
