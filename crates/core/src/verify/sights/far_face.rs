//! A face that stands farther off than its surface is looked for by the sums: a wall built 0.2 m beside its place.
//!
//! Where an object was not found, or without a number, its faces are held against where the beams of each station ended.
//! What another object explains is left out. What is left is the face, displaced, if it is as large (a fourth of what of
//! the face could have been seen there, and most of what is left), as flat, lies parallel to it, and does not go on beyond
//! its outline. What stands before a plane hides it, and says nothing against it.

use std::collections::BTreeSet;

use super::second_look::{Looked, Outlook, Owner, Sighted};
use super::sight_map::{Sight, SightMap};
use crate::geometry::{FaceKind, Vec3, perpendiculars};
use crate::num::stats::{MEDIAN_SD, median_and_spread};
use crate::verify::evidence::{Evidence, FoundFace};
use crate::verify::model::{EvidenceModel, RATHER, three_sigma};
use crate::{Interrupt, Result, poll_now_and_then};

/// Least share of a face, without what is hidden, that must be found.
const MIN_FOUND: f64 = 0.25;
/// The same before its place, where more stands that is not drawn.
const MIN_FOUND_BEFORE: f64 = 0.5;
/// Least share of a face that must be found, whatever is hidden.
const MIN_FOUND_OF_ALL: f64 = 0.1;
/// Least share of what was met in a plane or behind, and is nobody else's, that must lie in it.
const MIN_IN_PLANE: f64 = 0.6;
/// Or so many times as much as in any other: what stands about lies at all distances.
const TIMES_NEXT: f64 = 2.0;
/// Fewer samples are no face.
const MIN_SAMPLES: usize = 10;
/// Nor is what so few beams met.
const MIN_BEAMS: usize = 10;
/// Nor is less than this share of the object's samples.
const MIN_OF_OBJECT: f64 = 0.03;
/// Half as thick is a plane that was built, metres.
const FLAT_M: f64 = 0.015;
/// What is met this near to another drawn object may be it, metres.
const CLAIMED_M: f64 = 0.1;
/// A face is covered where another object's opposite face is drawn this near to it, metres.
const COVERED_M: f64 = 0.015;
/// Beside the outline it is asked so far off whether the surface goes on, metres; and farther by the width of a sight.
const BESIDE_M: f64 = 0.08;
/// A surface that goes on at more of these places is larger than the face.
const MAX_GOES_ON: f64 = 0.5;
/// Places beside each side of a face that are asked.
const PROBES_A_SIDE: usize = 8;

/// What one beam met near a face.
#[derive(Debug, Clone, Copy)]
struct Met {
    sample: usize,
    /// Along the outward normal, metres.
    height: f64,
    /// By which station's map.
    map: usize,
    /// Which beam: several samples may see the same.
    met_scanner: [u32; 3],
}

/// The faces of an object and where beams ended.
pub struct FarFaces<'a> {
    pub looked: &'a Looked<'a>,
    pub outlooks: &'a [Outlook<'a>],
    pub evidence: &'a Evidence,
    /// Of so many samples one is looked at.
    pub stride: usize,
}

