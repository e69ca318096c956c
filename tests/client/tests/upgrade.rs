//! From the first released SQL to the current one: what was stored answers as before, and an updated extension cannot
//! be told from a fresh one.

use std::collections::BTreeSet;

use asbuilt_client_tests::Database;
use postgres::Client;

/// What a user of 0.1.0 has: tables, an index, views, stored evidence.
const SCENE: &str = "
CREATE EXTENSION asbuilt VERSION '0.1.0';
CREATE TABLE scan AS SELECT st AS station_id, ab_scan(ARRAY[0, 0.5 * st, 1.5]::float8[], array_agg(ARRAY[5, 0.5 * st + 0.02 * i, 1.5 + 0.02 * j]::float8[] ORDER BY i, j), 0.004, st) AS patch
FROM generate_series(0, 2) st, generate_series(-25, 25) i, generate_series(-25, 25) j GROUP BY st;
CREATE INDEX ON scan USING gist (patch);
CREATE TABLE building_object AS SELECT i AS id, ab_solid(ab_box(5 + 0.002 * i, i - 2, 1, 5.2, i - 1, 2)) AS solid, ab_point(5, i - 1.5, 1.5, 0.01) AS p FROM generate_series(1, 3) i;
CREATE INDEX ON building_object USING gist (solid); CREATE INDEX ON building_object USING gist (p);
ANALYZE;
CREATE TABLE evidence AS SELECT o.id, ab_evidence_agg(o.solid, s.patch, ab_evidence_model(loa => 'LOA30')) AS e
FROM building_object o LEFT JOIN scan s ON s.patch && o.solid GROUP BY o.id;
CREATE TABLE tied AS SELECT ab_evidence_agg(solid, ab_point(5, i * 0.02, 1.5 + j * 0.02, 0.001), ARRAY[[-4, 0.5, 1.5], [-3, -0.5, 2]], ab_evidence_model()) AS e
FROM building_object, generate_series(-40, 40) i, generate_series(-20, 20) j WHERE id = 2;
CREATE VIEW verdict AS SELECT id, ab_verdict(e) AS verdict, ab_count(e) AS samples FROM evidence;
CREATE VIEW readme AS
SELECT o.id, s.* FROM (SELECT o.id, ab_evidence_agg(o.solid, s.patch, ab_evidence_model(loa => 'LOA30')) AS e
    FROM building_object o LEFT JOIN scan s ON s.patch && o.solid GROUP BY o.id) o CROSS JOIN LATERAL ab_summary(o.e) s;
CREATE VIEW moved AS SELECT id, x, x_sd, (ab_shift(e)).y FROM evidence, ab_shift(e);
CREATE VIEW beam AS SELECT station_id, b.* FROM scan, ab_beams(patch) b;
CREATE VIEW called AS
SELECT o.id, d.sd, t.p_value, i.dof, c.half_angle, ab_tolerance('LOA30') AS upper, ab_verdict(e => e.e, loa => 'LOA20') AS coarse,
    ab_line(start => ARRAY[0, 0, 0], \"end\" => ARRAY[1, 2, 3]) AS line, ab_overlaps(o.solid, o.p) AS met, ab_equal(o.p, o.p) AS same,
    ab_scan(ARRAY[0, 0, 0]::float8[], ARRAY[[1, 0, 0]]::float8[], 0.001, 7, 0.0002) AS patch, (SELECT count(*) FROM ab_loa_class()) AS levels
FROM building_object o JOIN evidence e USING (id) CROSS JOIN LATERAL ab_distance(o.p, ab_point(0, 0, 0, 0.01)) d
CROSS JOIN LATERAL ab_test_same(o.p, ab_point(5, 0, 1.5)) t CROSS JOIN LATERAL ab_cone((SELECT patch FROM scan WHERE station_id = o.id - 1)) c
CROSS JOIN LATERAL ab_test_incident(ab_line(ARRAY[0, 0, 0], ARRAY[1, 0, 0]), o.p) i;
CREATE TABLE setting (id integer PRIMARY KEY, model ab_evidence_model);
INSERT INTO setting SELECT i, ab_evidence_model('LOA40', spacing => 0.05 * i, sigma_station => 0.002) FROM generate_series(1, 2) i;
CREATE VIEW chosen AS SELECT s.id, s.model, ab_model(ab_evidence_agg(o.solid, p.patch, s.model)) AS used, ab_verdict(ab_evidence_agg(o.solid, p.patch, s.model)) AS verdict
    FROM setting s, building_object o, scan p WHERE o.id = 1 GROUP BY s.id;
CREATE INDEX ON evidence USING gist (ab_box(e));
CREATE VIEW near AS SELECT o.id, s.station_id FROM building_object o JOIN scan s ON s.patch && o.solid AND o.solid && o.p;
";

/// What the views of then show; functions that they call have other columns, parameters or names today.
const VIEWS: [&str; 7] = ["verdict", "readme", "moved", "beam", "called", "near", "chosen"];

fn views(client: &mut Client) -> Vec<String> {
    let shown = VIEWS.map(|v| format!("(SELECT string_agg(v::text, E'\\n' ORDER BY v::text) FROM {v} v)"));
    let row = client.query_one(&format!("SELECT {}", shown.join(", ")), &[]).unwrap();
    (0..VIEWS.len())
        .map(|i| row.get::<_, Option<String>>(i).unwrap_or_else(|| panic!("{} is empty", VIEWS[i])))
        .collect()
}

/// Answers that an update must not change.
const ANSWERS: &str = "SELECT md5(string_agg(t, ';' ORDER BY t)) FROM (
    (SELECT string_agg(id || verdict || samples, ',' ORDER BY id) AS t FROM verdict)
    UNION ALL (SELECT string_agg(id || '-' || station_id, ',' ORDER BY id, station_id) FROM near)
    UNION ALL (SELECT string_agg(patch::text, ',' ORDER BY station_id) FROM scan)
    UNION ALL (SELECT string_agg(e::text, ',' ORDER BY id) FROM evidence)
    UNION ALL (SELECT ab_verdict(e) || ab_station_count(e) || ab_rollup(e, e)::text FROM tied)
    UNION ALL (SELECT string_agg(point::text || range, ',' ORDER BY point::text) FROM scan, ab_beams(patch))
    UNION ALL (SELECT string_agg(ab_station(c) || ' ' || ab_count(c), ',' ORDER BY ab_station(c))
        FROM (SELECT unnest(ab_scan_agg(point[1], point[2], point[3], origin, station_id)) AS c FROM scan, ab_beams(patch) GROUP BY station_id) a)) x";

