//! Verdicts from edited patches are those from patches made anew of the same beams.

use asbuilt_client_tests::{Database, project, scratch, text};
use postgres::Client;

/// Edge of the cubes to which scans are thinned, metres.
const THINNED: [&str; 2] = ["0.03", "0.08"];

struct Verdict {
    name: String,
    verdict: String,
    coverage: f64,
}

fn verdicts(client: &mut Client, table: &str) -> Vec<Verdict> {
    let judged = format!(
        "SELECT o.name, t.verdict, t.coverage
         FROM building_object o JOIN ab_verify_table('SELECT id, solid FROM building_object WHERE solid IS NOT NULL',
              'SELECT patch FROM {table}', ab_evidence_model(spacing => 0.05)) t USING (id) ORDER BY id"
    );
    let rows = client.query(&judged, &[]).unwrap();
    rows.iter().map(|r| Verdict { name: r.get(0), verdict: r.get(1), coverage: r.get(2) }).collect()
}

/// Makes a table of the beams of another as `ab_scan_agg` packs them.
fn made_anew(client: &mut Client, table: &str) {
    let made = format!(
        "CREATE TABLE {table}_anew AS
         SELECT unnest(ab_scan_agg(point[1], point[2], point[3], origin, station)) AS patch
         FROM (SELECT ab_station(patch) AS station, (ab_beams(patch)).* FROM {table}) b WHERE point IS NOT NULL GROUP BY station"
    );
    client.batch_execute(&made).unwrap();
}

/// Fails unless both say the same of every object.
fn assert_same(edited: &[Verdict], anew: &[Verdict], what: &str) {
    assert!(edited.len() == anew.len() && edited.len() > 10, "{what}: {} objects", edited.len());
    let differ: Vec<String> = edited
        .iter()
        .zip(anew)
        .filter(|(a, b)| a.verdict != b.verdict || (a.coverage - b.coverage).abs() > 0.02)
        .map(|(a, b)| format!("{}: {} {:.3}, anew {} {:.3}", a.name, a.verdict, a.coverage, b.verdict, b.coverage))
        .collect();
    assert!(differ.is_empty(), "{what}: {differ:#?}");
}

#[test]
fn edited_patches_say_what_their_beams_say() {
    let (db, mut client) = Database::with_extension("edited");
    let (model, stations, scan) = (project("demo/pavilion.ifc"), project("demo/stations.txt"), scratch("edited.e57"));
    let simulate = ["simulate", text(&model), "--stations", text(&stations), "--step-mrad", "4", "--seed", "5"];
    db.asbuilt(&[&simulate[..], &["--out", text(&scan)]].concat());
    db.asbuilt(&["load", text(&model)]);
    db.asbuilt(&["load", text(&scan)]);
    std::fs::remove_file(scan).unwrap();
    // Beams without return are in no group of returns.
    client.batch_execute("CREATE TABLE returned AS SELECT ab_filter(patch, 0) AS patch FROM scan").unwrap();
    made_anew(&mut client, "returned");
    let whole = verdicts(&mut client, "returned");
    assert_same(&whole, &verdicts(&mut client, "returned_anew"), "all returns");
    for (i, side) in THINNED.iter().enumerate() {
        let edits = format!(
            "CREATE TABLE thin{i} AS SELECT ab_thin(patch, {side}) AS patch FROM returned;
             CREATE TABLE retiled{i} AS
                SELECT ab_retile(array_agg(patch)) AS patch FROM thin{i} GROUP BY ab_station(patch);
             CREATE TABLE united{i} AS SELECT ab_union(patch) AS patch
                FROM (SELECT patch, row_number() OVER (PARTITION BY ab_station(patch) ORDER BY ab_cone(patch)::text) / 2 AS pair
                      FROM thin{i} WHERE ab_count(patch) < 2000) p GROUP BY ab_station(patch), pair;
             CREATE TABLE filtered{i} AS
                SELECT f AS patch FROM thin{i}, ab_filter(patch, ab_box(-50, -50, -50, 50, 4, 50)) f WHERE f IS NOT NULL"
        );
        client.batch_execute(&edits).unwrap();
        made_anew(&mut client, &format!("thin{i}"));
        made_anew(&mut client, &format!("united{i}"));
        made_anew(&mut client, &format!("filtered{i}"));
        let mut compare = |edited: &str, anew: &str| {
            let (edited, anew) = (format!("{edited}{i}"), format!("{anew}{i}_anew"));
            let said = verdicts(&mut client, &edited);
            assert_same(&said, &verdicts(&mut client, &anew), &format!("{edited} at {side} m"));
            said
        };
        let thin = compare("thin", "thin");
        compare("retiled", "thin");
        compare("united", "united");
        compare("filtered", "filtered");
        let unobserved = |all: &[Verdict]| all.iter().filter(|v| v.verdict == "unobserved").count();
        println!("{side}: {} unobserved, {} before", unobserved(&thin), unobserved(&whole));
    }
}
