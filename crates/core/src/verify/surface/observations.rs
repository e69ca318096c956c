//! The seen samples of an object with what was measured there: all that judging needs, whatever the level of accuracy.

use std::ops::Range;

use super::body::{EvidenceBody, mass_of};
use super::reading::SampleReading;
use super::station_shares::StationShares;
use crate::evidence::{LogCommonality, Mass};
use crate::geometry::Vec3;
use crate::num::sort::sort;
use crate::verify::evidence::{Evidence, SampleBlock};
use crate::verify::model::EvidenceModel;
use crate::{Grow, Interrupt, Result, poll, room};

/// A sample that enough beams told of.
#[derive(Debug, Clone, Copy)]
pub struct SeenSample {
    position_local: [f32; 3],
    pub face: u32,
    /// Its bodies of evidence in [`Observations`]; where there are none, its place among the beliefs.
    first: u32,
    bodies: u8,
    /// How many samples' worth of independent measurements, at most 1.
    pub independence: f32,
    /// Conflict between stations, at the tolerance that was asked.
    pub conflict: f32,
}

impl SeenSample {
    /// Local position, metres.
    pub fn position(&self) -> Vec3 {
        Vec3::from(self.position_local.map(f64::from))
    }
}

/// All seen samples of an object, face by face of each smooth surface.
#[derive(Debug)]
pub struct Observations {
    pub seen: Vec<SeenSample>,
    /// For each smooth surface its run in `seen`.
    pub surfaces: Vec<Range<usize>>,
    /// For each face its run in `seen`.
    pub faces: Vec<Range<usize>>,
    /// For each face.
    pub stations_of_face: Vec<StationShares>,
    /// Samples in front of which something was met by too few beams, or too unevenly, to call them seen.
    pub in_front_unseen: u64,
    bodies: Vec<EvidenceBody>,
    beliefs: Vec<LogCommonality>,
}

impl Observations {
    /// Reads every sample once.
    pub fn of(e: &Evidence, model: &EvidenceModel, interrupt: Interrupt) -> Result<Self> {
        let mut gathered = ObservationsBuilder::new(e, model);
        for (b, block) in e.samples.blocks.iter().enumerate() {
            if b % 16 == 0 {
                poll(interrupt)?;
            }
            gathered.add_block(b, block, interrupt)?;
        }
        let ObservationsBuilder { seen, stations_of_face, in_front_unseen, bodies, beliefs, .. } = gathered;
        let surface_of_face = &e.samples.surface_of_face;
        let seen = ordered(seen, surface_of_face, interrupt)?;
        let (surfaces, faces) = runs(&seen, surface_of_face);
        Ok(Self { seen, surfaces, faces, stations_of_face, in_front_unseen, bodies, beliefs })
    }

    /// The body that tells where the surface is, and its deviation; `None` where no beam met one. Metres.
    pub fn surface_body(&self, s: &SeenSample) -> Option<(&EvidenceBody, f64)> {
        EvidenceBody::on_surface(self.bodies_of(s))
    }

    /// Combined mass at `model`'s tolerance, and belief that a surface stands in front of the face.
    pub fn mass(&self, s: &SeenSample, model: &EvidenceModel) -> (Mass, f64) {
        match self.beliefs.get(s.first as usize) {
            Some(belief) if s.bodies == 0 => (belief.mass().unwrap_or(Mass::VACUOUS), 0.0),
            _ => mass_of(self.bodies_of(s), model),
        }
    }

    fn bodies_of(&self, s: &SeenSample) -> &[EvidenceBody] {
        match s.bodies {
            0 => &[],
            n => &self.bodies[s.first as usize..s.first as usize + usize::from(n)],
        }
    }
}

/// What was read so far, in the order of the samples.
struct ObservationsBuilder<'a> {
    evidence: &'a Evidence,
    /// By face.
    is_expected: Vec<bool>,
    model: &'a EvidenceModel,
    reading: SampleReading,
    seen: Vec<SeenSample>,
    stations_of_face: Vec<StationShares>,
    in_front_unseen: u64,
    bodies: Vec<EvidenceBody>,
    beliefs: Vec<LogCommonality>,
}

