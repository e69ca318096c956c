//! The beams of a patch carved into a tile.

use super::bundle::Bundle;
use super::line::SlabAxes;
use super::local_origin::LocalOrigin;
use super::ray::Ray;
use super::tile::CarvedTile;
use crate::geometry::Vec3;
use crate::scan::{Beam, Beams, Origins, Patch, PatchHeader};
use crate::voxel::lattice::bits::slot_of;
use crate::voxel::lattice::block_map::block_of;
use crate::voxel::lattice::{Grid, VoxelBox};
use crate::{Interrupt, Result};

/// Beams that lean at most so far from an axis of the lattice (cosine) are carved together along it.
const MIN_COS: f64 = 0.5;
/// A beam stops this far before the voxel of its return, in voxels, lest rounding lets it into it.
const BEFORE: f64 = 1e-9;

/// Whether a patch can say anything of a grid's tile, by its header alone.
pub fn concerns(grid: &Grid, header: &PatchHeader) -> bool {
    header.hull.overlaps(&grid.tile.expanded(grid.voxel))
}

/// Adds what a packed patch says: returns are counted, and what the beams pass on their way is empty.
pub fn absorb(tile: &mut CarvedTile, patch: &[u8], interrupt: Interrupt) -> Result<()> {
    let grid = tile.grid;
    if !concerns(grid, &PatchHeader::read(patch)?) {
        return Ok(());
    }
    let (header, content) = Patch::beams_of(patch)?;
    let origin = LocalOrigin::at(grid.index(&header.origin)?);
    let rays = count_returns(tile, &header, &content, &origin, interrupt)?;
    if header.origins() != Origins::Unknown {
        let raster = (header.origins() == Origins::One && !grid.exact)
            .then(|| (origin.local(grid, &header.origin), header.spacing.angle()));
        let hull = [header.hull.min, header.hull.max].map(|corner| grid.index(&corner.into()));
        let [low, high] = [hull[0].clone()?, hull[1].clone()?];
        let span = tile.span.common(&VoxelBox::between(low, high));
        carve_rays(tile, rays, origin, &span, raster, interrupt)?;
    }
    Ok(())
}

/// Counts the returns; the ways that say "empty".
fn count_returns(
    tile: &mut CarvedTile,
    header: &PatchHeader,
    content: &Beams,
    origin: &LocalOrigin,
    interrupt: Interrupt,
) -> Result<Vec<Ray>> {
    let grid = tile.grid;
    let (mut out, mut hits) = (Vec::with_capacity(content.len()), Vec::with_capacity(content.len()));
    // A beam of no length saw nothing; a point whose origin nobody knows may be its patch's.
    let saw = |beam: &Beam| header.origins() == Origins::Unknown || beam.offset != Vec3::zeros();
    for (i, beam) in content.beams.iter().enumerate().filter(|(_, beam)| saw(beam)) {
        let end = grid.index(&(header.origin + content.end(i)))?;
        if beam.returned && tile.span.holds(end) {
            hits.push((block_of(end), slot_of(end)));
        }
        let start = origin.local(grid, &(header.origin + content.start(i)));
        let last = beam.returned.then(|| [0, 1, 2].map(|axis| end[axis] - origin.0[axis]));
        let way = empty_way(grid, beam, &start, last);
        out.extend(way.map(|(way, part)| Ray { start, stop: start + way, part }));
    }
    // Neighbours return from one block, mostly.
    for run in hits.chunk_by(|a, b| a.0 == b.0) {
        let block = tile.block(run[0].0, interrupt)?;
        run.iter().for_each(|(_, slot)| block.hit(*slot, 1));
    }
    Ok(out)
}

/// From a beam's start to where it stops saying "empty", in voxels, and which part of its way that is; `last` is the
/// voxel of its return.
fn empty_way(grid: &Grid, beam: &Beam, start: &Vec3, last: Option<[i64; 3]>) -> Option<(Vec3, f64)> {
    let range = beam.offset.norm();
    if range <= 0.0 {
        return None;
    }
    let Some(last) = last else {
        let far = grid.no_return_range / (range * grid.voxel);
        return (far > 0.0).then_some((beam.offset * far, 1.0));
    };
    let way = beam.offset / grid.voxel;
    // The beam enters the voxel of its return where it has crossed the last of the three faces towards it.
    let enters = |axis: usize| {
        let low = last[axis] as f64;
        let face = if way[axis] > 0.0 { low } else { low + 1.0 };
        if way[axis] == 0.0 { 0.0 } else { (face - start[axis]) / way[axis] }
    };
    let enter = enters(0).max(enters(1)).max(enters(2)) - BEFORE * grid.voxel / range;
    let part = enter.min(1.0 - grid.margin / range);
    (part > 0.0).then_some((way * part, part))
}

/// Rays that lean towards one axis together, the others one by one. `span`: the voxels of the tile that lie in the hull
/// of the beams; `raster`: where all start, and their step.
fn carve_rays(
    tile: &mut CarvedTile,
    mut rays: Vec<Ray>,
    origin: LocalOrigin,
    span: &VoxelBox,
    raster: Option<(Vec3, f64)>,
    interrupt: Interrupt,
) -> Result<()> {
    let sum: Vec3 = rays.iter().map(|r| r.stop - r.start).sum();
    let (axis, sign) = (sum.iamax(), sum[sum.iamax()].signum());
    let strays = rays.extract_if(.., |r| {
        let way = r.stop - r.start;
        way[axis] * sign <= 0.0 || way[axis].powi(2) < MIN_COS.powi(2) * way.norm_squared()
    });
    let strays: Vec<Ray> = strays.collect();
    Bundle::new(&rays, SlabAxes::new(axis, sign), origin, span, raster).carve(tile, interrupt)?;
    for ray in &strays {
        tile.carve_ray(ray, &origin, interrupt)?;
    }
    Ok(())
}
