//! What the client tests share: a fresh database each, the program, the data beside the project.
//!
//! The environment comes from `scripts/installcheck.sh`: PGHOST (a private cluster's socket directory), PGUSER,
//! ASBUILT (the program), PG_BINDIR.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use postgres::{Client, Config, NoTls};
use serde_json::Value;

/// A database of its own, dropped at the end.
pub struct Database {
    name: String,
}

fn variable(name: &str) -> String {
    std::env::var(name).unwrap_or_else(|_| panic!("{name} is not set; run these tests by: make test"))
}

fn config(database: &str) -> Config {
    let mut c = Config::new();
    c.host(&variable("PGHOST")).user(&variable("PGUSER")).dbname(database);
    c
}

impl Database {
    /// Makes an empty database.
    pub fn new(name: &str) -> Self {
        let name = format!("client_{name}_{}", std::process::id());
        let mut admin = config("postgres").connect(NoTls).expect("the cluster is reachable");
        admin.batch_execute(&format!("DROP DATABASE IF EXISTS {name}")).unwrap();
        admin.batch_execute(&format!("CREATE DATABASE {name}")).unwrap();
        Self { name }
    }

    /// Makes a database with the extension.
    pub fn with_extension(name: &str) -> (Self, Client) {
        let db = Self::new(name);
        let mut client = db.connect();
        client.batch_execute("CREATE EXTENSION asbuilt").unwrap();
        (db, client)
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    pub fn connect(&self) -> Client {
        config(&self.name).connect(NoTls).unwrap()
    }

    /// Calls a program of PostgreSQL (pg_dump, psql …).
    pub fn tool(&self, program: &str, args: &[&str]) -> Output {
        let path = Path::new(&variable("PG_BINDIR")).join(program);
        Command::new(path).args(args).env("PGDATABASE", &self.name).output().unwrap()
    }

    /// Dumps the database as SQL and restores it into a fresh one.
    pub fn dumped_and_restored(&self, name: &str) -> Self {
        let dump = self.tool("pg_dump", &[]);
        assert!(dump.status.success(), "{}", String::from_utf8_lossy(&dump.stderr));
        let file = scratch(&format!("{name}.sql"));
        std::fs::write(&file, &dump.stdout).unwrap();
        let back = Self::new(name);
        let restored = back.tool("psql", &["-q", "-v", "ON_ERROR_STOP=1", "-f", text(&file)]);
        assert!(restored.status.success(), "{}", String::from_utf8_lossy(&restored.stderr));
        back
    }

    /// The program `asbuilt`, not yet started.
    pub fn command(&self, args: &[&str]) -> Command {
        let mut c = Command::new(variable("ASBUILT"));
        c.args(args).env("PGDATABASE", &self.name);
        c
    }

    /// The same as another user, whose search path this is.
    pub fn command_as(&self, user: &str, path: &str, args: &[&str]) -> Command {
        let mut c = self.command(args);
        c.env("PGUSER", user).env("PGOPTIONS", format!("-c search_path={path}"));
        c
    }

    /// Connects as another user.
    pub fn connect_as(&self, user: &str) -> Client {
        config(&self.name).user(user).connect(NoTls).unwrap()
    }

    /// Calls `asbuilt` and expects success; returns what it said on standard error.
    pub fn asbuilt(&self, args: &[&str]) -> String {
        let out = self.command(args).output().unwrap();
        let said = String::from_utf8_lossy(&out.stderr).into_owned();
        assert!(out.status.success(), "asbuilt {args:?}: {said}");
        said
    }

    /// Calls `asbuilt` and expects failure; returns the error.
    pub fn asbuilt_fails(&self, args: &[&str]) -> String {
        let out = self.command(args).output().unwrap();
        let said = String::from_utf8_lossy(&out.stderr).into_owned();
        assert!(!out.status.success(), "asbuilt {args:?} succeeded: {said}");
        assert!(said.contains("asbuilt: ") || said.contains("error: "), "no error message: {said}");
        said
    }

    /// `asbuilt verify … --format json`, by object name.
    pub fn verify(&self, args: &[&str]) -> Verdicts {
        let mut all = vec!["verify", "--format", "json"];
        all.extend(args);
        let out = self.command(&all).output().unwrap();
        assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
        let rows: Vec<Value> = serde_json::from_slice(&out.stdout).unwrap();
        assert!(!rows.is_empty(), "no object was verified");
        Verdicts(rows)
    }
}

impl Drop for Database {
    fn drop(&mut self) {
        if let Ok(mut admin) = config("postgres").connect(NoTls) {
            let _ = admin.batch_execute(&format!("DROP DATABASE IF EXISTS {} WITH (FORCE)", self.name));
        }
    }
}

/// Roles of a test, dropped at the end with what they own in this database.
pub struct Roles<'a> {
    db: &'a Database,
    names: Vec<String>,
}

