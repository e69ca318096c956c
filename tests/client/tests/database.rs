//! Life in a database: workers, cancel, dump and restore.

use std::time::{Duration, Instant};

use asbuilt_client_tests::Database;
use postgres::Client;
use postgres::error::SqlState;

/// Walls around four stations that see them through 2 mrad steps: about 400 patches.
const SCENE: &str = "
CREATE TABLE scan (station_id bigint, epoch int, patch ab_scan);
INSERT INTO scan
SELECT st, 1, ab_scan(ARRAY[st, 0.5 * st, 1.5]::float8[], array_agg(ARRAY[6, 0.5 * st + (6 - st) * y, 1.5 + (6 - st) * z]::float8[]), 0.004, st)
FROM generate_series(0, 3) st, generate_series(-5, 4) ty, generate_series(-5, 4) tz,
     LATERAL (SELECT (ty * 16 + i) * 0.004 AS y FROM generate_series(0, 15) i) a,
     LATERAL (SELECT (tz * 16 + i) * 0.004 AS z FROM generate_series(0, 15) i) b
GROUP BY st, ty, tz;
CREATE TABLE building_object (id int PRIMARY KEY, name text, solid ab_solid);
INSERT INTO building_object SELECT i, 'wall ' || i, ab_solid(ab_box(6 + 0.002 * i, i - 2, 0.5, 6.2, i - 1, 2.5)) FROM generate_series(1, 4) i;
INSERT INTO building_object VALUES (9, 'far away', ab_solid(ab_box(100, 0, 0, 101, 1, 1)));
CREATE INDEX ON scan USING gist (patch);
ANALYZE scan, building_object;
";

const EVIDENCE: &str = "
SELECT o.id, ab_evidence_agg(o.solid, s.patch, ab_evidence_model(loa => 'LOA30')) AS e
FROM building_object o LEFT JOIN scan s ON s.epoch = 1 AND s.patch && o.solid GROUP BY o.id";

fn scene(name: &str) -> (Database, Client) {
    let (db, mut client) = Database::with_extension(name);
    client.batch_execute(SCENE).unwrap();
    (db, client)
}

fn plan(client: &mut Client, sql: &str) -> String {
    let rows = client.query(&format!("EXPLAIN (COSTS OFF) {sql}"), &[]).unwrap();
    rows.iter().map(|r| r.get::<_, String>(0) + "\n").collect()
}

#[test]
fn the_tour_join_uses_the_index_and_keeps_unseen_objects() {
    let (_db, mut client) = scene("tour");
    let shown = plan(&mut client, EVIDENCE);
    assert!(shown.contains("Index") && shown.contains("patch && "), "{shown}");
    let rows = client
        .query(
            &format!(
                "SELECT x.id, s.verdict, s.best_loa::text FROM ({EVIDENCE}) x, LATERAL ab_summary(x.e) s ORDER BY 1"
            ),
            &[],
        )
        .unwrap();
    assert_eq!(rows.len(), 5);
    assert_eq!(rows[0].get::<_, &str>(1), "confirmed");
    assert_eq!(rows[4].get::<_, &str>(1), "unobserved");
}

/// With 0, 1 and 2 workers: exactly the same evidence, not nearly.
#[test]
fn workers_do_not_change_a_bit() {
    let (_db, mut client) = scene("workers");
    // One wall, so that the workers share its patches.
    let sql = "SELECT md5(ab_evidence_agg((SELECT solid FROM building_object WHERE id = 2), patch, ab_evidence_model())::text) FROM scan";
    client
        .batch_execute(
            "SET parallel_setup_cost = 0; SET parallel_tuple_cost = 0; SET min_parallel_table_scan_size = 0;
            SET enable_indexscan = off; SET enable_bitmapscan = off; ALTER TABLE scan SET (parallel_workers = 2)",
        )
        .unwrap();
    let mut sums = Vec::new();
    for workers in 0..3 {
        client.batch_execute(&format!("SET max_parallel_workers_per_gather = {workers}")).unwrap();
        let shown = plan(&mut client, sql);
        assert_eq!(shown.contains("Partial Aggregate"), workers > 0, "{workers} workers: {shown}");
        sums.push(client.query_one(sql, &[]).unwrap().get::<_, String>(0));
    }
    assert!(sums.iter().all(|s| *s == sums[0]), "{sums:?}");
}

