//! The program as people live with it: filters, order, sums, exit status, units, explanations, what is loaded, and
//! removing it.

use std::collections::BTreeMap;
use std::process::{Output, Stdio};

use asbuilt_client_tests::{Database, project, scratch, text};
use serde_json::Value;

/// The demo building, built as demo/changes.json says, in epochs 1 and 2.
fn demo(name: &str) -> Database {
    let db = Database::new(name);
    let (model, scan) = (project("demo/pavilion.ifc"), scratch(&format!("{name}.e57")));
    let (stations, changes) = (project("demo/stations.txt"), project("demo/changes.json"));
    let simulate = ["simulate", text(&model), "--stations", text(&stations), "--built", text(&changes)];
    db.asbuilt(&[&simulate[..], &["--step-mrad", "10", "--out", text(&scan)]].concat());
    db.asbuilt(&["load", text(&model), text(&scan)]);
    db.asbuilt(&["load", text(&scan), "--epoch", "2"]);
    std::fs::remove_file(scan).unwrap();
    db
}

const VERIFY: [&str; 3] = ["verify", "--spacing", "0.05"];

fn run(db: &Database, args: &[&str]) -> Output {
    db.command(args).output().unwrap()
}

/// What it printed; it must succeed.
fn printed(db: &Database, args: &[&str]) -> String {
    let out = run(db, args);
    assert!(out.status.success(), "{args:?}: {}", String::from_utf8_lossy(&out.stderr));
    String::from_utf8(out.stdout).unwrap()
}

fn json(db: &Database, args: &[&str]) -> Vec<Value> {
    serde_json::from_str(&printed(db, &[&VERIFY, args, &["--format", "json"]].concat())).unwrap()
}

fn names(rows: &[Value]) -> Vec<&str> {
    rows.iter().map(|r| r["name"].as_str().unwrap()).collect()
}

/// A filter chooses what is printed; what is known of an object does not change by a digit.
#[test]
fn filters_choose_and_change_nothing() {
    let db = demo("filters");
    let all = json(&db, &[]);
    assert_eq!(all.len(), 13);
    let id = |name: &str| all.iter().find(|r| r["name"] == name).unwrap()["id"].to_string();
    let global_id = all[3]["global_id"].as_str().unwrap();
    let both = format!("{},{global_id}", id("column B"));
    let walls = ["wall south", "wall north", "wall west", "wall east", "partition", "screen wall"];
    let east = ["--exclude", &id("wall east")].map(str::to_owned);
    for (args, expected) in [
        (vec!["--class", "IfcColumn"], vec!["column A", "column B", "column C"]),
        (vec!["--class", "ifccolumn", "--name", "*B"], vec!["column B"]),
        (vec!["--name", "column A", "--name", "beam"], vec!["column A", "beam"]),
        (vec!["--only", &both], vec!["column B", all[3]["name"].as_str().unwrap()]),
        (vec!["--class", "IfcWall*", &east[0], &east[1]], walls.into_iter().filter(|w| *w != "wall east").collect()),
        (vec!["--where", "o.name LIKE 'column%' AND o.id > 0 -- a remark"], vec!["column A", "column B", "column C"]),
    ] {
        let rows = json(&db, &args);
        let mut expected: Vec<&str> = expected;
        expected.sort_by_key(|n| all.iter().position(|r| r["name"] == **n));
        assert_eq!(names(&rows), expected, "{args:?}");
        for row in &rows {
            assert!(all.contains(row), "{args:?}: {row}");
        }
    }
    for (args, said) in [
        (["--class", "IfcPile"], "the classes are IfcBeam, IfcBuildingElementProxy"),
        (["--name", "nobody"], "the names are beam"),
        (["--only", "4711"], "no object has the id or GlobalId 4711"),
        (["--where", "o.nothing = 1"], "column o.nothing does not exist"),
        (["--where", "true); DELETE FROM scan; SELECT (1"], "multiple commands"),
        (
            ["--where", "pg_catalog.set_config('asbuilt.x', nextval('building_object_id_seq')::text, false) > ''"],
            "read-only",
        ),
    ] {
        let said_of_it = db.asbuilt_fails(&[&VERIFY, &args[..]].concat());
        assert!(said_of_it.contains(said), "{args:?}: {said_of_it}");
    }
}

