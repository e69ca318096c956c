//! A file with some of its bytes replaced, and some appended, without copying it.

use std::io::{self, Read, Seek, SeekFrom};

/// Bytes to be read instead of those in the file.
struct Piece {
    start: u64,
    bytes: Vec<u8>,
}

/// A file of `len` bytes and its corrections.
pub struct Overlay<R> {
    inner: R,
    len: u64,
    at: u64,
    /// The position of `inner`.
    inner_at: u64,
    pieces: Vec<Piece>,
}

impl<R: Read + Seek> Overlay<R> {
    pub fn new(mut inner: R) -> io::Result<Self> {
        let len = inner.seek(SeekFrom::End(0))?;
        Ok(Self { inner, len, at: 0, inner_at: len, pieces: Vec::new() })
    }

    /// Puts bytes over those at `start`, or after the end.
    pub fn put(&mut self, start: u64, bytes: Vec<u8>) {
        self.len = self.len.max(start + bytes.len() as u64);
        self.pieces.push(Piece { start, bytes });
    }

    pub fn len(&self) -> u64 {
        self.len
    }
}

impl<R: Read + Seek> Read for Overlay<R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let at = self.at;
        let within = |p: &&Piece| (p.start..p.start + p.bytes.len() as u64).contains(&at);
        let read = if let Some(piece) = self.pieces.iter().find(within) {
            (&piece.bytes[(at - piece.start) as usize..]).read(out)?
        } else {
            let next = self.pieces.iter().map(|p| p.start).filter(|&start| start > at).min();
            let room = next.map_or(out.len(), |start| out.len().min((start - at) as usize));
            if self.inner_at != at {
                self.inner_at = self.inner.seek(SeekFrom::Start(at))?;
            }
            let read = self.inner.read(&mut out[..room])?;
            self.inner_at += read as u64;
            read
        };
        self.at += read as u64;
        Ok(read)
    }
}

impl<R: Read + Seek> Seek for Overlay<R> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let target = match to {
            SeekFrom::Start(at) => Some(at),
            SeekFrom::End(by) => self.len.checked_add_signed(by),
            SeekFrom::Current(by) => self.at.checked_add_signed(by),
        };
        self.at = target.ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "before the file's start"))?;
        Ok(self.at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    #[test]
    fn mends_are_read_and_the_rest_is_as_before() {
        let mut o = Overlay::new(Cursor::new(b"0123456789".to_vec())).unwrap();
        o.put(2, b"ab".to_vec());
        o.put(10, b"xyz".to_vec());
        let mut all = String::new();
        o.read_to_string(&mut all).unwrap();
        assert_eq!(all, "01ab456789xyz");
        o.seek(SeekFrom::End(-4)).unwrap();
        all.clear();
        o.read_to_string(&mut all).unwrap();
        assert_eq!(all, "9xyz");
        assert_eq!(o.len(), 13);
    }
}
