-- Intensity, colour, beams without return, moving platforms and points without origin: made, read, joined, damaged.
SET extra_float_digits = 1;
\set VERBOSITY sqlstate
-- wrong input first
SELECT ab_scan(ARRAY[0,0,0], ARRAY[[1,0,0],[1,0.1,0]], intensity => ARRAY[1]);
SELECT ab_scan(ARRAY[0,0,0], ARRAY[[1,0,0]], intensity => ARRAY[65536]);
SELECT ab_scan(ARRAY[0,0,0], ARRAY[[1,0,0]], intensity => ARRAY[NULL]::int[]);
SELECT ab_scan(ARRAY[0,0,0], ARRAY[[1,0,0]], colour => ARRAY[[0,-1,0]]);
SELECT ab_scan(ARRAY[0,0,0], ARRAY[[1,0,0]], colour => ARRAY[0,1,0]);
SELECT ab_scan(ARRAY[[0,0,0],[1,0,0]], ARRAY[[1,0,0]]);
SELECT ab_scan(ARRAY[[0,0,0]], ARRAY[[1,0,0]], no_return => ARRAY[[1,0,0]]);
SELECT ab_scan(ARRAY[0,0,0], ARRAY[]::float8[]);
SELECT ab_cloud(ARRAY[]::float8[]);
SELECT ab_cloud(ARRAY[['nan',0,0]]::float8[]);
SELECT ab_cloud(ARRAY[[1e6,0,0],[0,0,0]]::float8[]);
SELECT ab_union(ARRAY[ab_scan(ARRAY[0,0,0], ARRAY[[1,0,0]]), ab_cloud(ARRAY[[1,0,0]])]);
SELECT ab_scan_agg(1, 2, 3, ARRAY[0, 0, 0], 1, -1);
SELECT ab_scan_agg(1, 2, 3, ARRAY[0, 0, 0], 1, 1, ARRAY[1, 2]);
SELECT ab_scan_agg(x, 2, 3, ARRAY[0, 0, 0], x) FROM generate_series(1, 2) x;
SELECT ab_filter(ab_cloud(ARRAY[[1,2,3],[6,6,6]]), 0, 5);
\set VERBOSITY default
SELECT ab_union(array_agg(ab_cloud(p))) FROM (SELECT array_agg(ARRAY[i, k, 0]) p FROM generate_series(1, 3000) i, generate_series(1, 2) k GROUP BY k) q;
-- the least patches
SELECT ab_count(p), ab_return_count(p), ab_origin(p), ab_point_box(p) FROM ab_scan(ARRAY[1,2,3], ARRAY[[1,2,3]]) p;
SELECT ab_count(p), ab_return_count(p), (ab_range(p)).* FROM ab_scan(ARRAY[1,2,3], ARRAY[]::float8[], no_return => ARRAY[[0,0,9]]) p;
SELECT ab_count(p), (ab_range(p)).*, (ab_cone(p)).half_angle, pg_column_size(p) < 1500 AS small FROM (SELECT ab_scan(ARRAY[0,0,0], array_agg(ARRAY[0, 0, 10000])) p FROM generate_series(1, 4096)) q;
SELECT ab_count(p), (ab_range(p)).* FROM ab_scan(ARRAY[0,0,0], ARRAY[[0,0,0],[0,0,10000]]) p;
SELECT ab_scan(ARRAY[0,0,0], array_agg(ARRAY[0, 0, 1])) FROM generate_series(1, 4097);
SELECT (ab_range(ab_cloud(ARRAY[[1,2,3],[6,6,6]]))).*;
-- the finest quantum of a union wins, whatever the order
SELECT max(abs(b.point[1] - 5.0004)) < 0.00006 AS fine FROM (VALUES (1), (2)) o(k), LATERAL (SELECT ab_union(p ORDER BY k * q) AS u FROM (VALUES (1, ab_scan(ARRAY[0,0,0], ARRAY[[5, 0, 0]], quantum => 0.001)), (-1, ab_scan(ARRAY[0,0,0], ARRAY[[5.0004, 1, 0]]))) v(q, p)) x, ab_beams(u) b WHERE b.point[2] > 0.5;
-- what is asked for exactly where a return is, is seen
SELECT count(*) AS seen FROM generate_series(1, 500) i, ab_scan(ARRAY[6e6 + 0.1 * i, 6e6, 0.3 * i], ARRAY[[6e6 + 5 + 0.37 * i, 6e6 + 0.7 * i, 1]]) p WHERE ab_sees(p, ab_point_box(p));
-- intensity and colour, with beams that did not return, at 6 000 000 m
CREATE TABLE patch (kind text, p ab_scan);
INSERT INTO patch SELECT 'tripod', ab_scan(ARRAY[6e6, 6e6, 0], array_agg(ARRAY[6e6 + 5, 6e6 + i * 0.01, j * 0.01] ORDER BY i, j), 0.002, 7,
  intensity => array_agg(100 * i + j ORDER BY i, j), colour => array_agg(ARRAY[i, 2 * j, 255 - i] ORDER BY i, j), no_return => ARRAY[[5, -0.01, 0], [5, -0.02, 0]])
