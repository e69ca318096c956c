//! The parent's side: starts the meshing process, keeps what it reports, and restarts it without the product on which
//! it died.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, ExitStatus};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, anyhow, bail};

use super::told::{IfcHeader, Outcome, Task, WorkerMessage};
use super::worker::{self, WorkerLimits};
use super::{IfcModel, assemble, watch};
use crate::child::{epitaph, spawn};
use crate::memory;

/// How much time and memory a model may take.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Of all products together.
    pub time: Duration,
    pub memory: u64,
    pub product_time: Duration,
    pub product_memory: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            time: Duration::from_secs(300),
            memory: memory::budget(),
            product_time: Duration::from_secs(20),
            product_memory: 2 << 30,
        }
    }
}

/// What is known about a model so far.
#[derive(Default)]
pub struct Progress {
    pub header: Option<IfcHeader>,
    pub outcomes: BTreeMap<u32, std::result::Result<Outcome, String>>,
    /// Time of meshing and of its checks.
    pub times: Option<(Duration, Duration)>,
    running: BTreeSet<u32>,
    bytes: u64,
}

/// Meshes a file in child processes of this program.
pub fn read(path: &Path, limits: Limits) -> Result<IfcModel> {
    std::fs::metadata(path).with_context(|| format!("{}: cannot open it", path.display()))?;
    let told = collect(path, limits);
    told.and_then(assemble::model).with_context(|| format!("{}", path.display()))
}

/// Meshes a file within this process, for programs that trust it: no limit of time or memory holds, and its text stays
/// in memory until the program ends.
pub fn read_within(path: &Path) -> Result<IfcModel> {
    let bytes = std::fs::read(path).with_context(|| format!("{}: cannot open it", path.display()))?;
    within(bytes).with_context(|| format!("{}", path.display()))
}

/// Meshes a text within this process.
pub(super) fn within(bytes: Vec<u8>) -> Result<IfcModel> {
    let limits = Limits::default();
    let worker = WorkerLimits { memory: u64::MAX, product_time: Duration::from_secs(60), product_memory: u64::MAX };
    let mut told = Vec::new();
    worker::tell(bytes, &Task::default(), worker, &mut told).map_err(|reason| anyhow!(reason))?;
    let (mut progress, mut from) = (Progress::default(), &told[..]);
    while let Some(piece) = WorkerMessage::read(&mut from, u64::MAX)? {
        progress.take(piece, limits)?;
    }
    assemble::model(progress)
}

fn collect(path: &Path, limits: Limits) -> Result<Progress> {
    let (mut progress, mut task, start) = (Progress::default(), Task::default(), Instant::now());
    loop {
        let mut worker = Worker::start(path, limits, &task)?;
        let ended = worker.listen(&mut progress, start + limits.time, limits)?;
        let Some(reason) = ended else { return Ok(progress) };
        let running = std::mem::take(&mut progress.running);
        if progress.header.is_none() || running.is_empty() {
            bail!(reason);
        }
        let running: Vec<u32> = running.into_iter().collect();
        match running[..] {
            [culprit] => drop(progress.outcomes.insert(culprit, Err(reason))),
            _ => task.alone = running,
        }
        task.done = progress.outcomes.keys().copied().collect();
        task.alone.retain(|id| !progress.outcomes.contains_key(id));
        task.has_header = true;
    }
}

/// A meshing process; it ends with this value.
struct Worker {
    child: Child,
    words: Option<std::thread::JoinHandle<String>>,
    told: Receiver<Result<Option<WorkerMessage>>>,
}

