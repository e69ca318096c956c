//! Many objects verified together: a patch is unpacked once for all objects that it concerns.

use std::sync::Arc;

use super::collector::Collector;
use super::drawn_object::DrawnObject;
use super::survey_objects::{Batch, SurveyObjects};
use super::threads::Threads;
use crate::scan::PatchHeader;
use crate::verify::aim::{Aim, Claims, Unpacked, UnpackedBeams};
use crate::verify::evidence::Evidence;
use crate::verify::sights::Sights;
use crate::{Interrupt, Result, poll};

/// Evidence about the objects of a batch, being collected.
#[derive(Debug)]
pub struct Verifier<'a> {
    objects: &'a SurveyObjects,
    collectors: Vec<(u32, Collector)>,
    /// Objects that may have been met instead.
    around: Vec<u32>,
    threads: Threads,
}

impl<'a> Verifier<'a> {
    /// Spreads samples over every solid of the batch.
    pub fn new(objects: &'a SurveyObjects, batch: &Batch, threads: Threads, interrupt: Interrupt) -> Result<Self> {
        let collector = |i: &u32| {
            let drawn = Arc::clone(&objects.drawn[*i as usize]);
            Ok((*i, Collector::among_neighbours(objects.solid(*i), drawn, interrupt)?))
        };
        let collectors = threads.map(&batch.own, collector)?;
        Ok(Self { objects, collectors, around: batch.around.clone(), threads })
    }

    /// Adds what some packed patches tell; all are unpacked at once. Objects know each other here: what a beam met is
    /// that object's to whose drawn surface it lies nearest, and does not displace another one behind it (cladding, a
    /// wall's end). The evidence is the same to the last bit whatever the batches and threads: it is made of integer
    /// sums, and each object adds up its own. Where `sights` are given, they remember all beams.
    pub fn absorb<P: AsRef<[u8]> + Sync>(
        &mut self,
        patches: &[P],
        mut sights: Option<&mut Sights>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let unpacked = self.unpacked(patches, sights.is_some(), interrupt)?;
        if let Some(sights) = &mut sights {
            for patch in &unpacked {
                poll(interrupt)?;
                match &patch.beams {
                    UnpackedBeams::FromOne(view) => sights.add(view),
                    _ => sights.add_unknown(),
                }
            }
        }
        let aims = |object: &DrawnObject| -> Result<Vec<Aim>> {
            unpacked.iter().map(|patch| object.aim(patch, interrupt)).collect()
        };
        let own = self.threads.map(&self.collectors, |(_, collector)| aims(&collector.drawn))?;
        let around = self.threads.map(&self.around, |i| aims(&self.objects.drawn[*i as usize]))?;
        let claims = self.claims(&unpacked, &own, &around)?;
        let mut work: Vec<_> = self.collectors.iter_mut().zip(&own).collect();
        self.threads.for_each(&mut work, |((object, collector), aims)| {
            let mut patches = unpacked.iter().zip(aims.iter()).zip(&claims);
            patches.try_for_each(|((patch, aim), claims)| {
                let others = claims.of_others_than(self.objects.body(*object));
                collector.absorb_aimed(patch, aim, Some(others), interrupt)
            })
        })
    }

    /// The patches that concern any of the objects, or all.
    fn unpacked<P: AsRef<[u8]> + Sync>(&self, patches: &[P], all: bool, interrupt: Interrupt) -> Result<Vec<Unpacked>> {
        let with_intensities = self.collectors.iter().any(|(_, c)| c.evidence().model().intensity.is_some());
        let unpacked = self.threads.map(patches, |p| {
            poll(interrupt)?;
            let header = PatchHeader::read(p.as_ref())?;
            let concerned = all || self.collectors.iter().any(|(_, c)| c.concerns(&header));
            concerned.then(|| Unpacked::of(p.as_ref(), with_intensities)).transpose()
        })?;
        Ok(unpacked.into_iter().flatten().collect())
    }

    /// For each patch which of its returns lie near which object.
    fn claims(&self, unpacked: &[Unpacked], own: &[Vec<Aim>], around: &[Vec<Aim>]) -> Result<Vec<Claims>> {
        let numbers = self.collectors.iter().map(|(i, _)| i).chain(&self.around);
        let aimed: Vec<(&u32, &Vec<Aim>)> = numbers.zip(own.iter().chain(around)).collect();
        let patches: Vec<usize> = (0..unpacked.len()).collect();
        self.threads.map(&patches, |&k| {
            let mut claims = Claims::none(unpacked[k].claimable());
            for (object, aims) in &aimed {
                let (drawn, body) = (&self.objects.drawn[**object as usize], self.objects.body(**object));
                drawn.claim(&unpacked[k], &aims[k], body, &mut claims);
            }
            Ok(claims)
        })
    }

    /// The evidence about each object of the batch, by its number.
    pub fn into_evidence(self) -> impl Iterator<Item = (u32, Evidence)> {
        self.collectors.into_iter().map(|(i, collector)| (i, collector.into_evidence()))
    }
}

impl SurveyObjects {
    /// The evidence about every object from patches in memory, in the objects' order; so many are unpacked at once.
    pub fn evidence<P: AsRef<[u8]> + Sync>(
        &self,
        patches: &[P],
        at_once: usize,
        threads: Threads,
        interrupt: Interrupt,
    ) -> Result<Vec<Evidence>> {
        self.gathered(patches, at_once, None, threads, interrupt)
    }

    /// The same, and where all beams ended.
    pub fn evidence_and_sights<P: AsRef<[u8]> + Sync>(
        &self,
        patches: &[P],
        at_once: usize,
        threads: Threads,
        interrupt: Interrupt,
    ) -> Result<(Vec<Evidence>, Sights)> {
        let mut sights = Sights::default();
        let evidence = self.gathered(patches, at_once, Some(&mut sights), threads, interrupt)?;
        Ok((evidence, sights))
    }

    fn gathered<P: AsRef<[u8]> + Sync>(
        &self,
        patches: &[P],
        at_once: usize,
        mut sights: Option<&mut Sights>,
        threads: Threads,
        interrupt: Interrupt,
    ) -> Result<Vec<Evidence>> {
        let mut out = Vec::new();
        for batch in self.batches() {
            let mut verifier = Verifier::new(self, &batch, threads, interrupt)?;
            for some in patches.chunks(at_once.max(1)) {
                verifier.absorb(some, sights.as_deref_mut(), interrupt)?;
            }
            // Once is enough.
            sights = None;
            out.extend(verifier.into_evidence());
        }
        out.sort_by_key(|(object, _)| *object);
        Ok(out.into_iter().map(|(_, evidence)| evidence).collect())
    }
}
