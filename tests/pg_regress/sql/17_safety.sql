-- No value brings the server down, hangs it or passes for another one.
CREATE FUNCTION outcome(query text) RETURNS text LANGUAGE plpgsql AS $$
DECLARE detail text;
BEGIN
    EXECUTE query;
    RETURN 'fine';
EXCEPTION WHEN OTHERS THEN
    GET STACKED DIAGNOSTICS detail = PG_EXCEPTION_DETAIL;
    RETURN SQLSTATE || CASE WHEN detail ~ 'backtrace|rust|::' THEN ' with a backtrace' ELSE '' END;
END $$;
CREATE TABLE sample AS SELECT
    ab_solid(ab_box(0, 0, 0, 1, 2, 3)) AS solid,
    ab_scan(ARRAY[0, 0, 0]::float8[], ARRAY[[2, 0, 0], [2, 0.1, 0], [2, 0, 0.1]]::float8[], 0.05) AS scan;
ALTER TABLE sample ADD evidence ab_evidence, ADD occupancy ab_occupancy, ADD change ab_change, ADD model ab_evidence_model, ADD grid ab_grid;
UPDATE sample SET evidence = (SELECT ab_evidence_agg(solid, scan, ab_evidence_model(spacing => 0.5)) FROM sample),
    occupancy = (SELECT ab_occupancy_agg(scan, ab_grid(0.1)) FROM sample), model = ab_evidence_model('LOA40'), grid = ab_grid(0.05);
UPDATE sample SET change = ab_change(occupancy, occupancy, 1);

-- Binary output of arrays, rows and ranges of rows: what is sent is freed by whoever asked for it.
COPY (SELECT ARRAY[solid], ARRAY[scan, scan], ARRAY[evidence], ARRAY[occupancy], ARRAY[change] FROM sample) TO '/dev/null' (FORMAT binary);
COPY (SELECT array_agg(solid), array_agg(ROW(scan, ARRAY[scan])), array_agg(ROW(evidence)) FROM sample) TO '/dev/null' (FORMAT binary);
COPY (SELECT array_agg(s) FROM sample s) TO '/dev/null' (FORMAT binary);
COPY (SELECT ab_scan_agg(x, 0, 1, ARRAY[0, 0, 0]::float8[]) FROM generate_series(1, 9) x) TO '/dev/null' (FORMAT binary);
CREATE DOMAIN tall AS ab_solid CHECK (ab_volume(VALUE) > 1);
COPY (SELECT ARRAY[solid::tall] FROM sample) TO '/dev/null' (FORMAT binary);
-- Short values as they lie in a row.
CREATE TABLE short (patch ab_scan);
ALTER TABLE short ALTER patch SET STORAGE plain;
INSERT INTO short SELECT scan FROM sample;
COPY (SELECT ARRAY[patch], ROW(patch) FROM short) TO '/dev/null' (FORMAT binary);
SELECT ab_rollup(NULL, evidence) = evidence AND ab_rollup(evidence, NULL) = evidence AS handed_through FROM sample;

-- Polygons whose rings cross or run to and fro: refused or cut, and never long about it. EWKB in big-endian order.
CREATE FUNCTION polygon_z(VARIADIC rings text[]) RETURNS bytea LANGUAGE sql IMMUTABLE AS $$
    SELECT '\x0080000003'::bytea || int4send(cardinality(rings)) || string_agg(body, ''::bytea ORDER BY n)
    FROM (SELECT n, int4send(count(*)::int) || string_agg(float8send(split_part(trim(point), ' ', 1)::float8) || float8send(split_part(trim(point), ' ', 2)::float8) || float8send(split_part(trim(point), ' ', 3)::float8), ''::bytea ORDER BY k) AS body
        FROM unnest(rings) WITH ORDINALITY r(ring, n), unnest(string_to_array(ring, ',')) WITH ORDINALITY p(point, k) GROUP BY n) r $$;
