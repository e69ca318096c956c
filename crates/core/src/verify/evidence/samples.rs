//! Samples: the points on a solid's faces at which belief is formed.

use super::spread::{sort_along_curve, spread};
use crate::geometry::{Closedness, FaceKind, Solid, Vec3, group_faces};
use crate::num::eigen;
use crate::{Grow, Interrupt, Result, poll_now_and_then};

/// Samples of one block at the most. Blocks are culled as a whole.
pub const BLOCK: usize = 64;
/// Most samples of one object, 2000 m² at 2 cm: keeps its evidence within PostgreSQL's 1 GB.
const MAX_SAMPLES: f64 = 5e6;

/// Slim solids measure less than this across: displaced by the 6 cm that happen on sites, a fourth of it is left where
/// it is drawn.
const SLIM_M: f64 = 0.25;

/// Samples by which it is told how slim a solid is, at the most; spread evenly over it.
const MAX_MEASURED: usize = 20_000;

/// Points spread evenly over a solid's surface, in blocks of neighbours on one face.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    /// World coordinates of the local origin, metres.
    pub(in crate::verify) reference: Vec3,
    /// Local coordinates, metres.
    pub(in crate::verify) positions: Vec<[f32; 3]>,
    /// Unit normal of each face.
    pub(in crate::verify) normals: Vec<Vec3>,
    /// The smooth surface that each face is a facet of.
    pub(in crate::verify) surface_of_face: Vec<u32>,
    /// What each face belongs to; older layouts do not tell, all are fixed.
    pub(in crate::verify) kinds: Vec<FaceKind>,
    /// In the order of the faces.
    pub(in crate::verify) blocks: Vec<SampleBlock>,
    /// The faces are seen from both sides (an open surface).
    pub(in crate::verify) two_sided: bool,
}

/// A run of samples on one face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleBlock {
    /// First sample.
    pub start: u32,
    /// Number of samples, 1 to [`BLOCK`].
    pub len: u32,
    /// Its face.
    pub face: u32,
}

impl Samples {
    /// The spacing that `solid` really gets: wider than asked on an object that would have more than five million.
    /// Metres.
    pub fn effective_spacing(solid: &Solid, spacing: f64) -> f64 {
        spacing.max((solid.area() / MAX_SAMPLES).sqrt())
    }

    /// Bytes that the samples on `solid` will take, at least. The spacing in metres.
    pub fn expected_memory(solid: &Solid, spacing: f64) -> usize {
        Self::expected(solid, spacing) as usize * size_of::<[f32; 3]>()
    }

    /// How many samples `solid` will have. The spacing in metres.
    pub fn expected(solid: &Solid, spacing: f64) -> f64 {
        (solid.area() / (spacing * spacing)).min(MAX_SAMPLES)
    }

    /// Spreads samples over `solid`, one for about every [`Samples::effective_spacing`]² of its area (m). A solid
    /// without area has none. The spacing in metres.
    pub fn on(solid: &Solid, spacing: f64, interrupt: Interrupt) -> Result<Self> {
        let spacing = Self::effective_spacing(solid, spacing);
        let faces = group_faces(solid, interrupt)?;
        let reference = solid.bounds().centre().map(|c| c.round());
        let mut by_face: Vec<Vec<Vec3>> = vec![Vec::new(); faces.normals.len()];
        spread(solid, &faces, spacing, interrupt, &mut by_face)?;
        let mut out = Self {
            reference,
            positions: Vec::new(),
            normals: faces.normals,
            surface_of_face: faces.surface_of_face,
            kinds: faces.kinds,
            blocks: Vec::new(),
            two_sided: solid.closedness() == Closedness::Open,
        };
        for (face, mut points) in by_face.into_iter().enumerate() {
            sort_along_curve(&mut points, &out.normals[face], spacing, interrupt)?;
            out.push_face(face as u32, &points, interrupt)?;
        }
        Ok(out)
    }

    /// Whether the solid is long and thin: across its longest extent it measures less than [`SLIM_M`].
    pub(in crate::verify) fn is_slim(&self) -> bool {
        // What is far from slim is known by few.
        let some = || self.positions.iter().step_by(self.positions.len().div_ceil(MAX_MEASURED).max(1));
        let n = some().count().max(1) as f64;
        let local = || some().map(|p| Vec3::from(p.map(f64::from)));
        let mean = local().sum::<Vec3>() / n;
        let covariance = local().map(|p| (p - mean) * (p - mean).transpose() / n).sum::<nalgebra::Matrix3<f64>>();
        let mut variances: [f64; 3] = eigen::of_three(covariance).eigenvalues.into();
        variances.sort_by(f64::total_cmp);
        // Of the hollow square of side a: a²/6.
        (6.0 * variances[1]).sqrt() < SLIM_M
    }

    fn push_face(&mut self, face: u32, points: &[Vec3], interrupt: Interrupt) -> Result<()> {
        for run in points.chunks(BLOCK) {
            poll_now_and_then(self.blocks.len(), interrupt)?;
            self.blocks.grow(1, interrupt)?;
            self.positions.grow(run.len(), interrupt)?;
            self.blocks.push(SampleBlock { start: self.positions.len() as u32, len: run.len() as u32, face });
            self.positions.extend(run.iter().map(|p| {
                let local = p - self.reference;
                [local.x as f32, local.y as f32, local.z as f32]
            }));
        }
        Ok(())
    }

