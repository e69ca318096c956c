-- && by index = && by sequence, for every opclass and right-hand type; also after deletes, inserts, vacuum.
SELECT setseed(0.42);
CREATE TABLE solids AS
SELECT i AS id, ab_solid(ab_box(x, y, z, x + random() * 2, y + random() * 2, z + random() * 2)) AS solid
FROM (SELECT i, random() * 60 AS x, random() * 40 AS y, random() * 10 AS z FROM generate_series(1, 2000) i) a;
-- clustered and degenerate ones
INSERT INTO solids SELECT 2000 + i, ab_solid(ab_box(5, 5, 1, 5, 5 + i % 3, 2)) FROM generate_series(1, 500) i;
CREATE TABLE patches AS
SELECT i AS id, ab_scan(ARRAY[ox, oy, 1.5], ARRAY[[ox + cos(a) * r, oy + sin(a) * r, 1.5 + h], [ox + cos(a + 0.01) * r, oy + sin(a + 0.01) * r, 1.5 + h]]) AS patch
FROM (SELECT i, (i % 5) * 12::float8 AS ox, (i % 4) * 10::float8 AS oy, random() * 6.28 AS a, 1 + random() * 10 AS r, random() * 3 - 1.5 AS h
      FROM generate_series(1, 3000) i) a;
CREATE TABLE boxes AS SELECT id, ab_box(solid) AS box FROM solids;
CREATE INDEX solids_idx ON solids USING gist (solid);
CREATE INDEX patches_idx ON patches USING gist (patch);
CREATE INDEX boxes_idx ON boxes USING gist (box);
ANALYZE solids, patches, boxes;

CREATE FUNCTION counts() RETURNS TABLE (what text, pairs bigint, sum numeric) LANGUAGE sql AS $$
    SELECT 'solid box', count(*), sum(a.id * 7 + b.id) FROM solids a JOIN boxes b ON a.solid && b.box WHERE b.id % 10 = 0
    UNION ALL SELECT 'solid solid', count(*), sum(a.id * 7 + b.id) FROM solids a JOIN solids b ON a.solid && b.solid WHERE b.id % 10 = 0
    UNION ALL SELECT 'solid scan', count(*), sum(a.id * 7 + b.id) FROM solids a JOIN patches b ON a.solid && b.patch WHERE b.id % 10 = 0
    UNION ALL SELECT 'scan box', count(*), sum(a.id * 7 + b.id) FROM patches a JOIN boxes b ON a.patch && b.box WHERE b.id % 10 = 0
    UNION ALL SELECT 'scan solid', count(*), sum(a.id * 7 + b.id) FROM patches a JOIN solids b ON a.patch && b.solid WHERE b.id % 10 = 0
    UNION ALL SELECT 'scan scan', count(*), sum(a.id * 7 + b.id) FROM patches a JOIN patches b ON a.patch && b.patch WHERE b.id % 10 = 0
    UNION ALL SELECT 'box box', count(*), sum(a.id * 7 + b.id) FROM boxes a JOIN boxes b ON a.box && b.box WHERE b.id % 10 = 0
    UNION ALL SELECT 'box solid', count(*), sum(a.id * 7 + b.id) FROM boxes a JOIN solids b ON a.box && b.solid WHERE b.id % 10 = 0
    UNION ALL SELECT 'box scan', count(*), sum(a.id * 7 + b.id) FROM boxes a JOIN patches b ON a.box && b.patch WHERE b.id % 10 = 0
$$;
CREATE TEMP TABLE results (run text, what text, pairs bigint, sum numeric);
CREATE PROCEDURE run_both(run text) LANGUAGE plpgsql AS $$
BEGIN
    SET LOCAL enable_seqscan = on; SET LOCAL enable_indexscan = off; SET LOCAL enable_bitmapscan = off; SET LOCAL enable_indexonlyscan = off;
    INSERT INTO results SELECT run || ' sequential', * FROM counts();
    SET LOCAL enable_seqscan = off; SET LOCAL enable_indexscan = on; SET LOCAL enable_bitmapscan = on;
    INSERT INTO results SELECT run || ' index', * FROM counts();
END $$;
CALL run_both('built');
DELETE FROM solids WHERE id % 3 = 0; DELETE FROM patches WHERE id % 3 = 1; DELETE FROM boxes WHERE id % 3 = 2;
VACUUM solids, patches, boxes;
INSERT INTO solids SELECT id + 10000, solid FROM solids WHERE id % 5 = 0;
INSERT INTO patches SELECT id + 10000, patch FROM patches WHERE id % 5 = 0;
INSERT INTO boxes SELECT id + 10000, box FROM boxes WHERE id % 5 = 0;
CALL run_both('changed');
SELECT i.what, i.pairs = s.pairs AND i.sum = s.sum AS same, i.pairs > 500 AS not_empty, split_part(i.run, ' ', 1) AS run
FROM results i JOIN results s ON i.what = s.what AND i.run LIKE '% index' AND s.run = replace(i.run, 'index', 'sequential')
ORDER BY i.run DESC, i.what;

-- the join of the tour uses the index by itself
EXPLAIN (COSTS OFF) SELECT s.id, count(*) FROM solids s LEFT JOIN patches p ON p.patch && s.solid WHERE s.id = 7 GROUP BY s.id;
-- and the operators have no other plan to fall into: commutated, the same
EXPLAIN (COSTS OFF) SELECT count(*) FROM patches WHERE ab_box(10, 10, 0, 11, 11, 1) && patch;
DROP TABLE solids, patches, boxes;
DROP PROCEDURE run_both; DROP FUNCTION counts;
