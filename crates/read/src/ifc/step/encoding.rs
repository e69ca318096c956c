//! Names in encodings other than the standard's: bytes that are not UTF-8 are read as Latin-1 (Windows-1252).

use std::borrow::Cow;

use encoding_rs::WINDOWS_1252;

use super::document::Edits;
use super::record::{comment_end, string_end};

/// Every byte that is not UTF-8 is written in the standard's own way; `words` say how many texts there were.
pub fn readable<'a>(text: Cow<'a, [u8]>, words: &mut Vec<String>) -> Cow<'a, [u8]> {
    if std::str::from_utf8(&text).is_ok() {
        return text;
    }
    let (mut edits, mut texts, mut at) = (Edits::default(), 0, 0);
    while let Some(&b) = text.get(at) {
        let (piece, is_string) = match b {
            b'\'' => (at..string_end(&text, at), true),
            b'/' if text.get(at + 1) == Some(&b'*') => (at..comment_end(&text, at), false),
            _ => (at..at + 1, false),
        };
        at = piece.end;
        if piece.len() > 1 || b >= 0x80 {
            let bytes = &text[piece.clone()];
            if std::str::from_utf8(bytes).is_err() {
                texts += usize::from(is_string);
                let by = if is_string { escaped(bytes) } else { vec![b' '] };
                edits.replace(piece, by);
            }
        }
    }
    if texts > 0 {
        words.push(format!("texts that are neither ASCII nor UTF-8: {texts}; read as Latin-1 (Windows-1252)"));
    }
    Cow::Owned(edits.apply(&text))
}

/// `ä` as `\X2\00E4\X0\`.
fn escaped(bytes: &[u8]) -> Vec<u8> {
    let mut out = String::with_capacity(bytes.len() + 16);
    for c in WINDOWS_1252.decode_without_bom_handling(bytes).0.chars() {
        if c.is_ascii() {
            out.push(c);
        } else {
            out.push_str(&format!("\\X2\\{:04X}\\X0\\", u32::from(c)));
        }
    }
    out.into_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn latin1_is_escaped_and_utf8_left() {
        let mut words = Vec::new();
        let seen = readable(Cow::Borrowed(b"#1=A('W\xE4nde \x80');#2=B('W\xC3\xA4nde');/* \xFF */"), &mut words);
        let right = b"#1=A('W\\X2\\00E4\\X0\\nde \\X2\\20AC\\X0\\');#2=B('W\xC3\xA4nde'); ";
        assert_eq!(seen, &right[..]);
        assert_eq!(words.len(), 1);
        assert!(matches!(readable(Cow::Borrowed(b"'W\xC3\xA4nde'"), &mut words), Cow::Borrowed(_)));
    }
}
