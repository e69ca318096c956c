//! Many rays of nearly one direction, carved together: slab by slab along an axis of the lattice into a dense bit map
//! that stays in the cache, a run of voxels at a time, and from there block by block into the occupancy.

use super::block::EDGE;
use super::blocks::{Bits, block_of};
use super::grid::Grid;
use super::occupancy::Occupancy;
use crate::Result;
use crate::geometry::Vec3;

/// Voxels of a slab along its axis: a row of the bit map is one word.
const DEPTH: i64 = 64;
/// Most rows of a slab's bit map (8 bytes each); beyond, rays are so far apart that they are carved one by one.
const MOST_ROWS: i64 = 1 << 20;

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
}

/// A way through empty space, in voxels from a [`Base`].
#[derive(Debug, Clone, Copy)]
pub struct Ray {
    /// Where it begins.
    pub start: Vec3,
    /// Where it stops.
    pub stop: Vec3,
}

impl Ray {
    /// The part inside a box of voxels, `[first, end)` an axis.
    pub fn clipped(&self, tile: &[[f64; 2]; 3]) -> Option<Self> {
        let way = self.stop - self.start;
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for axis in 0..3 {
            let [a, b] = tile[axis].map(|face| (face - self.start[axis]) / way[axis]);
            if way[axis] != 0.0 {
                (from, to) = (from.max(a.min(b)), to.min(a.max(b)));
            } else if self.start[axis] < tile[axis][0] || self.start[axis] >= tile[axis][1] {
                return None;
            }
        }
        (from < to).then(|| Self { start: self.start + way * from, stop: self.start + way * to })
    }
}

/// A ray along the slabs' axis: its other two coordinates as functions of the first, which grows.
#[derive(Debug, Clone, Copy)]
struct Line {
    from: f64,
    to: f64,
    at: [f64; 2],
    slope: [f64; 2],
    /// 1 / slope; infinite for a line that stays in its row.
    pace: [f64; 2],
}

/// The three axes of a bundle: along it, and across it in the order that blocks store them.
#[derive(Debug, Clone, Copy)]
struct Frame {
    along: usize,
    across: [usize; 2],
    sign: f64,
}

impl Frame {
    fn new(along: usize, sign: f64) -> Self {
        let across = match along {
            0 => [1, 2],
            1 => [0, 2],
            _ => [0, 1],
        };
        Self { along, across, sign }
    }

    fn line(&self, ray: &Ray) -> Line {
        let (from, to) = (self.sign * ray.start[self.along], self.sign * ray.stop[self.along]);
        let at = self.across.map(|k| ray.start[k]);
        let slope = self.across.map(|k| (ray.stop[k] - ray.start[k]) / (to - from));
        Line { from, to, at, slope, pace: slope.map(f64::recip) }
    }
}

impl Line {
    fn across(&self, k: usize, along: f64) -> f64 {
        self.at[k] + self.slope[k] * (along - self.from)
    }

    /// Where it leaves the row of voxels numbered `row` on the axis across `k`.
    fn leaves(&self, k: usize, row: i64) -> f64 {
        let face = if self.slope[k] > 0.0 { row + 1 } else { row };
        if self.slope[k] == 0.0 { f64::INFINITY } else { self.from + (face as f64 - self.at[k]) * self.pace[k] }
    }
}

/// Carves rays that all lean towards `sign` × the axis `along`; `check` is asked at every slab whether to go on.
pub fn carve_bundle(
    occupancy: &mut Occupancy,
    rays: &[Ray],
    along: usize,
    sign: f64,
    base: &Base,
    check: &dyn Fn(&Occupancy) -> Result<()>,
) -> Result<()> {
    let frame = Frame::new(along, sign);
    let lines: Vec<Line> = rays.iter().map(|r| frame.line(r)).collect();
    let ends = lines.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], l| [a.min(l.from), b.max(l.to)]);
    if lines.is_empty() {
        return Ok(());
    }
    let mut map = BitMap::default();
    for number in (ends[0].floor() as i64).div_euclid(DEPTH)..=(ends[1].floor() as i64).div_euclid(DEPTH) {
        check(occupancy)?;
        let slab = [number * DEPTH, (number + 1) * DEPTH];
        if map.fit(&lines, slab) {
            lines.iter().for_each(|l| map.draw(l, slab));
            map.merge(occupancy, &frame, slab[0], base);
        } else {
            for line in &lines {
                check(occupancy)?;
                carve_part(occupancy, &frame, line, slab, base);
            }
        }
    }
    Ok(())
}

