//! What the user sees: tables, CSV, JSON, progress bars.

use std::io::Write;

use anyhow::Result;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Map, Value};

/// Prints a line to standard error; nobody reading it is no reason to stop.
macro_rules! say {
    ($($arg:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($arg)*);
    }};
}
pub(crate) use say;

/// How to print rows.
#[derive(clap::ValueEnum, Debug, Clone, Copy, Default)]
pub enum Format {
    /// Aligned columns
    #[default]
    Table,
    /// Comma-separated, with a header line
    Csv,
    /// An array of objects
    Json,
}

/// Rows under named columns.
#[derive(Debug, Default)]
pub struct Table {
    columns: Vec<String>,
    rows: Vec<Vec<Value>>,
}

impl Table {
    pub fn new(columns: &[&str]) -> Self {
        Self { columns: columns.iter().map(ToString::to_string).collect(), rows: Vec::new() }
    }

    pub fn push(&mut self, row: Vec<Value>) {
        self.rows.push(row);
    }

    pub fn print(&self, format: Format) -> Result<()> {
        self.print_of(format, "object", "objects")
    }

    /// The same for rows that are something else, named in singular and plural.
    pub fn print_of(&self, format: Format, one: &str, many: &str) -> Result<()> {
        let mut out = std::io::stdout().lock();
        match format {
            Format::Table => self.print_aligned(&mut out, if self.rows.len() == 1 { one } else { many })?,
            Format::Csv => {
                writeln!(out, "{}", self.columns.join(","))?;
                for row in &self.rows {
                    writeln!(out, "{}", row.iter().map(csv_field).collect::<Vec<_>>().join(","))?;
                }
            }
            Format::Json => {
                let object = |row: &Vec<Value>| {
                    self.columns.iter().cloned().zip(row.iter().cloned()).collect::<Map<String, Value>>()
                };
                let objects: Vec<_> = self.rows.iter().map(object).collect();
                writeln!(out, "{}", serde_json::to_string_pretty(&objects)?)?;
            }
        }
        Ok(())
    }

    fn print_aligned(&self, out: &mut impl Write, what: &str) -> Result<()> {
        let cells: Vec<Vec<String>> = self.rows.iter().map(|r| r.iter().map(shown).collect()).collect();
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
        writeln!(out, "({} {what})", cells.len())?;
        Ok(())
    }
}

fn shown(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(s) => s.clone(),
        other => other.to_string(),
    }
}

fn csv_field(value: &Value) -> String {
    let text = shown(value);
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// A number rounded to `digits` decimals; NULL stays NULL.
pub fn rounded(value: Option<f64>, digits: i32) -> Value {
    let scale = 10f64.powi(digits);
    value.map_or(Value::Null, |v| Value::from((v * scale).round() / scale))
}

/// A bar that counts `unit`; hidden where standard error is no terminal.
pub fn progress(what: &str, unit: &str) -> ProgressBar {
    let bar = ProgressBar::new(0);
    let template = format!("{{msg:28}} {{wide_bar}} {{human_pos}}/{{human_len}} {unit} {{eta:>4}}");
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style);
    }
    bar.set_message(what.to_owned());
    bar
}

/// A spinner for work of unknown length.
pub fn spinner(what: &str) -> ProgressBar {
    let bar = ProgressBar::new_spinner();
    bar.set_message(what.to_owned());
    bar.enable_steady_tick(std::time::Duration::from_millis(120));
    bar
}

/// `12_345_678` as `12.3 M`.
pub fn count(n: u64) -> String {
    match n {
        0..10_000 => n.to_string(),
        10_000..1_000_000 => format!("{:.1} k", n as f64 / 1e3),
        _ => format!("{:.1} M", n as f64 / 1e6),
    }
}
