//! File formats: [`e57`], [`las`], [`ply`], [`ptx`], [`pcd`], [`xyz`] give scans, [`ifc`] gives a model; all of them
//! are read by a [`child`] process under a budget of [`memory`]. A file is what its [`content`] says; whether a scanner
//! stood where it says is [`origin`]'s doubt, what its numbers count in [`unit`]'s; [`frame`] brings it to the model.
//! [`packing`] makes patches of what
//! was read.
//!
//! The child is the program itself, called again: a program that reads through children answers to `mesh-ifc` with
//! [`ifc::answer`] and to `read-scan` with [`child::answer`], as `asbuilt` does. One that trusts its files reads within
//! its own process: [`ifc::read_within`], [`read_scans`].

#![forbid(unsafe_code)]
// Contents pages link to what they hand on, which is not public by itself.
#![allow(rustdoc::private_intra_doc_links)]

pub mod child;
mod content;
mod e57;
#[cfg(test)]
mod field_tests;
mod frame;
mod grid;
pub mod ifc;
mod las;
pub mod memory;
mod options;
mod origin;
mod overlay;
pub mod packing;
mod pcd;
mod planes;
mod ply;
mod ptx;
mod text;
mod unit;
mod xyz;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Beams};
use indicatif::ProgressBar;

pub use content::{FileContents, FileFormat, form, kind};
pub use frame::{FrameOptions, FrameTransform};
pub use options::ReadOptions;
use origin::Settler;
pub use origin::{IdentityPose, OriginSource, OriginsChoice};
pub use text::Columns;
pub use unit::Unit;

/// What a scan file holds, one value per scanner position.
#[derive(Debug, Default)]
pub struct RawScan {
    /// Name in the file, or the file's own.
    pub name: String,
    /// Scanner, where the file tells.
    pub sensor: Option<String>,
    /// Rotation of scanner to world (unit quaternion w, x, y, z); `None` when the points have no origin.
    pub world_from_scan: Option<[f64; 4]>,
    /// Who says where the scanner stood; `None` when the points have no origin.
    pub origin_source: Option<OriginSource>,
    /// Standard deviation of the origin an axis, metres, where it is known.
    pub origin_sd: Option<f64>,
    /// The scanner's place, or a reference point near the data; world metres.
    pub anchor: Vec3,
    /// Beams relative to `anchor`, world axes; with intensity and colour where they were asked for and are there.
    pub content: Beams,
    /// Point source id of every beam (LAS), where origins are sought by them.
    pub point_sources: Option<Vec<u16>>,
    /// How many scans its file holds, where that is known before it was read.
    pub scans_in_file: Option<u64>,
    /// Number of unusable points: not finite, or impossibly far.
    pub unusable: u64,
    pub order: Order,
    /// What the user should know about it.
    pub notes: Vec<String>,
    /// What the file says about itself: name and value.
    pub facts: Facts,
}

/// How the points of a scan are arranged.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Order {
    /// In rows and columns, or by angles: as a scanner measures.
    Measured,
    /// In no order, in a format that gives scans rows and columns.
    List,
    #[default]
    NotTold,
}

impl RawScan {
    /// Keeps the beams for which `keep` is true, with their attributes.
    pub fn retain(&mut self, keep: impl Fn(&Beam) -> bool) {
        if self.content.beams.iter().all(&keep) {
            return;
        }
        let kept: Vec<u32> =
            (0..self.content.len() as u32).filter(|&i| keep(&self.content.beams[i as usize])).collect();
        self.content = self.content.select(&kept);
        if let Some(sources) = &mut self.point_sources {
            *sources = kept.iter().map(|&i| sources[i as usize]).collect();
        }
    }
}

/// What a file says about itself: version, units, attributes, time, in its own words.
pub type Facts = std::collections::BTreeMap<String, String>;

/// The rotation of a scan whose file gives none.
pub const NO_ROTATION: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

/// Receives scans as they are read.
pub type ScanSink<'a> = &'a mut dyn FnMut(RawScan) -> Result<()>;

