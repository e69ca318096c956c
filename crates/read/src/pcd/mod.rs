//! PCD (PCL). Where VIEWPOINT says more than its default, the points are in the scanner's frame and VIEWPOINT is its
//! pose, as CloudCompare (from 2.13 on) and pcl_viewer read it; the default is what merged clouds carry, too.
//!
//! Files in the field have capitals, integers, commas and fields of the same name, which the `pcd-rs` crate refuses.

mod header;

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use asbuilt_core::geometry::Vec3;
use indicatif::ProgressBar;
use nalgebra::{Quaternion, UnitQuaternion};

use super::text::Lines;
use super::{Facts, OriginSource, RawScan, ReadOptions, ScanSink, scan_of_points};
use header::{PcdField, PcdHeader, Storage};

/// Reads all points.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: ScanSink) -> Result<()> {
    let mut lines = Lines::open(path, bar)?.with_decimal_commas(options.decimal_comma);
    let header = PcdHeader::read(&mut lines)?;
    let places = [header.place("x")?, header.place("y")?, header.place("z")?];
    bar.set_length(header.points);
    let (points, has_more) = match header.storage {
        Storage::Ascii => ascii(lines, &header, places, bar)?,
        Storage::Binary => binary(behind_header(path)?, &header, places, bar)?,
        Storage::Compressed => (compressed(behind_header(path)?, &header, places)?, false),
    };
    let has_pose = !is_default(&header.viewpoint);
    let here = ReadOptions { origin: if has_pose { Some(Vec3::zeros()) } else { options.origin }, ..options.clone() };
    let mut scan = scan_of_points(path, points, &here)?;
    if has_more {
        scan.notes.push(format!("its header counts {} points; more follow, which were not read", header.points));
    }
    let names: Vec<&str> = header.fields.iter().map(|f| f.name.as_str()).collect();
    scan.facts = Facts::from([
        ("data".into(), format!("{:?}", header.storage)),
        ("points".into(), header.points.to_string()),
        ("fields".into(), names.join(" ")),
        ("unit".into(), "not told".into()),
    ]);
    if has_pose {
        pose(&mut scan, &header.viewpoint, options);
    }
    sink(scan)
}

/// At zero and without rotation, however the quaternion is written.
fn is_default([x, y, z, w, i, j, k]: &[f64; 7]) -> bool {
    [x, y, z].into_iter().all(|c| *c == 0.0) && [i, j, k].into_iter().all(|c| c.abs() <= 1e-9 * w.abs()) && *w != 0.0
}

/// Rotates the scan by VIEWPOINT and moves it there.
fn pose(scan: &mut RawScan, viewpoint: &[f64; 7], options: &ReadOptions) {
    let [x, y, z, w, i, j, k] = *viewpoint;
    let rotation = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
    let scale = options.file_unit.map_or(1.0, super::Unit::metres);
    scan.anchor = Vec3::new(x, y, z) * scale;
    scan.content.beams.iter_mut().for_each(|b| b.offset = rotation * b.offset);
    scan.world_from_scan = Some([rotation.w, rotation.i, rotation.j, rotation.k]);
    scan.origin_source = Some(OriginSource::File);
    if rotation.angle() == 0.0 {
        scan.notes.push(
            "VIEWPOINT has a place and no rotation: its points are taken to be in the scanner's frame, as CloudCompare does; \
             if they are in world coordinates, set VIEWPOINT to 0 0 0 1 0 0 0 and give --origin"
                .into(),
        );
    }
}

/// The part of the file after the line DATA.
fn behind_header(path: &Path) -> Result<BufReader<File>> {
    let mut file = BufReader::with_capacity(1 << 20, File::open(path).context("cannot open it")?);
    loop {
        let mut line = Vec::new();
        if file.by_ref().take(1 << 16).read_until(b'\n', &mut line)? == 0 {
            bail!("it ends before its points");
        }
        if line.trim_ascii_start().to_ascii_uppercase().starts_with(b"DATA") {
            return Ok(file);
        }
    }
}

