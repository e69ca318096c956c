//! Every SQL example in the documents runs; those of docs/api.md where it is made and checked (scripts/api_docs.sh).

use asbuilt_client_tests::{Database, project, scratch, text};

fn examples(markdown: &str) -> Vec<String> {
    markdown.split("```sql\n").skip(1).filter_map(|rest| Some(rest.split_once("```")?.0.to_owned())).collect()
}

#[test]
fn sql_examples_run() {
    let db = Database::new("docs");
    let scan = scratch("docs.e57");
    db.asbuilt(&[
        "simulate",
        text(&project("demo/pavilion.ifc")),
        "--stations",
        text(&project("demo/stations.txt")),
        "--step-mrad",
        "20",
        "--out",
        text(&scan),
    ]);
    db.asbuilt(&["load", text(&project("demo/pavilion.ifc")), text(&scan)]);
    db.asbuilt(&["load", text(&scan), "--epoch", "2"]);
    let mut client = db.connect();
    let mut files: Vec<_> = std::fs::read_dir(project("docs")).unwrap().map(|e| e.unwrap().path()).collect();
    files.push(project("README.md"));
    files.retain(|f| f.extension().is_some_and(|e| e == "md") && !f.ends_with("docs/api.md"));
    let there = "SELECT EXISTS (SELECT FROM pg_available_extensions WHERE name = 'postgis')";
    let has_postgis: bool = client.query_one(there, &[]).unwrap().get(0);
    let mut ran = 0;
    for file in files {
        for example in examples(&std::fs::read_to_string(&file).unwrap()) {
            if example.contains("asbuilt_postgis") && !has_postgis {
                eprintln!("SKIPPED: PostGIS is not installed: {example}");
                continue;
            }
            client.batch_execute(&example).unwrap_or_else(|e| panic!("{}: {e:?}\n{example}", file.display()));
            ran += 1;
        }
    }
    assert!(ran >= 13, "{ran} examples found");
}
