//! Rows under named columns: aligned, CSV, JSON.

use std::io::Write;

use anyhow::Result;
use serde_json::{Map, Value};

use super::{safe, to_stdout};

/// How to print rows.
#[derive(clap::ValueEnum, Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Format {
    /// Aligned columns; control characters in names are written out, as \x1b
    #[default]
    Table,
    /// Comma-separated, with a header line; a text that a spreadsheet would take for a formula (it begins with =, +, -,
    /// @, a tab or a carriage return) gets an apostrophe before it, numbers never
    Csv,
    /// Comma-separated, every text exactly as it is: for programs, not for spreadsheets
    CsvExact,
    /// An array of objects, every text exactly as it is
    Json,
}

/// Rows under named columns.
#[derive(Debug, Default)]
pub struct Table {
    columns: Vec<String>,
    rows: Vec<Vec<Value>>,
}

impl Table {
    pub fn new<S: ToString>(columns: &[S]) -> Self {
        Self { columns: columns.iter().map(ToString::to_string).collect(), rows: Vec::new() }
    }

    pub fn push(&mut self, row: Vec<Value>) {
        self.rows.push(row);
    }

    pub fn print(&self, format: Format) -> Result<()> {
        self.print_of(format, "object", "objects")
    }

    /// The same for rows of something else, named in singular and plural.
    pub fn print_of(&self, format: Format, one: &str, many: &str) -> Result<()> {
        let what = if self.rows.len() == 1 { one } else { many };
        self.print_with(format, &format!("{} {what}", self.rows.len()))
    }

    /// The same with this below the rows, for people.
    pub fn print_with(&self, format: Format, sum: &str) -> Result<()> {
        to_stdout(|out| match format {
            Format::Table => self.print_aligned(out, sum),
            Format::Csv | Format::CsvExact => {
                let mut csv = csv::Writer::from_writer(out);
                csv.write_record(&self.columns).map_err(std::io::Error::from)?;
                for row in &self.rows {
                    let cells = row.iter().map(|value| cell(value, format == Format::Csv));
                    csv.write_record(cells).map_err(std::io::Error::from)?;
                }
                Ok(csv.flush()?)
            }
            Format::Json => {
                let object = |row: &Vec<Value>| {
                    self.columns.iter().cloned().zip(row.iter().cloned()).collect::<Map<String, Value>>()
                };
                let objects: Vec<_> = self.rows.iter().map(object).collect();
                Ok(writeln!(out, "{}", serde_json::to_string_pretty(&objects)?)?)
            }
        })
    }

    fn print_aligned(&self, out: &mut impl Write, sum: &str) -> Result<()> {
        let cell = |value: &Value| safe(&text(value));
        let cells: Vec<Vec<String>> = self.rows.iter().map(|r| r.iter().map(cell).collect()).collect();
        let width = |i: usize| {
            cells.iter().map(|r| r[i].chars().count()).max().unwrap_or(0).max(self.columns[i].chars().count())
        };
        let widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        let heads: Vec<String> = self.columns.iter().zip(&widths).map(|(c, w)| format!("{c:^w$}")).collect();
        writeln!(out, " {} ", heads.join(" | "))?;
        writeln!(out, "{}", widths.iter().map(|w| "-".repeat(w + 2)).collect::<Vec<_>>().join("+"))?;
        for (row, values) in cells.iter().zip(&self.rows) {
            let pad = |i: usize| {
                let (text, w) = (&row[i], widths[i]);
                if values[i].is_number() { format!("{text:>w$}") } else { format!("{text:<w$}") }
            };
            writeln!(out, " {} ", (0..row.len()).map(pad).collect::<Vec<_>>().join(" | "))?;
        }
        writeln!(out, "({sum})")?;
        Ok(())
    }
}

fn text(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(s) => s.clone(),
        other => other.to_string(),
    }
}

/// A cell of CSV; a text that begins like a formula is guarded where requested.
fn cell(value: &Value, guarded: bool) -> String {
    let mut text = text(value);
    if guarded && value.is_string() && text.starts_with(['=', '+', '-', '@', '\t', '\r']) {
        text.insert(0, '\'');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_guarded_and_numbers_are_not() {
        for (value, guarded, exact) in [
            (Value::from("=cmd|x"), "'=cmd|x", "=cmd|x"),
            (Value::from("-1"), "'-1", "-1"),
            (Value::from("\t=1"), "'\t=1", "\t=1"),
            (Value::from("@a,b"), "'@a,b", "@a,b"),
            (Value::from("a=b"), "a=b", "a=b"),
            (Value::from(-0.0121), "-0.0121", "-0.0121"),
            (Value::Null, "", ""),
        ] {
            assert_eq!(cell(&value, true), guarded);
            assert_eq!(cell(&value, false), exact);
        }
    }
}
