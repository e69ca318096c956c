//! The stored form of occupancy: SQL's `ab_occupancy`.

use super::block::Block;
use super::grid::Grid;
use super::occupancy::Occupancy;
use crate::error::{Error, Result};
use crate::geometry::Aabb;
use crate::num::bytes::{Put, Reader};
use crate::{Interrupt, poll_now_and_then};

const TY: &str = "ab_occupancy";

/// A word of a block's traversals: nothing, everything, or as written.
const NONE: u16 = 0;
const ALL: u16 = 1;
const WRITTEN: u16 = 2;

/// What a block's first byte says.
const ABOVE_THE_LAST: u8 = 1;
const HAS_HITS: u8 = 2;
const ALL_TRAVERSED: u8 = 4;
const KNOWN: u8 = 7;

/// What is readable without the blocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OccupancyHeader {
    /// The lattice and the tile.
    pub grid: Grid,
    /// Blocks of which something is known.
    pub blocks: u32,
    /// First and last of them on every axis; `[0, -1]` for none.
    pub span: [[i32; 2]; 3],
}

impl OccupancyHeader {
    /// Bytes of a header.
    pub const LEN: usize = 4 + 4 + 72 + 4 + 24;

    /// Box of the blocks of which something is known, world metres; `None` for none.
    pub fn bounds(&self) -> Option<Aabb> {
        let edge = 8.0 * self.grid.voxel;
        (self.blocks > 0).then(|| Aabb {
            min: self.span.map(|[first, _]| f64::from(first) * edge),
            max: self.span.map(|[_, last]| (f64::from(last) + 1.0) * edge),
        })
    }
}

impl Occupancy {
    /// Layout version written by this release.
    pub const VERSION: u8 = 1;

    /// The stored and transmitted form; equal occupancy has equal bytes.
    ///
    /// Little-endian: version u8, `'O'` u8, 0 u16, CRC-32 of the rest u32; grid (voxel, tile, margin, no-return range) 9×f64;
    /// blocks u32, their span 6×i32; then per block, in the order of their numbers, a byte of flags, its number (three
    /// varint differences, unless it lies above the last), its traversals (two bits a word, then the words as written)
    /// unless all are set, and its counts (how many, then slot difference and count, varints).
    pub fn to_bytes(&self, interrupt: Interrupt) -> Result<Vec<u8>> {
        let sorted = self.sorted();
        let mut out = Vec::with_capacity(OccupancyHeader::LEN + 8 * sorted.len());
        out.put(&[Self::VERSION, b'O', 0, 0]);
        out.put_u32(0);
        let Grid { voxel, tile, margin, no_return_range } = self.grid;
        let numbers = [&[voxel][..], &tile.min, &tile.max, &[margin, no_return_range]].concat();
        numbers.iter().for_each(|&n| out.put_f64(n));
        out.put_u32(sorted.len() as u32);
        for axis in 0..3 {
            let along = || sorted.iter().map(|(key, _)| key[axis]);
            let span = [along().min().unwrap_or(0), along().max().unwrap_or(-1)];
            span.iter().for_each(|&i| out.put(&i.to_le_bytes()));
        }
        let mut last = [0i32; 3];
        for (round, (key, block)) in sorted.into_iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            write_block(key, last, block, &mut out);
            last = key;
        }
        let checksum = crc32fast::hash(&out[8..]);
        out[4..8].copy_from_slice(&checksum.to_le_bytes());
        Ok(out)
    }

    /// The header alone.
    pub fn header(bytes: &[u8]) -> Result<OccupancyHeader> {
        Ok(read_header(bytes)?.1)
    }

    /// Reads bytes, foreign ones too; no more than about `most_memory` bytes are allocated.
    pub fn from_bytes(bytes: &[u8], most_memory: usize, interrupt: Interrupt) -> Result<Self> {
        let (mut r, header) = read_header(bytes)?;
        let stored = u32::from_le_bytes(std::array::from_fn(|i| bytes[4 + i]));
        if crc32fast::hash(&bytes[8..]) != stored {
            return Err(Error::corrupted(TY, "the checksum does not match"));
        }
        let mut out = Self::new(header.grid);
        let mut last = [0i32; 3];
        for round in 0..header.blocks {
            poll_now_and_then(round as usize, interrupt)?;
            let (key, block) = read_block(&mut r, last, round == 0)?;
            if (0..3).any(|i| key[i] < header.span[i][0] || key[i] > header.span[i][1]) {
                return Err(r.bad("a block outside the span that it announces"));
            }
            out.insert(key, block);
            out.check_memory(most_memory)?;
            last = key;
        }
        r.finish()?;
        Ok(out)
    }
}

