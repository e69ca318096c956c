//! Beams of patches become occupancy.

use super::block::{Block, EDGE};
use super::blocks::block_of;
use super::grid::Span;
use super::march::march;
use super::occupancy::Occupancy;
use super::slab::{Base, Bundle, Frame, Ray};
use crate::geometry::Vec3;
use crate::scan::{Beam, Content, Header, Origins, Patch};
use crate::{Grow, Interrupt, Result, poll};

/// Beams that lean at most so far from an axis of the lattice (cosine) are carved together along it.
const LEAST_COS: f64 = 0.5;
/// Voxels of a lone ray between two looks at interrupt and memory.
const PIECE: f64 = 1024.0;
/// A beam stops this far before the voxel of its return, in voxels, lest rounding lets it into it.
const BEFORE: f64 = 1e-9;

impl Occupancy {
    /// Whether a patch can say anything of the tile, by its header alone.
    pub fn concerns(&self, header: &Header) -> bool {
        header.hull.overlaps(&self.grid.tile.expanded(self.grid.voxel))
    }

    /// Adds what a packed patch says: returns are counted, and what the beams pass on their way is empty.
    pub fn absorb(&mut self, patch: &[u8], interrupt: Interrupt) -> Result<()> {
        let header = Header::read(patch)?;
        if !self.concerns(&header) {
            return Ok(());
        }
        let (header, content) = Patch::beams_of(patch)?;
        let base = Base::at(self.grid.index(&header.origin)?);
        let rays = self.count_returns(&header, &content, &base, interrupt)?;
        if header.origins() != Origins::Unknown {
            let raster = (header.origins() == Origins::One && !self.grid.exact)
                .then(|| (base.local(&self.grid, &header.origin), f64::from(header.step)));
            let hull = [header.hull.min, header.hull.max].map(|corner| self.grid.index(&corner.into()));
            let [low, high] = [hull[0].clone()?, hull[1].clone()?];
            let span = self.span.common(&Span([0, 1, 2].map(|i| [low[i], high[i] + 1])));
            self.carve(rays, base, &span, raster, interrupt)?;
        }
        Ok(())
    }

    /// Counts the returns; the ways that say "empty".
    fn count_returns(
        &mut self,
        header: &Header,
        content: &Content,
        base: &Base,
        interrupt: Interrupt,
    ) -> Result<Vec<Ray>> {
        let (mut out, mut hits) = (Vec::with_capacity(content.len()), Vec::with_capacity(content.len()));
        // A beam of no length saw nothing; a point whose origin nobody knows may be its patch's.
        let saw = |beam: &Beam| header.origins() == Origins::Unknown || beam.offset != Vec3::zeros();
        for (i, beam) in content.beams.iter().enumerate().filter(|(_, beam)| saw(beam)) {
            let end = self.grid.index(&(header.origin + content.end(i)))?;
            if beam.returned && self.span.holds(end) {
                hits.push((block_of(end), Block::slot(end)));
            }
            let start = base.local(&self.grid, &(header.origin + content.start(i)));
            let last = beam.returned.then(|| [0, 1, 2].map(|axis| end[axis] - base.0[axis]));
            let way = self.way(beam, &start, last);
            out.extend(way.map(|(way, part)| Ray { start, stop: start + way, part }));
        }
        // Neighbours return from one block, mostly.
        for run in hits.chunk_by(|a, b| a.0 == b.0) {
            let block = self.block(run[0].0, interrupt)?;
            run.iter().for_each(|(_, slot)| block.hit(*slot, 1));
        }
        Ok(out)
    }

    /// From a beam's start to where it stops saying "empty", in voxels, and which part of its way that is; `last` is the
    /// voxel of its return.
    fn way(&self, beam: &Beam, start: &Vec3, last: Option<[i64; 3]>) -> Option<(Vec3, f64)> {
        let range = beam.offset.norm();
        if range <= 0.0 {
            return None;
        }
        let Some(last) = last else {
            let far = self.grid.no_return_range / (range * self.grid.voxel);
            return (far > 0.0).then_some((beam.offset * far, 1.0));
        };
        let way = beam.offset / self.grid.voxel;
        // The beam enters the voxel of its return where it has crossed the last of the three faces towards it.
        let enters = |axis: usize| {
            let low = last[axis] as f64;
            let face = if way[axis] > 0.0 { low } else { low + 1.0 };
            if way[axis] == 0.0 { 0.0 } else { (face - start[axis]) / way[axis] }
        };
        let enter = enters(0).max(enters(1)).max(enters(2)) - BEFORE * self.grid.voxel / range;
        let part = enter.min(1.0 - self.grid.margin / range);
        (part > 0.0).then_some((way * part, part))
    }

    /// Rays that lean towards one axis together, the others one by one. `span`: the voxels of the tile that lie in the hull
    /// of the beams; `raster`: their common origin and step.
    fn carve(
        &mut self,
        mut rays: Vec<Ray>,
        base: Base,
        span: &Span,
        raster: Option<(Vec3, f64)>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let sum: Vec3 = rays.iter().map(|r| r.stop - r.start).sum();
        let (axis, sign) = (sum.iamax(), sum[sum.iamax()].signum());
        let strays = rays.extract_if(.., |r| {
            let way = r.stop - r.start;
            way[axis] * sign <= 0.0 || way[axis].powi(2) < LEAST_COS.powi(2) * way.norm_squared()
        });
        let strays: Vec<Ray> = strays.collect();
        Bundle::new(&rays, Frame::new(axis, sign), base, span, raster).carve(self, interrupt)?;
        for ray in &strays {
            self.carve_alone(ray, &base, interrupt)?;
        }
        Ok(())
    }

    /// One ray, voxel by voxel, as far as it lies in the tile.
    pub(super) fn carve_alone(&mut self, ray: &Ray, base: &Base, interrupt: Interrupt) -> Result<()> {
        poll(interrupt)?;
        let Some(ray) = ray.clipped(&base.span(&self.span)) else { return Ok(()) };
        let way = ray.stop - ray.start;
        let pieces = (way.amax() / PIECE).ceil().max(1.0);
        for piece in 0..pieces as u64 {
            poll(interrupt)?;
            // Nothing can be refused on the way: a piece of a ray passes at most three voxels a step.
            self.blocks.grow(3 * PIECE as usize / EDGE as usize + 4, interrupt)?;
            let [from, to] = [piece, piece + 1].map(|i| ray.start + way * (i as f64 / pieces));
            march(&from, &to, |local| {
                let voxel = base.world(local);
                if self.span.holds(voxel) {
                    self.blocks.entry(block_of(voxel)).or_default().traverse(Block::slot(voxel));
                }
            });
        }
        Ok(())
    }
}