fn answer(client: &mut Client) -> String {
    client.query_one(ANSWERS, &[]).unwrap().get::<_, Option<String>>(0).expect("there are answers")
}

/// The ten nearest, by the index and by a sort.
fn nearest(client: &mut Client, by_index: bool) -> Vec<f64> {
    client.batch_execute(&format!("SET enable_seqscan = {}; SET enable_indexscan = {by_index}", !by_index)).unwrap();
    let sql = "SELECT patch <-> ab_box(4, 0, 1, 4, 0, 1) FROM scan ORDER BY patch <-> ab_box(4, 0, 1, 4, 0, 1)";
    let rows = client.query(sql, &[]).unwrap();
    client.batch_execute("RESET enable_seqscan; RESET enable_indexscan").unwrap();
    rows.iter().map(|r| r.get(0)).collect()
}

/// Every object of the extension with all that the catalogue says about it.
fn catalogue(client: &mut Client) -> BTreeSet<String> {
    let sql = "
    WITH member AS (SELECT d.classid, d.objid FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND d.refclassid = 'pg_extension'::regclass WHERE x.extname = 'asbuilt' AND d.deptype = 'e')
    SELECT concat_ws(' ', 'function', p.oid::regprocedure, pg_get_function_arguments(p.oid), pg_get_function_result(p.oid), p.prokind, p.provolatile, p.proparallel, p.proisstrict,
        p.procost, p.prorows, p.prosrc, p.probin, pg_get_function_sqlbody(p.oid), obj_description(p.oid, 'pg_proc'), a.aggtransfn, a.aggfinalfn, a.aggcombinefn, a.aggserialfn, a.aggdeserialfn, a.aggtranstype::regtype, a.aggtransspace)
    FROM member m JOIN pg_proc p ON m.classid = 'pg_proc'::regclass AND m.objid = p.oid LEFT JOIN pg_aggregate a ON a.aggfnoid = p.oid
    UNION ALL SELECT concat_ws(' ', 'operator', o.oid::regoperator, o.oprcode, o.oprrest, o.oprjoin, o.oprcom::regoperator, o.oprnegate::regoperator, o.oprcanhash, o.oprcanmerge, obj_description(o.oid, 'pg_operator'))
    FROM member m JOIN pg_operator o ON m.classid = 'pg_operator'::regclass AND m.objid = o.oid
    UNION ALL SELECT concat_ws(' ', 'type', t.typname, t.typlen, t.typstorage, t.typalign, t.typinput, t.typoutput, t.typreceive, t.typsend, t.typanalyze, obj_description(t.oid, 'pg_type'))
    FROM member m JOIN pg_type t ON m.classid = 'pg_type'::regclass AND m.objid = t.oid
    UNION ALL SELECT concat_ws(' ', 'column', t.typname, a.attnum, a.attname, a.atttypid::regtype, col_description(a.attrelid, a.attnum))
    FROM member m JOIN pg_type t ON m.classid = 'pg_type'::regclass AND m.objid = t.oid AND t.typtype = 'c' JOIN pg_attribute a ON a.attrelid = t.typrelid AND a.attnum > 0
    UNION ALL SELECT concat_ws(' ', 'member of', f.opfname, o.amopstrategy, o.amopopr::regoperator, o.amoppurpose) FROM pg_amop o JOIN pg_opfamily f ON f.oid = o.amopfamily WHERE f.opfname ~ '^ab_'
    UNION ALL SELECT concat_ws(' ', 'support of', f.opfname, p.amprocnum, p.amproc::regprocedure) FROM pg_amproc p JOIN pg_opfamily f ON f.oid = p.amprocfamily WHERE f.opfname ~ '^ab_'
    UNION ALL SELECT concat_ws(' ', 'class', c.opcname, c.opcintype::regtype, c.opcdefault, c.opckeytype::regtype, obj_description(c.oid, 'pg_opclass')) FROM member m JOIN pg_opclass c ON m.classid = 'pg_opclass'::regclass AND m.objid = c.oid
    UNION ALL SELECT concat_ws(' ', 'cast', c.castsource::regtype, c.casttarget::regtype, c.castfunc::regprocedure, c.castcontext, obj_description(c.oid, 'pg_cast'))
    FROM member m JOIN pg_cast c ON m.classid = 'pg_cast'::regclass AND m.objid = c.oid";
    client.query(sql, &[]).unwrap().iter().map(|r| r.get(0)).collect()
}

