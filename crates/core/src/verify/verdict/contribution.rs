//! What each station contributed to the evidence.

use crate::verify::evidence::{Evidence, StationEvidence, StationOrigin};
use crate::verify::surface::SampleReading;
use crate::{Interrupt, Result, poll};

/// One station's part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contribution {
    /// The station's number.
    pub station: i64,
    /// Where its beams start.
    pub place: StationOrigin,
    /// Samples that it sees by itself.
    pub seen: u64,
    /// Samples that are seen with it and not without.
    pub added: u64,
}

impl Evidence {
    /// For each station what it saw, and what nobody would have seen without it.
    pub fn contributions(&self, interrupt: Interrupt) -> Result<Vec<Contribution>> {
        let none = |s: &StationEvidence| Contribution { station: s.id, place: s.place, seen: 0, added: 0 };
        let mut out: Vec<Contribution> = self.stations.iter().map(none).collect();
        let mut reading = SampleReading::default();
        for (b, block) in self.samples.blocks.iter().enumerate() {
            poll(interrupt)?;
            let all = self.stations_of_block(b);
            let normal = &self.samples.normals[block.face as usize];
            for i in 0..block.len as usize {
                let position = self.samples.position(block.start as usize + i);
                let mut is_seen = |stations: &[_]| {
                    reading.read(stations, i, &position, normal, &self.model);
                    reading.seen
                };
                let seen_by_all = is_seen(&all);
                for (k, one) in all.iter().enumerate() {
                    let others = [&all[..k], &all[k + 1..]].concat();
                    let contribution = &mut out[one.0];
                    contribution.seen += u64::from(is_seen(std::slice::from_ref(one)));
                    contribution.added += u64::from(seen_by_all && !is_seen(&others));
                }
            }
        }
        Ok(out)
    }
}
