//! `asbuilt mesh-ifc`: the loader's child process.

use std::path::PathBuf;

use anyhow::Result;

#[derive(clap::Args, Debug)]
pub struct MeshIfcArgs {
    /// IFC file
    file: PathBuf,
    /// Bytes
    #[arg(long)]
    max_memory: u64,
}

pub fn run(args: &MeshIfcArgs) -> Result<()> {
    crate::read::ifc::answer(&args.file, args.max_memory)
}
