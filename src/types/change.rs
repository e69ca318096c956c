//! `ab_change`: core's byte form, on disk and on the wire; in hexadecimal as text; and the functions on it.

use asbuilt_core::voxel::{Change, Class, Settings, TileHeader};
use asbuilt_core::{Error, Result};

use super::grid::grid_ret;
use super::hex::{hex_in, hex_out};
use super::occupancy::{cover, occupancy_arg, words};
use super::rollup::rolled_up;
use super::{box_bytes, box_from};
use crate::pg::{Account, Args, Backend, Field, Rows, SqlValue, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_change:1:";

fn read(bytes: &[u8]) -> Result<Change> {
    Change::from_bytes(bytes, &Backend)
}

fn arg(args: &Args, i: usize) -> Result<Change> {
    read(args.bytes(i))
}

fn ret(change: &Change) -> Result<SqlValue> {
    Ok(SqlValue::Bytes(change.to_bytes(&Backend)?))
}

sql_functions! {
    on Account::Grid;

    fn ab_change_in(args) { ret(&read(&hex_in(args, "ab_change", PREFIX)?)?) }

    fn ab_change_out(args) { hex_out(args, PREFIX) }

    fn ab_change_recv(args) { ret(&read(args.message(0))?) }

    fn ab_change_send(args) { Ok(args.copied(0)) }

    fn ab_change_grid(args) { grid_ret(&Change::header(args.prefix(0, TileHeader::LEN))?.grid) }

    fn ab_change_clip(args) { ret(&arg(args, 0)?.clipped(&box_from(&args.fixed(1)), &Backend)?) }

    /// ab_change(old, new, threshold, tolerance)
    fn ab_change_between(args) {
        if (0..3).any(|i| args.is_null(i)) {
            return Ok(SqlValue::Null);
        }
        let threshold = Settings::threshold(args.i32(2))?;
        let (old, new) = (occupancy_arg(args, 0)?, occupancy_arg(args, 1)?);
        let margin = old.grid().margin.max(new.grid().margin).min(8.0 * new.grid().voxel);
        let tolerance = if args.is_null(3) { margin } else { args.f64(3) };
        ret(&Change::between(&old, &new, Settings { threshold, tolerance }, &Backend)?)
    }

    /// ab_rollup(change, change)
    fn ab_change_rollup(args) {
        rolled_up(args, || {
            let mut sum = arg(args, 0)?;
            sum.merge(&arg(args, 1)?, &Backend)?;
            ret(&sum)
        })
    }

    /// ab_summary(change, solid, margin)
    fn ab_change_summary(args) {
        if args.is_null(0) {
            return Ok(SqlValue::Null);
        }
        let change = arg(args, 0)?;
        let voxel = change.grid().voxel;
        let margin = if args.is_null(2) { change.settings().tolerance } else { args.f64(2) };
        if !(0.0..=8.0 * voxel).contains(&margin) {
            return Err(Error::argument("the margin", "from 0 to 8 voxels", format!("{margin} m")));
        }
        let mask = if args.is_null(1) { None } else { Some(cover(args, 1, change.grid(), margin)?) };
        let tally = change.tally(mask.as_ref(), margin, &Backend)?;
        let (total, volume) = (tally.total(), change.grid().voxel_volume());
        let voxels: Vec<u64> = tally.voxels.into_iter().chain([total]).collect();
        let share = |n: u64| if total == 0 { Field::Null } else { Field::F64(n as f64 / total as f64) };
        let counts = voxels.iter().map(|&n| Field::I64(n as i64));
        let volumes = voxels.iter().map(|&n| Field::F64(n as f64 * volume));
        Ok(SqlValue::Row(counts.chain(volumes).chain(tally.voxels.into_iter().map(share)).collect()))
    }

    /// ab_voxels(change, classes)
    fn ab_change_voxels(args) {
        let mut rows = Rows::new(args)?;
        if args.is_null(0) {
            return Ok(SqlValue::Null);
        }
        let classes: Vec<Class> = match args.is_null(1) {
            true => Class::ALL.to_vec(),
            false => words(args, 1, "the classes")?.iter().map(|w| Class::parse(w)).collect::<Result<_>>()?,
        };
        let change = arg(args, 0)?;
        change.for_each(&Backend, |voxel, class| {
            if classes.contains(&class) {
                let [x, y, z] = <[f64; 3]>::from(change.grid().centre(voxel)).map(Field::F64);
                rows.push(&[x, y, z, Field::Text(change.class_name(class).into())]);
            }
        })?;
        Ok(SqlValue::Null)
    }

    /// ab_components(change, class, min_voxels, gap)
    fn ab_change_components(args) {
        let mut rows = Rows::new(args)?;
        if args.is_null(0) || args.is_null(2) {
            return Ok(SqlValue::Null);
        }
        let classes = match args.is_null(1) {
            true => vec![Class::New, Class::Disappeared],
            false => vec![Class::parse(&args.text(1))?],
        };
        let Ok(least) = u64::try_from(args.i32(2)) else {
            return Err(Error::argument("the least number of voxels", "0 or more", args.i32(2)));
        };
        let change = arg(args, 0)?;
        let gap = if args.is_null(3) { 4.0 * change.grid().voxel } else { args.f64(3) };
        let mut found = Vec::new();
        for class in classes {
            found.extend(change.components(class, least, gap, &Backend)?);
        }
        found.sort_by_key(|c| std::cmp::Reverse(c.voxels));
        for c in found {
            rows.push(&[
                Field::Text(change.class_name(c.class).into()),
                Field::I64(c.voxels as i64),
                Field::F64(c.voxels as f64 * change.grid().voxel_volume()),
                Field::Fixed(box_bytes(&c.bounds)),
                Field::Vector(c.centroid.into()),
            ]);
        }
        Ok(SqlValue::Null)
    }
}
