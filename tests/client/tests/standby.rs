//! Commands that only read work on a server that can only be read.

use std::path::{Path, PathBuf};
use std::process::Command;

use asbuilt_client_tests::{Database, project, scratch, text};

/// The demo, and two epochs of it.
fn demo(name: &str) -> Database {
    let db = Database::new(name);
    let (model, stations, scan) =
        (project("demo/pavilion.ifc"), project("demo/stations.txt"), scratch(&format!("{name}.e57")));
    db.asbuilt(&["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "10", "--out", text(&scan)]);
    db.asbuilt(&["load", text(&model), text(&scan)]);
    db.asbuilt(&["load", text(&scan), "--epoch", "2"]);
    std::fs::remove_file(scan).unwrap();
    db
}

const READERS: [&[&str]; 5] = [
    &["verify", "--spacing", "0.1", "--format", "csv"],
    &["explain", "1", "--spacing", "0.1"],
    &["list", "stations", "--format", "csv"],
    &["change", "--from", "1", "--to", "2", "--voxel", "0.1", "--format", "json"],
    &["change", "--model", "--to", "2", "--voxel", "0.1", "--format", "json"],
];

fn answers(db: &Database, environment: &[(&str, &str)]) -> Vec<Vec<u8>> {
    let answer = |args: &&[&str]| {
        let out = db.command(args).envs(environment.iter().copied()).output().unwrap();
        assert!(out.status.success(), "{args:?}: {}", String::from_utf8_lossy(&out.stderr));
        out.stdout
    };
    READERS.iter().map(answer).collect()
}

#[test]
fn a_session_that_may_not_write() {
    let db = demo("read_only");
    let plain = answers(&db, &[]);
    assert_eq!(plain, answers(&db, &[("PGOPTIONS", "-c default_transaction_read_only=on")]));
    // Nor anybody who may make no temporary tables.
    let ply = scratch("read_only.ply");
    db.connect().batch_execute(&format!("REVOKE TEMPORARY ON DATABASE {} FROM PUBLIC", db.name())).unwrap();
    let mut command = db.command(&["change", "--from", "1", "--to", "2", "--voxel", "0.1", "--export", text(&ply)]);
    let out = command.env("PGOPTIONS", "-c default_transaction_read_only=on").output().unwrap();
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    assert!(std::fs::metadata(&ply).unwrap().len() > 1000);
    std::fs::remove_file(ply).unwrap();
}

/// A cluster of the test's own; gone at the end.
struct Cluster(PathBuf);

impl Cluster {
    fn new(name: &str) -> Self {
        let dir = std::env::temp_dir().join(format!("asbuilt-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&dir);
        std::fs::create_dir_all(&dir).unwrap();
        if is_root() {
            assert!(Command::new("chown").args(["postgres:", text(&dir)]).status().unwrap().success());
        }
        Self(dir)
    }

    /// Calls a program of PostgreSQL, as root by user postgres.
    fn tool(&self, program: &str, args: &[&str]) {
        let path = Path::new(&std::env::var("PG_BINDIR").unwrap()).join(program);
        let mut c = if is_root() {
            let mut c = Command::new("runuser");
            c.args(["-u", "postgres", "--", text(&path)]);
            c
        } else {
            Command::new(path)
        };
        c.args(args).current_dir("/").env_remove("PGHOST").stdout(std::process::Stdio::null());
        let out = c.output().unwrap();
        assert!(out.status.success(), "{program} {args:?}: {}", String::from_utf8_lossy(&out.stderr));
    }

    fn data(&self) -> String {
        format!("{}/data", self.0.display())
    }

    fn start(&self) {
        let options = format!("-c listen_addresses= -c unix_socket_directories={} -c fsync=off", self.0.display());
        let log = format!("{}/log", self.0.display());
        self.tool("pg_ctl", &["-D", &self.data(), "-l", &log, "-w", "-s", "-o", &options, "start"]);
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        let stop = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            self.tool("pg_ctl", &["-D", &self.data(), "-m", "immediate", "-w", "-s", "stop"]);
        }));
        let _ = (stop, std::fs::remove_dir_all(&self.0));
    }
}

fn is_root() -> bool {
    Command::new("id").arg("-u").output().is_ok_and(|o| o.stdout == b"0\n")
}

#[test]
fn a_hot_standby() {
    let db = demo("standby");
    let dump = db.tool("pg_dump", &[]);
    let (primary, standby) = (Cluster::new("primary"), Cluster::new("standby"));
    primary.tool("initdb", &["-D", &primary.data(), "-U", "postgres", "-A", "trust", "--no-sync"]);
    primary.start();
    let socket = text(&primary.0).to_owned();
    primary.tool("createdb", &["-h", &socket, "-U", "postgres", db.name()]);
    let sql = primary.0.join("dump.sql");
    std::fs::write(&sql, dump.stdout).unwrap();
    primary
        .tool("psql", &["-q", "-h", &socket, "-U", "postgres", "-v", "ON_ERROR_STOP=1", "-f", text(&sql), db.name()]);
    standby.tool(
        "pg_basebackup",
        &["-h", &socket, "-U", "postgres", "-D", &standby.data(), "-R", "-X", "stream", "-c", "fast"],
    );
    standby.start();
    let plain = answers(&db, &[]);
    assert_eq!(plain, answers(&db, &[("PGHOST", text(&standby.0))]));
    let out =
        db.command(&["load", text(&project("demo/pavilion.ifc"))]).env("PGHOST", text(&standby.0)).output().unwrap();
    assert!(String::from_utf8_lossy(&out.stderr).contains("read-only transaction"));
}
