//! E57 (ASTM E2807), through the `e57` crate.

use std::path::Path;

use anyhow::{Context, Result, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::Beam;
use e57::{CartesianCoordinate, E57Reader, PointCloud, RecordDataType};
use indicatif::ProgressBar;
use nalgebra::{Quaternion, UnitQuaternion};

use super::grid::{Cell, missing_directions};
use super::{NO_ROTATION, RawScan, ReadOptions, Sink, stem};

/// Reads every point cloud of the file.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: Sink) -> Result<()> {
    let length = std::fs::metadata(path).context("cannot open it")?.len();
    let mut file = E57Reader::from_file(path).context("not a readable E57 file")?;
    let clouds = file.pointclouds();
    if clouds.is_empty() {
        bail!("it holds no point cloud");
    }
    bar.set_length(clouds.iter().map(|c| c.records).sum());
    let mut points = 0;
    for (i, cloud) in clouds.iter().enumerate() {
        check(cloud, length)?;
        let mut scan = read_cloud(&mut file, cloud, options, bar)?;
        points += scan.beams.len();
        scan.name =
            cloud.name.clone().filter(|n| !n.is_empty()).unwrap_or_else(|| format!("{} #{}", stem(path), i + 1));
        sink(scan)?;
    }
    if points == 0 {
        bail!("its point clouds hold no points");
    }
    Ok(())
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
    file: &mut E57Reader<std::io::BufReader<std::fs::File>>,
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
    let (beams, cells, unusable) = collect(file, cloud, bar, &rotation)?;
    let mut scan = RawScan {
        name: String::new(),
        sensor: sensor(cloud),
        world_from_scan: has_origin.then_some([rotation.w, rotation.i, rotation.j, rotation.k]),
        anchor: scanner,
        beams,
        unusable,
    };
    if has_origin {
        let missing = missing_directions(&cells);
        scan.beams.extend(missing.iter().map(|d| Beam { offset: rotation * d, returned: false }));
    }
    move_anchor(&mut scan, options.origin, has_origin);
    Ok(scan)
}

/// Points that room is made for at once: the header may promise more than there are.
const MAX_RESERVED: u64 = 1 << 24;

/// Beams, cells of the grid, and how many points were not finite.
type Collected = (Vec<Beam>, Vec<Cell>, u64);

fn collect(
    file: &mut E57Reader<std::io::BufReader<std::fs::File>>,
    cloud: &PointCloud,
    bar: &ProgressBar,
    rotation: &UnitQuaternion<f64>,
) -> Result<Collected> {
    let grid = cloud.has_row_column();
    let room = cloud.records.min(MAX_RESERVED) as usize;
    let (mut beams, mut cells) = (Vec::with_capacity(room), Vec::with_capacity(if grid { room } else { 0 }));
    let mut unusable = 0;
    let mut reader = file.pointcloud_simple(cloud).context("its points cannot be read")?;
    reader.apply_pose(false);
    reader.intensity_to_color(false);
    reader.normalize_color(false);
    reader.normalize_intensity(false);
    // The iterator repeats an error for ever: stop at the first.
    for (i, point) in reader.enumerate() {
        let point = point.with_context(|| format!("damaged after point {i} of {}", cloud.records))?;
        if i % 65_536 == 0 {
            bar.inc(65_536.min(cloud.records));
        }
        let local = match point.cartesian {
            CartesianCoordinate::Valid { x, y, z } => Some(Vec3::new(x, y, z)),
            CartesianCoordinate::Direction { x, y, z } => {
                beams.push(Beam { offset: rotation * Vec3::new(x, y, z), returned: false });
                continue;
            }
            CartesianCoordinate::Invalid => None,
        };
        let finite = local.filter(|p| p.iter().all(|c| c.is_finite()));
        unusable += u64::from(local.is_some() && finite.is_none());
        let local = finite;
        beams.extend(local.map(|p| Beam { offset: rotation * p, returned: true }));
        if let (true, Ok(row), Ok(column)) = (grid, u32::try_from(point.row), u32::try_from(point.column)) {
            cells.push(Cell { row, column, point: local });
        }
    }
    if cells.iter().all(|c| c.point.is_some()) {
        cells.clear();
    }
    Ok((beams, cells, unusable))
}

/// Where the file tells no position: makes the beams relative to the user's origin, or else to a point near them.
fn move_anchor(scan: &mut RawScan, origin: Option<Vec3>, has_origin: bool) {
    let Some(first) = scan.beams.first() else { return };
    if has_origin {
        return;
    }
    let anchor = origin.unwrap_or_else(|| (first.offset + scan.anchor).map(|c| c.round()));
    let shift = scan.anchor - anchor;
    scan.beams.retain(|b| b.returned);
    scan.beams.iter_mut().for_each(|b| b.offset += shift);
    scan.anchor = anchor;
    scan.world_from_scan = origin.map(|_| NO_ROTATION);
}

fn sensor(cloud: &PointCloud) -> Option<String> {
    let words: Vec<&str> =
        [&cloud.sensor_vendor, &cloud.sensor_model].into_iter().flatten().map(String::as_str).collect();
    (!words.is_empty()).then(|| words.join(" "))
}
