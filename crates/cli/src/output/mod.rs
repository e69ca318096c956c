//! What the user sees: [`table`] (aligned, CSV, JSON), [`length`]s, [`message`]s and errors, progress bars. Every text from
//! elsewhere passes through [`safe`] before a person sees it.

mod length;
mod message;
mod safe;
mod table;

use std::io::{StdoutLock, Write};

use anyhow::Result;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::Value;

pub use length::LengthUnit;
pub(crate) use message::say;
pub use message::{Noted, notes, say_error};
pub use safe::safe;
pub use table::{Format, Table};

/// Writes to standard output. Who closes it (head, less) wants no more, and that is no error.
pub fn to_stdout(write: impl FnOnce(&mut StdoutLock<'static>) -> Result<()>) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let result = write(&mut out).and_then(|()| Ok(out.flush()?));
    let is_closed = |e: &anyhow::Error| {
        e.downcast_ref::<std::io::Error>().is_some_and(|e| e.kind() == std::io::ErrorKind::BrokenPipe)
    };
    match result {
        Err(e) if is_closed(&e) => std::process::exit(0),
        other => other,
    }
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
    bar.set_message(safe(what));
    bar
}

/// A spinner for work of unknown length.
pub fn spinner(what: &str) -> ProgressBar {
    let bar = ProgressBar::new_spinner();
    bar.set_message(safe(what));
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
