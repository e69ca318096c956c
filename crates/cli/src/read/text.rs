//! Lines of numbers, read with a memory of where they stand.

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

use anyhow::{Context, Result, bail};
use indicatif::ProgressBar;

/// A text file, line by line; the progress bar counts bytes.
pub struct Lines<'a> {
    reader: BufReader<File>,
    line: Vec<u8>,
    number: u64,
    bar: &'a ProgressBar,
}

/// Longest line that can be numbers; more is a binary file.
const LONGEST: usize = 4096;

impl<'a> Lines<'a> {
    pub fn open(path: &Path, bar: &'a ProgressBar) -> Result<Self> {
        let file = File::open(path).context("cannot open it")?;
        bar.set_length(file.metadata()?.len());
        Ok(Self { reader: BufReader::with_capacity(1 << 20, file), line: Vec::new(), number: 0, bar })
    }

    /// The next line without its end; `None` at the end of the file.
    pub fn next(&mut self) -> Result<Option<&str>> {
        self.line.clear();
        let read = std::io::Read::take(&mut self.reader, LONGEST as u64).read_until(b'\n', &mut self.line)?;
        if read == 0 {
            return Ok(None);
        }
        self.number += 1;
        if self.number.is_multiple_of(4096) {
            self.bar.inc(4096 * read as u64);
        }
        if read == LONGEST {
            bail!("line {} is longer than {LONGEST} characters: not a text file of points", self.number);
        }
        let bytes = if self.number == 1 { self.line.strip_prefix(b"\xef\xbb\xbf") } else { None };
        match std::str::from_utf8(bytes.unwrap_or(&self.line)) {
            Ok(text) => Ok(Some(text.trim())),
            Err(_) => bail!("line {} is not text", self.number),
        }
    }

    /// The next line, which must be there and start with `N` numbers.
    pub fn numbers<const N: usize>(&mut self, what: &str) -> Result<[f64; N]> {
        let number = self.number + 1;
        let Some(line) = self.next()? else { bail!("it ends after line {}, where {what} should follow", number - 1) };
        match numbers::<N>(line) {
            Some(n) => Ok(n),
            None => bail!("line {number}: {what} expected ({N} numbers), found \"{line}\""),
        }
    }

    /// Number of the line read last.
    pub fn number(&self) -> u64 {
        self.number
    }
}

/// The first `N` numbers of a line. Blanks, tabs and semicolons part them, and commas where these do not; a comma
/// within a number that they part is its decimal mark (`1,50;2,50;3,50`).
pub fn numbers<const N: usize>(line: &str) -> Option<[f64; N]> {
    let parted = || line.split([' ', ';', '\t']).map(|w| w.trim_end_matches(',')).filter(|w| !w.is_empty());
    let decimal_commas = parted().take(N).filter(|w| w.matches(',').count() <= 1).count() == N;
    if N > 1 && decimal_commas {
        parse(parted().map(|w| w.replace(',', ".")))
    } else {
        parse(line.split([' ', ';', '\t', ',']).filter(|w| !w.is_empty()).map(ToOwned::to_owned))
    }
}

fn parse<const N: usize>(mut words: impl Iterator<Item = String>) -> Option<[f64; N]> {
    let mut out = [0.0; N];
    for slot in &mut out {
        *slot = words.next()?.parse().ok()?;
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::numbers;

    #[test]
    fn separators_and_decimal_marks() {
        for (line, expected) in [
            ("1.5 2.5 3.5 255 0 0", Some([1.5, 2.5, 3.5])),
            ("1.5,2.5,3.5", Some([1.5, 2.5, 3.5])),
            ("1.5, 2.5, 3.5, 9", Some([1.5, 2.5, 3.5])),
            ("1,5;2,5;3,5", Some([1.5, 2.5, 3.5])),
            ("1,5\t2,5\t3,5\t0,1", Some([1.5, 2.5, 3.5])),
            ("1.5,2.5,3.5 255", Some([1.5, 2.5, 3.5])),
            ("1.5;2.5", None),
            ("x y z", None),
        ] {
            assert_eq!(numbers::<3>(line), expected, "{line}");
        }
    }
}
