//! The child's side: meshes product by product on all cores, each with its own limit of time.

use std::collections::{HashMap, HashSet, VecDeque};
use std::io::{BufRead, Write, stdin, stdout};
use std::path::Path;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use anyhow::{Context, Result};
use ifc_lite_core::{build_entity_index, set_report_sink};
use ifc_lite_processing::{GEOMETRY_STACK_BYTES, geometry_pool_builder};

use super::attributes;
use super::cut::{Cut, Cutter};
use super::looks::Looks;
use super::meshing::{Meshing, Warm};
use super::step::Step;
use super::told::{IfcHeader, Outcome, Task, WorkerMessage};
use super::watch;
use crate::memory;
use crate::silence_panics;

/// The child's limits.
#[derive(Debug, Clone, Copy)]
pub struct WorkerLimits {
    pub memory: u64,
    /// Limits of a single product: time and memory.
    pub product_time: Duration,
    pub product_memory: u64,
}

/// Meshes the file and reports it on standard output, piece by piece.
pub fn answer(path: &Path, limits: WorkerLimits) -> Result<()> {
    memory::limit(limits.memory)?;
    let mut line = String::new();
    stdin().lock().read_line(&mut line).context("the loader is gone")?;
    let task: Task = serde_json::from_str(&line)?;
    // The parent holds the other end of standard input: it ends with the parent, however that ends.
    std::thread::spawn(|| {
        let _ = std::io::copy(&mut stdin().lock(), &mut std::io::sink());
        std::process::exit(1);
    });
    let _ = set_report_sink(|_| {});
    let _ = geometry_pool_builder().num_threads(threads(limits.memory)).build_global();
    let mut out = std::io::BufWriter::with_capacity(1 << 18, stdout().lock());
    // A panic is told as what it is, product by product.
    let told = silence_panics(|| {
        let bytes = std::fs::read(path).map_err(|e| format!("cannot read it: {e}"))?;
        tell(bytes, &task, limits, &mut out)
    });
    match told {
        Ok(Ok(())) => {}
        Ok(Err(reason)) => WorkerMessage::Refused(reason).write(&mut out)?,
        Err(_) => {
            WorkerMessage::Refused("the geometry library gave up on it: the file is damaged".into()).write(&mut out)?
        }
    }
    out.flush()?;
    // Threads that do not end must not keep it.
    std::process::exit(0)
}

/// Reports a file's products, piece by piece.
pub(super) fn tell(
    bytes: Vec<u8>,
    task: &Task,
    limits: WorkerLimits,
    out: &mut impl Write,
) -> std::result::Result<(), String> {
    // The process ends with the file: its text needs no owner, and threads that do not end may go on reading it.
    let bytes: &'static [u8] = Vec::leak(bytes);
    let step: &'static Step = Box::leak(Box::new(Step::read(bytes)?));
    let text: &'static [u8] = &step.text;
    let index = Arc::new(build_entity_index(text));
    let (attributes, relations) = attributes::read(text, &index);
    let with_body: Vec<u32> = attributes.drafts.iter().filter(|(_, d)| d.has_body).map(|(&id, _)| id).collect();
    if with_body.is_empty() {
        let n = attributes.drafts.len();
        return Err(format!("it holds no product with a body ({n} products without): export it with its 3D geometry"));
    }
    let known = Known { notes: super::reach::notes(step, &index, &attributes.drafts), looks: Looks::read(text) };
    let meshing = Meshing::new(text, index, step.angle)?;
    if !task.has_header {
        let mut drafts = attributes.drafts;
        drafts.iter_mut().for_each(|(&id, d)| d.product.id = step.shown(id));
        let (length_unit, word) = step.settled_unit(meshing.metres());
        let words = step.words.iter().cloned().chain(word).collect();
        let (whole_of, left_out, map_conversion) =
            (relations.whole_of, attributes.left_out, step.map_conversion.clone());
        let header = IfcHeader { drafts, whole_of, left_out, words, map_conversion, length_unit };
        WorkerMessage::Header(Box::new(header)).write(out).map_err(|e| e.to_string())?;
    }
    let cutter = Arc::new(Cutter::new(meshing, text, step.angle));
    let skipped: HashSet<u32> = task.done.iter().chain(&task.alone).copied().collect();
    let rest: Vec<u32> = with_body.into_iter().filter(|id| !skipped.contains(id)).collect();
    let mut times = (Duration::ZERO, Duration::ZERO);
    for (ids, threads) in [(task.alone.clone(), 1), (rest, threads(limits.memory))] {
        let mut crew = MeshingPool::new(&cutter, ids, limits);
        crew.run(threads, &known, &mut times, out).map_err(|e| e.to_string())?;
    }
    WorkerMessage::End { meshing: times.0, checks: times.1 }.write(out).map_err(|e| e.to_string())
}

/// As many threads as there are cores; but their deep stacks, twice as many with the library's own, count as memory and
/// may take a quarter of it.
fn threads(memory: u64) -> usize {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let most = memory / (8 * GEOMETRY_STACK_BYTES as u64);
    cores.min(usize::try_from(most).unwrap_or(usize::MAX)).max(1)
}

