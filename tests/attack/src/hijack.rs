//! Another role may CREATE in schema public: whatever it plants there, the program of someone else must not run.

use std::process::Command;

use postgres::Client;

use crate::catalogue::{Catalogue, Function};
use crate::cluster::{AMPLE_KB, Cluster};
use crate::files::program;
use crate::report::{Kind, Report};

/// Planted code reports in the server's log who ran it: a row in a table would vanish with the failing transaction.
const MARK: &str = "PLANTED";
/// The report as it appears in the log; statements that PostgreSQL refused are in the log, too.
const MARKED: &str = "LOG:  PLANTED";

/// Columns of the program's tables, so that planted ones look right.
const PLANTED: [(&str, &str); 3] = [
    (
        "building_object",
        "id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY, global_id text, ifc_class text, name text, storey text, loa ab_loa, solid ab_solid, properties jsonb, source text",
    ),
    (
        "station",
        "id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY, epoch integer, name text, pose ab_pose, sensor text, source text",
    ),
    ("scan", "id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY, station_id bigint, epoch integer, patch ab_scan"),
];

/// What is planted.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Plant {
    Nothing,
    /// The same arguments: where public stands before the extension's schema.
    Same,
    /// The first of the arguments without defaults, which win over a longer list with defaults.
    Shorter,
    /// Text for numbers: an untyped literal prefers text.
    TextForNumbers,
    TextForPlain,
    TextForAll,
    Tables,
}

/// Name of the database, the extension's schema, who runs the program. A superuser is a member of every role, so what a
/// plain user refuses may still catch one. Each kind has a database of its own: together they are only ambiguous.
const CASES: [(&str, &str, &str, Plant); 9] = [
    ("unharmed", "public", "victim", Plant::Nothing),
    ("shorter", "public", "victim", Plant::Shorter),
    ("text_for_numbers", "public", "victim", Plant::TextForNumbers),
    ("text_for_plain", "public", "victim", Plant::TextForPlain),
    ("text_for_all", "public", "victim", Plant::TextForAll),
    ("house", "house", "victim", Plant::Same),
    ("house_shorter", "house", "victim", Plant::Shorter),
    ("tables", "public", "victim", Plant::Tables),
    ("tables_of_a_plain_user", "public", "plain", Plant::Tables),
];

pub fn run(report: &mut Report) {
    let mut cluster = Cluster::start("hijack", AMPLE_KB, "");
    let folder = cluster.socket_dir().join("files");
    std::fs::create_dir_all(&folder).unwrap();
    let files = crate::files::for_hijack(&folder);
    let roles = "CREATE ROLE attacker LOGIN; CREATE ROLE victim LOGIN SUPERUSER; CREATE ROLE plain LOGIN";
    cluster.connect("postgres").batch_execute(roles).unwrap();
    for case in CASES {
        let (name, schema, _, plant) = case;
        let planted = database(&cluster, name, schema, plant);
        cluster.new_log();
        let failed: Vec<String> = commands(&files).iter().filter_map(|c| failure(&cluster, &case, c)).collect();
        report.executed(commands(&files).len() as u64);
        if plant == Plant::Nothing && !failed.is_empty() {
            report.finding(
                Kind::Stale,
                "hijack",
                "asbuilt load, verify, change",
                &format!("without any attack: {failed:?}"),
            );
        }
        judge(report, &mut cluster, &format!("hijack by {name}"), &planted);
    }
}

/// A database whose owner lets everyone CREATE in public, as PostgreSQL 14 did by default; with what another role
/// planted there. Where the extension lies in public the tables are there and filled, as a loader left them.
fn database(cluster: &Cluster, name: &str, schema: &str, plant: Plant) -> Vec<String> {
    let filled = schema == "public" && !matches!(plant, Plant::Nothing | Plant::Tables);
    let template = if filled { " TEMPLATE hijack_unharmed" } else { "" };
    cluster.connect("postgres").batch_execute(&format!("CREATE DATABASE hijack_{name}{template}")).unwrap();
    let mut owner = cluster.connect(&format!("hijack_{name}"));
    let grant = format!(
        "CREATE SCHEMA IF NOT EXISTS {schema}; GRANT USAGE ON SCHEMA {schema} TO PUBLIC; GRANT CREATE ON SCHEMA public TO PUBLIC; \
         CREATE EXTENSION IF NOT EXISTS asbuilt SCHEMA {schema}"
    );
    owner.batch_execute(&grant).unwrap();
    let planted = match plant {
        Plant::Nothing => vec![],
        Plant::Tables => tables(),
        _ => functions(&mut owner, plant),
    };
    let mut attacker = cluster.connect_as("attacker", &format!("hijack_{name}"));
    // What PostgreSQL itself refuses (a name taken) is no way in.
    planted.iter().for_each(|sql| drop(attacker.batch_execute(sql)));
    planted
}

fn commands(files: &[String]) -> Vec<Vec<String>> {
    let words = |line: &str| line.split_whitespace().map(String::from).collect::<Vec<_>>();
    let mut all: Vec<Vec<String>> = files.iter().map(|f| words(&format!("load {f}"))).collect();
    all.push(words(&format!("load {} --epoch 2", files[1])));
    all.push(words("verify --spacing 0.2 --format json"));
    all.push(words("change --from 1 --to 2 --voxel 0.1"));
    all.push(words("change --model --to 1 --voxel 0.1"));
    all
}

