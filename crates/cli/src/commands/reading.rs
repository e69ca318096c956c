//! How to read files: options that `load` and `inspect` share.

use std::path::Path;
use std::time::Duration;

use anyhow::{Result, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::num::text::numbers;

use crate::memory;
use crate::read::child::Job;
use crate::read::{Columns, IdentityPose, Unit, ifc};

#[derive(clap::Args, Debug, Clone)]
pub struct ReadingArgs {
    /// The scanner's position, for files that do not tell it
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_origin)]
    pub origin: Option<Vec3>,
    /// Drop returns nearer than this (the scanner's own platform), metres
    #[arg(long, default_value_t = 0.3, value_name = "M", allow_hyphen_values = true)]
    pub min_range: f64,
    /// Keep the intensity of every return (E57, LAS, LAZ, texts with a column i); 1 to 2 bytes a beam more
    #[arg(long)]
    pub intensity: bool,
    /// Keep the colour of every return (E57, LAS, LAZ, texts with columns r, g, b); up to 3 bytes a beam more
    #[arg(long, alias = "color")]
    pub colour: bool,
    /// What the columns of a text of points hold, in their order: n (number), x, y, z, i (intensity), r, g, b, - (passed over)
    #[arg(long, value_name = "n,x,y,z,…", allow_hyphen_values = true)]
    pub columns: Option<Columns>,
    /// A comma within a number of a text is its decimal mark, where the numbers themselves do not tell
    #[arg(long)]
    pub decimal_comma: bool,
    /// What the numbers of a file count in that does not tell it itself
    #[arg(long, value_name = "UNIT")]
    pub file_unit: Option<Unit>,
    /// Keep the points of LAS and LAZ that are classified as noise (classes 7 and 18)
    #[arg(long)]
    pub keep_noise: bool,
    /// What to make of a scanner at zero without rotation, as merged clouds have it
    #[arg(long, value_enum, default_value_t)]
    pub identity_pose: IdentityPose,
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
        Ok(())
    }

    pub fn max_memory(&self) -> u64 {
        self.max_memory.unwrap_or_else(memory::budget)
    }

    /// What the process that reads a file of scans is told.
    pub fn job(&self, file: &Path) -> Job {
        Job {
            file: file.to_owned(),
            origin: self.origin,
            min_range: self.min_range,
            intensity: self.intensity,
            colour: self.colour,
            columns: self.columns.clone(),
            decimal_comma: self.decimal_comma,
            file_unit: self.file_unit,
            keep_noise: self.keep_noise,
            identity_pose: self.identity_pose,
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

pub fn parse_origin(text: &str) -> std::result::Result<Vec3, String> {
    numbers::<3>(text).map(Vec3::from).ok_or_else(|| format!("\"{text}\" is not three numbers x,y,z"))
}
