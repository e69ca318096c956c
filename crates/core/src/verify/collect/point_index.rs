//! Which samples a point without a beam concerns: those around its foot.

use nalgebra::Matrix3;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::geometry::{Aabb, Vec3};
use crate::verify::aim::NearFace;
use crate::verify::evidence::Samples;
use crate::verify::model::{KERNEL_SPACINGS, PointTouch, same_surface};
use crate::{Interrupt, Result, poll_now_and_then};

type BlockBox = GeomWithData<Rectangle<[f64; 3]>, u32>;

/// The boxes of all blocks of samples (local coordinates), for search.
#[derive(Debug)]
pub struct PointIndex {
    tree: RTree<BlockBox>,
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
}
