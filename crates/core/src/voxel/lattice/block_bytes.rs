//! The blocks of a stored tile: their numbers, and bits of their voxels.

use super::bits::Bits;
use super::tile_format::TileHeader;
use crate::error::Result;
use crate::num::bytes::{ByteReader, Put};
use crate::{Grow, Interrupt, poll_now_and_then};

/// Most bytes that [`write_key`] and a block of either type write.
const MAX_BLOCK_BYTES: usize = 4096;

/// What a block's first byte says of its number: it lies above the last along z.
pub const ABOVE_THE_LAST: u8 = 1;

/// Begins a block: a byte of `flags` (not [`ABOVE_THE_LAST`]), and where the number is not the next its three
/// differences.
pub fn write_key(key: [i32; 3], last: [i32; 3], flags: u8, out: &mut Vec<u8>) {
    let above = key[0] == last[0] && key[1] == last[1] && i64::from(key[2]) == i64::from(last[2]) + 1;
    out.push(flags | if above { ABOVE_THE_LAST } else { 0 });
    if !above {
        (0..3).for_each(|i| out.put_varint_signed(i64::from(key[i]) - i64::from(last[i])));
    }
}

/// The flags and the number of the next block; `last` is `None` for the first.
fn read_key(r: &mut ByteReader, last: Option<[i32; 3]>, header: &TileHeader) -> Result<(u8, [i32; 3])> {
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

/// Appends blocks by `write(number, the last one's, block, out)`, which begins with [`write_key`].
pub fn write_blocks<T>(
    blocks: Vec<([i32; 3], T)>,
    out: &mut Vec<u8>,
    interrupt: Interrupt,
    write: impl Fn([i32; 3], [i32; 3], T, &mut Vec<u8>),
) -> Result<()> {
    let mut last = [0i32; 3];
    for (round, (key, block)) in blocks.into_iter().enumerate() {
        poll_now_and_then(round, interrupt)?;
        out.grow(MAX_BLOCK_BYTES, interrupt)?;
        write(key, last, block, out);
        last = key;
    }
    Ok(())
}

/// Calls `read` with the flags and number of every block, to read the rest of it; fails where bytes are left.
pub fn read_blocks(
    mut r: ByteReader,
    header: &TileHeader,
    interrupt: Interrupt,
    mut read: impl FnMut(&mut ByteReader, u8, [i32; 3]) -> Result<()>,
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
pub fn write_bits(bits: &Bits, out: &mut Vec<u8>) {
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
pub fn read_bits(r: &mut ByteReader) -> Result<Bits> {
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