impl FarFaces<'_> {
    /// The face of which most was found.
    pub fn find(&self, interrupt: Interrupt) -> Result<Option<FoundFace>> {
        let samples = &self.evidence.samples;
        let mut by_face = vec![Vec::new(); samples.normals.len()];
        for (round, (i, face)) in samples.face_of_each().enumerate().step_by(self.stride).enumerate() {
            poll_now_and_then(round, interrupt)?;
            by_face[face].push(i);
        }
        let all: usize = by_face.iter().map(Vec::len).sum();
        let mut best: Option<FoundFace> = None;
        for (face, of_face) in by_face.iter().enumerate() {
            let large = of_face.len() >= MIN_SAMPLES && of_face.len() as f64 >= MIN_OF_OBJECT * all as f64;
            if !large || !self.is_plane(face) || samples.kinds[face] != FaceKind::Fixed {
                continue;
            }
            let found = self.find_face(face, of_face, interrupt)?;
            best = best.into_iter().chain(found).max_by_key(|f| f.samples);
        }
        Ok(best)
    }

    /// Whether a face is no facet of a curved surface: of that one no distance of a facet tells.
    fn is_plane(&self, face: usize) -> bool {
        let surfaces = &self.evidence.samples.surface_of_face;
        surfaces.iter().filter(|s| **s == surfaces[face]).count() == 1
    }

    fn find_face(&self, face: usize, of_face: &[usize], interrupt: Interrupt) -> Result<Option<FoundFace>> {
        let normal = self.evidence.samples.normals[face];
        let mut met = Vec::new();
        for (round, &sample) in of_face.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            met.extend(self.met_at(sample, &normal));
        }
        let half = FLAT_M.max(three_sigma(self.looked.model));
        let (plane, others) = densest(met, half);
        let (count, all) = (plane.len() as f64, of_face.len() as f64);
        if plane.len() < MIN_SAMPLES || count < MIN_FOUND_OF_ALL * all || !stands_out(&plane, others, half) {
            return Ok(None);
        }
        let Some((deviation, sd)) = measured(&plane, self.looked.model) else { return Ok(None) };
        let hidden = self.hidden(of_face, &normal, deviation + 2.0 * half, interrupt)?;
        let least = if deviation > 0.0 { MIN_FOUND_BEFORE } else { MIN_FOUND };
        if count < least * (all - hidden as f64) {
            return Ok(None);
        }
        let model = self.looked.model;
        let is_far = deviation > model.band_in_front() - 2.0 * FLAT_M || deviation < 2.0 * FLAT_M - model.band_behind();
        if !is_far || self.goes_on(of_face, &normal, deviation, &plane) {
            return Ok(None);
        }
        let samples = (plane.len() * self.stride) as u32;
        Ok(Some(FoundFace { face: face as u32, deviation, sd, samples }))
    }

    /// Before how many samples of a face every beam that was sent there ended more than `above` metres in front of it.
    fn hidden(&self, of_face: &[usize], normal: &Vec3, above: f64, interrupt: Interrupt) -> Result<usize> {
        let mut hidden = 0;
        for (round, &sample) in of_face.iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            let place_world = self.evidence.samples.position(sample);
            let mut heights = self.outlooks.iter().filter_map(|o| self.ended(o.map, &place_world, normal)).peekable();
            hidden += usize::from(heights.peek().is_some() && heights.all(|height| height > above));
        }
        Ok(hidden)
    }

    /// How far in front of a place along `normal` the beam ended that a station before the face sent there, metres; minus
    /// infinity where nothing returned.
    fn ended(&self, map: &SightMap, place_world: &Vec3, normal: &Vec3) -> Option<f64> {
        let (sighted, beam) = self.beam(map, place_world, normal).filter(|(sighted, _)| sighted.side > 0.0)?;
        Some(beam.met().map_or(f64::NEG_INFINITY, |met| (met - sighted.place_scanner).dot(normal)))
    }

    /// The beam that a station sent towards a place, unless it would meet a face there too steeply.
    fn beam(&self, map: &SightMap, place_world: &Vec3, normal: &Vec3) -> Option<(Sighted, Sight)> {
        let sighted = self.looked.sighted(map, place_world, normal);
        let looks = sighted.cos >= self.looked.model.max_incidence.cos();
        let beam = looks.then(|| map.towards(&sighted.direction)).flatten()?;
        Some((sighted, beam))
    }

    /// What the nearest station met near a sample, that no other object explains.
    fn met_at(&self, sample: usize, normal: &Vec3) -> Option<Met> {
        let place_world = self.evidence.samples.position(sample);
        let mut nearest: Option<(f64, Met)> = None;
        for (map, Outlook { map: sights, may_meet }) in self.outlooks.iter().enumerate() {
            if !may_meet {
                continue;
            }
            let range = (place_world - sights.origin_world).norm();
            if nearest.as_ref().is_none_or(|n| range < n.0) {
                let met = self.height(sights, &place_world, normal);
                let met = met.map(|(height, met_scanner)| (range, Met { sample, height, map, met_scanner }));
                nearest = met.or(nearest);
            }
        }
        // What stands before a face that another object covers is rather that object, displaced.
        let is_covered = || (self.looked.is_anothers)(&place_world, normal, COVERED_M);
        nearest.map(|(_, met)| met).filter(|met| met.height <= 0.0 || !is_covered())
    }

    /// How far in front of a place along `normal` the beam ended that a station sent there, metres, and which beam it was;
    /// `None` where it tells nothing.
    fn height(&self, map: &SightMap, place_world: &Vec3, normal: &Vec3) -> Option<(f64, [u32; 3])> {
        let (Sighted { place_scanner, .. }, beam) = self.beam(map, place_world, normal)?;
        let met = beam.met()?;
        let height = (met - place_scanner).dot(normal);
        if height.abs() > self.looked.model.reach {
            return None;
        }
        let within = (height.abs() / RATHER).min(CLAIMED_M);
        let (met_world, direction) = (met + map.origin_world, met.normalize());
        let is_anothers = (self.looked.is_anothers)(&met_world, &direction, within);
        // Another part of the object, where it is drawn.
        let is_own = height.abs() > CLAIMED_M && (self.looked.owner)(&met_world, &direction) == Owner::Own;
        (!is_anothers && !is_own).then_some((height, beam.met_scanner.map(f32::to_bits)))
    }

    /// Whether the surface that was found goes on beyond the outline of the face.
    fn goes_on(&self, of_face: &[usize], normal: &Vec3, deviation: f64, plane: &[Met]) -> bool {
        let [u, w] = perpendiculars(normal);
        let places: Vec<Vec3> = of_face.iter().map(|i| self.evidence.samples.position(*i)).collect();
        let extent = |axis: &Vec3| {
            let along = places.iter().map(|p| p.dot(axis));
            along.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
        };
        let (in_u, in_w, height) = (extent(&u), extent(&w), places[0].dot(normal) + deviation);
        let maps: BTreeSet<usize> = plane.iter().map(|m| m.map).collect();
        let (mut on, mut asked) = (0u32, 0u32);
        for map in maps.into_iter().map(|m| self.outlooks[m].map) {
            let middle = u * (0.5 * (in_u.0 + in_u.1)) + w * (0.5 * (in_w.0 + in_w.1)) + normal * height;
            let beside = BESIDE_M + 1.5 * SightMap::CELL * (middle - map.origin_world).norm();
            for [x, y] in around(in_u, in_w, beside) {
                let place_world = u * x + w * y + normal * height;
                let met = self.height(map, &place_world, normal);
                asked += 1;
                on += u32::from(met.is_some_and(|(off, _)| off.abs() <= FLAT_M));
            }
        }
        f64::from(on) > MAX_GOES_ON * f64::from(asked)
    }
}

