//! A session that survives what it asks for: crashes, hangs and errors are recorded, and it reconnects.

use std::error::Error;
use std::io::{Read, Write};
use std::time::Duration;

use postgres::types::private::BytesMut;
use postgres::types::{FromSql, IsNull, ToSql, Type, to_sql_checked};
use postgres::{Client, SimpleQueryMessage};

use crate::cluster::{Cluster, deaths};
use crate::report::{Kind, Report};
use crate::watch::Watch;

/// A value as it goes over the wire in binary, whatever its type.
#[derive(Debug, Clone)]
pub struct Raw(pub Vec<u8>);

impl ToSql for Raw {
    fn to_sql(&self, _: &Type, out: &mut BytesMut) -> Result<IsNull, Box<dyn Error + Sync + Send>> {
        out.extend_from_slice(&self.0);
        Ok(IsNull::No)
    }

    fn accepts(_: &Type) -> bool {
        true
    }

    to_sql_checked!();
}

impl<'a> FromSql<'a> for Raw {
    fn from_sql(_: &Type, raw: &'a [u8]) -> Result<Self, Box<dyn Error + Sync + Send>> {
        Ok(Self(raw.to_vec()))
    }

    fn accepts(_: &Type) -> bool {
        true
    }
}

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq)]
pub enum Fault {
    /// An error with its SQLSTATE.
    State(String),
    /// The backend is gone, or had to be ended.
    Lost,
    /// Not asked: it is known to bring the server down.
    Skipped,
}

pub type Answer<T> = Result<T, Fault>;

/// The first column of every row, in binary.
pub type Column = Vec<Option<Vec<u8>>>;

pub struct Session<'a> {
    pub cluster: &'a mut Cluster,
    pub report: &'a mut Report,
    database: String,
    setup: String,
    client: Option<Client>,
    pid: i32,
    watch: Watch,
}

impl<'a> Session<'a> {
    pub fn new(cluster: &'a mut Cluster, report: &'a mut Report, database: &str, cancel_after: Duration) -> Self {
        let mut admin = postgres::Config::new();
        admin.host_path(cluster.socket_dir()).user("postgres").dbname("postgres");
        let watch = Watch::new(admin, cancel_after);
        Self { cluster, report, database: database.into(), setup: String::new(), client: None, pid: 0, watch }
    }

    /// Statements that every connection of this session begins with.
    pub fn set_up(&mut self, sql: &str) {
        self.setup = sql.into();
        self.client = None;
    }

    /// The backend's process; connects if need be.
    pub fn pid(&mut self) -> i32 {
        if self.client.as_ref().is_none_or(Client::is_closed) {
            let mut client = self.cluster.connect(&self.database);
            self.pid = client.query_one("SELECT pg_backend_pid()", &[]).unwrap().get(0);
            client.batch_execute(&self.setup).expect("the session's settings");
            self.client = Some(client);
        }
        self.pid
    }

    /// Leaves the connection this much more address space than it has, by a limit that holds to its end.
    pub fn leave_memory(&mut self, bytes: u64) {
        let pid = self.pid();
        self.cluster.limit_addresses(pid, bytes);
    }

    /// Runs `work` under the watch and records the result. `key` names the attack: one that brought the server
    /// down is not repeated.
    fn run<T>(
        &mut self,
        key: &str,
        statement: &str,
        work: impl FnOnce(&mut Client) -> Result<T, postgres::Error>,
    ) -> Answer<T> {
        if self.report.has(Kind::Crash, key) || self.report.has(Kind::Hang, key) {
            return Err(Fault::Skipped);
        }
        let pid = self.pid();
        self.report.executed(1);
        self.watch.begin(pid);
        let result = work(self.client.as_mut().unwrap());
        let watched = self.watch.end();
        if let Some(time) = watched.cancelled
            && !watched.hung
        {
            self.report.slowest_cancel = self.report.slowest_cancel.max(time);
        }
        if watched.hung {
            self.report.finding(Kind::Hang, key, statement, "not ended 5 s after it was cancelled");
            self.recover();
            return Err(Fault::Lost);
        }
        result.map_err(|e| self.fault(key, statement, &e))
    }