SELECT outcome($$SELECT ab_solid_from_ewkb(polygon_z('2.5 0 0,1.75 0.75 0,3.25 0.25 0,2.5 0 0', '0 0 0,2.5 0 0,0 0 0,0 0 0', '3.5 1.75 0,0 0 0,2 0 0,3.5 1.75 0'))$$) AS the_one_that_hung;
SELECT outcome($$EXPLAIN SELECT ab_solid_from_ewkb(polygon_z('0 0 0,4 4 0,4 0 0,0 4 0,0 0 0'))$$) AS a_bow_tie_in_explain;
SELECT ab_area(ab_solid_from_ewkb(polygon_z('0 0 0,4 0 0,4 4 0,0 4 0,0 0 0', '1 1 0,3 1 0,3 3 0,1 3 0,1 1 0'))) AS with_a_hole,
       ab_area(ab_solid_from_ewkb(polygon_z('0 0 0,4 0 0,4 4 0,0 4 0,0 0 0,1 1 0,1 3 0,3 3 0,3 1 0,1 1 0,0 0 0'))) AS with_a_slit;
SELECT outcome($$SELECT ab_solid_from_ewkb(polygon_z('0 0 0,4 0 0,4 4 0,0 4 0', '5 1 0,6 1 0,6 2 0'))$$) AS a_hole_beside,
       outcome($$SELECT ab_solid_from_ewkb('\x008000000300000001ffffffff')$$) AS a_ring_that_is_cut_short,
       outcome($$SELECT ab_solid_from_ewkb(polygon_z('0 0 0,1 0 0,2 0 0,1 0 0,0 0 0'))$$) AS a_line;
SELECT ab_area(ab_solid_from_ewkb(polygon_z(string_agg(format('%s %s 0', (1 + 0.5 * (i % 2)) * cos(i * pi() / 5000), (1 + 0.5 * (i % 2)) * sin(i * pi() / 5000)), ',' ORDER BY i)))) > 1 AS ten_thousand_corners FROM generate_series(0, 9999) i;

-- Limits of memory: an error, and what was taken is given back.
SET asbuilt.max_grid_memory = '64MB';
SET enable_sort = off; SET work_mem = '500GB';
SELECT outcome('SELECT ab_voxelize(ab_solid(ab_box(0, 0, 0, 20, 20, 20)), 0.005)') AS voxelize,
       outcome('SELECT ab_occupancy_agg(ab_transform(scan, ab_pose(ARRAY[i, 0, 0]::float8[], ARRAY[1, 0, 0, 0]::float8[])), ab_grid(0.0005)) FROM sample, generate_series(1, 2000) i') AS occupancy,
       outcome('SELECT count(ab_occupancy_agg) FROM (SELECT ab_occupancy_agg(ab_transform(scan, ab_pose(ARRAY[i, 0, 0]::float8[], ARRAY[1, 0, 0, 0]::float8[])), ab_grid(0.002)) FROM sample, generate_series(1, 3000) i GROUP BY i) g') AS many_groups;
SELECT live < 20e6 AS given_back, peak < 1.1 * 64 * 1048576 + 1e6 AS kept_within FROM ab_memory();
RESET enable_sort; RESET work_mem;
SET asbuilt.max_evidence_memory = '64MB';
SELECT peak IS NOT NULL AS anew FROM ab_memory(from_now => true);
SELECT outcome('SELECT ab_evidence_agg(ab_solid(ab_box(2, -20, -20, 2.1, 20, 20)), scan, ab_evidence_model(spacing => 0.002)) FROM sample') AS evidence,
       outcome('SELECT * FROM ab_verify_table(''SELECT 1, ab_solid(ab_box(2, -20, -20, 2.1, 20, 20))'', ''SELECT scan FROM sample'', ab_evidence_model(spacing => 0.002))') AS verify_table;
SELECT live < 20e6 AS given_back, peak < 1.1 * 64 * 1048576 + 1e6 AS kept_within FROM ab_memory();
-- What a call gave back is not held against the next ones.
SET asbuilt.max_grid_memory = '1MB';
DO $$ BEGIN FOR i IN 1..30000 LOOP PERFORM ab_clip(occupancy, ab_box(-9, -9, -9, 9, 9, 9)) FROM sample; END LOOP; END $$;
RESET asbuilt.max_grid_memory;
RESET asbuilt.max_evidence_memory;
SET asbuilt.memory_ceiling = '32MB';
SELECT outcome('SELECT ab_plane_agg(ab_point(x, x * x % 7, x % 3)) FROM generate_series(1, 1000000) x') AS below_no_other_limit;
RESET asbuilt.memory_ceiling;
CREATE ROLE safety_guest;
SET ROLE safety_guest;
SELECT outcome($$SET asbuilt.max_grid_memory = '2GB'$$) AS ones_own, outcome($$SET asbuilt.memory_ceiling = '2GB'$$) AS a_superusers;
RESET ROLE;

