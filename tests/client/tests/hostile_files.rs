//! Files made to bring the loader down: each gives an error that names the file, quickly, with exit code 1, and leaves
//! nothing behind.

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use asbuilt_client_tests::{Database, project, scratch, text};

/// A LAS or LAZ file of 3000 points.
fn las(name: &str, version: (u8, u8), compressed: bool, evlrs: usize) -> (PathBuf, Vec<u8>) {
    let file = scratch(name);
    let mut builder = las::Builder::from(version);
    builder.point_format = las::point::Format::new(0).unwrap();
    builder.point_format.is_compressed = compressed;
    for i in 0..evlrs {
        let data = vec![7; 70_000];
        builder.evlrs.push(las::Vlr { user_id: "test".into(), record_id: i as u16, description: String::new(), data });
    }
    let mut writer = las::Writer::from_path(&file, builder.into_header().unwrap()).unwrap();
    for i in 0..3000 {
        let at = f64::from(i) * 0.001;
        writer.write_point(las::Point { x: 5.0, y: at.sin() * 9.0, z: 1.5 + at, ..Default::default() }).unwrap();
    }
    writer.close().unwrap();
    let bytes = fs::read(&file).unwrap();
    (file, bytes)
}

fn number(bytes: &[u8], at: usize, len: usize) -> usize {
    bytes[at..at + len].iter().rev().fold(0, |n, b| n << 8 | usize::from(*b))
}

fn put(bytes: &mut [u8], at: usize, value: &[u8]) {
    bytes[at..at + value.len()].copy_from_slice(value);
}

/// A variant of a file, under a name of its own.
fn variant(name: &str, mut bytes: Vec<u8>, change: impl Fn(&mut Vec<u8>)) -> PathBuf {
    change(&mut bytes);
    let file = scratch(name);
    fs::write(&file, bytes).unwrap();
    file
}

fn laz_cases() -> Vec<(PathBuf, &'static str)> {
    let (plain, laz) = las("plain.laz", (1, 2), true, 0);
    let points = number(&laz, 96, 4);
    let table = number(&laz, points, 8);
    // Where the compression is told: the user's name of its record, 52 bytes before its data.
    let vlr = laz.windows(14).position(|w| w == b"laszip encoded").unwrap() + 52;
    let case = |name: &str, change: &dyn Fn(&mut Vec<u8>)| variant(name, laz.clone(), change);
    let mut out = vec![
        (case("chunks.laz", &|b| put(b, table + 4, &0x7fff_ffffu32.to_le_bytes())), "chunks, more than"),
        (case("chunks_all.laz", &|b| put(b, table + 4, &u32::MAX.to_le_bytes())), "chunks, more than"),
        (case("chunks_some.laz", &|b| put(b, table + 4, &100u32.to_le_bytes())), ""),
        (case("no_chunks.laz", &|b| put(b, table + 4, &0u32.to_le_bytes())), "more than its 0 chunks"),
        (case("table_far.laz", &|b| put(b, points, &i64::MAX.to_le_bytes())), "its table of chunks lies at"),
        (case("table_nowhere.laz", &|b| put(b, points, &(-1i64).to_le_bytes())), "its table of chunks lies at"),
        (case("table_damaged.laz", &|b| put(b, table + 8, &[0xff; 4])), ""),
        (
            case("chunk_size.laz", &|b| put(b, vlr + 12, &0x7fff_ffffu32.to_le_bytes())),
            "its LAZ compression is damaged",
        ),
        (case("chunk_variable.laz", &|b| put(b, vlr + 12, &u32::MAX.to_le_bytes())), ""),
        (case("count.laz", &|b| put(b, 107, &u32::MAX.to_le_bytes())), "promises 4294967295 points"),
        // Records that have no room are skipped.
        (case("vlrs.laz", &|b| put(b, 100, &u32::MAX.to_le_bytes())), ""),
        (case("points_far.laz", &|b| put(b, 96, &u32::MAX.to_le_bytes())), "records before points"),
        (case("points_near.laz", &|b| put(b, 96, &1u32.to_le_bytes())), "records before points"),
    ];
    fs::remove_file(plain).unwrap();
    let (plain, las14) = las("plain.las", (1, 4), false, 2);
    let first = number(&las14, 235, 8);
    let case = |name: &str, change: &dyn Fn(&mut Vec<u8>)| variant(name, las14.clone(), change);
    let promise = "an extended record claims";
    out.extend([
        (case("evlr1.las", &|b| put(b, first + 20, &(1u64 << 40).to_le_bytes())), promise),
        (case("evlr2.las", &|b| put(b, first + 60 + 70_000 + 20, &(1u64 << 40).to_le_bytes())), promise),
        (case("evlr3.las", &|b| put(b, first + 60 + 70_000 + 20, &u64::MAX.to_le_bytes())), promise),
        (case("evlrs.las", &|b| put(b, 243, &u32::MAX.to_le_bytes())), "extended records, more than"),
        (case("evlr_far.las", &|b| put(b, 235, &(u64::MAX - 9).to_le_bytes())), ""),
        (case("count.las", &|b| put(b, 247, &(1u64 << 40).to_le_bytes())), ""),
        (case("long_points.las", &|b| put(b, 105, &u16::MAX.to_le_bytes())), ""),
    ]);
    fs::remove_file(plain).unwrap();
    out
}

