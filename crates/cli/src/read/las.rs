//! LAS and LAZ, through the `las` crate. Without `--origin` the points have none.

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Content};
use indicatif::ProgressBar;
use las::{Header, LazParallelism, PointDataBuilder, Reader, ReaderOptions, raw};

use super::{ReadOptions, Sink, scan_of_content};

/// Points read at a time: several LAZ chunks, so that they decompress in parallel.
const AT_ONCE: u64 = 500_000;
/// Larger chunks than any writer makes would be allocated before a byte is checked.
const MAX_LAZ_CHUNK: u32 = 10_000_000;

/// Reads all points.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: Sink) -> Result<()> {
    let mut file = BufReader::with_capacity(1 << 20, File::open(path).context("cannot open it")?);
    let count = check(&mut file)?;
    file.rewind()?;
    bar.set_length(count);
    let parallel = ReaderOptions::default().with_laz_parallelism(LazParallelism::Yes);
    let mut reader = Reader::with_options(file, parallel).context("not a readable LAS file")?;
    let t = *reader.header().transforms();
    let mut data = PointDataBuilder::new().for_header(reader.header()).build();
    let mut content = Content { intensity: options.intensity.then(Vec::new), ..Content::default() };
    let mut colours = Vec::new();
    while (content.len() as u64) < count {
        let got = reader.fill_points(AT_ONCE, &mut data).context("its points are damaged")?;
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

/// Number of points, after refusing headers that would make the library allocate what they only claim.
fn check(file: &mut BufReader<File>) -> Result<u64> {
    let length = file.get_ref().metadata()?.len();
    let fixed = raw::Header::read_from(&mut *file).context("not a readable LAS file")?;
    if let Some(extended) = fixed.evlr {
        file.seek(SeekFrom::Start(extended.start_of_first_evlr))?;
        let mut head = [0u8; 60];
        file.read_exact(&mut head).context("an extended record lies beyond the end of the file")?;
        let claimed = u64::from_le_bytes(std::array::from_fn(|k| head[20 + k]));
        if claimed > length {
            bail!("an extended record claims {claimed} bytes of a file of {length}");
        }
    }
    file.rewind()?;
    let header = Header::new(&mut *file).context("not a readable LAS file")?;
    let (format, count) = (*header.point_format(), header.number_of_points());
    if format.is_compressed {
        let laz = header.laz_vlr().context("not a readable LAZ file")?;
        let odd = laz.items().is_empty() || laz.items_size() != u64::from(format.len());
        if odd || (!laz.uses_variable_size_chunks() && laz.chunk_size() > MAX_LAZ_CHUNK) {
            bail!("its LAZ compression is damaged or of an unknown kind");
        }
    } else {
        let room = length.saturating_sub(u64::from(fixed.offset_to_point_data));
        if u128::from(count) * u128::from(format.len()) > u128::from(room) {
            bail!("its header promises {count} points, more than the file holds");
        }
    }
    Ok(count)
}
