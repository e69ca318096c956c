//! A slab of voxels as a dense bit map, which stays in the cache.

use super::fan::Fan;
use super::line::{SlabAxes, SlabLine};
use super::local_origin::LocalOrigin;
use super::tile::CarvedTile;
use super::turn::{crossed, oriented, set_bits, transposed};
use crate::num::whole::{ceil, floor};
use crate::voxel::lattice::block_map::block_of;
use crate::voxel::lattice::{Bits, EDGE};
use crate::{Interrupt, Result};

/// Voxels of a slab along its axis: a row of the bit map is one word.
pub const DEPTH: i64 = 64;
/// Most rows of a slab's bit map (8 bytes each); beyond, rays are so far apart that they are carved one by one.
const MAX_ROWS: i64 = 1 << 20;

/// A slab of voxels, in rows along the axis and, where a fan filled it, in rows across it.
#[derive(Debug, Default)]
pub struct BitMap {
    /// First row on either axis across, a multiple of 8.
    first: [i64; 2],
    /// Rows on either axis, multiples of 8.
    size: [i64; 2],
    /// A word a row along the axis.
    words: Vec<u64>,
    /// By layer along the axis, then row on the second axis across: eight voxels of the first a byte. Empty without a
    /// fan.
    filled: Vec<u8>,
}

impl BitMap {
    /// Makes room, empty, from the first to the last row on either axis; `false` where that would be too much.
    pub fn make_room(&mut self, rows: [[i64; 2]; 2]) -> bool {
        self.size = [0; 2];
        self.words.clear();
        self.filled.clear();
        if rows.iter().any(|[first, last]| first > last) {
            return true;
        }
        self.first = rows.map(|[first, _]| first.div_euclid(EDGE) * EDGE);
        self.size = [0, 1].map(|k| (rows[k][1].div_euclid(EDGE) + 1) * EDGE - self.first[k]);
        let rows = self.size[0].saturating_mul(self.size[1]);
        if rows > MAX_ROWS {
            return false;
        }
        self.words.resize(rows as usize, 0);
        true
    }

    /// Sets the voxels of a slab that a part of a line passes through.
    pub fn draw(&mut self, line: &SlabLine, part: [f64; 2], slab: [i64; 2]) {
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
    pub fn fill(&mut self, fan: &Fan, slab: [i64; 2]) {
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

    /// Adds the map to a tile. `slab` is the number of its first voxel along the axis, mirrored for rays that run
    /// against it.
    pub fn merge(
        &self,
        tile: &mut CarvedTile,
        axes: &SlabAxes,
        slab: i64,
        origin: &LocalOrigin,
        interrupt: Interrupt,
    ) -> Result<()> {
        // Voxel i of the mirrored axis is voxel -1 - i.
        let first_along = if axes.is_mirrored() { -slab - DEPTH } else { slab };
        for w in (0..self.size[1]).step_by(8) {
            for v in (0..self.size[0]).step_by(8) {
                let rows = self.rows(v, w, axes.is_mirrored());
                let any = rows.iter().flatten().fold(0, |a, r| a | r);
                for part in 0..8 {
                    let drawn = (any >> (8 * part) & 0xff != 0).then(|| {
                        // Byte i of word j: bits along the axis, i and j across it.
                        let bits = rows.map(|r| u64::from_le_bytes(r.map(|word| (word >> (8 * part)) as u8)));
                        oriented(bits, axes.along)
                    });
                    let filled = self.filled_block(v, w, part, axes);
                    let bits: Bits = match (drawn, filled) {
                        (None, None) => continue,
                        (Some(one), None) | (None, Some(one)) => one,
                        (Some(a), Some(b)) => std::array::from_fn(|z| a[z] | b[z]),
                    };
                    let along = first_along + 8 * part as i64;
                    let local = axes.voxel(along, [self.first[0] + v, self.first[1] + w]);
                    tile.traverse_block(block_of(origin.world(local)), &bits, interrupt)?;
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
    fn filled_block(&self, v: i64, w: i64, part: usize, axes: &SlabAxes) -> Option<Bits> {
        if self.filled.is_empty() {
            return None;
        }
        let bytes = (self.size[0] / EDGE) as usize;
        let (column, plane) = ((v / EDGE) as usize, self.size[1] as usize * bytes);
        let mut layers: [[u8; 8]; 8] = [[0; 8]; 8];
        let mut any = 0;
        for (k, layer) in layers.iter_mut().enumerate() {
            let number = if axes.is_mirrored() { DEPTH as usize - 1 - (8 * part + k) } else { 8 * part + k };
            let start = number * plane + w as usize * bytes + column;
            for (j, byte) in layer.iter_mut().enumerate() {
                *byte = self.filled[start + j * bytes];
                any |= *byte;
            }
        }
        (any != 0).then(|| match axes.along {
            0 => crossed(&layers).map(|layer| transposed(u64::from_le_bytes(layer))),
            1 => crossed(&layers).map(u64::from_le_bytes),
            _ => layers.map(u64::from_le_bytes),
        })
    }
}
