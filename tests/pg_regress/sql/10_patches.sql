-- Patches taken apart, filtered, thinned, moved, joined.
SET extra_float_digits = 1;
CREATE TABLE patch AS
SELECT st AS station, ab_scan(ARRAY[600000, 5300000 + st, 500]::float8[],
       array_agg(ARRAY[600004, 5300000 + st + 0.02 * i, 500 + 0.02 * j]::float8[] ORDER BY i, j), 0.005, st) AS p
FROM generate_series(0, 1) st, generate_series(-20, 19) i, generate_series(-20, 19) j GROUP BY st;
SELECT station, count(*), count(DISTINCT origin) AS origins, round(min(range)::numeric, 3) AS nearest, round(max(range)::numeric, 3) AS farthest FROM patch, ab_beams(p) GROUP BY 1 ORDER BY 1;
SELECT bool_and(abs(point[1] - 600004) <= 0.00005 + 1e-9) AS kept_to_half_a_quantum, bool_and(abs(direction[1]^2 + direction[2]^2 + direction[3]^2 - 1) < 1e-12) AS unit FROM patch, ab_beams(p);
SELECT round(axis[1]::numeric, 3) AS axis_x, half_angle BETWEEN 0.1 AND 0.2 AS narrow FROM patch, ab_cone(p) WHERE station = 0;
SELECT round(nearest::numeric, 3), round(farthest::numeric, 3) FROM patch, ab_range(p) WHERE station = 0;
-- by box, by range, thinned: as counted beam by beam
SELECT ab_count(ab_filter(p, b)) = (SELECT count(*) FROM ab_beams(p) WHERE point[2] BETWEEN 5300000 AND 5300000.1 AND point[3] BETWEEN 500 AND 501) AS as_counted, ab_count(ab_filter(p, b)) > 50 AS some
FROM patch, ab_box(600003, 5300000, 500, 600005, 5300000.1, 501) b WHERE station = 0;
SELECT ab_filter(p, ab_box(0, 0, 0, 1, 1, 1)) IS NULL AS nothing_there, ab_filter(p, 100) IS NULL AS nothing_so_far FROM patch WHERE station = 0;
SELECT ab_count(ab_filter(p, 0, 4.005)) = (SELECT count(*) FROM ab_beams(p) WHERE range <= 4.005) AS as_counted FROM patch WHERE station = 0;
SELECT ab_count(ab_thin(p, 0.1)) AS thinned, ab_count(p) FROM patch WHERE station = 0;
-- moved there and back; the origin moves along
SELECT ab_origin(ab_transform(p, q)) AS origin, (SELECT max(abs(a.point[1] - b.point[1]) + abs(a.point[2] - b.point[2])) < 0.0003 FROM (SELECT row_number() OVER () n, point FROM ab_beams(p)) a JOIN (SELECT row_number() OVER () n, point FROM ab_beams(ab_transform(ab_transform(p, q), ab_inverse(q)))) b USING (n)) AS there_and_back
FROM patch, ab_pose(ARRAY[-600000, -5300000, -500]) q WHERE station = 0;
-- joined: halves of one station are one patch again; two stations are not
SELECT count(*), sum(ab_count(t)) FROM (SELECT ab_retile(ARRAY[ab_filter(p, ab_box(6e5, 0, 0, 7e5, 6e6, 500)), ab_filter(p, ab_box(6e5, 0, 500.001, 7e5, 6e6, 600)), NULL]) AS t FROM patch WHERE station = 0) x;
SELECT ab_retile(array_agg(p)) FROM patch;
SELECT count(*) FROM ab_retile(ARRAY[]::ab_scan[]);
-- sees: sharper than &&, and never false where a beam comes near
SELECT count(*) AS boxes, count(*) FILTER (WHERE p && b) AS overlap, count(*) FILTER (WHERE ab_sees(p, b)) < count(*) FILTER (WHERE p && b) AS sharper,
       count(*) FILTER (WHERE NOT ab_sees(p, b) AND ab_filter(p, b) IS NOT NULL) AS denied
FROM patch, generate_series(0, 50) i, generate_series(-12, 12) j, generate_series(-12, 12) k, ab_box(600000 + i * 0.1, 5300000 + j * 0.1, 500 + k * 0.1, 600000.05 + i * 0.1, 5300000.05 + j * 0.1, 500.05 + k * 0.1) b
WHERE station = 0;
-- wrong arguments
SELECT ab_thin(p, 0) FROM patch WHERE station = 0;
SELECT ab_thin(p, 'nan') FROM patch WHERE station = 0;
SELECT ab_filter(p, 3, 2) FROM patch WHERE station = 0;
SELECT ab_filter(p, 'nan'::float8) FROM patch WHERE station = 0;
SELECT ab_sees(p, ab_box(0,0,0,1,1,1), -1) FROM patch WHERE station = 0;
SELECT ab_retile(ARRAY[ARRAY[p]]) FROM patch WHERE station = 0;
SELECT ab_transform(p, ab_pose(ARRAY[0,0,0], scale => 1e8)) FROM patch WHERE station = 0;
-- from rows and back: every return, to half a quantum; by workers the same beams
CREATE TABLE ret AS SELECT station, origin, point[1] AS x, point[2] AS y, point[3] AS z FROM patch, ab_beams(p);
SELECT station, count(*) AS patches, sum(ab_count(c)), bool_and(ab_station(c) = station) AS of_station, sum((SELECT count(*) FROM ab_beams(c) b JOIN ret r ON r.station = x.station AND abs(r.x - b.point[1]) < 0.00006 AND abs(r.y - b.point[2]) < 0.00006 AND abs(r.z - b.point[3]) < 0.00006)) AS found
FROM (SELECT station, unnest(ab_scan_agg(x, y, z, origin, station)) AS c FROM ret GROUP BY station) x GROUP BY 1 ORDER BY 1;
SET parallel_setup_cost = 0; SET parallel_tuple_cost = 0; SET min_parallel_table_scan_size = 0; ALTER TABLE ret SET (parallel_workers = 2);
EXPLAIN (COSTS OFF) SELECT ab_scan_agg(x, y, z, origin, station) FROM ret WHERE station = 1;
SELECT sum(ab_count(c)) FROM (SELECT unnest(ab_scan_agg(x, y, z, origin, station)) AS c FROM ret WHERE station = 1) q;
RESET parallel_setup_cost; RESET parallel_tuple_cost; RESET min_parallel_table_scan_size;
SELECT ab_scan_agg(x, y, z, origin, station) FROM ret;
SELECT ab_scan_agg(x, y, z, origin, station) IS NULL AS nothing FROM ret WHERE false;
SELECT ab_scan_agg(x, y, 'nan', origin, station) FROM ret WHERE station = 0;
SELECT ab_scan_agg(x, y, z, ARRAY[1], station) FROM ret WHERE station = 0;
DROP TABLE patch, ret;
