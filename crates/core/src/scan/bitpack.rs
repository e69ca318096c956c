//! One column of integers as bit-packed differences.
//!
//! Blocks of [`BLOCK`] values. Per block the first or the second difference, whichever packs smaller, zigzag
//! coded, in as few bits as pay off; values that need more (the jump to the next scan line) are exceptions.
//! After Zukowski et al. 2006 (PFOR-DELTA). Arithmetic wraps, so any `i32` column is carried exactly.
//!
//! Block layout: `order << 6 | width` u8, exceptions u8, the packed low bits (`width` × values, LSB first, padded
//! to a byte), then per exception its place u8 and its full value u32.

use crate::error::Result;
use crate::num::bytes::{Put, Reader};

/// Values in a block.
pub const BLOCK: usize = 64;

/// Appends `values` to `out`.
pub fn pack(values: &[i32], out: &mut Vec<u8>) {
    let mut before = [0i32; 2];
    for block in values.chunks(BLOCK) {
        let choice = [1u8, 2].map(|order| {
            let residuals = residuals(block, before, order);
            let (width, bits) = best_width(&residuals);
            (bits, order, width, residuals)
        });
        let [first, second] = choice;
        let (_, order, width, residuals) = if first.0 <= second.0 { first } else { second };
        write_block(order, width, &residuals, out);
        before = last_two(before, block);
    }
}

/// Reads `count` values.
pub fn unpack(r: &mut Reader, count: usize) -> Result<Vec<i32>> {
    let mut out = Vec::with_capacity(count);
    let mut before = [0i32; 2];
    let mut residuals = [0u32; BLOCK];
    while out.len() < count {
        let n = BLOCK.min(count - out.len());
        let order = read_block(r, &mut residuals[..n])?;
        for &z in &residuals[..n] {
            let predicted = predict(before, order);
            let v = predicted.wrapping_add(unzigzag(z));
            before = [before[1], v];
            out.push(v);
        }
    }
    Ok(out)
}

fn predict(before: [i32; 2], order: u8) -> i32 {
    if order == 1 { before[1] } else { before[1].wrapping_mul(2).wrapping_sub(before[0]) }
}

fn residuals(block: &[i32], mut before: [i32; 2], order: u8) -> Vec<u32> {
    block
        .iter()
        .map(|&v| {
            let z = zigzag(v.wrapping_sub(predict(before, order)));
            before = [before[1], v];
            z
        })
        .collect()
}

fn last_two(before: [i32; 2], block: &[i32]) -> [i32; 2] {
    match block {
        [.., a, b] => [*a, *b],
        [a] => [before[1], *a],
        [] => before,
    }
}

fn zigzag(v: i32) -> u32 {
    (v << 1 ^ v >> 31) as u32
}

fn unzigzag(z: u32) -> i32 {
    (z >> 1) as i32 ^ -((z & 1) as i32)
}

/// The width that costs fewest bits, exceptions (5 bytes each) included.
fn best_width(residuals: &[u32]) -> (u32, usize) {
    let mut longer_than = [0usize; 33];
    for &z in residuals {
        let bits = 32 - z.leading_zeros();
        longer_than[..bits as usize].iter_mut().for_each(|n| *n += 1);
    }
    (0..=32u32)
        .map(|w| (w, residuals.len() * w as usize + 40 * longer_than[w as usize]))
        .min_by_key(|&(_, cost)| cost)
        .unwrap_or((32, 0))
}

fn write_block(order: u8, width: u32, residuals: &[u32], out: &mut Vec<u8>) {
    let fits = |z: u32| width == 32 || z >> width == 0;
    let exceptions: Vec<usize> = (0..residuals.len()).filter(|&i| !fits(residuals[i])).collect();
    out.put(&[order << 6 | width as u8, exceptions.len() as u8]);
    let (mut pending, mut bits) = (0u64, 0);
    for &z in residuals {
        let low = if width == 32 { z } else { z & ((1 << width) - 1) };
        pending |= u64::from(low) << bits;
        bits += width;
        while bits >= 8 {
            out.push(pending as u8);
            pending >>= 8;
            bits -= 8;
        }
    }
    if bits > 0 {
        out.push(pending as u8);
    }
    for i in exceptions {
        out.push(i as u8);
        out.put_u32(residuals[i]);
    }
}

/// Fills `residuals` from the next block and returns its order of differences.
fn read_block(r: &mut Reader, residuals: &mut [u32]) -> Result<u8> {
    let head = r.u8()?;
    let (order, width) = (head >> 6, u32::from(head & 63));
    let exceptions = r.u8()?;
    if !(1..=2).contains(&order) || width > 32 {
        return Err(r.bad(format!("block head {head:#04x} is unknown")));
    }
    let packed = r.take((residuals.len() * width as usize).div_ceil(8))?;
    let mask = if width == 32 { u32::MAX } else { (1 << width) - 1 };
    let (mut pending, mut bits, mut at) = (0u64, 0, 0);
    for z in residuals.iter_mut() {
        while bits < width {
            pending |= u64::from(packed[at]) << bits;
            at += 1;
            bits += 8;
        }
        *z = pending as u32 & mask;
        pending >>= width;
        bits -= width;
    }
    for _ in 0..exceptions {
        let place = usize::from(r.u8()?);
        let value = r.u32()?;
        let Some(slot) = residuals.get_mut(place) else {
            return Err(r.bad(format!("exception at place {place} of a block of {}", residuals.len())));
        };
        *slot = value;
    }
    Ok(order)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn any_column_round_trips(values in prop::collection::vec(any::<i32>(), 0..300), smooth: bool) {
            let values: Vec<i32> = if smooth { values.iter().enumerate().map(|(i, v)| i as i32 * 240 + v % 20).collect() } else { values };
            let mut bytes = Vec::new();
            pack(&values, &mut bytes);
            let mut r = Reader::new(&bytes, "t");
            prop_assert_eq!(unpack(&mut r, values.len()).unwrap(), values);
            r.finish().unwrap();
        }

        #[test]
        fn damaged_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..400), count in 0usize..5000) {
            let _ = unpack(&mut Reader::new(&bytes, "t"), count);
        }
    }

    #[test]
    fn scan_lines_pack_small() {
        // A line of 64 values 240 apart with ±10 of noise, then a jump back: 12 bits or fewer a value.
        let values: Vec<i32> = (0..4096).map(|i| (i % 64) * 240 + (i * 7919 % 21) - 10).collect();
        let mut bytes = Vec::new();
        pack(&values, &mut bytes);
        assert!(bytes.len() * 8 < 4096 * 12, "{}", bytes.len());
    }
}
