//! The optional attributes stored behind the beams: starts, intensity, colour; and their own steps.

use super::beams::Beams;
use super::bitpack;
use super::header::PatchHeader;
use crate::error::Result;
use crate::num::bytes::ByteReader;

/// Appends intensity, then colour (green, and red and blue that follow it), where present.
pub fn pack(content: &Beams, out: &mut Vec<u8>) {
    if let Some(intensity) = &content.intensity {
        bitpack::pack(&intensity.iter().map(|&v| i32::from(v)).collect::<Vec<_>>(), None, out);
    }
    if let Some(colour) = &content.colour {
        let [red, green, blue] = [0, 1, 2].map(|k| colour.iter().map(|c| i32::from(c[k])).collect::<Vec<_>>());
        bitpack::pack(&green, None, out);
        bitpack::pack(&red, Some(&green), out);
        bitpack::pack(&blue, Some(&green), out);
    }
}

/// Reads what [`pack`] wrote into `content`, whose beams have been read.
pub fn unpack(r: &mut ByteReader, flags: u8, content: &mut Beams) -> Result<()> {
    let n = content.len();
    if flags & PatchHeader::FLAG_INTENSITY != 0 {
        let column = bitpack::unpack(r, n, None)?;
        content.intensity = Some(column.into_iter().map(|v| narrow(r, v)).collect::<Result<_>>()?);
    }
    if flags & PatchHeader::FLAG_COLOUR != 0 {
        let green = bitpack::unpack(r, n, None)?;
        let [red, blue] = [bitpack::unpack(r, n, Some(&green))?, bitpack::unpack(r, n, Some(&green))?];
        let colour = |i: usize| Ok([narrow(r, red[i])?, narrow(r, green[i])?, narrow(r, blue[i])?]);
        content.colour = Some((0..n).map(colour).collect::<Result<_>>()?);
    }
    Ok(())
}

/// A step is stored as its logarithm, in so many parts of an octave of
const STEPS_PER_OCTAVE: f64 = 16.0;
/// this one, radians: to 2 %.
const UNIT_STEP: f64 = 1e-7;
/// Steps up to 6.5 rad.
const MAX_STORED_STEP: i32 = 415;

/// Appends the beams' own steps.
pub fn pack_steps(steps: &[f32], out: &mut Vec<u8>) {
    bitpack::pack(&steps.iter().map(|s| stored_step(*s)).collect::<Vec<_>>(), None, out);
}

/// Reads what [`pack_steps`] wrote.
pub fn unpack_steps(mut r: ByteReader, n: usize) -> Result<Vec<f32>> {
    let column = bitpack::unpack(&mut r, n, None)?;
    let Some(bad) = column.iter().find(|v| !(0..=MAX_STORED_STEP).contains(*v)) else {
        r.finish()?;
        return Ok(column.into_iter().map(restored_step).collect());
    };
    Err(r.bad(format!("step {bad}")))
}

/// The steps as a reader will see them.
pub fn restored_steps(steps: &[f32]) -> Vec<f32> {
    steps.iter().map(|s| restored_step(stored_step(*s))).collect()
}

fn stored_step(step: f32) -> i32 {
    let octaves = (f64::from(step) / UNIT_STEP).log2();
    ((octaves * STEPS_PER_OCTAVE).round() as i32).clamp(0, MAX_STORED_STEP)
}

fn restored_step(stored: i32) -> f32 {
    (UNIT_STEP * (f64::from(stored) / STEPS_PER_OCTAVE).exp2()) as f32
}

fn narrow<T: TryFrom<i32>>(r: &ByteReader, value: i32) -> Result<T> {
    T::try_from(value).map_err(|_| r.bad(format!("intensity or colour {value}")))
}
