//! XYZ and PTS: a point a line, x y z first.

use std::path::Path;

use anyhow::{Result, bail};
use asbuilt_core::geometry::Vec3;
use indicatif::ProgressBar;

use super::text::{Lines, numbers};
use super::{ReadOptions, Sink, scan_of_points};

/// Reads points; a header line, comments and a PTS point count are passed over.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: Sink) -> Result<()> {
    let mut lines = Lines::open(path, bar)?;
    let mut points = Vec::new();
    while let Some(line) = lines.next()? {
        if let Some(p) = numbers::<3>(line) {
            points.push(Vec3::from(p));
        } else if !line.is_empty() && !line.starts_with(['#', '/']) {
            let line = line.to_owned();
            // A title, or the count that starts a PTS file.
            if !points.is_empty() || lines.number() > 2 {
                bail!("line {}: three coordinates expected, found \"{line}\"", lines.number());
            }
        }
    }
    sink(scan_of_points(path, points, options.origin)?)
}
