//! What surrounds a STEP file: byte order marks, comments and blanks before it, anything after it; UTF-16.

use std::borrow::Cow;

use encoding_rs::{Encoding, UTF_16BE, UTF_16LE};

use super::record::skip_blank;

const BEGINNING: &[u8] = b"ISO-10303-21";
const END: &[u8] = b"END-ISO-10303-21";

/// The file from `ISO-10303-21` up to and including `END-ISO-10303-21;`, in an encoding that extends ASCII.
pub fn open<'a>(bytes: &'a [u8], words: &mut Vec<String>) -> Result<Cow<'a, [u8]>, String> {
    match bytes {
        [0xFF, 0xFE, rest @ ..] => Ok(Cow::Owned(trim(&utf16(rest, UTF_16LE), words)?.to_vec())),
        [0xFE, 0xFF, rest @ ..] => Ok(Cow::Owned(trim(&utf16(rest, UTF_16BE), words)?.to_vec())),
        [b'I', 0, b'S', 0, ..] => Ok(Cow::Owned(trim(&utf16(bytes, UTF_16LE), words)?.to_vec())),
        [0, b'I', 0, b'S', ..] => Ok(Cow::Owned(trim(&utf16(bytes, UTF_16BE), words)?.to_vec())),
        _ => trim(bytes, words).map(Cow::Borrowed),
    }
}

/// Half a code unit at the end is ignored.
fn utf16(bytes: &[u8], encoding: &'static Encoding) -> Vec<u8> {
    let whole = &bytes[..bytes.len() & !1];
    encoding.decode_without_bom_handling(whole).0.into_owned().into_bytes()
}

fn trim<'a>(mut bytes: &'a [u8], words: &mut Vec<String>) -> Result<&'a [u8], String> {
    // Tools that put a mark before a file with a mark leave two.
    while let Some(rest) = bytes.strip_prefix(b"\xEF\xBB\xBF") {
        bytes = rest;
    }
    let text = &bytes[skip_blank(bytes, 0)..];
    if !text.starts_with(BEGINNING) {
        let seen = String::from_utf8_lossy(&text[..text.len().min(24)]).into_owned();
        let hint = match text {
            [b'P', b'K', ..] => "it is a ZIP archive (ifcZIP): unpack it",
            [b'<', ..] => "it is XML (ifcXML): export it as STEP (.ifc)",
            [b'{' | b'[', ..] => "it is JSON (IFC5, ifcJSON): export it as STEP (.ifc)",
            _ => "export it again as STEP (.ifc)",
        };
        return Err(format!("not an IFC file in STEP form: it starts with {seen:?}, not with ISO-10303-21; {hint}"));
    }
    let at = text.windows(END.len()).rposition(|w| w == END).ok_or_else(|| {
        let shown = String::from_utf8_lossy(&text[text.len().saturating_sub(40)..]).trim_end().to_owned();
        format!(
            "the file is cut short: no END-ISO-10303-21 at its end, it ends with {shown:?}; copy or export it again"
        )
    })?;
    let end = skip_blank(text, at + END.len());
    let end = if text.get(end) == Some(&b';') { end + 1 } else { end };
    let behind = text.len() - skip_blank(text, end);
    if behind > 0 {
        words.push(format!("{behind} bytes behind END-ISO-10303-21 were passed over"));
    }
    Ok(&text[..end])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn opened(bytes: &[u8]) -> (Result<Vec<u8>, String>, usize) {
        let mut words = Vec::new();
        (open(bytes, &mut words).map(Cow::into_owned), words.len())
    }

    #[test]
    fn what_stands_around_is_passed_over() {
        let file = b"ISO-10303-21;\nDATA;ENDSEC;\nEND-ISO-10303-21;".to_vec();
        let around = |before: &[u8], after: &[u8]| [before, &file, after].concat();
        assert_eq!(opened(&around(b"\xEF\xBB\xBF", b"\r\n")), (Ok(file.clone()), 0));
        assert_eq!(opened(&around(b"/* made by X */\n\n", &[b'\n'; 6000])), (Ok(file.clone()), 0));
        assert_eq!(opened(&around(b"\xEF\xBB\xBF /* a */ /* b */", &[0; 9000])), (Ok(file.clone()), 0));
        assert_eq!(opened(&around(b"", b"\nrubbish")), (Ok(file.clone()), 1));
        let wide: Vec<u8> = file.iter().flat_map(|&b| [b, 0]).collect();
        assert_eq!(opened(&[b"\xFF\xFE", &wide[..]].concat()), (Ok(file.clone()), 0));
        assert_eq!(opened(&wide), (Ok(file.clone()), 0));
        let big: Vec<u8> = file.iter().flat_map(|&b| [0, b]).collect();
        assert_eq!(opened(&big), (Ok(file.clone()), 0));
        assert_eq!(opened(&around(b"\xEF\xBB\xBF\xEF\xBB\xBF", b"")), (Ok(file), 0));
    }

    #[test]
    fn what_is_no_file_says_what_it_is() {
        for (bytes, word) in [(&b"PK\x03\x04"[..], "ZIP"), (b"<?xml", "XML"), (b"ISO-10303-21;DATA;#1=A(", "cut short")]
        {
            assert!(opened(bytes).0.unwrap_err().contains(word));
        }
        assert!(opened(b"").0.is_err());
    }
}
