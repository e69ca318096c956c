//! The loader: every format, replacing earlier loads, and leaving nothing half done.

use std::fs;
use std::time::Duration;

use asbuilt_client_tests::{Database, project, scratch, shared, text};
use postgres::Client;

fn count(client: &mut Client, sql: &str) -> i64 {
    client.query_one(sql, &[]).unwrap().get(0)
}

const BEAMS: &str = "SELECT coalesce(sum(ab_count(patch)), 0)::bigint FROM scan";

/// A small wall of points in the plane x = 5, as lines `x y z`.
fn points() -> String {
    (0..400).map(|i| format!("5.0 {:.3} {:.3}\n", f64::from(i % 20) * 0.02, f64::from(i / 20) * 0.02)).collect()
}

#[test]
fn text_formats_with_and_without_origin() {
    let db = Database::new("formats");
    let ply = format!(
        "ply\nformat ascii 1.0\nelement vertex 400\nproperty float x\nproperty float y\nproperty float z\nend_header\n{}",
        points()
    );
    let pcd = format!(
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 400\nHEIGHT 1\nVIEWPOINT 1 0.5 0 1 0 0 0\nPOINTS 400\nDATA ascii\n{}",
        points()
    );
    let pts = format!("400\n{}", points());
    let xyz = format!("# x y z\n{}", points());
    let mut expected = 0;
    for (ending, content, has_origin) in
        [("ply", &ply, false), ("pcd", &pcd, true), ("pts", &pts, false), ("xyz", &xyz, false)]
    {
        let file = scratch(&format!("wall.{ending}"));
        fs::write(&file, content).unwrap();
        let said = db.asbuilt(&["load", text(&file)]);
        expected += 400;
        assert_eq!(said.contains("without scanner position"), !has_origin, "{ending}: {said}");
        assert_eq!(count(&mut db.connect(), BEAMS), expected, "{ending}");
    }
    // With an origin they are a scan; loading again replaces.
    let file = scratch("wall.xyz");
    db.asbuilt(&["load", text(&file), "--origin", "0,0,1.5"]);
    let mut client = db.connect();
    assert_eq!(count(&mut client, BEAMS), expected);
    let origins = "SELECT count(*) FROM scan s JOIN station t ON t.id = s.station_id WHERE t.source LIKE '%wall.xyz' AND ab_origin(patch) = '{0,0,1.5}'";
    assert!(count(&mut client, origins) > 0);
    // Points are kept to half a quantum.
    let near = "SELECT count(*) FROM scan WHERE abs((ab_max(ab_point_box(patch)))[1] - 5) <= 0.00005001";
    assert!(count(&mut client, near) >= 3);
    // Points of a PCD with a VIEWPOINT are in the scanner's frame: the wall is a metre farther.
    assert!(count(&mut client, &near.replace("[1] - 5", "[1] - 6")) >= 1);
}

