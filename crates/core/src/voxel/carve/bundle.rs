//! Many rays of nearly one direction, carved together: slab by slab along an axis of the lattice into a dense bit map
//! that stays in the cache, a run of voxels at a time, and from there block by block into the tile.

use super::bitmap::{BitMap, DEPTH};
use super::fan::Fan;
use super::line::{SlabAxes, SlabLine};
use super::local_origin::LocalOrigin;
use super::ray::Ray;
use super::tile::CarvedTile;
use crate::geometry::Vec3;
use crate::num::whole::floor;
use crate::voxel::lattice::VoxelBox;
use crate::{Interrupt, Result, poll};

/// Rays that all lean towards one axis, to be carved together.
pub struct Bundle {
    axes: SlabAxes,
    origin: LocalOrigin,
    /// The voxels to be carved, counted from the origin.
    span: VoxelBox,
    lines: Vec<SlabLine>,
    /// Fills what need not be drawn, with the cell of each line.
    fan: Option<(Fan, Vec<usize>)>,
}

impl Bundle {
    /// Of rays that lean towards the axis of the slabs, carved as far as they lie in `span`; those of one place,
    /// neighbours a step apart (`raster`), may be filled between.
    pub fn new(
        rays: &[Ray],
        axes: SlabAxes,
        origin: LocalOrigin,
        span: &VoxelBox,
        raster: Option<(Vec3, f64)>,
    ) -> Self {
        let span = origin.span(span);
        let mut lines: Vec<SlabLine> = rays.iter().map(|r| axes.line(r, &span)).collect();
        let fan = raster.and_then(|(start, step)| Fan::new(&mut lines, &axes, &start, step));
        Self { axes, origin, span, lines, fan }
    }

    /// Carves it, slab by slab.
    pub fn carve(&self, tile: &mut CarvedTile, interrupt: Interrupt) -> Result<()> {
        let Some(ends) = self.ends() else { return Ok(()) };
        let mut map = BitMap::default();
        for number in floor(ends[0]).div_euclid(DEPTH)..=floor(ends[1]).div_euclid(DEPTH) {
            poll(interrupt)?;
            let slab = [number * DEPTH, (number + 1) * DEPTH];
            if self.fit(&mut map, slab) {
                self.draw(&mut map, slab);
                map.merge(tile, &self.axes, slab[0], &self.origin, interrupt)?;
            } else {
                for line in &self.lines {
                    self.carve_part(tile, line, slab, interrupt)?;
                }
            }
        }
        Ok(())
    }

    /// From where to where along the axis there is something to carve.
    fn ends(&self) -> Option<[f64; 2]> {
        let own = self.span.0[self.axes.along].map(|i| self.axes.sign * i as f64);
        let part = |l: &SlabLine| match self.fan {
            Some(_) => [l.from.max(own[0].min(own[1])), l.to.min(own[0].max(own[1]))],
            None => l.clipped,
        };
        let parts = self.lines.iter().map(part).filter(|[from, to]| from < to);
        parts.reduce(|[a, b], [from, to]| [a.min(from), b.max(to)])
    }

    /// Makes room for what lines pass through in a slab; `false` where that would be too much.
    fn fit(&self, map: &mut BitMap, slab: [i64; 2]) -> bool {
        let rows = match &self.fan {
            Some((fan, _)) => {
                let of_fan = fan.extent(slab.map(|i| i as f64));
                let rows = self.axes.across.map(|axis| self.span.0[axis]);
                [0, 1].map(|k| [of_fan[k][0].max(rows[k][0] - 1), of_fan[k][1].min(rows[k][1] + 1)])
            }
            None => extent(&self.lines, slab),
        };
        map.make_room(rows)
    }

    fn draw(&self, map: &mut BitMap, slab: [i64; 2]) {
        let Some((fan, cells)) = &self.fan else {
            for line in &self.lines {
                map.draw(line, [f64::NEG_INFINITY, f64::INFINITY], slab);
            }
            return;
        };
        for (ray, (line, &cell)) in self.lines.iter().zip(cells).enumerate() {
            let [near, from] = fan.drawn(ray, cell);
            if near > slab[0] as f64 {
                map.draw(line, [f64::NEG_INFINITY, near], slab);
            }
            if from < slab[1] as f64 && line.to > slab[0] as f64 {
                map.draw(line, [from.max(near), f64::INFINITY], slab);
            }
        }
        map.fill(fan, slab);
    }

    /// The part of a line inside a slab, voxel by voxel.
    fn carve_part(&self, tile: &mut CarvedTile, line: &SlabLine, slab: [i64; 2], interrupt: Interrupt) -> Result<()> {
        match line.within(slab) {
            None => poll(interrupt),
            Some([from, to]) => {
                let [start, stop] = [from, to].map(|along| self.axes.point(line, along));
                tile.carve_ray(&Ray { start, stop, part: 1.0 }, &self.origin, interrupt)
            }
        }
    }
}

/// First and last row across the axis that lines pass through in a slab, and one more on every side for rounding.
fn extent(lines: &[SlabLine], slab: [i64; 2]) -> [[i64; 2]; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for (line, [from, to]) in lines.iter().filter_map(|l| Some((l, l.within(slab)?))) {
        for k in 0..2 {
            let ends = [line.across(k, from), line.across(k, to)];
            low[k] = low[k].min(ends[0]).min(ends[1]);
            high[k] = high[k].max(ends[0]).max(ends[1]);
        }
    }
    [0, 1].map(|k| if low[k] <= high[k] { [floor(low[k]) - 1, floor(high[k]) + 1] } else { [0, -1] })
}
