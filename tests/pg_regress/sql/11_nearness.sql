-- @>, <@, ~= and <->: index result = sequential result, on random, clustered and degenerate boxes, after deletes and vacuum.
SELECT setseed(0.25);
CREATE TABLE thing AS
SELECT i AS id, b, ab_solid(b) AS s, ab_point(x, y, z, 0.01 * random()) AS p
FROM (SELECT i, x, y, z, ab_box(x, y, z, x + w, y + w, z + w) b
      FROM (SELECT i, CASE i % 3 WHEN 0 THEN 100 * random() WHEN 1 THEN 50 + random() ELSE 7 END x, 100 * random() y, CASE WHEN i % 5 = 0 THEN 0 ELSE 10 * random() END z,
                   CASE WHEN i % 7 = 0 THEN 0.001 ELSE 2 * random() + 0.001 END w FROM generate_series(1, 6000) i) r) q;
ALTER TABLE thing ADD c ab_scan;
UPDATE thing SET c = ab_scan(ARRAY[(ab_min(b))[1], (ab_min(b))[2], (ab_min(b))[3]], ARRAY[[(ab_min(b))[1] + 1, (ab_min(b))[2], (ab_min(b))[3] + 0.01]], 0.01);
CREATE INDEX ON thing USING gist (b); CREATE INDEX ON thing USING gist (s); CREATE INDEX ON thing USING gist (p); CREATE INDEX ON thing USING gist (c);
DELETE FROM thing WHERE id % 10 = 3;
INSERT INTO thing SELECT id + 10000, b, s, p, c FROM thing WHERE id % 10 = 4;
VACUUM ANALYZE thing;
CREATE TABLE asked AS SELECT i AS id, CASE WHEN i <= 40 THEN b ELSE ab_box(x, y, 0, x + w, y + w, 5 * random()) END AS q
FROM (SELECT i, 100 * random() x, 100 * random() y, 8 * random() w FROM generate_series(1, 80) i) r JOIN thing t ON t.id = 10 * i + 1;
CREATE FUNCTION found(op text, col text) RETURNS TABLE (question int, answer int) LANGUAGE plpgsql AS $$
BEGIN RETURN QUERY EXECUTE format('SELECT a.id, t.id FROM asked a JOIN thing t ON t.%I %s a.q', col, op); END $$;
CREATE TABLE answers (by_index boolean, op text, col text, question int, answer int);
SET enable_seqscan = off; SET enable_nestloop = on; SET enable_hashjoin = off; SET enable_mergejoin = off;
INSERT INTO answers SELECT true, op, col, f.* FROM unnest(ARRAY['&&', '@>', '<@', '~=']) op, unnest(ARRAY['b', 's', 'p', 'c']) col, found(op, col) f;
EXPLAIN (COSTS OFF) SELECT count(*) FROM asked a JOIN thing t ON t.c <@ a.q;
SET enable_seqscan = on; SET enable_indexscan = off; SET enable_bitmapscan = off;
INSERT INTO answers SELECT false, op, col, f.* FROM unnest(ARRAY['&&', '@>', '<@', '~=']) op, unnest(ARRAY['b', 's', 'p', 'c']) col, found(op, col) f;
RESET enable_indexscan; RESET enable_bitmapscan; RESET enable_hashjoin; RESET enable_mergejoin;
SELECT op, count(*) > 5 AS some, count(*) FILTER (WHERE n <> 2) AS differ FROM (SELECT op, col, question, answer, count(*) n FROM answers GROUP BY 1, 2, 3, 4) x GROUP BY op ORDER BY op;
-- nearest first: the same distances in the same order as sorted
SET enable_seqscan = off;
EXPLAIN (COSTS OFF) SELECT id FROM thing ORDER BY c <-> ab_box(50, 50, 5, 50, 50, 5) LIMIT 10;
CREATE FUNCTION nearest(col text, too text) RETURNS TABLE (question int, n bigint, d float8) LANGUAGE plpgsql AS $$
BEGIN RETURN QUERY EXECUTE format('SELECT a.id, row_number() OVER (PARTITION BY a.id ORDER BY k.d), k.d FROM asked a, LATERAL (SELECT %1$I <-> %2$s AS d FROM thing ORDER BY %1$I <-> %2$s LIMIT 10) k', col, too); END $$;
EXPLAIN (COSTS OFF) SELECT id FROM thing ORDER BY c <-> ab_point(50, 50, 5) LIMIT 10;
CREATE TABLE near AS SELECT true AS by_index, col, too, f.* FROM unnest(ARRAY['b', 's', 'p', 'c']) col, unnest(ARRAY['a.q', 'ab_min(a.q)::ab_point']) too, nearest(col, too) f;
SET enable_seqscan = on; SET enable_indexscan = off;
INSERT INTO near SELECT false, col, too, f.* FROM unnest(ARRAY['b', 's', 'p', 'c']) col, unnest(ARRAY['a.q', 'ab_min(a.q)::ab_point']) too, nearest(col, too) f;
RESET enable_indexscan;
SELECT col, too, count(*), count(*) FILTER (WHERE a.d <> b.d) AS differ, count(*) FILTER (WHERE a.d > 0) > 100 AS apart FROM near a JOIN near b USING (col, too, question, n) WHERE a.by_index AND NOT b.by_index GROUP BY 1, 2 ORDER BY 1, 2;
-- a patch is as near as its returns, not as its hull; nothing returned is infinitely far
SELECT p <-> ab_point(0, 0, 0) AS returns, ab_box(p) <-> ab_point(0, 0, 0) AS hull, p <-> ab_box(4, 0, 0, 4, 0, 0) AS from_box FROM ab_scan(ARRAY[0,0,0], ARRAY[[5,0,0]]) p;
SELECT ab_scan(ARRAY[0,0,0], ARRAY[]::float8[], no_return => ARRAY[[5,0,0]]) <-> ab_point(0, 0, 0) AS nothing;
DROP TABLE near; DROP FUNCTION nearest;
RESET enable_seqscan; RESET enable_nestloop;
SELECT ab_box(0,0,0,3,3,3) @> ab_box(1,1,1,2,2,2) AS holds, ab_box(1,1,1,2,2,2) <@ ab_box(0,0,0,3,3,3) AS lies_in, ab_box(0,0,0,1,1,1) ~= ab_box(0,0,0,1,1,1) AS same,
       ab_box(0,0,0,1,1,1) <-> ab_box(4,5,1,9,9,9) AS distance, ab_box(0,0,0,9,9,9) @> ab_solid(ab_box(1,1,1,2,2,2)) AS holds_solid;
DROP TABLE thing, asked, answers; DROP FUNCTION found;
