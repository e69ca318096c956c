-- Uncertain points, lines, planes and poses.
SET extra_float_digits = 1;
-- text and binary round-trip exactly, and keep every number
CREATE TABLE object (id int, p ab_point, l ab_line, pl ab_plane, po ab_pose);
INSERT INTO object
SELECT i, a, ab_line(a, b), ab_plane(a, b, c), ab_pose(ARRAY[i, 2, 3], ARRAY[1, 0.1 * i, 0.2, -0.3], 1.001, 0.001, 0.002, 0.0001)
FROM generate_series(1, 40) i,
     LATERAL (SELECT ab_point(600000 + sin(i), 5300000 + cos(i), 500, 0.001 * i) a, ab_point(600003 + cos(i), 5300001, 501, 0.002) b,
                     ab_point(600001, 5300004 + sin(i), 502, covariance => '{{4e-6,1e-6,0},{1e-6,3e-6,1e-6},{0,1e-6,9e-6}}') c) x;
SELECT count(*) AS same FROM object
WHERE p = p::text::ab_point AND l = l::text::ab_line AND pl = pl::text::ab_plane AND po = po::text::ab_pose
  AND p = p::float8[]::ab_point AND l = l::float8[]::ab_line AND pl = pl::float8[]::ab_plane AND po = po::float8[]::ab_pose;
CREATE TABLE copied (LIKE object);
\copy object TO 'uncertain.bin' (FORMAT binary)
\copy copied FROM 'uncertain.bin' (FORMAT binary)
\! rm -f uncertain.bin
SELECT count(*) AS same FROM object o JOIN copied c USING (id, p, l, pl, po);
SELECT ab_point(1, 2, 3), ab_point(1, 2, 3, sd => 0.5), '{1,2,3}'::float8[]::ab_point;
SELECT ab_plane(ARRAY[0,0,1]::float8[], ARRAY[0,0,2]::float8[], 0.5, 0.25);
SELECT ab_x(p), ab_y(p), ab_z(p), ab_position(p), ab_sd(p), ab_covariance(p) FROM (SELECT ab_point(1, 2, 3, 0.5) p) x;
SELECT ab_translation(q), ab_rotation(q), ab_scale(q), (ab_covariance(q))[7][7] FROM (SELECT ab_pose(ARRAY[1,2,3]::float8[], ARRAY[2,0,0,0]::float8[], 2, sd_scale => 0.5) q) x;
-- order, hash
SELECT count(DISTINCT p) AS points, count(DISTINCT l::text) AS lines FROM (SELECT p, l FROM object UNION ALL SELECT p, l FROM copied) x;
SELECT array_agg(ab_x(p) ORDER BY p) FROM (VALUES (ab_point(2,0,0)), (ab_point(-1,0,0)), (ab_point(1,5,0)), (ab_point(1,4,0))) v(p);
SELECT ab_point(0,0,0) = ab_point(-0.0::float8,0,0) AS zero_is_zero, _ab_hash(ab_point(0,0,0)) = _ab_hash(ab_point(-0.0::float8,0,0)) AS hashes_alike;
CREATE INDEX ON object USING hash (pl);
SET enable_seqscan = off;
SELECT count(*) FROM object WHERE pl = (SELECT pl FROM copied WHERE id = 7);
RESET enable_seqscan;
-- constructions, by hand
SELECT round(ab_x(m)::numeric, 12) x, round((ab_sd(m))[1]::numeric, 12) sd FROM (SELECT ab_midpoint(ab_point(0,0,0,0.003), ab_point(2,0,0,0.004)) m) x;
SELECT round(distance::numeric, 12) distance, round(sd::numeric, 12) sd FROM ab_distance(ab_point(0,0,0,0.003), ab_point(3,4,0,0.004));
SELECT round(distance::numeric, 12) distance, round(sd::numeric, 12) sd FROM ab_distance(ab_point(0,0,-2,0.003), ab_plane(ARRAY[0,0,1]::float8[], ARRAY[0,0,1]::float8[], 0.004));
SELECT round(distance::numeric, 12) distance, round(sd::numeric, 12) sd FROM ab_distance(ab_point(1,0,2,0.003), ab_line(ab_point(0,0,0,0.004), ab_point(2,0,0,0.004)));
SELECT round(distance::numeric, 12) distance, round(sd::numeric, 12) sd FROM ab_distance(ab_line('{0,0,0}'::float8[], '{1,0,0}'::float8[]), ab_line('{0,0,5}'::float8[], '{0,1,5}'::float8[]));
SELECT ab_position(ab_intersection(ab_plane(ARRAY[1,0,0], ARRAY[1,0,0]), ab_plane(ARRAY[0,2,0], ARRAY[0,1,0]), ab_plane(ARRAY[0,0,3], ARRAY[0,0,1])));
SELECT ab_position(ab_intersection(ab_line('{0,0,0}'::float8[], '{1,1,1}'::float8[]), ab_plane(ARRAY[0,0,3], ARRAY[0,0,1])));
SELECT ab_direction(ab_intersection(ab_plane(ARRAY[0,0,0], ARRAY[1,0,0]), ab_plane(ARRAY[0,0,0], ARRAY[0,1,0])));
SELECT ab_position(ab_foot(ab_point(1,2,3), ab_plane(ARRAY[0,0,1], ARRAY[0,0,1]))), ab_position(ab_foot(ab_point(1,2,3), ab_line('{0,0,0}'::float8[], '{0,0,9}'::float8[])));
SELECT line, covariance[4][4] FROM ab_plucker(ab_line('{1,0,0}'::float8[], '{1,1,0}'::float8[]));
SELECT ab_position(ab_transform(ab_point(1,0,0), ab_pose(ARRAY[10,0,0]::float8[], ARRAY[cos(pi()/4),0,0,sin(pi()/4)], 2))) AS turned_and_doubled;
SELECT (ab_distance(ab_transform(ab_transform(p, po), ab_inverse(po)), p)).distance < 1e-8 AS there_and_back, count(*) FROM object GROUP BY 1;
SELECT (ab_distance(ab_transform(p, ab_transform(po, q)), ab_transform(ab_transform(p, po), q))).distance < 1e-8 AS associates, count(*)
FROM object, (SELECT po q FROM object WHERE id = 3) x GROUP BY 1;
SELECT ab_volume(ab_transform(ab_solid(ab_box(0,0,0,1,2,3)), ab_pose(ARRAY[5,5,5]::float8[], scale => 2))) AS eightfold;
-- best fits
SELECT ab_normal(p) AS normal, round((ab_covariance(p))[4][4]::numeric, 12) AS offset_variance FROM (
    SELECT ab_plane_agg(ab_point(i, j, 2, 0.01)) p FROM generate_series(1, 10) i, generate_series(1, 10) j) x;