/// Runs the program; what it said if it failed.
fn failure(
    cluster: &Cluster,
    (name, schema, victim, _): &(&str, &str, &str, Plant),
    arguments: &[String],
) -> Option<String> {
    let out = Command::new("timeout")
        .arg("60")
        .arg(program())
        .args(arguments)
        .env("PGHOST", cluster.socket_dir())
        .env("PGUSER", victim)
        .env("PGDATABASE", format!("hijack_{name}"))
        .env("PGOPTIONS", format!("-c search_path=public,{schema}"))
        .output()
        .expect("the program runs");
    (!out.status.success()).then(|| format!("{arguments:?}: {}", String::from_utf8_lossy(&out.stderr)))
}

/// For every function of the extension: functions of its name in public that fit a call as well or better.
fn functions(owner: &mut Client, plant: Plant) -> Vec<String> {
    // With this path the catalogue names every type with its schema.
    owner.batch_execute("SET search_path = pg_catalog").unwrap();
    let catalogue = Catalogue::read(owner);
    let is_called = |f: &&Function| !f.aggregate && !f.arguments.iter().any(|a| a == "internal" || a == "cstring");
    let mut sql: Vec<String> = catalogue.functions.iter().filter(is_called).flat_map(|f| disguises(f, plant)).collect();
    // And of PostgreSQL's own that the program calls, for arguments that fit better than theirs.
    for (name, arguments) in [
        ("to_regclass", "varchar"),
        ("to_regtype", "varchar"),
        ("hashtext", "varchar"),
        ("format", "varchar, varchar"),
        ("floor", "real"),
        ("length", "varchar"),
        ("round", "real, integer"),
    ] {
        sql.push(planted(name, arguments, "integer", "NULL"));
    }
    sql
}

fn disguises(f: &Function, plant: Plant) -> Vec<String> {
    let name = f.name.rsplit('.').next().unwrap();
    let n = f.arguments.len();
    let list = |k: usize, as_text: &dyn Fn(&str) -> bool, defaults: usize| {
        let argument = |i: usize| {
            let ty = if as_text(&f.arguments[i]) { "text" } else { &f.arguments[i] };
            let given = f.names.get(i).filter(|n| !n.is_empty()).map_or(String::new(), |n| format!("\"{n}\" "));
            format!("{given}{ty}{}", if i + defaults >= n { " DEFAULT NULL" } else { "" })
        };
        let mut all: Vec<String> = (0..k).map(argument).collect();
        all.extend((!f.outs.is_empty()).then(|| f.outs.clone()));
        all.join(", ")
    };
    let value = if f.outs.is_empty() && !f.returns.starts_with("SETOF") { "NULL" } else { "" };
    let of = |arguments: String| planted(name, &arguments, &f.returns, value);
    let defaults = f.defaults as usize;
    match plant {
        Plant::Shorter => (n - defaults..n).map(|k| of(list(k, &|_| false, 0))).collect(),
        Plant::TextForNumbers => vec![of(list(n, &|ty| ty == "double precision", defaults))],
        Plant::TextForPlain => vec![of(list(n, &|ty| !ty.contains("ab_"), defaults))],
        Plant::TextForAll => vec![of(list(n, &|_| true, defaults))],
        _ => vec![of(list(n, &|_| false, defaults))],
    }
}

fn planted(name: &str, arguments: &str, returns: &str, value: &str) -> String {
    let how = format!("{name}({arguments})").replace('\'', "''");
    format!(
        "CREATE FUNCTION public.{name}({arguments}) RETURNS {returns} LANGUAGE plpgsql AS $$ BEGIN \
         RAISE LOG '{MARK} % ran as %', '{how}', current_user; RETURN {value}; END $$"
    )
}

/// Tables of the program's names with triggers, rules of defaults and policies that run the planter's code.
fn tables() -> Vec<String> {
    let mut sql = vec![
        "CREATE FUNCTION public.trap() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN \
         RAISE LOG 'PLANTED % ran as %', 'trigger on ' || TG_TABLE_NAME, current_user; RETURN coalesce(NEW, OLD); END $$"
            .to_string(),
        "CREATE FUNCTION public.bait() RETURNS text LANGUAGE plpgsql AS $$ BEGIN \
         RAISE LOG 'PLANTED default ran as %', current_user; RETURN 'x'; END $$"
            .into(),
    ];
    for (table, columns) in PLANTED {
        sql.push(format!("CREATE TABLE public.{table} ({columns}, bait text DEFAULT public.bait())"));
        sql.push(format!("CREATE TRIGGER trap BEFORE INSERT OR UPDATE OR DELETE ON public.{table} FOR EACH ROW EXECUTE FUNCTION public.trap()"));
        sql.push(format!("CREATE TRIGGER trap_statement AFTER INSERT OR UPDATE OR DELETE ON public.{table} FOR EACH STATEMENT EXECUTE FUNCTION public.trap()"));
        sql.push(format!("GRANT ALL ON public.{table} TO PUBLIC"));
    }
    sql
}

fn judge(report: &mut Report, cluster: &mut Cluster, key: &str, planted: &[String]) {
    for line in cluster.new_log().lines().filter(|l| l.contains(MARKED) && !l.ends_with(" attacker")) {
        let how = line.split(MARK).nth(1).unwrap_or_default().trim();
        let name = how.split(" ran as ").next().unwrap_or_default();
        let statement = planted.iter().find(|p| p.contains(&name.replace('\'', "''")));
        let statement = statement.map_or(planted.join(";\n"), Clone::clone);
        report.finding(Kind::Hijack, &format!("{key}: {}", name.split('(').next().unwrap_or(name)), &statement, how);
    }
}
