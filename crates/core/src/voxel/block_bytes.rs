//! What the stored forms of occupancy and change share: header, seal, numbers and bits of blocks.

use super::blocks::Bits;
use super::change::Change;
use super::grid::Grid;
use super::occupancy::Occupancy;
use crate::error::{Error, Result};
use crate::geometry::Aabb;
use crate::num::bytes::{Put, Reader};
use crate::num::sections::{self, BODY, HEADER, begin, checksum, header_end, put_section};
use crate::{Interrupt, NEVER, poll_now_and_then};

/// A stored tile, by the type's name, its letter and the newest layout version.
#[derive(Debug, Clone, Copy)]
pub(super) struct Form {
    pub ty: &'static str,
    pub letter: u8,
    pub version: u8,
}

/// What is readable of a stored tile without its blocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TileHeader {
    /// Layout version.
    pub version: u8,
    /// Two bytes whose meaning is the type's.
    pub notes: [u8; 2],
    /// The lattice and the tile.
    pub grid: Grid,
    /// Blocks of which something is known.
    pub blocks: u32,
    /// First and last of them on every axis; `[0, -1]` for none.
    pub span: [[i32; 2]; 3],
}

impl TileHeader {
    /// Bytes of the header's content.
    const CONTENT: usize = Grid::LEN + 4 + 24;
    /// Bytes that suffice for [`TileHeader::read`], whatever the version.
    pub const LEN: usize = header_end(Self::CONTENT);

    /// The header of an occupancy or of a change, by its letter.
    pub fn read(bytes: &[u8]) -> Result<Self> {
        match bytes.get(1) {
            Some(b'C') => Change::header(bytes),
            _ => Occupancy::header(bytes),
        }
    }

    /// Box of the blocks of which something is known, world metres; `None` for none.
    pub fn bounds(&self) -> Option<Aabb> {
        let edge = 8.0 * self.grid.voxel;
        (self.blocks > 0).then(|| Aabb {
            min: self.span.map(|[first, _]| f64::from(first) * edge),
            max: self.span.map(|[_, last]| (f64::from(last) + 1.0) * edge),
        })
    }
}

impl Form {
    /// A container of sections (`num/sections.rs`), version 2; the header's content: the grid; blocks u32, their span 6×i32.
    /// Version 1 is read: version u8, letter u8, notes 2×u8, CRC-32 of the rest u32, the header's content, the body.
    pub fn write(
        &self,
        notes: [u8; 2],
        grid: &Grid,
        keys: &[[i32; 3]],
        interrupt: Interrupt,
        body: impl FnOnce(&mut Vec<u8>) -> Result<()>,
    ) -> Result<Vec<u8>> {
        let mut out = Vec::new();
        begin(self.version, self.letter, notes, &mut out);
        put_section(HEADER, &mut out, interrupt, |out| {
            grid.write(out);
            out.put_u32(keys.len() as u32);
            for axis in 0..3 {
                let along = || keys.iter().map(|key| key[axis]);
                let span = [along().min().unwrap_or(0), along().max().unwrap_or(-1)];
                span.iter().for_each(|&i| out.put(&i.to_le_bytes()));
            }
            Ok(())
        })?;
        put_section(BODY, &mut out, interrupt, body)?;
        Ok(out)
    }

    /// The header alone.
    pub fn header(&self, bytes: &[u8]) -> Result<TileHeader> {
        let mut r = Reader::new(bytes, self.ty);
        let version = r.u8()?;
        if r.u8()? != self.letter {
            return Err(r.bad("it does not start as its type does"));
        }
        if version == 0 || version > self.version {
            return Err(Error::Version { ty: self.ty, found: version, known: self.version });
        }
        let notes = [r.u8()?, r.u8()?];
        if version == 1 {
            r.u32()?;
        } else {
            r = sections::header(bytes, self.ty, NEVER)?;
        }
        let grid = Grid::read(&mut r)?;
        let blocks = r.u32()?;
        let mut span = [[0; 2]; 3];
        for end in span.iter_mut().flatten() {
            *end = r.u32()? as i32;
        }
        Ok(TileHeader { version, notes, grid, blocks, span })
    }

