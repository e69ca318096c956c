//! Samples: the points on a solid's faces at which belief is formed.

use crate::error::Result;
use crate::geometry::{Faces, Solid, Vec3, group_faces};
use crate::num::sort::sort;
use crate::{Grow, Interrupt, poll_now_and_then, room};

/// Samples of one block at the most. Blocks are culled as a whole.
pub const BLOCK: usize = 64;
/// Most samples of one object, 2000 m² at 2 cm: keeps its evidence within PostgreSQL's 1 GB.
const MAX_SAMPLES: f64 = 5e6;

/// Slim solids measure less than this across: displaced by the 6 cm that happen on sites, a fourth of it is left where it
/// is drawn.
const SLIM_M: f64 = 0.25;

/// Points spread evenly over a solid's surface, in blocks of neighbours on one face.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    /// World coordinates of the local origin, metres.
    pub(super) reference: Vec3,
    /// Local coordinates, metres.
    pub(super) positions: Vec<[f32; 3]>,
    /// Unit normal of each face.
    pub(super) normals: Vec<Vec3>,
    /// The smooth surface that each face is a facet of.
    pub(super) surface_of_face: Vec<u32>,
    pub(super) blocks: Vec<Block>,
    /// The faces are seen from both sides (an open surface).
    pub(super) two_sided: bool,
}

/// A run of samples on one face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// First sample.
    pub start: u32,
    /// Number of samples, 1 to [`BLOCK`].
    pub len: u32,
    /// Its face.
    pub face: u32,
}

impl Samples {
    /// The spacing that `solid` really gets: wider than asked on an object that would have more than five million.
    pub fn effective_spacing(solid: &Solid, spacing: f64) -> f64 {
        spacing.max((solid.area() / MAX_SAMPLES).sqrt())
    }

    /// Bytes that the samples on `solid` will take, at least.
    pub fn expected_memory(solid: &Solid, spacing: f64) -> usize {
        (solid.area() / (spacing * spacing)).min(MAX_SAMPLES) as usize * size_of::<[f32; 3]>()
    }

    /// Spreads samples over `solid`, one for about every [`Samples::effective_spacing`]² of its area (m). A solid
    /// without area has none.
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
            blocks: Vec::new(),
            two_sided: solid.closedness() == crate::geometry::Closedness::Open,
        };
        for (face, mut points) in by_face.into_iter().enumerate() {
            sort_along_curve(&mut points, &out.normals[face], spacing, interrupt)?;
            out.push_face(face as u32, &points, interrupt)?;
        }
        Ok(out)
    }

    /// Whether the solid is long and thin: across its longest extent it measures less than [`SLIM_M`].
    pub(super) fn is_slim(&self) -> bool {
        let n = self.positions.len().max(1) as f64;
        let local = || self.positions.iter().map(|p| Vec3::from(p.map(f64::from)));
        let mean = local().sum::<Vec3>() / n;
        let covariance = local().map(|p| (p - mean) * (p - mean).transpose() / n).sum::<nalgebra::Matrix3<f64>>();
        let mut variances: [f64; 3] = crate::num::eigen::of_three(covariance).eigenvalues.into();
        variances.sort_by(f64::total_cmp);
        // Of the hollow square of side a: a²/6.
        (6.0 * variances[1]).sqrt() < SLIM_M
    }

    fn push_face(&mut self, face: u32, points: &[Vec3], interrupt: Interrupt) -> Result<()> {
        for run in points.chunks(BLOCK) {
            poll_now_and_then(self.blocks.len(), interrupt)?;
            self.blocks.grow(1, interrupt)?;
            self.positions.grow(run.len(), interrupt)?;
            self.blocks.push(Block { start: self.positions.len() as u32, len: run.len() as u32, face });
            self.positions.extend(run.iter().map(|p| {
                let local = p - self.reference;
                [local.x as f32, local.y as f32, local.z as f32]
            }));
        }
        Ok(())
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
    pub(super) fn are_those_of(&self, other: &Self) -> bool {
        self.reference == other.reference
            && self.positions == other.positions
            && self.normals == other.normals
            && self.blocks == other.blocks
            && self.two_sided == other.two_sided
    }

    /// Takes over surfaces that the other knows: there, faces have lower numbers than their own.
    pub(super) fn join_surfaces(&mut self, other: &Self) {
        self.surface_of_face.iter_mut().zip(&other.surface_of_face).for_each(|(a, b)| *a = (*a).min(*b));
    }

    /// The face of every sample, in order; counts as the faces of [`super::Evidence::faces`] do.
    pub fn face_of_each(&self) -> impl Iterator<Item = usize> {
        self.blocks.iter().flat_map(|b| std::iter::repeat_n(b.face as usize, b.len as usize))
    }

    pub(super) fn local(&self, i: usize) -> Vec3 {
        Vec3::from(self.positions[i].map(f64::from))
    }

    /// A ball around each block.
    pub(super) fn balls(&self, interrupt: Interrupt) -> Result<Vec<(Vec3, f64)>> {
        let ball = |(i, b)| poll_now_and_then(i, interrupt).map(|()| self.ball(b));
        self.blocks.iter().enumerate().map(ball).collect()
    }

    /// Centre (local) and radius of a ball around a block.
    fn ball(&self, block: &Block) -> (Vec3, f64) {
        let range = block.start as usize..(block.start + block.len) as usize;
        let centre = range.clone().map(|i| self.local(i)).sum::<Vec3>() / f64::from(block.len);
        let radius = range.map(|i| (self.local(i) - centre).norm()).fold(0.0, f64::max);
        (centre, radius)
    }
}

