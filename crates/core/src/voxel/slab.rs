//! Many rays of nearly one direction, carved together: slab by slab along an axis of the lattice into a dense bit map
//! that stays in the cache, a run of voxels at a time, and from there block by block into the occupancy.

use super::block::EDGE;
use super::blocks::{Bits, block_of};
use super::fan::Fan;
use super::grid::{Grid, Span};
use super::occupancy::Occupancy;
use crate::geometry::Vec3;
use crate::{Interrupt, Result, poll};

/// Voxels of a slab along its axis: a row of the bit map is one word.
const DEPTH: i64 = 64;
/// Most rows of a slab's bit map (8 bytes each); beyond, rays are so far apart that they are carved one by one.
const MOST_ROWS: i64 = 1 << 20;

/// The greatest whole number that is not greater. `f64::floor` is a call into the C library where the processor's own
/// instruction may not be taken for granted.
#[inline]
pub fn floor(x: f64) -> i64 {
    let cut = x as i64;
    cut - i64::from(x < cut as f64)
}

/// The least whole number that is not less.
#[inline]
pub fn ceil(x: f64) -> i64 {
    let cut = x as i64;
    cut + i64::from(x > cut as f64)
}

/// A voxel near the patch, from which its coordinates are counted; a multiple of 64 on every axis.
#[derive(Debug, Clone, Copy)]
pub struct Base(pub [i64; 3]);

impl Base {
    /// Near a voxel.
    pub fn at(voxel: [i64; 3]) -> Self {
        Self(voxel.map(|i| i.div_euclid(DEPTH) * DEPTH))
    }

    /// A point in voxels from here.
    pub fn local(&self, grid: &Grid, world: &Vec3) -> Vec3 {
        Vec3::from_fn(|i, _| world[i] / grid.voxel - self.0[i] as f64)
    }

    /// Number of the voxel that has the number `local` from here.
    pub fn world(&self, local: [i64; 3]) -> [i64; 3] {
        [0, 1, 2].map(|i| local[i] + self.0[i])
    }

    /// Voxels counted from here.
    pub fn span(&self, span: &Span) -> Span {
        Span([0, 1, 2].map(|i| span.0[i].map(|v| v - self.0[i])))
    }
}

/// A way through empty space, in voxels from a [`Base`].
#[derive(Debug, Clone, Copy)]
pub struct Ray {
    /// Where it begins.
    pub start: Vec3,
    /// Where it stops.
    pub stop: Vec3,
    /// Part of the way to its return at which it stops.
    pub part: f64,
}

impl Ray {
    /// The part inside a box of voxels.
    pub fn clipped(&self, tile: &Span) -> Option<Self> {
        let way = self.stop - self.start;
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for axis in 0..3 {
            let faces = tile.0[axis].map(|i| i as f64);
            let [a, b] = faces.map(|face| (face - self.start[axis]) / way[axis]);
            if way[axis] != 0.0 {
                (from, to) = (from.max(a.min(b)), to.min(a.max(b)));
            } else if self.start[axis] < faces[0] || self.start[axis] >= faces[1] {
                return None;
            }
        }
        (from < to).then(|| Self { start: self.start + way * from, stop: self.start + way * to, part: self.part })
    }
}

/// A ray along the slabs' axis: its other two coordinates as functions of the first, which grows.
#[derive(Debug, Clone, Copy)]
pub struct Line {
    from: f64,
    /// Where it stops along the axis.
    pub to: f64,
    /// Where its return lies along the axis.
    pub end: f64,
    at: [f64; 2],
    /// Its other two coordinates a voxel along the axis.
    pub slope: [f64; 2],
    /// 1 / slope; infinite for a line that stays in its row.
    pace: [f64; 2],
    /// The part of it inside the tile.
    shown: [f64; 2],
}

/// The three axes of a bundle: along it, and across it in the order that blocks store them.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    /// The slabs' axis.
    pub along: usize,
    /// The other two.
    pub across: [usize; 2],
    /// Lines run with the axis or against it.
    pub sign: f64,
}

impl Frame {
    /// For rays that all lean towards `sign` × the axis `along`.
    pub fn new(along: usize, sign: f64) -> Self {
        let across = match along {
            0 => [1, 2],
            1 => [0, 2],
            _ => [0, 1],
        };
        Self { along, across, sign }
    }

    fn mirrored(&self) -> bool {
        self.sign < 0.0
    }

