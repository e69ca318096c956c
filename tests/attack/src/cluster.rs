//! A private server with backtraces switched on and, where asked, little memory; and its log.

use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use postgres::{Client, Config, NoTls};

/// Address space of a backend when memory is short: 1.5 GB.
pub const SMALL_KB: u64 = 1_572_864;
/// Enough for honest work, and little enough that no attack takes the machine.
pub const AMPLE_KB: u64 = 4 << 20;

pub struct Cluster {
    dir: PathBuf,
    bin: PathBuf,
    ulimit_kb: u64,
    log_read: u64,
}

/// The project's folder.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap().to_path_buf()
}

fn bin_dir() -> PathBuf {
    if let Ok(dir) = std::env::var("PG_BINDIR") {
        return dir.into();
    }
    let config = std::env::var("PG_CONFIG").unwrap_or_else(|_| "/usr/lib/postgresql/15/bin/pg_config".into());
    let out = Command::new(config).arg("--bindir").output().expect("pg_config");
    String::from_utf8_lossy(&out.stdout).trim().into()
}

fn is_root() -> bool {
    std::fs::metadata("/proc/self").is_ok_and(|m| m.uid() == 0)
}

impl Cluster {
    /// Makes and starts a server; `ulimit_kb` bounds the addresses of each of its processes.
    pub fn start(name: &str, ulimit_kb: u64, settings: &str) -> Self {
        let dir = std::env::temp_dir().join(format!("asbuilt-attack-{name}-{}", std::process::id()));
        let mut cluster = Self { dir, bin: bin_dir(), ulimit_kb, log_read: 0 };
        cluster.script("start");
        cluster.script("stop");
        // Each value stands alone: no autovacuum, so that a run repeats; SQLSTATE and kind of process in the log.
        let conf = format!(
            "shared_buffers = 32MB\nmax_connections = 20\nautovacuum = off\nwork_mem = 4MB\nmaintenance_work_mem = 32MB\n\
             max_wal_size = 1GB\nlog_line_prefix = '%p %e %b: '\nlog_error_verbosity = terse\n{settings}\n"
        );
        let file = cluster.dir.join("data/postgresql.conf");
        let old = std::fs::read_to_string(&file).unwrap();
        std::fs::write(&file, old + &conf).unwrap();
        cluster.control("start");
        cluster.log_read = 0;
        cluster
    }

    fn script(&self, command: &str) {
        let script = root().join("scripts/cluster.sh");
        let out = Command::new(script).arg(command).arg(&self.dir).output().unwrap();
        assert!(out.status.success(), "cluster.sh {command}: {}", String::from_utf8_lossy(&out.stderr));
    }

    /// `pg_ctl`, here and not by the script: that one removes RUST_BACKTRACE, and a backtrace that reaches a client is
    /// one of the findings.
    fn control(&self, command: &str) {
        let line = format!(
            "ulimit -c 0; ulimit -v {}; exec env RUST_BACKTRACE=1 '{}/pg_ctl' -D '{}/data' -l '{}/server.log' -w -s -m immediate {command}",
            self.ulimit_kb,
            self.bin.display(),
            self.dir.display(),
            self.dir.display()
        );
        let mut c = if is_root() { Command::new("runuser") } else { Command::new("bash") };
        if is_root() {
            c.args(["-u", "postgres", "--", "bash"]);
        }
        // -m is for stop alone
        let line = if command == "start" { line.replace(" -m immediate", "") } else { line };
        let status = c.arg("-c").arg(line).stdin(std::process::Stdio::null()).status().unwrap();
        assert!(status.success(), "pg_ctl {command} failed; see {}/server.log", self.dir.display());
    }

    /// Leaves one process this much more address space than it has. By the server's user: another's limits are not
    /// root's to set where root is without its capabilities.
    pub fn limit_addresses(&self, pid: i32, more: u64) {
        let pages = std::fs::read_to_string(format!("/proc/{pid}/statm")).expect("the backend's size");
        let size: u64 = pages.split_whitespace().next().unwrap().parse().unwrap();
        let limit = format!("--as={}", (size * 4096 + more).min(self.ulimit_kb * 1024));
        let mut c = if is_root() { Command::new("runuser") } else { Command::new("prlimit") };
        if is_root() {
            c.args(["-u", "postgres", "--", "prlimit"]);
        }
        let status = c.args(["--pid", &pid.to_string(), &limit]).status().expect("prlimit");
        assert!(status.success(), "prlimit {limit} failed");
    }

    pub fn socket_dir(&self) -> &Path {
        &self.dir
    }

    /// A connection as `user`; waits while the server recovers from a crash.
    pub fn connect_as(&self, user: &str, database: &str) -> Client {
        let mut config = Config::new();
        config.host_path(&self.dir).user(user).dbname(database).application_name("attack");
        let began = Instant::now();
        loop {
            match config.connect(NoTls) {
                Ok(client) => return client,
                Err(e) if began.elapsed() > Duration::from_secs(60) => panic!("the server does not come back: {e}"),
                Err(_) => std::thread::sleep(Duration::from_millis(50)),
            }
        }
    }

    pub fn connect(&self, database: &str) -> Client {
        self.connect_as("postgres", database)
    }

    /// A fresh database with the extension and those of its bridges that are installed.
    pub fn database(&self, name: &str) -> Client {
        self.connect("postgres").batch_execute(&format!("CREATE DATABASE {name}")).unwrap();
        let mut client = self.connect(name);
        client.batch_execute("CREATE EXTENSION asbuilt; CREATE SCHEMA attack").unwrap();
        for bridge in ["asbuilt_postgis", "asbuilt_pointcloud"] {
            if let Err(e) = client.batch_execute(&format!("CREATE EXTENSION {bridge} CASCADE")) {
                let why = e.as_db_error().map(|d| d.message().to_string()).unwrap_or_default();
                println!("SKIPPED: {bridge} cannot be attacked here: {why}");
            }
        }
        client
    }

    /// What the log said since the last call.
    pub fn new_log(&mut self) -> String {
        let whole = std::fs::read(self.dir.join("server.log")).unwrap_or_default();
        let from = (self.log_read as usize).min(whole.len());
        self.log_read = whole.len() as u64;
        String::from_utf8_lossy(&whole[from..]).into_owned()
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        let out = Command::new(root().join("scripts/cluster.sh")).arg("drop").arg(&self.dir).output();
        if !out.is_ok_and(|o| o.status.success()) {
            eprintln!("attack: {} could not be removed", self.dir.display());
        }
    }
}

/// Lines of a log that tell of a death: signal, PANIC, abort.
pub fn deaths(log: &str) -> Vec<String> {
    let deadly = ["terminated by signal", "PANIC", "memory allocation of", "exited with exit code 134"];
    log.lines().filter(|l| deadly.iter().any(|d| l.contains(d))).map(String::from).collect()
}