-- A setting that does not exist.
SET asbuilt.nonsense = 1;

-- What rows row-level security hides, the planner's estimate does not show.
CREATE TABLE hidden AS SELECT i AS id, ab_solid(ab_box(i % 7, 0, 0, i % 7 + 0.5, 1, 1)) AS solid FROM generate_series(1, 7000) i;
CREATE INDEX ON hidden USING gist (solid);
ANALYZE hidden;
ALTER TABLE hidden ENABLE ROW LEVEL SECURITY;
CREATE POLICY few ON hidden USING (id = 1);
GRANT SELECT ON hidden TO safety_guest;
CREATE FUNCTION estimate(query text) RETURNS float8 LANGUAGE plpgsql AS $$
DECLARE plan json;
BEGIN
    EXECUTE 'EXPLAIN (FORMAT json) ' || query INTO plan;
    RETURN plan -> 0 -> 'Plan' ->> 'Plan Rows';
END $$;
SELECT estimate('SELECT FROM hidden WHERE solid && ab_box(3, 0, 0, 3.5, 1, 1)') > 500 AS the_owner_is_told;
SET ROLE safety_guest;
SELECT estimate('SELECT FROM hidden WHERE solid && ab_box(3, 0, 0, 3.5, 1, 1)') = estimate('SELECT FROM hidden WHERE solid && ab_box(70, 0, 0, 71, 1, 1)') AS a_guest_is_not,
       estimate('SELECT FROM hidden a JOIN hidden b ON a.solid && b.solid') < 500 AS nor_of_pairs;
RESET ROLE;

-- Equality by bytes, for every type: a row finds itself, and groups hold one.
SELECT count(*) FROM (SELECT DISTINCT solid, scan, evidence, occupancy, change, model, grid FROM (SELECT * FROM sample UNION ALL SELECT * FROM sample) s) d;
SELECT count(*) FROM sample a JOIN sample b USING (solid, scan, evidence, occupancy, change, model, grid);
SELECT a = b AS same_row, a <> b AS other_row FROM sample a, sample b;
SELECT ab_grid(0.1) = ab_grid(0.1), (ab_grid(0.1) < ab_grid(0.2)) <> (ab_grid(0.1) > ab_grid(0.2)), ab_evidence_model('LOA40') = ab_evidence_model('LOA30'),
       solid = ab_solid(ab_box(0, 0, 0, 1, 2, 3)), solid <> ab_solid(ab_box(0, 0, 0, 1, 2, 4)), scan = scan::text::ab_scan FROM sample;