fn read_header(bytes: &[u8]) -> Result<(Reader<'_>, OccupancyHeader)> {
    let mut r = Reader::new(bytes, TY);
    let version = r.u8()?;
    if r.u8()? != b'O' {
        return Err(r.bad("it does not start as an occupancy does"));
    }
    if version == 0 || version > Occupancy::VERSION {
        return Err(Error::Version { ty: TY, found: version, known: Occupancy::VERSION });
    }
    r.take(6)?;
    let voxel = r.f64()?;
    let tile = Aabb { min: r.vec3()?.into(), max: r.vec3()?.into() };
    let grid = Grid::new(voxel, tile, r.f64()?, r.f64()?)?;
    let blocks = r.u32()?;
    let mut span = [[0; 2]; 3];
    for end in span.iter_mut().flatten() {
        *end = r.u32()? as i32;
    }
    Ok((r, OccupancyHeader { grid, blocks, span }))
}

fn write_block(key: [i32; 3], last: [i32; 3], block: &Block, out: &mut Vec<u8>) {
    let above = key[0] == last[0] && key[1] == last[1] && i64::from(key[2]) == i64::from(last[2]) + 1;
    let all = block.traversed == [u64::MAX; 8];
    let flag = |set: bool, flag: u8| if set { flag } else { 0 };
    let hits = block.hits.as_deref().filter(|h| h.iter().any(|&n| n > 0));
    out.push(flag(above, ABOVE_THE_LAST) | flag(hits.is_some(), HAS_HITS) | flag(all, ALL_TRAVERSED));
    if !above {
        (0..3).for_each(|i| out.put_varint_signed(i64::from(key[i]) - i64::from(last[i])));
    }
    if !all {
        let kind = |word: u64| match word {
            0 => NONE,
            u64::MAX => ALL,
            _ => WRITTEN,
        };
        let kinds = block.traversed.iter().enumerate().fold(0, |k, (i, &word)| k | kind(word) << (2 * i));
        out.put(&kinds.to_le_bytes());
        block.traversed.iter().filter(|&&w| kind(w) == WRITTEN).for_each(|w| out.put(&w.to_le_bytes()));
    }
    if let Some(hits) = hits {
        out.put_varint(hits.iter().filter(|&&n| n > 0).count() as u64);
        let mut before = 0;
        for (slot, &count) in hits.iter().enumerate().filter(|(_, n)| **n > 0) {
            out.put_varint((slot - before) as u64);
            out.push(count);
            before = slot;
        }
    }
}