SELECT (ab_distance(ab_start(l), ab_point(0,0,0))).distance < 1e-9 AS starts_at_the_first, (ab_distance(ab_end(l), ab_point(10,20,0))).distance < 1e-9 AS ends_at_the_last FROM (SELECT ab_line(array_agg(ab_point(i, 2 * i, 0, 0.01))) l FROM generate_series(0, 10) i) x;
-- tests
SELECT round(statistic::numeric, 9) statistic, dof, round(p_value::numeric, 6) p_value FROM ab_test_same(ab_point(0,0,0,0.003), ab_point(0.005,0,0,0.004));
SELECT round(statistic::numeric, 9) statistic, dof, round(p_value::numeric, 6) p_value FROM ab_test_incident(ab_point(5,5,0.0098,0.003), ab_plane('{5,5,0}', '{0,0,1}', 0.004));
SELECT ab_is_incident(ab_point(5,5,0.0097,0.003), ab_plane('{5,5,0}', '{0,0,1}', 0.004)) AS on_it, ab_is_incident(ab_point(5,5,0.0099,0.003), ab_plane('{5,5,0}', '{0,0,1}', 0.004)) AS beside_it;
SELECT (ab_test_incident(a, l)).dof, (ab_test_incident(l, p)).dof, (ab_test_same(p, q)).dof, (ab_test_parallel(l, m)).dof, (ab_test_parallel(p, q)).dof, (ab_test_parallel(l, p)).dof,
       (ab_test_orthogonal(l, m)).dof, (ab_test_orthogonal(p, q)).dof, (ab_test_orthogonal(l, p)).dof, (ab_test_coplanar(l, m)).dof
FROM (SELECT ab_point(0,0,0,0.01) a, ab_line(ab_point(0,0,0,0.01), ab_point(1,0,0,0.01)) l, ab_line(ab_point(0,1,0,0.01), ab_point(1,1,0,0.01)) m,
             ab_plane('{0,0,0}', '{0,0,1}', 0.01, 0.001) p, ab_plane('{0,0,1}', '{0,0,1}', 0.01, 0.001) q) x;
