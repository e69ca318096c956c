//! `asbuilt mesh-ifc`: the loader's child process; with `--table` what the loader would make of a file, for tests.

use std::path::PathBuf;
use std::time::Duration;

use anyhow::Result;

use asbuilt_read::ifc::{Limits, WorkerLimits, answer, print_table};

#[derive(clap::Args, Debug)]
pub struct MeshIfcArgs {
    /// IFC file
    file: PathBuf,
    /// Bytes
    #[arg(long)]
    max_memory: Option<u64>,
    /// Bytes
    #[arg(long)]
    product_memory: Option<u64>,
    /// Seconds
    #[arg(long)]
    product_timeout: Option<f64>,
    /// One line of JSON a product: volume, area, box, note
    #[arg(long)]
    table: bool,
}

pub fn run(args: &MeshIfcArgs) -> Result<()> {
    let known = Limits::default();
    let limits = Limits {
        memory: args.max_memory.unwrap_or(known.memory),
        product_memory: args.product_memory.unwrap_or(known.product_memory),
        product_time: args.product_timeout.map_or(Ok(known.product_time), Duration::try_from_secs_f64)?,
        ..known
    };
    if args.table {
        return print_table(&args.file, limits);
    }
    let Limits { memory, product_time, product_memory, .. } = limits;
    answer(&args.file, WorkerLimits { memory, product_time, product_memory })
}
