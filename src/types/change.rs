//! `ab_change`: core's byte form, on disk and on the wire; in hexadecimal as text; and the functions on it.

use asbuilt_core::geometry::Aabb;
use asbuilt_core::voxel::{ChangeClass, ChangeSettings, TileHeader, VoxelChange};
use asbuilt_core::{Error, Result};

use super::box_bytes;
use super::grid::grid_ret;
use super::hex::{hex_in, hex_out};
use super::occupancy::{OccupancyArg, cover};
use super::rollup::rolled_up;
use super::solid::SolidArg;
use crate::pg::{Account, Backend, Message, RowField, SqlValue, TextArray, TextInput, Varlena, sql_functions};

/// Text form: this, then the bytes in hexadecimal.
const PREFIX: &str = "ab_change:1:";

fn read(bytes: &[u8]) -> Result<VoxelChange> {
    VoxelChange::from_bytes(bytes, &Backend)
}

/// A change.
type ChangeArg<'a> = Varlena<'a, VoxelChange>;

impl ChangeArg<'_> {
    /// The whole of it.
    fn read(&self) -> Result<VoxelChange> {
        read(self.bytes())
    }
}

fn ret(change: &VoxelChange) -> Result<SqlValue> {
    Ok(SqlValue::Bytes(change.to_bytes(&Backend)?))
}

sql_functions! {
    on Account::Grid;

    fn ab_change_in(text: TextInput) { ret(&read(&hex_in(&text, "ab_change", PREFIX)?)?) }

    fn ab_change_out(change: ChangeArg) { hex_out(&change, PREFIX) }

    fn ab_change_recv(message: Message) { ret(&read(message.rest())?) }

    fn ab_change_send(change: ChangeArg) { Ok(change.copied()) }

    fn ab_change_grid(change: ChangeArg) { grid_ret(&VoxelChange::header(change.prefix(TileHeader::LEN))?.grid) }

    fn ab_change_clip(change: ChangeArg, tile: Aabb) { ret(&change.read()?.clipped(&tile, &Backend)?) }

    fn ab_change_between(old: OccupancyArg, new: OccupancyArg, threshold: i32, tolerance: Option<f64>) {
        let threshold = ChangeSettings::threshold(threshold)?;
        let (old, new) = (old.read()?, new.read()?);
        let margin = old.grid().margin.max(new.grid().margin).min(8.0 * new.grid().voxel);
        let tolerance = tolerance.unwrap_or(margin);
        ret(&VoxelChange::between(&old, &new, ChangeSettings { threshold, tolerance }, &Backend)?)
    }

    fn ab_change_rollup(c1: Option<ChangeArg>, c2: Option<ChangeArg>) {
        rolled_up(c1, c2, |c1, c2| {
            let mut sum = c1.read()?;
            sum.merge(&c2.read()?, &Backend)?;
            ret(&sum)
        })
    }

    fn ab_change_summary(change: ChangeArg, solid: Option<SolidArg>, margin: Option<f64>) {
        let change = change.read()?;
        let voxel = change.grid().voxel;
        let margin = margin.unwrap_or(change.settings().tolerance);
        if !(0.0..=8.0 * voxel).contains(&margin) {
            return Err(Error::argument("the margin", "from 0 to 8 voxels", format!("{margin} m")));
        }
        let mask = solid.map(|s| cover(&s, change.grid(), margin)).transpose()?;
        let tally = change.tally(mask.as_ref(), margin, &Backend)?;
        let (total, volume) = (tally.total(), change.grid().voxel_volume());
        let voxels: Vec<u64> = tally.voxels.into_iter().chain([total]).collect();
        let share = |n: u64| if total == 0 { RowField::Null } else { RowField::F64(n as f64 / total as f64) };
        let counts = voxels.iter().map(|&n| RowField::I64(n as i64));
        let volumes = voxels.iter().map(|&n| RowField::F64(n as f64 * volume));
        Ok(SqlValue::Row(counts.chain(volumes).chain(tally.voxels.into_iter().map(share)).collect()))
    }

    fn ab_change_voxels(rows: Rows; change: ChangeArg, classes: Option<TextArray>) {
        let classes: Vec<ChangeClass> = match classes {
            None => ChangeClass::ALL.to_vec(),
            Some(classes) => {
                classes.words("the classes")?.iter().map(|w| ChangeClass::parse(w)).collect::<Result<_>>()?
            }
        };
        let change = change.read()?;
        change.for_each(&Backend, |voxel, class| {
            if classes.contains(&class) {
                let [x, y, z] = <[f64; 3]>::from(change.grid().centre(voxel)).map(RowField::F64);
                rows.push(&[x, y, z, RowField::Text(change.class_name(class).into())]);
            }
        })?;
        Ok(SqlValue::Null)
    }

    fn ab_change_components(
        rows: Rows; change: ChangeArg, class: Option<String>, min_voxels: i32, gap: Option<f64>
    ) {
        let classes = match class {
            None => vec![ChangeClass::New, ChangeClass::Disappeared],
            Some(class) => vec![ChangeClass::parse(&class)?],
        };
        let Ok(least) = u64::try_from(min_voxels) else {
            return Err(Error::argument("the least number of voxels", "0 or more", min_voxels));
        };
        let change = change.read()?;
        let gap = gap.unwrap_or(4.0 * change.grid().voxel);
        let mut found = Vec::new();
        for class in classes {
            found.extend(change.components(class, least, gap, &Backend)?);
        }
        found.sort_by_key(|c| std::cmp::Reverse(c.voxels));
        for c in found {
            rows.push(&[
                RowField::Text(change.class_name(c.class).into()),
                RowField::I64(c.voxels as i64),
                RowField::F64(c.voxels as f64 * change.grid().voxel_volume()),
                RowField::Fixed(box_bytes(&c.bounds)),
                RowField::Vector(c.centroid.into()),
            ]);
        }
        Ok(SqlValue::Null)
    }
}
