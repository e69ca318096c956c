//! IFC: products with their meshes, read by a child process so that a file that hangs or kills the geometry
//! kernel costs no more than an error.

mod geometry;
mod relations;

use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, anyhow, bail};
use asbuilt_core::geometry::{Closedness, Solid, Vec3, orient};
use serde::{Deserialize, Serialize};

use super::child::{epitaph, spawn};
use crate::memory;

/// A building object.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct Product {
    pub global_id: String,
    pub ifc_class: String,
    pub name: String,
    pub storey: Option<String>,
    /// Property values by `Set.Property`.
    pub properties: BTreeMap<String, String>,
    /// Property `LevelOfAccuracy`, its own or its whole's.
    pub level_of_accuracy: Option<String>,
    /// GlobalId of the object it is a part of.
    pub part_of: Option<String>,
    /// World metres.
    pub vertices: Vec<[f64; 3]>,
    pub triangles: Vec<[u32; 3]>,
    /// What the geometry library had to say about it.
    pub note: Option<String>,
}

/// What an IFC file holds.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct Model {
    pub products: Vec<Product>,
    /// Products with a body that could not be meshed: name and reason. They are among the products, without mesh.
    pub unmeshed: Vec<(String, String)>,
    /// Products whose coordinates the geometry library rounded: name and grid, metres.
    pub rounded: Vec<(String, f64)>,
    /// What is no building object (openings, spaces, grids), by class.
    pub left_out: BTreeMap<String, u64>,
    pub warnings: Vec<String>,
}

/// What the child sends: the model or why there is none.
type Answer = std::result::Result<Model, String>;

impl Product {
    /// Its solid: as meshed, or re-oriented where that closes it; `None` without mesh.
    pub fn solid(&self) -> Result<Option<Solid>> {
        if self.triangles.is_empty() {
            return Ok(None);
        }
        let vertices: Vec<Vec3> = self.vertices.iter().map(|v| Vec3::from(*v)).collect();
        let solid = Solid::new(vertices.clone(), self.triangles.clone())?;
        if solid.closedness() == Closedness::Open {
            let mut turned = self.triangles.clone();
            if orient(&vertices, &mut turned) > 0 {
                let mended = Solid::new(vertices, turned)?;
                if mended.closedness() != Closedness::Open {
                    return Ok(Some(mended));
                }
            }
        }
        Ok(Some(solid))
    }
}

/// Meshes a file in a child process of this program, which may take so much memory, bytes.
pub fn read(path: &Path, limit: Duration, max_memory: u64) -> Result<Model> {
    std::fs::metadata(path).with_context(|| format!("{}: cannot open it", path.display()))?;
    let mut command = Command::new(std::env::current_exe()?);
    command.arg("mesh-ifc").arg(format!("--max-memory={max_memory}")).arg("--").arg(path);
    // Settings of the geometry library from the user's environment would change the result.
    for (name, _) in std::env::vars_os().filter(|(n, _)| n.to_string_lossy().starts_with("IFC_LITE_")) {
        command.env_remove(name);
    }
    // Positions relative to each element's centre: in a projected system the library's single precision would lose
    // centimetres.
    command.env("IFC_LITE_LOCAL_FRAME", "1");
    let (mut child, words) = spawn(command)?;
    let answer = receive(&mut child, limit, max_memory);
    let _ = child.kill();
    let status = child.wait()?;
    let bytes = answer.with_context(|| format!("{}", path.display()))?;
    let model = match postcard::from_bytes::<Answer>(&bytes) {
        Ok(answer) => answer.map_err(|reason| anyhow!(reason)),
        Err(_) => Err(anyhow!(epitaph(status, &words.join().unwrap_or_default(), max_memory))),
    };
    model.with_context(|| format!("{}", path.display()))
}

/// Everything the child writes, within the time limit; more than a quarter of its memory would be too much for us too.
fn receive(child: &mut Child, limit: Duration, max_memory: u64) -> Result<Vec<u8>> {
    let mut pipe = child.stdout.take().context("no pipe to the meshing process")?.take(max_memory / 4);
    let reader = std::thread::spawn(move || {
        let mut bytes = Vec::new();
        pipe.read_to_end(&mut bytes).map(|_| bytes)
    });
    let start = Instant::now();
    while !reader.is_finished() {
        if start.elapsed() > limit {
            bail!("meshing took longer than {} s; raise --mesh-timeout, or repair the file", limit.as_secs());
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    let bytes = reader.join().map_err(|_| anyhow!("the reader of the meshing process failed"))?;
    let bytes = bytes.context("reading from the meshing process")?;
    if bytes.len() as u64 == max_memory / 4 {
        bail!("its meshes take more than a quarter of --max-memory {}", memory::shown(max_memory));
    }
    Ok(bytes)
}

/// The child's side: meshes the file and writes the answer to standard output.
pub fn answer(path: &Path, max_memory: u64) -> Result<()> {
    memory::limit(max_memory)?;
    // The parent holds the other end of standard input: it ends with the parent, however that ends.
    std::thread::spawn(|| {
        let _ = std::io::copy(&mut std::io::stdin().lock(), &mut std::io::sink());
        std::process::exit(1);
    });
    let answer: Answer = match std::fs::read(path) {
        Ok(bytes) => geometry::read(&bytes),
        Err(e) => Err(format!("cannot read it: {e}")),
    };
    std::io::stdout().lock().write_all(&postcard::to_stdvec(&answer)?)?;
    Ok(())
}
