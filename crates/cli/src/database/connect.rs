//! Reaching the database as psql would.

use anyhow::{Context, Result, anyhow};
use postgres::{Client, NoTls};

use super::config::config;
use crate::output::say;

/// Which database; without `--db`, the one that psql would reach.
#[derive(clap::Args, Debug)]
pub struct DatabaseArgs {
    /// Connection URL or string, e.g. postgresql://user@host/name; what it leaves open comes from PGHOST, PGPORT,
    /// PGUSER, PGPASSWORD (or ~/.pgpass), PGDATABASE and PGOPTIONS
    #[arg(long = "db", value_name = "URL")]
    url: Option<String>,
}

impl DatabaseArgs {
    /// Connects; server warnings are printed to standard error.
    pub fn connect(&self) -> Result<Client> {
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
        // A server that finds its client gone (Ctrl-C) ends the query; where it cannot look, it is not asked to.
        let _ = client.batch_execute("SET client_connection_check_interval = '500ms'");
        Ok(client)
    }
}

/// A PostgreSQL error with its message, detail and hint, which its own `Display` leaves out.
pub fn explain(error: postgres::Error) -> anyhow::Error {
    let Some(db) = error.as_db_error() else {
        return anyhow!(error);
    };
    let mut text = format!("{} (SQLSTATE {})", db.message(), db.code().code());
    let denied = *db.code() == postgres::error::SqlState::INSUFFICIENT_PRIVILEGE;
    let grants = denied.then_some(
        "to verify takes SELECT on building_object, station and scan, to load INSERT and DELETE too; their owner can \
         GRANT them",
    );
    for (name, part) in [("detail", db.detail()), ("hint", db.hint().or(grants))] {
        if let Some(part) = part {
            text += &format!("\n  {name}: {part}");
        }
    }
    anyhow!(text)
}
