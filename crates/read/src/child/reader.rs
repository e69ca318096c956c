//! The parent's side: what the reading process sends, as events.

use std::io::{BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout};
use std::thread::JoinHandle;

use anyhow::{Context, Result, anyhow, bail};
use indicatif::ProgressBar;

use super::frame::{FrameKind, ScanHead, read};
use super::{Job, epitaph, spawn};
use crate::packing::Packed;

/// A reading process; it ends with this value.
pub struct ReadingProcess {
    job: Job,
    child: Child,
    words: Option<JoinHandle<String>>,
    pipe: BufReader<ChildStdout>,
    answers: ChildStdin,
}

/// What a file holds, in its order.
pub enum Event {
    /// A scan; unless it is empty, [`ReadingProcess::answer`] is waited for.
    Scan(ScanHead),
    /// The bytes of one of its patches.
    Patch(Vec<u8>),
    /// All of its patches have been sent.
    Packed(Packed),
}

impl ReadingProcess {
    pub fn start(job: Job) -> Result<Self> {
        let (mut child, words) = spawn(job.command()?)?;
        let pipe = child.stdout.take().context("no pipe to the reading process")?;
        let answers = child.stdin.take().context("no pipe to the reading process")?;
        Ok(Self { job, child, words: Some(words), pipe: BufReader::with_capacity(1 << 18, pipe), answers })
    }

    /// The next event; `None` at the end of the file.
    pub fn next(&mut self, bar: &ProgressBar) -> Result<Option<Event>> {
        while let Some((kind, bytes)) = read(&mut self.pipe)? {
            return Ok(match kind {
                FrameKind::Progress => {
                    let number = |at: usize| u64::from_be_bytes(std::array::from_fn(|k| bytes[at + k]));
                    if bytes.len() == 16 {
                        bar.set_length(number(8));
                        bar.set_position(number(0));
                    }
                    continue;
                }
                FrameKind::Scan => Some(Event::Scan(postcard::from_bytes(&bytes)?)),
                FrameKind::Patch => Some(Event::Patch(bytes)),
                FrameKind::Packed => Some(Event::Packed(Packed::from_bytes(&bytes)?)),
                FrameKind::End => None,
                FrameKind::Failure => bail!(String::from_utf8_lossy(&bytes).into_owned()),
            });
        }
        let status = self.child.wait()?;
        let words = self.words.take().and_then(|w| w.join().ok()).unwrap_or_default();
        Err(anyhow!("{}: {}", self.job.file.display(), epitaph(status, &words, self.job.max_memory)))
    }

    /// Sends the number of the station to which the patches belong.
    pub fn answer(&mut self, station: i64) -> Result<()> {
        // Where it is gone, the next event says why.
        let _ = self.answers.write_all(&station.to_be_bytes()).and_then(|()| self.answers.flush());
        Ok(())
    }
}

impl Drop for ReadingProcess {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