/// Cancel and statement_timeout reach into one long call: sampling a large solid, and judging it.
#[test]
fn long_work_is_cancelled() {
    let (db, mut client) = scene("cancel");
    let long =
        "SELECT ab_evidence_agg(ab_solid(ab_box(0, 0, 0, 20, 20, 2)), NULL, ab_evidence_model(spacing => 0.0151))";
    let start = Instant::now();
    client.query_one(&format!("SELECT octet_length(_ab_evidence_send(({long})))"), &[]).unwrap();
    let whole = start.elapsed();
    client.batch_execute("SET statement_timeout = 50").unwrap();
    let start = Instant::now();
    let error = client.query(long, &[]).unwrap_err();
    assert_eq!(error.code(), Some(&SqlState::QUERY_CANCELED));
    assert!(start.elapsed() < whole, "cancelled after {:?}, the whole takes {whole:?}", start.elapsed());
    client.batch_execute("RESET statement_timeout").unwrap();
    let token = client.cancel_token();
    let canceller = std::thread::spawn(move || {
        std::thread::sleep(Duration::from_millis(100));
        token.cancel_query(postgres::NoTls).unwrap();
    });
    let many = format!("SELECT count(x.e) FROM generate_series(1, 1000) i, LATERAL ({long} AS e WHERE i > 0) x");
    assert_eq!(client.query(&many, &[]).unwrap_err().code(), Some(&SqlState::QUERY_CANCELED));
    canceller.join().unwrap();
    // The session lives on.
    assert_eq!(client.query_one("SELECT 1", &[]).unwrap().get::<_, i32>(0), 1);
    drop(db);
}

/// No leak: a thousand calls do not increase the session's memory.
#[test]
fn a_thousand_calls_leak_nothing() {
    let (_db, mut client) = scene("leak");
    let call = "SELECT count(ab_verdict(e)) FROM (SELECT ab_evidence_agg(o.solid, s.patch, ab_evidence_model(spacing => 0.1)) AS e
        FROM building_object o JOIN scan s ON s.patch && o.solid WHERE o.id = 1) x";
    let mut resident = || {
        let pid: i32 = client.query_one("SELECT pg_backend_pid()", &[]).unwrap().get(0);
        let status = std::fs::read_to_string(format!("/proc/{pid}/status")).unwrap();
        let line = status.lines().find(|l| l.starts_with("RssAnon")).unwrap().to_owned();
        let kib: i64 = line.split_whitespace().nth(1).unwrap().parse().unwrap();
        for _ in 0..500 {
            client.query_one(call, &[]).unwrap();
        }
        kib
    };
    resident();
    let warm = resident();
    let later = resident();
    assert!(later - warm < 2048, "{warm} KiB, after 500 more calls {later} KiB");
}

#[test]
fn dump_and_restore_lose_nothing() {
    let (db, mut client) = scene("dump");
    client.batch_execute(&format!("CREATE TABLE evidence AS {EVIDENCE}")).unwrap();
    let digest = "SELECT (SELECT md5(string_agg(solid::text, ',' ORDER BY id)) FROM building_object)
        || (SELECT md5(string_agg(patch::text, ',' ORDER BY patch::text)) FROM scan)
        || (SELECT md5(string_agg(e::text, ',' ORDER BY id)) FROM evidence)";
    let before: String = client.query_one(digest, &[]).unwrap().get(0);
    let back = db.dumped_and_restored("restored");
    let mut client = back.connect();
    assert_eq!(client.query_one(digest, &[]).unwrap().get::<_, String>(0), before);
    assert!(plan(&mut client, EVIDENCE).contains("patch && "));
}

/// A value of every type, patches of every kind among them.
const VALUES: &str = "
CREATE TABLE value AS SELECT i AS id, ab_box(i, 0, -i, 600000.123456789, 5300000, i) AS b, ab_mass(0.1 * i, 0.3) AS m,
    ab_point(600000.1, 5300000.2, i, 0.01 * i) AS p, ab_line(ab_point(0, 0, i, 0.01), ab_point(1, 1, 1 / 3.0, 0.02)) AS l,
    ab_plane(ARRAY[5, 5, i], ARRAY[0.6, 0, 0.8], 0.002, 0.0001) AS pl, ab_pose(ARRAY[10, -5, i]) AS q,
    ab_evidence_model(loa => 'LOA20', spacing => 0.01 * i) AS em, ab_solid(ab_box(0, 0, 0, i, i, i)) AS s, 'LOA30'::ab_loa AS loa,
    CASE i WHEN 1 THEN ab_scan(ARRAY[6e5, 5.3e6, 0], (SELECT array_agg(ARRAY[6e5 + 5, 5.3e6 + 0.01 * k, 0.3]) FROM generate_series(1, 3000) k), intensity => (SELECT array_agg(k * 7 % 65536) FROM generate_series(1, 3000) k), no_return => ARRAY[[1, 0.1, 0]])
        WHEN 2 THEN ab_scan(ARRAY[[0, 0, 0], [0.1, 0, 0]], ARRAY[[5, 5, 5], [-5, 5, 5]])
        ELSE ab_cloud(ARRAY[[1, 2, 3], [6, 6, 6]], colour => ARRAY[[1, 2, 3], [255, 0, 9]]) END AS c
