//! How to read files: options that `load` and `inspect` share.

use std::path::Path;
use std::time::Duration;

use anyhow::{Result, bail};

use asbuilt_read::child::Job;
use asbuilt_read::memory;
use asbuilt_read::{ReadOptions, ifc};

#[derive(clap::Args, Debug, Clone)]
pub struct ReadingArgs {
    #[command(flatten)]
    pub options: ReadOptions,
    /// Drop returns nearer than this (the scanner's own platform), metres
    #[arg(long, default_value_t = 0.3, value_name = "M", allow_hyphen_values = true)]
    pub min_range: f64,
    /// Give up meshing a model after this many seconds
    #[arg(long, default_value_t = 300, value_name = "S")]
    pub mesh_timeout: u64,
    /// Give up meshing a single product after this many seconds; the others are loaded
    #[arg(long, default_value_t = 20, value_name = "S", value_parser = clap::value_parser!(u64).range(1..))]
    pub product_timeout: u64,
    /// Most memory that meshing may take for a single product; the others are loaded
    #[arg(long, default_value = "2GB", value_name = "SIZE", value_parser = memory::parse)]
    pub product_memory: u64,
    /// Most memory that reading a file may take, e.g. 4GB [default: three quarters of the machine's]
    #[arg(long, value_name = "SIZE", value_parser = memory::parse)]
    pub max_memory: Option<u64>,
}

impl ReadingArgs {
    /// Refuses what no option may be.
    pub fn check(&self) -> Result<()> {
        if !(self.min_range >= 0.0 && self.min_range.is_finite()) {
            bail!("--min-range {} must be 0 or more", self.min_range);
        }
        self.options.check()
    }

    pub fn max_memory(&self) -> u64 {
        self.max_memory.unwrap_or_else(memory::budget)
    }

    /// What the process that reads a file of scans is told.
    pub fn job(&self, file: &Path) -> Job {
        Job {
            file: file.to_owned(),
            options: self.options.clone(),
            min_range: self.min_range,
            max_memory: self.max_memory(),
        }
    }

    /// What the processes that mesh a model may take.
    pub fn limits(&self) -> ifc::Limits {
        ifc::Limits {
            time: Duration::from_secs(self.mesh_timeout),
            memory: self.max_memory(),
            product_time: Duration::from_secs(self.product_timeout),
            product_memory: self.product_memory,
        }
    }
}
