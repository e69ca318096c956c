//! What the meshing process reports, piece by piece: what has been reported is safe, however the process ends.

use std::collections::{BTreeMap, HashMap};
use std::io::{Read, Write};
use std::time::Duration;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

use super::Product;
use super::looks::Look;
use super::soup::Soup;
use super::step::MapConversion;

/// A product without its mesh.
#[derive(Debug, Serialize, Deserialize)]
pub struct Draft {
    pub product: Product,
    pub has_body: bool,
    pub is_element: bool,
}

pub type Drafts = BTreeMap<u32, Draft>;

/// The file before any mesh.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct IfcHeader {
    pub drafts: Drafts,
    pub whole_of: HashMap<u32, u32>,
    pub left_out: BTreeMap<String, u64>,
    pub words: Vec<String>,
    pub map_conversion: Option<MapConversion>,
    pub length_unit: Option<f64>,
}

/// The result for a product.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct Outcome {
    pub soup: Soup,
    /// What is told of each of its items.
    pub looks: Vec<Look>,
    /// A door or window of which nothing opens.
    pub is_fixed: bool,
    pub note: Option<String>,
    /// Why the cut of its openings is not proven.
    pub unproven: Option<String>,
    /// Its openings had to be cut again.
    pub mended: bool,
}

#[derive(Debug, Serialize, Deserialize)]
pub enum WorkerMessage {
    Header(Box<IfcHeader>),
    /// A product is being meshed.
    Begun(u32),
    Meshed(u32, Outcome),
    /// A product has no mesh, and why.
    Failed(u32, String),
    /// Everything has been reported; the time of meshing and of its checks, all threads together.
    End {
        meshing: Duration,
        checks: Duration,
    },
    /// The file cannot be read.
    Refused(String),
}

impl WorkerMessage {
    pub fn write(&self, out: &mut impl Write) -> Result<()> {
        let bytes = postcard::to_stdvec(self)?;
        out.write_all(&(bytes.len() as u64).to_be_bytes())?;
        out.write_all(&bytes)?;
        Ok(out.flush()?)
    }

    /// The next piece, of at most this many bytes; `None` where the process has ended.
    pub fn read(from: &mut impl Read, most: u64) -> Result<Option<Self>> {
        let mut length = [0; 8];
        if from.read_exact(&mut length).is_err() {
            return Ok(None);
        }
        let length = u64::from_be_bytes(length);
        anyhow::ensure!(length <= most, "a product's mesh of {} MB is more than fits", length >> 20);
        let mut bytes = Vec::new();
        let got = from.take(length).read_to_end(&mut bytes)?;
        if got as u64 != length {
            return Ok(None);
        }
        postcard::from_bytes(&bytes).map(Some).context("the meshing process said something that nobody understands")
    }
}

/// What the process is to do, given on its standard input as one line.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Task {
    /// Products that are done.
    pub done: Vec<u32>,
    /// Products to be meshed first and each alone: a process has died on one of them.
    pub alone: Vec<u32>,
    /// The header was reported already.
    pub has_header: bool,
}
