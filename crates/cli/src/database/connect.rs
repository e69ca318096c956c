//! Reaching the database as psql would.

use std::env;

use anyhow::{Context, Result, anyhow, bail};
use postgres::config::SslMode;
use postgres::{Client, Config, NoTls};

/// Which database; without `--db`, the one that psql would reach.
#[derive(clap::Args, Debug)]
pub struct DatabaseArgs {
    /// Connection URL or string, e.g. postgresql://user@host/name; what it leaves open comes from PGHOST, PGPORT,
    /// PGUSER, PGPASSWORD and PGDATABASE
    #[arg(long = "db", value_name = "URL")]
    url: Option<String>,
}

impl DatabaseArgs {
    /// Connects; server notices are printed to standard error.
    pub fn connect(&self) -> Result<Client> {
        let mut config = config(self.url.as_deref().unwrap_or(""))?;
        config.notice_callback(|notice| {
            if notice.severity() != "NOTICE" {
                eprintln!("{}: {}", notice.severity(), notice.message());
            }
        });
        let place = format!("{:?} as {}", config.get_hosts(), config.get_user().unwrap_or("the system's user"));
        config.connect(NoTls).map_err(explain).with_context(|| {
            format!("cannot connect to PostgreSQL at {place}; set PGHOST, PGUSER, PGDATABASE or give --db URL")
        })
    }
}

fn config(text: &str) -> Result<Config> {
    let var = |name: &str| env::var(name).ok().filter(|v| !v.is_empty());
    let mut c: Config =
        text.parse().map_err(explain).with_context(|| format!("--db \"{text}\" is no connection URL"))?;
    if c.get_hosts().is_empty() && c.get_hostaddrs().is_empty() {
        c.host(var("PGHOST").as_deref().unwrap_or("/var/run/postgresql"));
    }
    if c.get_ports().is_empty()
        && let Some(port) = var("PGPORT")
    {
        c.port(port.parse().with_context(|| format!("PGPORT \"{port}\" is no port number"))?);
    }
    if c.get_user().is_none()
        && let Some(user) = var("PGUSER")
    {
        c.user(&user);
    }
    if c.get_password().is_none()
        && let Some(password) = var("PGPASSWORD")
    {
        c.password(password);
    }
    if c.get_dbname().is_none()
        && let Some(name) = var("PGDATABASE")
    {
        c.dbname(&name);
    }
    if let (false, Some(mode)) = (text.contains("sslmode"), var("PGSSLMODE")) {
        match mode.as_str() {
            "disable" => c.ssl_mode(SslMode::Disable),
            "prefer" | "allow" => &mut c,
            _ => {
                bail!("PGSSLMODE={mode} asks for TLS, which this program cannot do yet; tunnel the connection (ssh -L)")
            }
        };
    }
    Ok(c)
}

/// A PostgreSQL error with its message, detail and hint, which its own `Display` leaves out.
pub fn explain(error: postgres::Error) -> anyhow::Error {
    let Some(db) = error.as_db_error() else {
        return anyhow!(error);
    };
    let mut text = format!("{} (SQLSTATE {})", db.message(), db.code().code());
    for (name, part) in [("detail", db.detail()), ("hint", db.hint())] {
        if let Some(part) = part {
            text += &format!("\n  {name}: {part}");
        }
    }
    anyhow!(text)
}