SET enable_hashagg = off;
SELECT count(*) FROM (SELECT solid FROM hidden GROUP BY solid) g;
RESET enable_hashagg;
-- (the type that is kept of 0.1.0 had none: a column of it is altered to today's)
SELECT typname FROM pg_type t JOIN pg_depend d ON d.classid = 'pg_type'::regclass AND d.objid = t.oid AND d.deptype = 'e' JOIN pg_extension x ON x.oid = d.refobjid
WHERE x.extname = 'asbuilt' AND t.typtype = 'b' AND t.typelem = 0 AND t.typname <> 'ab_evidence_model_010'
  AND NOT (EXISTS (SELECT FROM pg_opclass c JOIN pg_am m ON m.oid = c.opcmethod WHERE c.opcintype = t.oid AND c.opcdefault AND m.amname = 'btree')
       AND EXISTS (SELECT FROM pg_opclass c JOIN pg_am m ON m.oid = c.opcmethod WHERE c.opcintype = t.oid AND c.opcdefault AND m.amname = 'hash'));

-- Zero has no sign, so text and binary forms say the same.
SELECT encode(_ab_box_send(ab_box('-0', '-0', '-0', 1, 1, 1)), 'hex') = encode(_ab_box_send(ab_box('-0', '-0', '-0', 1, 1, 1)::text::ab_box), 'hex') AS boxes,
       encode(_ab_point_send(ab_point('-0', 0, 0)), 'hex') = encode(_ab_point_send(ab_point('-0', 0, 0)::text::ab_point), 'hex') AS points,
       encode(_ab_mass_send(ab_mass('-0', '-0')), 'hex') = encode(_ab_mass_send(ab_mass('-0', '-0')::text::ab_mass), 'hex') AS masses,
       encode(_ab_grid_send(ab_grid(0.1, ab_box('-0', 0, 0, 1, 1, 1), '-0')), 'hex') = encode(_ab_grid_send(ab_grid(0.1, ab_box('-0', 0, 0, 1, 1, 1), '-0')::text::ab_grid), 'hex') AS grids;

-- Damage to a stored value, a byte at a time: whoever reads all of it is told, and so is who reads the header alone where that is hit.
CREATE CAST (bytea AS ab_solid) WITHOUT FUNCTION;
CREATE CAST (bytea AS ab_scan) WITHOUT FUNCTION;
CREATE CAST (bytea AS ab_evidence) WITHOUT FUNCTION;
CREATE CAST (bytea AS ab_occupancy) WITHOUT FUNCTION;
CREATE CAST (bytea AS ab_change) WITHOUT FUNCTION;
CREATE TABLE stored AS SELECT 'ab_solid' AS type, _ab_solid_send(solid) AS bytes, 'ab_area(ab_transform(%s, ab_pose(ARRAY[0, 0, 0]::float8[], ARRAY[1, 0, 0, 0]::float8[])))' AS whole, 'ab_area(%s)' AS header, 88 AS header_length FROM sample
    UNION ALL SELECT 'ab_scan', _ab_scan_send(scan), 'ab_thin(%s, 0.001)', 'ab_box(%s)', 200 FROM sample
    UNION ALL SELECT 'ab_evidence', _ab_evidence_send(evidence), 'ab_verdict(%s)', 'ab_count(%s)', 220 FROM sample
    UNION ALL SELECT 'ab_occupancy', _ab_occupancy_send(occupancy), 'ab_downsample(%s)', 'ab_box(%s)', 124 FROM sample
    UNION ALL SELECT 'ab_change', _ab_change_send(change), 'ab_clip(%s, ab_box(0, 0, 0, 1, 1, 1))', 'ab_box(%s)', 124 FROM sample;
CREATE TABLE damage AS
    SELECT type, i, i < header_length AS in_header, outcome(format('SELECT ' || whole, format('%L::bytea::%s', bad, type))) AS whole, outcome(format('SELECT ' || header, format('%L::bytea::%s', bad, type))) AS header
    FROM stored, generate_series(0, length(bytes) - 1) i, LATERAL (SELECT set_byte(bytes, i, get_byte(bytes, i) # 4) AS bad) b;
-- Byte 0 tells a version: newer ones are not known (0A000), older ones another layout.
SELECT type, whole, count(*) FROM damage WHERE i > 0 GROUP BY 1, 2 ORDER BY 1, 2;
SELECT type, header, count(*) FROM damage WHERE i > 0 AND in_header GROUP BY 1, 2 ORDER BY 1, 2;
SELECT type, outcome(format('SELECT ' || whole, format('%L::bytea::%s', substr(bytes, 1, n), type))) AS cut_short, count(*) FROM stored, generate_series(0, 300) n WHERE n < length(bytes) GROUP BY 1, 2 ORDER BY 1, 2;
-- The same bytes from a client are the client's fault.
SELECT type, outcome(format('SELECT %L::%s', type || ':1:' || encode(set_byte(bytes, 99, get_byte(bytes, 99) # 4), 'hex'), type)) AS as_text FROM stored ORDER BY 1;

-- No error of a query inside our functions carries a backtrace (the server's environment asks Rust for one).
SELECT outcome($$SELECT * FROM ab_verify_table('SELECT 1/0, NULL::ab_solid', 'SELECT NULL::ab_scan')$$), outcome($$SELECT * FROM ab_verify_table('SELECT nothing', '')$$);
DROP CAST (bytea AS ab_solid); DROP CAST (bytea AS ab_scan); DROP CAST (bytea AS ab_evidence); DROP CAST (bytea AS ab_occupancy); DROP CAST (bytea AS ab_change);
DROP OWNED BY safety_guest;
DROP ROLE safety_guest;