    /// Whether some of the object may stand elsewhere, or lets beams pass.
    pub(in crate::verify) fn has_optional(&self) -> bool {
        self.kinds.iter().any(|kind| *kind != FaceKind::Fixed)
    }

    /// Whether a face is expected to be seen: one that is fixed, where the object has any.
    pub(in crate::verify) fn expects(&self) -> impl Fn(usize) -> bool + '_ {
        let has_fixed = self.kinds.contains(&FaceKind::Fixed);
        move |face| !has_fixed || self.kinds[face] == FaceKind::Fixed
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// World position of sample `i`, metres.
    pub fn position(&self, i: usize) -> Vec3 {
        self.reference + self.local(i)
    }

    /// Whether the samples are the same, wherever they were stored: older layouts know no smooth surfaces.
    pub(in crate::verify) fn are_those_of(&self, other: &Self) -> bool {
        self.reference == other.reference
            && self.positions == other.positions
            && self.normals == other.normals
            && self.blocks == other.blocks
            && self.two_sided == other.two_sided
    }

    /// Takes over surfaces and kinds that the other knows: there, faces have lower numbers than their own.
    pub(in crate::verify) fn join_surfaces(&mut self, other: &Self) {
        self.surface_of_face.iter_mut().zip(&other.surface_of_face).for_each(|(a, b)| *a = (*a).min(*b));
        if self.kinds.iter().all(|k| *k == FaceKind::Fixed) {
            self.kinds.clone_from(&other.kinds);
        }
    }

    /// The face of every sample, in order; counts as the faces of [`Evidence::faces`](super::Evidence::faces) do.
    pub fn face_of_each(&self) -> impl Iterator<Item = usize> {
        self.blocks.iter().flat_map(|b| std::iter::repeat_n(b.face as usize, b.len as usize))
    }

    /// Position of sample `i` from the local origin, metres.
    pub(in crate::verify) fn local(&self, i: usize) -> Vec3 {
        Vec3::from(self.positions[i].map(f64::from))
    }

    /// A ball around each block.
    pub(in crate::verify) fn balls(&self, interrupt: Interrupt) -> Result<Vec<(Vec3, f64)>> {
        let ball = |(i, b)| poll_now_and_then(i, interrupt).map(|()| self.ball(b));
        self.blocks.iter().enumerate().map(ball).collect()
    }

    /// Centre (local) and radius of a ball around a block.
    fn ball(&self, block: &SampleBlock) -> (Vec3, f64) {
        let range = block.start as usize..(block.start + block.len) as usize;
        let centre = range.clone().map(|i| self.local(i)).sum::<Vec3>() / f64::from(block.len);
        let radius = range.map(|i| (self.local(i) - centre).norm()).fold(0.0, f64::max);
        (centre, radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;

    #[test]
    fn as_many_as_the_area_asks_for_whatever_the_mesh() {
        for (solid, what) in [
            (Solid::cuboid([0.0; 3], [4.0, 0.2, 3.0]).unwrap(), "cuboid"),
            (Solid::cylinder([1e6, 6e6, 0.0], 0.2, 3.0, 200).unwrap(), "fine cylinder"),
        ] {
            let s = Samples::on(&solid, 0.02, NEVER).unwrap();
            let expected = solid.area() / 4e-4;
            assert!((s.len() as f64 - expected).abs() <= 2.0, "{what}: {} of {expected}", s.len());
            assert_eq!(s.blocks.iter().map(|b| b.len as usize).sum::<usize>(), s.len());
        }
    }

    #[test]
    fn samples_lie_on_the_surface_and_are_even() {
        let solid = Solid::cuboid([0.0; 3], [1.0, 1.0, 1.0]).unwrap();
        let s = Samples::on(&solid, 0.05, NEVER).unwrap();
        let mut mean = Vec3::zeros();
        for i in 0..s.len() {
            let p = s.position(i);
            let off = p.iter().map(|c| c.abs().min((c - 1.0).abs())).fold(f64::INFINITY, f64::min);
            assert!(off < 1e-6 && p.iter().all(|c| (-1e-6..=1.0 + 1e-6).contains(c)));
            mean += p / s.len() as f64;
        }
        assert!((mean - Vec3::repeat(0.5)).norm() < 0.01, "{mean}");
        for b in &s.blocks {
            assert!(s.ball(b).1 < 0.6);
        }
    }

    #[test]
    fn limits() {
        let tiny = Solid::cuboid([0.0; 3], [1e-3; 3]).unwrap();
        assert_eq!(Samples::on(&tiny, 0.02, NEVER).unwrap().len(), 1);
        let large = Solid::cuboid([0.0; 3], [60.0, 40.0, 0.3]).unwrap();
        let n = Samples::on(&large, 0.02, NEVER).unwrap().len() as f64;
        assert!((n - MAX_SAMPLES).abs() < 10.0, "{n}");
        let flat = Solid::new(vec![Vec3::zeros(), Vec3::x(), Vec3::x() * 2.0], vec![[0, 1, 2]]).unwrap();
        assert!(Samples::on(&flat, 0.02, NEVER).unwrap().is_empty());
        assert_eq!(Samples::on(&tiny, 0.02, &|| true), Err(crate::Error::Interrupted));
    }
}
