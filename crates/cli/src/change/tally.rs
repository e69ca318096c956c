//! Voxels of objects, of components and in total, counted from the changes of the tiles.

use std::collections::HashMap;

use anyhow::Result;
use asbuilt_core::geometry::{Aabb, Solid};
use asbuilt_core::voxel::{ChangeClass, ChangeComponent, FillRule, Grid, VoxelChange, VoxelSet};
use asbuilt_core::{AtOnce, NEVER};
use postgres::{Row, Transaction};
use rayon::prelude::*;

use super::classes::ObjectClass;
use super::tiles::ChangeTile;
use crate::database::connect::explain;
use crate::database::names::Names;
use crate::output::say;
use asbuilt_read::memory;

/// What the report is about.
pub struct ChangeReport {
    pub objects: Vec<Counted>,
    /// Class, component, and the building objects whose boxes it meets.
    pub components: Vec<(&'static str, ChangeComponent, Vec<String>)>,
    /// Voxels by class, in the order of [`ChangeClass::ALL`].
    pub total: [u64; 5],
    /// Cubic metres.
    pub voxel_volume: f64,
    /// Whether objects have classes: between epochs, not against the drawn model.
    pub has_classes: bool,
}

/// An object with its voxels by class.
pub struct Counted {
    pub id: i64,
    pub name: String,
    pub global_id: String,
    pub voxels: [u64; 5],
    /// What became of it; `None` where the drawn model is compared.
    pub class: Option<ObjectClass>,
    solid: Option<Solid>,
}

/// How components are formed.
pub struct Parts {
    /// Least number of voxels.
    pub least: u64,
    /// Voxels with less than this gap are connected, metres; four voxels if it is not given.
    pub gap: Option<f64>,
}

impl ChangeReport {
    /// Counts voxels. Those of an object are the ones that it touches, or that lie within the tolerance of these.
    pub fn of(
        tx: &mut Transaction,
        names: &Names,
        tiles: &[ChangeTile],
        tolerance: f64,
        parts: &Parts,
    ) -> Result<Self> {
        let objects = objects(tx, names)?;
        let mut out = Self { objects, components: Vec::new(), total: [0; 5], voxel_volume: 0.0, has_classes: false };
        let mut whole: Option<VoxelChange> = None;
        for tile in tiles {
            let change = tile.change()?;
            out.voxel_volume = change.grid().voxel_volume();
            add(&mut out.total, &change.tally(None, 0.0, NEVER)?.voxels);
            let near = tile.bounds.expanded(tolerance + 2.0 * change.grid().voxel);
            out.objects.par_iter_mut().try_for_each(|o| o.count(&change, &near, tolerance))?;
            match &mut whole {
                Some(whole) => whole.merge(&change, NEVER)?,
                None => whole = Some(change),
            }
        }
        if let Some(whole) = whole {
            out.find_components(&whole, parts)?;
        }
        Ok(out)
    }

    /// Says of each object what became of it, by its id.
    pub fn classify(&mut self, mut classes: HashMap<i64, ObjectClass>) {
        self.objects.iter_mut().for_each(|o| o.class = classes.remove(&o.id));
        self.has_classes = true;
    }

    /// Components need the whole change at once; where that takes too much memory, the objects are still reported.
    fn find_components(&mut self, whole: &VoxelChange, parts: &Parts) -> Result<()> {
        let gap = parts.gap.unwrap_or(4.0 * whole.grid().voxel);
        let most = AtOnce(usize::try_from(memory::budget() / 4).unwrap_or(usize::MAX));
        let mut found = Vec::new();
        for class in [ChangeClass::New, ChangeClass::Disappeared] {
            match whole.components(class, parts.least, gap, &most) {
                Ok(some) => found.extend(some),
                Err(error @ asbuilt_core::Error::Argument { .. }) => return Err(error.into()),
                Err(error) => say!("asbuilt: no components: {error}"),
            }
        }
        found.sort_by_key(|c| std::cmp::Reverse(c.voxels));
        for c in found {
            self.components.push((whole.class_name(c.class), c, self.names_in(&c.bounds)));
        }
        Ok(())
    }

    fn names_in(&self, bounds: &Aabb) -> Vec<String> {
        let meets = |o: &&Counted| o.solid.as_ref().is_some_and(|s| s.bounds().overlaps(bounds));
        let mut names: Vec<String> = self.objects.iter().filter(meets).map(|o| o.name.clone()).collect();
        names.sort();
        names
    }
}

impl Counted {
    fn of(row: &Row) -> Result<Self> {
        let bytes: Option<&[u8]> = row.get(2);
        let solid = bytes.map(|b| Solid::from_bytes(b, NEVER)).transpose()?;
        Ok(Self { id: row.get(3), name: row.get(0), global_id: row.get(1), voxels: [0; 5], class: None, solid })
    }

    /// Adds the object's voxels in a tile.
    fn count(&mut self, change: &VoxelChange, near: &Aabb, tolerance: f64) -> Result<()> {
        let Some(solid) = self.solid.as_ref().filter(|s| s.bounds().overlaps(near)) else { return Ok(()) };
        let grid = change.grid();
        let grid = Grid { tile: grid.tile.expanded(tolerance + grid.voxel), ..*grid };
        let rule = if solid.volume().is_ok() { FillRule::Cover } else { FillRule::Surface };
        let mask = VoxelSet::of(solid, &grid, rule, NEVER)?;
        add(&mut self.voxels, &change.tally(Some(&mask), tolerance, NEVER)?.voxels);
        Ok(())
    }
}

fn objects(tx: &mut Transaction, names: &Names) -> Result<Vec<Counted>> {
    let sql = names.sql("SELECT name, global_id, @ext._ab_solid_send(solid), id FROM @building_object ORDER BY id");
    tx.query(&sql, &[]).map_err(explain)?.iter().map(Counted::of).collect()
}

fn add(to: &mut [u64; 5], more: &[u64; 5]) {
    to.iter_mut().zip(more).for_each(|(a, b)| *a += b);
}
