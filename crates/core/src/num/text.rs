//! Text forms that lose nothing: shortest decimals, hexadecimal bytes.

use crate::error::{Error, Result};
use crate::{Grow, Interrupt, poll, room};

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

/// Bytes converted between two looks at the interrupt.
const PIECE: usize = 1 << 20;

/// `prefix` and then the bytes in hexadecimal: the lossless text form of the variable-length types.
pub fn to_hex(prefix: &str, bytes: &[u8], interrupt: Interrupt) -> Result<String> {
    room::<u8>(prefix.len() + 2 * bytes.len(), interrupt)?;
    let mut out = String::with_capacity(prefix.len() + 2 * bytes.len());
    out.push_str(prefix);
    for piece in bytes.chunks(PIECE) {
        poll(interrupt)?;
        out.push_str(&hex::encode(piece));
    }
    Ok(out)
}

/// Reads what [`to_hex`] wrote; `ty` is the SQL type for the error message.
pub fn from_hex(ty: &'static str, prefix: &str, text: &[u8], interrupt: Interrupt) -> Result<Vec<u8>> {
    let bad = || Error::syntax(ty, &String::from_utf8_lossy(&text[..text.len().min(200)]));
    let digits = text.trim_ascii().strip_prefix(prefix.as_bytes()).ok_or_else(bad)?;
    if digits.len() % 2 != 0 {
        return Err(bad());
    }
    let mut out = Vec::new();
    out.grow(digits.len() / 2, interrupt)?;
    for piece in digits.chunks(PIECE) {
        poll(interrupt)?;
        let start = out.len();
        out.resize(start + piece.len() / 2, 0);
        hex::decode_to_slice(piece, &mut out[start..]).map_err(|_| bad())?;
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
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
            let text = to_hex("T1:", &bytes, NEVER).unwrap();
            prop_assert_eq!(from_hex("t", "T1:", text.as_bytes(), NEVER).unwrap(), bytes);
        }

        #[test]
        fn any_text_is_refused_or_read(text in "\\PC*") {
            let _ = from_hex("t", "T1:", text.as_bytes(), NEVER);
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
