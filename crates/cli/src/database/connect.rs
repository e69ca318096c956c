//! Reaching the database as psql would.

use anyhow::{Context, Result, anyhow, bail};
use postgres::{Client, NoTls};

use super::config::config;
use super::names::Names;
use crate::output::{Noted, say};

/// Which database; without `--db`, the one that psql would reach.
#[derive(clap::Args, Debug)]
pub struct DatabaseArgs {
    /// Connection URL or string, e.g. postgresql://user@host/name; what it leaves open comes from PGHOST, PGPORT,
    /// PGUSER, PGPASSWORD (or ~/.pgpass), PGDATABASE and PGOPTIONS
    #[arg(long = "db", value_name = "URL")]
    url: Option<String>,
    /// Schema of the tables building_object, station and scan [default: where the search path finds one of them, else
    /// the first schema on it]
    #[arg(long, value_name = "NAME")]
    schema: Option<String>,
}

/// A connection, with the names that its statements use.
pub struct Database {
    pub client: Client,
    pub names: Names,
    /// The schema in which the user's own statements would create something.
    pub current_schema: Option<String>,
    /// The user's search path, as it is set, for conditions of their own.
    pub user_path: String,
}

impl DatabaseArgs {
    /// Connects; server warnings are printed to standard error. From here on the session's search path is our own.
    pub fn connect(&self) -> Result<Database> {
        let mut config = config(self.url.as_deref().unwrap_or(""))?;
        config.notice_callback(|notice| {
            if notice.severity() != "NOTICE" {
                say!("{}: {}", notice.severity(), notice.message());
            }
        });
        let place = format!("{:?} as {}", config.get_hosts(), config.get_user().unwrap_or("the system's user"));
        let mut client = config.connect(NoTls).map_err(explain).with_context(|| {
            format!("cannot connect to PostgreSQL at {place}; set PGHOST, PGUSER, PGDATABASE or give --db URL")
        })?;
        let (user_path, schemas) = user_schemas(&mut client)?;
        // A server that finds its client gone (Ctrl-C) ends the query; where it cannot look, it is not asked to.
        let _ = client.batch_execute("SET client_connection_check_interval = '500ms'");
        let names = self.names(&mut client, &schemas)?;
        let mut database = Database { client, names, current_schema: schemas.into_iter().next(), user_path };
        database.set_path()?;
        Ok(database)
    }

    fn names(&self, client: &mut Client, schemas: &[String]) -> Result<Names> {
        let extension = extension(client)?;
        let home = match &self.schema {
            Some(name) => name.clone(),
            None => home(client, schemas)?.or_else(|| schemas.first().cloned()).ok_or_else(|| {
                anyhow!("no schema of the search path exists or may be used; give one for the tables: --schema NAME")
            })?,
        };
        let there = "SELECT pg_catalog.count(*) FROM pg_catalog.pg_namespace WHERE nspname = $1::text::name";
        if client.query_one(there, &[&home]).map_err(explain)?.get::<_, i64>(0) == 0 {
            bail!(
                "there is no schema {home}; an owner of the database can make it: CREATE SCHEMA {}",
                super::quoted(&home)
            );
        }
        Ok(Names { extension, home })
    }
}

impl Database {
    /// Sets the search path of our own statements.
    pub fn set_path(&mut self) -> Result<()> {
        set_path(&mut self.client, &self.names.path())
    }

    /// A statement with full names, see [`Names::sql`].
    pub fn sql(&self, template: &str) -> String {
        self.names.sql(template)
    }
}

pub fn set_path(client: &mut impl postgres::GenericClient, path: &str) -> Result<()> {
    let set = "SELECT pg_catalog.set_config('search_path'::pg_catalog.text, $1::pg_catalog.text, false)";
    client.execute(set, &[&path]).map(drop).map_err(explain)
}

/// The user's search path, and the schemas on it in which tables can be, read before the path is replaced by the program's.
fn user_schemas(client: &mut Client) -> Result<(String, Vec<String>)> {
    let read = "SELECT pg_catalog.current_schemas(false), pg_catalog.current_setting('search_path')";
    let row = client.query_one(read, &[]).map_err(explain)?;
    set_path(client, "pg_catalog, pg_temp")?;
    let mut schemas: Vec<String> = row.get(0);
    schemas.retain(|s| !s.starts_with("pg_") && s != "information_schema");
    Ok((row.get(1), schemas))
}

/// The extension's schema.
fn extension(client: &mut Client) -> Result<Option<String>> {
    let sql = "SELECT n.nspname, x.extversion FROM pg_catalog.pg_extension x
        JOIN pg_catalog.pg_namespace n ON n.oid = x.extnamespace WHERE x.extname = 'asbuilt'::name";
    let Some(row) = client.query_opt(sql, &[]).map_err(explain)? else { return Ok(None) };
    let (version, own): (String, _) = (row.get(1), env!("CARGO_PKG_VERSION"));
    if version != own {
        say!(
            "warning: the extension in this database is {version}, the program {own}; its owner can: ALTER EXTENSION \
             asbuilt UPDATE"
        );
    }
    Ok(Some(row.get(0)))
}

/// The first of these schemas that holds something under the name of one of the tables.
fn home(client: &mut Client, schemas: &[String]) -> Result<Option<String>> {
    let sql = "SELECT n.nspname FROM pg_catalog.pg_class c JOIN pg_catalog.pg_namespace n ON n.oid = c.relnamespace
        WHERE c.relname IN ('building_object'::name, 'station'::name, 'scan'::name)";
    let holding: Vec<String> = client.query(sql, &[]).map_err(explain)?.iter().map(|r| r.get(0)).collect();
    Ok(schemas.iter().find(|s| holding.contains(s)).cloned())
}

/// A PostgreSQL error with its message, detail and hint, which its own `Display` leaves out.
pub fn explain(error: postgres::Error) -> anyhow::Error {
    let Some(db) = error.as_db_error() else {
        return anyhow!(error);
    };
    let denied = *db.code() == postgres::error::SqlState::INSUFFICIENT_PRIVILEGE;
    let grants = denied.then_some(
        "to verify takes SELECT on building_object, station and scan, to load INSERT and DELETE too; their owner can \
         GRANT them",
    );
    let notes = [("detail", db.detail()), ("hint", db.hint().or(grants))];
    let notes = notes.into_iter().filter_map(|(name, part)| Some(format!("{name}: {}", part?))).collect();
    anyhow!(Noted { message: format!("{} (SQLSTATE {})", db.message(), db.code().code()), notes })
}
