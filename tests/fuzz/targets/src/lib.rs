//! What the fuzzer calls: each decoder of the core with bytes from outside, and every question about what it accepted.
//!
//! Two kinds of target: one reads the input as the stored form of a value; the other builds a value out of the input,
//! which gets past the checksums, and demands that `decode(encode(x)) == x`. A panic is a finding, and so is a call
//! that does not end: every call gets an [`asbuilt_core::Interrupt`] that says stop after a while, as a cancelled query
//! would.

#![forbid(unsafe_code)]

mod build;
mod checksum;
mod input;
mod solid;
mod texts;
mod value;
mod voxels;

pub use checksum::mended;

use std::sync::atomic::{AtomicU64, Ordering};

/// A target by name.
pub struct Target {
    pub name: &'static str,
    pub run: fn(&[u8]),
}

/// All of them; the corpus of each is in `tests/fuzz/corpus/NAME`.
pub const TARGETS: &[Target] = &[
    Target { name: "solid", run: solid::decode },
    Target { name: "solid_built", run: solid::build },
    Target { name: "ewkb", run: solid::ewkb },
    Target { name: "patch", run: value::patch },
    Target { name: "patch_built", run: build::patch },
    Target { name: "gathered", run: value::gathered },
    Target { name: "evidence", run: value::evidence },
    Target { name: "evidence_built", run: build::evidence },
    Target { name: "occupancy", run: voxels::occupancy },
    Target { name: "change", run: voxels::change },
    Target { name: "texts", run: texts::read },
];

/// Runs work with an interrupt that says stop after it was asked many times: the work is bounded if it asks at all.
/// Half a million steps: some tenths of a second, and a fourth of what an instrumented program has before it counts as
/// hung.
fn bounded<T>(work: impl FnOnce(asbuilt_core::Interrupt) -> T) -> T {
    let asked = AtomicU64::new(0);
    work(&|| asked.fetch_add(1, Ordering::Relaxed) > 500)
}

/// How a kept input ended.
#[derive(Debug, PartialEq, Eq)]
pub enum End {
    Survived,
    Panicked,
    Hung,
}

/// Runs one input on a thread of its own; one that does not end within 5 s is left behind.
pub fn replay(target: &Target, bytes: Vec<u8>) -> End {
    let (tell, told) = std::sync::mpsc::channel();
    let run = target.run;
    let thread = std::thread::spawn(move || {
        run(&bytes);
        let _ = tell.send(());
    });
    match told.recv_timeout(std::time::Duration::from_secs(5)) {
        Ok(()) => End::Survived,
        Err(std::sync::mpsc::RecvTimeoutError::Timeout) => End::Hung,
        Err(_) => thread.join().map_or(End::Panicked, |()| End::Survived),
    }
}

/// Valid inputs to start from, a few for each target.
pub fn seeds(target: &str) -> Vec<Vec<u8>> {
    build::seeds(target)
}
