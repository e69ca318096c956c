//! Which samples a point without a beam concerns: those of the face nearest to it.

use nalgebra::Matrix3;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, PointDistance, RTree};

use super::sample::Samples;
use super::surface_sums::{KERNEL_SPACINGS, same_surface};
use crate::geometry::{Aabb, Vec3};
use crate::{Interrupt, Result, poll_now_and_then};

/// A point whose own standard deviation along the normal is more than this part of the search band says nothing: where
/// in the band it lies would be chance.
const MOST_SD: f64 = 0.5;

type BlockBox = GeomWithData<Rectangle<[f64; 3]>, u32>;

/// The boxes of all blocks of samples (local coordinates), for search.
#[derive(Debug)]
pub struct PointIndex {
    tree: RTree<BlockBox>,
}

/// A point, local metres.
#[derive(Debug, Clone, Copy)]
pub struct LocalPoint {
    pub position: Vec3,
    /// Its own covariance, m²; zero where the model's σ is to stand for it.
    pub covariance: Matrix3<f64>,
    /// Width of its kernel: the distance of such points, metres.
    pub spacing: f64,
}

/// What a point says at one sample.
#[derive(Debug, Clone, Copy)]
pub struct Touch {
    pub block: u32,
    /// Sample within the block.
    pub k: usize,
    /// Kernel weight, 1 at the foot of the point.
    pub weight: f64,
    /// Signed deviation along the outward normal, metres, and the point's variance along it, m².
    pub deviation: f64,
    pub variance: f64,
}

impl PointIndex {
    /// Boxes every block.
    pub fn of(samples: &Samples, interrupt: Interrupt) -> Result<Self> {
        let mut boxes = Vec::with_capacity(samples.blocks.len());
        for (i, block) in samples.blocks.iter().enumerate() {
            poll_now_and_then(i, interrupt)?;
            let points: Vec<Vec3> = (0..block.len as usize).map(|k| samples.local(block.start as usize + k)).collect();
            let b = Aabb::around(&points);
            boxes.push(BlockBox::new(Rectangle::from_corners(b.min, b.max), i as u32));
        }
        Ok(Self { tree: RTree::bulk_load(boxes) })
    }

    /// Calls `speak` for every sample around the foot of `point` on the nearest face, if that is within `reach` metres:
    /// in front of it by at most `in_front`, behind it by at most `behind`.
    pub fn gather(
        &self,
        samples: &Samples,
        point: &LocalPoint,
        (in_front, behind): (f64, f64),
        mut speak: impl FnMut(&Touch),
    ) {
        let reach = in_front.max(behind);
        let Some((nearest, normal)) = self.nearest(samples, &point.position, reach + point.spacing) else { return };
        let height = normal.dot(&(point.position - nearest));
        if !(-behind..=in_front).contains(&height) {
            return;
        }
        let foot = point.position - normal * height;
        let radius = KERNEL_SPACINGS * point.spacing;
        let (low, high) = (foot.map(|c| c - radius), foot.map(|c| c + radius));
        let variance = normal.dot(&(point.covariance * normal)).max(0.0);
        if variance.sqrt() > MOST_SD * reach {
            return;
        }
        for found in self.tree.locate_in_envelope_intersecting(&AABB::from_corners(low.into(), high.into())) {
            let block = samples.blocks[found.data as usize];
            let here = samples.normals[block.face as usize];
            for k in 0..block.len as usize {
                let v = foot - samples.local(block.start as usize + k);
                let across = v - here * here.dot(&v);
                let lateral_squared = across.norm_squared();
                if lateral_squared > radius * radius || !same_surface(&v, lateral_squared.sqrt(), &normal, &here) {
                    continue;
                }
                let weight = (-lateral_squared / point.spacing.powi(2)).exp2();
                speak(&Touch { block: found.data, k, weight, deviation: height, variance });
            }
        }
    }

    /// The nearest sample within `reach`, and its normal.
    fn nearest(&self, samples: &Samples, p: &Vec3, reach: f64) -> Option<(Vec3, Vec3)> {
        let at: [f64; 3] = (*p).into();
        let mut best = (reach * reach, None);
        for found in self.tree.nearest_neighbor_iter(&at) {
            if found.distance_2(&at) > best.0 {
                break;
            }
            let block = samples.blocks[found.data as usize];
            for k in 0..block.len as usize {
                let q = samples.local(block.start as usize + k);
                let off = (q - p).norm_squared();
                if off < best.0 {
                    best = (off, Some((q, samples.normals[block.face as usize])));
                }
            }
        }
        best.1
    }
}