FROM generate_series(1, 3) i;
ALTER TABLE value ADD PRIMARY KEY (id);
CREATE INDEX value_c ON value USING gist (c); CREATE INDEX ON value USING gist (b); CREATE INDEX ON value USING gist (p); CREATE INDEX ON value USING gist (l); CREATE INDEX ON value USING gist (s);
CREATE INDEX ON value (p); CREATE INDEX ON value USING hash (m);";

const VALUES_DIGEST: &str =
    "SELECT md5(string_agg(value::text, ';' ORDER BY id)) || bool_and(ab_count(c) > 0) FROM value";

fn digest(client: &mut Client) -> String {
    client.query_one(VALUES_DIGEST, &[]).unwrap().get(0)
}

#[test]
fn values_survive_vacuum_full_binary_copy_dump_and_another_schema() {
    let (db, mut client) = Database::with_extension("values");
    client.batch_execute(VALUES).unwrap();
    let before = digest(&mut client);
    for rewrite in
        ["UPDATE value SET id = id", "VACUUM FULL value", "CLUSTER value USING value_pkey", "REINDEX TABLE value"]
    {
        client.batch_execute(rewrite).unwrap();
    }
    assert_eq!(digest(&mut client), before);
    // Binary COPY, out and in again.
    let mut bytes = Vec::new();
    std::io::Read::read_to_end(&mut client.copy_out("COPY value TO STDOUT (FORMAT binary)").unwrap(), &mut bytes)
        .unwrap();
    client.batch_execute("TRUNCATE value").unwrap();
    let mut sink = client.copy_in("COPY value FROM STDIN (FORMAT binary)").unwrap();
    std::io::Write::write_all(&mut sink, &bytes).unwrap();
    sink.finish().unwrap();
    assert_eq!(digest(&mut client), before);
    // Dumped in the custom format and restored with the extension in a schema that is on nobody's path.
    client.batch_execute("CREATE SCHEMA elsewhere; ALTER EXTENSION asbuilt SET SCHEMA elsewhere").unwrap();
    let file = asbuilt_client_tests::scratch("values.dump");
    let dump = db.tool("pg_dump", &["-Fc", "-f", file.to_str().unwrap()]);
    assert!(dump.status.success(), "{}", String::from_utf8_lossy(&dump.stderr));
    let back = Database::new("values_restored");
    let restored = back.tool("pg_restore", &["-e", "-d", back.name(), file.to_str().unwrap()]);
    assert!(restored.status.success(), "{}", String::from_utf8_lossy(&restored.stderr));
    let mut client = back.connect();
    client.batch_execute("SET search_path = public, elsewhere").unwrap();
    assert_eq!(digest(&mut client), before);
    client.batch_execute("SET enable_seqscan = off").unwrap();
    assert!(plan(&mut client, "SELECT FROM value WHERE c && ab_box(0, 0, 0, 9, 9, 9)").contains("value_c"));
}

/// What an index on an expression or a replica needs: the same value wherever and whenever it is computed.
#[test]
fn immutable_functions_do_not_follow_settings() {
    let (_db, mut client) = Database::with_extension("settings");
    client.batch_execute(VALUES).unwrap();
    let before = digest(&mut client);
    client.batch_execute("DROP TABLE value").unwrap();
    client
        .batch_execute(
            "SET extra_float_digits = -10; SET lc_numeric = 'C'; SET DateStyle = 'German'; SET bytea_output = 'escape'; SET TimeZone = 'Asia/Tokyo';
            SET search_path = public, pg_catalog; SET standard_conforming_strings = off; SET client_encoding = 'LATIN1'",
        )
        .unwrap();
    // Made again under these settings, not only printed.
    client.batch_execute(VALUES).unwrap();
    assert_eq!(digest(&mut client), before);
}
