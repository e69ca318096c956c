//! From numbers to the whole numbers beside them.

/// The greatest whole number that is not greater. `f64::floor` is a call into the C library where the processor's own
/// instruction may not be taken for granted.
#[inline]
pub fn floor(x: f64) -> i64 {
    let cut = x as i64;
    cut - i64::from(x < cut as f64)
}

/// The least whole number that is not less.
#[inline]
pub fn ceil(x: f64) -> i64 {
    let cut = x as i64;
    cut + i64::from(x > cut as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn as_the_library_says(x in -1e15..1e15f64, whole: bool) {
            let x = if whole { x.round() } else { x };
            prop_assert_eq!((floor(x), ceil(x)), (x.floor() as i64, x.ceil() as i64));
        }
    }
}
