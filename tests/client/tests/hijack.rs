//! A role that may CREATE in a schema on a user's search path runs no code as the user who runs the program.
//!
//! Everything planted raises HIJACKED when it is called.

use std::process::Output;

use asbuilt_client_tests::{Database, Roles, project, scratch, text};

fn evil(signature: &str, returns: &str) -> String {
    format!(
        "CREATE FUNCTION public.{signature} RETURNS {returns} LANGUAGE plpgsql AS $$BEGIN RAISE EXCEPTION 'HIJACKED as % by {signature}', current_user; END$$;"
    )
}

/// An operator over a function that hijacks.
fn evil_operator(name: &str, left: &str, right: &str) -> String {
    let function = if name == "||" { "joined" } else { "compared" };
    evil(&format!("{function}({left}, {right})"), if name == "||" { "text" } else { "boolean" })
        + &format!("CREATE OPERATOR public.{name} (LEFTARG = {left}, RIGHTARG = {right}, FUNCTION = public.{function})")
}

fn said(out: &Output) -> String {
    String::from_utf8_lossy(&out.stderr).into_owned()
}

/// A database of alice (role 0), with the extension in schema `ext`, in whose schema public mallory (role 1) may make things.
fn database(name: &str) -> Database {
    let db = Database::new(name);
    db.connect()
        .batch_execute("CREATE SCHEMA ext; CREATE EXTENSION asbuilt SCHEMA ext; GRANT USAGE ON SCHEMA ext TO PUBLIC")
        .unwrap();
    db
}

