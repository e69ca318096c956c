//! Intensity and colour as SQL gives them.

use asbuilt_core::{Error, Result};

use crate::pg::Args;

/// Intensities of argument `i`, an `integer[]`; NULL, or no such argument (`_ab_scan_010`), for none.
pub fn intensity(args: &Args, i: usize) -> Result<Option<Vec<u16>>> {
    if !args.has(i) {
        return Ok(None);
    }
    args.i32_list(i, "the intensities")?.into_iter().map(one_intensity).collect::<Result<_>>().map(Some)
}

/// Colours of argument `i`, an `integer[]` of n x 3; NULL for none.
pub fn colour(args: &Args, i: usize) -> Result<Option<Vec<[u8; 3]>>> {
    if !args.has(i) {
        return Ok(None);
    }
    args.i32_triples(i, "the colours")?.into_iter().map(one_colour).collect::<Result<_>>().map(Some)
}

/// One intensity.
pub fn one_intensity(value: i32) -> Result<u16> {
    u16::try_from(value).map_err(|_| Error::argument("an intensity", "from 0 to 65535", value))
}

/// One colour: red, green, blue.
pub fn one_colour(value: [i32; 3]) -> Result<[u8; 3]> {
    let part = |v: i32| u8::try_from(v).map_err(|_| Error::argument("a colour", "from 0 to 255", v));
    Ok([part(value[0])?, part(value[1])?, part(value[2])?])
}
