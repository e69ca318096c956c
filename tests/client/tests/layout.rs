//! Tables of older programs are brought up to date by those who may do it, and no row is lost.

use std::process::Output;

use asbuilt_client_tests::{Database, Roles, project, scratch, text};
use postgres::Client;

/// The tables as 0.1.0 creates them, and every program before scan had a key.
const OLD: &str = "
CREATE TABLE building_object (
    id         bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    global_id  text NOT NULL,
    ifc_class  text NOT NULL,
    name       text NOT NULL,
    storey     text,
    loa        ab_loa NOT NULL,
    solid      ab_solid,
    properties jsonb NOT NULL,
    source     text NOT NULL,
    UNIQUE (source, global_id)
);
CREATE INDEX building_object_solid_idx ON building_object USING gist (solid);
COMMENT ON TABLE building_object IS 'Objects of the building model; solid is NULL where the geometry could not be meshed';
CREATE TABLE station (
    id     bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    epoch  integer NOT NULL,
    name   text NOT NULL,
    pose   ab_pose,
    sensor text,
    source text NOT NULL
);
CREATE INDEX station_epoch_idx ON station (epoch);
CREATE TABLE scan (
    station_id bigint NOT NULL REFERENCES station ON DELETE CASCADE,
    epoch      integer NOT NULL,
    patch      ab_scan NOT NULL
);
CREATE INDEX scan_patch_idx ON scan USING gist (patch);
CREATE INDEX scan_station_idx ON scan (station_id);
INSERT INTO building_object (global_id, ifc_class, name, loa, solid, properties, source)
SELECT 'g' || i, 'IfcWall', 'wall ' || i, 'LOA30', ab_solid(ab_box(5 + 0.002 * i, i - 2, 1, 5.2, i - 1, 2)), '{}', 'old.ifc' FROM generate_series(1, 3) i;
INSERT INTO station (epoch, name, pose, source) SELECT 1, 's' || i, ab_pose(ARRAY[0, 0.5 * i, 1.5]::float8[]), 'old.e57' FROM generate_series(0, 2) i;
INSERT INTO scan
SELECT st + 1, 1, ab_scan(ARRAY[0, 0.5 * st, 1.5]::float8[], array_agg(ARRAY[5, 0.5 * st + 0.02 * i, 1.5 + 0.02 * j]::float8[] ORDER BY i, j), 0.004, st + 1)
FROM generate_series(0, 2) st, generate_series(-25, 25) i, generate_series(-25, 25) j GROUP BY st;
CREATE VIEW seen AS SELECT * FROM scan WHERE epoch = 1;";

/// All rows, whatever the order of columns.
const ROWS: &str = "SELECT concat((SELECT md5(string_agg(b::text, ';' ORDER BY id)) FROM building_object b),
    (SELECT md5(string_agg(concat(id, epoch, name, pose, sensor, source), ';' ORDER BY id)) FROM station),
    (SELECT md5(string_agg(concat(station_id, epoch, patch), ';' ORDER BY station_id, patch::text)) FROM scan), (SELECT count(*) FROM seen))";

fn rows(client: &mut Client) -> String {
    client.query_one(ROWS, &[]).unwrap().get(0)
}

fn said(out: &Output) -> String {
    String::from_utf8_lossy(&out.stderr).into_owned()
}

fn file(name: &str) -> std::path::PathBuf {
    let file = scratch(name);
    std::fs::write(&file, (0..400).map(|i| format!("5.0 {:.3} 1.5\n", f64::from(i) * 0.001)).collect::<String>())
        .unwrap();
    file
}

/// The recorded layout, the number of keys of scan, and whether they are its primary key.
fn layout(client: &mut Client) -> (i32, i64, bool) {
    let sql = "SELECT (SELECT layout FROM asbuilt_layout), (SELECT count(DISTINCT id) FROM scan),
        EXISTS (SELECT FROM pg_index WHERE indrelid = 'scan'::regclass AND indisprimary)";
    let row = client.query_one(sql, &[]).unwrap();
    (row.get(0), row.get(1), row.get(2))
}

