//! The comparison, tile by tile, by the server; its result is kept here, so that a server that cannot be written to (a
//! hot standby) can compare, too.

use anyhow::{Result, bail};
use asbuilt_core::NEVER;
use asbuilt_core::geometry::Aabb;
use asbuilt_core::voxel::VoxelChange;
use postgres::Transaction;
use postgres::types::ToSql;

use crate::database::connect::explain;
use crate::database::names::Names;
use crate::output::progress;

/// The older side.
#[derive(Debug, Clone, Copy)]
pub enum Old {
    /// An epoch of scans.
    Epoch(i32),
    /// The drawn objects.
    Model,
}

/// How two sides are compared; lengths in metres.
#[derive(Debug)]
pub struct Comparison {
    pub old: Old,
    pub new: i32,
    pub voxel: f64,
    pub threshold: i32,
    pub tolerance: Option<f64>,
    pub margin: f64,
    pub no_return_range: f64,
    pub exact: bool,
    pub tile: f64,
}

impl Comparison {
    /// The server's default where none is given.
    pub fn tolerance(&self) -> f64 {
        self.tolerance.unwrap_or(self.margin.min(8.0 * self.voxel))
    }
}

/// The change of a tile, packed as it is stored.
pub struct ChangeTile {
    pub bounds: Aabb,
    packed: Vec<u8>,
}

impl ChangeTile {
    pub fn change(&self) -> Result<VoxelChange> {
        Ok(VoxelChange::from_bytes(&self.packed, NEVER)?)
    }
}

/// Voxels by which tiles overlap while they are compared, so that the tolerance sees across their borders.
const HALO: f64 = 9.0;

/// The box of the returns of both epochs, and of the model where it is compared.
const EXTENT: &str = "
SELECT @ext.ab_box(pg_catalog.min((@ext.ab_min(b))[1]), pg_catalog.min((@ext.ab_min(b))[2]), pg_catalog.min((@ext.ab_min(b))[3]),
              pg_catalog.max((@ext.ab_max(b))[1]), pg_catalog.max((@ext.ab_max(b))[2]), pg_catalog.max((@ext.ab_max(b))[3]))::text
FROM  (SELECT @ext.ab_point_box(patch) AS b FROM @scan WHERE epoch = $1::int4 OR epoch = $2::int4
       UNION ALL SELECT @ext.ab_box(solid) FROM @building_object WHERE $3::bool) boxes";

const TILES: &str = "SELECT t::text FROM @ext.ab_tiles($1::text::@ext.ab_box, $2::float8) t ORDER BY 1";

/// One side of a tile ($2 with its surroundings) from an epoch.
fn of_epoch(parameter: usize) -> String {
    format!(
        "(SELECT coalesce(@ext.ab_occupancy_agg(patch, a.grid), @ext.ab_occupancy(a.grid, false))
          FROM @scan WHERE epoch = ${parameter}::int4 AND patch OPERATOR(@ext.&&) $2::text::@ext.ab_box)"
    )
}

/// The same from the model; an object without an inside fills the voxels of its surface.
const OF_MODEL: &str = "
(SELECT coalesce(@ext.ab_rollup_agg(@ext.ab_voxelize(solid, $3::float8,
            CASE WHEN @ext.ab_closedness(solid) = 'open surface'::text THEN 'surface'::text ELSE 'centre'::text END,
            $2::text::@ext.ab_box)),
        @ext.ab_occupancy(@ext.ab_grid($3::float8, $2::text::@ext.ab_box, 0::float8, 0::float8, false), true))
 FROM @building_object WHERE solid OPERATOR(@ext.&&) $2::text::@ext.ab_box AND $8::int4 IS NOT NULL)";

fn statement(old: Old) -> String {
    let older = match old {
        Old::Model => OF_MODEL.to_owned(),
        Old::Epoch(_) => of_epoch(8),
    };
    format!(
        "SELECT @ext._ab_change_send(@ext.ab_clip(@ext.ab_change(t.old, t.new, $4::int4, $5::float8), t.tile))
         FROM (SELECT $1::text::@ext.ab_box AS tile, {older} AS old, {} AS new
               FROM (SELECT @ext.ab_grid($3::float8, $2::text::@ext.ab_box, $6::float8, $7::float8, $10::bool) AS grid) a) t",
        of_epoch(9)
    )
}

/// Compares, and returns the changes of all tiles.
pub fn compare(tx: &mut Transaction, names: &Names, c: &Comparison) -> Result<Vec<ChangeTile>> {
    let (old, against_model) = match c.old {
        Old::Epoch(n) => (n, false),
        Old::Model => (c.new, true),
    };
    let extent = tx.query_one(&names.sql(EXTENT), &[&old, &c.new, &against_model]).map_err(explain)?;
    let Some(extent) = extent.get::<_, Option<String>>(0) else { bail!("the scans hold no returns") };
    let tiles = tx.query(&names.sql(TILES), &[&extent, &c.tile]).map_err(explain)?;
    let bar = progress("comparing", "tiles");
    bar.set_length(tiles.len() as u64);
    // The table of patches is small beside the beams it stands for: PostgreSQL would not take a second process for it.
    tx.batch_execute("SET LOCAL min_parallel_table_scan_size = 0").map_err(explain)?;
    let statement = tx.prepare(&names.sql(&statement(c.old))).map_err(explain)?;
    let mut out = Vec::with_capacity(tiles.len());
    for row in tiles {
        let tile: String = row.get(0);
        let bounds = Aabb::from_text(&tile)?;
        let wide = bounds.expanded(HALO * c.voxel).to_text();
        let parameters: [&(dyn ToSql + Sync); 10] =
            [&tile, &wide, &c.voxel, &c.threshold, &c.tolerance, &c.margin, &c.no_return_range, &old, &c.new, &c.exact];
        let row = tx.query_one(&statement, &parameters).map_err(explain)?;
        out.push(ChangeTile { bounds, packed: row.get(0) });
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(out)
}
