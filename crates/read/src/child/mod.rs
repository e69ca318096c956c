//! Files are read by child processes of this program: whatever a hostile file does to its reader (memory, stack, time)
//! costs no more than an error, and the connection to the database survives.
//!
//! * [`frame`]: what is written to the pipe;
//! * [`worker`]: the child's side: reads, packs, writes;
//! * [`reader`]: the parent's side.

mod frame;
mod reader;
mod worker;

use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::JoinHandle;

use anyhow::{Context, Result};

pub use frame::ScanHead;
pub use reader::{Event, ReadingProcess};
pub use worker::answer;

use super::ReadOptions;

/// What the worker is told on its command line.
#[derive(clap::Args, Debug, Clone)]
pub struct Job {
    /// File of scans
    pub file: PathBuf,
    #[command(flatten)]
    pub options: ReadOptions,
    #[arg(long, default_value_t = 0.0)]
    pub min_range: f64,
    /// Bytes
    #[arg(long)]
    pub max_memory: u64,
}

impl Job {
    fn command(&self) -> Result<Command> {
        let mut c = Command::new(std::env::current_exe()?);
        c.arg("read-scan")
            .arg(format!("--max-memory={}", self.max_memory))
            .arg(format!("--min-range={}", self.min_range))
            .args(self.options.arguments());
        c.arg("--").arg(&self.file);
        Ok(c)
    }
}

/// Starts a worker with pipes; its last words are collected.
pub fn spawn(mut command: Command) -> Result<(Child, JoinHandle<String>)> {
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    // A trace in its last words helps nobody.
    command.env_remove("RUST_BACKTRACE");
    let mut child = command.spawn().context("cannot start the reading process")?;
    let mut pipe = child.stderr.take().context("no pipe to the reading process")?;
    let words = std::thread::spawn(move || {
        let (mut kept, mut buffer) = (Vec::new(), [0; 4096]);
        // All is read, lest the worker wait; the beginning is kept.
        while let Ok(n @ 1..) = std::io::Read::read(&mut pipe, &mut buffer) {
            kept.extend_from_slice(&buffer[..n.min(65_536usize.saturating_sub(kept.len()))]);
        }
        String::from_utf8_lossy(&kept).into_owned()
    });
    Ok((child, words))
}

/// Why a worker ended without an answer.
pub fn epitaph(status: ExitStatus, words: &str, max_memory: u64) -> String {
    if words.contains("memory allocation of") || words.contains("out of memory") {
        let most = crate::memory::shown(max_memory);
        format!(
            "reading it takes more memory than {most} (--max-memory) or than the system gives: the file is damaged or hostile, or larger than that allows"
        )
    } else if words.contains("overflowed its stack") {
        "it is nested too deeply: the file is damaged or hostile".into()
    } else {
        format!("its reader gave up ({status}): the file is damaged or hostile")
    }
}
