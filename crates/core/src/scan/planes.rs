//! The optional attributes stored behind the beams: starts, intensity, colour.

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

fn narrow<T: TryFrom<i32>>(r: &ByteReader, value: i32) -> Result<T> {
    T::try_from(value).map_err(|_| r.bad(format!("intensity or colour {value}")))
}
