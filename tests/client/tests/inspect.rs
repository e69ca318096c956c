//! What files are reported to hold, without a database; and dry runs of loading.

use std::fs;

use asbuilt_client_tests::{Database, project, scratch, text};
use serde_json::Value;

/// Runs inspect where there is no server.
fn inspect(db: &Database, args: &[&str]) -> (bool, Value) {
    let args = [&["inspect", "--format", "json"], args].concat();
    let out = db.command(&args).env("PGHOST", "/nowhere").output().unwrap();
    (out.status.success(), serde_json::from_slice(&out.stdout).unwrap())
}

const POINTS: &str = "1.25 2.5 0.75\n1.5 2.5 0.75\n1.75 2.5 0.75\n1.25 2.75 0.75\n1.5 2.75 1\n";

#[test]
fn files_are_told_without_a_database() {
    let db = Database::new("inspect");
    let points = scratch("inspect.txt");
    fs::write(&points, POINTS).unwrap();
    let damaged = scratch("inspect.e57");
    fs::write(&damaged, "this is no E57").unwrap();
    let model = project("demo/pavilion.ifc");
    let (success, found) = inspect(&db, &[text(&points), text(&model), "--file-unit", "ft"]);
    assert!(!success);
    // The model tells its own unit.
    assert!(found[1]["error"].as_str().unwrap().contains("--file-unit says feet"), "{}", found[1]);
    let scan = &found[0]["scans"][0];
    assert_eq!((&scan["returns"], &scan["origin"]), (&Value::from(5), &Value::Null), "{scan}");
    assert!((scan["box"][1][0].as_f64().unwrap() - 1.75 * 0.3048).abs() < 1e-4, "{scan}");
    assert_eq!(scan["facts"]["columns"], "x,y,z");
    let (success, alone) = inspect(&db, &[text(&model)]);
    assert!(success && alone[0]["model"]["products"].as_u64().unwrap() > 10, "{}", alone[0]);
    let (success, found) = inspect(&db, &[text(&damaged)]);
    assert!(!success && found[0]["error"].as_str().unwrap().contains("not a readable E57 file"), "{}", found[0]);
    // For people.
    let out = db.command(&["inspect", text(&points)]).env("PGHOST", "/nowhere").output().unwrap();
    let said = String::from_utf8(out.stdout).unwrap();
    assert!(out.status.success() && said.contains("returns: 5") && said.contains("origin: not known"), "{said}");
    [points, damaged].iter().for_each(|file| fs::remove_file(file).unwrap());
}

#[test]
fn a_dry_run_leaves_nothing() {
    let db = Database::new("dry_run");
    let points = scratch("dry_run.xyz");
    fs::write(&points, POINTS).unwrap();
    let model = project("demo/pavilion.ifc");
    let said = db.asbuilt(&["load", "--dry-run", text(&model), text(&points)]);
    assert!(said.contains("5 beams") && said.contains("nothing was loaded"), "{said}");
    let there: Option<String> =
        db.connect().query_one("SELECT pg_catalog.to_regclass('building_object')::text", &[]).unwrap().get(0);
    assert_eq!(there, None);
    // Where something is loaded, it stays as it is.
    db.asbuilt(&["load", text(&points)]);
    let said = db.asbuilt(&["load", "--dry-run", text(&points)]);
    assert!(said.contains("replaces 1 stations"), "{said}");
    let count = "SELECT (SELECT count(*) FROM station) * 100 + sum(ab_count(patch)) FROM scan";
    let row = db.connect().query_one(&format!("SELECT ({count})::bigint"), &[]).unwrap();
    assert_eq!(row.get::<_, i64>(0), 105);
    fs::write(&points, "no points").unwrap();
    assert!(db.asbuilt_fails(&["load", "--dry-run", text(&points)]).contains("1 of 1 files cannot be loaded"));
    fs::remove_file(points).unwrap();
}
