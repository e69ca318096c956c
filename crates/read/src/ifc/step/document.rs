//! A STEP file whose records can be looked up, and edits to it.

use std::collections::HashSet;
use std::ops::Range;

use super::record::{Record, Records, comment_end, string_end};
use super::value::{Value, references, values};

/// A text and the places of its records, in order of their numbers.
pub struct Document<'a> {
    text: &'a [u8],
    records: Vec<Record>,
}

impl<'a> Document<'a> {
    pub fn new(text: &'a [u8]) -> Self {
        let mut records: Vec<Record> = Records::new(text).collect();
        if !records.is_sorted_by_key(|r| r.id) {
            records.sort_by_key(|r| r.id);
        }
        Self { text, records }
    }

    pub fn records(&self) -> &[Record] {
        &self.records
    }

    pub fn text(&self) -> &'a [u8] {
        self.text
    }

    pub fn find(&self, id: u64) -> Option<&Record> {
        self.records.binary_search_by_key(&id, |r| r.id).ok().map(|at| &self.records[at])
    }

    pub fn is(&self, record: &Record, keyword: &str) -> bool {
        self.text[record.keyword.clone()].eq_ignore_ascii_case(keyword.as_bytes())
    }

    /// All records of a kind.
    pub fn all<'s>(&'s self, keyword: &'s str) -> impl Iterator<Item = &'s Record> {
        self.records.iter().filter(move |r| self.is(r, keyword))
    }

    pub fn values(&self, record: &Record) -> Vec<Value<'a>> {
        values(&self.text[record.arguments.clone()]).unwrap_or_default()
    }

    /// The numbers that a record refers to.
    pub fn references_of(&self, record: &Record) -> Vec<u64> {
        let mut all = Vec::new();
        references(&self.text[record.arguments.clone()], 0, |_, id| all.push(id));
        all
    }

    /// Where each argument of a record stands, comments and blanks around it included.
    pub fn argument_pieces(&self, record: &Record) -> Vec<Range<usize>> {
        let (mut pieces, mut start, mut depth, mut at) =
            (Vec::new(), record.arguments.start, 0usize, record.arguments.start);
        while at < record.arguments.end {
            let b = self.text[at];
            depth = match b {
                b'(' => depth + 1,
                b')' => depth.saturating_sub(1),
                _ => depth,
            };
            let next = match b {
                b'\'' => string_end(self.text, at),
                b'/' if self.text.get(at + 1) == Some(&b'*') => comment_end(self.text, at),
                _ => at + 1,
            };
            if b == b',' && depth == 0 {
                pieces.push(start..at);
                start = next;
            }
            at = next;
        }
        pieces.push(start..record.arguments.end);
        pieces
    }

    /// The values of a record of that kind.
    pub fn values_of(&self, id: u64, keyword: &str) -> Option<Vec<Value<'a>>> {
        self.find(id).filter(|r| self.is(r, keyword)).map(|r| self.values(r))
    }

    /// The coordinates of a point or a direction.
    pub fn coordinates(&self, id: u64) -> Option<Vec<f64>> {
        let record = self.find(id)?;
        self.values(record).first()?.list().iter().map(Value::number).collect()
    }

    /// Numbers that no record has yet, within the range of the geometry library.
    pub fn free_numbers(&self) -> impl Iterator<Item = u64> + use<> {
        let last = self.records.iter().map(|r| r.id).filter(|&id| id <= MAX_NUMBER).max().unwrap_or(0);
        let used: HashSet<u64> =
            if last == MAX_NUMBER { self.records.iter().map(|r| r.id).collect() } else { HashSet::new() };
        let first = if last == MAX_NUMBER { 1 } else { last + 1 };
        (first..=MAX_NUMBER).filter(move |id| !used.contains(id))
    }
}

/// The geometry library counts records in 32 bits.
pub const MAX_NUMBER: u64 = u32::MAX as u64;

/// Replacements for pieces of a text.
#[derive(Debug, Default)]
pub struct Edits(Vec<(Range<usize>, Vec<u8>)>);

impl Edits {
    pub fn replace(&mut self, piece: Range<usize>, by: impl Into<Vec<u8>>) {
        self.0.push((piece, by.into()));
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The text with its edits; where two overlap, the first counts.
    pub fn apply(mut self, text: &[u8]) -> Vec<u8> {
        self.0.sort_by_key(|(piece, _)| piece.start);
        let mut out = Vec::with_capacity(text.len() + self.0.iter().map(|(_, by)| by.len()).sum::<usize>());
        let mut at = 0;
        for (piece, by) in self.0 {
            if piece.start >= at {
                out.extend_from_slice(&text[at..piece.start]);
                out.extend_from_slice(&by);
                at = piece.end;
            }
        }
        out.extend_from_slice(&text[at..]);
        out
    }
}
