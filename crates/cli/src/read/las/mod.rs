//! LAS and LAZ, through the `las` crate. Without `--origin` the points have none.

mod check;

use std::fs::File;
use std::io::{BufReader, Seek};
use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Content};
use indicatif::ProgressBar;
use las::{LazParallelism, PointDataBuilder, Reader, ReaderOptions};

use super::{ReadOptions, Sink, scan_of_content};

/// Points read at a time: several LAZ chunks, so that they decompress in parallel; of long records fewer.
const AT_ONCE: u64 = 500_000;
const BYTES_AT_ONCE: u64 = 64 << 20;

/// Reads all points.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: Sink) -> Result<()> {
    let mut file = BufReader::with_capacity(1 << 20, File::open(path).context("cannot open it")?);
    let count = check::check(&mut file)?;
    file.rewind()?;
    bar.set_length(count);
    let parallel = ReaderOptions::default().with_laz_parallelism(LazParallelism::Yes);
    let mut reader = Reader::with_options(file, parallel).context("not a readable LAS file")?;
    let t = *reader.header().transforms();
    let mut data = PointDataBuilder::new().for_header(reader.header()).build();
    let mut content = Content { intensity: options.intensity.then(Vec::new), ..Content::default() };
    let mut colours = Vec::new();
    let at_once = AT_ONCE.min(BYTES_AT_ONCE / u64::from(reader.header().point_format().len()).max(1));
    while (content.len() as u64) < count {
        let got = reader.fill_points(at_once, &mut data).context("its points are damaged")?;
        if got == 0 {
            bail!("it ends after {} of {count} points", content.len());
        }
        // In every point format a record starts with x, y, z as 32-bit integers.
        content.beams.extend(data.raw_bytes().chunks_exact(data.record_len()).map(|record| {
            let coordinate = |at: usize| i32::from_le_bytes(std::array::from_fn(|k| record[at + k]));
            let offset = Vec3::new(t.x.direct(coordinate(0)), t.y.direct(coordinate(4)), t.z.direct(coordinate(8)));
            Beam { offset, returned: true }
        }));
        content.intensity.iter_mut().for_each(|plane| plane.extend(data.intensity()));
        if let (true, Some(some)) = (options.colour, data.rgb()) {
            colours.extend(some.map(|(r, g, b)| [r, g, b]));
        }
        bar.inc(got);
    }
    // The format wants sixteen bits a part; many writers fill eight.
    let shift = if colours.iter().flatten().any(|&part| part > 255) { 8 } else { 0 };
    content.colour =
        (!colours.is_empty()).then(|| colours.iter().map(|c| c.map(|part| (part >> shift) as u8)).collect());
    sink(scan_of_content(path, content, options.origin)?)
}