/// How many stations tell who knows their origin, and how many columns with comments there are for it.
fn origins(client: &mut Client) -> String {
    let sql = "SELECT format('%s of %s, %s columns with comments', count(origin_source), count(*),
        (SELECT count(col_description(attrelid, attnum)) FROM pg_attribute
         WHERE attrelid = 'station'::regclass AND attname IN ('origin_source', 'origin_sd'))) FROM station";
    client.query_one(sql, &[]).unwrap().get(0)
}

#[test]
fn the_owner_migrates() {
    let (db, mut client) = Database::with_extension("layout_owner");
    client.batch_execute(OLD).unwrap();
    let before = rows(&mut client);
    // Who only looks changes nothing.
    assert_eq!(db.verify(&["--spacing", "0.1"]).len(), 3);
    db.asbuilt(&["change", "--from", "1", "--to", "1", "--voxel", "0.1"]);
    let there: bool = client.query_one("SELECT to_regclass('asbuilt_layout') IS NOT NULL", &[]).unwrap().get(0);
    assert!(!there);
    // A file that fails leaves the migration, which stands for itself.
    let bad = scratch("layout_bad.xyz");
    std::fs::write(&bad, "1 2 3\nx\n").unwrap();
    let said = db.asbuilt_fails(&["load", text(&bad)]);
    assert!(said.contains("brought to layout 2") && said.contains("primary key id"), "{said}");
    assert!(said.contains("brought to layout 3") && said.contains("origin_source"), "{said}");
    assert_eq!(rows(&mut client), before);
    assert_eq!(layout(&mut client), (3, 3, true));
    assert_eq!(origins(&mut client), "0 of 3, 2 columns with comments");
    let said = db.asbuilt(&["load", text(&file("layout_new.xyz"))]);
    assert!(!said.contains("brought to"), "{said}");
    assert_eq!(layout(&mut client), (3, 4, true));
    // What a key is for: a published table is replaced.
    client
        .batch_execute("CREATE PUBLICATION p FOR TABLE scan; DELETE FROM scan WHERE station_id = 4; DROP PUBLICATION p")
        .unwrap();
    // A newer program's tables are left alone.
    client.batch_execute("UPDATE asbuilt_layout SET layout = 4").unwrap();
    for args in [&["load", text(&file("layout_new.xyz"))][..], &["verify"], &["change", "--from", "1", "--to", "1"]] {
        let said = db.asbuilt_fails(args);
        assert!(said.contains("layout 4") && said.contains("newer"), "{said}");
    }
}

#[test]
fn a_new_database_has_a_key_and_its_layout() {
    let db = Database::new("layout_new");
    db.asbuilt(&["load", text(&file("fresh.xyz"))]);
    let mut client = db.connect();
    assert_eq!(layout(&mut client), (3, 1, true));
    assert_eq!(origins(&mut client), "0 of 1, 2 columns with comments");
    let identity: String = client
        .query_one(
            "SELECT attidentity::text FROM pg_attribute WHERE attrelid = 'scan'::regclass AND attname = 'id'",
            &[],
        )
        .unwrap()
        .get(0);
    assert_eq!(identity, "a");
    // No column is a word that SQL keeps.
    let kept = "SELECT coalesce(string_agg(attname, ', '), '') FROM pg_attribute JOIN pg_get_keywords() ON word = attname
        WHERE attrelid IN ('building_object'::regclass, 'station'::regclass, 'scan'::regclass, 'asbuilt_layout'::regclass)
        AND attnum > 0 AND (catcode = 'R' OR catcode = 'C' AND word <> 'position')";
    assert_eq!(client.query_one(kept, &[]).unwrap().get::<_, String>(0), "");
    // Dumped and restored it is known again.
    let back = db.dumped_and_restored("layout_back");
    assert!(!back.asbuilt(&["load", text(&file("fresh.xyz"))]).contains("brought to"));
}

