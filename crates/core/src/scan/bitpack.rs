//! One column of integers as bit-packed differences.
//!
//! Blocks of [`BLOCK`] values. Each value is predicted from the one before; in a column that follows a leading one,
//! also from the leading column's step times the block's slope: range noise moves a return along its beam, so two
//! coordinates follow the third. The remainder, less the block's reference (the regular step of the scan line), is
//! zigzag coded in the number of bits that costs least; values that need more (the jump to the next scan line) are
//! exceptions. After Zukowski et al. 2006 (PFOR-DELTA). Arithmetic wraps, so any `i32` column is carried exactly.
//!
//! Block layout: width u8, exceptions u8, slope i16 (only with a leading column), reference varint (signed), the packed
//! low bits (`width` × values, LSB first, padded to a byte), then per exception its place u8 and its value varint.

use crate::error::Result;
use crate::num::bytes::{ByteReader, Put};

/// Values in a block.
pub const BLOCK: usize = 64;
/// Unit of a slope: 2⁻¹², so that slopes of up to ±8 are held.
const SLOPE_BITS: u32 = 12;

/// A block's prediction apart from the preceding value: slope against the leading column, and the regular step.
#[derive(Debug, Clone, Copy)]
struct BlockPredictor {
    slope: i16,
    reference: i32,
}

impl BlockPredictor {
    /// How much the value should grow where the leading column grows by `lead`.
    fn step(self, lead: i32) -> i32 {
        self.along(lead).wrapping_add(self.reference)
    }

    /// The leading column's part in that.
    fn along(self, lead: i32) -> i32 {
        ((i64::from(self.slope) * i64::from(lead)) >> SLOPE_BITS) as i32
    }
}

/// Appends `values` to `out`; `lead` is the column of the same length that they follow, if any.
pub fn pack(values: &[i32], lead: Option<&[i32]>, out: &mut Vec<u8>) {
    let mut before = [0i32; 2];
    for (i, block) in values.chunks(BLOCK).enumerate() {
        let leading = lead.map(|l| &l[i * BLOCK..i * BLOCK + block.len()]);
        let slope = leading.map_or(0, |l| slope(l[l.len() / 2], block[block.len() / 2]));
        let mut model = BlockPredictor { slope, reference: 0 };
        let mut steps: Vec<i32> = residuals_of(block, leading, before, model).collect();
        let middle = steps.len() / 2;
        model.reference = *steps.select_nth_unstable(middle).1;
        let residuals: Vec<u32> = residuals_of(block, leading, before, model).map(zigzag).collect();
        write_block(model, lead.is_some(), &residuals, out);
        before = [block[block.len() - 1], leading.map_or(0, |l| l[l.len() - 1])];
    }
}

/// Reads `count` values that were packed with the leading column `lead`.
pub fn unpack(r: &mut ByteReader, count: usize, lead: Option<&[i32]>) -> Result<Vec<i32>> {
    let mut out = Vec::with_capacity(count);
    let mut before = [0i32; 2];
    let mut residuals = [0u32; BLOCK];
    // Steps first, which vectorise, then their running sum, which does not.
    let mut steps = [0i32; BLOCK];
    while out.len() < count {
        let start = out.len();
        let n = BLOCK.min(count - start);
        let model = read_block(r, lead.is_some(), n, &mut residuals)?;
        for (step, &z) in steps.iter_mut().zip(&residuals) {
            *step = unzigzag(z).wrapping_add(model.reference);
        }
        if let Some(lead) = lead {
            let block = &lead[start..start + n];
            steps[0] = steps[0].wrapping_add(model.along(block[0].wrapping_sub(before[1])));
            for (step, pair) in steps[1..].iter_mut().zip(block.windows(2)) {
                *step = step.wrapping_add(model.along(pair[1].wrapping_sub(pair[0])));
            }
            before[1] = block[n - 1];
        }
        out.extend(steps[..n].iter().map(|&step| {
            before[0] = before[0].wrapping_add(step);
            before[0]
        }));
    }
    Ok(out)
}

/// The slope of a beam: its coordinate over the leading one.
fn slope(lead: i32, value: i32) -> i16 {
    if lead == 0 {
        return 0;
    }
    let exact = f64::from(value) / f64::from(lead) * f64::from(1u32 << SLOPE_BITS);
    exact.round().clamp(f64::from(i16::MIN), f64::from(i16::MAX)) as i16
}

fn residuals_of<'a>(
    block: &'a [i32],
    lead: Option<&'a [i32]>,
    mut before: [i32; 2],
    model: BlockPredictor,
) -> impl Iterator<Item = i32> + 'a {
    block.iter().enumerate().map(move |(i, &v)| {
        let l = lead.map_or(0, |l| l[i]);
        let residual = v.wrapping_sub(before[0]).wrapping_sub(model.step(l.wrapping_sub(before[1])));
        before = [v, l];
        residual
    })
}

fn zigzag(v: i32) -> u32 {
    (v << 1 ^ v >> 31) as u32
}

fn unzigzag(z: u32) -> i32 {
    (z >> 1) as i32 ^ -((z & 1) as i32)
}

/// The width that costs fewest bits, including exceptions (about four bytes each).
fn best_width(residuals: &[u32]) -> u32 {
    let mut longer_than = [0usize; 33];
    for &z in residuals {
        let bits = 32 - z.leading_zeros();
        longer_than[..bits as usize].iter_mut().for_each(|n| *n += 1);
    }
    (0..=32u32).min_by_key(|&w| residuals.len() * w as usize + 32 * longer_than[w as usize]).unwrap_or(32)
}