    /// A ray as a line, and its part inside a tile (voxels from the base).
    fn line(&self, ray: &Ray, tile: &Span) -> Line {
        let (from, to) = (self.sign * ray.start[self.along], self.sign * ray.stop[self.along]);
        let at = self.across.map(|k| ray.start[k]);
        let slope = self.across.map(|k| (ray.stop[k] - ray.start[k]) / (to - from));
        let pace = slope.map(f64::recip);
        let own = tile.0[self.along].map(|i| self.sign * i as f64);
        let mut shown = [from.max(own[0].min(own[1])), to.min(own[0].max(own[1]))];
        for k in 0..2 {
            let faces = tile.0[self.across[k]].map(|i| i as f64);
            if slope[k] != 0.0 {
                let [a, b] = faces.map(|face| from + (face - at[k]) * pace[k]);
                shown = [shown[0].max(a.min(b)), shown[1].min(a.max(b))];
            } else if at[k] < faces[0] || at[k] >= faces[1] {
                shown[1] = f64::NEG_INFINITY;
            }
        }
        Line { from, to, end: from + (to - from) / ray.part, at, slope, pace, shown }
    }
}

impl Line {
    /// Square of its length a voxel along the axis.
    pub fn length_squared(&self) -> f64 {
        1.0 + self.slope[0].powi(2) + self.slope[1].powi(2)
    }

    /// Stops so many voxels (of its own length) earlier.
    pub fn stop_before(&mut self, voxels: f64) {
        self.to = (self.to - voxels / self.length_squared().sqrt()).max(self.from);
        self.shown[1] = self.shown[1].min(self.to);
    }

    fn across(&self, k: usize, along: f64) -> f64 {
        self.at[k] + self.slope[k] * (along - self.from)
    }

    /// Where it leaves the row of voxels numbered `row` on the axis across `k`.
    fn leaves(&self, k: usize, row: i64) -> f64 {
        let face = if self.slope[k] > 0.0 { row + 1 } else { row };
        if self.slope[k] == 0.0 { f64::INFINITY } else { self.from + (face as f64 - self.at[k]) * self.pace[k] }
    }

    /// The part inside the tile and a slab.
    fn within(&self, slab: [i64; 2]) -> Option<[f64; 2]> {
        let part = [self.shown[0].max(slab[0] as f64), self.shown[1].min(slab[1] as f64)];
        (part[0] < part[1]).then_some(part)
    }
}

/// Rays that all lean towards one axis, to be carved together.
pub struct Bundle {
    frame: Frame,
    base: Base,
    /// Voxels from the base.
    tile: Span,
    lines: Vec<Line>,
    /// Fills what need not be drawn, with the cell of each line.
    fan: Option<(Fan, Vec<usize>)>,
}

impl Bundle {
    /// Of rays that lean towards a frame's axis; those of one `origin`, neighbours a `step` apart, may be filled between.
    pub fn new(rays: &[Ray], frame: Frame, base: Base, span: &Span, raster: Option<(Vec3, f64)>) -> Self {
        let tile = base.span(span);
        let mut lines: Vec<Line> = rays.iter().map(|r| frame.line(r, &tile)).collect();
        let fan = raster.and_then(|(origin, step)| Fan::new(&mut lines, &frame, &origin, step));
        Self { frame, base, tile, lines, fan }
    }

    /// Carves it, slab by slab.
    pub fn carve(&self, occupancy: &mut Occupancy, interrupt: Interrupt) -> Result<()> {
        let Some(ends) = self.ends() else { return Ok(()) };
        let mut map = BitMap::default();
        for number in floor(ends[0]).div_euclid(DEPTH)..=floor(ends[1]).div_euclid(DEPTH) {
            poll(interrupt)?;
            let slab = [number * DEPTH, (number + 1) * DEPTH];
            if self.fit(&mut map, slab) {
                self.draw(&mut map, slab);
                map.merge(occupancy, &self.frame, slab[0], &self.base, interrupt)?;
            } else {
                for line in &self.lines {
                    self.carve_part(occupancy, line, slab, interrupt)?;
                }
            }
        }
        Ok(())
    }

    /// From where to where along the axis there is something to carve.
    fn ends(&self) -> Option<[f64; 2]> {
        let own = self.tile.0[self.frame.along].map(|i| self.frame.sign * i as f64);
        let part = |l: &Line| match self.fan {
            Some(_) => [l.from.max(own[0].min(own[1])), l.to.min(own[0].max(own[1]))],
            None => l.shown,
        };
        let parts = self.lines.iter().map(part).filter(|[from, to]| from < to);
        parts.reduce(|[a, b], [from, to]| [a.min(from), b.max(to)])
    }

