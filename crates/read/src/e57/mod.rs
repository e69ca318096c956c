//! E57 (ASTM E2807), through the `e57` crate.

mod mend;

use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Beams};
use e57::{CartesianCoordinate, Point, PointCloud, RecordDataType};
use indicatif::ProgressBar;
use nalgebra::{Quaternion, UnitQuaternion};

use super::grid::{GridCell, missing_directions};
use super::{Facts, NO_ROTATION, Order, OriginSource, RawScan, ReadOptions, ScanSink, drop_zeros, stem, unit};

/// Reads every point cloud of the file.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: ScanSink) -> Result<()> {
    unit::check(1.0, options.file_unit)?;
    let length = check_head(path)?;
    let (mut file, mut notes) = mend::open(path)?;
    let clouds = file.pointclouds();
    if clouds.is_empty() {
        bail!("it holds no point cloud");
    }
    bar.set_length(clouds.iter().map(|c| c.records).sum());
    let mut points = 0;
    for (i, cloud) in clouds.iter().enumerate() {
        if cloud.records == 0 && clouds.len() > 1 {
            notes.push(format!("point cloud {} of {} holds no points", i + 1, clouds.len()));
            continue;
        }
        check(cloud, length)?;
        let mut scan = read_cloud(&mut file, cloud, options, bar)?;
        scan.notes.append(&mut notes);
        scan.scans_in_file = Some(clouds.len() as u64);
        points += scan.content.len();
        scan.name =
            cloud.name.clone().filter(|n| !n.is_empty()).unwrap_or_else(|| format!("{} #{}", stem(path), i + 1));
        sink(scan)?;
    }
    if points == 0 {
        bail!("its point clouds hold no points");
    }
    Ok(())
}

/// The file's length, after refusing a header whose XML would not fit into the file: the library allocates it at once.
fn check_head(path: &Path) -> Result<u64> {
    let mut file = std::fs::File::open(path).context("cannot open it")?;
    let length = file.metadata()?.len();
    let mut head = [0; 48];
    if std::io::Read::read_exact(&mut file, &mut head).is_err() {
        return Ok(length); // the library says what is wrong with it
    }
    let [start, xml] = [24, 32].map(|at| u64::from_le_bytes(std::array::from_fn(|k| head[at + k])));
    if head.starts_with(b"ASTM-E57") && start.checked_add(xml).is_none_or(|end| end > length) {
        bail!("its header promises {xml} bytes of XML at {start}, beyond the end of a file of {length}");
    }
    Ok(length)
}

/// Refuses what makes the reader allocate without bound: fields that are all constant, more records than bytes.
fn check(cloud: &PointCloud, length: u64) -> Result<()> {
    let bits: u128 = cloud.prototype.iter().map(|r| bits(&r.data_type)).sum();
    if cloud.records > 0 && bits == 0 {
        bail!("a point cloud of {} records has only constant fields", cloud.records);
    }
    if u128::from(cloud.records) * bits / 8 > u128::from(length) {
        bail!("its header promises {} points, more than the file can hold", cloud.records);
    }
    if !cloud.has_cartesian() && !cloud.has_spherical() {
        bail!("a point cloud has neither cartesian nor spherical coordinates");
    }
    Ok(())
}

fn bits(data_type: &RecordDataType) -> u128 {
    match *data_type {
        RecordDataType::Single { .. } => 32,
        RecordDataType::Double { .. } => 64,
        RecordDataType::Integer { min, max } | RecordDataType::ScaledInteger { min, max, .. } => {
            let range = i128::from(max) - i128::from(min);
            if range > 0 { u128::from(range.ilog2()) + 1 } else { 0 }
        }
    }
}