SELECT ab_is_parallel(l, m), ab_is_orthogonal(l, n), ab_is_coplanar(l, m), ab_is_coplanar(l, n), ab_is_same(p, q), ab_is_parallel(p, q)
FROM (SELECT ab_line(ab_point(0,0,0,0.01), ab_point(1,0,0,0.01)) l, ab_line(ab_point(0,1,0,0.01), ab_point(1,1,0,0.01)) m, ab_line(ab_point(0,1,1,0.01), ab_point(0,2,1,0.01)) n,
             ab_plane('{0,0,0}', '{0,0,1}', 0.01, 0.001) p, ab_plane('{0,0,1}', '{0,0,1}', 0.01, 0.001) q) x;
SELECT round(half_axis::numeric, 6) half_axis, direction FROM ab_ellipsoid(ab_point(0,0,0, covariance => '{{1,0,0},{0,4,0},{0,0,9}}'), 0.95);
SELECT ab_box(ab_point(0,0,0,1), 0.95);
SELECT setseed(0.5);
-- search within k sigma: index and sequence agree, near and far, tight and loose
CREATE TABLE cloud AS SELECT i AS id, ab_point(10 * random(), 10 * random(), random(), sd => 0.001 + 0.03 * random()) AS p FROM generate_series(1, 20000) i;
CREATE INDEX cloud_p ON cloud USING gist (p);
ANALYZE cloud;
CREATE TABLE question AS SELECT i AS id, ab_point(10 * random(), 10 * random(), random(), sd => 0.05 * random()) AS q, i % 6 AS k FROM generate_series(1, 400) i;
SET enable_seqscan = off; SET enable_bitmapscan = on;
CREATE TABLE by_index AS SELECT question.id AS q, cloud.id AS c FROM question JOIN cloud ON ab_within(cloud.p, question.q, question.k);
EXPLAIN (COSTS OFF) SELECT id FROM cloud WHERE ab_within(p, '(5,5,0.5;0.01,0,0,0.01,0,0.01)'::ab_point, 3);
RESET enable_seqscan; SET enable_indexscan = off; SET enable_bitmapscan = off;
CREATE TABLE in_sequence AS SELECT question.id AS q, cloud.id AS c FROM question JOIN cloud ON ab_mahalanobis(cloud.p, question.q) <= question.k;
RESET enable_indexscan; RESET enable_bitmapscan;
SELECT (SELECT count(*) FROM by_index) > 100 AS found_some, (SELECT count(*) FROM (TABLE by_index EXCEPT TABLE in_sequence) x) AS too_many, (SELECT count(*) FROM (TABLE in_sequence EXCEPT TABLE by_index) x) AS missed;
CREATE TABLE segment AS SELECT id, ab_line(p, ab_point(ab_x(p) + 0.3, ab_y(p), ab_z(p), 0.01)) l FROM cloud;
CREATE INDEX segment_l ON segment USING gist (l);
SET enable_seqscan = off;
SELECT count(*) > 50 AS found_some, count(*) = (SELECT count(*) FROM segment WHERE _ab_overlaps(l, ab_box(4,4,0,5,5,1))) AS index_is_sequence FROM segment WHERE l && ab_box(4,4,0,5,5,1);
SELECT count(*) > 30 AS found_some, count(*) = (SELECT count(*) FROM cloud WHERE _ab_overlaps(p, ab_box(4,4,0,5,5,1))) AS index_is_sequence FROM cloud WHERE p && ab_box(4,4,0,5,5,1);
RESET enable_seqscan;
DROP TABLE object, copied, cloud, question, by_index, in_sequence, segment;

-- evidence from tie points with their cameras, and from points without origin
CREATE TABLE wall AS SELECT 1 AS id, ab_solid(ab_box(-0.2, 0, 0, 0, 1, 1)) AS solid UNION ALL SELECT 2, ab_solid(ab_box(-5, 0, 0, -4.8, 1, 1)) UNION ALL SELECT 3, ab_solid(ab_box(1, 0.2, 0.2, 1.1, 0.8, 0.8));
CREATE TABLE tie AS SELECT ab_point(0.001 * sin(i * i), (i % 60) / 60.0, (i / 60) / 60.0, sd => 0.001) AS p, ARRAY[[4, 0.2, 0.5], [4, 0.8, 0.5]]::float8[] AS cameras FROM generate_series(0, 3599) i;
CREATE INDEX ON tie USING gist (p);
SELECT id, verdict, best_loa, coverage > 0.2 AS seen FROM (SELECT id, ab_evidence_agg(solid, p, cameras, ab_evidence_model()) e FROM wall LEFT JOIN tie ON true GROUP BY id) x, ab_summary(e) ORDER BY 1;
SELECT id, verdict, ab_station_count(e) FROM (SELECT id, ab_evidence_agg(solid, p, NULL, ab_evidence_model()) e FROM wall LEFT JOIN tie ON p && solid GROUP BY id) x, ab_summary(e) ORDER BY 1;
SET enable_seqscan = off; SET enable_mergejoin = off; SET enable_hashjoin = off;
SELECT (SELECT count(*) FROM wall JOIN tie ON p && solid) = (SELECT count(*) FROM wall JOIN tie ON _ab_overlaps(solid, p)) AS index_is_sequence;
EXPLAIN (COSTS OFF) SELECT count(*) FROM wall JOIN tie ON p && solid;
RESET enable_seqscan; RESET enable_mergejoin; RESET enable_hashjoin;
SELECT ab_evidence_agg(solid, ab_point(0,0,0), '{{1,2}}', ab_evidence_model()) FROM wall WHERE id = 1;
SELECT ab_evidence_agg(solid, ab_point(0,0,0), '{{1,2,nan}}', ab_evidence_model()) FROM wall WHERE id = 1;
DROP TABLE wall, tie;

