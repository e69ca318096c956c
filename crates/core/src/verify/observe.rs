//! The seen samples of an object with what was measured there: all that judging needs, whatever the level of accuracy.

use super::evidence::Evidence;
use super::model::EvidenceModel;
use super::reading::{Body, Reading, mass_of};
use crate::evidence::{LogCommonality, Mass};
use crate::geometry::Vec3;
use crate::num::sort::sort;
use crate::{Grow, Interrupt, Result, poll, room};

/// A sample that enough beams spoke about.
#[derive(Debug, Clone, Copy)]
pub struct Seen {
    /// Local coordinates, metres.
    pub position: [f32; 3],
    pub face: u32,
    /// Its bodies of evidence in [`Observations::bodies`]; for the ray model its place in [`Observations::rays`].
    first: u32,
    bodies: u8,
    /// How many samples' worth of independent measurements, at most 1.
    pub independence: f32,
    /// Conflict between stations, at the tolerance that was asked.
    pub conflict: f32,
}

/// What one face, or one smooth surface, has in numbers before it is judged.
#[derive(Debug, Clone, Default)]
pub struct Heard {
    /// All samples.
    pub samples: u64,
    /// By station, the sum of its shares in the samples' deviations.
    shares: Vec<(u32, f64)>,
}

/// All seen samples of an object, face by face of each smooth surface.
#[derive(Debug, Default)]
pub struct Observations {
    pub seen: Vec<Seen>,
    /// For each smooth surface its run in `seen`.
    pub surfaces: Vec<std::ops::Range<usize>>,
    /// For each face its run in `seen`.
    pub faces: Vec<std::ops::Range<usize>>,
    pub heard: Vec<Heard>,
    /// Samples in front of which something was met by too few beams, or too unevenly, to call them seen.
    pub before_unseen: u64,
    bodies: Vec<Body>,
    rays: Vec<LogCommonality>,
}

impl Observations {
    /// Reads every sample once.
    pub fn of(e: &Evidence, model: &EvidenceModel, interrupt: Interrupt) -> Result<Self> {
        let mut out = Self { heard: vec![Heard::default(); e.samples.normals.len()], ..Self::default() };
        let mut reading = Reading::default();
        for (b, block) in e.samples.blocks.iter().enumerate() {
            if b % 16 == 0 {
                poll(interrupt)?;
            }
            let face = block.face as usize;
            out.heard[face].samples += u64::from(block.len);
            let heard = e.heard(b);
            if heard.is_empty() {
                continue;
            }
            let normal = &e.samples.normals[face];
            for i in 0..block.len as usize {
                let at = block.start as usize + i;
                reading.read(&heard, i, &e.samples.position(at), normal, model);
                if reading.seen {
                    out.seen.grow(1, interrupt)?;
                    out.bodies.grow(reading.bodies.len(), interrupt)?;
                    out.push(e.samples.positions[at], block.face, &reading, model);
                } else {
                    out.before_unseen += u64::from(Body::that_met(&reading.bodies).is_some_and(|b| b.deviation > 0.0));
                }
            }
        }
        out.sort(&e.samples.surface_of_face, interrupt)?;
        Ok(out)
    }

    fn push(&mut self, position: [f32; 3], face: u32, reading: &Reading, model: &EvidenceModel) {
        let first = if reading.rays.is_some() { self.rays.len() } else { self.bodies.len() } as u32;
        self.rays.extend(reading.rays);
        let bodies = reading.bodies.len().min(255);
        self.bodies.extend(&reading.bodies[..bodies]);
        for &(station, share) in &reading.shares {
            self.heard[face as usize].add_share(station as u32, share);
        }
        self.seen.push(Seen {
            position,
            face,
            first,
            bodies: bodies as u8,
            independence: reading.independence as f32,
            conflict: reading.conflict(model) as f32,
        });
    }

    /// Orders the samples by smooth surface, then by face.
    fn sort(&mut self, surface_of_face: &[u32], interrupt: Interrupt) -> Result<()> {
        let key = |s: &Seen| (surface_of_face[s.face as usize], s.face);
        // Samples come face by face; only the facets of curved surfaces lie apart.
        if !self.seen.is_sorted_by_key(key) {
            let place = |(i, s): (usize, &Seen)| (key(s), i as u32);
            room::<[Seen; 2]>(self.seen.len(), interrupt)?;
            let mut order: Vec<_> = self.seen.iter().enumerate().map(place).collect();
            sort(&mut order, interrupt)?;
            self.seen = order.into_iter().map(|(_, i)| self.seen[i as usize]).collect();
            poll(interrupt)?;
        }
        let surfaces = surface_of_face.iter().max().map_or(0, |s| *s as usize + 1);
        let (mut surface_runs, mut face_runs) = (vec![0..0; surfaces], vec![0..0; surface_of_face.len()]);
        let mut start = 0;
        while start < self.seen.len() {
            let (surface, face) = key(&self.seen[start]);
            let end = start + self.seen[start..].partition_point(|s| key(s) == (surface, face));
            face_runs[face as usize] = start..end;
            let whole = &mut surface_runs[surface as usize];
            *whole = if whole.start == whole.end { start..end } else { whole.start..end };
            start = end;
        }
        (self.surfaces, self.faces) = (surface_runs, face_runs);
        Ok(())
    }

    /// The body that tells where the surface is; `None` where no beam met one.
    pub fn surface_body(&self, s: &Seen) -> Option<&Body> {
        Body::that_met(self.bodies_of(s))
    }

    /// Combined mass at `model`'s tolerance, and belief that a surface stands in front of the face.
    pub fn mass(&self, s: &Seen, model: &EvidenceModel) -> (Mass, f64) {
        match self.rays.get(s.first as usize) {
            Some(rays) if s.bodies == 0 => (rays.mass().unwrap_or(Mass::VACUOUS), 0.0),
            _ => mass_of(self.bodies_of(s), model),
        }
    }

    fn bodies_of(&self, s: &Seen) -> &[Body] {
        match s.bodies {
            0 => &[],
            n => &self.bodies[s.first as usize..s.first as usize + usize::from(n)],
        }
    }

    /// Local position of a sample.
    pub fn position(s: &Seen) -> Vec3 {
        Vec3::from(s.position.map(f64::from))
    }
}

impl Heard {
    /// Share of each station in the mean deviation; they add up to 1.
    pub fn shares(&self) -> impl Iterator<Item = (usize, f64)> {
        let all: f64 = self.shares.iter().map(|s| s.1).sum();
        self.shares.iter().map(move |&(station, share)| (station as usize, share / all))
    }

    /// Variance that a mean over these samples shares: registration averages out over stations only, the model not.
    pub fn common_variance(&self, model: &EvidenceModel) -> f64 {
        let squares: f64 = if self.shares.is_empty() { 1.0 } else { self.shares().map(|(_, w)| w * w).sum() };
        model.sigma_station.powi(2) * squares + model.sigma_model.powi(2) + model.least_variance()
    }

    /// Adds what another face of the same surface heard.
    pub fn add(&mut self, other: &Self) {
        self.samples += other.samples;
        for &(station, share) in &other.shares {
            self.add_share(station, share);
        }
    }

    fn add_share(&mut self, station: u32, share: f64) {
        match self.shares.iter_mut().find(|s| s.0 == station) {
            Some(s) => s.1 += share,
            None => self.shares.push((station, share)),
        }
    }
}