#[test]
fn las_and_laz() {
    let db = Database::new("las");
    for (ending, compressed) in [("las", false), ("laz", true)] {
        let file = scratch(&format!("points.{ending}"));
        let mut builder = las::Builder::from((1, 2));
        builder.point_format = las::point::Format::new(2).unwrap();
        builder.point_format.is_compressed = compressed;
        builder.transforms = las::Vector {
            x: las::Transform { scale: 1e-4, offset: 6e5 },
            y: las::Transform { scale: 1e-4, offset: 5.3e6 },
            z: las::Transform { scale: 1e-4, offset: 0.0 },
        };
        let mut writer = las::Writer::from_path(&file, builder.into_header().unwrap()).unwrap();
        for i in 0..5000 {
            let point = las::Point {
                x: 600_005.0,
                y: 5_300_000.0 + f64::from(i) * 1e-3,
                z: 1.5,
                intensity: i as u16,
                color: Some(las::Color::new(i as u16 % 256 * 256, 7 * 256, 0)),
                ..Default::default()
            };
            writer.write_point(point).unwrap();
        }
        writer.close().unwrap();
        db.asbuilt(&["load", text(&file), "--origin", "600000,5300000,1.5"]);
        let mut client = db.connect();
        let row = client.query_one("SELECT sum(ab_count(patch))::bigint, min((ab_min(ab_point_box(patch)))[2]) FROM scan s JOIN station t ON t.id = station_id WHERE source LIKE $1", &[&format!("%.{ending}")]).unwrap();
        assert_eq!(row.get::<_, i64>(0), 5000, "{ending}");
        assert!((row.get::<_, f64>(1) - 5_300_000.0).abs() < 6e-5);
        let planes = "SELECT count(intensity), count(colour) FROM scan, ab_beams(patch)";
        let kept = |client: &mut postgres::Client, sql: &str| {
            let row = client.query_one(sql, &[]).unwrap();
            (row.get::<_, i64>(0), row.get::<_, i64>(1))
        };
        assert_eq!(kept(&mut client, planes), (0, 0), "planes are kept when asked for");
        db.asbuilt(&["load", text(&file), "--origin", "600000,5300000,1.5", "--intensity", "--colour"]);
        let right = format!(
            "{planes} WHERE intensity = round((point[2] - 5300000) * 1000) AND colour = ARRAY[intensity % 256, 7, 0]"
        );
        assert_eq!(kept(&mut client, &right), (5000, 5000));
        db.asbuilt(&["load", text(&file), "--origin", "600000,5300000,1.5"]);
        // Cut short it is refused, and what was there stays.
        let bytes = fs::read(&file).unwrap();
        fs::write(&file, &bytes[..bytes.len() / 2]).unwrap();
        db.asbuilt_fails(&["load", text(&file), "--origin", "600000,5300000,1.5"]);
        assert_eq!(
            count(&mut client, "SELECT count(DISTINCT source) FROM station") as usize,
            if compressed { 2 } else { 1 }
        );
    }
}

/// A merged delivery whose stations are listed, the same without origin, and what is said of verdicts on it.
#[test]
fn origins_of_a_merged_cloud() {
    let db = Database::new("origins");
    let (file, listing) = (scratch("merged.las"), scratch("stations.csv"));
    let mut builder = las::Builder::from((1, 2));
    builder.transforms = las::Vector {
        x: las::Transform { scale: 1e-4, offset: 0.0 },
        y: las::Transform { scale: 1e-4, offset: 0.0 },
        z: las::Transform { scale: 1e-4, offset: 0.0 },
    };
    let mut writer = las::Writer::from_path(&file, builder.into_header().unwrap()).unwrap();
    for i in 0..3000u16 {
        let (x, y, z) = (5.0, f64::from(i % 50) * 0.02, f64::from(i / 50) * 0.02);
        writer.write_point(las::Point { x, y, z, point_source_id: 1 + i % 3, ..Default::default() }).unwrap();
    }
    writer.close().unwrap();
    fs::write(&listing, "station,x,y,z,sd\n1,0,0,1.5,0.003\n2,1,0,1.5\n").unwrap();
    let said = db.asbuilt(&["load", text(&project("demo/pavilion.ifc")), text(&file), "--origins", text(&listing)]);
    assert!(said.contains("1000 points have the point source ids 3"), "{said}");
    let mut client = db.connect();
    let known = "SELECT string_agg(concat_ws(' ', substr(name, strpos(name, ' ') + 1), origin_source, origin_sd), '; ' ORDER BY id)
        FROM station WHERE pose IS NOT NULL";
    assert_eq!(client.query_one(known, &[]).unwrap().get::<_, String>(0), "1 given 0.003; 2 given");
    let beams =
        "SELECT count(*) FROM (SELECT FROM scan GROUP BY ab_origin(patch) HAVING sum(ab_count(patch)) = 1000) s";
    assert_eq!(count(&mut client, beams), 3);
    let verify = |args: &[&str]| {
        let out = db.command(&[&["verify", "--spacing", "0.2"], args].concat()).output().unwrap();
        assert!(out.status.success());
        String::from_utf8(out.stderr).unwrap()
    };
    let said = verify(&[]);
    assert!(said.contains("1 of 3 stations have no origin") && said.contains("--origins FILE"), "{said}");
    // Without origin, whatever is known.
    let said = db.asbuilt(&["load", text(&file), "--origins", "none", "--epoch", "2"]);
    assert!(said.contains("never that a place is empty") && !said.contains("give --origin"), "{said}");
    assert!(verify(&["--epoch", "2"]).contains("1 of 1 stations have no origin"));
    // Nothing to say where all are known; loading again replaces.
    fs::write(&listing, "1 0 0 1.5\n2 1 0 1.5\n3 2 0 1.5\n").unwrap();
    assert!(db.asbuilt(&["load", text(&file), "--origins", text(&listing)]).contains("replaces 3 stations"));
    assert!(!verify(&[]).contains("no origin"));
    // What is refused, before anything is read or changed.
    let load =
        |origins: &str, more: &[&str]| db.asbuilt_fails(&[&["load", text(&file), "--origins", origins], more].concat());
    fs::write(&listing, "1 0 0 1.5\n2 1 zero 1.5\n").unwrap();
    let said = load(text(&listing), &[]);
    assert!(said.contains("line 2") && said.contains("y is \"zero\""), "{said}");
    assert!(load(text(&scratch("nowhere.csv")), &[]).contains("cannot open it"));
    assert!(load("none", &["--origin", "1,2,3"]).contains("cannot be used with"));
    fs::write(&listing, "17 0 0 1.5\n18 1 0 1.5\n").unwrap();
    let said = load(text(&listing), &[]);
    assert!(said.contains("ids 1, 2, 3") && said.contains("stations 17, 18"), "{said}");
    assert_eq!(count(&mut client, "SELECT count(*) FROM station WHERE epoch = 1"), 3);
}