#[test]
fn order_sum_units_and_exit_status() {
    let db = demo("sums");
    let table = |args: &[&str]| printed(&db, &[&VERIFY, args].concat());
    let whole = table(&["--sort", "verdict"]);
    let lines: Vec<&str> = whole.lines().collect();
    assert!(lines[2].contains("column C") && lines[2].contains("absent"), "{whole}");
    assert!(whole.ends_with("(13 objects: 9 confirmed, 1 unobserved, 2 deviating, 1 absent)\n"), "{whole}");
    let some = table(&["--class", "IfcColumn"]);
    assert!(some.ends_with("(3 of 13 objects: 1 confirmed, 1 deviating, 1 absent)\n"), "{some}");
    assert!(lines[0].contains("| deviation_mm | deviation_sd_mm |") && lines[0].trim_start().starts_with("id"));
    // The same lengths in either unit.
    let (metres, millimetres) = (json(&db, &[]), json(&db, &["--units", "mm"]));
    let mut compared = 0;
    for (m, mm) in metres.iter().zip(&millimetres) {
        let [a, b] = [(m, "deviation_m"), (mm, "deviation_mm")].map(|(row, column)| row[column].as_f64());
        assert_eq!(a.map(|v| (v * 1e4).round()), b.map(|v| (v * 10.0).round()), "{m} {mm}");
        compared += u32::from(a.is_some());
        assert!(m.get("shift_sd_m").is_some() && mm.get("shift_mm").is_some());
    }
    assert!(compared > 8);
    let off: Vec<f64> =
        json(&db, &["--sort", "deviation"]).iter().map(|r| r["deviation_m"].as_f64().map_or(0.0, f64::abs)).collect();
    assert!(off.is_sorted_by(|a, b| a >= b) && off[0] > 0.02, "{off:?}");
    let status = |args: &[&str]| run(&db, &[&VERIFY, args].concat()).status.code();
    assert_eq!(status(&["--fail-on", "deviating,absent"]), Some(3));
    assert_eq!(status(&["--fail-on", "conflicting"]), Some(0));
    assert_eq!(status(&["--fail-on", "absent", "--name", "wall*"]), Some(0));
    assert_eq!(status(&["--fail-on", "gone"]), Some(2));
    assert_eq!(status(&["--epoch", "7", "--fail-on", "absent"]), Some(1));
}

/// Who reads the first line only is no error.
#[test]
fn a_closed_pipe_is_quiet() {
    let db = demo("pipe");
    for args in [&["verify", "--spacing", "0.2", "--format", "csv"][..], &["list"], &["list", "--format", "json"]] {
        let mut child = db.command(args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let out = child.wait_with_output().unwrap();
        assert_eq!(String::from_utf8_lossy(&out.stderr), "", "{args:?}");
        assert_ne!(out.status.code(), Some(101), "{args:?}");
    }
}

#[test]
fn an_object_is_explained_among_its_neighbours() {
    let db = demo("explained");
    let rows = json(&db, &[]);
    let of = |name: &str| rows.iter().find(|r| r["name"] == name).unwrap();
    let (b, c) = (of("column B")["id"].to_string(), of("column C")["global_id"].as_str().unwrap());
    let said = printed(&db, &["explain", &b, c, "--spacing", "0.05"]);
    let expected = |name: &str, verdict: &str| said.contains(&format!("{name} (IfcColumn")) && said.contains(verdict);
    assert!(expected("column B", "  Deviating at LOA30") && expected("column C", "  Absent at LOA30"), "{said}");
    let error = db.asbuilt_fails(&["explain", "4711"]);
    assert!(error.contains("no object has the id or GlobalId 4711") && error.contains("asbuilt verify"), "{error}");
}

/// Rows of a table by what names them.
fn listed(db: &Database, what: &[&str]) -> Vec<BTreeMap<String, Value>> {
    serde_json::from_str(&printed(db, &[&["list"], what, &["--format", "json"]].concat())).unwrap()
}

#[test]
fn what_is_loaded_is_listed_and_removed() {
    let db = demo("removed");
    let files = listed(&db, &[]);
    assert_eq!(files.len(), 3);
    assert_eq!(
        (&files[0]["kind"], &files[0]["file"], &files[0]["objects"]),
        (&"model".into(), &"pavilion.ifc".into(), &13.into())
    );
    assert_eq!(files[1..].iter().map(|f| f["epoch"].as_i64().unwrap()).collect::<Vec<_>>(), [1, 2]);
    assert!(files[1]["size_mb"].as_f64().unwrap() > 0.0 && files[1]["stations"] == 4);
    let stations = listed(&db, &["stations"]);
    assert!(stations.len() == 8 && stations.iter().all(|s| s["origin_source"] == "file"));
    // Without a terminal nothing is asked, and nothing goes.
    let error = db.asbuilt_fails(&["remove", "epoch", "2"]);
    assert!(error.contains("4 stations") && error.contains("--yes"), "{error}");
    assert_eq!(listed(&db, &[]).len(), 3);
    let said = db.asbuilt(&["remove", "epoch", "2", "--yes"]);
    assert!(said.contains("epoch 2: removed 4 stations, "), "{said}");
    let station = stations[0]["id"].to_string();
    assert!(db.asbuilt(&["remove", "station", &station, "--yes"]).contains("removed 1 station, "));
    assert_eq!(listed(&db, &["stations"]).len(), 3);
    let mut client = db.connect();
    let orphans: i64 = client
        .query_one("SELECT count(*) FROM scan WHERE station_id NOT IN (SELECT id FROM station)", &[])
        .unwrap()
        .get(0);
    assert_eq!(orphans, 0);
    assert!(db.asbuilt(&["remove", "file", "pavilion.ifc", "--yes"]).contains("removed 13 objects"));
    for (what, name) in
        [("epoch", "2"), ("file", "pavilion.ifc"), ("station", &station), ("epoch", "-1"), ("epoch", "x' OR true")]
    {
        let error = db.asbuilt_fails(&["remove", what, name, "--yes"]);
        assert!(error.contains(&format!("there is no {what} {name}")) && error.contains("asbuilt list"), "{error}");
    }
    assert_eq!(listed(&db, &[]).len(), 1);
}
