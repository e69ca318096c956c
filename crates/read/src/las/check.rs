//! Checks the counts of a LAS or LAZ file against its size, before the libraries believe them and allocate.

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};

use anyhow::{Context, Result, bail};
use las::{Header, LazParallelism, raw};
use laz::LazVlr;
use laz::laszip::ChunkTable;

use crate::overlay::Overlay;

/// Larger chunks than any writer makes: points, and bytes of their points.
const MAX_LAZ_CHUNK: u64 = 10_000_000;
const MAX_CHUNK_BYTES: u64 = 1 << 30;
/// Bytes of a record's header.
const VLR_HEAD: u64 = 54;
const EVLR_HEAD: u64 = 60;

/// What reading needs to know.
pub struct Checked {
    pub count: u64,
    pub parallelism: LazParallelism,
    /// Number of points for which the file has room beyond those.
    pub more: u64,
}

/// Number of points, after refusing what the file cannot hold.
pub fn check(file: &mut BufReader<Overlay<File>>) -> Result<Checked> {
    let length = file.get_ref().len();
    let fixed = raw::Header::read_from(&mut *file).context("not a readable LAS file")?;
    records(file, &fixed, length)?;
    file.rewind()?;
    let header = Header::new(&mut *file).context("not a readable LAS file")?;
    let (len, count) = (u64::from(header.point_format().len()), header.number_of_points());
    let room = length.saturating_sub(u64::from(fixed.offset_to_point_data));
    if header.point_format().is_compressed {
        let laz = header.laz_vlr().context("not a readable LAZ file")?;
        if is_pointwise(&header) {
            // One stream from the first point to the last, which is read as it comes.
            return Ok(Checked { count, parallelism: LazParallelism::No, more: 0 });
        }
        let odd = laz.items().is_empty() || laz.items_size() != len;
        if odd || (!laz.uses_variable_size_chunks() && too_large(u64::from(laz.chunk_size()), len)) {
            bail!("its LAZ compression is damaged or of an unknown kind");
        }
        file.seek(SeekFrom::Start(u64::from(fixed.offset_to_point_data)))?;
        chunks(file, &laz, length, count)?;
    } else if u128::from(count) * u128::from(len) > u128::from(room) {
        bail!("its header promises {count} points, more than the file holds");
    }
    // What stands behind the points, extended records or waveforms, is no point.
    let end = fixed.evlr.map(|e| e.start_of_first_evlr).filter(|&at| at > 0).unwrap_or(length).min(length);
    let is_plain = !header.point_format().is_compressed && !header.point_format().has_waveform;
    let rest = end.saturating_sub(u64::from(fixed.offset_to_point_data) + count * len);
    let more = if is_plain { rest / len.max(1) } else { 0 };
    Ok(Checked { count, parallelism: LazParallelism::Yes, more })
}

/// The first LAZ files were one chunk without a table.
fn is_pointwise(header: &Header) -> bool {
    let record = header.vlrs().iter().find(|v| v.user_id == LazVlr::USER_ID && v.record_id == LazVlr::RECORD_ID);
    record.is_some_and(|v| v.data.starts_with(&1u16.to_le_bytes()))
}

/// The records beside the points; each extended one is visited.
fn records(file: &mut BufReader<Overlay<File>>, fixed: &raw::Header, length: u64) -> Result<()> {
    let (start, points) = (u64::from(fixed.header_size), u64::from(fixed.offset_to_point_data));
    let claimed = u64::from(fixed.number_of_variable_length_records) * VLR_HEAD;
    if points > length || start + claimed > points {
        bail!(
            "its header promises {} records before points at {points}, which a file of {length} bytes does not hold",
            fixed.number_of_variable_length_records
        );
    }
    let Some(extended) = fixed.evlr else { return Ok(()) };
    let mut at = extended.start_of_first_evlr;
    if u64::from(extended.number_of_evlrs) > length / EVLR_HEAD {
        bail!("its header promises {} extended records, more than the file holds", extended.number_of_evlrs);
    }
    for _ in 0..extended.number_of_evlrs {
        file.seek(SeekFrom::Start(at))?;
        let mut head = [0u8; EVLR_HEAD as usize];
        file.read_exact(&mut head).context("an extended record lies beyond the end of the file")?;
        let claimed = u64::from_le_bytes(std::array::from_fn(|k| head[20 + k]));
        let end = at.checked_add(EVLR_HEAD).and_then(|n| n.checked_add(claimed)).filter(|&end| end <= length);
        let Some(end) = end else { bail!("an extended record claims {claimed} bytes of a file of {length}") };
        at = end;
    }
    Ok(())
}

/// The table of chunks; its start is stored at the start of the points or, by writers to a stream, at the file's end.
fn chunks(file: &mut BufReader<Overlay<File>>, laz: &LazVlr, length: u64, count: u64) -> Result<()> {
    let (point, data) = (laz.items_size(), file.stream_position()?);
    let mut at = number(file)?;
    if at <= data as i64 {
        file.seek(SeekFrom::Start(length.saturating_sub(8)))?;
        at = number(file)?;
    }
    let Some(table) = u64::try_from(at).ok().filter(|&at| at >= data + 8 && at + 8 <= length) else {
        bail!("its table of chunks lies at {at}, beyond the points of a file of {length} bytes");
    };
    file.seek(SeekFrom::Start(table + 4))?;
    let mut chunks = [0; 4];
    file.read_exact(&mut chunks)?;
    let chunks = u64::from(u32::from_le_bytes(chunks));
    // Each chunk begins with a point that is not compressed.
    let room = table - data - 8;
    if u128::from(chunks) * u128::from(point) > u128::from(room) + u128::from(point) {
        bail!("its table promises {chunks} chunks, more than the file holds");
    }
    file.seek(SeekFrom::Start(data))?;
    let read = ChunkTable::read_from(&mut *file, laz).context("its table of chunks is damaged")?;
    let (mut bytes, mut points) = (0u128, 0u128);
    for chunk in &read {
        bytes += u128::from(chunk.byte_count);
        points += u128::from(chunk.point_count);
        if too_large(chunk.point_count, point) {
            bail!("its table of chunks promises one of {} points, more than any has", chunk.point_count);
        }
    }
    if bytes > u128::from(room) || points < u128::from(count) {
        bail!("its header promises {count} points, more than its {chunks} chunks hold");
    }
    Ok(())
}

fn number(file: &mut BufReader<Overlay<File>>) -> Result<i64> {
    let mut bytes = [0; 8];
    file.read_exact(&mut bytes).context("it ends before its points")?;
    Ok(i64::from_le_bytes(bytes))
}

fn too_large(points: u64, len: u64) -> bool {
    points > MAX_LAZ_CHUNK || points.saturating_mul(len) > MAX_CHUNK_BYTES
}