    fn fault(&mut self, key: &str, statement: &str, error: &postgres::Error) -> Fault {
        let Some(db) = error.as_db_error() else {
            // The driver's own refusals (a parameter that does not fit) are no news; a closed connection is.
            let closed = self.client.as_ref().is_none_or(Client::is_closed);
            return if closed { self.crashed(key, statement) } else { Fault::State(format!("driver: {error}")) };
        };
        let code = db.code().code().to_string();
        if matches!(code.as_str(), "57P01" | "57P02" | "57P03") {
            return self.crashed(key, statement);
        }
        self.report.error(&code);
        if db.severity() == "FATAL" {
            self.client = None;
        }
        let told = format!("{} {} {}", db.message(), db.detail().unwrap_or(""), db.hint().unwrap_or(""));
        if std::env::var("ATTACK_SHOW").is_ok_and(|c| c == code) {
            println!("{code} {told}: {}", crate::report::shortened(statement, 200));
        }
        if code.starts_with("XX") {
            let message: String = db.message().chars().filter(|c| !c.is_ascii_digit()).take(40).collect();
            let what = format!("{key}: {code} {message}");
            self.report.finding(Kind::Internal, &what, statement, &format!("{code} {told}"));
        }
        if ["rust_begin_unwind", "stack backtrace", "backtrace:", "/src/", ".rs:"].iter().any(|t| told.contains(t)) {
            self.report.finding(Kind::Backtrace, key, statement, &told);
        }
        Fault::State(code)
    }

    fn crashed(&mut self, key: &str, statement: &str) -> Fault {
        let deaths = self.recover();
        self.report.finding(Kind::Crash, key, statement, &deaths);
        Fault::Lost
    }

    /// Waits until the server answers again; what its log says about the death.
    fn recover(&mut self) -> String {
        self.client = None;
        std::thread::sleep(Duration::from_millis(100));
        self.pid();
        let deaths = deaths(&self.cluster.new_log());
        if deaths.is_empty() { "the connection was lost".into() } else { deaths.join("; ") }
    }

    /// Asks in the extended protocol with binary parameters and binary results, as asyncpg and JDBC do.
    pub fn query(&mut self, key: &str, sql: &str, params: &[Option<Raw>]) -> Answer<Column> {
        let shown = with_parameters(sql, params);
        let refs: Vec<&(dyn ToSql + Sync)> = params.iter().map(|p| p as &(dyn ToSql + Sync)).collect();
        self.run(key, &shown, |c| {
            let rows = c.query(sql, &refs)?;
            let first = |r: &postgres::Row| {
                if r.is_empty() { None } else { r.get::<_, Option<Raw>>(0).map(|r| r.0) }
            };
            Ok(rows.iter().map(first).collect())
        })
    }

    /// Asks in the simple protocol: text results; the first column.
    pub fn text(&mut self, key: &str, sql: &str) -> Answer<Vec<Option<String>>> {
        self.run(key, sql, |c| {
            let messages = c.simple_query(sql)?;
            let first = |m: &SimpleQueryMessage| match m {
                SimpleQueryMessage::Row(r) if !r.is_empty() => Some(r.get(0).map(String::from)),
                _ => None,
            };
            Ok(messages.iter().filter_map(first).collect())
        })
    }

    pub fn execute(&mut self, key: &str, sql: &str) -> Answer<()> {
        self.run(key, sql, |c| c.batch_execute(sql))
    }

    /// COPY … TO STDOUT.
    pub fn copy_out(&mut self, key: &str, sql: &str) -> Answer<Vec<u8>> {
        self.run(key, sql, |c| {
            let mut bytes = vec![];
            c.copy_out(sql)?.read_to_end(&mut bytes).map_err(into_postgres)?;
            Ok(bytes)
        })
    }

    /// COPY … FROM STDIN.
    pub fn copy_in(&mut self, key: &str, sql: &str, bytes: &[u8]) -> Answer<u64> {
        let shown = format!("{sql} -- {} bytes, from {}", bytes.len(), hex(&bytes[..bytes.len().min(20_000)]));
        self.run(key, &shown, |c| {
            let mut w = c.copy_in(sql)?;
            w.write_all(bytes).map_err(into_postgres)?;
            w.finish()
        })
    }

    /// Whether a second session on the same server answers.
    pub fn others_live(&mut self) -> bool {
        self.cluster.connect(&self.database).query_one("SELECT 1 + 1", &[]).is_ok()
    }
}

/// The driver wraps its errors for the I/O traits.
fn into_postgres(e: std::io::Error) -> postgres::Error {
    let inner = e.into_inner().expect("the driver's error");
    *inner.downcast::<postgres::Error>().expect("the driver's error")
}

pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect()
}

fn with_parameters(sql: &str, params: &[Option<Raw>]) -> String {
    let mut shown = sql.to_string();
    for (i, p) in params.iter().enumerate() {
        let value = p.as_ref().map_or("NULL".into(), |r| hex(&r.0));
        shown.push_str(&format!("\n-- binary ${}: {value}", i + 1));
    }
    shown
}
