//! The built surface as points, fitted to the drawn one.

use std::collections::BTreeMap;

use nalgebra::Matrix3;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::vote::{Solution, Vote};
use crate::geometry::Vec3;
use crate::verify::evidence::{Evidence, StationEvidence, StationOrigin};
use crate::verify::model::{Sums, SurfaceReading, independence};
use crate::{Interrupt, Result, poll};

/// Points of the built surface used at the most: enough to average noise away, few enough to be quick.
const MAX_POINTS: usize = 6_000;
/// Samples of the drawn surface used at the most.
const MAX_SAMPLES: usize = 60_000;
/// Fewer points than this cannot improve on the faces' own offsets.
const MIN_POINTS: usize = 50;
/// Noise of one point, metres: what facets and sampling leave.
const POINT_SD_M: f64 = 0.002;
/// All points of a face together weigh as one vote of this, metres.
const FACE_SD_M: f64 = 3e-4;
/// Rounds of closest points.
const ROUNDS: usize = 12;
/// A smooth surface of as many facets is curved.
pub const MIN_FACETS: usize = 3;
/// A point is compared with drawn faces that look its way (cos 45°).
const MIN_TURN_COS: f64 = 0.7;

/// A point of the built surface.
#[derive(Debug)]
struct BuiltPoint {
    position_local: Vec3,
    /// The face that the beam was aimed at.
    face: u32,
    /// Its standard deviation, metres, as if it shared no beam with others.
    sd: f64,
    /// The station, which has all of its deviation.
    station: [(usize, f64); 1],
}

/// A drawn sample and its face.
type DesignPoint = GeomWithData<[f64; 3], u32>;

/// Points of the built surface near the drawn one, and the drawn samples (local coordinates of the evidence).
#[derive(Debug, Default)]
pub struct SurfacePoints {
    built: Vec<BuiltPoint>,
    as_designed: Vec<DesignPoint>,
    normals: Vec<Vec3>,
    surface_of_face: Vec<u32>,
}

impl SurfacePoints {
    /// Where each station met a surface: off each sample by the deviation along its normal.
    pub fn of(e: &Evidence, interrupt: Interrupt) -> Result<Self> {
        let samples = &e.samples;
        let stride = |n: usize, most: usize| n.div_ceil(most).max(1);
        let every_sample = stride(samples.len(), MAX_SAMPLES);
        let every_reading = stride(samples.len() * e.stations.len(), MAX_POINTS);
        let (mut built, mut as_designed) = (Vec::new(), Vec::new());
        let mut readings = 0;
        for (b, block) in samples.blocks.iter().enumerate() {
            poll(interrupt)?;
            let stations = e.stations_of_block(b);
            for k in 0..block.len as usize {
                let i = block.start as usize + k;
                if i.is_multiple_of(every_sample) {
                    as_designed.push(DesignPoint::new(samples.local(i).into(), block.face));
                }
                for (number, station, sums) in &stations {
                    readings += 1;
                    if readings % every_reading == 0 {
                        built.extend(BuiltPoint::of(e, i, block.face, (*number, station), &sums[k]));
                    }
                }
            }
        }
        let (normals, surface_of_face) = (samples.normals.clone(), samples.surface_of_face.clone());
        Ok(Self { built, as_designed, normals, surface_of_face })
    }

    /// Radius of the round parts of the drawn surface, metres: the slope of places on normals. `None` where it has
    /// none.
    pub fn lateral_radius(&self) -> Option<f64> {
        let mut facets = BTreeMap::new();
        self.surface_of_face.iter().for_each(|s| *facets.entry(*s).or_insert(0) += 1);
        let place = |d: &DesignPoint| (Vec3::from(*d.geom()), self.normals[d.data as usize]);
        let (mut along, mut turn) = (0.0, 0.0);
        for surface in facets.into_iter().filter(|(_, n)| *n >= MIN_FACETS).map(|(s, _)| s) {
            let is_of = move |d: &&DesignPoint| self.surface_of_face[d.data as usize] == surface;
            let of = || self.as_designed.iter().filter(is_of).map(place);
            let n = of().count().max(1) as f64;
            let (p, normal) = of().fold((Vec3::zeros(), Vec3::zeros()), |(p, q), (a, b)| (p + a / n, q + b / n));
            of().for_each(|(a, b)| along += (a - p).dot(&(b - normal)));
            of().for_each(|(_, b)| turn += (b - normal).norm_squared());
        }
        (turn > 0.0).then_some(along / turn).filter(|r| *r > 0.0)
    }

    /// Point-to-plane closest points (Chen & Medioni 1992), translation only, one vote a face: each point weighs
    /// the less, the more of its face there are. Metres.
    pub fn refine(&self, start: Vec3, projector: &Matrix3<f64>) -> Option<Solution> {
        if self.built.len() < MIN_POINTS {
            return None;
        }
        let tree = RTree::bulk_load(self.as_designed.clone());
        let mut per_face = vec![0f64; self.normals.len()];
        self.built.iter().for_each(|p| per_face[p.face as usize] += 1.0);
        let mut shift = start;
        let mut solution = None;
        for _ in 0..ROUNDS {
            let vote = |p| self.vote(p, &tree, &shift, per_face[p.face as usize]);
            let votes: Vec<Vote> = self.built.iter().filter_map(vote).collect();
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

    /// The offset of a point from the drawn surface that it is nearest to when moved back by `shift`.
    fn vote<'a>(
        &self,
        point: &'a BuiltPoint,
        tree: &RTree<DesignPoint>,
        shift: &Vec3,
        points_of_face: f64,
    ) -> Option<Vote<'a>> {
        let moved_local = point.position_local - shift;
        let looks = &self.normals[point.face as usize];
        let near = tree.nearest_neighbor_iter(&moved_local.into()).take(16);
        let mut fitting = near.filter(|d| self.normals[d.data as usize].dot(looks) >= MIN_TURN_COS);
        let nearest = fitting.next()?;
        let normal = self.normals[nearest.data as usize];
        let off = normal.dot(&(moved_local - Vec3::from(*nearest.geom())));
        Some(Vote {
            normal,
            offset: off + normal.dot(shift),
            weight_sd: FACE_SD_M * points_of_face.sqrt(),
            random_sd: point.sd,
            stations: &point.station,
        })
    }
}

impl BuiltPoint {
    /// Where a station met a surface around sample `i`, if it did.
    fn of(
        e: &Evidence,
        i: usize,
        face: u32,
        (number, station): (usize, &StationEvidence),
        sums: &Sums,
    ) -> Option<Self> {
        let r = SurfaceReading::of(sums).filter(|r| r.hit > 2.0 * r.through && r.hit > 1.0)?;
        let (sample_local, normal) = (e.samples.local(i), &e.samples.normals[face as usize]);
        let (sight, range) = match station.place {
            StationOrigin::At(origin) => {
                let sight = sample_local + e.samples.reference - origin;
                (sight.normalize(), sight.norm())
            }
            StationOrigin::Many | StationOrigin::Unknown => (-normal, 0.0),
        };
        // Sums count towards the scanner, and belong to the foot of what was met.
        let towards = if sight.dot(normal) <= 0.0 { *normal } else { -normal };
        let position_local = sample_local + towards * r.deviation;
        let cos = sight.dot(normal).abs();
        let sd = POINT_SD_M / independence(f64::from(station.step), range, cos, &e.model).sqrt();
        Some(Self { position_local, face, sd, station: [(number, 1.0)] })
    }
}