/// The part of a ray inside a slab, voxel by voxel.
fn carve_part(occupancy: &mut Occupancy, frame: &Frame, line: &Line, slab: [i64; 2], base: &Base) {
    let (from, to) = (line.from.max(slab[0] as f64), line.to.min(slab[1] as f64));
    if from < to {
        let point = |along: f64| {
            let mut p = Vec3::zeros();
            p[frame.along] = frame.sign * along;
            (0..2).for_each(|k| p[frame.across[k]] = line.across(k, along));
            p
        };
        occupancy.carve_alone(&Ray { start: point(from), stop: point(to) }, base);
    }
}

/// A slab of voxels: one word a row along the axis, rows across it.
#[derive(Debug, Default)]
struct BitMap {
    /// First row on either axis, a multiple of 8.
    first: [i64; 2],
    /// Rows on either axis, multiples of 8.
    size: [i64; 2],
    words: Vec<u64>,
}

impl BitMap {
    /// Makes room, empty, for what lines pass through in a slab; `false` where that would be too much.
    fn fit(&mut self, lines: &[Line], slab: [i64; 2]) -> bool {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for line in lines {
            let (from, to) = (line.from.max(slab[0] as f64), line.to.min(slab[1] as f64));
            if from < to {
                for k in 0..2 {
                    let ends = [line.across(k, from), line.across(k, to)];
                    low[k] = low[k].min(ends[0]).min(ends[1]);
                    high[k] = high[k].max(ends[0]).max(ends[1]);
                }
            }
        }
        self.size = [0; 2];
        self.words.clear();
        if low[0] > high[0] {
            return true;
        }
        // A row more on every side: rounding may reach into it.
        for k in 0..2 {
            self.first[k] = (low[k].floor() as i64 - 1).div_euclid(EDGE) * EDGE;
            self.size[k] = ((high[k].floor() as i64 + 1).div_euclid(EDGE) + 1) * EDGE - self.first[k];
        }
        let rows = self.size[0].saturating_mul(self.size[1]);
        if rows > MOST_ROWS {
            return false;
        }
        self.words.resize(rows as usize, 0);
        true
    }

    /// Sets the voxels that a line passes through.
    fn draw(&mut self, line: &Line, slab: [i64; 2]) {
        let (mut from, to) = (line.from.max(slab[0] as f64), line.to.min(slab[1] as f64));
        if from >= to {
            return;
        }
        let mut row = [0, 1].map(|k| line.across(k, from).floor() as i64);
        let mut leaves = [0, 1].map(|k| line.leaves(k, row[k]));
        let step = [0, 1].map(|k| if line.slope[k] > 0.0 { 1 } else { -1 });
        loop {
            let k = usize::from(leaves[1] < leaves[0]);
            let until = leaves[k].min(to).max(from);
            let first = (from.floor() as i64 - slab[0]).clamp(0, DEPTH - 1);
            let last = (until.ceil() as i64 - 1 - slab[0]).clamp(first, DEPTH - 1);
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

    /// Adds the map to the occupancy. `slab` is the number of its first voxel along the axis, mirrored for rays that run
    /// against it.
    fn merge(&self, occupancy: &mut Occupancy, frame: &Frame, slab: i64, base: &Base) {
        let mirrored = frame.sign < 0.0;
        // Voxel i of the mirrored axis is voxel -1 - i.
        let first_along = if mirrored { -slab - DEPTH } else { slab };
        for w in (0..self.size[1]).step_by(8) {
            for v in (0..self.size[0]).step_by(8) {
                let rows: [[u64; 8]; 8] = std::array::from_fn(|j| {
                    let start = ((w + j as i64) * self.size[0] + v) as usize;
                    std::array::from_fn(|i| {
                        let row = self.words[start + i];
                        if mirrored { row.reverse_bits() } else { row }
                    })
                });
                let any = rows.iter().flatten().fold(0, |a, r| a | r);
                for part in (0..8).filter(|part| any >> (8 * part) & 0xff != 0) {
                    let mut local = [0; 3];
                    local[frame.along] = first_along + 8 * part as i64;
                    local[frame.across[0]] = self.first[0] + v;
                    local[frame.across[1]] = self.first[1] + w;
                    // Byte i of word j: bits along the axis, i and j across it.
                    let bits = rows.map(|r| u64::from_le_bytes(r.map(|word| (word >> (8 * part)) as u8)));
                    occupancy.traverse_block(block_of(base.world(local)), &oriented(bits, frame.along));
                }
            }
        }
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
