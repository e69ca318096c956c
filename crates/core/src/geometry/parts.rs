//! Parts of a solid: which of its triangles are panes, which may stand elsewhere.

use crate::error::{Error, Limited, Result};
use crate::num::bytes::{ByteReader, Put};
use crate::{Grow, Interrupt, poll_now_and_then};

/// Bits of a part's flags as they are stored.
const TRANSPARENT: u8 = 1;
const MOVABLE: u8 = 2;

/// A part of a solid: a frame, a pane, a leaf.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Part {
    /// What it is called; never empty.
    pub name: Option<String>,
    /// Most beams pass it and return from behind: glass.
    pub is_transparent: bool,
    /// It may stand elsewhere than drawn without being built wrongly: a leaf, a sash.
    pub is_movable: bool,
}

/// For each triangle of a solid the number of its part, and what is known of each part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parts {
    of_triangle: Vec<u16>,
    list: Vec<Part>,
}

impl Parts {
    /// Most parts of one solid.
    pub const MAX_PARTS: usize = 1 << 16;
    /// Longest name of a part, bytes of UTF-8.
    pub const MAX_NAME_LEN: usize = 200;

    /// Parts by triangle. A part may be without triangles; an empty name is none.
    pub fn new(of_triangle: Vec<u16>, mut list: Vec<Part>) -> Result<Self> {
        if list.len() > Self::MAX_PARTS {
            let limit = Self::MAX_PARTS.to_string();
            return Err(Error::Limit { what: Limited::Parts, value: list.len().to_string(), limit });
        }
        for part in &mut list {
            part.name = part.name.take().filter(|name| !name.is_empty());
            part.name.as_deref().map_or(Ok(()), check_name)?;
        }
        if let Some(triangle) = of_triangle.iter().position(|&n| usize::from(n) >= list.len()) {
            let part = i64::from(of_triangle[triangle]);
            return Err(Error::PartNumber { triangle, part, parts: list.len() });
        }
        Ok(Self { of_triangle, list })
    }

    /// How many triangles are told of.
    pub fn triangles(&self) -> usize {
        self.of_triangle.len()
    }

    /// All parts, by their numbers.
    pub fn list(&self) -> &[Part] {
        &self.list
    }

    /// The number of triangle `t`'s part.
    pub fn number_of(&self, t: usize) -> usize {
        usize::from(self.of_triangle[t])
    }

    /// Triangle `t`'s part.
    pub fn part_of(&self, t: usize) -> &Part {
        &self.list[self.number_of(t)]
    }

    /// Whether they tell nothing: a single part without name and flags.
    pub fn is_plain(&self) -> bool {
        matches!(&self.list[..], [only] if *only == Part::default())
    }

    /// Appends them: the number of parts u32; for each its flags u8, the length of its name (LEB128) and the name; then
    /// runs of triangles of one part, its number and their count (LEB128).
    pub(super) fn put(&self, out: &mut Vec<u8>, interrupt: Interrupt) -> Result<()> {
        out.put_u32(self.list.len() as u32);
        for part in &self.list {
            let name = part.name.as_deref().unwrap_or_default();
            out.put(&[flags_of(part)]);
            out.put_varint(name.len() as u64);
            out.put(name.as_bytes());
        }
        for (round, run) in self.of_triangle.chunk_by(|a, b| a == b).enumerate() {
            poll_now_and_then(round, interrupt)?;
            out.grow(8, interrupt)?;
            out.put_varint(u64::from(run[0]));
            out.put_varint(run.len() as u64);
        }
        Ok(())
    }

    /// What [`Parts::put`] wrote for a solid of that many triangles.
    pub(super) fn read(bytes: &[u8], ty: &'static str, triangles: usize, interrupt: Interrupt) -> Result<Self> {
        let mut r = ByteReader::new(bytes, ty);
        let count = r.u32()? as usize;
        if count > Self::MAX_PARTS {
            return Err(r.bad(format!("{count} parts are more than {}", Self::MAX_PARTS)));
        }
        let list = (0..count).map(|_| read_part(&mut r)).collect::<Result<Vec<_>>>()?;
        let mut of_triangle = Vec::new();
        of_triangle.grow(triangles, interrupt)?;
        for round in 0.. {
            poll_now_and_then(round, interrupt)?;
            if r.remaining() == 0 {
                break;
            }
            let (number, length) = (r.varint()?, r.varint()?);
            let left = triangles - of_triangle.len();
            match u16::try_from(number) {
                Ok(number) if length > 0 && length <= left as u64 => {
                    of_triangle.resize(of_triangle.len() + length as usize, number);
                }
                _ => return Err(r.bad(format!("{length} triangles of part {number} where {left} are left"))),
            }
        }
        if of_triangle.len() < triangles {
            return Err(r.bad(format!("parts of {} triangles of {triangles}", of_triangle.len())));
        }
        Self::new(of_triangle, list).map_err(|e| Error::binary(ty, e.to_string()))
    }
}

