//! Lines of a text file: UTF-8, UTF-16 or one byte per character, ended by LF, CR or both.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek};
use std::path::Path;

use anyhow::{Context, Error, Result, anyhow, bail};
use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};
use encoding_rs_io::DecodeReaderBytesBuilder;
use indicatif::ProgressBar;

use super::dialect::{Dialect, hint};

/// A text file, line by line; the progress bar counts bytes.
pub struct Lines<'a> {
    reader: Box<dyn BufRead>,
    line: Vec<u8>,
    text: String,
    number: u64,
    dialect: Dialect,
    bar: &'a ProgressBar,
}

/// Longest line that can be numbers; longer ones mean a binary file.
const LONGEST: usize = 4096;
const BUFFER: usize = 1 << 20;

impl<'a> Lines<'a> {
    pub fn open(path: &Path, bar: &'a ProgressBar) -> Result<Self> {
        let mut file = File::open(path).context("cannot open it")?;
        bar.set_length(file.metadata()?.len());
        let mut head = Vec::new();
        file.by_ref().take(1024).read_to_end(&mut head)?;
        file.rewind()?;
        Ok(Self::of(decoded(file, encoding(&head)), 0, bar))
    }

    /// Continues at the position of `reader`, after line `number`.
    pub fn of(reader: Box<dyn BufRead>, number: u64, bar: &'a ProgressBar) -> Self {
        Self { reader, line: Vec::new(), text: String::new(), number, dialect: Dialect::default(), bar }
    }

    /// If the user says so, a comma within a number is its decimal mark.
    pub fn with_decimal_commas(mut self, are_decimal: bool) -> Self {
        self.dialect = Dialect::told(are_decimal);
        self
    }

    /// The next line without its end and blanks around it; `None` at the end of the file.
    pub fn next(&mut self) -> Result<Option<&str>> {
        self.line.clear();
        let read = read_line(&mut *self.reader, &mut self.line)?;
        if read == 0 {
            return Ok(None);
        }
        self.number += 1;
        if self.number.is_multiple_of(4096) {
            self.bar.inc(4096 * read as u64);
        }
        if self.line.len() > LONGEST {
            bail!("line {} is longer than {LONGEST} characters: not a text file of points", self.number);
        }
        if memchr::memchr(0, &self.line).is_some() {
            bail!("line {} holds bytes that are no text: not a text file of points", self.number);
        }
        // Titles and comments are often Latin-1; numbers are the same in both.
        self.text.clear();
        match str::from_utf8(&self.line) {
            Ok(text) => self.text.push_str(trimmed(text)),
            Err(_) => self.text.push_str(trimmed(&WINDOWS_1252.decode(&self.line).0)),
        }
        Ok(Some(&self.text))
    }

    /// The next line, which must be there and start with `N` numbers.
    pub fn numbers<const N: usize>(&mut self, what: &str) -> Result<[f64; N]> {
        let number = self.number;
        if self.next()?.is_none() {
            bail!("it ends after line {number}, where {what} should follow");
        }
        let found = self.learnt().and_then(|d| d.numbers::<N>(&self.text));
        found.ok_or_else(|| self.unlike(&format!("{what} expected ({N} numbers)")))
    }

    /// The three numbers at the start of the next non-empty line; `None` at the end of the file.
    pub fn point(&mut self, what: &str) -> Result<Option<[f64; 3]>> {
        if !self.next_filled()? {
            return Ok(None);
        }
        let found = self.learnt().and_then(|d| d.numbers::<3>(&self.text));
        found.map(Some).ok_or_else(|| self.unlike(&format!("{what} expected")))
    }

    /// The same, at positions chosen by the line's words.
    pub fn chosen(&mut self, what: &str, places: impl Fn(&[&str]) -> Option<[usize; 3]>) -> Result<Option<[f64; 3]>> {
        if !self.next_filled()? {
            return Ok(None);
        }
        let found = self.learnt().and_then(|d| {
            let words = d.words(&self.text);
            let [x, y, z] = places(&words)?.map(|place| words.get(place).and_then(|w| d.value(w)));
            Some([x?, y?, z?])
        });
        found.map(Some).ok_or_else(|| self.unlike(&format!("{what} expected")))
    }

    /// Goes to the next non-empty line; returns whether there is one.
    pub fn next_filled(&mut self) -> Result<bool> {
        loop {
            match self.next()? {
                None => return Ok(false),
                Some("") => {}
                Some(_) => return Ok(true),
            }
        }
    }

