//! PCD (PCL), through the `pcd-rs` crate. The origin is VIEWPOINT's, unless that is the default of zero, which
//! merged clouds carry too; then it must be given.

use std::fs::File;
use std::io::{BufReader, Read, Seek};
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use asbuilt_core::geometry::Vec3;
use indicatif::ProgressBar;
use pcd_rs::{DataKind, DynReader, Field, PcdMeta};

use super::{ReadOptions, Sink, scan_of_points};

/// Longest record that a real file has.
const MAX_RECORD: u128 = 1 << 16;

/// Reads all points.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: Sink) -> Result<()> {
    let meta = check(path)?;
    bar.set_length(meta.num_points);
    let at = |name: &str| {
        let named = meta.field_defs.iter().filter(|f| !f.is_padding());
        named.into_iter().position(|f| f.name == name).ok_or_else(|| anyhow!("its points have no {name}"))
    };
    let places = [at("x")?, at("y")?, at("z")?];
    let mut points = Vec::new();
    for (i, record) in DynReader::open(path).context("not a readable PCD file")?.enumerate() {
        let record = record.with_context(|| format!("damaged after point {i} of {}", meta.num_points))?;
        points.push(Vec3::from(places.map(|p| number(&record.0[p]))));
        if i % 65_536 == 0 {
            bar.set_position(i as u64);
        }
    }
    let v = &meta.viewpoint;
    let viewpoint = Vec3::new(v.tx, v.ty, v.tz);
    let origin = (viewpoint != Vec3::zeros()).then_some(viewpoint).or(options.origin);
    sink(scan_of_points(path, points, origin)?)
}

/// Refuses headers that promise more than the file holds; the library would index beyond it.
fn check(path: &Path) -> Result<PcdMeta> {
    let file = File::open(path).context("cannot open it")?;
    let length = file.metadata()?.len();
    let mut reader = BufReader::new(file);
    let meta = PcdMeta::from_reader(&mut reader).context("not a readable PCD file")?;
    let room = u128::from(length - reader.stream_position()?);
    let record: u128 = meta.field_defs.iter().map(|f| f.kind.byte_size() as u128 * u128::from(f.count)).sum();
    let words: u128 = meta.field_defs.iter().map(|f| u128::from(f.count)).sum();
    if record > MAX_RECORD {
        bail!("a point of {record} bytes is no point");
    }
    let points = u128::from(meta.num_points);
    let holds = match meta.data {
        DataKind::Ascii => points * words * 2 <= room + 1,
        DataKind::Binary => points * record <= room,
        DataKind::BinaryCompressed => {
            let mut sizes = [0; 8];
            reader.read_exact(&mut sizes).context("it ends before its points")?;
            let size = |k: usize| u128::from(u32::from_le_bytes(std::array::from_fn(|i| sizes[k + i])));
            // LZF makes at most 264 bytes of 3.
            size(0) + 8 <= room && size(4) == points * record && size(4) <= size(0) * 88 + 264
        }
    };
    if !holds {
        bail!("its header promises {points} points, more than the file holds");
    }
    Ok(meta)
}

fn number(field: &Field) -> f64 {
    match field {
        Field::F32(v) => v.first().copied().map_or(f64::NAN, f64::from),
        Field::F64(v) => v.first().copied().unwrap_or(f64::NAN),
        _ => f64::NAN,
    }
}
