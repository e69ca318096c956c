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
        match std::str::from_utf8(&self.line) {
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

/// The first `N` numbers of a line; blanks, commas, semicolons and tabs part them.
pub fn numbers<const N: usize>(line: &str) -> Option<[f64; N]> {
    let mut out = [0.0; N];
    let mut words = line.split([' ', ',', ';', '\t']).filter(|w| !w.is_empty());
    for slot in &mut out {
        *slot = words.next()?.parse().ok()?;
    }
    Some(out)
}
