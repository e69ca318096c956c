//! `asbuilt change` against what was built, OctoMap's own count of a scan, and its exports.

use asbuilt_client_tests::{Database, project, scratch, shared, text};
use postgres::Client;
use serde_json::Value;

fn change(db: &Database, args: &[&str]) -> Value {
    let mut all = vec!["change", "--format", "json"];
    all.extend(args);
    let out = db.command(&all).output().unwrap();
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    serde_json::from_slice(&out.stdout).unwrap()
}

fn number(of: &Value, key: &str) -> f64 {
    of[key].as_f64().unwrap_or_else(|| panic!("no {key} in {of}"))
}

fn number_at(of: &Value, i: usize) -> f64 {
    of[i].as_f64().unwrap_or_else(|| panic!("no element {i} in {of}"))
}

fn object<'a>(report: &'a Value, name: &str) -> &'a Value {
    let objects = report["objects"].as_array().unwrap();
    objects.iter().find(|o| o["name"] == name).unwrap_or_else(|| panic!("no object {name}"))
}

/// Share of a class among the voxels of an object that both epochs saw.
fn share_of_seen(o: &Value, class: &str) -> f64 {
    number(o, class) / (number(o, "total") - number(o, "unknown"))
}

/// The largest component of a class whose centroid lies in a box.
fn component<'a>(report: &'a Value, class: &str, min: [f64; 3], max: [f64; 3]) -> &'a Value {
    let inside = |c: &&Value| (0..3).all(|i| (min[i]..max[i]).contains(&number(&c["centroid"], i)));
    fn number(v: &Value, i: usize) -> f64 {
        v[i].as_f64().unwrap()
    }
    let all = report["components"].as_array().unwrap();
    all.iter()
        .filter(|c| c["class"] == class)
        .find(inside)
        .unwrap_or_else(|| panic!("nothing {class} in {min:?} {max:?}"))
}

