//! Scans in another unit or frame than the model are named, with the option that mends them, and what fits is left alone.

use asbuilt_client_tests::{Database, project, scratch, shared, text};

const WARNING: &str = "warning: epoch";

/// A transform as a file.
fn transform(name: &str, rows: &str) -> String {
    let file = scratch(&format!("{name}.txt"));
    std::fs::write(&file, rows).unwrap();
    text(&file).to_owned()
}

/// 4 × 4, row by row, of a scale.
fn scale(s: f64) -> String {
    format!("{s} 0 0 0\n0 {s} 0 0\n0 0 {s} 0\n0 0 0 1\n")
}

#[test]
fn traps_are_named_and_mended() {
    let db = Database::new("frames");
    let (model, stations, scan) = (project("demo/pavilion.ifc"), project("demo/stations.txt"), scratch("frames.e57"));
    db.asbuilt(&["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "12", "--out", text(&scan)]);
    db.asbuilt(&["load", text(&model)]);
    let load = |epoch: &str, more: &[&str]| db.asbuilt(&[&["load", text(&scan), "--epoch", epoch], more].concat());
    assert!(!load("1", &[]).contains(WARNING));
    let exact = db.verify(&["--spacing", "0.1"]);
    let turned = "1 0 0 0 0 0 1 0 0 -1 0 0 0 0 0 1";
    for (epoch, name, rows, said) in [
        ("2", "feet", scale(1.0 / 0.3048), "--file-unit ft"),
        ("3", "millimetres", scale(1000.0), "--file-unit mm"),
        ("4", "kilometres", scale(0.001), "the model fits the scans as if it counted in millimetres"),
        ("5", "turned", turned.to_owned(), "--transform FILE that holds 1 0 0 0 / 0 0 -1 0 / 0 1 0 0 / 0 0 0 1"),
        ("6", "projected", "1 0 0 512345 0 1 0 5412345 0 0 1 101.5".to_owned(), "--offset X,Y,Z"),
    ] {
        let file = transform(name, &rows);
        let told = load(epoch, &["--transform", &file, "--min-range", "0"]);
        assert!(told.contains(&format!("{WARNING} {epoch}")) && told.contains(said), "{name}: {told}");
        let out = db.command(&["verify", "--spacing", "0.2", "--epoch", epoch, "--format", "csv"]).output().unwrap();
        assert!(String::from_utf8_lossy(&out.stderr).contains(said), "{name}: before verify, too");
        assert!(std::fs::remove_file(file).is_ok());
    }
    // Brought there and back it is what it was: to the quantum of a patch.
    let offset = load("7", &["--offset", "0.25,-0.5,0.125"]);
    assert!(offset.contains("an offset of (0.250, -0.500, 0.125) m"), "{offset}");
    let back = transform("back", "0 1 0 0 -1 0 0 0 0 0 1 0 0 0 0 1");
    let quarter = transform("quarter", "0 -1 0 0 1 0 0 0 0 0 1 0 0 0 0 1");
    load("8", &["--transform", &quarter]);
    let mut client = db.connect();
    let origin = |client: &mut postgres::Client, epoch: i32| -> Vec<f64> {
        let sql = "SELECT ab_origin(s.patch) FROM scan s WHERE epoch = $1 ORDER BY s.id LIMIT 1";
        client.query_one(sql, &[&epoch]).unwrap().get(0)
    };
    let (plain, moved, turned) = (origin(&mut client, 1), origin(&mut client, 7), origin(&mut client, 8));
    let is = |a: &[f64], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(is(&moved, [plain[0] + 0.25, plain[1] - 0.5, plain[2] + 0.125]), "{plain:?} {moved:?}");
    assert!(is(&turned, [-plain[1], plain[0], plain[2]]), "{plain:?} {turned:?}");
    let again = db.verify(&["--spacing", "0.1"]);
    assert_eq!(exact.verdict("column B"), again.verdict("column B"));
    for (bad, said) in [("1 0 0 0", "16 numbers"), ("1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1", "mirrors")] {
        let file = transform("bad", bad);
        let error = db.asbuilt_fails(&["load", text(&scan), "--epoch", "9", "--transform", &file]);
        assert!(error.contains(said) && error.contains("--transform"), "{error}");
        std::fs::remove_file(file).unwrap();
    }
    for file in [back, quarter] {
        std::fs::remove_file(file).unwrap();
    }
    std::fs::remove_file(scan).unwrap();
}

/// The data beside the project lies where it should: nothing is said of it.
#[test]
fn no_false_alarm() {
    let Some(hall) = asbuilt_client_tests::hall("frames_hall") else { return };
    let room = ["model.ifc", "scans.e57"].map(|f| shared(&format!("real-room/{f}")));
    for epoch in ["1", "2"] {
        let out = hall.command(&["verify", "--spacing", "0.2", "--epoch", epoch, "--format", "csv"]).output().unwrap();
        assert!(!String::from_utf8_lossy(&out.stderr).contains(WARNING), "{}", String::from_utf8_lossy(&out.stderr));
    }
    let [Some(model), Some(scans)] = room else { return };
    let db = Database::new("frames_room");
    let said = db.asbuilt(&["load", text(&model), text(&scans), "--min-range", "0.45"]);
    assert!(!said.contains(WARNING), "{said}");
}