-- partitions and groups by hash; what a construction stores can be dumped and read again
CREATE TABLE part (p ab_point, m ab_mass) PARTITION BY HASH (p);
CREATE TABLE part0 PARTITION OF part FOR VALUES WITH (MODULUS 2, REMAINDER 0);
CREATE TABLE part1 PARTITION OF part FOR VALUES WITH (MODULUS 2, REMAINDER 1);
INSERT INTO part SELECT ab_point(i % 10, 0, 0), ab_mass((i % 3) / 10.0, 0.5) FROM generate_series(1, 90) i;
SELECT (SELECT count(*) FROM part0) > 0 AND (SELECT count(*) FROM part1) > 0 AS both, count(*) FROM (SELECT p, m FROM part GROUP BY p, m) x;
DROP TABLE part;
SELECT q = q::text::ab_pose AS reads_again FROM (SELECT ab_inverse(ab_inverse(ab_pose(ARRAY[600000, 5300000, 500], ARRAY[0.9, 0.1, 0.2, 0.3], sd_rotation => 1e-3))) q) x;
SELECT ab_foot(ab_point(1e9, 1e9, -1e9), ab_plane(ARRAY[-1e9, -1e9, 1e9], ARRAY[1, -0.6, 0.6]));
SELECT ab_plane(ab_point(0, 0, 0, 1e150), ab_point(1, 0, 0, 1e150), ab_point(0, 1, 0, 1e150));
SELECT ab_point(0, 0, 0, 1e200);
-- keys, order and DISTINCT of every type; arguments the other way round
CREATE TABLE keyed (m ab_mass PRIMARY KEY, l ab_line UNIQUE, pl ab_plane UNIQUE, po ab_pose UNIQUE);
INSERT INTO keyed SELECT ab_mass(i / 20.0, 0.1), ab_line(ARRAY[i, 0, 0], ARRAY[0, 1, 1]), ab_plane(ARRAY[i, 0, 0], ARRAY[0, 0, 1]), ab_pose(ARRAY[i, 0, 0]) FROM generate_series(10, 1, -1) i;
INSERT INTO keyed SELECT m, l, pl, po FROM keyed LIMIT 1;
SELECT count(DISTINCT m) AS masses, count(DISTINCT l) AS lines, count(DISTINCT pl) AS planes, count(DISTINCT po) AS poses FROM (SELECT * FROM keyed UNION ALL SELECT * FROM keyed) x;
SELECT array_agg(ab_belief(m) ORDER BY m) = array_agg(ab_belief(m) ORDER BY ab_belief(m)) AS ordered FROM keyed;
DROP TABLE keyed;
SELECT ab_distance(p, pl) = ab_distance(pl, p) AS distance, ab_distance(p, l) = ab_distance(l, p) AS from_line, ab_test_incident(p, pl) = ab_test_incident(pl, p) AS incident, ab_is_incident(l, pl, 0.5) = ab_is_incident(pl, l, 0.5) AS in_plane,
       ab_test_orthogonal(l, pl) = ab_test_orthogonal(pl, l) AS orthogonal, ab_is_parallel(pl, l) AS parallel, ab_intersection(pl, l) = ab_intersection(l, pl) AS met
FROM (SELECT ab_point(1, 2, 3, 0.01) p, ab_line(ab_point(0, 0, 0, 0.01), ab_point(1, 1, 4, 0.01)) l, ab_plane(ARRAY[0, 0, 3], ARRAY[0, 0, 1], 0.01, 0.001) pl) x;
