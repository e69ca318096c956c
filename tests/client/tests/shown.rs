//! What others wrote (names in files, names of files, passwords) is safe to display, and exact where programs read it.

use std::path::PathBuf;
use std::process::Output;

use asbuilt_client_tests::{Database, project, scratch, text};

/// The demo with hostile names.
fn model(name: &str) -> PathBuf {
    let text = std::fs::read_to_string(project("demo/pavilion.ifc")).unwrap();
    let text = text
        .replace("'wall south'", "'=cmd|x\\X\\1B[31mred'")
        .replace("'wall north'", "'-1 \\X2\\202E\\X0\\turned'")
        .replace("'wall west'", "'two\\X\\0Alines'");
    let file = scratch(name);
    std::fs::write(&file, text).unwrap();
    file
}

/// Checks for anything that a terminal would obey.
fn is_safe(bytes: &[u8]) {
    let text = std::str::from_utf8(bytes).unwrap();
    let bad = |c: &char| {
        (c.is_control() && *c != '\n') || ('\u{202a}'..='\u{202e}').contains(c) || ('\u{2066}'..='\u{2069}').contains(c)
    };
    assert!(!text.contains(|c| bad(&c)), "{text:?}");
}

#[test]
fn names_of_objects() {
    let db = Database::new("shown");
    let (model, stations, scan) = (model("hostile_names.ifc"), project("demo/stations.txt"), scratch("shown.e57"));
    db.asbuilt(&["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "20", "--out", text(&scan)]);
    is_safe(db.asbuilt(&["load", text(&model), text(&scan)]).as_bytes());
    let names: Vec<String> = db
        .connect()
        .query("SELECT name FROM building_object ORDER BY id", &[])
        .unwrap()
        .iter()
        .map(|r| r.get(0))
        .collect();
    assert!(names.contains(&"=cmd|x\u{1b}[31mred".to_owned()) && names.contains(&"two\nlines".to_owned()), "{names:?}");
    let voxel = ["--from", "1", "--to", "1", "--voxel", "0.1"];
    for command in [
        &["verify", "--spacing", "0.2"][..],
        &[&["change"][..], &voxel[..]].concat(),
        &["forecast", text(&model), "--stations", text(&stations), "--step-mrad", "20", "--next", "0"],
    ] {
        let run = |format: &str| {
            let out = db.command(&[command, &["--format", format]].concat()).output().unwrap();
            assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
            is_safe(&out.stderr);
            out.stdout
        };
        let table = run("table");
        is_safe(&table);
        let table = String::from_utf8(table).unwrap();
        assert!(
            table.contains("=cmd|x\\x1b[31mred") && table.contains("\\u{202e}") && table.contains("two\\nlines"),
            "{table}"
        );
        let (csv, exact) = (String::from_utf8(run("csv")).unwrap(), String::from_utf8(run("csv-exact")).unwrap());
        let has = |csv: &str, text: &str| ['\n', ','].iter().any(|before| csv.contains(&format!("{before}{text}")));
        let are_guarded = has(&csv, "'=cmd|x") && has(&csv, "'-1 \u{202e}turned");
        assert!(are_guarded && csv.contains("\"two\nlines\""), "{csv}");
        assert!(has(&exact, "=cmd|x") && has(&exact, "-1 \u{202e}turned"), "{exact}");
        assert_eq!(csv.replace("'=", "=").replace("'-", "-"), exact, "nothing else differs");
        let json: serde_json::Value = serde_json::from_slice(&run("json")).unwrap();
        let objects = json.get("objects").unwrap_or(&json).as_array().unwrap();
        for name in &names {
            assert!(objects.iter().any(|o| o["name"] == name.as_str()), "{name:?}");
        }
        let help = db.command(&[command[0], "--help"]).output().unwrap();
        assert!(String::from_utf8_lossy(&help.stdout).contains("csv-exact"));
    }
}

/// Names of files, contents of files, and mistakes on the command line.
#[test]
fn messages_and_errors() {
    let db = Database::new("shown_errors");
    db.asbuilt(&["load", text(&project("demo/pavilion.ifc"))]);
    let dir = scratch("odd");
    std::fs::create_dir_all(&dir).unwrap();
    let odd = |name: &str, content: &str| {
        let file = dir.join(name);
        std::fs::write(&file, content).unwrap();
        file
    };
    let good = odd("a\u{1b}[2J\nasbuilt: all is well\u{202e}.xyz", "5 0 1\n5 0.1 1\n");
    is_safe(db.asbuilt(&["load", text(&good)]).as_bytes());
    let said = db.asbuilt(&["load", text(&good)]);
    assert!(said.contains("\\x1b[2J\\nasbuilt: all is well\\u{202e}.xyz"), "{said}");
    assert!(!said.lines().any(|l| l.starts_with("asbuilt: all is well")), "{said}");
    let bad = odd("b\u{9b}31m.xyz", "1 2 3\n4 5 \u{1b}]0;title\u{7}\u{202e}\n");
    for args in [
        &["load", text(&bad)][..],
        &["load", text(&dir.join("no\u{1b}where.xyz"))],
        &["load", text(&dir.join("x.\u{1b}doc"))],
        &["verify", "--model", "\u{1b}[31m\nasbuilt: fine"],
        &["verify", "--schema", "\u{1b}[31m"],
    ] {
        let said = db.asbuilt_fails(args);
        is_safe(said.as_bytes());
        assert!(said.contains("\\x1b") || said.contains("\\x9b"), "{args:?}: {said}");
    }
}

#[test]
fn passwords_are_not_shown() {
    let db = Database::new("shown_passwords");
    let host = std::env::var("PGHOST").unwrap();
    let encoded = host.replace('/', "%2F");
    for url in [
        "postgres://me:s3cr3t@nowhere.invalid:5432/db".to_owned(),
        "postgres://me:s3cr3t@nowhere.invalid:port/db".into(),
        "postgres://me:x@s3cr3t@nowhere.invalid/db".into(),
        "postgres://me:x/s3cr3t@nowhere.invalid/db".into(),
        "postgres://me:%s3cr3t@nowhere.invalid:x/db".into(),
        "postgres://me:s3cr3t#?nowhere.invalid".into(),
        "postgresql://me:a@b/s3cr3t@nowhere.invalid/db".into(),
        "postgre://me:s3cr3t@nowhere.invalid/db".into(),
        "host=nowhere.invalid password=s3cr3t nonsense=1".into(),
        "host=nowhere.invalid password='my s3cr3t".into(),
        "host=nowhere.invalid password=my s3cr3t=1".into(),
        "host=nowhere.invalid port=x password=s3cr3t".into(),
        "postgres://nowhere.invalid/db?password=s3cr3t&nonsense=1".into(),
        format!("postgres://nobody:s3cr3t@{encoded}/{}", db.name()),
    ] {
        let silent = |out: Output, args: &[&str]| {
            let all = [out.stdout, out.stderr].concat();
            assert!(!out.status.success(), "{args:?}");
            assert!(!String::from_utf8_lossy(&all).contains("s3cr3t"), "{args:?}: {}", String::from_utf8_lossy(&all));
        };
        // Given rightly; forgotten to be given; given twice; as a file; with the password in the environment too.
        for args in [
            &["verify", "--db", &url][..],
            &["verify", &url],
            &["verify", "--db", &url, &url],
            &["load", &url],
            &["change", "--to", &url],
        ] {
            silent(db.command(args).env("PGPASSWORD", "s3cr3t").output().unwrap(), args);
        }
    }
    let said = db.asbuilt_fails(&["verify", "--db", "postgres://me:x@nowhere.invalid:port/db"]);
    assert!(said.contains("is no connection URL") && said.contains("PGPASSWORD"), "{said}");
}
