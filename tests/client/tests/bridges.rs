//! The bridges, against the real PostGIS and pgPointcloud, each in a schema of its own.

use asbuilt_client_tests::{Database, project, text};
use postgres::Client;

/// A database with the model of the demo, the other extension in schema `theirs`, and the bridge; `None`, with a
/// message, where the other extension is not installed.
fn bridged(name: &str, other: &str) -> Option<(Database, Client)> {
    let db = Database::new(name);
    db.asbuilt(&["load", text(&project("demo/pavilion.ifc"))]);
    let mut client = db.connect();
    let there = "SELECT EXISTS (SELECT FROM pg_available_extensions WHERE name = $1)";
    if !client.query_one(there, &[&other]).unwrap().get::<_, bool>(0) {
        eprintln!("SKIPPED: {other} is not installed; its bridge is not tested");
        return None;
    }
    client
        .batch_execute(&format!(
            "CREATE SCHEMA theirs; CREATE EXTENSION {other} SCHEMA theirs;
            CREATE SCHEMA bridge; CREATE EXTENSION asbuilt_{other} SCHEMA bridge"
        ))
        .unwrap();
    Some((db, client))
}

/// Every row of a query of conditions must be true, and there must be rows.
fn holds(client: &mut Client, sql: &str) {
    let rows = client.query(sql, &[]).unwrap_or_else(|e| panic!("{sql}: {e:?}"));
    assert!(!rows.is_empty(), "nothing to check: {sql}");
    for row in &rows {
        for (i, column) in row.columns().iter().enumerate().filter(|(_, c)| c.type_().name() == "bool") {
            assert_eq!(row.get::<_, Option<bool>>(i), Some(true), "{} of {sql}", column.name());
        }
    }
}

fn fails(client: &mut Client, sql: &str, message: &str) {
    let error = client.batch_execute(sql).expect_err(sql).as_db_error().expect(sql).message().to_owned();
    assert!(error.contains(message), "{sql}: {error}");
}

