//! The tables of the tour.

use anyhow::Result;
use postgres::Transaction;

use super::connect::explain;

/// What the loader fills and the verdict reads. Loading a file again replaces what it had loaded.
const TABLES: &str = "
CREATE EXTENSION IF NOT EXISTS asbuilt;

CREATE TABLE IF NOT EXISTS building_object (
    id         bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    global_id  text NOT NULL,
    ifc_class  text NOT NULL,
    name       text NOT NULL,
    storey     text,
    loa        ab_loa NOT NULL,
    solid      ab_solid,
    properties jsonb NOT NULL,
    source     text NOT NULL,
    UNIQUE (source, global_id)
);
CREATE INDEX IF NOT EXISTS building_object_solid_idx ON building_object USING gist (solid);
COMMENT ON TABLE building_object IS 'Objects of the building model; solid is NULL where the geometry could not be meshed';

CREATE TABLE IF NOT EXISTS station (
    id     bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    epoch  integer NOT NULL,
    name   text NOT NULL,
    pose   float8[],
    sensor text,
    source text NOT NULL
);
CREATE INDEX IF NOT EXISTS station_epoch_idx ON station (epoch);
COMMENT ON TABLE station IS 'Scanner positions: pose is x, y, z in metres and the unit quaternion w, x, y, z; NULL for points without origin';

CREATE TABLE IF NOT EXISTS scan (
    station_id bigint NOT NULL REFERENCES station ON DELETE CASCADE,
    epoch      integer NOT NULL,
    patch      ab_scan NOT NULL
);
CREATE INDEX IF NOT EXISTS scan_patch_idx ON scan USING gist (patch);
CREATE INDEX IF NOT EXISTS scan_station_idx ON scan (station_id);
COMMENT ON TABLE scan IS 'Patches of at most 4096 neighbouring beams of a station';
";

/// Makes extension and tables where they are missing.
pub fn make(tx: &mut Transaction) -> Result<()> {
    // Loaders that start together would race for the catalogue.
    tx.execute("SELECT pg_advisory_xact_lock(hashtext('asbuilt tables'))", &[]).map_err(explain)?;
    tx.batch_execute(TABLES).map_err(explain)
}