fn check_name(name: &str) -> Result<()> {
    if name.len() > Parts::MAX_NAME_LEN {
        let (value, limit) = (format!("{} bytes", name.len()), format!("{} bytes", Parts::MAX_NAME_LEN));
        return Err(Error::Limit { what: Limited::PartName, value, limit });
    }
    if name.contains('\0') {
        return Err(Error::argument("a part's name", "text without zero bytes", format!("{name:?}")));
    }
    Ok(())
}

fn flags_of(part: &Part) -> u8 {
    u8::from(part.is_transparent) * TRANSPARENT + u8::from(part.is_movable) * MOVABLE
}

fn read_part(r: &mut ByteReader) -> Result<Part> {
    let flags = r.u8()?;
    if flags & !(TRANSPARENT | MOVABLE) != 0 {
        return Err(r.bad(format!("unknown flags {flags:#x} of a part")));
    }
    let length = r.varint()?;
    if length > Parts::MAX_NAME_LEN as u64 {
        return Err(r.bad(format!("a part's name of {length} bytes")));
    }
    let name = std::str::from_utf8(r.take(length as usize)?).map_err(|e| r.bad(format!("a part's name: {e}")))?;
    Ok(Part {
        name: (!name.is_empty()).then(|| name.to_owned()),
        is_transparent: flags & TRANSPARENT != 0,
        is_movable: flags & MOVABLE != 0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use proptest::prelude::*;

    fn part(name: &str, is_transparent: bool, is_movable: bool) -> Part {
        Part { name: (!name.is_empty()).then(|| name.into()), is_transparent, is_movable }
    }

    fn read(bytes: &[u8], triangles: usize) -> Result<Parts> {
        Parts::read(bytes, "ab_solid", triangles, NEVER)
    }

    #[test]
    fn limits_are_told_with_their_values() {
        let long = Parts::new(vec![], vec![part(&"x".repeat(201), false, false)]).unwrap_err();
        assert_eq!(long.to_string(), "the length of a part's name is 201 bytes; the most is 200 bytes");
        let many = Parts::new(vec![], vec![Part::default(); 65_537]).unwrap_err();
        assert_eq!(many.to_string(), "the number of parts is 65537; the most is 65536");
        let beyond = Parts::new(vec![0, 1, 2], vec![Part::default(); 2]).unwrap_err();
        assert_eq!(beyond.to_string(), "triangle 2 belongs to part 2, but the solid has 2 parts");
        assert!(Parts::new(vec![], vec![part("a\0b", false, false)]).is_err());
        let named = Parts::new(vec![0], vec![Part { name: Some(String::new()), ..Part::default() }]).unwrap();
        assert!(named.is_plain());
    }

    #[test]
    fn runs_that_do_not_fit_are_refused() {
        let mut good = Vec::new();
        Parts::new(vec![0, 0, 1], vec![part("frame", false, false), part("", true, true)])
            .unwrap()
            .put(&mut good, NEVER)
            .unwrap();
        assert_eq!(good[good.len() - 4..], [0, 2, 1, 1]);
        assert!(read(&good, 3).unwrap().part_of(2).is_transparent);
        assert!(read(&good, 2).is_err() && read(&good, 4).is_err());
        for (at, bad) in [(0, 3), (3, 1), (4, 4), (good.len() - 3, 0), (good.len() - 2, 2)] {
            let mut bytes = good.clone();
            bytes[at] = bad;
            assert!(read(&bytes, 3).is_err(), "byte {at}");
        }
    }

    proptest! {
        #[test]
        fn round_trip(numbers in prop::collection::vec(0u16..5, 0..60), flags in prop::array::uniform5(any::<(bool, bool)>())) {
            let list: Vec<Part> = flags.iter().map(|&(a, b)| part(if a == b { "Scheibe ß" } else { "" }, a, b)).collect();
            let parts = Parts::new(numbers.clone(), list).unwrap();
            let mut bytes = Vec::new();
            parts.put(&mut bytes, NEVER).unwrap();
            prop_assert_eq!(read(&bytes, numbers.len()).unwrap(), parts);
        }

        #[test]
        fn damaged_bytes_never_panic(bytes: Vec<u8>, triangles in 0usize..100) {
            let _ = read(&bytes, triangles);
        }
    }
}
