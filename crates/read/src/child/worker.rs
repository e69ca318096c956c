//! The child's side: reads a file of scans under its budget of memory, packs them and writes patches to its output.

use std::io::{BufWriter, Read, Stdout, Write, stdin, stdout};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use anyhow::{Context, Result};
use indicatif::ProgressBar;

use super::Job;
use super::frame::{FrameKind, ScanHead, write};
use crate::packing::pack;
use crate::{RawScan, read_scans};

/// The pipe to the parent, shared by the reader and the progress reports.
#[derive(Clone)]
struct Pipe(Arc<Mutex<BufWriter<Stdout>>>);

impl Pipe {
    fn send(&self, kind: FrameKind, bytes: &[u8]) -> Result<()> {
        let mut out = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        write(&mut *out, kind, bytes)?;
        // Patches may gather; all else is waited for.
        if kind == FrameKind::Patch { Ok(()) } else { Ok(out.flush()?) }
    }
}

/// Reads the file and answers on standard output, if only with the reason why it cannot be read.
pub fn answer(job: &Job) -> Result<()> {
    crate::memory::limit(job.max_memory)?;
    let pipe = Pipe(Arc::new(Mutex::new(BufWriter::with_capacity(1 << 18, stdout()))));
    let bar = ProgressBar::hidden();
    tell(&pipe, &bar);
    match read_scans(&job.file, &job.options, &bar, &mut |scan| send(job, scan, &pipe)) {
        Ok(()) => pipe.send(FrameKind::End, &[]),
        Err(error) => pipe.send(FrameKind::Failure, format!("{error:#}").as_bytes()),
    }
}

fn send(job: &Job, mut scan: RawScan, pipe: &Pipe) -> Result<()> {
    let head = ScanHead {
        name: std::mem::take(&mut scan.name),
        sensor: scan.sensor.take(),
        world_from_scan: scan.world_from_scan,
        origin_source: scan.origin_source,
        origin_sd: scan.origin_sd,
        anchor: scan.anchor.into(),
        is_empty: scan.content.is_empty(),
        unusable: scan.unusable,
        notes: std::mem::take(&mut scan.notes),
        facts: std::mem::take(&mut scan.facts),
    };
    pipe.send(FrameKind::Scan, &postcard::to_stdvec(&head)?)?;
    if head.is_empty {
        return Ok(());
    }
    let mut station = [0; 8];
    stdin().lock().read_exact(&mut station).context("the loader is gone")?;
    let packed =
        pack(&mut scan, i64::from_be_bytes(station), job.min_range, |patch| pipe.send(FrameKind::Patch, patch))?;
    pipe.send(FrameKind::Packed, &packed.to_bytes()?)
}

/// Reports progress at intervals; when nobody listens, the parent is gone and this process ends.
fn tell(pipe: &Pipe, bar: &ProgressBar) {
    let (pipe, bar) = (pipe.clone(), bar.clone());
    std::thread::spawn(move || {
        loop {
            let now: Vec<u8> =
                [bar.position(), bar.length().unwrap_or(0)].iter().flat_map(|n| n.to_be_bytes()).collect();
            if pipe.send(FrameKind::Progress, &now).is_err() {
                std::process::exit(1);
            }
            std::thread::sleep(Duration::from_millis(100));
        }
    });
}
