//! The comparison, tile by tile, into a temporary table.

use anyhow::{Result, bail};
use asbuilt_core::geometry::Aabb;
use postgres::types::ToSql;
use postgres::{Client, Transaction};

use crate::database::connect::explain;
use crate::database::copy::BinaryCopy;
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
    /// What the server takes where none is given.
    pub fn tolerance(&self) -> f64 {
        self.tolerance.unwrap_or(self.margin.min(8.0 * self.voxel))
    }
}

/// Voxels by which tiles overlap while they are compared, so that the tolerance sees across their borders.
const HALO: f64 = 9.0;

/// The box of the returns of both epochs, and of the model where it is compared.
const EXTENT: &str = "
SELECT ab_box(min((ab_min(b))[1]), min((ab_min(b))[2]), min((ab_min(b))[3]),
              max((ab_max(b))[1]), max((ab_max(b))[2]), max((ab_max(b))[3]))::text
FROM  (SELECT ab_point_box(patch) AS b FROM scan WHERE epoch = $1 OR epoch = $2
       UNION ALL SELECT ab_box(solid) FROM building_object WHERE $3) boxes";

const TILES: &str = "SELECT t::text FROM ab_tiles($1::text::ab_box, $2) t ORDER BY 1";

/// One side of a tile ($2 with its surroundings) from an epoch.
fn of_epoch(parameter: usize) -> String {
    format!(
        "(SELECT coalesce(ab_occupancy_agg(patch, a.grid), ab_occupancy(a.grid))
          FROM scan WHERE epoch = ${parameter} AND patch && $2::text::ab_box)"
    )
}

/// The same from the model; an object without inside fills the voxels of its surface.
const OF_MODEL: &str = "
(SELECT coalesce(ab_rollup_agg(ab_voxelize(solid, $3,
            CASE WHEN ab_closedness(solid) = 'open surface' THEN 'surface' ELSE 'centre' END, $2::text::ab_box)),
        ab_occupancy(ab_grid($3, $2::text::ab_box, 0), true))
 FROM building_object WHERE solid && $2::text::ab_box AND $8::integer IS NOT NULL)";

/// Compares, and leaves the result in the table `asbuilt_change (tile, change)`.
pub fn compare(client: &mut Client, c: &Comparison) -> Result<u64> {
    let (old, against_model) = match c.old {
        Old::Epoch(n) => (n, false),
        Old::Model => (c.new, true),
    };
    let extent = client.query_one(EXTENT, &[&old, &c.new, &against_model]).map_err(explain)?;
    let Some(extent) = extent.get::<_, Option<String>>(0) else { bail!("the scans hold no returns") };
    let tiles = client.query(TILES, &[&extent, &c.tile]).map_err(explain)?;
    let bar = progress("comparing", "tiles");
    bar.set_length(tiles.len() as u64);
    // The table of patches is small beside the beams it stands for: PostgreSQL would not take a second process for it.
    client
        .batch_execute(
            "SET min_parallel_table_scan_size = 0;
             CREATE TEMPORARY TABLE asbuilt_change (tile ab_box NOT NULL, change ab_change NOT NULL)",
        )
        .map_err(explain)?;
    let older = if against_model { OF_MODEL.to_owned() } else { of_epoch(8) };
    let sql = format!(
        "SELECT ab_box_send(t.tile), ab_change_send(ab_clip(ab_change(t.old, t.new, $4, $5), t.tile))
         FROM (SELECT $1::text::ab_box AS tile, {older} AS old, {} AS new
               FROM (SELECT ab_grid($3, $2::text::ab_box, $6, $7, $10) AS grid) a) t",
        of_epoch(9)
    );
    let statement = client.prepare(&sql).map_err(explain)?;
    for row in tiles {
        let tile: String = row.get(0);
        let wide = Aabb::from_text(&tile)?.expanded(HALO * c.voxel).to_text();
        let parameters: [&(dyn ToSql + Sync); 10] =
            [&tile, &wide, &c.voxel, &c.threshold, &c.tolerance, &c.margin, &c.no_return_range, &old, &c.new, &c.exact];
        let row = client.query_one(&statement, &parameters).map_err(explain)?;
        let mut tx = client.transaction().map_err(explain)?;
        store(&mut tx, row.get(0), row.get(1))?;
        tx.commit().map_err(explain)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    client
        .batch_execute("CREATE INDEX ON asbuilt_change USING gist (change); ANALYZE asbuilt_change")
        .map_err(explain)?;
    Ok(bar.length().unwrap_or(0))
}

fn store(tx: &mut Transaction, tile: &[u8], change: &[u8]) -> Result<()> {
    let mut copy = BinaryCopy::start(tx, "asbuilt_change", &["tile", "change"])?;
    copy.row(&[Some(tile), Some(change)])?;
    copy.finish().map(|_| ())
}
