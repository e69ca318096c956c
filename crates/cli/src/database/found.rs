//! What exists under the names of the program's tables, and whether it may be used.

use anyhow::{Result, bail};
use postgres::{GenericClient, Row};

use super::connect::explain;
use super::ddl::{LAYOUT, LAYOUT_TABLE, ORIGIN_COLUMNS, TOUR, TableOf};
use super::names::Names;

/// The tables that exist.
pub struct Found {
    /// The model and scan tables in their order: owner, and whether the current user may act for the owner.
    pub tour: [Option<Owner>; 3],
    pub layout_table: Option<Owner>,
    /// The layout that each of them has.
    pub layouts: [Option<i32>; 3],
    /// The layout that the tables have; `None` where one of them is missing.
    pub layout: Option<i32>,
    /// The layout that is written down.
    pub written: Option<i32>,
}

#[derive(Debug, Clone)]
pub struct Owner {
    pub name: String,
    /// The owner is the current user, or one for whom the current user may act.
    pub is_ours: bool,
}

impl Found {
    pub fn is_complete(&self) -> bool {
        self.tour.iter().all(Option::is_some)
    }
}

/// A relation under one of the program's names. Trusted are the current user, the roles it is a member of (which
/// `pg_has_role` does not tell for a superuser), the owner of the database and superusers.
const RELATION: &str = "
WITH RECURSIVE mine(role) AS (
  SELECT r.oid FROM pg_catalog.pg_roles r WHERE r.rolname = current_user
  UNION SELECT m.roleid FROM mine JOIN pg_catalog.pg_auth_members m ON m.member = mine.role),
trusted(role) AS (
  SELECT role FROM mine
  UNION SELECT d.datdba FROM pg_catalog.pg_database d WHERE d.datname = pg_catalog.current_database()
  UNION SELECT r.oid FROM pg_catalog.pg_roles r WHERE r.rolsuper OR r.rolname = 'pg_database_owner'::name)
SELECT c.oid, c.relkind::text, pg_catalog.pg_get_userbyid(c.relowner), c.relowner IN (SELECT role FROM trusted),
       pg_catalog.pg_has_role(c.relowner, 'MEMBER'::text),
       (SELECT f.proname FROM pg_catalog.pg_trigger t JOIN pg_catalog.pg_proc f ON f.oid = t.tgfoid
        WHERE t.tgrelid = c.oid AND NOT t.tgisinternal AND f.proowner NOT IN (SELECT role FROM trusted) LIMIT 1::int8),
       current_user
FROM   pg_catalog.pg_class c JOIN pg_catalog.pg_namespace n ON n.oid = c.relnamespace
WHERE  n.nspname = $1::text::name AND c.relname = $2::text::name";

/// Its columns with their types; of the extension's types with the schema too.
const COLUMNS: &str = "
SELECT a.attname, t.typname, n.nspname,
       EXISTS (SELECT FROM pg_catalog.pg_index i WHERE i.indrelid = a.attrelid AND i.indisprimary AND i.indnkeyatts = 1::int2
               AND i.indkey[0] = a.attnum)
FROM   pg_catalog.pg_attribute a JOIN pg_catalog.pg_type t ON t.oid = a.atttypid
JOIN   pg_catalog.pg_namespace n ON n.oid = t.typnamespace
WHERE  a.attrelid = $1::oid AND a.attnum > 0::int2 AND NOT a.attisdropped";

const WAY_OUT: &str = "keep the tables of asbuilt in a schema of their own: CREATE SCHEMA name, and give --schema name";

