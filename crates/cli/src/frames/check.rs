//! Asks the database whether model and scans lie on each other, and says what is likely wrong.

use std::collections::BTreeMap;

use anyhow::Result;
use asbuilt_core::geometry::Aabb;
use postgres::Row;

use super::diagnosis::{StationBoxes, diagnoses};
use crate::database::connect::{Database, explain};
use crate::output::say;

/// So many patches are looked at, evenly.
const PATCHES: i64 = 4000;

const OBJECTS: &str = "
SELECT @ext.ab_min(b), @ext.ab_max(b) FROM (SELECT @ext.ab_box(solid) AS b FROM @building_object WHERE solid IS NOT NULL) o";

const SCANS: &str = "
WITH numbered AS (
  SELECT station_id, patch, pg_catalog.row_number() OVER (ORDER BY station_id) AS n, pg_catalog.count(*) OVER () AS of
  FROM   @scan WHERE epoch = $1::int4)
SELECT p.station_id, t.name, @ext.ab_min(p.b), @ext.ab_max(p.b)
FROM  (SELECT station_id, @ext.ab_point_box(patch) AS b FROM numbered
       WHERE  n % greatest(of / $2::int8, 1::int8) = 0::int8) p
JOIN   @station t ON t.id = p.station_id
WHERE  p.b IS NOT NULL";

/// Warns about an epoch whose scans are in another frame, or unit, than the model.
pub fn warn(db: &mut Database, epoch: i32) -> Result<()> {
    let objects = db.client.query(&db.names.sql(OBJECTS), &[]).map_err(explain)?;
    let objects: Vec<Aabb> = objects.iter().filter_map(|row| aabb(row, 0)).collect();
    let mut stations: BTreeMap<i64, StationBoxes> = BTreeMap::new();
    for row in db.client.query(&db.names.sql(SCANS), &[&epoch, &PATCHES]).map_err(explain)? {
        let station = stations.entry(row.get(0));
        let station = station.or_insert_with(|| StationBoxes { name: row.get(1), patches: Vec::new() });
        station.patches.extend(aabb(&row, 2));
    }
    let stations: Vec<StationBoxes> = stations.into_values().collect();
    for said in diagnoses(&objects, &stations) {
        say!("warning: epoch {epoch}: {said}");
    }
    Ok(())
}

fn aabb(row: &Row, first: usize) -> Option<Aabb> {
    let corner = |i: usize| row.get::<_, Option<Vec<f64>>>(i).and_then(|c| <[f64; 3]>::try_from(c).ok());
    Some(Aabb { min: corner(first)?, max: corner(first + 1)? })
}