/// What is known of products besides their meshes.
struct Known<'a> {
    notes: HashMap<u32, String>,
    looks: Looks<'a>,
}

/// What a thread reports.
enum ThreadReport {
    Begun(u32),
    /// `None` where the library gave up.
    Done(u32, Option<Box<Cut>>, Duration),
}

/// Threads that share a queue of products.
struct MeshingPool {
    cutter: Arc<Cutter>,
    queue: Arc<Mutex<VecDeque<u32>>>,
    limits: WorkerLimits,
    reports: (Sender<ThreadReport>, Receiver<ThreadReport>),
    /// Since when each product has been in work, and how much memory the process held then.
    running: HashMap<u32, (Instant, u64)>,
    left: usize,
    /// Products whose threads were abandoned.
    lost: HashSet<u32>,
}

impl MeshingPool {
    fn new(cutter: &Arc<Cutter>, ids: Vec<u32>, limits: WorkerLimits) -> Self {
        Self {
            cutter: cutter.clone(),
            left: ids.len(),
            queue: Arc::new(Mutex::new(ids.into())),
            limits,
            reports: channel(),
            running: HashMap::new(),
            lost: HashSet::new(),
        }
    }

    fn run(
        &mut self,
        threads: usize,
        known: &Known,
        times: &mut (Duration, Duration),
        out: &mut impl Write,
    ) -> Result<()> {
        for _ in 0..threads.min(self.left) {
            self.hire()?;
        }
        while self.left > 0 {
            match self.reports.1.recv_timeout(Duration::from_millis(20)) {
                Ok(report) => self.take(report, known, times, out)?,
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => break,
            }
            self.give_up_slow(out)?;
            if self.is_hungry() {
                // Which of them takes it is not known from within; the parent sees who was in work.
                out.flush()?;
                std::process::exit(watch::TOO_MUCH_MEMORY);
            }
        }
        Ok(())
    }

    /// Whether the process has grown by more than a product may take while one was in work.
    fn is_hungry(&self) -> bool {
        let now = watch::resident();
        self.running.values().any(|(_, before)| now.saturating_sub(*before) > self.limits.product_memory)
    }

    fn take(
        &mut self,
        report: ThreadReport,
        known: &Known,
        times: &mut (Duration, Duration),
        out: &mut impl Write,
    ) -> Result<()> {
        match report {
            ThreadReport::Begun(id) => {
                self.running.insert(id, (Instant::now(), watch::resident()));
                WorkerMessage::Begun(id).write(out)
            }
            ThreadReport::Done(id, ..) if self.lost.contains(&id) => Ok(()),
            ThreadReport::Done(id, cut, time) => {
                self.running.remove(&id);
                self.left -= 1;
                times.0 += time;
                let Some(cut) = cut else {
                    return WorkerMessage::Failed(
                        id,
                        "the geometry library gave up on it: its geometry is damaged".into(),
                    )
                    .write(out);
                };
                times.1 += cut.check;
                let said = cut.meshed.note.into_iter().chain(known.notes.get(&id).cloned()).collect::<Vec<_>>();
                let note = (!said.is_empty()).then(|| said.join("; "));
                let (soup, unproven, mended) = (cut.meshed.soup, cut.unproven, cut.mended);
                let looks = known.looks.of(id, &cut.meshed.items);
                let outcome = Outcome { soup, looks, is_fixed: known.looks.is_fixed(id), note, unproven, mended };
                WorkerMessage::Meshed(id, outcome).write(out)
            }
        }
    }

    /// Names products that take too long, and continues without their threads.
    fn give_up_slow(&mut self, out: &mut impl Write) -> Result<()> {
        let limit = self.limits.product_time;
        let slow: Vec<u32> =
            self.running.iter().filter(|(_, (at, _))| at.elapsed() > limit).map(|(&id, _)| id).collect();
        for id in slow {
            self.running.remove(&id);
            self.lost.insert(id);
            self.left -= 1;
            let reason = format!(
                "meshing it took longer than {} s; raise --product-timeout, or simplify its geometry",
                limit.as_secs_f64()
            );
            WorkerMessage::Failed(id, reason).write(out)?;
            self.hire()?;
        }
        Ok(())
    }

    fn hire(&self) -> Result<()> {
        let (cutter, queue, reports) = (self.cutter.clone(), self.queue.clone(), self.reports.0.clone());
        let work = move || {
            let mut warm = Warm::default();
            loop {
                let next = queue.lock().unwrap_or_else(PoisonError::into_inner).pop_front();
                let Some(id) = next else { return };
                let start = Instant::now();
                if reports.send(ThreadReport::Begun(id)).is_err() {
                    return;
                }
                let mesh = std::panic::AssertUnwindSafe(|| cutter.mesh(id, &mut warm));
                let cut = std::panic::catch_unwind(mesh).ok().map(Box::new);
                if reports.send(ThreadReport::Done(id, cut, start.elapsed())).is_err() {
                    return;
                }
            }
        };
        let thread = std::thread::Builder::new().stack_size(GEOMETRY_STACK_BYTES);
        thread.spawn(work).map(drop).context("cannot start the geometry threads")
    }
}