/// The database of 0.1.0, with its extension not yet updated, dumped and restored.
#[test]
fn a_database_of_0_1_0_is_migrated() {
    let db = Database::new("layout_010");
    let mut client = db.connect();
    client.batch_execute("CREATE EXTENSION asbuilt VERSION '0.1.0'").unwrap();
    client.batch_execute(OLD).unwrap();
    let said = db.asbuilt(&["load", text(&file("layout_010.xyz"))]);
    assert!(said.contains("brought to layout 2") && said.contains("ALTER EXTENSION asbuilt UPDATE"), "{said}");
    client.batch_execute("ALTER EXTENSION asbuilt UPDATE; DELETE FROM station WHERE source <> 'old.e57'").unwrap();
    let before = rows(&mut client);
    assert_eq!(db.verify(&["--spacing", "0.1"]).len(), 3);
    let back = db.dumped_and_restored("layout_010_back");
    let mut client = back.connect();
    assert_eq!(rows(&mut client), before);
    assert_eq!(layout(&mut client), (3, 3, true));
}

/// Tables as programs before station told how origins are known made them, dumped and restored.
#[test]
fn a_database_of_layout_2_is_migrated() {
    let (db, mut client) = Database::with_extension("layout_2");
    client.batch_execute(OLD).unwrap();
    client
        .batch_execute(
            "ALTER TABLE scan ADD COLUMN id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY;
             CREATE TABLE asbuilt_layout (layout integer NOT NULL, one boolean NOT NULL DEFAULT true CHECK (one) PRIMARY KEY);
             INSERT INTO asbuilt_layout VALUES (2)",
        )
        .unwrap();
    let before = rows(&mut client);
    let back = db.dumped_and_restored("layout_2_back");
    let mut client = back.connect();
    // Who only looks needs no migration.
    assert_eq!(back.verify(&["--spacing", "0.1"]).len(), 3);
    let said = back.asbuilt(&["load", text(&file("layout_2.xyz")), "--origin", "0,0,1.5"]);
    assert!(said.contains("brought to layout 3") && !said.contains("layout 2"), "{said}");
    let given = "SELECT count(*) FROM station WHERE origin_source = 'given' AND origin_sd IS NULL AND pose IS NOT NULL";
    assert_eq!(client.query_one(given, &[]).unwrap().get::<_, i64>(0), 1);
    client.batch_execute("DELETE FROM station WHERE source <> 'old.e57'").unwrap();
    assert_eq!(rows(&mut client), before);
    assert_eq!(origins(&mut client), "0 of 3, 2 columns with comments");
    // A column of the user's own in the way.
    client
        .batch_execute("ALTER TABLE station DROP COLUMN origin_sd; ALTER TABLE station ADD COLUMN origin_sd text")
        .unwrap();
    let said = back.asbuilt_fails(&["load", text(&file("layout_2.xyz"))]);
    assert!(said.contains("RENAME COLUMN origin_sd"), "{said}");
}

