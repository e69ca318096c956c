-- A project of a million patches and twenty thousand objects: estimates, and the plans PostgreSQL chooses by itself.
SELECT setseed(0.5);
CREATE UNLOGGED TABLE project_patch (id int, patch ab_scan);
INSERT INTO project_patch SELECT i, ab_scan(ARRAY[x, y, z], ARRAY[[x + dx, y + dy, z + dz], [x + dx, y + dy + 0.3, z + dz + 0.3]], 0.01)
FROM (SELECT i, 500 * random() x, 500 * random() y, 30 * random() z, 3 * random() + 0.5 AS dx, 2 * random() - 1 AS dy, random() dz FROM generate_series(1, 1000000) i) q;
CREATE UNLOGGED TABLE project_object AS SELECT id, box, ab_solid(box) AS solid FROM (SELECT i AS id, ab_box(x, y, z, x + 3 * random(), y + 0.3, z + 2.5) AS box FROM (SELECT i, 500 * random() x, 500 * random() y, 30 * random() z FROM generate_series(1, 20000) i) q) r;
CREATE INDEX project_patch_gist ON project_patch USING gist (patch);
ANALYZE project_patch; ANALYZE project_object;
-- the join of the tour, by index and by workers; rows as estimated
SET max_parallel_workers_per_gather = 2;
EXPLAIN (COSTS OFF) SELECT o.id, count(*) FROM project_object o JOIN project_patch p ON p.patch && o.box GROUP BY o.id;
EXPLAIN (COSTS OFF) SELECT o.id, ab_evidence_agg(o.solid, p.patch, ab_evidence_model()) FROM project_object o LEFT JOIN project_patch p ON p.patch && o.solid GROUP BY o.id;
EXPLAIN (COSTS OFF) SELECT count(*) FROM project_object o WHERE EXISTS (SELECT FROM project_patch p WHERE p.patch && o.box);
EXPLAIN (COSTS OFF) SELECT id FROM project_patch ORDER BY patch <-> ab_point(250, 250, 15) LIMIT 10;
CREATE FUNCTION estimated(query text, OUT rows float8) LANGUAGE plpgsql AS $$
DECLARE plan json; BEGIN EXECUTE 'EXPLAIN (FORMAT json) ' || query INTO plan; rows := plan -> 0 -> 'Plan' ->> 'Plan Rows'; END $$;
CREATE FUNCTION counted(query text, OUT rows float8) LANGUAGE plpgsql AS $$ BEGIN EXECUTE 'SELECT count(*) FROM (' || query || ') q' INTO rows; END $$;
CREATE TABLE question (query text);
INSERT INTO question VALUES ('SELECT FROM project_object o JOIN project_patch p ON p.patch && o.box'), ('SELECT FROM project_object o JOIN project_patch p ON o.box && p.patch'),
  ('SELECT FROM project_patch WHERE patch && ab_box(100, 100, 0, 150, 105, 5)'), ('SELECT FROM project_patch WHERE patch <@ ab_box(100, 100, 0, 180, 150, 30)'),
  ('SELECT FROM project_object WHERE ab_box(100, 100, 0, 200, 200, 30) @> box'), ('SELECT FROM project_object WHERE box && ab_solid(ab_box(100, 100, 0, 200, 200, 30))'),
  ('SELECT FROM project_object o JOIN project_patch p ON p.patch && o.solid'), ('SELECT FROM project_object o WHERE EXISTS (SELECT FROM project_patch p WHERE p.patch && o.box)');
SELECT query, abs(ln(estimated(query) / counted(query))) < ln(2) AS within_a_factor_of_two, counted(query) > 100 AS many FROM question;
SELECT estimated('SELECT FROM project_patch WHERE patch && NULL::ab_box') AS of_null, estimated('SELECT FROM project_patch WHERE patch && ab_box(-9, -9, -9, -8, -8, -8)') AS of_nowhere;
-- what the index reads is what it returns
CREATE FUNCTION read_per_row(query text, OUT ratio float8) LANGUAGE plpgsql AS $$
DECLARE plan json; scan json; BEGIN EXECUTE 'EXPLAIN (ANALYZE, TIMING OFF, SUMMARY OFF, FORMAT json) ' || query INTO plan; scan := plan -> 0 -> 'Plan';
WHILE scan ->> 'Index Name' IS NULL LOOP scan := COALESCE(scan -> 'Plans' -> 1, scan -> 'Plans' -> 0); END LOOP;
ratio := 1 + COALESCE((scan ->> 'Rows Removed by Index Recheck')::float8, 0) / NULLIF((scan ->> 'Actual Rows')::float8, 0); END $$;
SELECT read_per_row('SELECT o.id FROM project_object o JOIN project_patch p ON p.patch && o.box') AS by_overlap,
       read_per_row('SELECT id FROM project_patch ORDER BY patch <-> ab_point(250, 250, 15) LIMIT 10') <= 3 AS nearest_at_most_three;
-- columns with NULL, empty, of one value; a domain of nothing analysed
CREATE TABLE odd AS SELECT CASE WHEN i % 4 = 0 THEN ab_box(1, 1, 1, 2, 2, 2) END AS b, NULL::ab_solid AS s, ab_point(1, 2, 3) AS p FROM generate_series(1, 1000) i;
ANALYZE odd; CREATE TABLE none (b ab_box, s ab_solid, c ab_scan, p ab_point, l ab_line); ANALYZE none;
SELECT estimated('SELECT FROM odd WHERE b && ab_box(0, 0, 0, 9, 9, 9)') AS same, estimated('SELECT FROM odd WHERE s && ab_box(0, 0, 0, 9, 9, 9)') AS null, estimated('SELECT FROM odd WHERE p && ab_box(0, 0, 0, 9, 9, 9)') AS points, estimated('SELECT FROM none WHERE c && b') AS none;
SELECT null_frac, avg_width, n_distinct FROM pg_stats WHERE tablename = 'odd' AND attname = 'b';
RESET max_parallel_workers_per_gather;
DROP FUNCTION estimated, counted, read_per_row; DROP TABLE project_patch, project_object, question, odd, none;
