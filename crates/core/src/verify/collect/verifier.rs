//! Many objects verified together: a patch is unpacked once for all objects that it concerns.

use super::collector::Collector;
use super::threads::Threads;
use crate::geometry::Solid;
use crate::verify::aim::{Aim, Claims, Unpacked, UnpackedBeams};
use crate::verify::evidence::Evidence;
use crate::verify::model::EvidenceModel;
use crate::verify::sights::Sights;
use crate::{Interrupt, Result, poll};

/// Evidence about many solids, being collected.
#[derive(Debug)]
pub struct Verifier {
    collectors: Vec<Collector>,
    threads: Threads,
    sights: Sights,
}

impl Verifier {
    /// Spreads samples over every solid.
    pub fn new(objects: &[(Solid, EvidenceModel)], threads: Threads, interrupt: Interrupt) -> Result<Self> {
        let collectors =
            threads.map(objects, |(solid, model)| Collector::among_neighbours(solid, *model, interrupt))?;
        let sights = Sights::of(collectors.iter().map(Collector::has_optional).collect());
        Ok(Self { collectors, threads, sights })
    }

    /// Adds what a batch of packed patches tells; all are unpacked at once. Objects know each other here: what a beam
    /// met is that object's to whose drawn surface it lies nearest, and does not displace another one behind it
    /// (cladding, a wall's end). The evidence is the same to the last bit whatever the batches and threads: it is made
    /// of integer sums, and each object adds up its own.
    pub fn absorb<P: AsRef<[u8]> + Sync>(&mut self, patches: &[P], interrupt: Interrupt) -> Result<()> {
        let with_intensities = self.collectors.iter().any(|c| c.evidence().model().intensity.is_some());
        let unpacked = self.threads.map(patches, |p| {
            poll(interrupt)?;
            Unpacked::of(p.as_ref(), with_intensities)
        })?;
        let aims: Vec<Vec<Aim>> = self.threads.map(&self.collectors, |collector| {
            unpacked.iter().map(|patch| collector.aim(patch, interrupt)).collect::<Result<_>>()
        })?;
        let numbers: Vec<usize> = (0..unpacked.len()).collect();
        let claims = self.threads.map(&numbers, |&i| {
            let mut claims = Claims::none(unpacked[i].claimable());
            for (object, (collector, aims)) in self.collectors.iter().zip(&aims).enumerate() {
                collector.claim(&unpacked[i], &aims[i], object as u32, &mut claims);
            }
            Ok(claims)
        })?;
        for (patch, claims) in unpacked.iter().zip(&claims) {
            poll(interrupt)?;
            if let UnpackedBeams::FromOne(view) = &patch.beams {
                self.sights.add(view, claims);
            }
        }
        let mut work: Vec<_> = self.collectors.iter_mut().zip(&aims).enumerate().collect();
        self.threads.for_each(&mut work, |(object, (collector, aims))| {
            let mut patches = unpacked.iter().zip(aims.iter()).zip(&claims);
            patches.try_for_each(|((patch, aim), claims)| {
                let others = claims.of_others_than(*object as u32);
                collector.absorb_aimed(patch, aim, Some(others), interrupt)
            })
        })
    }

    /// The evidence about each solid, in their order.
    pub fn into_evidence(self) -> Vec<Evidence> {
        self.finish().0
    }

    /// The same, and where all beams ended.
    pub fn finish(self) -> (Vec<Evidence>, Sights) {
        (self.collectors.into_iter().map(Collector::into_evidence).collect(), self.sights)
    }
}
