//! The tables in use: what must exist, locks and statistics.

use anyhow::{Result, bail};
use postgres::Transaction;

use super::connect::{Database, explain};
use super::found::look;
use super::layout::refuse_newer;

/// Fails where the extension is not installed or nothing was ever loaded.
pub fn check_loaded(db: &mut Database) -> Result<()> {
    if db.names.extension.is_none() {
        bail!("this database has no extension asbuilt; an owner of it can: CREATE EXTENSION asbuilt");
    }
    let found = look(&mut db.client, &db.names)?;
    refuse_newer(&found)?;
    if !found.is_complete() {
        bail!(
            "schema {} has no tables building_object, station and scan; fill them: asbuilt load MODEL.ifc SCAN.e57, or \
             name their schema: --schema NAME",
            db.names.home
        );
    }
    Ok(())
}

/// Fails where an epoch has no scans.
pub fn check_epoch(db: &mut Database, epoch: i32) -> Result<()> {
    let scans = db.sql(
        "SELECT EXISTS (SELECT FROM @scan WHERE epoch = $1::int4),
                (SELECT pg_catalog.string_agg(DISTINCT epoch::text, ', '::text) FROM @station)",
    );
    let row = db.client.query_one(&scans, &[&epoch]).map_err(explain)?;
    if !row.get::<_, bool>(0) {
        let known: Option<String> = row.get(1);
        bail!("no scan of epoch {epoch}; loaded are epochs: {}", known.unwrap_or_else(|| "none".into()));
    }
    Ok(())
}

/// Holds back other loaders of the same file and epoch until this transaction ends; otherwise both would replace its
/// rows.
pub fn lock_source(tx: &mut Transaction, source: &str, epoch: i32) -> Result<()> {
    let lock = "SELECT pg_catalog.pg_advisory_xact_lock(pg_catalog.hashtext('asbuilt source'::text),
        pg_catalog.hashtext($1::text))";
    tx.execute(lock, &[&format!("{source} {epoch}")]).map_err(explain)?;
    Ok(())
}

/// Collects statistics for the planner, for the tables that the user may analyse.
pub fn analyse(db: &mut Database) -> Result<()> {
    let own = "SELECT c.relname FROM pg_catalog.pg_class c JOIN pg_catalog.pg_namespace n ON n.oid = c.relnamespace
        WHERE n.nspname = $1::text::name AND c.relname IN ('building_object'::name, 'scan'::name)
        AND pg_catalog.pg_has_role(c.relowner, 'USAGE'::text)";
    for row in db.client.query(own, &[&db.names.home]).map_err(explain)? {
        let table = db.names.table(row.get(0));
        db.client.batch_execute(&format!("ANALYZE {table}")).map_err(explain)?;
    }
    Ok(())
}