    /// The header, and the body, whose checksum is checked.
    pub fn read<'a>(&self, bytes: &'a [u8], interrupt: Interrupt) -> Result<(Reader<'a>, TileHeader)> {
        let header = self.header(bytes)?;
        let body = match header.version {
            // Over everything but itself.
            1 if checksum(&[&bytes[..4], &bytes[8..]], interrupt)?.to_le_bytes() != bytes[4..8] => {
                return Err(Error::corrupted(self.ty, "the checksum does not match"));
            }
            1 => &bytes[8 + TileHeader::CONTENT..],
            _ => sections::read(bytes, self.ty, [HEADER, BODY], interrupt)?[1],
        };
        Ok((Reader::new(body, self.ty), header))
    }
}

/// Most bytes that [`write_key`] and a block of either type write.
pub(super) const MOST_OF_A_BLOCK: usize = 4096;

/// What a block's first byte says of its number: it lies above the last along z.
pub(super) const ABOVE_THE_LAST: u8 = 1;

/// Begins a block: a byte of `flags` (not [`ABOVE_THE_LAST`]), and where the number is not the next its three differences.
pub(super) fn write_key(key: [i32; 3], last: [i32; 3], flags: u8, out: &mut Vec<u8>) {
    let above = key[0] == last[0] && key[1] == last[1] && i64::from(key[2]) == i64::from(last[2]) + 1;
    out.push(flags | if above { ABOVE_THE_LAST } else { 0 });
    if !above {
        (0..3).for_each(|i| out.put_varint_signed(i64::from(key[i]) - i64::from(last[i])));
    }
}

/// The flags and the number of the next block; `last` is `None` for the first.
fn read_key(r: &mut Reader, last: Option<[i32; 3]>, header: &TileHeader) -> Result<(u8, [i32; 3])> {
    let flags = r.u8()?;
    let mut key = last.unwrap_or_default().map(i64::from);
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
    let key = [x, y, z];
    if last.is_some_and(|last| key <= last) {
        return Err(r.bad("its blocks are not in order"));
    }
    if (0..3).any(|i| key[i] < header.span[i][0] || key[i] > header.span[i][1]) {
        return Err(r.bad("a block outside the span that it announces"));
    }
    Ok((flags, key))
}

/// Calls `read` with the flags and number of every block, to read the rest of it; fails where bytes are left.
pub(super) fn read_blocks(
    mut r: Reader,
    header: &TileHeader,
    interrupt: Interrupt,
    mut read: impl FnMut(&mut Reader, u8, [i32; 3]) -> Result<()>,
) -> Result<()> {
    let mut last = None;
    for round in 0..header.blocks {
        poll_now_and_then(round as usize, interrupt)?;
        let (flags, key) = read_key(&mut r, last, header)?;
        read(&mut r, flags, key)?;
        last = Some(key);
    }
    r.finish()
}

/// A word of bits: nothing, everything, or as written.
const NONE: u16 = 0;
const ALL: u16 = 1;
const WRITTEN: u16 = 2;

/// Two bits a word, then the words that are neither empty nor full.
pub(super) fn write_bits(bits: &Bits, out: &mut Vec<u8>) {
    let kind = |word: u64| match word {
        0 => NONE,
        u64::MAX => ALL,
        _ => WRITTEN,
    };
    let kinds = bits.iter().enumerate().fold(0, |k, (i, &word)| k | kind(word) << (2 * i));
    out.put(&kinds.to_le_bytes());
    bits.iter().filter(|&&w| kind(w) == WRITTEN).for_each(|w| out.put(&w.to_le_bytes()));
}

/// Reads what [`write_bits`] wrote.
pub(super) fn read_bits(r: &mut Reader) -> Result<Bits> {
    let kinds = u16::from_le_bytes([r.u8()?, r.u8()?]);
    let mut bits = [0; 8];
    for (i, word) in bits.iter_mut().enumerate() {
        *word = match kinds >> (2 * i) & 3 {
            NONE => 0,
            ALL => u64::MAX,
            WRITTEN => r.i64()? as u64,
            other => return Err(r.bad(format!("a word of kind {other}"))),
        };
    }
    Ok(bits)
}