#[test]
fn a_member_of_the_owning_role_migrates_and_others_are_told() {
    let (db, mut client) = Database::with_extension("layout_roles");
    let roles = Roles::new(&db, &["member", "stranger", "team"]);
    client.batch_execute(OLD).unwrap();
    // Not even a member that inherits nothing needs more than to be one.
    client.batch_execute(&format!(
        "ALTER TABLE building_object OWNER TO {team}; ALTER TABLE station OWNER TO {team}; ALTER TABLE scan OWNER TO {team};
         ALTER VIEW seen OWNER TO {team}; ALTER ROLE {member} NOINHERIT; GRANT {team} TO {member};
         GRANT SELECT, INSERT, DELETE ON building_object, station, scan TO {member}, {stranger};
         ALTER DATABASE {} OWNER TO {team}", db.name(), team = &roles[2], member = &roles[0], stranger = &roles[1])).unwrap();
    let before = rows(&mut client);
    let new = file("layout_role.xyz");
    let load = |role: &str| {
        let out = db.command(&["load", text(&new)]).env("PGUSER", role).output().unwrap();
        (out.status.success(), said(&out))
    };
    let (done, said) = load(&roles[1]);
    assert!(!done && said.contains(&roles[2]), "{said}");
    let statement = said.split("or: ").nth(1).unwrap().trim().to_owned();
    assert!(statement.starts_with("ALTER TABLE \"public\".\"scan\" ADD COLUMN id bigint"), "{said}");
    assert_eq!(rows(&mut client), before);
    let (done, said) = load(&roles[0]);
    assert!(done && said.contains("brought to layout 2"), "{said}");
    let owner: String = client
        .query_one("SELECT tableowner::text FROM pg_tables WHERE tablename = 'asbuilt_layout'", &[])
        .unwrap()
        .get(0);
    assert_eq!(owner, &roles[2]);
    assert!(load(&roles[1]).0, "now a stranger with rights on the tables loads too");
    client.batch_execute("DELETE FROM station WHERE source LIKE '%layout_role.xyz'").unwrap();
    assert_eq!(rows(&mut client), before);
    // The statement that was named is enough.
    client.batch_execute("DROP VIEW seen; ALTER TABLE scan DROP COLUMN id; DROP TABLE asbuilt_layout").unwrap();
    assert!(!load(&roles[1]).0);
    client.batch_execute(&statement).unwrap();
    let (done, said) = load(&roles[1]);
    assert!(done, "{said}");
    let (done, said) = load(&roles[0]);
    assert!(done, "{said}");
    assert_eq!(layout(&mut client).0, 3);
    drop(client);
}

/// Loaders that start at the same time migrate once.
#[test]
fn at_the_same_time() {
    let (db, mut client) = Database::with_extension("layout_race");
    client.batch_execute(OLD).unwrap();
    let files: Vec<_> = (0..4).map(|i| file(&format!("race{i}.xyz"))).collect();
    let start =
        |f: &std::path::PathBuf| db.command(&["load", text(f)]).stderr(std::process::Stdio::piped()).spawn().unwrap();
    let all: Vec<_> = files.iter().map(start).collect();
    let said: Vec<String> = all
        .into_iter()
        .map(|child| {
            let out = child.wait_with_output().unwrap();
            assert!(out.status.success(), "{}", said(&out));
            said(&out)
        })
        .collect();
    assert_eq!(said.iter().filter(|s| s.contains("brought to layout 2")).count(), 1, "{said:?}");
    assert_eq!(layout(&mut client), (3, 7, true));
}

/// Tables of these names that are something else are not touched.
#[test]
fn tables_that_are_not_ours() {
    let (db, mut client) = Database::with_extension("layout_other");
    let new = file("layout_other.xyz");
    for (table, expected) in [
        ("scan (id bigint, station_id bigint, epoch integer, patch bytea)", "no column patch of type ab_scan"),
        ("station (id integer, name text)", "no column id of type int8"),
        ("building_object (id bigint, name varchar(20))", "no column"),
        ("asbuilt_layout (version text)", "no column layout"),
    ] {
        client.batch_execute(&format!("CREATE TABLE {table}")).unwrap();
        let said = db.asbuilt_fails(&["load", text(&new)]);
        assert!(said.contains(expected) && said.contains("--schema"), "{table}: {said}");
        let name = table.split(' ').next().unwrap();
        client.batch_execute(&format!("DROP TABLE {name}")).unwrap();
    }
    // Beside them, in a schema of their own.
    client
        .batch_execute("CREATE TABLE scan (picture bytea); INSERT INTO scan VALUES ('x'); CREATE SCHEMA \"it's 100%\"")
        .unwrap();
    let said = db.asbuilt_fails(&["load", text(&new), "--schema", "nowhere"]);
    assert!(said.contains("CREATE SCHEMA \"nowhere\""), "{said}");
    db.asbuilt(&["load", text(&project("demo/pavilion.ifc")), text(&new), "--schema", "it's 100%"]);
    assert_eq!(db.verify(&["--schema", "it's 100%", "--spacing", "0.2"]).len(), 13);
    db.asbuilt(&["change", "--model", "--to", "1", "--voxel", "0.1", "--schema", "it's 100%"]);
    assert_eq!(client.query_one("SELECT count(*) FROM scan", &[]).unwrap().get::<_, i64>(0), 1);
    // A column of the user's own in the way of the key.
    client.batch_execute("DROP TABLE scan").unwrap();
    client.batch_execute(OLD).unwrap();
    client.batch_execute("ALTER TABLE scan ADD COLUMN id text").unwrap();
    let said = db.asbuilt_fails(&["load", text(&new)]);
    assert!(said.contains("RENAME COLUMN id"), "{said}");
}