/// Places around a rectangle, so far beside it.
fn around(in_u: (f64, f64), in_w: (f64, f64), beside: f64) -> impl Iterator<Item = [f64; 2]> {
    (0..PROBES_A_SIDE).flat_map(move |k| {
        let part = (k as f64 + 0.5) / PROBES_A_SIDE as f64;
        let (x, y) = (in_u.0 + part * (in_u.1 - in_u.0), in_w.0 + part * (in_w.1 - in_w.0));
        [[x, in_w.0 - beside], [x, in_w.1 + beside], [in_u.0 - beside, y], [in_u.1 + beside, y]]
    })
}

/// Whether most of what was met in a plane and behind it lies in it, or it holds more than any other. What stands about
/// lies at all distances.
fn stands_out(plane: &[Met], others: Vec<Met>, half: f64) -> bool {
    let count = plane.len() as f64;
    let lowest = plane.first().map_or(0.0, |met| met.height);
    let behind = others.iter().filter(|met| met.height < lowest).count() as f64;
    count >= MIN_IN_PLANE * (count + behind) || count >= TIMES_NEXT * densest(others, half).0.len() as f64
}

/// Those whose heights lie within ± `half` metres of each other, most of them; and those farther off than as much again.
fn densest(mut met: Vec<Met>, half: f64) -> (Vec<Met>, Vec<Met>) {
    met.sort_by(|a, b| a.height.total_cmp(&b.height).then(a.sample.cmp(&b.sample)));
    let (mut best, mut end) = (0..0, 0);
    for start in 0..met.len() {
        while end < met.len() && met[end].height <= met[start].height + 2.0 * half {
            end += 1;
        }
        if end - start > best.len() {
            best = start..end;
        }
    }
    let plane = met[best].to_vec();
    if let (Some(first), Some(last)) = (plane.first(), plane.last()) {
        met.retain(|m| m.height < first.height - half || m.height > last.height + half);
    }
    (plane, met)
}

/// Median height and its standard deviation, metres, where enough beams tell: the beams' scatter, registration, and that
/// beams meet a face that is off beside the place of which they tell.
fn measured(plane: &[Met], model: &EvidenceModel) -> Option<(f64, f64)> {
    let mut heights: Vec<f64> = plane.iter().map(|m| m.height).collect();
    let (median, spread) = median_and_spread(&mut heights)?;
    let beams: BTreeSet<_> = plane.iter().map(|m| (m.map, m.met_scanner)).collect();
    if beams.len() < MIN_BEAMS {
        return None;
    }
    let random = MEDIAN_SD * spread / (beams.len() as f64).sqrt();
    let maps: BTreeSet<usize> = plane.iter().map(|m| m.map).collect();
    let share = |map: usize| plane.iter().filter(|m| m.map == map).count() as f64 / plane.len() as f64;
    let stations: f64 = maps.into_iter().map(|m| share(m).powi(2)).sum();
    Some((median, (random.powi(2) + model.common_variance(stations)).sqrt().hypot(model.second_order_sd(median))))
}
