//! Stored values as containers of tagged sections, each with a checksum of its own.
//!
//! Layout, little-endian: version u8, the type's letter u8, two bytes of notes whose meaning is the type's; then
//! sections of tag u32, length u32, CRC-32 u32 and content of that length. The checksum covers tag, length and content,
//! that of the first section ([`HEADER`], readable from a prefix) the four bytes before it too. What a later release
//! adds is a section: readers that do not know its tag skip it, unless the tag is [`REQUIRED`]; then they refuse the
//! value.

use super::bytes::{ByteReader, Put};
use crate::error::{Error, Limited, Result};
use crate::{Interrupt, poll};

/// Bit of the tags without which a value cannot be understood.
pub const REQUIRED: u32 = 1 << 31;
/// The first section: of fixed length, with what is asked for often.
pub const HEADER: u32 = REQUIRED | 1;
/// What the header describes.
pub const BODY: u32 = REQUIRED | 2;

/// Bytes before the first section.
const PREAMBLE: usize = 4;
/// Bytes before a section's content.
const HEAD: usize = 12;
/// Most bytes that PostgreSQL stores in a value.
const MAX_STORED: usize = (1 << 30) - (1 << 10);

/// Bytes of a value up to the end of a header of this length.
pub const fn header_end(content: usize) -> usize {
    PREAMBLE + HEAD + content
}

/// Begins a container.
pub fn begin(version: u8, letter: u8, notes: [u8; 2], out: &mut Vec<u8>) {
    out.put(&[version, letter, notes[0], notes[1]]);
}

/// Appends a section whose content `write` appends.
pub fn put_section(
    tag: u32,
    out: &mut Vec<u8>,
    interrupt: Interrupt,
    write: impl FnOnce(&mut Vec<u8>) -> Result<()>,
) -> Result<()> {
    let start = out.len();
    out.put_u32(tag);
    out.put(&[0; 8]);
    write(out)?;
    let len = out.len() - start - HEAD;
    if out.len() > MAX_STORED {
        let value = format!("{} MB", out.len() >> 20);
        return Err(Error::Limit { what: Limited::StoredForm, value, limit: "1 GB".into() });
    }
    out[start + 4..start + 8].copy_from_slice(&(len as u32).to_le_bytes());
    let checksum = checksum(&[preamble_of(out, start), &out[start..start + 8], &out[start + HEAD..]], interrupt)?;
    out[start + 8..start + HEAD].copy_from_slice(&checksum.to_le_bytes());
    Ok(())
}

/// The first section's checksum covers what stands before it.
fn preamble_of(bytes: &[u8], start: usize) -> &[u8] {
    if start == PREAMBLE { &bytes[..PREAMBLE] } else { &[] }
}

/// CRC-32 of some pieces, one after the other; asks the interrupt after every megabyte.
pub fn checksum(pieces: &[&[u8]], interrupt: Interrupt) -> Result<u32> {
    const MEGABYTE: usize = 1 << 20;
    let mut hasher = crc32fast::Hasher::new();
    for part in pieces.iter().flat_map(|piece| piece.chunks(MEGABYTE)) {
        hasher.update(part);
        if part.len() == MEGABYTE {
            poll(interrupt)?;
        }
    }
    Ok(hasher.finalize())
}

/// The content of the header of a value of type `ty`, of which at least [`header_end`] bytes are there.
pub fn header<'a>(bytes: &'a [u8], ty: &'static str, interrupt: Interrupt) -> Result<ByteReader<'a>> {
    match next(bytes, PREAMBLE, ty, interrupt)? {
        (HEADER, content, _) => Ok(ByteReader::new(content, ty)),
        _ => Err(Error::binary(ty, "it does not begin with its header")),
    }
}

/// The contents of the sections with these tags, all of which must be there; all checksums are checked.
pub fn read<'a, const N: usize>(
    bytes: &'a [u8],
    ty: &'static str,
    tags: [u32; N],
    interrupt: Interrupt,
) -> Result<[&'a [u8]; N]> {
    let found = find(bytes, ty, tags, interrupt)?;
    if found.iter().any(Option::is_none) {
        return Err(Error::binary(ty, "a section is missing"));
    }
    Ok(found.map(Option::unwrap_or_default))
}