impl<'a> ObservationsBuilder<'a> {
    fn new(evidence: &'a Evidence, model: &'a EvidenceModel) -> Self {
        let faces = 0..evidence.samples.normals.len();
        Self {
            evidence,
            is_expected: faces.map(evidence.samples.expects()).collect(),
            model,
            reading: SampleReading::default(),
            seen: Vec::new(),
            stations_of_face: vec![StationShares::default(); evidence.samples.normals.len()],
            in_front_unseen: 0,
            bodies: Vec::new(),
            beliefs: Vec::new(),
        }
    }

    fn add_block(&mut self, b: usize, block: &SampleBlock, interrupt: Interrupt) -> Result<()> {
        let (samples, face) = (&self.evidence.samples, block.face as usize);
        // A leaf that stands elsewhere and a pane that beams pass are not expected to be seen.
        let is_expected = self.is_expected[face];
        self.stations_of_face[face].samples += if is_expected { u64::from(block.len) } else { 0 };
        let stations = self.evidence.stations_of_block(b);
        if stations.is_empty() {
            return Ok(());
        }
        for i in 0..block.len as usize {
            let at = block.start as usize + i;
            self.reading.read(&stations, i, &samples.position(at), &samples.normals[face], self.model);
            if self.reading.seen {
                self.stations_of_face[face].samples += u64::from(!is_expected);
                self.seen.grow(1, interrupt)?;
                self.bodies.grow(self.reading.bodies.len(), interrupt)?;
                self.push(samples.positions[at], block.face);
            } else {
                self.in_front_unseen +=
                    u64::from(EvidenceBody::on_surface(&self.reading.bodies).is_some_and(|(_, d)| d > 0.0));
            }
        }
        Ok(())
    }

    fn push(&mut self, position_local: [f32; 3], face: u32) {
        let reading = &self.reading;
        let first = if reading.belief.is_some() { self.beliefs.len() } else { self.bodies.len() } as u32;
        self.beliefs.extend(reading.belief);
        let bodies = reading.bodies.len().min(255);
        self.bodies.extend(&reading.bodies[..bodies]);
        for &(station, share) in &reading.shares {
            self.stations_of_face[face as usize].add_share(station as u32, share);
        }
        self.seen.push(SeenSample {
            position_local,
            face,
            first,
            bodies: bodies as u8,
            independence: reading.independence as f32,
            conflict: reading.conflict(self.model) as f32,
        });
    }
}

/// (Smooth surface, face) of a sample.
fn key(s: &SeenSample, surface_of_face: &[u32]) -> (u32, u32) {
    (surface_of_face[s.face as usize], s.face)
}

/// The samples by smooth surface, then by face.
fn ordered(seen: Vec<SeenSample>, surface_of_face: &[u32], interrupt: Interrupt) -> Result<Vec<SeenSample>> {
    let key = |s: &SeenSample| key(s, surface_of_face);
    // Samples come face by face; only the facets of curved surfaces lie apart.
    if seen.is_sorted_by_key(key) {
        return Ok(seen);
    }
    room::<[SeenSample; 2]>(seen.len(), interrupt)?;
    let mut order: Vec<_> = seen.iter().enumerate().map(|(i, s)| (key(s), i as u32)).collect();
    sort(&mut order, interrupt)?;
    let seen = order.into_iter().map(|(_, i)| seen[i as usize]).collect();
    poll(interrupt)?;
    Ok(seen)
}

/// The runs of each smooth surface and of each face.
fn runs(seen: &[SeenSample], surface_of_face: &[u32]) -> (Vec<Range<usize>>, Vec<Range<usize>>) {
    let surfaces = surface_of_face.iter().max().map_or(0, |s| *s as usize + 1);
    let (mut surface_runs, mut face_runs) = (vec![0..0; surfaces], vec![0..0; surface_of_face.len()]);
    let mut start = 0;
    while start < seen.len() {
        let (surface, face) = key(&seen[start], surface_of_face);
        let end = start + seen[start..].partition_point(|s| key(s, surface_of_face) == (surface, face));
        face_runs[face as usize] = start..end;
        let whole = &mut surface_runs[surface as usize];
        *whole = if whole.start == whole.end { start..end } else { whole.start..end };
        start = end;
    }
    (surface_runs, face_runs)
}