#[test]
fn a_database_of_0_1_0_is_updated() {
    let db = Database::new("upgrade");
    let mut client = db.connect();
    client.batch_execute(SCENE).unwrap();
    // The new library under the old SQL, as it is between installing and updating.
    let (before, shown) = (answer(&mut client), views(&mut client));
    assert_eq!(nearest(&mut client, true), nearest(&mut client, false));
    assert_eq!(nearest(&mut client, true)[0], 0.0, "0.1.0 measures to the hull");
    let version: String = client
        .query_one("SELECT default_version FROM pg_available_extensions WHERE name = 'asbuilt'", &[])
        .unwrap()
        .get(0);
    assert_ne!(version, "0.1.0");
    client.batch_execute("ALTER EXTENSION asbuilt UPDATE").unwrap();
    let now: String =
        client.query_one("SELECT extversion FROM pg_extension WHERE extname = 'asbuilt'", &[]).unwrap().get(0);
    assert_eq!(now, version);
    assert_eq!(answer(&mut client), before);
    assert_eq!(views(&mut client), shown);
    let text: String = client.query_one("SELECT shift FROM readme WHERE id = 1", &[]).unwrap().get(0);
    assert!(text.starts_with("(-0.002") && text.contains("-) +/- ("), "0.1.0 tells a text: {text}");
    // Columns of parameters, of fixed length then, serve today's functions, and take values.
    let today = "SELECT count(*) FROM chosen c JOIN (SELECT s.id, ab_verdict(ab_evidence_agg(o.solid, p.patch, s.model)) AS verdict
        FROM setting s, building_object o, scan p WHERE o.id = 1 GROUP BY s.id) t USING (id, verdict)";
    assert_eq!(client.query_one(today, &[]).unwrap().get::<_, i64>(0), 2);
    client
        .batch_execute(
            "INSERT INTO setting VALUES (3, 'LOA20'); DELETE FROM setting WHERE id = 3;
             CREATE TABLE renewed AS SELECT id, model::ab_evidence_model AS model FROM setting; DROP TABLE renewed",
        )
        .unwrap();
    // An index on an expression serves it as before.
    client.batch_execute("SET enable_seqscan = off").unwrap();
    let sql = "EXPLAIN SELECT id FROM evidence WHERE ab_box(e) && ab_box(0, 0, 0, 1, 1, 1)";
    let plan: Vec<String> = client.query(sql, &[]).unwrap().iter().map(|r| r.get(0)).collect();
    assert!(plan.iter().any(|line| line.contains("evidence_ab_box_idx")), "{plan:?}");
    client.batch_execute("RESET enable_seqscan").unwrap();
    assert_eq!(nearest(&mut client, true), nearest(&mut client, false));
    assert!(nearest(&mut client, true)[0] > 0.9, "now to the returns");
    // What is new works on what is old.
    client.batch_execute("ANALYZE; REINDEX TABLE scan; SELECT ab_union(patch) FROM scan WHERE station_id = 1").unwrap();
    let (fresh, mut other) = Database::with_extension("upgrade_fresh");
    let (updated, made) = (catalogue(&mut client), catalogue(&mut other));
    assert!(made.len() > 500, "{} objects", made.len());
    let differ: Vec<&String> = updated.symmetric_difference(&made).collect();
    assert!(differ.is_empty(), "{} differ, such as {:#?}", differ.len(), &differ[..differ.len().min(6)]);
    drop(fresh);
    // What was kept of 0.1.0 is there in a fresh 0.2.0, too.
    let back = db.dumped_and_restored("upgrade_back");
    assert_eq!(views(&mut back.connect()), shown);
}
