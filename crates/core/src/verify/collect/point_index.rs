//! Which samples a point without a beam concerns: those of the face nearest to it.

use nalgebra::Matrix3;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, PointDistance, RTree};

use crate::geometry::{Aabb, Vec3};
use crate::verify::aim::NearFace;
use crate::verify::evidence::Samples;
use crate::verify::model::{KERNEL_SPACINGS, PointTouch, same_surface};
use crate::{Interrupt, Result, poll_now_and_then};

/// A point whose own standard deviation along the normal is more than this part of the search band tells nothing: where
/// in the band it lies would be chance.
const MAX_SD: f64 = 0.5;

type BlockBox = GeomWithData<Rectangle<[f64; 3]>, u32>;

/// The boxes of all blocks of samples (local coordinates), for search.
#[derive(Debug)]
pub struct PointIndex {
    tree: RTree<BlockBox>,
    /// Distance of the samples, metres.
    sample_spacing: f64,
}

/// A point, local metres.
#[derive(Debug, Clone, Copy)]
pub struct LocalPoint {
    pub position_local: Vec3,
    /// Its own covariance, m²; zero where the model's σ is to stand for it.
    pub covariance: Matrix3<f64>,
    /// Width of its kernel: the distance of such points, metres.
    pub spacing: f64,
}

impl LocalPoint {
    /// A point whose uncertainty is the model's. Metres.
    pub fn exact(position_local: Vec3, spacing: f64) -> Self {
        Self { position_local, covariance: Matrix3::zeros(), spacing }
    }
}

impl PointIndex {
    /// Boxes every block.
    pub fn of(samples: &Samples, sample_spacing: f64, interrupt: Interrupt) -> Result<Self> {
        let mut boxes = Vec::with_capacity(samples.blocks.len());
        for (i, block) in samples.blocks.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            let points: Vec<Vec3> = (0..block.len as usize).map(|k| samples.local(block.start as usize + k)).collect();
            let b = Aabb::around(&points);
            boxes.push(BlockBox::new(Rectangle::from_corners(b.min, b.max), i as u32));
        }
        Ok(Self { tree: RTree::bulk_load(boxes), sample_spacing })
    }

    /// The face nearest to a point, if the point lies in front of it by at most `in_front` metres or behind it by at most
    /// `behind`, and is known well enough to say so.
    pub fn near_face(&self, samples: &Samples, point: &LocalPoint, (in_front, behind): (f64, f64)) -> Option<NearFace> {
        let reach = in_front.max(behind);
        let point_local = point.position_local;
        let (nearest, normal) = self.nearest(samples, &point_local, reach + point.spacing)?;
        let off = point_local - nearest;
        let height = normal.dot(&off);
        // Samples are no farther apart than this: what is nearer to one lies above the face.
        let beside = Some((off - normal * height).norm()).filter(|b| *b > self.sample_spacing).unwrap_or(0.0);
        let sd = normal.dot(&(point.covariance * normal)).max(0.0).sqrt();
        let is_near = (-behind..=in_front).contains(&height) && sd <= MAX_SD * reach;
        is_near.then_some(NearFace { normal, height, beside })
    }

    /// Calls `visit(block, sample within it, touch)` for every sample around the foot of `point` on the face nearest to
    /// it.
    pub fn gather(
        &self,
        samples: &Samples,
        point: &LocalPoint,
        face: &NearFace,
        mut visit: impl FnMut(u32, usize, &PointTouch),
    ) {
        let point_local = point.position_local;
        let variance = face.normal.dot(&(point.covariance * face.normal)).max(0.0);
        let foot_local = point_local - face.normal * face.height;
        let radius = KERNEL_SPACINGS * point.spacing;
        let (low, high) = (foot_local.map(|c| c - radius), foot_local.map(|c| c + radius));
        for found in self.tree.locate_in_envelope_intersecting(&AABB::from_corners(low.into(), high.into())) {
            let block = samples.blocks[found.data as usize];
            let normal = samples.normals[block.face as usize];
            for k in 0..block.len as usize {
                let sample_local = samples.local(block.start as usize + k);
                let v = foot_local - sample_local;
                let across = v - normal * normal.dot(&v);
                let lateral_squared = across.norm_squared();
                let lateral = lateral_squared.sqrt();
                if lateral_squared > radius * radius || !same_surface(&v, lateral, &face.normal, &normal) {
                    continue;
                }
                let weight = (-lateral_squared / point.spacing.powi(2)).exp2();
                let touch = PointTouch { weight, deviation: face.height, variance, point_local, sample_local, normal };
                visit(found.data, k, &touch);
            }
        }
    }

    /// The nearest sample within `reach`, and its normal.
    fn nearest(&self, samples: &Samples, point_local: &Vec3, reach: f64) -> Option<(Vec3, Vec3)> {
        let at: [f64; 3] = (*point_local).into();
        let mut best = (reach * reach, None);
        for found in self.tree.nearest_neighbor_iter(&at) {
            if found.distance_2(&at) > best.0 {
                break;
            }
            let block = samples.blocks[found.data as usize];
            for k in 0..block.len as usize {
                let q = samples.local(block.start as usize + k);
                let off = (q - point_local).norm_squared();
                if off < best.0 {
                    best = (off, Some((q, samples.normals[block.face as usize])));
                }
            }
        }
        best.1
    }
}