fn read_block(r: &mut Reader, last: [i32; 3], first: bool) -> Result<([i32; 3], Block)> {
    let flags = r.u8()?;
    if flags & !KNOWN != 0 {
        return Err(r.bad(format!("flags {flags:#04x} of a block")));
    }
    let mut key = last.map(i64::from);
    if flags & ABOVE_THE_LAST != 0 {
        key[2] += 1;
    } else {
        for part in &mut key {
            *part = part.saturating_add(r.varint_signed()?);
        }
    }
    let [Ok(x), Ok(y), Ok(z)] = key.map(i32::try_from) else {
        return Err(r.bad("a block beyond the lattice"));
    };
    if !first && [x, y, z] <= last {
        return Err(r.bad("its blocks are not in order"));
    }
    let mut block = Block { traversed: [u64::MAX; 8], hits: None };
    if flags & ALL_TRAVERSED == 0 {
        let kinds = u16::from_le_bytes([r.u8()?, r.u8()?]);
        for (i, word) in block.traversed.iter_mut().enumerate() {
            *word = match kinds >> (2 * i) & 3 {
                NONE => 0,
                ALL => u64::MAX,
                WRITTEN => r.i64()? as u64,
                other => return Err(r.bad(format!("a word of kind {other}"))),
            };
        }
    }
    if flags & HAS_HITS != 0 {
        let mut slot = 0;
        for _ in 0..r.varint()? {
            slot += usize::try_from(r.varint()?).unwrap_or(usize::MAX).min(512);
            let count = r.u8()?;
            if slot >= 512 || count == 0 {
                return Err(r.bad("a count that no voxel has"));
            }
            block.hits.get_or_insert_with(|| Box::new([0; 512]))[slot] = count;
        }
    }
    Ok(([x, y, z], block))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use proptest::prelude::*;

    const MOST: usize = 1 << 24;

    fn any_occupancy() -> impl Strategy<Value = Occupancy> {
        let voxel = prop::array::uniform3(-40i64..40);
        (prop::collection::vec((voxel, 0u8..3), 0..300), prop::collection::vec(prop::array::uniform3(-4i32..4), 0..20))
            .prop_map(|(voxels, full)| {
                let mut o = Occupancy::new(Grid::new(0.02, Grid::EVERYWHERE, 0.01, 5.0).unwrap());
                for (v, what) in voxels {
                    if what > 0 {
                        o.hit(v);
                    }
                    if what < 2 {
                        o.traverse(v);
                    }
                }
                full.into_iter().for_each(|key| o.insert(key, Block { traversed: [u64::MAX; 8], hits: None }));
                o
            })
    }

    proptest! {
        #[test]
        fn bytes_round_trip(o in any_occupancy()) {
            let bytes = o.to_bytes(NEVER).unwrap();
            let back = Occupancy::from_bytes(&bytes, MOST, NEVER).unwrap();
            prop_assert_eq!(&back, &o);
            prop_assert_eq!(back.to_bytes(NEVER).unwrap(), bytes.clone());
            let header = Occupancy::header(&bytes).unwrap();
            prop_assert_eq!(header.blocks as usize, o.sorted().len());
            let bounds = header.bounds();
            o.for_each(1, NEVER, |v, _, _| assert!(bounds.unwrap().holds(&o.grid().centre(v)))).unwrap();
        }

        #[test]
        fn damage_is_noticed(o in any_occupancy(), at in any::<usize>(), x in 1u8.., cut in 0usize..3) {
            let mut bytes = o.to_bytes(NEVER).unwrap();
            let n = bytes.len();
            bytes[at % n] ^= x;
            bytes.truncate(n - cut);
            // Two bytes are not used.
            prop_assert!(Occupancy::from_bytes(&bytes, MOST, NEVER).is_err() || (cut == 0 && (2..4).contains(&(at % n))));
        }

        #[test]
        fn nonsense_under_a_right_checksum(tail in prop::collection::vec(any::<u8>(), 0..300), blocks in any::<u32>()) {
            let mut bytes = Occupancy::new(Grid::new(0.02, Grid::EVERYWHERE, 0.0, 5.0).unwrap()).to_bytes(NEVER).unwrap();
            bytes[80..84].copy_from_slice(&blocks.to_le_bytes());
            for axis in 0..3 {
                bytes[84 + 8 * axis..88 + 8 * axis].copy_from_slice(&i32::MIN.to_le_bytes());
                bytes[88 + 8 * axis..92 + 8 * axis].copy_from_slice(&i32::MAX.to_le_bytes());
            }
            bytes.extend_from_slice(&tail);
            let checksum = crc32fast::hash(&bytes[8..]);
            bytes[4..8].copy_from_slice(&checksum.to_le_bytes());
            let _ = Occupancy::from_bytes(&bytes, MOST, NEVER);
        }
    }

    #[test]
    fn memory_is_bounded() {
        let mut o = Occupancy::new(Grid::new(0.02, Grid::EVERYWHERE, 0.0, 5.0).unwrap());
        (0..5000).for_each(|i| o.insert([0, 0, i], Block { traversed: [u64::MAX; 8], hits: None }));
        let bytes = o.to_bytes(NEVER).unwrap();
        assert!(bytes.len() < 5000 + 200, "a full block takes a byte: {}", bytes.len());
        assert!(matches!(Occupancy::from_bytes(&bytes, 100_000, NEVER), Err(Error::Limit { .. })));
    }
}
