//! How large a coordinate may be.

use crate::error::{Error, Result};

/// Largest coordinate, metres: a hundred times that of any projected system.
const MAX_COORDINATE_M: f64 = 1e9;

/// Fails where a coordinate is not finite or too large; `what` names it. World metres.
pub fn check_coordinates<'a>(what: &'static str, all: impl IntoIterator<Item = &'a f64>) -> Result<()> {
    match all.into_iter().find(|c| !(-MAX_COORDINATE_M..=MAX_COORDINATE_M).contains(*c)) {
        Some(c) => Err(Error::argument(what, "finite and within 1e9 m", c)),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_included() {
        assert!(check_coordinates("x", &[0.0, 1e9, -1e9]).is_ok());
        for bad in [f64::NAN, f64::INFINITY, -1.000001e9] {
            assert!(check_coordinates("x", &[0.0, bad]).is_err());
        }
    }
}
