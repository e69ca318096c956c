//! PTX: scans one after the other, each with its grid and pose; `0 0 0` is a beam without return.

use std::path::Path;

use anyhow::{Result, bail};
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Beams};
use indicatif::ProgressBar;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

use super::grid::{GridCell, missing_directions};
use super::text::{Lines, numbers};
use super::{Facts, NO_ROTATION, Order, OriginSource, RawScan, ReadOptions, ScanSink, stem, unit};

/// Reads every scan of the file.
pub fn read(path: &Path, options: &ReadOptions, bar: &ProgressBar, sink: ScanSink) -> Result<()> {
    let mut lines = Lines::open(path, bar)?.with_decimal_commas(options.decimal_comma);
    let mut number = 0;
    while let Some(columns) = next_count(&mut lines)? {
        let rows = lines.numbers::<1>("the number of rows")?[0];
        if !((1.0..=4e9).contains(&rows) && columns * rows <= 4e9) {
            bail!("line {}: {columns}×{rows} is no scan grid", lines.number());
        }
        number += 1;
        let PtxPose { rotation, anchor, are_world, notes: said } = pose(&mut lines)?;
        let (cells, mut notes) = cells(&mut lines, columns as u32, rows as u32)?;
        notes.splice(0..0, said);
        let from = if are_world { anchor } else { Vec3::zeros() };
        let offset = |p: Vec3| rotation * p - from;
        let mut beams: Vec<Beam> =
            cells.iter().filter_map(|c| c.point).map(|p| Beam { offset: offset(p), returned: true }).collect();
        beams.extend(missing_directions(&cells).iter().map(|d| Beam { offset: rotation * d, returned: false }));
        let facts = Facts::from([("grid".into(), format!("{columns} columns × {rows} rows"))]);
        let order = if columns == 1.0 || rows == 1.0 { Order::List } else { Order::Measured };
        // In a list an empty cell has no direction: it is a point that is none.
        let empty = cells.iter().filter(|c| c.point.is_none()).count() as u64;
        let unusable = if order == Order::List { empty } else { 0 };
        let name = if number == 1 { stem(path) } else { format!("{} #{number}", stem(path)) };
        let (world_from_scan, content) = (Some(quaternion(&rotation)), Beams::of(beams));
        let origin_source = Some(OriginSource::File);
        let scan = RawScan { name, world_from_scan, origin_source, anchor, content, ..RawScan::default() };
        let mut scan = RawScan { unusable, order, notes, facts, ..scan };
        unit::apply(options.file_unit, &mut scan);
        sink(scan)?;
    }
    if number == 0 {
        bail!("it holds no scan");
    }
    Ok(())
}

/// The number of columns that starts a scan, after blank lines; `None` at the end of the file.
fn next_count(lines: &mut Lines) -> Result<Option<f64>> {
    loop {
        let Some(line) = lines.next()? else { return Ok(None) };
        if line.is_empty() {
            continue;
        }
        let found = line.to_owned();
        return match numbers::<1>(&found) {
            Some([n]) if (1.0..=4e9).contains(&n) && n.fract() == 0.0 => Ok(Some(n)),
            _ => bail!("line {}: the number of columns of a scan expected, found \"{found}\"", lines.number()),
        };
    }
}

/// The frame of a scan's points.
struct PtxPose {
    rotation: Matrix3<f64>,
    anchor: Vec3,
    /// The points are in the world frame already.
    are_world: bool,
    notes: Vec<String>,
}

/// Scanner position and axes (repeated in the matrix), then the matrix for row vectors: a point p in the scanner's
/// frame is p·M in the world's.
fn pose(lines: &mut Lines) -> Result<PtxPose> {
    let position = Vec3::from(lines.numbers::<3>("the scanner's position")?);
    for what in ["the first axis", "the second axis", "the third axis"] {
        lines.numbers::<3>(what)?;
    }
    let mut rows = [[0.0; 4]; 4];
    for row in &mut rows {
        *row = lines.numbers::<4>("a row of the transformation")?;
    }
    if rows.iter().flatten().any(|v| !v.is_finite()) {
        bail!("line {}: the transformation is not finite", lines.number());
    }
    let mut notes = Vec::new();
    // Some write it for column vectors: then the place stands in its last column.
    let last_column = Vec3::new(rows[0][3], rows[1][3], rows[2][3]);
    if rows[3][..3] == [0.0; 3] && last_column != Vec3::zeros() {
        rows = std::array::from_fn(|i| std::array::from_fn(|j| rows[j][i]));
        notes.push("its transformation has the scanner's place in the last column, and was read so".into());
    }
    let rotation = Matrix3::from_fn(|i, j| rows[j][i]);
    if rotation.determinant().abs() < 1e-12 {
        bail!("line {}: the transformation puts all points into a plane: no scan has it", lines.number());
    }
    let mut anchor = Vec3::new(rows[3][0], rows[3][1], rows[3][2]);
    let apart = (position - anchor).norm() > 1e-3;
    let are_world = apart && anchor == Vec3::zeros() && rotation == Matrix3::identity();
    if are_world {
        anchor = position;
        notes.push(
            "its transformation is none, but its scanner's place is told: its points were taken as they are".into(),
        );
    } else if apart && position != Vec3::zeros() {
        notes.push(format!(
            "its scanner's place is told as {} {} {} and by its transformation as {} {} {}; the latter was taken",
            position.x, position.y, position.z, anchor.x, anchor.y, anchor.z
        ));
    }
    Ok(PtxPose { rotation, anchor, are_world, notes })
}

/// Cells, and a note. A single column is not a grid but a list of points in any order, whose count many writers guess.
fn cells(lines: &mut Lines, columns: u32, rows: u32) -> Result<(Vec<GridCell>, Vec<String>)> {
    let (mut out, mut notes) = (Vec::new(), Vec::new());
    let is_list = columns == 1 || rows == 1;
    'grid: for column in 0..columns {
        for row in 0..rows {
            let first = lines.number() + 1;
            let Some(p) = lines.point("a point")? else {
                if is_list && !out.is_empty() {
                    notes.push(format!(
                        "it promises {} points and holds {}; all were read",
                        columns.max(rows),
                        out.len()
                    ));
                    break 'grid;
                }
                bail!("it ends after line {}, where a point should follow", first - 1);
            };
            let p = Vec3::from(p);
            let point = (p != Vec3::zeros() && p.iter().all(|c| c.is_finite())).then_some(p);
            out.push(GridCell { row, column, point });
        }
    }
    Ok((out, notes))
}

fn quaternion(rotation: &Matrix3<f64>) -> [f64; 4] {
    if (rotation * rotation.transpose() - Matrix3::identity()).amax() > 1e-3 || rotation.determinant() < 0.0 {
        return NO_ROTATION; // scaled or mirrored: the beams are right all the same
    }
    let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix(rotation));
    [q.w, q.i, q.j, q.k]
}
