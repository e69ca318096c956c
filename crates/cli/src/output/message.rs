//! Messages on standard error.

use std::fmt;

/// Prints a line to standard error, safe to display; a closed standard error is no reason to stop.
macro_rules! say {
    ($($arg:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), "{}", crate::output::safe(&format!($($arg)*)));
    }};
}
pub(crate) use say;

/// An error with notes (detail, hint, what was not done), each of which is printed on a line of its own.
#[derive(Debug)]
pub struct Noted {
    pub message: String,
    pub notes: Vec<String>,
}

impl fmt::Display for Noted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Noted {}

/// The notes of an error and of what caused it.
pub fn notes(error: &anyhow::Error) -> Vec<String> {
    error.chain().filter_map(|e| e.downcast_ref::<Noted>()).flat_map(|n| n.notes.iter().cloned()).collect()
}

/// Prints an error with what caused it, and its notes below.
pub fn say_error(what: &str, error: &anyhow::Error) {
    say!("{what}: {error:#}");
    for note in notes(error) {
        say!("  {note}");
    }
}
