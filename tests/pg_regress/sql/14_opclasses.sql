-- Every operator of every GiST class, taken from the catalogue: index result = sequential result on random, clustered and
-- degenerate values, built sorted and by inserts, after deletes and vacuum.
SELECT setseed(0.7);
CREATE TABLE seed AS SELECT i AS id, CASE i % 3 WHEN 0 THEN 30 * random() WHEN 1 THEN 600000 + random() ELSE 7 END AS x, 30 * random() AS y,
    CASE WHEN i % 5 = 0 THEN 0 ELSE 4 * random() END AS z, CASE i % 7 WHEN 0 THEN 0 WHEN 1 THEN 9 ELSE 2 * random() END AS w FROM generate_series(1, 900) i;
CREATE TABLE v_ab_box WITH (autovacuum_enabled = off) AS SELECT id, ab_box(x, y, z, x + w, y + w, z + w) AS v FROM seed;
CREATE TABLE v_ab_solid WITH (autovacuum_enabled = off) AS SELECT id, ab_solid(v) AS v FROM v_ab_box WHERE id % 7 <> 0;
CREATE TABLE v_ab_scan WITH (autovacuum_enabled = off) AS SELECT id, ab_scan(ARRAY[x, y, z], ARRAY[[x + 0.5 + w, y, z], [x + 0.5 + w, y + 0.1, z + 0.1]], 0.01) AS v FROM seed;
INSERT INTO v_ab_scan SELECT id + 1000, ab_cloud(ARRAY[[x, y, z], [x + w, y, z]]) FROM seed WHERE id % 4 = 0;
INSERT INTO v_ab_scan SELECT id + 2000, ab_scan(ARRAY[[x, y, z], [x, y + 1, z]], ARRAY[[x + w, y, z], [x - w, y, z]]) FROM seed WHERE id % 4 = 1;
INSERT INTO v_ab_box SELECT id + 3000, ab_box(v) FROM v_ab_scan WHERE id % 9 = 0;
CREATE TABLE v_ab_point WITH (autovacuum_enabled = off) AS SELECT id, ab_point(x, y, z, 0.02 * w) AS v FROM seed;
CREATE TABLE v_ab_line WITH (autovacuum_enabled = off) AS SELECT id, ab_line(ab_point(x, y, z, 0.01), ab_point(x + 1 + w, y, z, 0.02)) AS v FROM seed;
CREATE TABLE v_ab_occupancy WITH (autovacuum_enabled = off) AS SELECT id, ab_occupancy_agg(v, ab_grid(0.5, exact => true)) AS v FROM v_ab_scan WHERE id % 3 > 0 AND id < 1900 GROUP BY id;
INSERT INTO v_ab_occupancy SELECT id + 5000, ab_occupancy(ab_grid(0.5, v)) FROM v_ab_box WHERE id % 11 = 0;
CREATE TABLE v_ab_change WITH (autovacuum_enabled = off) AS SELECT id, ab_change(ab_occupancy(ab_grid(v)), v, 1) AS v FROM v_ab_occupancy WHERE id % 4 < 3;
CREATE TABLE answer (round text, by_index boolean, class text, op text, pairs bigint, digest bigint);
CREATE PROCEDURE ask(round text) LANGUAGE plpgsql AS $$
DECLARE o record; way boolean;
BEGIN
    FOR o IN SELECT f.opfname, a.amopopr::regoperator AS op, p.oprname, a.amoplefttype::regtype AS l, a.amoprighttype::regtype AS r, a.amoppurpose = 'o' AS orders
             FROM pg_amop a JOIN pg_opfamily f ON f.oid = a.amopfamily JOIN pg_am m ON m.oid = a.amopmethod JOIN pg_operator p ON p.oid = a.amopopr
             WHERE m.amname = 'gist' AND f.opfname ~ '^ab_' ORDER BY 1, 2 LOOP
        FOREACH way IN ARRAY ARRAY[true, false] LOOP
            PERFORM set_config('enable_seqscan', (NOT way)::text, true), set_config('enable_indexscan', way::text, true), set_config('enable_bitmapscan', way::text, true), set_config('enable_indexonlyscan', way::text, true);
            IF o.orders THEN
                EXECUTE format('INSERT INTO answer SELECT %L, %L, %L, %L, count(*), sum((1e6 * k.d)::bigint) FROM v_%s b, LATERAL (SELECT a.v %s b.v AS d FROM v_%s a ORDER BY a.v %s b.v LIMIT 7) k WHERE b.id %% 30 = 2 AND k.d < 1e12', round, way, o.opfname, o.op, o.r, o.oprname, o.l, o.oprname);
            ELSE
                EXECUTE format('INSERT INTO answer SELECT %L, %L, %L, %L, count(*), sum(a.id * 7 + b.id) FROM v_%s b JOIN v_%s a ON a.v %s b.v WHERE b.id %% 5 <> 0', round, way, o.opfname, o.op, o.r, o.l, o.oprname);
            END IF;
        END LOOP;
    END LOOP;
END $$;
DO $$ DECLARE t text; BEGIN FOREACH t IN ARRAY ARRAY['box', 'solid', 'scan', 'point', 'line', 'occupancy', 'change'] LOOP EXECUTE format('CREATE INDEX ON v_ab_%s USING gist (v)', t); EXECUTE format('ANALYZE v_ab_%s', t); END LOOP; END $$;
CALL ask('built');
DO $$ DECLARE t text; BEGIN FOREACH t IN ARRAY ARRAY['box', 'solid', 'scan', 'point', 'line', 'occupancy', 'change'] LOOP EXECUTE format('DELETE FROM v_ab_%s WHERE id %% 3 = 1', t); END LOOP; END $$;
VACUUM v_ab_box, v_ab_solid, v_ab_scan, v_ab_point, v_ab_line, v_ab_occupancy, v_ab_change;
DO $$ DECLARE t text; BEGIN FOREACH t IN ARRAY ARRAY['box', 'solid', 'scan', 'point', 'line', 'occupancy', 'change'] LOOP EXECUTE format('INSERT INTO v_ab_%s SELECT id + 9000, v FROM v_ab_%s WHERE id %% 4 < 2', t, t); END LOOP; END $$;
CALL ask('changed');
SELECT i.class, i.op, i.round, i.pairs = s.pairs AND i.digest = s.digest AS same, i.pairs > 20 AS some
FROM answer i JOIN answer s USING (round, class, op) WHERE i.by_index AND NOT s.by_index ORDER BY 1, 2, 3;
-- and the index is what answered
SET enable_seqscan = off;
EXPLAIN (COSTS OFF) SELECT count(*) FROM v_ab_box b JOIN v_ab_line a ON a.v && b.v;
EXPLAIN (COSTS OFF) SELECT k.d FROM v_ab_point b, LATERAL (SELECT a.v <-> b.v AS d FROM v_ab_scan a ORDER BY a.v <-> b.v LIMIT 7) k;
RESET enable_seqscan;
DROP PROCEDURE ask; DROP TABLE seed, answer, v_ab_box, v_ab_solid, v_ab_scan, v_ab_point, v_ab_line, v_ab_occupancy, v_ab_change;
