//! Another role may CREATE in schema public: whatever it plants there, the program of someone else must not run.

use std::process::{Command, Output};

use postgres::Client;

use crate::catalogue::{Catalogue, Function};
use crate::cluster::{AMPLE_KB, Cluster};
use crate::files::program;
use crate::report::{Kind, Report};

/// What was run by whom. The planted code writes here with the rights of whoever runs it.
const MARKER: &str = "CREATE TABLE public.marker (who name, how text); GRANT ALL ON public.marker TO PUBLIC";

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

pub fn run(report: &mut Report) {
    let mut cluster = Cluster::start("hijack", AMPLE_KB, "");
    let folder = cluster.socket_dir().join("files");
    std::fs::create_dir_all(&folder).unwrap();
    let files = crate::files::for_hijack(&folder);
    cluster
        .connect("postgres")
        .batch_execute("CREATE ROLE attacker LOGIN; CREATE ROLE victim LOGIN SUPERUSER; CREATE ROLE plain LOGIN")
        .unwrap();
    // A superuser is a member of every role, so what a plain user refuses may still catch one.
    for (name, schema, victim) in [
        ("unharmed", "public", "victim"),
        ("functions", "public", "victim"),
        ("elsewhere", "house", "victim"),
        ("first", "later", "victim"),
        ("tables", "public", "victim"),
        ("tables_of_a_plain_user", "public", "plain"),
    ] {
        let (mut owner, mut attacker) = database(&cluster, name, schema);
        let key = format!("hijack by {name}");
        let planted = match name {
            "unharmed" => vec![],
            _ if name.starts_with("tables") => tables(),
            _ => functions(&mut owner, schema),
        };
        for sql in &planted {
            // What PostgreSQL itself refuses (a name taken) is no way in.
            let _ = attacker.batch_execute(sql);
        }
        let mut outputs = vec![];
        for arguments in commands(&files) {
            report.executed(1);
            outputs.push(output(&cluster, name, schema, victim, &arguments));
        }
        if name == "unharmed" && outputs.iter().any(|o| !o.status.success()) {
            let said: Vec<String> = outputs.iter().map(|o| String::from_utf8_lossy(&o.stderr).into_owned()).collect();
            report.finding(
                Kind::Stale,
                &key,
                "asbuilt load, verify, change",
                &format!("the program fails without any attack: {said:?}"),
            );
        }
        judge(report, &mut owner, &key, &planted);
    }
    cluster.new_log();
}

/// A database whose owner lets everyone CREATE in public, as PostgreSQL 14 did by default.
fn database(cluster: &Cluster, name: &str, schema: &str) -> (Client, Client) {
    cluster.connect("postgres").batch_execute(&format!("CREATE DATABASE hijack_{name}")).unwrap();
    let mut owner = cluster.connect(&format!("hijack_{name}"));
    owner.batch_execute(&format!("GRANT CREATE ON SCHEMA public TO PUBLIC; {MARKER}")).unwrap();
    if schema != "later" {
        let sql = format!(
            "CREATE SCHEMA IF NOT EXISTS {schema}; GRANT USAGE ON SCHEMA {schema} TO PUBLIC; CREATE EXTENSION asbuilt SCHEMA {schema}"
        );
        owner.batch_execute(&sql).unwrap();
    }
    (owner, cluster.connect_as("attacker", &format!("hijack_{name}")))
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

fn output(cluster: &Cluster, name: &str, schema: &str, victim: &str, arguments: &[String]) -> Output {
    Command::new("timeout")
        .arg("60")
        .arg(program())
        .args(arguments)
        .env("PGHOST", cluster.socket_dir())
        .env("PGUSER", victim)
        .env("PGDATABASE", format!("hijack_{name}"))
        .env("PGOPTIONS", format!("-c search_path=public,{schema}"))
        .output()
        .expect("the program runs")
}

/// For every function of the extension: functions of its name in public that fit a call as well or better.
fn functions(owner: &mut Client, schema: &str) -> Vec<String> {
    // With this path the catalogue names every type with its schema.
    owner.batch_execute("SET search_path = pg_catalog").unwrap();
    let catalogue = if schema == "later" {
        // The names are known from another database; here the extension is not there yet.
        owner.batch_execute("CREATE SCHEMA spare; CREATE EXTENSION asbuilt SCHEMA spare").unwrap();
        let read = Catalogue::read(owner);
        owner.batch_execute("DROP EXTENSION asbuilt; DROP SCHEMA spare").unwrap();
        read
    } else {
        Catalogue::read(owner)
    };
    let is_called = |f: &&Function| !f.aggregate && !f.arguments.iter().any(|a| a == "internal" || a == "cstring");
    let mut sql: Vec<String> = catalogue.functions.iter().filter(is_called).flat_map(disguises).collect();
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

/// The same arguments; the first of them without defaults, which wins over a longer list with defaults; and text where
/// an untyped literal may stand, which prefers it.
fn disguises(f: &Function) -> Vec<String> {
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
    let mut all: Vec<String> = (n - defaults..=n).map(|k| of(list(k, &|_| false, 0))).collect();
    all.push(of(list(n, &|ty| !ty.contains("ab_"), defaults)));
    all.push(of(list(n, &|ty| ty == "double precision", defaults)));
    all.push(of(list(n, &|_| true, defaults)));
    all
}

fn planted(name: &str, arguments: &str, returns: &str, value: &str) -> String {
    let how = format!("{name}({arguments})").replace('\'', "''");
    format!(
        "CREATE FUNCTION public.{name}({arguments}) RETURNS {returns} LANGUAGE plpgsql AS $$ BEGIN \
         INSERT INTO public.marker VALUES (current_user, '{how}'); RETURN {value}; END $$"
    )
}

/// Tables of the program's names with triggers, rules of defaults and policies that run the planter's code.
fn tables() -> Vec<String> {
    let mut sql = vec![
        "CREATE FUNCTION public.trap() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN \
         INSERT INTO public.marker VALUES (current_user, 'trigger on ' || TG_TABLE_NAME); RETURN coalesce(NEW, OLD); END $$"
            .to_string(),
        "CREATE FUNCTION public.bait() RETURNS text LANGUAGE plpgsql AS $$ BEGIN \
         INSERT INTO public.marker VALUES (current_user, 'default'); RETURN 'x'; END $$"
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

fn judge(report: &mut Report, owner: &mut Client, key: &str, planted: &[String]) {
    let sql = "SELECT DISTINCT how FROM public.marker WHERE who <> 'attacker' ORDER BY 1";
    for row in owner.query(sql, &[]).expect("the marker") {
        let how: String = row.get(0);
        let name = how.split('(').next().unwrap_or_default();
        let statement = planted.iter().find(|p| p.contains(&how)).map_or(planted.join(";\n"), Clone::clone);
        report.finding(Kind::Hijack, &format!("{key}: {name}"), &statement, &format!("{how} ran as the victim"));
    }
}