    /// The dialect, with what this line adds to it; `None` where it contradicts earlier lines.
    fn learnt(&mut self) -> Option<Dialect> {
        self.dialect = self.dialect.learn(&self.text)?;
        Some(self.dialect)
    }

    fn unlike(&self, expected: &str) -> Error {
        anyhow!("line {}: {expected}, found \"{}\"{}", self.number, self.text, hint(&self.text, self.dialect.comma))
    }

    /// Number of the last line read.
    pub fn number(&self) -> u64 {
        self.number
    }
}

/// Blanks, the byte order marks that remain inside joined files, and the end mark of DOS.
fn trimmed(text: &str) -> &str {
    text.trim_matches(|c: char| c.is_whitespace() || c == '\u{feff}' || c == '\u{1a}')
}

/// Appends up to the end of the line, which is removed; returns the bytes read.
fn read_line(reader: &mut dyn BufRead, line: &mut Vec<u8>) -> std::io::Result<usize> {
    let mut read = 0;
    loop {
        let available = reader.fill_buf()?;
        if available.is_empty() {
            return Ok(read);
        }
        let end = memchr::memchr2(b'\n', b'\r', available);
        let taken = end.unwrap_or(available.len());
        line.extend_from_slice(&available[..taken]);
        let is_cr = end.is_some_and(|at| available[at] == b'\r');
        let used = taken + usize::from(end.is_some());
        reader.consume(used);
        read += used;
        if is_cr && reader.fill_buf()?.first() == Some(&b'\n') {
            reader.consume(1);
            read += 1;
        }
        if end.is_some() || line.len() > LONGEST {
            return Ok(read);
        }
    }
}

/// The encoding, by the byte order mark, or by the zero bytes that Latin letters and digits have in UTF-16.
pub fn encoding(head: &[u8]) -> &'static Encoding {
    if let Some((told, _)) = Encoding::for_bom(head) {
        return told;
    }
    let zeros = |odd: usize| head.chunks_exact(2).filter(|pair| pair[odd] == 0 && pair[1 - odd] != 0).count();
    let most = head.len() / 2 * 9 / 10;
    match (zeros(1) > most, zeros(0) > most) {
        _ if head.len() < 4 => UTF_8,
        (true, _) => UTF_16LE,
        (_, true) => UTF_16BE,
        _ => UTF_8,
    }
}

fn decoded(file: File, encoding: &'static Encoding) -> Box<dyn BufRead> {
    if encoding == UTF_8 {
        return Box::new(BufReader::with_capacity(BUFFER, file));
    }
    let decoder = DecodeReaderBytesBuilder::new().encoding(Some(encoding)).build(file);
    Box::new(BufReader::with_capacity(BUFFER, decoder))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(bytes: &[u8]) -> Vec<String> {
        let path =
            std::env::temp_dir().join(format!("asbuilt-lines-{}-{:x}", std::process::id(), bytes.as_ptr() as usize));
        std::fs::write(&path, bytes).unwrap();
        let bar = ProgressBar::hidden();
        let mut lines = Lines::open(&path, &bar).unwrap();
        let mut out = Vec::new();
        while let Some(line) = lines.next().unwrap() {
            out.push(line.to_owned());
        }
        std::fs::remove_file(path).unwrap();
        out
    }

    #[test]
    fn every_encoding_and_line_end_gives_the_same() {
        let text = "Höhe 1\n2 3\n\n4 5";
        let wide = |order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect::<Vec<u8>>();
        let marked = |mark: &[u8], rest: Vec<u8>| [mark, &rest].concat();
        for (what, bytes) in [
            ("UTF-8", text.into()),
            ("with mark", marked(b"\xef\xbb\xbf", text.into())),
            ("CR", text.replace('\n', "\r").into()),
            ("CR LF", text.replace('\n', "\r\n").into()),
            ("Latin-1", text.chars().map(|c| c as u8).collect()),
            ("UTF-16 LE with mark", marked(b"\xff\xfe", wide(u16::to_le_bytes))),
            ("UTF-16 BE with mark", marked(b"\xfe\xff", wide(u16::to_be_bytes))),
            ("UTF-16 LE", wide(u16::to_le_bytes)),
            ("UTF-16 BE", wide(u16::to_be_bytes)),
        ] {
            assert_eq!(lines(&bytes), ["Höhe 1", "2 3", "", "4 5"], "{what}");
        }
    }

    #[test]
    fn a_mark_within_is_no_character() {
        assert_eq!(lines("1\n\u{feff}2\n".as_bytes()), ["1", "2"]);
    }
}