fn scan(db: &Database) -> std::path::PathBuf {
    let file = scratch(&format!("{}.e57", db.name()));
    let (model, stations) = (project("demo/pavilion.ifc"), project("demo/stations.txt"));
    db.asbuilt(&["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "20", "--out", text(&file)]);
    file
}

/// What is planted beside what the program means to call; with the extension in another schema, and in that one.
fn plants() -> Vec<(&'static str, String)> {
    let model = "loa ext.ab_loa, model text, spacing text, sigma_range text, sigma_angle text, sigma_station text, confidence text";
    let verify = "objects text, scans text, keep_evidence boolean";
    let verify = format!("ab_verify_table({verify}, OUT id bigint, OUT verdict text)");
    vec![
        ("model", evil(&format!("ab_evidence_model({model})"), "ext.ab_evidence_model")),
        ("pose", evil("ab_pose(float8[], float8[])", "ext.ab_pose")),
        ("verify", evil(&verify, "SETOF record")),
        ("format", evil("format(text, text, text, float8, float8, float8, float8, float8, bigint[])", "text")),
        ("format int", evil("format(text, integer)", "text")),
        (
            "array_agg",
            evil("acc(bigint[], bigint)", "bigint[]")
                + "CREATE AGGREGATE public.array_agg(bigint) (SFUNC = public.acc, STYPE = bigint[])",
        ),
        ("area", evil("ab_area(ext.ab_solid)", "float8")),
        ("point box", evil("ab_point_box(ext.ab_scan)", "ext.ab_box")),
        ("grid", evil("ab_grid(float8, ext.ab_box, float8, float8, boolean)", "ext.ab_grid")),
        ("change", evil("ab_change(ext.ab_occupancy, ext.ab_occupancy, integer, float8)", "ext.ab_change")),
        ("solid send", evil("_ab_solid_send(ext.ab_solid)", "bytea")),
        ("hashtext", evil("hashtext(text)", "integer")),
        ("to_regclass", evil("to_regclass(text)", "regclass")),
        ("lock", evil("pg_advisory_xact_lock(integer, integer)", "void")),
        ("lock of one", evil("pg_advisory_xact_lock(bigint)", "void")),
        ("set_config", evil("set_config(text, text, boolean)", "text")),
        ("current_schemas", evil("current_schemas(boolean)", "name[]")),
        ("role", evil("pg_has_role(oid, text)", "boolean")),
        ("floor", evil("floor(float8)", "float8")),
        ("overlap", evil_operator("&&", "ext.ab_scan", "ext.ab_solid")),
        ("overlap box", evil_operator("&&", "ext.ab_scan", "ext.ab_box")),
        ("equal int4", evil_operator("=", "integer", "integer")),
        ("equal text", evil_operator("=", "text", "text")),
        ("equal name", evil_operator("=", "name", "name")),
        ("equal oid", evil_operator("=", "oid", "oid")),
        ("text || integer", evil_operator("||", "text", "integer")),
        ("text || text", evil_operator("||", "text", "text")),
        ("float8 / float8", evil_operator("/", "float8", "float8")),
        (
            "domain over a type",
            evil("g(ext.ab_loa)", "boolean") + "CREATE DOMAIN public.ab_loa AS ext.ab_loa CHECK (public.g(VALUE))",
        ),
        (
            "type",
            evil("h(text)", "boolean")
                + "CREATE DOMAIN public.int4 AS pg_catalog.int4 CHECK (public.h(VALUE::pg_catalog.text))",
        ),
        (
            "type text",
            evil("k(pg_catalog.text)", "boolean")
                + "CREATE DOMAIN public.text AS pg_catalog.text CHECK (public.k(VALUE))",
        ),
    ]
}

fn all_commands(db: &Database, user: &str, path: &str, scan: &str, plant: &str) {
    let model = project("demo/pavilion.ifc");
    for args in [
        &["load", text(&model), scan][..],
        &["load", scan, "--epoch", "2"],
        &["verify", "--spacing", "0.2", "--sensor", "hybrid", "--confidence", "0.9"],
        &["change", "--from", "1", "--to", "2", "--voxel", "0.1"],
        &["change", "--model", "--to", "2", "--voxel", "0.1"],
    ] {
        let out = db.command_as(user, path, args).output().unwrap();
        if std::env::var("EACH_PLANT").is_ok() && !out.status.success() {
            eprintln!("called: {plant}, {path}, {args:?}: {}", said(&out));
            return;
        }
        assert!(out.status.success(), "{plant}, {path}, {args:?}: {}", said(&out));
    }
}

#[test]
fn planted_functions_operators_and_types_are_not_called() {
    let db = database("hijack");
    let roles = Roles::new(&db, &["alice", "mallory"]);
    let mut root = db.connect();
    root.batch_execute(&format!("ALTER DATABASE {} OWNER TO {}", db.name(), &roles[0])).unwrap();
    let scan = scan(&db);
    let mut mallory = db.connect_as(&roles[1]);
    // All at once; one by one where somebody wants to know which of them old code would have called.
    let plants = plants();
    let groups: Vec<&[(&str, String)]> =
        if std::env::var("EACH_PLANT").is_ok() { plants.chunks(1).collect() } else { vec![&plants] };
    for group in groups {
        mallory.batch_execute("SET search_path = pg_catalog").unwrap();
        for (plant, sql) in group {
            mallory.batch_execute(sql).unwrap_or_else(|e| panic!("{plant}: {e:?}"));
        }
        // Even where the user's own path puts others' schemas first, our statements are ours.
        for path in ["public,ext", "public,pg_catalog,ext"] {
            all_commands(&db, &roles[0], path, text(&scan), group[0].0);
        }
        mallory.batch_execute("DROP OWNED BY CURRENT_USER CASCADE").unwrap();
        root.batch_execute(&format!("GRANT ALL ON SCHEMA public TO {}", &roles[1])).unwrap();
    }
    std::fs::remove_file(scan).unwrap();
}

/// The extension in the schema in which others plant: every call has the exact types.
#[test]
fn plants_beside_the_extension() {
    let db = Database::new("hijack_beside");
    let roles = Roles::new(&db, &["alice", "mallory"]);
    let mut root = db.connect();
    root.batch_execute(&format!("ALTER DATABASE {} OWNER TO {}", db.name(), &roles[0])).unwrap();
    // Before the extension is made, which alice does by her first load.
    let mut mallory = db.connect_as(&roles[1]);
    mallory.batch_execute(&evil("ab_pose(float8[])", "float8")).unwrap();
    mallory.batch_execute(&evil("ab_area(text)", "float8")).unwrap();
    let scan = scan(&db);
    all_commands(&db, &roles[0], "public", text(&scan), "before the extension");
    let model = "loa ab_loa, model text, spacing text, sigma_range text, sigma_angle text, sigma_station text, confidence text, reach text";
    let plants = [
        evil(&format!("ab_evidence_model({model})"), "ab_evidence_model"),
        evil("ab_pose(text, text)", "ab_pose"),
        evil("ab_expand(ab_box, integer)", "ab_box"),
        evil("ab_tiles(ab_box, numeric)", "SETOF ab_box"),
        evil("ab_grid(numeric, ab_box, integer)", "ab_grid"),
        evil("format(text, text, text, float8, float8, float8, float8, float8, bigint[])", "text"),
        evil("acc(bigint[], bigint)", "bigint[]")
            + "CREATE AGGREGATE public.array_agg(bigint) (SFUNC = public.acc, STYPE = bigint[])",
        evil_operator("||", "text", "integer"),
        evil_operator("&&", "ab_scan", "text"),
    ];
    for sql in plants {
        mallory.batch_execute(&sql).unwrap_or_else(|e| panic!("{sql}: {e:?}"));
    }
    all_commands(&db, &roles[0], "public", text(&scan), "beside the extension");
    // One that fits as well as ours is not called either: PostgreSQL does not know which is meant.
    let model = "loa ab_loa, model text, spacing float8, sigma_range float8, sigma_angle float8, sigma_station float8, confidence float8, reach float8";
    mallory.batch_execute(&evil(&format!("ab_evidence_model({model})"), "ab_evidence_model")).unwrap();
    let out = db.command_as(&roles[0], "public", &["verify", "--spacing", "0.2"]).output().unwrap();
    assert!(
        !out.status.success() && said(&out).contains("not unique") && !said(&out).contains("HIJACKED"),
        "{}",
        said(&out)
    );
    std::fs::remove_file(scan).unwrap();
}

/// Columns like those of the program's tables.
const STATION: &str = "CREATE TABLE public.station (id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY, epoch integer NOT NULL, name text NOT NULL, pose ext.ab_pose, sensor text, source text NOT NULL);";

#[test]
fn tables_of_others_are_refused() {
    let db = database("hijack_tables");
    let roles = Roles::new(&db, &["alice", "mallory", "team"]);
    let mut root = db.connect();
    root.batch_execute(&format!(
        "ALTER DATABASE {} OWNER TO {}; CREATE SCHEMA mine AUTHORIZATION {1}",
        db.name(),
        &roles[0],
    ))
    .unwrap();
    let scan = scan(&db);
    let load = |user: &str, more: &[&str]| {
        let out = db.command_as(user, "public,ext", &[&["load", text(&scan)][..], more].concat()).output().unwrap();
        (out.status.success(), said(&out))
    };
    let mut mallory = db.connect_as(&roles[1]);
    let trigger = "CREATE TRIGGER t BEFORE INSERT ON public.station FOR EACH ROW EXECUTE FUNCTION public.t();";
    mallory.batch_execute(&evil("t()", "trigger")).unwrap();
    mallory.batch_execute(&format!("{STATION} GRANT ALL ON public.station TO PUBLIC; {trigger}")).unwrap();
    // A superuser is not taken in either, although PostgreSQL says that it is a member of every role.
    for user in [&roles[0], "postgres"] {
        let (done, said) = load(user, &[]);
        assert!(!done && said.contains(&format!("belongs to {}", &roles[1])), "{said}");
        assert!(said.contains("--schema") && !said.contains("HIJACKED"), "{said}");
    }
    // Beside them, in a schema of her own, alice works.
    assert!(load(&roles[0], &["--schema", "mine"]).0);
    for command in [&["verify", "--spacing", "0.2"][..], &["change", "--from", "1", "--to", "1", "--voxel", "0.1"]] {
        let args = [command, &["--schema", "mine"]].concat();
        let out = db.command_as(&roles[0], "public,ext", &args).output().unwrap();
        assert!(out.status.success(), "{args:?}: {}", said(&out));
        let out = db.command_as(&roles[0], "public,ext", command).output().unwrap();
        assert!(said(&out).contains("belongs to"), "{}", said(&out));
    }
    root.batch_execute("DROP TABLE public.station").unwrap();
    // Other things under the name of a table.
    for (sql, expected) in [
        ("CREATE VIEW public.scan AS SELECT 1 AS station_id", "belongs to"),
        ("CREATE TABLE public.scan (a int)", "belongs to"),
        ("CREATE TABLE public.asbuilt_layout (layout int); CREATE TABLE public.scan (a int)", "belongs to"),
    ] {
        mallory.batch_execute(sql).unwrap();
        let (done, said) = load(&roles[0], &[]);
        assert!(!done && said.contains(expected), "{sql}: {said}");
        let _ = mallory.batch_execute("DROP VIEW IF EXISTS public.scan");
        let _ = mallory.batch_execute("DROP TABLE IF EXISTS public.scan, public.asbuilt_layout");
        let _ = mallory.batch_execute("DROP TABLE public.scan");
    }
    let mut alice = db.connect_as(&roles[0]);
    alice.batch_execute("CREATE VIEW public.scan AS SELECT 1 AS station_id").unwrap();
    let (done, said) = load(&roles[0], &[]);
    assert!(!done && said.contains("is no table") && said.contains("--schema"), "{said}");
    alice.batch_execute("DROP VIEW public.scan").unwrap();
    // A role that alice is a member of is trusted.
    root.batch_execute(&format!(
        "{STATION} ALTER TABLE public.station OWNER TO {}; GRANT {0} TO {}",
        &roles[2], &roles[0]
    ))
    .unwrap();
    let (done, said) = load(&roles[0], &[]);
    assert!(done, "{said}");
    // Who may make triggers on it runs nothing as others.
    root.batch_execute(&format!("GRANT TRIGGER ON public.station TO {}", &roles[1])).unwrap();
    mallory.batch_execute(trigger).unwrap();
    let (done, said) = load(&roles[0], &[]);
    assert!(!done && said.contains("trigger") && !said.contains("HIJACKED"), "{said}");
    std::fs::remove_file(scan).unwrap();
}