fn write_block(model: BlockPredictor, led: bool, residuals: &[u32], out: &mut Vec<u8>) {
    let width = best_width(residuals);
    let fits = |z: u32| width == 32 || z >> width == 0;
    let exceptions: Vec<usize> = (0..residuals.len()).filter(|&i| !fits(residuals[i])).collect();
    out.put(&[width as u8, exceptions.len() as u8]);
    if led {
        out.put(&model.slope.to_le_bytes());
    }
    out.put_varint_signed(i64::from(model.reference));
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
        out.put_varint(u64::from(residuals[i]));
    }
}

/// Fills the first `n` of `residuals` from the next block and returns its model.
fn read_block(r: &mut ByteReader, led: bool, n: usize, residuals: &mut [u32; BLOCK]) -> Result<BlockPredictor> {
    let (width, exceptions) = (u32::from(r.u8()?), r.u8()?);
    let Some(unpack) = UNPACK.get(width as usize) else {
        return Err(r.bad(format!("a block of {width} bits a value")));
    };
    let slope = if led { i16::from_le_bytes([r.u8()?, r.u8()?]) } else { 0 };
    let reference = r.varint_signed()? as i32;
    let mut packed = [0u8; PACKED];
    let bytes = r.take((n * width as usize).div_ceil(8))?;
    packed[..bytes.len()].copy_from_slice(bytes);
    unpack(&packed, residuals);
    for _ in 0..exceptions {
        let place = usize::from(r.u8()?);
        let value = u32::try_from(r.varint()?).map_err(|_| r.bad("an exception longer than 32 bits"))?;
        let Some(slot) = residuals[..n].get_mut(place) else {
            return Err(r.bad(format!("exception at place {place} of a block of {n}")));
        };
        *slot = value;
    }
    Ok(BlockPredictor { slope, reference })
}

/// A block at 32 bits per value, with room behind it so that every value can be read as eight bytes at once.
const PACKED: usize = BLOCK * 4 + 8;

type Unpack = fn(&[u8; PACKED], &mut [u32; BLOCK]);

/// One unpacking loop per width, so that the compiler knows every shift.
const UNPACK: [Unpack; 33] = [
    at::<0>, at::<1>, at::<2>, at::<3>, at::<4>, at::<5>, at::<6>, at::<7>, at::<8>, at::<9>, at::<10>, at::<11>,
    at::<12>, at::<13>, at::<14>, at::<15>, at::<16>, at::<17>, at::<18>, at::<19>, at::<20>, at::<21>, at::<22>,
    at::<23>, at::<24>, at::<25>, at::<26>, at::<27>, at::<28>, at::<29>, at::<30>, at::<31>, at::<32>,
];

fn at<const WIDTH: usize>(packed: &[u8; PACKED], residuals: &mut [u32; BLOCK]) {
    let mask = ((1u64 << WIDTH) - 1) as u32;
    for (i, z) in residuals.iter_mut().enumerate() {
        let bit = i * WIDTH;
        let eight: [u8; 8] = std::array::from_fn(|k| packed[bit / 8 + k]);
        *z = (u64::from_le_bytes(eight) >> (bit % 8)) as u32 & mask;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn any_column_round_trips(pairs in prop::collection::vec(any::<[i32; 2]>(), 0..300), smooth: bool, led: bool) {
            let column = |k: usize| -> Vec<i32> {
                let value = |(i, p): (usize, &[i32; 2])| if smooth { i as i32 * 240 + p[k] % 20 } else { p[k] };
                pairs.iter().enumerate().map(value).collect()
            };
            let (values, lead) = (column(0), column(1));
            let lead = led.then_some(&lead[..]);
            let mut bytes = Vec::new();
            pack(&values, lead, &mut bytes);
            let mut r = ByteReader::new(&bytes, "t");
            prop_assert_eq!(unpack(&mut r, values.len(), lead).unwrap(), values);
            r.finish().unwrap();
        }

        #[test]
        fn damaged_bytes_never_panic(
            bytes in prop::collection::vec(any::<u8>(), 0..400),
            count in 0usize..5000,
            led: bool,
        ) {
            let lead = vec![7; count];
            let _ = unpack(&mut ByteReader::new(&bytes, "t"), count, led.then_some(&lead[..]));
        }
    }

    #[test]
    fn scan_lines_pack_small() {
        // A line of 64 values 240 apart with ±10 of noise, then a jump back: 7 bits or fewer a value.
        let values: Vec<i32> = (0..4096).map(|i| (i % 64) * 240 + (i * 7919 % 21) - 10).collect();
        let mut bytes = Vec::new();
        pack(&values, None, &mut bytes);
        assert!(bytes.len() * 8 < 4096 * 7, "{}", bytes.len());
    }

    #[test]
    fn what_follows_the_leading_column_costs_little() {
        // Noise along the beam in both columns: the second is 0.7 of the first.
        let lead: Vec<i32> = (0..4096).map(|i| 50_000 + (i * 7919 % 401) - 200).collect();
        let values: Vec<i32> = lead.iter().map(|l| (f64::from(*l) * 0.7).round() as i32).collect();
        let mut bytes = Vec::new();
        pack(&values, Some(&lead), &mut bytes);
        assert!(bytes.len() * 8 < 4096 * 4, "{}", bytes.len());
    }
}
