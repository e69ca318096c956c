//! Both epochs at every sample that both saw.

use super::epoch::Epoch;
use super::state::{MetSurface, SampleState};
use super::thresholds::{SAME_PLACE_M, SAME_SIGMAS};
use crate::verify::evidence::{Evidence, Samples};
use crate::{Grow, Interrupt, Result, poll, poll_now_and_then};

/// How the samples of an object, or of one of its smooth surfaces, divide.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PairedSamples {
    /// All samples.
    pub samples: u64,
    /// Samples that both epochs saw.
    pub seen_in_both: u64,
    /// Of these: the object is there in both.
    pub kept: u64,
    /// Of the kept: its surface is not where it was.
    pub displaced: u64,
    /// It was there before, and its place is empty now.
    pub lost: u64,
    /// Its place was empty before, and it is there now.
    pub won: u64,
    /// Its place is empty in both.
    pub empty: u64,
}

impl PairedSamples {
    /// Samples that say something in both epochs.
    pub fn compared(&self) -> u64 {
        self.shown() + self.empty
    }

    /// Samples where the object shows in either epoch.
    pub fn shown(&self) -> u64 {
        self.kept + self.lost + self.won
    }

    fn add_pair(&mut self, old: SampleState, new: SampleState) {
        use SampleState::{Empty, Open, There};
        self.seen_in_both += 1;
        match (old, new) {
            (There(old), There(new)) => {
                self.kept += 1;
                self.displaced += u64::from(old.zip(new).is_some_and(|(a, b)| !is_same_place(&a, &b)));
            }
            (There(_), Empty) => self.lost += 1,
            (Empty, There(_)) => self.won += 1,
            (Empty, Empty) => self.empty += 1,
            (Open, _) | (_, Open) => {}
        }
    }
}

/// Whether two epochs met one surface in one place, as far as they know.
fn is_same_place(a: &MetSurface, b: &MetSurface) -> bool {
    let variance = a.random_variance + a.common_variance + b.random_variance + b.common_variance;
    (a.deviation - b.deviation).abs() <= (SAME_SIGMAS * variance.sqrt()).max(SAME_PLACE_M)
}

/// How far a face's surface was met from where it had been.
#[derive(Debug, Clone, Default)]
pub struct FaceDifference {
    /// New deviation less old one at each sample that shows the object in both epochs, metres.
    pub differences: Vec<f64>,
    /// Sum of the variances of the beams' noise in them, m².
    pub noise: f64,
    /// How many independent measurements they are worth.
    pub independent: f64,
}

impl FaceDifference {
    fn add_pair(&mut self, old: &MetSurface, new: &MetSurface) {
        self.differences.push(new.deviation - old.deviation);
        self.noise += old.random_variance + new.random_variance;
        self.independent += old.independence.min(new.independence);
    }
}

/// Everything that two epochs say together.
pub struct Paired {
    pub all: PairedSamples,
    /// For each smooth surface.
    pub surfaces: Vec<PairedSamples>,
    /// For each face.
    pub faces: Vec<FaceDifference>,
    /// How many samples' worth of independent measurements they are, of the epoch that has fewer.
    pub independent: f64,
}

impl Paired {
    /// Brings two epochs of one object together.
    pub fn of(old: &Epoch, new: &Epoch, interrupt: Interrupt) -> Result<Self> {
        let samples = &old.evidence.samples;
        let count = samples.surface_of_face.iter().max().map_or(0, |s| *s as usize + 1);
        let mut out = Self {
            all: PairedSamples { samples: samples.len() as u64, ..PairedSamples::default() },
            surfaces: vec![PairedSamples::default(); count],
            faces: vec![FaceDifference::default(); samples.normals.len()],
            independent: 0.0,
        };
        for block in &samples.blocks {
            out.surfaces[samples.surface_of_face[block.face as usize] as usize].samples += u64::from(block.len);
        }
        for face in 0..samples.normals.len() {
            poll(interrupt)?;
            for (i, (at_old, at_new)) in seen_by_both(old, new, samples, face).enumerate() {
                poll_now_and_then(i, interrupt)?;
                out.faces[face].differences.grow(1, interrupt)?;
                out.add_pair(samples, face, old.state(at_old), new.state(at_new));
                out.independent += old.independence(at_old).min(new.independence(at_new));
            }
        }
        Ok(out)
    }

    fn add_pair(&mut self, samples: &Samples, face: usize, old: SampleState, new: SampleState) {
        self.all.add_pair(old, new);
        self.surfaces[samples.surface_of_face[face] as usize].add_pair(old, new);
        if let (SampleState::There(Some(old)), SampleState::There(Some(new))) = (old, new) {
            self.faces[face].add_pair(&old, &new);
        }
    }
}

/// The seen samples of a face that are the same in both epochs. Both lists follow the order of the object's samples.
fn seen_by_both<'a>(
    old: &'a Epoch,
    new: &'a Epoch,
    samples: &'a Samples,
    face: usize,
) -> impl Iterator<Item = (usize, usize)> + 'a {
    let [runs_old, runs_new] = [old, new].map(|e| e.fitted.observations.faces[face].clone());
    let (mut at_old, mut at_new) = (runs_old.start, runs_new.start);
    samples_of_face(old.evidence, face).filter_map(move |i| {
        let place = samples.local(i);
        let is_old = at_old < runs_old.end && old.position(at_old) == place;
        let is_new = at_new < runs_new.end && new.position(at_new) == place;
        let pair = (is_old && is_new).then_some((at_old, at_new));
        at_old += usize::from(is_old);
        at_new += usize::from(is_new);
        pair
    })
}

/// Numbers of a face's samples, in order: blocks follow the order of the faces.
fn samples_of_face(e: &Evidence, face: usize) -> std::ops::Range<usize> {
    let blocks = &e.samples.blocks;
    let first = blocks.partition_point(|b| (b.face as usize) < face);
    let last = blocks.partition_point(|b| (b.face as usize) <= face);
    let start = |b: usize| blocks.get(b).map_or(e.samples.len(), |b| b.start as usize);
    start(first)..start(last)
}