impl<'a> Roles<'a> {
    pub fn new(db: &'a Database, names: &[&str]) -> Self {
        let names: Vec<String> = names.iter().map(|n| format!("{n}_{}", db.name())).collect();
        let mut client = db.connect();
        for name in &names {
            client.batch_execute(&format!("CREATE ROLE {name} LOGIN; GRANT ALL ON SCHEMA public TO {name}")).unwrap();
        }
        Self { db, names }
    }
}

impl std::ops::Index<usize> for Roles<'_> {
    type Output = str;

    fn index(&self, i: usize) -> &str {
        &self.names[i]
    }
}

impl Drop for Roles<'_> {
    fn drop(&mut self) {
        let mut client = self.db.connect();
        for name in &self.names {
            let _ = client.batch_execute(&format!(
                "ALTER DATABASE {} OWNER TO CURRENT_USER; DROP OWNED BY {name} CASCADE; DROP ROLE {name}",
                self.db.name()
            ));
        }
    }
}

/// The rows of `asbuilt verify`.
pub struct Verdicts(Vec<Value>);

impl Verdicts {
    fn row(&self, object: &str) -> &Value {
        self.0.iter().find(|r| r["name"] == object).unwrap_or_else(|| panic!("no object {object}"))
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub fn verdict(&self, object: &str) -> &str {
        self.row(object)["verdict"].as_str().unwrap()
    }

    pub fn text(&self, object: &str, column: &str) -> &str {
        self.row(object)[column].as_str().unwrap_or_else(|| panic!("{object} has no {column}"))
    }

    pub fn number(&self, object: &str, column: &str) -> f64 {
        self.row(object)[column].as_f64().unwrap_or_else(|| panic!("{object} has no {column}"))
    }

    /// The rigid offset, metres; `None` along undetermined axes.
    pub fn shift(&self, object: &str) -> [Option<f64>; 3] {
        let axes = self.row(object)["shift_m"].as_array().unwrap_or_else(|| panic!("{object} has no shift"));
        axes.iter().map(serde_json::Value::as_f64).collect::<Vec<_>>().try_into().unwrap()
    }

    /// Fails, naming all of them, unless every object has its verdict.
    pub fn expect(&self, expected: &[(&str, &str)]) {
        let wrong: Vec<String> = expected
            .iter()
            .filter(|(object, verdict)| self.verdict(object) != *verdict)
            .map(|(object, verdict)| format!("{object}: expected {verdict}, got {}", self.row(object)))
            .collect();
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}

/// The project's root folder.
pub fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// A file of the data beside the project; `None` where it is absent, which `scripts/installcheck.sh` says loudly.
pub fn shared(path: &str) -> Option<PathBuf> {
    let file = project("../shared/data").join(path);
    if file.exists() {
        return Some(file);
    }
    eprintln!("SKIPPED: {} is not there", file.display());
    None
}

/// The hall of the data beside the project, its epochs 1 and 2 loaded; `None` where it is absent.
pub fn hall(database: &str) -> Option<Database> {
    let [model, one, two] = ["model.ifc", "epoch1.e57", "epoch2.e57"].map(|file| shared(&format!("hall/{file}")));
    let (model, one, two) = (model?, one?, two?);
    let db = Database::new(database);
    db.asbuilt(&["load", text(&model)]);
    db.asbuilt(&["load", text(&one), "--epoch", "1"]);
    db.asbuilt(&["load", text(&two), "--epoch", "2"]);
    Some(db)
}

/// A scratch file under the target folder.
pub fn scratch(name: &str) -> PathBuf {
    let dir = project("target/client-tests");
    std::fs::create_dir_all(&dir).unwrap();
    dir.join(format!("{}-{name}", std::process::id()))
}

/// Path as text.
pub fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}
