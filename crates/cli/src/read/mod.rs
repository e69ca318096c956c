//! File formats: [`e57`], [`las`], [`ply`], [`ptx`], [`pcd`], [`xyz`] give scans, [`ifc`] gives a model; all of them
//! are read by a [`child`] process.

pub mod child;
mod e57;
mod grid;
pub mod ifc;
mod las;
mod pcd;
mod ply;
mod ptx;
mod text;
mod xyz;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Content};
use indicatif::ProgressBar;

/// What a scan file holds, position by position.
#[derive(Debug)]
pub struct RawScan {
    /// Name in the file, or the file's own.
    pub name: String,
    /// Scanner, where the file tells.
    pub sensor: Option<String>,
    /// Rotation of scanner to world (unit quaternion w, x, y, z); `None` when the points have no origin.
    pub world_from_scan: Option<[f64; 4]>,
    /// The scanner's place, or a reference point near the data; world metres.
    pub anchor: Vec3,
    /// Beams relative to `anchor`, world axes; with intensity and colour where they were asked for and are there.
    pub content: Content,
    /// Points that are no points: not finite, or impossibly far.
    pub unusable: u64,
}

impl RawScan {
    /// Keeps the beams that `keep` says yes to, with what belongs to them.
    pub fn retain(&mut self, keep: impl Fn(&Beam) -> bool) {
        if self.content.beams.iter().all(&keep) {
            return;
        }
        let kept: Vec<u32> =
            (0..self.content.len() as u32).filter(|&i| keep(&self.content.beams[i as usize])).collect();
        self.content = self.content.select(&kept);
    }
}

/// Rotation of a scan whose file gives none.
pub const NO_ROTATION: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

/// How to read.
#[derive(Debug, Clone, Default)]
pub struct ReadOptions {
    /// The scanner's place as the user gives it, for files that do not tell it.
    pub origin: Option<Vec3>,
    /// Keep intensities.
    pub intensity: bool,
    /// Keep colours.
    pub colour: bool,
}

/// Takes scans as they are read.
pub type Sink<'a> = &'a mut dyn FnMut(RawScan) -> Result<()>;

/// What a file is, by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A building model.
    Model,
    /// Laser scans or points.
    Scan,
}

const SCAN_ENDINGS: [&str; 8] = ["e57", "las", "laz", "ply", "ptx", "pcd", "xyz", "pts"];

/// Tells models from scans.
pub fn kind(path: &Path) -> Result<Kind> {
    let e = ending(path);
    match e.as_str() {
        "ifc" => Ok(Kind::Model),
        _ if SCAN_ENDINGS.contains(&e.as_str()) => Ok(Kind::Scan),
        _ => bail!("{}: unknown kind of file \".{e}\"; known are ifc, {}", path.display(), SCAN_ENDINGS.join(", ")),
    }
}

fn ending(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_lowercase()
}

/// No scanner ranges farther, metres: points beyond it carry a position that is not theirs.
const MAX_RANGE_M: f64 = 50_000.0;

/// A scan most of whose points lie impossibly far from the position in the file (merged clouds in world
/// coordinates, saved with the scanner at zero) becomes points without origin; a few such points are dropped.
fn doubt_origin(mut scan: RawScan, given: Option<Vec3>) -> RawScan {
    let is_far = |b: &Beam| b.returned && b.offset.norm() > MAX_RANGE_M;
    let far = scan.content.beams.iter().filter(|b| is_far(b)).count();
    if far == 0 || scan.world_from_scan.is_none() {
        return scan;
    }
    if given.is_none() && 2 * far > scan.content.len() {
        let shift =
            scan.content.beams.iter().find(|b| is_far(b)).map_or_else(Vec3::zeros, |b| b.offset.map(|c| c.round()));
        scan.anchor += shift;
        scan.retain(|b| b.returned);
        scan.content.beams.iter_mut().for_each(|b| b.offset -= shift);
        scan.world_from_scan = None;
    } else {
        scan.retain(|b| !is_far(b));
        scan.unusable += far as u64;
    }
    scan
}

/// Reads every scan of a file. A library that panics on a damaged file becomes an error.
pub fn read_scans(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: Sink) -> Result<()> {
    let sink: Sink = &mut |scan| sink(doubt_origin(scan, options.origin));
    let read = || match ending(path).as_str() {
        "e57" => e57::read(path, options, bar, sink),
        "las" | "laz" => las::read(path, options, bar, sink),
        "ply" => ply::read(path, options, bar, sink),
        "ptx" => ptx::read(path, bar, sink),
        "pcd" => pcd::read(path, options, bar, sink),
        _ => xyz::read(path, options, bar, sink),
    };
    silence_panics(read)
        .unwrap_or_else(|_| Err(anyhow!("the file is damaged: its reader gave up in the middle")))
        .with_context(|| format!("{}", path.display()))
}

/// Runs `work`; a panic inside is caught and not printed.
pub fn silence_panics<T>(work: impl FnOnce() -> T) -> std::thread::Result<T> {
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let result = catch_unwind(AssertUnwindSafe(work));
    std::panic::set_hook(hook);
    result
}

/// Points in world coordinates as a scan from `options.origin`, or as points without origin.
fn scan_of_points(path: &Path, points: Vec<Vec3>, origin: Option<Vec3>) -> Result<RawScan> {
    let beam = |offset| Beam { offset, returned: true };
    scan_of_content(path, Content::of(points.into_iter().map(beam).collect()), origin)
}

/// The same with planes; offsets are world coordinates yet.
fn scan_of_content(path: &Path, content: Content, origin: Option<Vec3>) -> Result<RawScan> {
    let world_from_scan = origin.map(|_| NO_ROTATION);
    let mut scan =
        RawScan { name: stem(path), sensor: None, world_from_scan, anchor: Vec3::zeros(), content, unusable: 0 };
    let all = scan.content.len();
    scan.retain(|b| b.offset.iter().all(|c| c.is_finite()));
    scan.unusable = (all - scan.content.len()) as u64;
    let first = scan.content.beams.first().ok_or_else(|| anyhow!("it holds no points"))?.offset;
    scan.anchor = origin.unwrap_or_else(|| first.map(|c| c.round()));
    scan.content.beams.iter_mut().for_each(|b| b.offset -= scan.anchor);
    Ok(scan)
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
