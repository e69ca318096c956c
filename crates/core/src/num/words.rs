//! Stored values that are `name=value` words (parameters): their text in a container with a version and a checksum. What
//! a later release adds is a word.

use super::sections::{HEADER, begin, put_section, read};
use crate::NEVER;
use crate::error::{Error, Result};

/// A type of such values.
#[derive(Debug, Clone, Copy)]
pub struct Words {
    /// SQL name, for messages.
    pub ty: &'static str,
    /// Tells its values from those of other types.
    pub letter: u8,
}

impl Words {
    /// Of the layout.
    pub const VERSION: u8 = 1;

    /// The value of these words.
    pub fn encode(self, text: &str) -> Result<Vec<u8>> {
        let mut out = Vec::new();
        begin(Self::VERSION, self.letter, [0; 2], &mut out);
        put_section(HEADER, &mut out, NEVER, |out| {
            out.extend_from_slice(text.as_bytes());
            Ok(())
        })?;
        Ok(out)
    }

    /// What `parse` makes of a value's words.
    pub fn decode<T>(self, bytes: &[u8], parse: impl FnOnce(&str) -> Result<T>) -> Result<T> {
        match bytes {
            [version, letter, ..] if *letter == self.letter && *version > 0 => {
                if *version > Self::VERSION {
                    return Err(Error::Version { ty: self.ty, found: *version, known: Self::VERSION });
                }
            }
            _ => return Err(Error::binary(self.ty, "it does not begin as one does")),
        }
        let [content] = read(bytes, self.ty, [HEADER], NEVER)?;
        let text = std::str::from_utf8(content).map_err(|_| Error::binary(self.ty, "its words are no text"))?;
        parse(text).map_err(|e| Error::binary(self.ty, e.to_string()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEST: Words = Words { ty: "ab_test", letter: b'T' };

    #[test]
    fn words_come_back_and_damage_is_noticed() {
        let parse =
            |text: &str| if text.contains('?') { Err(Error::syntax("ab_test", text)) } else { Ok(text.to_owned()) };
        let bytes = TEST.encode("a=1 b=x").unwrap();
        assert_eq!(TEST.decode(&bytes, parse).unwrap(), "a=1 b=x");
        assert_eq!(TEST.decode(&TEST.encode("").unwrap(), parse).unwrap(), "");
        for i in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[i] ^= 1;
            assert!(TEST.decode(&damaged, parse).is_err(), "byte {i}");
            assert!(TEST.decode(&bytes[..i], parse).is_err(), "{i} bytes");
        }
        assert!(matches!(TEST.decode(&TEST.encode("?").unwrap(), parse), Err(Error::Binary { .. })));
        let newer = [&[2][..], &bytes[1..]].concat();
        assert!(matches!(TEST.decode(&newer, parse), Err(Error::Version { found: 2, known: 1, .. })));
        assert!(Words { letter: b'U', ..TEST }.decode(&bytes, parse).is_err());
    }
}
