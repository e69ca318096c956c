//! `asbuilt read-scan`: the loader's child process.

use anyhow::Result;

use asbuilt_read::child::{Job, answer};

pub fn run(job: &Job) -> Result<()> {
    answer(job)
}