/// Looks, and refuses what is not the program's.
pub fn look(client: &mut impl GenericClient, names: &Names) -> Result<Found> {
    let (mut tour, mut layouts) = ([None, None, None], [None; 3]);
    for (i, table) in TOUR.iter().enumerate() {
        let Some((owner, columns)) = relation(client, names, table)? else { continue };
        tour[i] = Some(owner);
        layouts[i] = Some(match table.name {
            "scan" if !is_key(names, &columns)? => 1,
            "station" if !tells_origin(names, &columns)? => 2,
            _ => LAYOUT,
        });
    }
    let layout_table = relation(client, names, &LAYOUT_TABLE)?.map(|(owner, _)| owner);
    let written = match layout_table {
        Some(_) => {
            let row = client.query_opt(&names.sql("SELECT layout FROM @asbuilt_layout"), &[]).map_err(explain)?;
            row.map(|r| r.get(0))
        }
        None => None,
    };
    // The oldest of them; `None` is less than any.
    let oldest = layouts.iter().copied().min().flatten();
    let layout = oldest.map(|oldest| if oldest == LAYOUT { written.unwrap_or(oldest).max(oldest) } else { oldest });
    Ok(Found { tour, layouts, layout_table, layout, written })
}

/// Owner and columns of a table; `None` where nothing has its name.
fn relation(client: &mut impl GenericClient, names: &Names, table: &TableOf) -> Result<Option<(Owner, Vec<Row>)>> {
    let full = names.table(table.name);
    let Some(row) = client.query_opt(RELATION, &[&names.home, &table.name]).map_err(explain)? else { return Ok(None) };
    let (owner, user): (String, String) = (row.get(2), row.get(6));
    if !row.get::<_, bool>(3) {
        bail!(
            "{full} belongs to {owner}, who is neither {user}, nor a role that {user} is a member of, nor the owner of the \
             database, nor a superuser: it is not used, for it may run code of {owner}; {WAY_OUT}"
        );
    }
    if !["r", "p"].contains(&row.get(1)) {
        bail!("{full} is no table (but a view, a foreign table or the like): it is not used; {WAY_OUT}");
    }
    if let Some(function) = row.get::<_, Option<String>>(5) {
        bail!("{full} has a trigger whose function {function} belongs to somebody else: it is not used; {WAY_OUT}");
    }
    let columns = client.query(COLUMNS, &[&row.get::<_, u32>(0)]).map_err(explain)?;
    for (name, kind) in table.columns {
        let schema = if kind.starts_with("ab_") { names.extension.as_deref() } else { Some("pg_catalog") };
        let is = |c: &&Row| c.get::<_, &str>(0) == *name;
        let found = columns.iter().find(is);
        if !found.is_some_and(|c| c.get::<_, &str>(1) == *kind && Some(c.get::<_, &str>(2)) == schema) {
            let other = found.map_or("none".to_owned(), |c| format!("one of type {}", c.get::<_, &str>(1)));
            bail!("{full} is no table of asbuilt: it has no column {name} of type {kind} (but {other}); {WAY_OUT}");
        }
    }
    Ok(Some((Owner { name: owner, is_ours: row.get(4) }, columns)))
}

/// Whether the scan table has its key; a column of that name that is no key is an error.
fn is_key(names: &Names, columns: &[Row]) -> Result<bool> {
    let Some(id) = columns.iter().find(|c| c.get::<_, &str>(0) == "id") else { return Ok(false) };
    if id.get::<_, &str>(1) != "int8" || !id.get::<_, bool>(3) {
        bail!(
            "{} has a column id that is not its primary key of type bigint, where layout 2 wants one; rename it: ALTER \
             TABLE {0} RENAME COLUMN id TO other",
            names.table("scan")
        );
    }
    Ok(true)
}

/// Whether the station table tells how origins are known; columns of these names and other types are an error.
fn tells_origin(names: &Names, columns: &[Row]) -> Result<bool> {
    let mut has_all = true;
    for (name, kind) in ORIGIN_COLUMNS {
        match columns.iter().find(|c| c.get::<_, &str>(0) == name).map(|c| c.get::<_, &str>(1)) {
            None => has_all = false,
            Some(found) if found != kind => bail!(
                "{} has a column {name} of type {found}, where layout 3 wants one of type {kind}; rename it: ALTER TABLE {0} \
                 RENAME COLUMN {name} TO other",
                names.table("station")
            ),
            Some(_) => {}
        }
    }
    Ok(has_all)
}