/// The contents of the sections with these tags, where they are there; all checksums are checked.
pub fn find<'a, const N: usize>(
    bytes: &'a [u8],
    ty: &'static str,
    tags: [u32; N],
    interrupt: Interrupt,
) -> Result<[Option<&'a [u8]>; N]> {
    let mut found: [Option<&[u8]>; N] = [None; N];
    let mut at = PREAMBLE;
    while at < bytes.len() {
        let (tag, content, end) = next(bytes, at, ty, interrupt)?;
        match tags.iter().position(|&t| t == tag) {
            Some(i) if found[i].is_none() => found[i] = Some(content),
            Some(_) => return Err(Error::binary(ty, format!("section {tag:#x} twice"))),
            None if tag & REQUIRED != 0 => return Err(Error::Section { ty, tag }),
            None => {}
        }
        at = end;
    }
    Ok(found)
}

/// Tag and content of the section at a place, and where it ends.
fn next<'a>(bytes: &'a [u8], at: usize, ty: &'static str, interrupt: Interrupt) -> Result<(u32, &'a [u8], usize)> {
    let mut r = ByteReader::new(bytes.get(at..).unwrap_or_default(), ty);
    let [tag, len, expected] = [r.u32()?, r.u32()?, r.u32()?];
    let content = r.take(len as usize)?;
    if checksum(&[preamble_of(bytes, at), &bytes[at..at + 8], content], interrupt)? != expected {
        return Err(Error::corrupted(ty, "the checksum does not match"));
    }
    Ok((tag, content, at + HEAD + content.len()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use proptest::prelude::*;

    const TY: &str = "ab_test";

    fn value(sections: &[(u32, &[u8])]) -> Vec<u8> {
        let mut out = Vec::new();
        begin(7, b'T', [1, 2], &mut out);
        for (tag, content) in sections {
            put_section(*tag, &mut out, NEVER, |out| {
                out.put(content);
                Ok(())
            })
            .unwrap();
        }
        out
    }

    #[test]
    fn what_is_not_known_is_passed_over_or_refused() {
        let bytes = value(&[(HEADER, b"head"), (5, b"a later release's"), (BODY, b"body")]);
        assert_eq!(read(&bytes, TY, [HEADER, BODY], NEVER).unwrap(), [&b"head"[..], b"body"]);
        assert_eq!(header(&bytes[..header_end(4)], TY, NEVER).unwrap().remaining(), 4);
        let bytes = value(&[(HEADER, b"head"), (REQUIRED | 5, b"a later release's"), (BODY, b"body")]);
        let refused = read(&bytes, TY, [HEADER, BODY], NEVER);
        assert_eq!(refused, Err(Error::Section { ty: TY, tag: REQUIRED | 5 }));
        assert!(read(&value(&[(HEADER, b"head")]), TY, [HEADER, BODY], NEVER).is_err());
        let bytes = value(&[(HEADER, b"head"), (5, b"more")]);
        let found = find(&bytes, TY, [HEADER, 5, 6], NEVER);
        assert_eq!(found.unwrap(), [Some(&b"head"[..]), Some(b"more"), None]);
        assert!(read(&value(&[(HEADER, b"a"), (HEADER, b"b")]), TY, [HEADER], NEVER).is_err());
    }

    proptest! {
        /// The version and the letter of the preamble are for the type to check.
        #[test]
        fn damage_is_noticed(
            body in prop::collection::vec(any::<u8>(), 0..200),
            at in any::<usize>(),
            x in 1u8..,
            cut in 0usize..3,
        ) {
            let mut bytes = value(&[(HEADER, b"head"), (9, b"optional"), (BODY, &body)]);
            let n = bytes.len();
            bytes[at % n] ^= x;
            bytes.truncate(n - cut);
            prop_assert!(read(&bytes, TY, [HEADER, BODY], NEVER).is_err());
        }
    }
}
