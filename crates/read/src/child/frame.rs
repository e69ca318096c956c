//! Frames between the reading process and its parent: a kind, a length, and as many bytes.

use std::io::{ErrorKind, Read, Write};

use anyhow::{Result, bail};
use serde::{Deserialize, Serialize};

use crate::{Facts, OriginSource};

/// What a frame holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameKind {
    /// Position and length of the progress.
    Progress = 1,
    /// A scan begins: [`ScanHead`]. The parent answers with the number of its station, unless it is empty.
    Scan = 2,
    /// A packed patch.
    Patch = 3,
    /// The scan is at its end: [`crate::packing::Packed`].
    Packed = 4,
    /// The file is at its end.
    End = 5,
    /// Why it cannot be read: text.
    Failure = 6,
}

/// A scan, sent before its patches.
#[derive(Debug, Serialize, Deserialize)]
pub struct ScanHead {
    pub name: String,
    pub sensor: Option<String>,
    /// Unit quaternion w, x, y, z; `None` when the points have no origin.
    pub world_from_scan: Option<[f64; 4]>,
    /// Who says where the scanner stood.
    pub origin_source: Option<OriginSource>,
    /// Standard deviation of the origin an axis, metres.
    pub origin_sd: Option<f64>,
    /// World metres.
    pub anchor: [f64; 3],
    pub is_empty: bool,
    /// Number of unusable points.
    pub unusable: u64,
    /// What the user should know about it.
    pub notes: Vec<String>,
    /// What the file says about itself.
    pub facts: Facts,
}

/// Longest frame: no patch and no name is longer; PostgreSQL takes no more either.
const LONGEST: u32 = 1 << 30;

pub fn write(out: &mut impl Write, kind: FrameKind, bytes: &[u8]) -> Result<()> {
    let Some(len) = u32::try_from(bytes.len()).ok().filter(|&n| n <= LONGEST) else {
        bail!("{} bytes in one piece are more than PostgreSQL takes", bytes.len());
    };
    out.write_all(&[kind as u8])?;
    out.write_all(&len.to_be_bytes())?;
    out.write_all(bytes)?;
    Ok(())
}

/// The next frame; `None` where the pipe is at its end.
pub fn read(from: &mut impl Read) -> Result<Option<(FrameKind, Vec<u8>)>> {
    let mut head = [0; 5];
    match from.read_exact(&mut head) {
        Err(e) if e.kind() == ErrorKind::UnexpectedEof => return Ok(None),
        other => other?,
    }
    let kinds =
        [FrameKind::Progress, FrameKind::Scan, FrameKind::Patch, FrameKind::Packed, FrameKind::End, FrameKind::Failure];
    let len = u32::from_be_bytes([head[1], head[2], head[3], head[4]]);
    let Some(kind) = kinds.into_iter().find(|k| *k as u8 == head[0] && len <= LONGEST) else {
        bail!("the reading process said something that nobody understands");
    };
    let mut bytes = Vec::new();
    let got = from.take(u64::from(len)).read_to_end(&mut bytes)?;
    Ok((got as u64 == u64::from(len)).then_some((kind, bytes)))
}