/// The points, and whether anything follows them.
fn ascii(mut lines: Lines, header: &PcdHeader, places: [usize; 3], bar: &ProgressBar) -> Result<(Vec<Vec3>, bool)> {
    // A field of several values takes as many words.
    let words_before = |place: usize| header.fields[..place].iter().map(|f| f.count).sum::<usize>();
    let places = places.map(words_before);
    let width: usize = header.fields.iter().map(|f| f.count).sum();
    let mut points = Vec::new();
    while (points.len() as u64) < header.points {
        let number = lines.number() + 1;
        let Some(point) = lines.chosen("a point", |words| (words.len() == width).then_some(places))? else {
            bail!(
                "its header promises {} points, more than the file holds: it ends with line {}",
                header.points,
                number - 1
            );
        };
        points.push(point.into());
        if points.len() % 65_536 == 0 {
            bar.set_position(points.len() as u64);
        }
    }
    let has_more = lines.next_filled()?;
    Ok((points, has_more))
}

fn binary(
    mut file: BufReader<File>,
    header: &PcdHeader,
    places: [usize; 3],
    bar: &ProgressBar,
) -> Result<(Vec<Vec3>, bool)> {
    let room = room(&mut file)?;
    if u128::from(header.points) * header.record() as u128 > u128::from(room) {
        bail!("its header promises {} points, more than the file holds", header.points);
    }
    let at = |place: usize| header.fields[..place].iter().map(PcdField::bytes).sum::<usize>();
    let starts = places.map(at);
    let mut record = vec![0; header.record()];
    let mut points = Vec::with_capacity(header.points as usize);
    for i in 0..header.points {
        file.read_exact(&mut record)?;
        let value = |axis: usize| number(&header.fields[places[axis]], &record[starts[axis]..]);
        points.push(Vec3::new(value(0), value(1), value(2)));
        if i.is_multiple_of(65_536) {
            bar.set_position(i);
        }
    }
    // Some fill up the last record.
    let more = u128::from(room) - u128::from(header.points) * header.record() as u128;
    Ok((points, more >= header.record() as u128))
}

/// All values of a field are stored together.
fn compressed(mut file: BufReader<File>, header: &PcdHeader, places: [usize; 3]) -> Result<Vec<Vec3>> {
    let room = room(&mut file)?;
    let mut sizes = [0; 8];
    file.read_exact(&mut sizes).context("it ends before its points")?;
    let size = |k: usize| u64::from(u32::from_le_bytes(std::array::from_fn(|i| sizes[k + i])));
    let (packed, unpacked) = (size(0), size(4));
    // LZF makes at most 264 bytes of 3.
    let fits = packed + 8 <= room && unpacked <= packed * 88 + 264;
    if !fits || u128::from(unpacked) != u128::from(header.points) * header.record() as u128 {
        bail!("its header promises {} points, more than the file holds", header.points);
    }
    let mut bytes = vec![0; packed as usize];
    file.read_exact(&mut bytes)?;
    let all =
        lzf::decompress(&bytes, unpacked as usize).map_err(|e| anyhow!("its compressed points are damaged: {e}"))?;
    if all.len() as u64 != unpacked {
        bail!("its compressed points are damaged: {} bytes of {unpacked}", all.len());
    }
    let points = header.points as usize;
    let start = |place: usize| header.fields[..place].iter().map(PcdField::bytes).sum::<usize>() * points;
    let value = |axis: usize, i: usize| {
        let field = &header.fields[places[axis]];
        number(field, &all[start(places[axis]) + i * field.bytes()..])
    };
    Ok((0..points).map(|i| Vec3::new(value(0, i), value(1, i), value(2, i))).collect())
}

fn room(file: &mut BufReader<File>) -> Result<u64> {
    let at = file.stream_position()?;
    let length = file.get_ref().metadata()?.len();
    file.seek(SeekFrom::Start(at))?;
    Ok(length.saturating_sub(at))
}

/// The first value of a field.
fn number(field: &PcdField, bytes: &[u8]) -> f64 {
    let word = || u64::from_le_bytes(std::array::from_fn(|k| if k < field.size { bytes[k] } else { 0 }));
    match (field.kind, field.size) {
        ('F', 4) => f64::from(f32::from_bits(word() as u32)),
        ('F', _) => f64::from_bits(word()),
        ('U', _) => word() as f64,
        (_, size) => {
            let shift = 64 - 8 * size as u32;
            ((word() << shift) as i64 >> shift) as f64
        }
    }
}