FROM generate_series(0, 49) i, generate_series(0, 49) j;
INSERT INTO patch SELECT 'moving', ab_scan(array_agg(ARRAY[6e6, 6e6 + i * 0.02, 1.5] ORDER BY i, j), array_agg(ARRAY[6e6 + 5, 6e6 + i * 0.02, j * 0.01] ORDER BY i, j), station => 8, intensity => array_agg(i ORDER BY i, j))
FROM generate_series(0, 49) i, generate_series(0, 49) j;
INSERT INTO patch SELECT 'cloud', ab_cloud(array_agg(ARRAY[6e6 + 5, 6e6 + i * 0.01, j * 0.01] ORDER BY i, j), colour => array_agg(ARRAY[i, j, 0] ORDER BY i, j))
FROM generate_series(0, 49) i, generate_series(0, 49) j;
SELECT kind, ab_count(p), ab_return_count(p), ab_station(p), ab_origin(p), (ab_cone(p)).half_angle < 0.2 AS narrow, ab_box(p) AS box FROM patch;
SELECT kind, count(*), count(origin) AS origins, count(DISTINCT origin) AS places, count(point) AS points, count(range) AS ranges, count(direction) AS directions, count(intensity) AS intensities, count(colour) AS colours
FROM patch, ab_beams(p) GROUP BY kind ORDER BY kind;
SELECT kind, bool_and(intensity = 100 * i + j) AS intensity, bool_and(colour = ARRAY[i, 2 * j, 255 - i]) AS colour, bool_and(abs(point[3] - j * 0.01) <= 0.00005 + 1e-9) AS place, count(*)
FROM (SELECT *, round((point[2] - 6e6) * 100)::int AS i, round(point[3] * 100)::int AS j FROM patch, ab_beams(p) WHERE kind = 'tripod' AND point IS NOT NULL) b GROUP BY 1;
SELECT bool_and(abs(origin[2] - point[2]) < 1e-9 AND abs(range^2 - 25 - (point[3] - 1.5)^2) < 1e-6 AND intensity = round((point[2] - 6e6) * 50)) AS as_made, count(*) FROM patch, ab_beams(p) WHERE kind = 'moving';
SELECT bool_and(colour = ARRAY[round((point[2] - 6e6) * 100)::int, round(point[3] * 100)::int, 0]) AS as_made FROM patch, ab_beams(p) WHERE kind = 'cloud';
-- round trips to the bit: text, binary; planes go along when filtered, thinned, moved, joined, cut anew
SELECT kind, p::text::ab_scan::text = p::text AS by_text, _ab_scan_send(p) = _ab_scan_send(p::text::ab_scan) AS by_bytes FROM patch;
SELECT kind, (SELECT count(*) FROM patch o, ab_beams(o.p) a JOIN ab_beams(f) b ON a.point = b.point AND a.origin IS NOT DISTINCT FROM b.origin AND a.intensity IS NOT DISTINCT FROM b.intensity AND a.colour IS NOT DISTINCT FROM b.colour WHERE o.kind = patch.kind) = ab_count(f) AS same, ab_count(f)
FROM patch, ab_filter(p, ab_box(6e6, 6e6, 0.1, 6000006, 6000000.2, 0.3)) f;
SELECT kind, ab_count(ab_thin(p, 0.1)) AS thinned FROM patch;
SELECT kind, (SELECT sum(intensity + 1) FROM ab_beams(t)) IS NOT DISTINCT FROM (SELECT sum(intensity + 1) FROM ab_beams(p)) AS intensity, abs(b.point[1] - 6000015) < 0.0002 AS moved, abs(b.origin[1] - 6000010) < 0.0002 AS origin_too
FROM patch, ab_transform(p, ab_pose(ARRAY[10, 0, 0])) t, LATERAL (SELECT * FROM ab_beams(t) LIMIT 1) b;
SELECT kind, ab_count(u) AS joined, (SELECT count(*) FROM ab_retile(ARRAY[p, p])) AS patches, (SELECT sum(ab_count(r)) FROM ab_retile(ARRAY[p, p]) r) AS beams, (SELECT sum(b.intensity) FROM ab_retile(ARRAY[p, p]) r, ab_beams(r) b) = 2 * (SELECT sum(intensity) FROM ab_beams(p)) AS intensity
FROM patch, LATERAL (SELECT ab_union(h) AS u FROM (VALUES (ab_filter(p, ab_box(6e6, 6e6, 0.3, 6000006, 6000002, 0.5))), (ab_filter(p, ab_box(6e6, 6e6, 0, 6000006, 6000002, 0.2))), (NULL)) v(h)) x;
-- by rows: one origin, many, none; with planes
CREATE TABLE ret AS SELECT kind, ab_station(p) AS station, origin, point[1] AS x, point[2] AS y, point[3] AS z, intensity, colour FROM patch, ab_beams(p) WHERE point IS NOT NULL;
SELECT 'tripod', ab_origin(c), ab_count(c), (SELECT count(*) FROM ab_beams(c) b JOIN ret r ON r.kind = 'tripod' AND r.colour = b.colour AND r.intensity = b.intensity AND abs(r.y - b.point[2]) < 0.0001) AS found FROM (SELECT unnest(ab_scan_agg(x, y, z, origin, station, intensity, colour)) c FROM ret WHERE kind = 'tripod') q
UNION ALL SELECT 'moving', ab_origin(c), ab_count(c), (SELECT count(DISTINCT origin) FROM ab_beams(c)) FROM (SELECT unnest(ab_scan_agg(x, y, z, origin, station, intensity)) c FROM ret WHERE kind = 'moving') q
UNION ALL SELECT 'cloud', ab_origin(c), ab_count(c), (SELECT count(*) FROM ab_beams(c) WHERE origin IS NULL) FROM (SELECT unnest(ab_cloud_agg(x, y, z, 5)) c FROM ret WHERE kind = 'cloud') q;
-- damage of the payload is told as such, wherever it is
\set VERBOSITY sqlstate
CREATE FUNCTION damaged(p ab_scan, place int) RETURNS text LANGUAGE plpgsql AS $$
DECLARE b bytea := _ab_scan_send(p);
BEGIN PERFORM ('ab_scan:1:' || encode(set_byte(b, place, get_byte(b, place) # 255), 'hex'))::ab_scan; RETURN 'taken';
EXCEPTION WHEN OTHERS THEN RETURN SQLSTATE; END $$;
SELECT kind, damaged(p, 200 + (i * 7919) % (length(_ab_scan_send(p)) - 200)) AS sqlstate, count(*) FROM patch, generate_series(1, 200) i GROUP BY 1, 2 ORDER BY 1, 2;
SELECT kind, damaged(p, 0) AS newer_version, damaged(p, 4) AS count_too_small, damaged(p, 7) AS count_huge FROM patch;
SELECT DISTINCT damaged(p, i) FROM patch, generate_series(0, 199) i ORDER BY 1;
DROP FUNCTION damaged; DROP TABLE patch, ret;