#[test]
fn ptx_without_returns() {
    let db = Database::new("ptx");
    let (columns, rows) = (40, 30);
    let mut content =
        format!("{columns}\n{rows}\n10 20 1\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n10 20 1 1\n");
    for c in 0..columns {
        for r in 0..rows {
            let (az, el) = (f64::from(c) * 0.02, f64::from(r) * 0.02 - 0.3);
            let hole = (10..15).contains(&c) && (10..15).contains(&r);
            let d = if hole { 0.0 } else { 5.0 };
            let p = [d * el.cos() * az.cos(), d * el.cos() * az.sin(), d * el.sin()];
            content += &format!("{:.6} {:.6} {:.6} 0.5\n", p[0], p[1], p[2]);
        }
    }
    let file = scratch("hole.ptx");
    fs::write(&file, content).unwrap();
    db.asbuilt(&["load", text(&file)]);
    let mut client = db.connect();
    assert_eq!(count(&mut client, BEAMS), i64::from(columns * rows));
    assert_eq!(count(&mut client, "SELECT sum(ab_count(patch) - ab_return_count(patch))::bigint FROM scan"), 25);
    assert!(count(&mut client, "SELECT count(*) FROM scan WHERE ab_origin(patch) = '{10,20,1}'") > 0);
}

#[test]
fn wrong_input_is_named_and_leaves_nothing() {
    let db = Database::new("wrong");
    let file = |name: &str, content: &str| {
        let f = scratch(name);
        fs::write(&f, content).unwrap();
        f
    };
    let model = fs::read_to_string(project("demo/pavilion.ifc")).unwrap();
    let cases = [
        (file("empty.xyz", ""), "holds no points"),
        (file("words.xyz", "1 2 3\n4 5 six\n"), "line 2: three coordinates expected, found \"4 5 six\""),
        (file("count.pts", "3\n1 2 3\n4 5 6\n"), "it promises 3 points and holds 2"),
        (project("demo"), "it is a folder"),
        (file("far.xyz", "1e12 0 0\n0 0 0\n"), "finite and within 1e9 m"),
        (file("short.ptx", "2\n2\n0 0 0\n"), "it ends after line 3, where the first axis should follow"),
        (
            file(
                "counts.ply",
                "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nend_header\n",
            ),
            "",
        ),
        (
            file(
                "promise.pcd",
                "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 9\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 999999999\nDATA binary\n",
            ),
            "promises",
        ),
        (file("noise.e57", "this is not E57"), "not a readable E57 file"),
        (file("noise.las", "this is not LAS"), "not a readable LAS file"),
        (file("text.ifc", "hello"), "ISO-10303-21"),
        (file("cut.ifc", &model[..model.len() / 2]), "cut short"),
        (file("bare.ifc", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n"), "no product"),
        (file("what.docx", "\u{1}x"), "unknown kind of file"),
        (file("words.docx", "x"), "three coordinates"),
        (project("no/such/file.e57"), "no such file"),
    ];
    for (path, reason) in &cases {
        let said = db.asbuilt_fails(&["load", text(path)]);
        assert!(said.contains(reason), "{}: {said}", path.display());
    }
    let mut client = db.connect();
    for table in ["building_object", "station", "scan"] {
        let there: Option<String> = client.query_one("SELECT to_regclass($1)::text", &[&table]).unwrap().get(0);
        if there.is_some() {
            assert_eq!(count(&mut client, &format!("SELECT count(*) FROM {table}")), 0, "{table}");
        }
    }
    let near = db.asbuilt_fails(&["load", text(&file("near.xyz", "0.1 0 0\n")), "--origin", "0,0,0"]);
    assert!(near.contains("--min-range"), "{near}");
    db.asbuilt(&["load", text(&project("demo/pavilion.ifc"))]);
    assert!(db.asbuilt_fails(&["verify", "--epoch", "7"]).contains("no scan of epoch 7"));
    assert!(db.asbuilt_fails(&["verify", "--loa", "LOA35"]).contains("LOA35"));
}

/// Decimal commas and a byte order mark are read, not misread; a position in the file goes before --origin.
#[test]
fn what_the_file_says_is_read_as_meant() {
    let db = Database::new("meant");
    let file = scratch("comma.xyz");
    fs::write(&file, "\u{feff}1,50;2,50;3,50\n2,50;2,50;3,50\n").unwrap();
    db.asbuilt(&["load", text(&file)]);
    let mut client = db.connect();
    let shown = "SELECT min((ab_min(ab_point_box(patch)))[1]) = 1.5 AND sum(ab_count(patch)) = 2 FROM scan";
    assert!(client.query_one(shown, &[]).unwrap().get::<_, bool>(0));
    let scan = scratch("posed.e57");
    let stations = scratch("one.txt");
    fs::write(&stations, "\u{feff}3 3 1.6\n").unwrap();
    let model = project("demo/pavilion.ifc");
    let simulate = ["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "30"];
    db.asbuilt(&[&simulate[..], &["--out", text(&scan)]].concat());
    let said = db.asbuilt(&["load", text(&scan), "--origin", "9,9,9"]);
    assert!(said.contains("goes before --origin"), "{said}");
    let nine = "SELECT count(*) FROM scan WHERE ab_origin(patch) = '{9,9,9}'";
    assert_eq!(count(&mut client, nine), 0);
    // What simulate refuses.
    assert!(db.asbuilt_fails(&[&simulate[..], &["--out", text(&model)]].concat()).contains("ends in .e57"));
    let fine = ["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "0.05", "--out", text(&scan)];
    assert!(db.asbuilt_fails(&fine).contains("beams, more than"));
    // Nothing but what is too near.
    let near = db.asbuilt_fails(&["load", text(&scan), "--min-range", "100"]);
    assert!(near.contains("nearer than --min-range"), "{near}");
}

/// One name in two folders: refused in one call, reported over two calls; after a failure the files not reached are
/// named.
#[test]
fn files_of_one_name_and_files_not_reached() {
    let db = Database::new("names");
    let other = scratch("folder");
    fs::create_dir_all(&other).unwrap();
    let (a, b) = (scratch("same.xyz"), other.join(scratch("same.xyz").file_name().unwrap()));
    fs::write(&a, points()).unwrap();
    fs::write(&b, points()).unwrap();
    assert!(db.asbuilt_fails(&["load", text(&a), text(&b)]).contains("have the same name"));
    db.asbuilt(&["load", text(&a)]);
    assert!(db.asbuilt(&["load", text(&b)]).contains("replaces 1 stations"));
    let bad = scratch("bad.xyz");
    fs::write(&bad, "1 2 3\nx\n").unwrap();
    let said = db.asbuilt_fails(&["load", text(&bad), text(&a)]);
    assert!(said.contains("not loaded: ") && said.contains("same.xyz"), "{said}");
}

/// A colleague with rights on the tables, though not their owner, can load; without the rights the error says what is
/// needed. Loaders of one file at the same time wait for each other.
#[test]
fn others_load_too_and_at_the_same_time() {
    let db = Database::new("others");
    let file = scratch("wall2.xyz");
    fs::write(&file, points()).unwrap();
    db.asbuilt(&["load", text(&file), text(&project("demo/pavilion.ifc"))]);
    let role = format!("colleague_{}", std::process::id());
    let mut client = db.connect();
    client.batch_execute(&format!("CREATE ROLE {role} LOGIN")).unwrap();
    let as_colleague = |args: &[&str]| db.command(args).env("PGUSER", &role).output().unwrap();
    let refused = as_colleague(&["load", text(&file)]);
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(!refused.status.success() && said.contains("GRANT"), "{said}");
    client.batch_execute(&format!("GRANT SELECT, INSERT, DELETE ON building_object, station, scan TO {role}")).unwrap();
    let loaded = as_colleague(&["load", text(&file)]);
    let said = String::from_utf8_lossy(&loaded.stderr).into_owned();
    assert!(loaded.status.success() && !said.contains("WARNING"), "{said}");
    client.batch_execute(&format!("DROP OWNED BY {role}; DROP ROLE {role}")).unwrap();
    let model = project("demo/pavilion.ifc");
    let start = || db.command(&["load", text(&model)]).stderr(std::process::Stdio::piped()).spawn().unwrap();
    let both = [start(), start()];
    for child in both {
        let out = child.wait_with_output().unwrap();
        assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    }
    assert_eq!(count(&mut client, "SELECT count(*) FROM building_object"), 13);
}

/// With nobody reading its output it loads all the same.
#[test]
fn a_closed_standard_error_does_not_stop_it() {
    let db = Database::new("closed");
    let files: Vec<_> = (0..3).map(|i| scratch(&format!("part{i}.xyz"))).collect();
    files.iter().for_each(|f| fs::write(f, points()).unwrap());
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let args: Vec<&str> = std::iter::once("load").chain(files.iter().map(|f| text(f))).collect();
    assert!(db.command(&args).stderr(writer).status().unwrap().success());
    assert_eq!(count(&mut db.connect(), BEAMS), 1200);
}

/// The server ends the query of a program that was killed.
#[test]
fn a_killed_verify_leaves_no_query_behind() {
    let db = Database::new("killed");
    db.asbuilt(&["load", text(&project("demo/pavilion.ifc"))]);
    let scan = scratch("fine.e57");
    let (model, stations) = (project("demo/pavilion.ifc"), project("demo/stations.txt"));
    db.asbuilt(&["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "6", "--out", text(&scan)]);
    db.asbuilt(&["load", text(&scan)]);
    let mut client = db.connect();
    let running = "SELECT count(*) FROM pg_stat_activity WHERE datname = current_database() AND query LIKE '%ab_verify_table%' AND state = 'active' AND pid <> pg_backend_pid()";
    let mut child = db.command(&["verify", "--spacing", "0.005"]).stdout(std::process::Stdio::null()).spawn().unwrap();
    while count(&mut client, running) == 0 {
        assert!(child.try_wait().unwrap().is_none(), "verify was over before it could be killed");
        std::thread::sleep(Duration::from_millis(5));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let ended = (0..100).any(|_| {
        std::thread::sleep(Duration::from_millis(50));
        count(&mut client, running) == 0
    });
    assert!(ended, "the query still runs 5 s after its client is gone");
}

/// A file is one transaction: a connection that dies in the middle leaves nothing behind.
#[test]
fn a_lost_connection_leaves_nothing() {
    let db = Database::new("lost");
    let file = scratch("large.xyz");
    let line = |i: u32| {
        format!(
            "{:.4} {:.4} {:.4}\n",
            5.0 + f64::from(i % 7) * 0.1,
            f64::from(i % 1000) * 0.01,
            f64::from(i / 1000) * 0.01
        )
    };
    fs::write(&file, (0..600_000).map(line).collect::<String>()).unwrap();
    let other = Database::new("killer");
    let mut killer = other.connect();
    let mut child =
        db.command(&["load", text(&file), "--origin", "0,0,0"]).stderr(std::process::Stdio::piped()).spawn().unwrap();
    let kill =
        "SELECT count(pg_terminate_backend(pid)) FROM pg_stat_activity WHERE datname = $1 AND xact_start IS NOT NULL";
    let mut killed = 0i64;
    while killed == 0 && child.try_wait().unwrap().is_none() {
        killed = killer.query_one(kill, &[&db.name()]).unwrap().get(0);
        std::thread::sleep(Duration::from_millis(1));
    }
    let out = child.wait_with_output().unwrap();
    assert!(killed > 0 && !out.status.success(), "the load was over before its connection could be cut");
    let mut client = db.connect();
    let tables: i64 = count(&mut client, "SELECT count(*) FROM pg_class WHERE relname IN ('scan', 'station')");
    assert!(
        tables == 0
            || count(&mut client, "SELECT count(*) FROM scan") + count(&mut client, "SELECT count(*) FROM station")
                == 0
    );
    // And the next try works.
    db.asbuilt(&["load", text(&file), "--origin", "0,0,0"]);
    assert_eq!(count(&mut client, BEAMS), 600_000);
}

/// The files of other projects' parsers: each loads or is refused with a reason.
#[test]
fn parser_cases_of_others() {
    let Some(dir) = shared("e57-ptx-parser") else { return };
    let db = Database::new("parsers");
    let mut files: Vec<_> = fs::read_dir(dir).unwrap().map(|e| e.unwrap().path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e == "e57" || e == "ptx"));
    assert!(files.len() >= 24, "{}", files.len());
    let mut loaded = 0;
    for file in &files {
        let out = db.command(&["load", text(file)]).output().unwrap();
        let said = String::from_utf8_lossy(&out.stderr);
        loaded += i32::from(out.status.success());
        assert!(out.status.success() || said.contains(text(file)), "{}: {said}", file.display());
        let bad = ["bad-crc", "corrupt_crc", "ZeroPoints", "InvalidCVHeader", "loadersgl_ripple"];
        let refused = bad.iter().any(|b| text(file).contains(b));
        assert_eq!(out.status.success(), !refused, "{}: {said}", file.display());
    }
    assert!(loaded >= 20, "{loaded}");
}

/// Real models: every product with a body is meshed or named as missing.
#[test]
fn models_of_others() {
    let Some(dir) = shared("schependomlaan") else { return };
    let mut files: Vec<_> = fs::read_dir(&dir).unwrap().map(|e| e.unwrap().path()).collect();
    let more = ["ifc-duplex", "ifc-fzk-haus", "ifc-bimwhale", "ifc-tiny", "geomapi-road"];
    files.extend(
        more.iter().filter_map(|d| shared(d)).flat_map(|d| fs::read_dir(d).unwrap().map(|e| e.unwrap().path())),
    );
    files.retain(|f| f.extension().is_some_and(|e| e == "ifc"));
    assert!(files.len() >= 14);
    let db = Database::new("models");
    for file in &files {
        let said = db.asbuilt(&["load", text(file)]);
        let source = file.file_name().unwrap().to_str().unwrap().to_owned();
        let sql = "SELECT count(*), count(*) FILTER (WHERE solid IS NULL) FROM building_object WHERE source = $1";
        let row = db.connect().query_one(sql, &[&source]).unwrap();
        let (all, without): (i64, i64) = (row.get(0), row.get(1));
        assert!(all > 0, "{source}");
        assert_eq!(said.matches("  missing: ").count() as i64, without, "{source}: {said}");
    }
}
