//! The built surface as points, fitted to the drawn one.

use std::collections::BTreeMap;

use nalgebra::Matrix3;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::evidence::{Evidence, Place};
use super::reading::independence;
use super::shift::{MIN_FACETS, Solution, Vote};
use super::surface_sums::SurfaceReading;
use crate::geometry::Vec3;
use crate::{Interrupt, Result, poll};

/// Points used at the most, and samples of the drawn surface: enough to average noise away, few enough to be quick.
const MAX_POINTS: usize = 6_000;
const MAX_SAMPLES: usize = 60_000;
/// Fewer points than this cannot better the faces' own offsets.
const MIN_POINTS: usize = 50;
/// Noise of one point, metres: what facets and sampling leave.
const POINT_SD_M: f64 = 0.002;
/// Rounds of closest points.
const ROUNDS: usize = 12;
/// A point is compared with drawn faces that look its way (cos 45°).
const MIN_TURN_COS: f64 = 0.7;

/// A point of the built surface.
#[derive(Debug)]
struct Point {
    position: Vec3,
    /// The face that the beam was aimed at.
    face: u32,
    /// Its standard deviation, metres, as if it shared no beam with others.
    sd: f64,
    /// The station, which has all of its deviation.
    station: [(usize, f64); 1],
}

type Drawn = GeomWithData<[f64; 3], u32>;

/// Points of the built surface near the drawn one, and the drawn samples (local coordinates of the evidence).
#[derive(Debug, Default)]
pub struct SurfacePoints {
    built: Vec<Point>,
    drawn: Vec<Drawn>,
    normals: Vec<Vec3>,
    surface_of_face: Vec<u32>,
}

impl SurfacePoints {
    /// Where each station met a surface: off each sample by the deviation along its normal.
    pub(super) fn of(e: &Evidence, interrupt: Interrupt) -> Result<Self> {
        let samples = &e.samples;
        let stride = |n: usize, most: usize| n.div_ceil(most).max(1);
        let (every_drawn, every_built) =
            (stride(samples.len(), MAX_SAMPLES), stride(samples.len() * e.stations.len(), MAX_POINTS));
        let mut out = Self {
            normals: samples.normals.clone(),
            surface_of_face: samples.surface_of_face.clone(),
            ..Self::default()
        };
        let mut counter = 0;
        for (b, block) in samples.blocks.iter().enumerate() {
            poll(interrupt)?;
            let normal = &samples.normals[block.face as usize];
            let heard = e.heard(b);
            for k in 0..block.len as usize {
                let i = block.start as usize + k;
                let local = samples.local(i);
                if i.is_multiple_of(every_drawn) {
                    out.drawn.push(Drawn::new(local.into(), block.face));
                }
                for (number, station, sums) in &heard {
                    counter += 1;
                    let reading = SurfaceReading::of(&sums[k]).filter(|r| r.hit > 2.0 * r.through && r.hit > 1.0);
                    if let (true, Some(r)) = (counter % every_built == 0, reading) {
                        let (sight, range) = match station.place {
                            Place::At(origin) => {
                                let sight = local + samples.reference - origin;
                                (sight.normalize(), sight.norm())
                            }
                            Place::Many | Place::Unknown => (-normal, 0.0),
                        };
                        // Sums count towards the scanner, and belong to the foot of what was met.
                        let towards = if sight.dot(normal) <= 0.0 { *normal } else { -normal };
                        let position = local + towards * r.deviation;
                        let cos = sight.dot(normal).abs();
                        let sd = POINT_SD_M / independence(station, range, cos, &e.model).sqrt();
                        out.built.push(Point { position, face: block.face, sd, station: [(*number, 1.0)] });
                    }
                }
            }
        }
        Ok(out)
    }

    /// Radius of the round parts of the drawn surface, metres: the slope of places on normals. `None` where it has none.
    pub(super) fn mantle_radius(&self) -> Option<f64> {
        let mut facets = BTreeMap::new();
        self.surface_of_face.iter().for_each(|s| *facets.entry(*s).or_insert(0) += 1);
        let place = |d: &Drawn| (Vec3::from(*d.geom()), self.normals[d.data as usize]);
        let (mut along, mut turn) = (0.0, 0.0);
        for surface in facets.into_iter().filter(|(_, n)| *n >= MIN_FACETS).map(|(s, _)| s) {
            let of = || self.drawn.iter().filter(move |d| self.surface_of_face[d.data as usize] == surface).map(place);
            let n = of().count().max(1) as f64;
            let (p, normal) = of().fold((Vec3::zeros(), Vec3::zeros()), |(p, q), (a, b)| (p + a / n, q + b / n));
            of().for_each(|(a, b)| along += (a - p).dot(&(b - normal)));
            of().for_each(|(_, b)| turn += (b - normal).norm_squared());
        }
        (turn > 0.0).then_some(along / turn).filter(|r| *r > 0.0)
    }

    /// Point-to-plane closest points (Chen & Medioni 1992), translation only, one vote a face: each point weighs
    /// the less, the more of its face there are.
    pub(super) fn refine(&self, start: Vec3, projector: &Matrix3<f64>) -> Option<Solution> {
        if self.built.len() < MIN_POINTS {
            return None;
        }
        let tree = RTree::bulk_load(self.drawn.clone());
        let mut per_face = vec![0f64; self.normals.len()];
        self.built.iter().for_each(|p| per_face[p.face as usize] += 1.0);
        let mut shift = start;
        let mut solution = None;
        for _ in 0..ROUNDS {
            let votes: Vec<Vote> = self
                .built
                .iter()
                .filter_map(|Point { position, face, sd: random_sd, station }| {
                    let moved = position - shift;
                    let looks = &self.normals[*face as usize];
                    let near = tree.nearest_neighbor_iter(&moved.into()).take(16);
                    let mut fitting = near.filter(|d| self.normals[d.data as usize].dot(looks) >= MIN_TURN_COS);
                    let drawn = fitting.next()?;
                    let normal = self.normals[drawn.data as usize];
                    let off = normal.dot(&(moved - Vec3::from(*drawn.geom())));
                    // A face's points together weigh as one vote of 0.3 mm.
                    let sd = 3e-4 * per_face[*face as usize].sqrt();
                    let offset = off + normal.dot(&shift);
                    Some(Vote { normal, offset, weight_sd: sd, random_sd: *random_sd, stations: station })
                })
                .collect();
            let next = Solution::of(&votes, projector)?;
            let step = (next.vector - shift).norm();
            shift = next.vector;
            solution = Some(next);
            if step < 1e-5 {
                break;
            }
        }
        solution
    }
}
