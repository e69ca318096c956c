//! The password file: one `host:port:database:user:password` per line, `*` matches anything.

use std::path::PathBuf;

use postgres::Config;
use postgres::config::Host;

use super::config::var;
use crate::output::say;

/// The password for this connection from PGPASSFILE or ~/.pgpass; like libpq, not from a file that others may read.
pub fn password(config: &Config) -> Option<String> {
    let path = var("PGPASSFILE").or_else(|| var("HOME").map(|h| format!("{h}/.pgpass"))).map(PathBuf::from)?;
    let text = std::fs::read_to_string(&path).ok()?;
    if open_to_others(&path) {
        say!("warning: {} is open to others and therefore not read; chmod 0600", path.display());
        return None;
    }
    let host = match config.get_hosts().first() {
        Some(Host::Tcp(name)) => name.clone(),
        _ => "localhost".into(),
    };
    let port = config.get_ports().first().copied().unwrap_or(5432).to_string();
    let user = config.get_user().map(ToOwned::to_owned).or_else(|| var("USER"))?;
    let database = config.get_dbname().unwrap_or(&user);
    find(&text, [&host, &port, database, &user])
}

fn find(text: &str, wanted: [&str; 4]) -> Option<String> {
    text.lines().filter(|l| !l.starts_with('#')).find_map(|line| {
        let mut fields = fields(line);
        let password = (fields.len() == 5).then(|| fields.pop())??;
        fields.iter().zip(wanted).all(|(f, w)| f == "*" || f == w).then_some(password)
    })
}

/// Parts between colons; a backslash takes the next character as it is.
fn fields(line: &str) -> Vec<String> {
    let mut out = vec![String::new()];
    let mut characters = line.chars();
    while let Some(c) = characters.next() {
        match c {
            ':' if out.len() < 5 => out.push(String::new()),
            '\\' => out.iter_mut().next_back().into_iter().for_each(|f| f.extend(characters.next())),
            c => out.iter_mut().next_back().into_iter().for_each(|f| f.push(c)),
        }
    }
    out
}

#[cfg(unix)]
fn open_to_others(path: &std::path::Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    std::fs::metadata(path).is_ok_and(|m| m.permissions().mode() & 0o077 != 0)
}

#[cfg(not(unix))]
fn open_to_others(_: &std::path::Path) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_matching_line_wins() {
        let text =
            "# a comment\nother:5432:*:me:no\nlocalhost:5432:db\\:1:me:a\\\\b:c\n*:*:*:me:fallback\nshort:line\n";
        assert_eq!(find(text, ["localhost", "5432", "db:1", "me"]).as_deref(), Some("a\\b:c"));
        assert_eq!(find(text, ["elsewhere", "1", "db", "me"]).as_deref(), Some("fallback"));
        assert_eq!(find(text, ["elsewhere", "1", "db", "you"]), None);
    }
}