/// The demo building as drawn, and then as demo/changes.json says; always available.
#[test]
fn simulated_pavilion() {
    let db = Database::new("change_pavilion");
    let (model, stations) = (project("demo/pavilion.ifc"), project("demo/stations.txt"));
    let changes = project("demo/changes.json");
    db.asbuilt(&["load", text(&model)]);
    for (epoch, built) in [("1", None), ("2", Some(text(&changes)))] {
        let scan = scratch(&format!("change{epoch}.e57"));
        let mut args = vec!["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "4"];
        args.extend(["--seed", "5", "--out", text(&scan)]);
        args.extend(built.map(|b| ["--built", b]).into_iter().flatten());
        db.asbuilt(&args);
        db.asbuilt(&["load", text(&scan), "--epoch", epoch]);
        std::fs::remove_file(scan).unwrap();
    }
    let (ply, laz) = (scratch("change.ply"), scratch("change.laz"));
    let report = change(&db, &["--from", "1", "--to", "2", "--voxel", "0.02", "--export", text(&ply)]);
    // Its foot and head touch floor and roof, which stay.
    assert!(share_of_seen(object(&report, "column C"), "disappeared") > 0.85, "{}", object(&report, "column C"));
    // What became of each, as demo/changes.json says.
    let class = |name: &str| object(&report, name)["change"].as_str().unwrap_or_else(|| panic!("{name}")).to_owned();
    assert_eq!(class("column C"), "gone");
    for (name, moved) in [("partition", [Some(0.012), None]), ("column B", [Some(0.03), Some(-0.01)])] {
        let o = object(&report, name);
        assert_eq!(class(name), "moved", "{o}");
        for (axis, by) in moved.into_iter().enumerate() {
            let Some(by) = by else { continue };
            let (shift, sd) = (number_at(&o["shift_m"], axis), number_at(&o["shift_sd_m"], axis));
            assert!((shift - by).abs() < 3.0 * sd && sd < 0.004, "{o}");
        }
    }
    assert_eq!(class("wall east"), "moved", "{}", object(&report, "wall east"));
    for same in ["floor", "roof", "wall south", "wall north", "wall west", "screen wall", "column A"] {
        assert_eq!(class(same), "unchanged", "{}", object(&report, same));
    }
    for same in ["floor", "roof", "wall south", "wall north", "wall west", "screen wall", "column A", "partition"] {
        let o = object(&report, same);
        assert!(share_of_seen(o, "new") + share_of_seen(o, "disappeared") < 0.02, "{o}");
    }
    component(&report, "new", [0.9, 3.1, 0.0], [2.3, 4.1, 0.5]);
    let gone = report["components"].as_array().unwrap().iter().find(|c| c["objects"].to_string().contains("column C"));
    assert_eq!(gone.expect("column C comes out as a thing")["class"], "disappeared");

    // The same from tiles of 2 m: borders change nothing.
    let tiled = change(&db, &["--from", "1", "--to", "2", "--voxel", "0.02", "--tile", "2", "--export", text(&laz)]);
    for class in ["confirmed", "new", "disappeared", "unknown", "ambiguous", "total"] {
        let (a, b) = (number(&report["total"], class), number(&tiled["total"], class));
        assert!((a - b).abs() <= 1e-3 * number(&report["total"], "total"), "{class}: {a} and {b}");
        for o in report["objects"].as_array().unwrap() {
            let there = object(&tiled, o["name"].as_str().unwrap());
            let (a, b) = (number(o, class), number(there, class));
            assert!((a - b).abs() <= 1e-3 * number(o, "total"), "{class}: {o} and {there}");
        }
    }
    // Exports hold every voxel, and are read back.
    for (file, name) in [(&ply, "ply"), (&laz, "laz")] {
        let said = db.asbuilt(&["load", text(file), "--epoch", "9", "--min-range", "0"]);
        let total = format!("{:.1} k beams", number(&report["total"], "total") / 1e3);
        assert!(said.contains(&total) || name == "laz" && said.contains("beams"), "{name}: {total}? {said}");
        std::fs::remove_file(file).unwrap();
    }
    assert!(change(&db, &["--model", "--to", "2", "--voxel", "0.05"])["objects"][0].get("change").is_none());
    // Against the model: the column that was never built is absent, the pallet is not drawn.
    let against = change(&db, &["--model", "--to", "2", "--voxel", "0.02"]);
    assert!(number(object(&against, "column C"), "disappeared") > 1000.0);
    assert!(
        number(object(&against, "column C"), "confirmed") < 0.1 * number(object(&against, "column C"), "disappeared")
    );
    assert!(share_of_seen(object(&against, "wall south"), "confirmed") > 0.95, "{}", object(&against, "wall south"));
    component(&against, "unmodelled", [0.9, 3.1, 0.0], [2.3, 4.1, 0.5]);
    let csv =
        db.command(&["change", "--from", "1", "--to", "2", "--voxel", "0.05", "--format", "csv"]).output().unwrap();
    let csv = String::from_utf8(csv.stdout).unwrap();
    assert!(csv.starts_with("name,global_id,confirmed,new,disappeared,unknown,ambiguous,total,confirmed_m3"), "{csv}");
    assert!(csv.lines().next().unwrap().ends_with(
        "total_m3,change,seen_in_both,shift_x_m,shift_y_m,shift_z_m,shift_sd_x_m,shift_sd_y_m,shift_sd_z_m"
    ));
    assert_eq!(csv.lines().count(), 14);
}

/// Wrong calls report what is wrong and what to do.
#[test]
fn wrong_calls() {
    let db = Database::new("change_wrong");
    assert!(db.asbuilt_fails(&["change", "--from", "1", "--to", "2"]).contains("CREATE EXTENSION"));
    let model = project("demo/pavilion.ifc");
    db.asbuilt(&["load", text(&model)]);
    let said = db.asbuilt_fails(&["change", "--from", "1", "--to", "2"]);
    assert!(said.contains("no scan of epoch 1"), "{said}");
    for (args, expected) in [
        (["--voxel", "0"], "voxel size must be"),
        (["--voxel", "NaN"], "voxel size must be"),
        (["--export", "x.doc"], ".ply, .las or .laz"),
        (["--margin", "-1"], "margin must be"),
        (["--tile", "0"], "tile must be"),
    ] {
        let said = db.asbuilt_fails(&[&["change", "--from", "1", "--to", "2"][..], &args[..]].concat());
        assert!(said.contains(expected), "{args:?}: {said}");
    }
    assert!(db.asbuilt_fails(&["change", "--to", "2"]).contains("--from"));
}

/// The hall at 2 cm, threshold 1: a beam every 2 cm or so is all that a step of 8 mrad gives.
#[test]
fn hall() {
    let Some(db) = asbuilt_client_tests::hall("change_hall") else { return };
    for (threshold, at_least_gone) in [("1", 0.9), ("3", 0.99)] {
        let args = ["--from", "1", "--to", "2", "--voxel", "0.02", "--threshold", threshold, "--gap", "0.1"];
        let report = change(&db, &args);
        assert!(
            share_of_seen(object(&report, "W-stub"), "disappeared") >= at_least_gone,
            "{}",
            object(&report, "W-stub")
        );
        for wall in ["W-north", "W-south", "W-west", "W-east", "W-mid", "W-part", "floor", "ceiling", "C1"] {
            let o = object(&report, wall);
            let seen = number(o, "total") - number(o, "unknown");
            assert!(number(o, "new") + number(o, "disappeared") <= 0.01 * seen, "{threshold}: {o}");
        }
        component(&report, "new", [2.9, 0.0, 0.0], [3.1, 5.5, 3.0]);
        component(&report, "new", [9.7, 2.2, 0.0], [10.3, 2.8, 3.0]);
        if threshold == "1" {
            component(&report, "disappeared", [4.1, 0.9, 0.0], [4.7, 1.2, 1.9]);
            component(&report, "disappeared", [8.9, 6.4, 0.0], [10.3, 7.4, 0.5]);
            component(&report, "new", [10.2, 0.7, 0.0], [11.6, 1.7, 0.8]);
        }
    }
    // The new wall is drawn nowhere: its volume, without the two centimetres where it meets floor, ceiling and walls.
    let mut client = db.connect();
    for threshold in [1, 3] {
        let row = client.query_one(NEW_WALL, &[&threshold]).unwrap();
        let (new, seen): (i64, i64) = (row.get(0), row.get(1));
        assert!(seen > 2000 && new as f64 >= 0.9 * seen as f64, "threshold {threshold}: {new} of {seen}");
    }
}

const NEW_WALL: &str = "
SELECT s.new, s.total - s.unknown
FROM   (SELECT ab_occupancy_agg(patch, ab_grid(0.02)) AS g FROM scan WHERE epoch = 1) old,
       (SELECT ab_occupancy_agg(patch, ab_grid(0.02)) AS g FROM scan WHERE epoch = 2) new,
       LATERAL ab_summary(ab_change(old.g, new.g, $1), ab_solid(ab_box(2.9, 0.02, 0.02, 3.05, 5.42, 2.98)), 0) s";

/// OctoMap's own scan: 88 206 returns. benches/octomap (OctoMap 1.9, not discretised) counts 40 568 occupied and 3 855
/// 241 free leaves at 5 cm, 23 537 and 794 069 at 10 cm. It keeps rays in single precision: some dozen voxels differ by
/// that. Discretised, with one ray per voxel, it misses 2 % of the free ones; filled between rays, asbuilt finds 60 %
/// more at 5 cm.
#[test]
fn octomap_counts_the_same() {
    let Some(packed) = shared("octomap-share/scan.dat.bz2") else { return };
    let out = std::process::Command::new("bzcat").arg(&packed).output();
    let Ok(out) = out else {
        eprintln!("SKIPPED: bzcat is not there");
        return;
    };
    let file = scratch("scan.xyz");
    std::fs::write(&file, out.stdout).unwrap();
    let db = Database::new("change_octomap");
    db.asbuilt(&["load", text(&file), "--origin", "0,0,0", "--min-range", "0"]);
    let mut client = db.connect();
    for (voxel, occupied, free) in [(0.05, 40_568.0, 3_855_241.0), (0.1, 23_537.0, 794_069.0)] {
        let [ours, empty] = states(&mut client, voxel, true);
        assert!((ours - occupied).abs() < 1e-3 * occupied, "{voxel}: {ours} occupied, OctoMap {occupied}");
        assert!((empty - free).abs() < 1e-4 * free, "{voxel}: {empty} empty, OctoMap {free}");
        let [filled, more] = states(&mut client, voxel, false);
        assert!(filled == ours && more > 1.05 * free && more < 1.7 * free, "{voxel}: {more} filled");
    }
    std::fs::remove_file(file).unwrap();
}

fn states(client: &mut Client, voxel: f64, exact: bool) -> [f64; 2] {
    let sql = "SELECT occupied + ambiguous, empty
               FROM (SELECT ab_occupancy_agg(patch, ab_grid($1, margin => 0, exact => $2)) AS o FROM scan) s, LATERAL ab_summary(o, 1)";
    let row = client.query_one(sql, &[&voxel, &exact]).unwrap();
    [row.get::<_, i64>(0) as f64, row.get::<_, i64>(1) as f64]
}

/// A real office against its plan: where the plan is wrong, space is seen empty.
#[test]
fn real_room() {
    let (Some(model), Some(scans)) = (shared("real-room/model.ifc"), shared("real-room/scans.e57")) else { return };
    let db = Database::new("change_room");
    db.asbuilt(&["load", text(&model), text(&scans)]);
    let report = change(&db, &["--model", "--to", "1", "--voxel", "0.05", "--threshold", "1"]);
    for planned in ["partition-planned", "column-planned"] {
        let o = object(&report, planned);
        // Furniture stands in their space, floor and ceiling touch it.
        assert!(share_of_seen(o, "disappeared") > 0.6, "{o}");
    }
    let o = object(&report, "store-next-door");
    assert!(number(o, "unknown") > 0.95 * number(o, "total"), "{o}");
    for wall in ["wall-west", "wall-south", "wall-north"] {
        assert!(share_of_seen(object(&report, wall), "confirmed") > 0.6, "{}", object(&report, wall));
    }
}