/// Spreads points over each triangle by its area. What a triangle owes or has too much is carried to the next
/// (error diffusion), so that a fine mesh gets as many samples as a coarse one.
fn spread(solid: &Solid, faces: &Faces, spacing: f64, interrupt: Interrupt, out: &mut [Vec<Vec3>]) -> Result<()> {
    let mut owed = 0.5;
    for (t, &face) in faces.of_triangle.iter().enumerate() {
        if face == Faces::NONE {
            continue;
        }
        poll_now_and_then(t, interrupt)?;
        let [a, b, c] = solid.corners(t);
        owed += 0.5 * (b - a).cross(&(c - a)).norm() / (spacing * spacing);
        let n = owed.floor();
        owed -= n;
        for i in 0..n as u64 {
            poll_now_and_then(i as usize, interrupt)?;
            let (u, v) = r2(i);
            // Fold the unit square onto the triangle.
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let points = &mut out[face as usize];
            points.grow(1, interrupt)?;
            points.push(a + (b - a) * u + (c - a) * v);
        }
    }
    if out.iter().all(Vec::is_empty) {
        // An object smaller than one sample is still an object.
        if let Some((t, &face)) = faces.of_triangle.iter().enumerate().find(|(_, f)| **f != Faces::NONE) {
            let [a, b, c] = solid.corners(t);
            out[face as usize].push((a + b + c) / 3.0);
        }
    }
    Ok(())
}

/// M. Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018): the R₂ sequence, evenly spread.
fn r2(i: u64) -> (f64, f64) {
    const PLASTIC: f64 = 1.324_717_957_244_746;
    let at = |alpha: f64| (0.5 + (i + 1) as f64 * alpha).fract();
    (at(1.0 / PLASTIC), at(1.0 / (PLASTIC * PLASTIC)))
}

/// Orders points along a Hilbert curve in the face's plane, so that a block is compact.
fn sort_along_curve(points: &mut Vec<Vec3>, normal: &Vec3, spacing: f64, interrupt: Interrupt) -> Result<()> {
    let drop = normal.iamax();
    let (i, j) = ((drop + 1) % 3, (drop + 2) % 3);
    let low = points.iter().fold([f64::INFINITY; 2], |l, p| [l[0].min(p[i]), l[1].min(p[j])]);
    let cell = |x: f64, lo: f64| ((x - lo) / spacing) as u32;
    let mut order = Vec::new();
    order.grow(points.len(), interrupt)?;
    for (k, p) in points.iter().enumerate() {
        poll_now_and_then(k, interrupt)?;
        order.push((hilbert(cell(p[i], low[0]), cell(p[j], low[1])), k as u32));
    }
    sort(&mut order, interrupt)?;
    room::<Vec3>(points.len(), interrupt)?;
    *points = order.into_iter().map(|(_, k)| points[k as usize]).collect();
    Ok(())
}

/// Place of a cell along the Hilbert curve of order 32 (Hamilton & Rau-Chaplin's rotation form).
fn hilbert(mut x: u32, mut y: u32) -> u64 {
    let mut place = 0u64;
    for bit in (0..32).rev() {
        let (rx, ry) = (x >> bit & 1, y >> bit & 1);
        place = place << 2 | u64::from((3 * rx) ^ ry);
        if ry == 0 {
            if rx == 1 {
                (x, y) = (!x, !y);
            }
            (x, y) = (y, x);
        }
    }
    place
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
    fn hilbert_visits_every_cell_and_only_steps_to_neighbours() {
        let mut cells: Vec<(u32, u32)> = (0..64).flat_map(|x| (0..64).map(move |y| (x, y))).collect();
        cells.sort_by_key(|&(x, y)| hilbert(x, y));
        assert!(cells.windows(2).all(|w| w[0].0.abs_diff(w[1].0) + w[0].1.abs_diff(w[1].1) == 1));
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