    /// Makes room for what lines pass through in a slab; `false` where that would be too much.
    fn fit(&self, map: &mut BitMap, slab: [i64; 2]) -> bool {
        let rows = match &self.fan {
            Some((fan, _)) => {
                let of_fan = fan.extent(slab.map(|i| i as f64));
                let tile = self.frame.across.map(|axis| self.tile.0[axis]);
                [0, 1].map(|k| [of_fan[k][0].max(tile[k][0] - 1), of_fan[k][1].min(tile[k][1] + 1)])
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
    fn carve_part(&self, occupancy: &mut Occupancy, line: &Line, slab: [i64; 2], interrupt: Interrupt) -> Result<()> {
        match line.within(slab) {
            None => poll(interrupt),
            Some([from, to]) => {
                let point = |along: f64| {
                    let mut p = Vec3::zeros();
                    p[self.frame.along] = self.frame.sign * along;
                    (0..2).for_each(|k| p[self.frame.across[k]] = line.across(k, along));
                    p
                };
                occupancy.carve_alone(&Ray { start: point(from), stop: point(to), part: 1.0 }, &self.base, interrupt)
            }
        }
    }
}

/// First and last row across the axis that lines pass through in a slab, and one more on every side for rounding.
fn extent(lines: &[Line], slab: [i64; 2]) -> [[i64; 2]; 2] {
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

/// A slab of voxels, in rows along the axis and, where a fan filled it, in rows across it.
#[derive(Debug, Default)]
struct BitMap {
    /// First row on either axis across, a multiple of 8.
    first: [i64; 2],
    /// Rows on either axis, multiples of 8.
    size: [i64; 2],
    /// A word a row along the axis.
    words: Vec<u64>,
    /// By layer along the axis, then row on the second axis across: eight voxels of the first a byte. Empty without a fan.
    filled: Vec<u8>,
}

impl BitMap {
    /// Makes room, empty, from the first to the last row on either axis; `false` where that would be too much.
    fn make_room(&mut self, rows: [[i64; 2]; 2]) -> bool {
        self.size = [0; 2];
        self.words.clear();
        self.filled.clear();
        if rows.iter().any(|[first, last]| first > last) {
            return true;
        }
        self.first = rows.map(|[first, _]| first.div_euclid(EDGE) * EDGE);
        self.size = [0, 1].map(|k| (rows[k][1].div_euclid(EDGE) + 1) * EDGE - self.first[k]);
        let rows = self.size[0].saturating_mul(self.size[1]);
        if rows > MOST_ROWS {
            return false;
        }
        self.words.resize(rows as usize, 0);
        true
    }

    /// Sets the voxels of a slab that a part of a line passes through.
    fn draw(&mut self, line: &Line, part: [f64; 2], slab: [i64; 2]) {
        let Some([from, to]) = line.within(slab) else { return };
        let (mut from, to, slab) = (from.max(part[0]), to.min(part[1]), slab[0]);
        if from >= to || self.words.is_empty() {
            return;
        }
        let mut row = [0, 1].map(|k| floor(line.across(k, from)));
        let mut leaves = [0, 1].map(|k| line.leaves(k, row[k]));
        let step = [0, 1].map(|k| if line.slope[k] > 0.0 { 1 } else { -1 });
        loop {
            let k = usize::from(leaves[1] < leaves[0]);
            let until = leaves[k].min(to).max(from);
            let first = (floor(from) - slab).clamp(0, DEPTH - 1);
            let last = (ceil(until) - 1 - slab).clamp(first, DEPTH - 1);
            let word = (row[1] - self.first[1]) * self.size[0] + row[0] - self.first[0];
            self.words[word as usize] |= (u64::MAX >> (DEPTH - 1 - (last - first))) << first;
            if leaves[k] >= to {
                return;
            }
            from = until;
            row[k] += step[k];
            leaves[k] = line.leaves(k, row[k]);
        }
    }

    /// Sets the voxels that lie between the rays of a fan.
    fn fill(&mut self, fan: &Fan, slab: [i64; 2]) {
        let ([first, rows], [width, height]) = (self.first, self.size);
        let bytes = (width / EDGE) as usize;
        if self.words.is_empty() {
            return;
        }
        self.filled.resize(DEPTH as usize * height as usize * bytes, 0);
        for (layer, plane) in (slab[0]..slab[1]).zip(self.filled.chunks_mut(height as usize * bytes)) {
            fan.fill_layer(layer, [rows, rows + height], |row, from, end| {
                let start = (row - rows) as usize * bytes;
                let (from, end) = ((from - first).clamp(0, width), (end - first).clamp(0, width));
                set_bits(&mut plane[start..start + bytes], from as usize, end as usize);
            });
        }
    }

    /// Adds the map to the occupancy. `slab` is the number of its first voxel along the axis, mirrored for rays that run
    /// against it.
    fn merge(
        &self,
        occupancy: &mut Occupancy,
        frame: &Frame,
        slab: i64,
        base: &Base,
        interrupt: Interrupt,
    ) -> Result<()> {
        // Voxel i of the mirrored axis is voxel -1 - i.
        let first_along = if frame.mirrored() { -slab - DEPTH } else { slab };
        for w in (0..self.size[1]).step_by(8) {
            for v in (0..self.size[0]).step_by(8) {
                let rows = self.rows(v, w, frame.mirrored());
                let any = rows.iter().flatten().fold(0, |a, r| a | r);
                for part in 0..8 {
                    let drawn = (any >> (8 * part) & 0xff != 0).then(|| {
                        // Byte i of word j: bits along the axis, i and j across it.
                        let bits = rows.map(|r| u64::from_le_bytes(r.map(|word| (word >> (8 * part)) as u8)));
                        oriented(bits, frame.along)
                    });
                    let filled = self.filled_block(v, w, part, frame);
                    let bits: Bits = match (drawn, filled) {
                        (None, None) => continue,
                        (Some(one), None) | (None, Some(one)) => one,
                        (Some(a), Some(b)) => std::array::from_fn(|z| a[z] | b[z]),
                    };
                    let mut local = [0; 3];
                    local[frame.along] = first_along + 8 * part as i64;
                    local[frame.across[0]] = self.first[0] + v;
                    local[frame.across[1]] = self.first[1] + w;
                    occupancy.traverse_block(block_of(base.world(local)), &bits, interrupt)?;
                }
            }
        }
        Ok(())
    }

    /// The rows along the axis of eight by eight.
    fn rows(&self, v: i64, w: i64, mirrored: bool) -> [[u64; 8]; 8] {
        std::array::from_fn(|j| {
            let start = ((w + j as i64) * self.size[0] + v) as usize;
            std::array::from_fn(|i| {
                let row = self.words[start + i];
                if mirrored { row.reverse_bits() } else { row }
            })
        })
    }

    /// What a fan filled of a block; `None` for nothing.
    fn filled_block(&self, v: i64, w: i64, part: usize, frame: &Frame) -> Option<Bits> {
        if self.filled.is_empty() {
            return None;
        }
        let bytes = (self.size[0] / EDGE) as usize;
        let (column, plane) = ((v / EDGE) as usize, self.size[1] as usize * bytes);
        let mut layers: [[u8; 8]; 8] = [[0; 8]; 8];
        let mut any = 0;
        for (k, layer) in layers.iter_mut().enumerate() {
            let number = if frame.mirrored() { DEPTH as usize - 1 - (8 * part + k) } else { 8 * part + k };
            let start = number * plane + w as usize * bytes + column;
            for (j, byte) in layer.iter_mut().enumerate() {
                *byte = self.filled[start + j * bytes];
                any |= *byte;
            }
        }
        (any != 0).then(|| match frame.along {
            0 => crossed(&layers).map(|layer| transposed(u64::from_le_bytes(layer))),
            1 => crossed(&layers).map(u64::from_le_bytes),
            _ => layers.map(u64::from_le_bytes),
        })
    }
}

/// Rows to columns.
fn crossed(layers: &[[u8; 8]; 8]) -> [[u8; 8]; 8] {
    let mut out = [[0; 8]; 8];
    for (k, layer) in layers.iter().enumerate() {
        for (j, byte) in layer.iter().enumerate() {
            out[j][k] = *byte;
        }
    }
    out
}

/// Sets the bits from `from` on, up to `end`.
fn set_bits(bytes: &mut [u8], from: usize, end: usize) {
    if from >= end {
        return;
    }
    let (first, last) = (from / 8, (end - 1) / 8);
    let (head, tail) = (0xffu8 << (from % 8), 0xffu8 >> (7 - (end - 1) % 8));
    if first == last {
        bytes[first] |= head & tail;
    } else {
        bytes[first] |= head;
        bytes[first + 1..last].fill(0xff);
        bytes[last] |= tail;
    }
}

/// From (bit, byte, word) = (along, across, across) to (x, y, z).
fn oriented(bits: Bits, along: usize) -> Bits {
    match along {
        0 => bits,
        1 => bits.map(transposed),
        _ => {
            let by_y = bits.map(|word| transposed(word).to_le_bytes());
            std::array::from_fn(|z| u64::from_le_bytes(std::array::from_fn(|y| by_y[y][z])))
        }
    }
}

/// Swaps bits and bytes of a word: bit j of byte i becomes bit i of byte j (Hacker's Delight, 7-3).
fn transposed(x: u64) -> u64 {
    let swap = |x: u64, shift: u32, mask: u64| {
        let t = (x ^ (x >> shift)) & mask;
        x ^ t ^ (t << shift)
    };
    let x = swap(x, 7, 0x00aa_00aa_00aa_00aa);
    let x = swap(x, 14, 0x0000_cccc_0000_cccc);
    swap(x, 28, 0x0000_0000_f0f0_f0f0)
}
