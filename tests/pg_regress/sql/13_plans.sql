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
-- what the index reads is about what it returns
BEGIN;
SELECT count(*) AS nearest FROM (SELECT id FROM project_patch ORDER BY patch <-> ab_point(250, 250, 15) LIMIT 10) k;
SELECT pg_stat_get_xact_tuples_fetched('project_patch_gist'::regclass) BETWEEN 10 AND 40 AS read_for_ten;
COMMIT;
-- a room seen from its middle, its floor asked for, 4 cm thick: at most three times the points wanted are unpacked
CREATE TABLE room AS SELECT unnest(ab_scan_agg(o[1] + t * d[1], o[2] + t * d[2], o[3] + t * d[3], o, 1)) AS patch
FROM (SELECT ARRAY[4.0, 3.0, 1.6]::float8[] AS o, ARRAY[cos(e) * cos(a), cos(e) * sin(a), sin(e)] AS d FROM (SELECT i * 0.01 AS a, j * 0.01 AS e FROM generate_series(0, 627) i, generate_series(-150, 150) j) q) beam,
    LATERAL (SELECT least(CASE WHEN d[1] > 0 THEN 4.1 / d[1] ELSE -4.2 / NULLIF(d[1], 0) END, CASE WHEN d[2] > 0 THEN 3.1 / d[2] ELSE -3.2 / NULLIF(d[2], 0) END, CASE WHEN d[3] > 0 THEN 1.2 / d[3] WHEN d[3] < 0 THEN -1.6 / d[3] ELSE 99 END) AS t) hit;
SELECT wanted > 20000 AS many, round(unpacked / wanted, 1) <= 3 AS at_most_three_times, unpacked < every AS not_all
FROM (SELECT sum(ab_count(ab_filter(patch, b)))::numeric AS wanted, sum(ab_count(patch)) FILTER (WHERE ab_point_box(patch) && b) AS unpacked, (SELECT sum(ab_count(patch)) FROM room) AS every FROM room, ab_box(-1, -1, -0.02, 9, 9, 0.02) b WHERE patch && b) x;
-- columns with NULL, empty, of one value, never analysed
CREATE TABLE odd AS SELECT CASE WHEN i % 4 = 0 THEN ab_box(1, 1, 1, 2, 2, 2) END AS b, NULL::ab_solid AS s, ab_point(1, 2, 3) AS p FROM generate_series(1, 1000) i;
ANALYZE odd; CREATE TABLE none (b ab_box, s ab_solid, c ab_scan, p ab_point, l ab_line); ANALYZE none;
SELECT estimated('SELECT FROM odd WHERE b && ab_box(0, 0, 0, 9, 9, 9)') AS same, estimated('SELECT FROM odd WHERE s && ab_box(0, 0, 0, 9, 9, 9)') AS null, estimated('SELECT FROM odd WHERE p && ab_box(0, 0, 0, 9, 9, 9)') AS points, estimated('SELECT FROM none WHERE c && b') AS none;
SELECT null_frac, avg_width, n_distinct FROM pg_stats WHERE tablename = 'odd' AND attname = 'b';
-- domains are their types; a type that only has the name of one of ours is not taken for it
CREATE SCHEMA other;
CREATE DOMAIN other.ab_solid AS ab_box; CREATE DOMAIN hull AS ab_scan;
CREATE TABLE named AS SELECT ab_box(i, 0, 0, i + 1, 1, 1)::other.ab_solid AS b, ab_scan(ARRAY[i, 0, 0], ARRAY[[i + 1, 0, 0]])::hull AS c FROM generate_series(1, 1000) i;
ANALYZE named;
SELECT estimated('SELECT FROM named WHERE b::ab_box && ab_box(0.5, 0, 0, 100.5, 1, 1)') BETWEEN 50 AND 200 AS domain_of_boxes, estimated('SELECT FROM named WHERE c::ab_scan && ab_box(0.5, 0, 0, 100.5, 1, 1)') BETWEEN 50 AND 200 AS domain_of_patches;
CREATE TYPE other.ab_scan AS ENUM ('a');
CREATE FUNCTION other.never(ab_box, other.ab_scan) RETURNS boolean LANGUAGE plpgsql AS 'BEGIN RETURN false; END';
CREATE OPERATOR other.&& (LEFTARG = ab_box, RIGHTARG = other.ab_scan, FUNCTION = other.never, RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
SELECT estimated($$SELECT FROM named WHERE b::ab_box OPERATOR(other.&&) 'a'::other.ab_scan$$) >= 1 AS not_read;
DROP TABLE named; DROP DOMAIN hull; SET client_min_messages = warning; DROP SCHEMA other CASCADE; RESET client_min_messages;
-- points keep what PostgreSQL itself knows of a column
CREATE TABLE control AS SELECT ab_point(i % 10, 0, 0) AS p FROM generate_series(1, 1000) i; ANALYZE control;
SELECT n_distinct, most_common_vals IS NOT NULL AS common, estimated('SELECT FROM control WHERE p = ab_point(3, 0, 0)') AS equal, estimated('SELECT FROM control WHERE p && ab_box(2.5, -1, -1, 4.5, 1, 1)') BETWEEN 100 AND 400 AS overlap FROM pg_stats WHERE tablename = 'control';
RESET max_parallel_workers_per_gather;
DROP FUNCTION estimated, counted; DROP TABLE project_patch, project_object, question, odd, none, room, control;
