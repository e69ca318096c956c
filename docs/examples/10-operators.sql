-- Search by an index
-- GiST indexes on boxes, solids, patches, points, lines, occupancies and changes, and the operators that they serve.
CREATE TEMP TABLE target AS       -- targets on a grid of 1 m
SELECT 10 * x + y AS id, ab_point(x, y, 1.5, sd => 0.005) AS p FROM generate_series(0, 9) x, generate_series(0, 9) y;
CREATE INDEX ON target USING gist (p);

-- ab_within
SELECT id FROM target WHERE ab_within(p, ab_point(4.01, 7, 1.5, sd => 0.005), 3);
SELECT id, p <-> ab_point(4.25, 7, 1.5) AS metres FROM target ORDER BY p <-> ab_point(4.25, 7, 1.5) LIMIT 2;