impl Worker {
    fn start(path: &Path, limits: Limits, task: &Task) -> Result<Self> {
        let mut command = Command::new(std::env::current_exe()?);
        command
            .arg("mesh-ifc")
            .arg(format!("--max-memory={}", limits.memory))
            .arg(format!("--product-memory={}", limits.product_memory))
            .arg(format!("--product-timeout={}", limits.product_time.as_secs_f64()))
            .arg("--")
            .arg(path);
        // Settings of the geometry library from the user's environment would change the result.
        for (name, _) in std::env::vars_os().filter(|(n, _)| n.to_string_lossy().starts_with("IFC_LITE_")) {
            command.env_remove(name);
        }
        let (mut child, words) = spawn(command)?;
        let line = serde_json::to_string(task)? + "\n";
        // Where it is gone, what it tells says why.
        let _ = child.stdin.as_mut().context("no pipe to the meshing process")?.write_all(line.as_bytes());
        let pipe = child.stdout.take().context("no pipe to the meshing process")?;
        let (send, told) = sync_channel(64);
        let most = limits.memory / 4;
        std::thread::spawn(move || {
            let mut pipe = BufReader::with_capacity(1 << 18, pipe);
            loop {
                let next = WorkerMessage::read(&mut pipe, most);
                let is_last = !matches!(next, Ok(Some(_)));
                if send.send(next).is_err() || is_last {
                    return;
                }
            }
        });
        Ok(Self { child, words: Some(words), told })
    }

    /// Takes everything that is reported; `None` at its end, otherwise why the process died.
    fn listen(&mut self, progress: &mut Progress, end: Instant, limits: Limits) -> Result<Option<String>> {
        loop {
            let left = end.saturating_duration_since(Instant::now());
            let told = match self.told.recv_timeout(left) {
                Ok(told) => told?,
                Err(RecvTimeoutError::Timeout) => {
                    progress.give_up(limits.time)?;
                    return Ok(None);
                }
                Err(RecvTimeoutError::Disconnected) => None,
            };
            match told {
                None => return self.died(limits).map(Some),
                Some(WorkerMessage::Refused(reason)) => bail!(reason),
                Some(WorkerMessage::End { meshing, checks }) => {
                    progress.times = Some((meshing, checks));
                    return Ok(None);
                }
                Some(told) => progress.take(told, limits)?,
            }
        }
    }

    fn died(&mut self, limits: Limits) -> Result<String> {
        let status: ExitStatus = self.child.wait()?;
        let words = self.words.take().and_then(|w| w.join().ok()).unwrap_or_default();
        let is_memory = status.code() == Some(watch::TOO_MUCH_MEMORY);
        Ok(if is_memory {
            let most = memory::shown(limits.product_memory);
            format!("meshing it takes more memory than {most}; raise --product-memory, or simplify its geometry")
        } else {
            epitaph(status, &words, limits.memory)
        })
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Progress {
    pub(super) fn take(&mut self, told: WorkerMessage, limits: Limits) -> Result<()> {
        match told {
            WorkerMessage::Header(header) => self.header = Some(*header),
            WorkerMessage::Begun(id) => drop(self.running.insert(id)),
            WorkerMessage::Meshed(id, outcome) => {
                self.bytes += 24 * outcome.soup.vertices.len() as u64 + 14 * outcome.soup.triangles.len() as u64;
                if self.bytes > limits.memory / 4 {
                    bail!("its meshes take more than a quarter of --max-memory {}", memory::shown(limits.memory));
                }
                self.running.remove(&id);
                self.outcomes.insert(id, Ok(outcome));
            }
            WorkerMessage::Failed(id, reason) => {
                self.running.remove(&id);
                self.outcomes.insert(id, Err(reason));
            }
            WorkerMessage::End { .. } | WorkerMessage::Refused(_) => {}
        }
        Ok(())
    }

    /// The time for the whole model is over: what is not meshed is named.
    fn give_up(&mut self, limit: Duration) -> Result<()> {
        let reason =
            format!("meshing took longer than {} s; raise --mesh-timeout, or repair the file", limit.as_secs());
        let Some(header) = self.header.as_ref().filter(|_| !self.outcomes.is_empty()) else { bail!(reason) };
        for (&id, _) in header.drafts.iter().filter(|(_, d)| d.has_body) {
            self.outcomes.entry(id).or_insert_with(|| Err(reason.clone()));
        }
        Ok(())
    }
}