/// An E57 file of the demo.
fn e57(db: &Database) -> Vec<u8> {
    let file = scratch("plain.e57");
    let (model, stations) = (project("demo/pavilion.ifc"), project("demo/stations.txt"));
    db.asbuilt(&["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "60", "--out", text(&file)]);
    let bytes = fs::read(&file).unwrap();
    fs::remove_file(file).unwrap();
    bytes
}

fn other_cases(db: &Database) -> Vec<(PathBuf, &'static str)> {
    let e57 = e57(db);
    let ply = |element: &str| {
        format!("ply\nformat binary_little_endian 1.0\n{element}property float x\nproperty float y\nproperty float z\nend_header\n").into_bytes()
    };
    let pcd = |width: &str, size: &str, count: &str, data: &str| {
        format!("VERSION 0.7\nFIELDS x y z a\nSIZE 4 4 4 {size}\nTYPE F F F U\nCOUNT 1 1 1 {count}\nWIDTH {width}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {width}\nDATA {data}\n").into_bytes()
    };
    let huge = "4000000000";
    let ptx = "1000000\n1000000\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n5 0 0 1\n";
    let mut lzf = pcd("40000000", "4", "1", "binary_compressed");
    lzf.extend_from_slice(&[16, 0, 0, 0, 0, 0xd0, 0x12, 0x26]);
    lzf.extend_from_slice(&[0; 16]);
    let lists = {
        let mut b = ply("element face 1\nproperty list uint double k\nelement vertex 1\n");
        b.extend_from_slice(&u32::MAX.to_le_bytes());
        b.extend_from_slice(&[0; 40]);
        b
    };
    let case = |name: &str, bytes: Vec<u8>| variant(name, bytes, |_| ());
    vec![
        (variant("xml.e57", e57.clone(), |b| put(b, 32, &(1u64 << 40).to_le_bytes())), "bytes of XML"),
        (variant("xml_all.e57", e57.clone(), |b| put(b, 32, &u64::MAX.to_le_bytes())), "bytes of XML"),
        (variant("xml_far.e57", e57.clone(), |b| put(b, 24, &(u64::MAX - 1).to_le_bytes())), "bytes of XML"),
        (variant("page.e57", e57.clone(), |b| put(b, 40, &(1u64 << 40).to_le_bytes())), ""),
        (variant("length.e57", e57.clone(), |b| put(b, 16, &u64::MAX.to_le_bytes())), ""),
        (case("count.ply", ply(&format!("element vertex {huge}\n"))), "promises more than"),
        (case("lists.ply", lists), ""),
        (case("width.pcd", pcd(huge, "4", "1", "binary")), "promises"),
        (case("ascii.pcd", pcd(huge, "4", "1", "ascii")), "promises"),
        (case("fields.pcd", pcd("1", "4", huge, "binary")), ""),
        (case("size.pcd", pcd("1", huge, "1", "binary")), ""),
        (case("lzf.pcd", lzf), ""),
        (case("grid.ptx", ptx.into()), "no scan grid"),
        (case("grid2.ptx", ptx.replacen("1000000\n1000000", "60000\n60000", 1).into()), "it ends after line"),
        (case("count.pts", b"18446744073709551615\n5 0 1\n".to_vec()), "promises"),
        (case("line.xyz", vec![b'7'; 50 << 20]), "longer than"),
    ]
}

/// Bodies of IFC that are deep, long or endless.
fn ifc_cases() -> Vec<(PathBuf, &'static str)> {
    let plain = fs::read_to_string(project("demo/pavilion.ifc")).unwrap();
    let with =
        |name: &str, line: &str| variant(name, plain.replacen("DATA;", &format!("DATA;\n{line}"), 1).into(), |_| ());
    let deep = 3_000_000;
    vec![
        (with("deep.ifc", &format!("#900001=IFCWALL({}1{});", "(".repeat(deep), ")".repeat(deep))), ""),
        (
            with(
                "deep_rel.ifc",
                &format!("#900001=IFCRELAGGREGATES('a',$,$,$,#1,({}#2{}));", "(".repeat(deep), ")".repeat(deep)),
            ),
            "",
        ),
        (with("open.ifc", &format!("#900001=IFCWALL({}", "(".repeat(deep))), ""),
        (with("line.ifc", &format!("#900001=IFCWALL('{}');", "x".repeat(40 << 20))), ""),
        (with("ids.ifc", "#4294967295=IFCWALL('a',$,$,$,$,$,$,$);#99999999999999999999=IFCWALL();"), ""),
    ]
}

/// The file is refused, or loaded (where nothing is expected), but never causes more than an error.
fn check(db: &Database, file: &PathBuf, reason: &str, more: &[&str]) {
    let start = Instant::now();
    let out = db.command(&[&["load", text(file)][..], more].concat()).output().unwrap();
    let said = String::from_utf8_lossy(&out.stderr);
    let name = file.file_name().unwrap().to_str().unwrap();
    assert!(start.elapsed() < Duration::from_secs(60), "{name} took {:?}", start.elapsed());
    assert!(matches!(out.status.code(), Some(0 | 1)), "{name}: {:?}: {said}", out.status);
    assert!(!said.contains("memory allocation") && !said.contains("panicked"), "{name}: {said}");
    if !out.status.success() {
        assert!(said.contains(name), "{name}: {said}");
    }
    if !reason.is_empty() {
        assert!(!out.status.success() && said.contains(reason), "{name}: {said}");
    }
    fs::remove_file(file).unwrap();
}

fn rows(db: &Database) -> i64 {
    db.connect().query_one("SELECT count(*) FROM scan", &[]).unwrap().get(0)
}

#[test]
fn counts_that_the_file_cannot_hold() {
    let db = Database::new("hostile");
    db.asbuilt_fails(&["load", "/nowhere.xyz"]);
    for (file, reason) in laz_cases().into_iter().chain(other_cases(&db)) {
        check(&db, &file, reason, &[]);
    }
    assert_eq!(
        db.connect()
            .query_one("SELECT count(*) FROM scan WHERE ab_count(patch) > 100000", &[])
            .unwrap()
            .get::<_, i64>(0),
        0
    );
}

#[test]
fn models_that_are_deep_or_long() {
    let db = Database::new("hostile_ifc");
    for (file, reason) in ifc_cases() {
        check(&db, &file, reason, &["--mesh-timeout", "50"]);
    }
}

/// An honest file that is larger than the budget.
#[test]
fn more_than_the_budget_is_an_error() {
    let db = Database::new("hostile_budget");
    let file = scratch("budget.xyz");
    let line = |i: u32| format!("{} {} 1\n", 5 + i % 7, i % 1000);
    fs::write(&file, (0..6_000_000).map(line).collect::<String>()).unwrap();
    let out = db.command(&["load", text(&file), "--max-memory", "64MB"]).output().unwrap();
    let said = String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(1), "{said}");
    assert!(said.contains("budget.xyz") && said.contains("more memory than 64 MB (--max-memory)"), "{said}");
    assert_eq!(rows(&db), 0);
    db.asbuilt(&["load", text(&file), "--max-memory", "2GB"]);
    assert!(rows(&db) > 0);
    let said = db.asbuilt_fails(&["load", text(&file), "--max-memory", "lots"]);
    assert!(said.contains("write 512MB or 4GB"), "{said}");
    fs::remove_file(file).unwrap();
    let said = db.asbuilt_fails(&["load", text(&project("demo/pavilion.ifc")), "--max-memory", "64MB"]);
    assert!(said.contains("pavilion.ifc"), "{said}");
}

/// The reading process ends with the program, however the program ends.
#[test]
fn no_reader_is_left_behind() {
    let db = Database::new("hostile_orphan");
    let file = scratch("orphan.xyz");
    fs::write(&file, (0..3_000_000).map(|i| format!("5 {} 1\n", i % 1000)).collect::<String>()).unwrap();
    let readers = || {
        let all = fs::read_dir("/proc").unwrap().filter_map(|e| fs::read(e.unwrap().path().join("cmdline")).ok());
        all.filter(|c| {
            let c = String::from_utf8_lossy(c);
            c.contains("read-scan") && c.contains(text(&file))
        })
        .count()
    };
    let mut child = db.command(&["load", text(&file)]).stderr(std::process::Stdio::null()).spawn().unwrap();
    while readers() == 0 {
        assert!(child.try_wait().unwrap().is_none(), "the load was over before it could be killed");
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let ended = (0..100).any(|_| {
        std::thread::sleep(Duration::from_millis(50));
        readers() == 0
    });
    assert!(ended, "a reader still runs 5 s after its parent is gone");
    let ended = (0..100).any(|_| {
        std::thread::sleep(Duration::from_millis(50));
        db.connect().query_one("SELECT count(*) FROM pg_class WHERE relname = 'scan'", &[]).unwrap().get::<_, i64>(0)
            == 0
            || rows(&db) == 0
    });
    assert!(ended);
    fs::remove_file(file).unwrap();
}