/// Points in the scanner's frame become beams from its position. Without a pose, a grid or spherical coordinates
/// tell that the scanner is at zero; other clouds without pose are points without origin.
fn read_cloud(
    file: &mut mend::E57File,
    cloud: &PointCloud,
    options: &ReadOptions,
    bar: &ProgressBar,
) -> Result<RawScan> {
    let pose = cloud.transform.clone();
    let has_origin = pose.is_some() || cloud.has_row_column() || cloud.has_spherical();
    let pose = pose.unwrap_or_default();
    let q = Quaternion::new(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
    let scanner = Vec3::new(pose.translation.x, pose.translation.y, pose.translation.z);
    if !(q.norm() > 1e-6 && q.norm().is_finite() && scanner.iter().all(|c| c.is_finite())) {
        bail!("the pose of a point cloud is no pose");
    }
    let rotation = UnitQuaternion::from_quaternion(q);
    let (content, cells, unusable) = collect(file, cloud, options, bar, &rotation)?;
    let mut scan = RawScan {
        name: String::new(),
        sensor: sensor(cloud),
        world_from_scan: has_origin.then_some([rotation.w, rotation.i, rotation.j, rotation.k]),
        origin_source: has_origin.then_some(OriginSource::File),
        origin_sd: None,
        anchor: scanner,
        content,
        point_sources: None,
        scans_in_file: None,
        unusable,
        order: if cloud.has_row_column() || cloud.has_spherical() { Order::Measured } else { Order::NotTold },
        notes: Vec::new(),
        facts: facts(cloud),
    };
    if has_origin {
        let missing = missing_directions(&cells);
        scan.content.extend_without_return(missing.iter().map(|d| rotation * d));
    }
    // One may be a corner of something.
    if scan.content.beams.iter().filter(|b| b.offset == Vec3::zeros()).nth(1).is_some() {
        drop_zeros(&mut scan);
    }
    move_anchor(&mut scan, options.origin, has_origin);
    Ok(scan)
}

/// Number of points for which room is made at once: the header may promise more than there are.
const MAX_RESERVED: u64 = 1 << 24;

/// Beams, cells of the grid, and how many points were not finite.
type Collected = (Beams, Vec<GridCell>, u64);

fn collect(
    file: &mut mend::E57File,
    cloud: &PointCloud,
    options: &ReadOptions,
    bar: &ProgressBar,
    rotation: &UnitQuaternion<f64>,
) -> Result<Collected> {
    let grid = cloud.has_row_column();
    let room = cloud.records.min(MAX_RESERVED) as usize;
    let mut content = Beams::of(Vec::with_capacity(room));
    content.intensity = (options.intensity && cloud.has_intensity()).then(Vec::new);
    content.colour = (options.colour && cloud.has_color()).then(Vec::new);
    let mut cells = Vec::with_capacity(if grid { room } else { 0 });
    let mut unusable = 0;
    let mut reader = file.pointcloud_simple(cloud).context("its points cannot be read")?;
    reader.apply_pose(false);
    reader.intensity_to_color(false);
    reader.normalize_color(options.colour);
    reader.normalize_intensity(options.intensity);
    // The iterator repeats an error for ever: stop at the first.
    for (i, point) in reader.enumerate() {
        let point = point.with_context(|| format!("damaged after point {i} of {}", cloud.records))?;
        if i % 65_536 == 0 {
            bar.inc(65_536.min(cloud.records));
        }
        let local = match point.cartesian {
            CartesianCoordinate::Valid { x, y, z } => Some(Vec3::new(x, y, z)),
            CartesianCoordinate::Direction { x, y, z } => {
                push(&mut content, Beam { offset: rotation * Vec3::new(x, y, z), returned: false }, &point);
                continue;
            }
            CartesianCoordinate::Invalid => None,
        };
        let finite = local.filter(|p| p.iter().all(|c| c.is_finite()));
        unusable += u64::from(local.is_some() && finite.is_none());
        let local = finite;
        if let Some(p) = local {
            push(&mut content, Beam { offset: rotation * p, returned: true }, &point);
        }
        if let (true, Ok(row), Ok(column)) = (grid, u32::try_from(point.row), u32::try_from(point.column)) {
            cells.push(GridCell { row, column, point: local });
        }
    }
    if cells.iter().all(|c| c.point.is_some()) {
        cells.clear();
    }
    Ok((content, cells, unusable))
}

/// Adds a beam and, to the attributes that are kept, what was measured of it (0 where the file does not say).
fn push(content: &mut Beams, beam: Beam, point: &Point) {
    content.beams.push(beam);
    let full = |share: f32, full: f32| (share.clamp(0.0, 1.0) * full).round();
    if let Some(plane) = &mut content.intensity {
        plane.push(point.intensity.map_or(0, |i| full(i, f32::from(u16::MAX)) as u16));
    }
    if let Some(plane) = &mut content.colour {
        let part = |c: f32| full(c, f32::from(u8::MAX)) as u8;
        plane.push(point.color.as_ref().map_or([0; 3], |c| [part(c.red), part(c.green), part(c.blue)]));
    }
}

/// Where the file gives no position: makes the beams relative to the user's origin, or else to a point near them.
fn move_anchor(scan: &mut RawScan, origin: Option<Vec3>, has_origin: bool) {
    let Some(first) = scan.content.beams.first() else { return };
    if has_origin {
        return;
    }
    let anchor = origin.unwrap_or_else(|| (first.offset + scan.anchor).map(|c| c.round()));
    let shift = scan.anchor - anchor;
    scan.retain(|b| b.returned);
    scan.content.beams.iter_mut().for_each(|b| b.offset += shift);
    scan.anchor = anchor;
    scan.world_from_scan = origin.map(|_| NO_ROTATION);
    scan.origin_source = origin.map(|_| OriginSource::Given);
}

/// Fields, times, and whatever else a cloud says about itself.
fn facts(cloud: &PointCloud) -> Facts {
    let fields: Vec<String> = cloud.prototype.iter().map(|r| format!("{:?}", r.name)).collect();
    let mut out = Facts::from([
        ("points".into(), cloud.records.to_string()),
        ("fields".into(), fields.join(" ")),
        ("unit".into(), "metres (by the standard)".into()),
    ]);
    let texts = [("description", &cloud.description), ("serial number", &cloud.sensor_serial), ("guid", &cloud.guid)];
    out.extend(texts.into_iter().filter_map(|(name, text)| Some((name.into(), text.clone()?))));
    if let Some(time) = &cloud.acquisition_start {
        out.insert("acquisition start".into(), format!("{} s GPS", time.gps_time));
    }
    out
}

fn sensor(cloud: &PointCloud) -> Option<String> {
    let words: Vec<&str> =
        [&cloud.sensor_vendor, &cloud.sensor_model].into_iter().flatten().map(String::as_str).collect();
    (!words.is_empty()).then(|| words.join(" "))
}
