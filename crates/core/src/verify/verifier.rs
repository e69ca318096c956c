//! Many objects verified together: a patch is unpacked once for all objects that it concerns.

use rayon::prelude::*;

use super::claims::Claims;
use super::collect::Collector;
use super::evidence::Evidence;
use super::model::EvidenceModel;
use super::unpacked::{Aim, Unpacked};
use crate::geometry::Solid;
use crate::{Interrupt, Result, poll};

/// Where the work is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Threads {
    /// On the caller's thread.
    Own,
    /// On those of the rayon pool that the caller has installed.
    Pool,
}

impl Threads {
    /// Calls `work` for every item, in any order; the first error in the items' order is returned.
    pub fn for_each<T: Send>(self, items: &mut [T], work: impl Fn(&mut T) -> Result<()> + Sync) -> Result<()> {
        match self {
            Self::Own => items.iter_mut().try_for_each(work),
            Self::Pool => items.par_iter_mut().with_max_len(1).map(&work).collect::<Vec<_>>().into_iter().collect(),
        }
    }

    /// `work` of every item, in the items' order.
    pub fn map<T: Sync, U: Send>(self, items: &[T], work: impl Fn(&T) -> Result<U> + Sync) -> Result<Vec<U>> {
        match self {
            Self::Own => items.iter().map(work).collect(),
            Self::Pool => items.par_iter().with_max_len(1).map(&work).collect::<Vec<_>>().into_iter().collect(),
        }
    }
}

/// Evidence about many solids in the making.
#[derive(Debug)]
pub struct Verifier {
    collectors: Vec<Collector>,
    threads: Threads,
}

impl Verifier {
    /// Spreads samples over every solid.
    pub fn new(objects: &[(Solid, EvidenceModel)], threads: Threads, interrupt: Interrupt) -> Result<Self> {
        let collectors = threads.map(objects, |(solid, model)| {
            let mut collector = Collector::new(solid, *model, interrupt)?;
            collector.know_neighbours();
            Ok(collector)
        })?;
        Ok(Self { collectors, threads })
    }

    /// Adds what a batch of packed patches says; all are unpacked at once. Objects know each other here: what a beam
    /// met is that object's to whose drawn surface it lies nearest, and does not displace another one behind it
    /// (cladding, a wall's end). The
    /// evidence is the same to the last bit whatever the batches and threads: it is made of integer sums, and each
    /// object adds up its own.
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
            let mut claims = Claims::none(unpacked[i].aimed_beams());
            for (object, (collector, aims)) in self.collectors.iter().zip(&aims).enumerate() {
                collector.claim(&unpacked[i], &aims[i], object as u32, &mut claims);
            }
            Ok(claims)
        })?;
        let mut work: Vec<_> = self.collectors.iter_mut().zip(&aims).enumerate().collect();
        self.threads.for_each(&mut work, |(object, (collector, aims))| {
            let mut patches = unpacked.iter().zip(aims.iter()).zip(&claims);
            patches.try_for_each(|((patch, aim), claims)| {
                let others = |slot| f64::from(claims.of_others(slot, *object as u32));
                collector.absorb_aimed(patch, aim, Some(&others), interrupt)
            })
        })
    }

    /// The evidence about each solid, in their order.
    pub fn into_evidence(self) -> Vec<Evidence> {
        self.collectors.into_iter().map(Collector::into_evidence).collect()
    }
}
