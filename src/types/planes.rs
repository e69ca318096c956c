//! Intensity and colour as SQL gives them.

use asbuilt_core::scan::check_count;
use asbuilt_core::{Error, Result};

use crate::pg::I32Array;

/// Intensities.
pub fn intensity(values: Option<&I32Array>) -> Result<Option<Vec<u16>>> {
    let Some(values) = values else { return Ok(None) };
    check_count(values.rows())?;
    values.list("the intensities")?.into_iter().map(one_intensity).collect::<Result<_>>().map(Some)
}

/// Colours: n x 3.
pub fn colour(values: Option<&I32Array>) -> Result<Option<Vec<[u8; 3]>>> {
    let Some(values) = values else { return Ok(None) };
    check_count(values.rows())?;
    values.triples("the colours")?.into_iter().map(one_colour).collect::<Result<_>>().map(Some)
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
