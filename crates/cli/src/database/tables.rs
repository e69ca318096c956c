//! The tables of the tour.

use anyhow::{Result, bail};
use postgres::{Client, GenericClient, Transaction};

use super::connect::explain;

/// What the loader fills and the verdict reads, each made where it is missing.
const TABLES: [(&str, &str); 3] = [
    (
        "building_object",
        "CREATE TABLE building_object (
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
        CREATE INDEX building_object_solid_idx ON building_object USING gist (solid);
        COMMENT ON TABLE building_object IS 'Objects of the building model; solid is NULL where the geometry could not be meshed';",
    ),
    (
        "station",
        "CREATE TABLE station (
            id     bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
            epoch  integer NOT NULL,
            name   text NOT NULL,
            pose   ab_pose,
            sensor text,
            source text NOT NULL
        );
        CREATE INDEX station_epoch_idx ON station (epoch);
        COMMENT ON TABLE station IS 'Scanner positions: pose is the transform from scanner to world, as far as the file tells it; NULL for points without origin';",
    ),
    (
        "scan",
        "CREATE TABLE scan (
            station_id bigint NOT NULL REFERENCES station ON DELETE CASCADE,
            epoch      integer NOT NULL,
            patch      ab_scan NOT NULL
        );
        CREATE INDEX scan_patch_idx ON scan USING gist (patch);
        CREATE INDEX scan_station_idx ON scan (station_id);
        COMMENT ON TABLE scan IS 'Patches of at most 4096 neighbouring beams of a station';",
    ),
];

/// Makes extension and tables where they are missing. Where they are there, nothing is locked and no right to make
/// tables is asked for.
pub fn make(client: &mut Client) -> Result<()> {
    if missing(client)?.is_empty() && extension_schema(client)?.is_some() {
        return check_search_path(client);
    }
    let mut tx = client.transaction().map_err(explain)?;
    // Loaders that start together would race for the catalogue.
    tx.execute("SELECT pg_advisory_xact_lock(hashtext('asbuilt tables'))", &[]).map_err(explain)?;
    tx.batch_execute("CREATE EXTENSION IF NOT EXISTS asbuilt").map_err(explain)?;
    check_search_path(&mut tx)?;
    for (_, ddl) in missing(&mut tx)? {
        tx.batch_execute(ddl).map_err(explain)?;
    }
    tx.commit().map_err(explain)
}

fn missing(client: &mut impl GenericClient) -> Result<Vec<(&'static str, &'static str)>> {
    let mut out = Vec::new();
    for table in TABLES {
        let row = client.query_one("SELECT to_regclass($1) IS NULL", &[&table.0]).map_err(explain)?;
        if row.get(0) {
            out.push(table);
        }
    }
    Ok(out)
}

fn extension_schema(client: &mut impl GenericClient) -> Result<Option<String>> {
    let schema = "SELECT extnamespace::regnamespace::text FROM pg_extension WHERE extname = 'asbuilt'";
    Ok(client.query_opt(schema, &[]).map_err(explain)?.map(|r| r.get(0)))
}

/// The extension may live in a schema that the session does not look into.
pub fn check_search_path(client: &mut impl GenericClient) -> Result<()> {
    let Some(schema) = extension_schema(client)? else {
        bail!("this database has no extension asbuilt; an owner of it can: CREATE EXTENSION asbuilt");
    };
    if client.query_one("SELECT to_regtype('ab_loa') IS NULL", &[]).map_err(explain)?.get(0) {
        bail!(
            "the extension asbuilt lies in schema {schema}, which is not on the search path; \
             set it, e.g. PGOPTIONS='-c search_path=public,{schema}'"
        );
    }
    Ok(())
}

/// Holds other loaders of the same file and epoch back until this transaction ends; both would replace its rows.
pub fn lock_source(tx: &mut Transaction, source: &str, epoch: i32) -> Result<()> {
    let lock = "SELECT pg_advisory_xact_lock(hashtext('asbuilt source'), hashtext($1 || ' ' || $2::int))";
    tx.execute(lock, &[&source, &epoch]).map_err(explain)?;
    Ok(())
}

/// Statistics for the planner, of the tables that the user may analyse.
pub fn analyse(client: &mut Client) -> Result<()> {
    let own = "SELECT oid::regclass::text FROM pg_class
        WHERE oid IN (to_regclass('building_object'), to_regclass('scan')) AND pg_has_role(relowner, 'USAGE')";
    for row in client.query(own, &[]).map_err(explain)? {
        client.batch_execute(&format!("ANALYZE {}", row.get::<_, String>(0))).map_err(explain)?;
    }
    Ok(())
}

/// Fails where nothing was ever loaded.
pub fn check_loaded(client: &mut Client) -> Result<()> {
    let there = "SELECT to_regclass('building_object') IS NOT NULL AND to_regclass('scan') IS NOT NULL";
    if !client.query_one(there, &[]).map_err(explain)?.get::<_, bool>(0) {
        bail!("this database has no tables building_object and scan; fill them: asbuilt load MODEL.ifc SCAN.e57");
    }
    Ok(())
}

/// Fails where an epoch has no scans.
pub fn check_epoch(client: &mut Client, epoch: i32) -> Result<()> {
    let scans = "SELECT EXISTS (SELECT FROM scan WHERE epoch = $1), (SELECT string_agg(DISTINCT epoch::text, ', ') FROM station)";
    let row = client.query_one(scans, &[&epoch]).map_err(explain)?;
    if !row.get::<_, bool>(0) {
        let known: Option<String> = row.get(1);
        bail!("no scan of epoch {epoch}; loaded are epochs: {}", known.unwrap_or_else(|| "none".into()));
    }
    Ok(())
}