/// Reads every scan of a file. A library that panics on a damaged file becomes an error.
pub fn read_scans(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: ScanSink) -> Result<()> {
    let read = || {
        let mut settler = Settler::new(options)?;
        let model_from_file = options.frame.model_from_file()?;
        let mut placed = |mut scan: RawScan| {
            model_from_file.iter().for_each(|transform| transform.apply(&mut scan));
            sink(scan)
        };
        read_raw(path, options, bar, &mut |scan| settler.settle(scan, &mut placed))?;
        settler.finish()
    };
    silence_panics(read)
        .unwrap_or_else(|_| Err(anyhow!("the file is damaged: its reader gave up in the middle")))
        .map_err(in_words)
        .with_context(|| format!("{}", path.display()))
}

/// Every scan as its file tells it.
fn read_raw(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: ScanSink) -> Result<()> {
    match content::form(path)? {
        FileFormat::E57 => e57::read(path, options, bar, sink),
        FileFormat::Las => las::read(path, options, bar, sink),
        FileFormat::Ply => ply::read(path, options, bar, sink),
        FileFormat::Ptx => ptx::read(path, options, bar, sink),
        FileFormat::Pcd => pcd::read(path, options, bar, sink),
        FileFormat::Text => xyz::read(path, options, bar, sink),
        FileFormat::Ifc => bail!("it is a building model, not a scan"),
    }
}

/// Runs `work`; a panic inside is caught and not printed.
pub fn silence_panics<T>(work: impl FnOnce() -> T) -> std::thread::Result<T> {
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let result = catch_unwind(AssertUnwindSafe(work));
    std::panic::set_hook(hook);
    result
}

/// What the libraries say about a file that is too short, in a user's words.
fn in_words(error: anyhow::Error) -> anyhow::Error {
    let is_short = error.chain().any(|cause| {
        cause.downcast_ref::<std::io::Error>().is_some_and(|e| e.kind() == std::io::ErrorKind::UnexpectedEof)
            || cause.to_string() == "failed to fill whole buffer"
    });
    if error.chain().any(|cause| cause.to_string().contains("invalid checksum")) {
        return anyhow!("its bytes do not fit their checksums: it was damaged; copy or export it again");
    }
    if !is_short {
        return error;
    }
    let what = error.chain().map(ToString::to_string).find(|text| text != "failed to fill whole buffer");
    anyhow!(
        "{}: it is cut short, or damaged: copy or export it again",
        what.unwrap_or_else(|| "it ends too early".into())
    )
}

/// Points in world coordinates, in the file's unit, as a scan from `options.origin`, or as points without origin.
fn scan_of_points(path: &Path, points: Vec<Vec3>, options: &ReadOptions) -> Result<RawScan> {
    let beam = |offset| Beam { offset, returned: true };
    scan_of_content(path, Beams::of(points.into_iter().map(beam).collect()), options)
}

/// The same with attributes; offsets are still world coordinates.
fn scan_of_content(path: &Path, content: Beams, options: &ReadOptions) -> Result<RawScan> {
    scan_of_sources(path, content, None, options)
}

/// The same with the point source ids of LAS.
fn scan_of_sources(
    path: &Path,
    content: Beams,
    point_sources: Option<Vec<u16>>,
    options: &ReadOptions,
) -> Result<RawScan> {
    let origin = options.origin;
    let world_from_scan = origin.map(|_| NO_ROTATION);
    let origin_source = origin.map(|_| OriginSource::Given);
    let name = stem(path);
    let scan = RawScan { name, world_from_scan, origin_source, content, point_sources, ..RawScan::default() };
    let mut scan = RawScan { scans_in_file: Some(1), ..scan };
    unit::apply(options.file_unit, &mut scan);
    let all = scan.content.len();
    scan.retain(|b| b.offset.iter().all(|c| c.is_finite()));
    scan.unusable = (all - scan.content.len()) as u64;
    drop_zeros(&mut scan);
    let Some(first) = scan.content.beams.first().map(|b| b.offset) else {
        bail!(
            "it holds no points{}",
            if all > 0 { format!(": its {all} are zero or not finite") } else { String::new() }
        );
    };
    scan.anchor = origin.unwrap_or_else(|| first.map(|c| c.round()));
    scan.content.beams.iter_mut().for_each(|b| b.offset -= scan.anchor);
    Ok(scan)
}

/// Points at exactly zero are beams that did not return; their direction is lost.
fn drop_zeros(scan: &mut RawScan) {
    let all = scan.content.len();
    scan.retain(|b| b.offset != Vec3::zeros());
    let zeros = all - scan.content.len();
    if zeros > 0 {
        scan.notes.push(format!("{zeros} points at 0 0 0 are beams without return, and were dropped"));
    }
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
