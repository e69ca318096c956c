//! Creates the tables, and brings those of older programs up to date.

use anyhow::{Context, Result, bail};
use postgres::{IsolationLevel, Transaction};

use super::connect::{Database, explain, set_path};
use super::ddl::{LAYOUT, LAYOUT_TABLE, MIGRATIONS, Migration, TOUR};
use super::found::{Found, Owner, look};
use super::names::{Names, quoted};
use crate::output::say;

/// Creates the extension and the tables where they are missing, and brings them up to date. Where there is nothing to
/// do, nothing is locked and no right to create tables is needed.
pub fn make(db: &mut Database) -> Result<()> {
    if is_made(db)? {
        return Ok(());
    }
    // Each statement sees what those before us in the lock's queue have made.
    let tx = db.client.build_transaction().isolation_level(IsolationLevel::ReadCommitted);
    let mut tx = tx.start().map_err(explain)?;
    let (names, done) = make_within(&mut tx, &db.names, db.current_schema.as_deref())?;
    tx.commit().map_err(explain)?;
    done.iter().for_each(|d| say!("asbuilt: tables in schema {}: {d}", names.home));
    db.names = names;
    Ok(())
}

/// Whether the extension and the tables exist and are up to date.
pub fn is_made(db: &mut Database) -> Result<bool> {
    Ok(db.names.extension.is_some() && is_current(&look(&mut db.client, &db.names)?)?)
}

/// The same within a transaction: returns the names to use from then on, and what was done.
pub fn make_within(tx: &mut Transaction, names: &Names, current: Option<&str>) -> Result<(Names, Vec<String>)> {
    let lock = "SELECT pg_catalog.pg_advisory_xact_lock(pg_catalog.hashtext('asbuilt tables'::text)::int8)";
    tx.execute(lock, &[]).map_err(explain)?;
    let names = with_extension(tx, names, current)?;
    let found = look(tx, &names)?;
    let mut done = Vec::new();
    if !is_current(&found)? {
        update(tx, &names, &found, &mut done)?;
    }
    Ok((names, done))
}

/// Whether there is nothing to do. Where the number of the layout is not recorded, and the user may not record it, the
/// tables themselves tell it.
fn is_current(found: &Found) -> Result<bool> {
    refuse_newer(found)?;
    let may_write = found.tour.iter().flatten().all(|o| o.is_ours);
    Ok(found.layout == Some(LAYOUT) && (found.written == Some(LAYOUT) || !may_write))
}

/// Fails where a newer program has changed the tables.
pub fn refuse_newer(found: &Found) -> Result<()> {
    match found.written {
        Some(n) if n > LAYOUT => {
            bail!("the tables have layout {n}, of a newer asbuilt; this one knows layouts up to {LAYOUT}: update it")
        }
        _ => Ok(()),
    }
}

/// Creates the extension where the user would create something, with a search path on which others have nothing.
fn with_extension(tx: &mut Transaction, names: &Names, current: Option<&str>) -> Result<Names> {
    let sql = "SELECT n.nspname FROM pg_catalog.pg_extension x JOIN pg_catalog.pg_namespace n ON n.oid = x.extnamespace
        WHERE x.extname = 'asbuilt'::name";
    let mut schema: Option<String> = tx.query_opt(sql, &[]).map_err(explain)?.map(|r| r.get(0));
    if schema.is_none() {
        let own = current.unwrap_or(&names.home);
        tx.batch_execute(&format!("CREATE EXTENSION asbuilt SCHEMA {}", quoted(own))).map_err(explain)?;
        schema = Some(own.to_owned());
    }
    let names = Names { extension: schema, home: names.home.clone() };
    set_path(tx, &names.path())?;
    Ok(names)
}

fn update(tx: &mut Transaction, names: &Names, found: &Found, done: &mut Vec<String>) -> Result<()> {
    // Each table has its own: beside those that are missing, some may be of an older program.
    let missing: Vec<&Migration> =
        MIGRATIONS.iter().filter(|m| found.layouts[m.table].is_some_and(|layout| m.from >= layout)).collect();
    let owner_of = |m: &Migration| found.tour[m.table].as_ref();
    if let Some(Owner { name, .. }) = missing.iter().filter_map(|m| owner_of(m)).find(|o| !o.is_ours) {
        let all: Vec<String> = missing.iter().map(|m| names.sql(m.ddl)).collect();
        bail!(
            "the tables of asbuilt are of an older layout and belong to {name}, who must run asbuilt load once, or: {};",
            all.join("; ")
        );
    }
    for migration in missing {
        act_as(tx, owner_of(migration))?;
        tx.batch_execute(&names.sql(migration.ddl)).map_err(explain)?;
        done.push(format!("brought to layout {}: {}; no row was changed", migration.from + 1, migration.what));
    }
    // What is new belongs to whom the rest belongs to.
    act_as(tx, found.tour.iter().flatten().next())?;
    for (table, there) in TOUR.iter().zip(&found.tour) {
        if there.is_none() {
            tx.batch_execute(&names.sql(table.ddl)).map_err(explain)?;
        }
    }
    if found.layout_table.is_none() {
        tx.batch_execute(&names.sql(LAYOUT_TABLE.ddl)).map_err(explain)?;
    } else {
        act_as(tx, found.layout_table.as_ref())?;
    }
    let write = "DELETE FROM @asbuilt_layout; INSERT INTO @asbuilt_layout (layout) VALUES ";
    tx.batch_execute(&format!("{}({LAYOUT})", names.sql(write))).map_err(explain)
}

/// Acts as the owner where allowed, so that members of a role without inherited rights can do what the role can, and
/// what is created belongs to the role.
fn act_as(tx: &mut Transaction, owner: Option<&Owner>) -> Result<()> {
    let Some(owner) = owner.filter(|o| o.is_ours) else { return Ok(()) };
    let role = format!("SET LOCAL ROLE {}", quoted(&owner.name));
    tx.batch_execute(&role).map_err(explain).with_context(|| format!("cannot act as {}", owner.name))
}