#[test]
fn solids_points_boxes_and_samples_in_postgis() {
    let Some((_db, mut client)) = bridged("postgis", "postgis") else { return };
    // Bodies are bound to their functions: only the test's own words need a path.
    client.batch_execute("SET search_path = public, bridge, theirs").unwrap();
    holds(
        &mut client,
        "SELECT ab_as_ewkb(ab_solid(ab_geometry(solid))) = ab_as_ewkb(solid) AS polyhedral_to_the_bit,
            ab_as_ewkb(ab_solid(ab_tin(solid))) = ab_as_ewkb(solid) AS tin_to_the_bit,
            ST_GeometryType(solid::geometry) = 'ST_PolyhedralSurface' AS is_polyhedral, ST_GeometryType(ab_tin(solid)) = 'ST_Tin' AS is_tin,
            ST_NumGeometries(solid::geometry) = array_length(ab_triangles(solid), 1) AS as_many_faces,
            ST_IsClosed(solid::geometry) = (ab_closedness(solid) = 'closed') AS closed_alike,
            (solid::geometry)::box3d::ab_box ~= ab_box(solid) AS same_box
        FROM building_object WHERE solid IS NOT NULL",
    );
    // A plate with a hole, its faces polygons of four corners and more: 4 x 4 x 1 less 2 x 2 x 1.
    holds(
        &mut client,
        "SELECT abs(ab_volume(s) - 12) < 1e-9 AS volume, abs(ab_area(s) - 48) < 1e-9 AS area, ab_closedness(s) = 'closed' AS closed FROM ab_solid(ST_SetSRID(ST_GeomFromText(
            'POLYHEDRALSURFACE Z (((0 0 1,4 0 1,4 4 1,0 4 1,0 0 1),(1 1 1,1 3 1,3 3 1,3 1 1,1 1 1)),((0 0 0,0 4 0,4 4 0,4 0 0,0 0 0),(1 1 0,3 1 0,3 3 0,1 3 0,1 1 0)),
            ((0 0 0,4 0 0,4 0 1,0 0 1,0 0 0)),((4 0 0,4 4 0,4 4 1,4 0 1,4 0 0)),((4 4 0,0 4 0,0 4 1,4 4 1,4 4 0)),((0 4 0,0 0 0,0 0 1,0 4 1,0 4 0)),
            ((3 1 0,1 1 0,1 1 1,3 1 1,3 1 0)),((3 3 0,3 1 0,3 1 1,3 3 1,3 3 0)),((1 3 0,3 3 0,3 3 1,1 3 1,1 3 0)),((1 1 0,1 3 0,1 3 1,1 1 1,1 1 0)))'), 25832)) s",
    );
    holds(
        &mut client,
        "SELECT ST_AsText(ab_point(1, 2, 3.5, 0.1)::geometry) = 'POINT Z (1 2 3.5)' AS to_geometry,
            ab_point(ST_MakePoint(600000.0001, 5300000, 3), 0.01) = ab_point(600000.0001, 5300000, 3, 0.01) AS from_geometry,
            ab_point(ST_MakePoint(1, 2)) IS NULL AS flat_is_null, ST_MakePoint(1, 2, 3)::ab_point = ab_point(1, 2, 3) AS exact,
            ab_box(1, 2, 3, 4, 5, 6)::box3d::ab_box ~= ab_box(1, 2, 3, 4, 5, 6) AS box, ST_Area(ab_footprint(ab_box(1, 2, 3, 4, 6, 6), 25832)) = 12 AS footprint,
            ST_SRID(ab_footprint(ab_box(1, 2, 3, 4, 6, 6), 25832)) = 25832 AS srid, ST_IsClosed(ab_box(1, 2, 3, 4, 5, 6)::geometry) AS box_is_closed,
            ST_GeometryType(ab_box(1, 2, 3, 4, 5, 3)::geometry) = 'ST_Polygon' AS flat_box",
    );
    client
        .batch_execute(
            "CREATE TABLE evidence AS SELECT ab_evidence_agg(ab_solid(ab_box(5, -1, 0, 5.2, 1, 2)), ab_scan(ARRAY[0, 0, 1],
                (SELECT array_agg(ARRAY[5.001, i * 0.03, 1 + j * 0.03] ORDER BY i, j) FROM generate_series(-30, 30) i, generate_series(-30, 30) j), 0.006), ab_evidence_model()) AS e",
        )
        .unwrap();
    holds(
        &mut client,
        "SELECT n > 100 AS some, ST_NumGeometries(g) = n AS all_seen, ST_ZMFlag(g) = 3 AS has_z_and_m,
            abs(m - (SELECT max(deviation) FROM evidence, ab_samples(e))) < 1e-12 AS deviation_as_m
        FROM (SELECT ab_samples_geometry(e) AS g, (SELECT count(deviation) FROM ab_samples(e)) AS n FROM evidence) s,
            LATERAL (SELECT max(ST_M(p.geom)) AS m FROM ST_DumpPoints(g) p) d",
    );
    fails(&mut client, "SELECT ab_solid(ST_MakePoint(1, 2, 3))", "geometry type 1");
    fails(&mut client, "SELECT ab_solid(ST_GeomFromText('POLYGON((0 0,1 0,1 1,0 0))'))", "three dimensions");
    fails(&mut client, "SELECT ab_solid(ST_GeomFromText('TIN Z EMPTY'))", "empty");
    fails(
        &mut client,
        "SELECT ab_solid(ST_GeomFromText('POLYGON Z((0 0 0,1 0 0,2 0 0,3 0 0,0 0 0))'))",
        "encloses nothing",
    );
    // Moved, the bridge holds, with no path at all.
    client.batch_execute("ALTER EXTENSION asbuilt_postgis SET SCHEMA public; SET search_path = pg_catalog").unwrap();
    holds(
        &mut client,
        "SELECT public.ab_geometry(solid) OPERATOR(theirs.=) public.ab_geometry(public.ab_solid(public.ab_geometry(solid))) AS same FROM public.building_object WHERE solid IS NOT NULL",
    );
}

/// A schema of pgPointcloud whose dimensions are in another order than ours.
const FORMAT: &str = r#"<?xml version="1.0" encoding="UTF-8"?><pc:PointCloudSchema xmlns:pc="http://pointcloud.org/schemas/PC/1.1">
<pc:dimension><pc:position>1</pc:position><pc:size>2</pc:size><pc:name>Intensity</pc:name><pc:interpretation>uint16_t</pc:interpretation></pc:dimension>
<pc:dimension><pc:position>2</pc:position><pc:size>4</pc:size><pc:name>Z</pc:name><pc:interpretation>int32_t</pc:interpretation><pc:scale>0.0001</pc:scale></pc:dimension>
<pc:dimension><pc:position>3</pc:position><pc:size>4</pc:size><pc:name>X</pc:name><pc:interpretation>int32_t</pc:interpretation><pc:scale>0.0001</pc:scale><pc:offset>600000</pc:offset></pc:dimension>
<pc:dimension><pc:position>4</pc:position><pc:size>4</pc:size><pc:name>Y</pc:name><pc:interpretation>int32_t</pc:interpretation><pc:scale>0.0001</pc:scale><pc:offset>5300000</pc:offset></pc:dimension>
<pc:dimension><pc:position>5</pc:position><pc:size>1</pc:size><pc:name>Classification</pc:name><pc:interpretation>uint8_t</pc:interpretation></pc:dimension>
<pc:metadata><Metadata name="compression">dimensional</Metadata></pc:metadata></pc:PointCloudSchema>"#;

