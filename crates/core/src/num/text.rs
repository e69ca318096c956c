//! Text forms that lose nothing: shortest decimals, hexadecimal bytes.

use crate::error::{Error, Result};

/// The shortest decimal that reads back as the same number; exponent form outside 1e-5…1e15.
pub fn number(x: f64) -> String {
    let text = format!("{x:?}");
    match text.strip_suffix(".0") {
        Some(whole) => whole.to_string(),
        None => text,
    }
}

/// Reads `count` finite numbers separated by blanks or commas.
pub fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let mut out = [0.0; N];
    let mut words = text.split([' ', ',', '\t', '\n']).filter(|w| !w.is_empty());
    for slot in &mut out {
        *slot = words.next()?.parse().ok().filter(|x: &f64| x.is_finite())?;
    }
    words.next().is_none().then_some(out)
}

/// `prefix` and then the bytes in hexadecimal: the lossless text form of the variable-length types.
pub fn to_hex(prefix: &str, bytes: &[u8]) -> String {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let mut out = String::with_capacity(prefix.len() + 2 * bytes.len());
    out.push_str(prefix);
    for &b in bytes {
        out.push(DIGITS[usize::from(b >> 4)] as char);
        out.push(DIGITS[usize::from(b & 15)] as char);
    }
    out
}

/// Reads what [`to_hex`] wrote; `ty` is the SQL type for the error message.
pub fn from_hex(ty: &'static str, prefix: &str, text: &str) -> Result<Vec<u8>> {
    let bad = || Error::syntax(ty, text);
    let digits = text.trim().strip_prefix(prefix).ok_or_else(bad)?.as_bytes();
    if digits.len() % 2 != 0 {
        return Err(bad());
    }
    let nibble = |d: u8| (d as char).to_digit(16).map(|v| v as u8).ok_or_else(bad);
    digits.chunks_exact(2).map(|p| Ok(nibble(p[0])? << 4 | nibble(p[1])?)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn numbers_round_trip(bits: u64) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            let back = number(x).parse::<f64>().unwrap();
            prop_assert_eq!(back.to_bits(), bits);
        }

        #[test]
        fn hex_round_trips(bytes: Vec<u8>) {
            prop_assert_eq!(from_hex("t", "T1:", &to_hex("T1:", &bytes)).unwrap(), bytes);
        }

        #[test]
        fn any_text_is_refused_or_read(text in "\\PC*") {
            let _ = from_hex("t", "T1:", &text);
            let _ = numbers::<3>(&text);
        }
    }

    #[test]
    fn refuses_what_is_not_a_number() {
        assert_eq!(numbers::<3>("1 2,3"), Some([1.0, 2.0, 3.0]));
        for bad in ["1 2", "1 2 3 4", "1 2 nan", "1 2 inf", "1 2 x", ""] {
            assert_eq!(numbers::<3>(bad), None, "{bad}");
        }
        assert_eq!(number(1.0), "1");
        assert_eq!(number(-0.1), "-0.1");
    }
}
