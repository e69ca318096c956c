//! XYZ and PTS: a point a line, x y z first. PTS puts the number of points before them, once or cloud by cloud.

use std::path::Path;

use anyhow::{Result, bail};
use asbuilt_core::geometry::Vec3;
use indicatif::ProgressBar;

use super::text::{Lines, numbers};
use super::{ReadOptions, Sink, scan_of_points};

/// Reads points; a title and comments are passed over, a count is held against the points.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: Sink) -> Result<()> {
    let mut lines = Lines::open(path, bar)?;
    let mut points = Vec::new();
    let mut promised: Option<u64> = None;
    while let Some(line) = lines.next()? {
        if let Some(p) = numbers::<3>(line) {
            points.push(Vec3::from(p));
        } else if line.is_empty() || line.starts_with(['#', '/']) {
        } else if let Some(n) = line.parse().ok().filter(|_| points.is_empty() || promised.is_some()) {
            promised = Some(promised.unwrap_or(0).saturating_add(n));
        } else {
            let line = line.to_owned();
            if !points.is_empty() || lines.number() > 2 {
                bail!("line {}: three coordinates expected, found \"{line}\"", lines.number());
            }
        }
    }
    if let Some(n) = promised.filter(|&n| n != points.len() as u64) {
        bail!("it promises {n} points and holds {}: cut short?", points.len());
    }
    sink(scan_of_points(path, points, options.origin)?)
}
