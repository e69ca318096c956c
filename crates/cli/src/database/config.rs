//! Connection settings as psql takes them from the environment.

use std::env;

use anyhow::{Context, Result, anyhow, bail};
use postgres::Config;
use postgres::config::{Host, SslMode};

use super::pgpass;

/// A variable that is set and not empty.
pub fn var(name: &str) -> Option<String> {
    env::var(name).ok().filter(|v| !v.is_empty())
}

/// Neither the text nor what the parser says about it is shown: both may contain a password or parts of one.
const NO_URL: &str = "--db is no connection URL (its text is not shown, for a password may be in it); write \
    postgresql://user@host/name or \"host=… port=… user=… dbname=…\", give the password in PGPASSWORD or ~/.pgpass, \
    or write its signs @ : / ? # % as %40 %3A %2F %3F %23 %25";

fn parse(text: &str) -> Result<Config> {
    let c: Config = text.parse().map_err(|_| anyhow!(NO_URL))?;
    // An unescaped @ in a password puts its end into the names of host and database, which errors show.
    let odd = |name: &str| text.contains("://") && name.contains('@');
    if c.get_hosts().iter().any(|h| matches!(h, Host::Tcp(name) if odd(name))) || c.get_dbname().is_some_and(odd) {
        bail!(NO_URL);
    }
    Ok(c)
}

/// Connection settings from `--db` and, for what it leaves open, the environment.
pub fn config(text: &str) -> Result<Config> {
    let mut c = parse(text)?;
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
    if c.get_dbname().is_none()
        && let Some(name) = var("PGDATABASE")
    {
        c.dbname(&name);
    }
    if c.get_options().is_none()
        && let Some(options) = var("PGOPTIONS")
    {
        c.options(&options);
    }
    if c.get_password().is_none()
        && let Some(password) = var("PGPASSWORD").or_else(|| pgpass::password(&c))
    {
        c.password(password);
    }
    if let Some(service) = var("PGSERVICE").filter(|_| text.is_empty()) {
        bail!("PGSERVICE={service}: this program does not read service files; give --db URL instead");
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
