//! A stored tile: its header, and the seal around header and blocks.

use super::grid::Grid;
use crate::error::{Error, Result};
use crate::geometry::Aabb;
use crate::num::bytes::{ByteReader, Put};
use crate::num::sections::{self, BODY, HEADER, begin, checksum, header_end, put_section};
use crate::{Interrupt, NEVER};

/// A stored tile, by the type's name, its letter and the newest layout version.
#[derive(Debug, Clone, Copy)]
pub struct TileFormat {
    ty: &'static str,
    letter: u8,
    /// Layout version written by this release.
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
            Some(&letter) if letter == TileFormat::CHANGE.letter => TileFormat::CHANGE.header(bytes),
            _ => TileFormat::OCCUPANCY.header(bytes),
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

impl TileFormat {
    /// What beams saw of a tile, or a model drawn in it.
    pub const OCCUPANCY: Self = Self { ty: "ab_occupancy", letter: b'O', version: 2 };
    /// What became of a tile.
    pub const CHANGE: Self = Self { ty: "ab_change", letter: b'C', version: 2 };

    /// A container of sections (`num/sections.rs`), version 2; the header's content: the grid; blocks u32, their span
    /// 6×i32. Version 1 is read: version u8, letter u8, notes 2×u8, CRC-32 of the rest u32, the header's content, the
    /// body.
    pub fn write(
        &self,
        notes: [u8; 2],
        grid: &Grid,
        keys: impl ExactSizeIterator<Item = [i32; 3]> + Clone,
        interrupt: Interrupt,
        body: impl FnOnce(&mut Vec<u8>) -> Result<()>,
    ) -> Result<Vec<u8>> {
        let mut out = Vec::new();
        begin(self.version, self.letter, notes, &mut out);
        put_section(HEADER, &mut out, interrupt, |out| {
            grid.write(out);
            out.put_u32(keys.len() as u32);
            for axis in 0..3 {
                let along = || keys.clone().map(|key| key[axis]);
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
        let mut r = ByteReader::new(bytes, self.ty);
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
    pub fn read<'a>(&self, bytes: &'a [u8], interrupt: Interrupt) -> Result<(ByteReader<'a>, TileHeader)> {
        let header = self.header(bytes)?;
        let body = match header.version {
            // Over everything but itself.
            1 if checksum(&[&bytes[..4], &bytes[8..]], interrupt)?.to_le_bytes() != bytes[4..8] => {
                return Err(Error::corrupted(self.ty, "the checksum does not match"));
            }
            1 => &bytes[8 + TileHeader::CONTENT..],
            _ => sections::read(bytes, self.ty, [HEADER, BODY], interrupt)?[1],
        };
        Ok((ByteReader::new(body, self.ty), header))
    }
}