#[test]
fn patches_of_pgpointcloud() {
    let Some((db, mut client)) = bridged("pointcloud", "pointcloud") else { return };
    client.batch_execute("SET search_path = public, bridge, theirs").unwrap();
    // Debian's pgPointcloud is built without LAZ.
    let plain = FORMAT.replace("dimensional", "none");
    let without = FORMAT.replace("<pc:name>Intensity", "<pc:name>Amplitude");
    for (pcid, schema) in [(1, FORMAT), (2, &plain), (3, &without)] {
        client.execute("INSERT INTO pointcloud_formats VALUES ($1, 25832, $2)", &[&pcid, &schema]).unwrap();
    }
    client
        .batch_execute(
            "CREATE TABLE ours AS SELECT ab_scan(ARRAY[600000, 5300000, 500], array_agg(ARRAY[600005, 5300000 + i * 0.01234, 500 + j * 0.01] ORDER BY i, j), 0.002, 7,
                intensity => array_agg(1000 * i + j ORDER BY i, j), no_return => ARRAY[[1, -0.1, 0]]) AS patch FROM generate_series(0, 59) i, generate_series(0, 59) j",
        )
        .unwrap();
    // To the quantum, 0.1 mm on both sides, so that nothing is lost on the way back.
    holds(
        &mut client,
        "SELECT PC_NumPoints(p) = 3600 AS all_returns, ab_count(back) = 3600 AS all_back, ab_station(back) = 7 AS station, ab_origin(back) = ARRAY[600000, 5300000, 500]::float8[] AS origin,
            (SELECT count(*) FROM ab_beams(patch) a JOIN ab_beams(back) b USING (intensity) WHERE abs(a.point[1] - b.point[1]) + abs(a.point[2] - b.point[2]) + abs(a.point[3] - b.point[3]) < 1e-8) = 3600 AS same
        FROM ours, generate_series(1, 2) pcid, ab_pcpatch(patch, pcid) p, ab_scans(p, ARRAY[600000, 5300000, 500], 7) back",
    );
    holds(
        &mut client,
        "SELECT ab_origin(back) IS NULL AS no_origin, ab_count(back) = 3600 AS all_back, ab_station(back) = 9 AS station, (SELECT count(intensity) FROM ab_beams(back)) = 3600 AS intensity
        FROM ours, ab_scans(ab_pcpatch(patch, 1), NULL, 9) back",
    );
    fails(&mut client, "SELECT ab_pcpatch(patch, 99) FROM ours", "99");
    holds(
        &mut client,
        "SELECT (SELECT count(intensity) FROM ab_beams(back)) = 0 AS no_intensity, ab_count(back) = 3600 AS all_back FROM ours, ab_scans(ab_pcpatch(patch, 3), ARRAY[600000, 5300000, 500]) back",
    );
    // Large patches come out as several, cut by direction.
    holds(
        &mut client,
        "SELECT count(*) > 1 AS several, sum(ab_count(back)) = 10000 AS all_back, bool_and(ab_count(back) <= 4096) AS small
        FROM (SELECT PC_Patch(PC_MakePoint(1, ARRAY[9, 500 + j * 0.01, 600005, 5300000 + i * 0.01, 2])) AS p FROM generate_series(0, 99) i, generate_series(0, 99) j) q,
            ab_scans(p, ARRAY[600000, 5300000, 500]) back",
    );
    holds(
        &mut client,
        "SELECT ab_pcpatch(ab_scan(ARRAY[0, 0, 0], ARRAY[]::float8[], no_return => ARRAY[[1, 0, 0]]), 1) IS NULL AS nothing_returned,
            NOT EXISTS (SELECT FROM ab_scans(NULL)) AS nothing_of_null, ab_pc_dimensions(99) IS NULL AS unknown_schema",
    );
    drop(db);
}

/// Dump and restore carry over extensions, tables and what depends on them.
#[test]
fn a_bridged_database_is_dumped_and_restored() {
    let Some((db, mut client)) = bridged("bridge_dump", "postgis") else { return };
    client
        .batch_execute(
            "CREATE VIEW public.layer AS SELECT id, bridge.ab_geometry(solid) AS geom FROM public.building_object;
            CREATE INDEX ON public.building_object USING gist (bridge.ab_geometry(solid) theirs.gist_geometry_ops_nd)",
        )
        .unwrap();
    let digest = "SELECT md5(string_agg(theirs.ST_AsEWKB(geom)::text, ',' ORDER BY id)) FROM public.layer";
    let before: String = client.query_one(digest, &[]).unwrap().get(0);
    let back = db.dumped_and_restored("bridge_restored");
    assert_eq!(back.connect().query_one(digest, &[]).unwrap().get::<_, String>(0), before);
}
