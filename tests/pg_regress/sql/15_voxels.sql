-- Occupancy, change and solids in voxels. Truth by hand: a scanner at the origin of a 10 cm lattice, beams along x.
SELECT ab_grid(), ab_grid(0.02, ab_box(0,0,0,1,1,1), exact => true);
SELECT 'voxel=0.05 tile=BOX3D(0 0 0,1 2 3)'::ab_grid, ab_grid(NULL) IS NULL AS no_voxel;
CREATE TABLE g AS SELECT ab_grid(0.1, ab_box(-1,-1,-1,4,1,1), 0, exact => true) AS grid;

-- three beams hit the same voxel at x = 2.0 .. 2.1, one goes through it to 3.05, one has zero length
CREATE TABLE old AS SELECT ab_scan(ARRAY[0.05,0.05,0.05], ARRAY[[2.04,0.05,0.05],[2.05,0.05,0.05],[2.06,0.05,0.05],[3.05,0.05,0.05],[0.05,0.05,0.05]], 0.001) AS patch;
CREATE TABLE new AS SELECT ab_scan(ARRAY[0.05,0.05,0.05], ARRAY[[1.04,0.05,0.05],[1.05,0.05,0.05],[1.06,0.05,0.05]], 0.001) AS patch;
CREATE TABLE o AS SELECT (SELECT ab_occupancy_agg(patch, grid) FROM old, g) AS old, (SELECT ab_occupancy_agg(patch, grid) FROM new, g) AS new;
SELECT x, ab_state(old, x, 0.05, 0.05) AS t3, ab_state(old, x, 0.05, 0.05, 1) AS t1, ab_state(new, x, 0.05, 0.05) AS new FROM o, unnest(ARRAY[-0.05, 0.05, 0.55, 1.05, 1.95, 2.05, 2.95, 3.05, 3.15, 99]) x ORDER BY x;
SELECT s.* FROM o, LATERAL ab_summary(old) s;
SELECT s.* FROM o, LATERAL ab_summary(old, 1) s;
SELECT v.* FROM o, LATERAL ab_voxels(old, threshold => 1) v ORDER BY 1, 2, 3;
SELECT count(*), min(x), max(x) FROM o, LATERAL ab_voxels(old, '{empty}') v;
SELECT ab_box(old), ab_grid(old), ab_box(ab_occupancy(ab_grid(0.1))) AS of_nothing FROM o;

-- change, by the published rule and within a tolerance
SELECT v.* FROM o, LATERAL ab_voxels(ab_change(old, new, tolerance => 0)) v ORDER BY 1, 2, 3;
SELECT s.* FROM o, LATERAL ab_summary(ab_change(old, new, 1, 0)) s;
SELECT confirmed, s.new, disappeared, unknown, ambiguous, total FROM o, LATERAL ab_summary(ab_change(new, old, 1, 0)) s;
SELECT confirmed, s.new, disappeared, unknown, ambiguous, total, round(new_share::numeric, 4) FROM o, LATERAL ab_summary(ab_change(new, old, 1), ab_solid(ab_box(1.9,0,0,2.2,0.1,0.1)), 0) s;
SELECT class, voxels, round(volume::numeric, 6) AS volume, box, centroid FROM o, LATERAL ab_components(ab_change(old, new, 1, 0), min_voxels => 1) c;
SELECT confirmed, s.new, disappeared, unknown FROM o, LATERAL ab_summary(ab_change(old, old, 1)) s;

-- it adds up, in whatever order and however it is cut: every way to the same bytes
CREATE TABLE many AS SELECT i, ab_scan(ARRAY[0.5, 0.5 * (i % 3), 1.5], (SELECT array_agg(ARRAY[6.0137 * cos(a + 0.00071), 6.0137 * sin(a + 0.00071), b + 0.0113] ORDER BY a, b) FROM generate_series(0.02 * i, 0.02 * i + 0.3, 0.01) a, generate_series(0, 1, 0.05) b), 0.01, i % 4) AS patch FROM generate_series(1, 200) i;
CREATE TABLE whole AS SELECT ab_occupancy_agg(patch, ab_grid(0.05)) AS w FROM many;
SELECT (SELECT ab_occupancy_agg(patch, ab_grid(0.05) ORDER BY i DESC) FROM many)::text = w::text AS backwards,
       ab_rollup((SELECT ab_occupancy_agg(patch, ab_grid(0.05)) FROM many WHERE i % 3 = 0), (SELECT ab_occupancy_agg(patch, ab_grid(0.05)) FROM many WHERE i % 3 > 0))::text = w::text AS rolled_up,
       (SELECT ab_rollup_agg(p) FROM (SELECT ab_occupancy_agg(patch, ab_grid(0.05)) AS p FROM many GROUP BY i % 4) s)::text = w::text AS by_station,
       (SELECT ab_rollup_agg(p) FROM (SELECT ab_occupancy_agg(patch, ab_grid(0.05, t)) AS p FROM ab_tiles(ab_box(-8,-8,-2,8,8,3), 4) t JOIN many ON patch && t GROUP BY t) s) IS NOT NULL AS by_tile,
       w::text::ab_occupancy::text = w::text AS text, ab_rollup(w, NULL)::text = w::text AS with_null FROM whole;
-- tiles know what the whole knows of them
SELECT count(*) > 20 AS many, count(*) = count(*) FILTER (WHERE t.p::text = ab_clip(w, box)::text) AS same FROM whole, (SELECT b AS box, ab_occupancy_agg(patch, ab_grid(0.05, b)) AS p FROM ab_tiles(ab_box(-8,-8,-2,8,8,3), 4) b JOIN many ON patch && b GROUP BY b) t;
SET min_parallel_table_scan_size = 0; SET parallel_setup_cost = 0; SET parallel_tuple_cost = 0;
EXPLAIN (COSTS OFF) SELECT ab_occupancy_agg(patch, ab_grid(0.05)) FROM many;
SELECT ab_occupancy_agg(patch, ab_grid(0.05))::text = (SELECT w::text FROM whole) AS in_parallel FROM many;
RESET min_parallel_table_scan_size; RESET parallel_setup_cost; RESET parallel_tuple_cost;
SELECT ab_occupancy_agg(NULL::ab_scan, grid) IS NOT NULL AS nothing_seen, ab_occupancy_agg(patch, NULL) IS NULL AS no_grid FROM old, g;
SELECT ab_occupancy_agg(patch, ab_grid()) IS NULL AS no_rows FROM old WHERE false;
-- copied in binary
\copy whole TO '/tmp/asbuilt_regress_whole.bin' (FORMAT binary)
CREATE TABLE copied (w ab_occupancy);
\copy copied FROM '/tmp/asbuilt_regress_whole.bin' (FORMAT binary)
\! rm /tmp/asbuilt_regress_whole.bin
SELECT c.w::text = w.w::text AS same FROM copied c, whole w;

-- solids
SELECT s.occupied, round(s.occupied_m3::numeric, 6) AS m3 FROM unnest(ARRAY['centre','cover','surface']) r, LATERAL ab_summary(ab_voxelize(ab_solid(ab_box(0.05,0.05,0.05,0.95,0.55,0.25)), 0.1, r), 1) s;
SELECT ab_state(m, 0.5, 0.3, 0.1), ab_state(m, 5, 5, 5) FROM ab_voxelize(ab_solid(ab_box(0,0,0,1,1,1)), 0.1) m;
SELECT s.occupied FROM ab_summary(ab_voxelize(ab_solid(ARRAY[[0,0,0],[1,0,0],[0,1,0]], ARRAY[[0,1,2]]), 0.1, 'surface'), 1) s;
SELECT ab_voxelize(ab_solid(ARRAY[[0,0,0],[1,0,0],[0,1,0]], ARRAY[[0,1,2]]), 0.1);
-- model against epoch: what is drawn at 2.0 .. 2.1 stands, what is drawn before it does not, what is drawn beside is not seen
CREATE TABLE m AS SELECT ab_rollup_agg(ab_voxelize(ab_solid(b), 0.1, 'centre', ab_box(-1,-1,-1,4,1,1))) AS model FROM unnest(ARRAY[ab_box(2,0,0,2.1,0.1,0.1), ab_box(1,0,0,1.2,0.1,0.1), ab_box(1,0.5,0,1.3,0.6,0.1)]) b;
SELECT v.* FROM m, o, LATERAL ab_voxels(ab_change(model, old, 1, 0)) v ORDER BY 1, 2;
SELECT count(*) FROM m, o, LATERAL ab_voxels(ab_change(model, old, 1, 0), '{absent,demolished}') v;

-- a change across the border of two tiles: both sides see it with their surroundings
CREATE TABLE halves AS SELECT t, ab_clip(ab_change(ab_voxelize(ab_solid(ab_box(0,0,-0.1,1,1,0)), 0.1, 'centre', ab_expand(t, 0.2)), ab_voxelize(ab_solid(ab_box(0,0,0,1,1,0.1)), 0.1, 'centre', ab_expand(t, 0.2)), 1, 0.05), t) AS change FROM ab_tiles(ab_box(0,0,-0.5,1,1,0.5), 1) t;
SELECT s.confirmed, s.new, s.disappeared FROM halves, LATERAL ab_summary(change) s ORDER BY t::text;
SELECT s.confirmed, s.total FROM (SELECT ab_rollup_agg(change) AS c FROM halves) h, LATERAL ab_summary(c) s;

-- pictures, filters, larger voxels
SELECT ab_slice(old, 'z', 0.05, 1) FROM o;
SELECT ab_slice(m, 'x', 0.55) FROM ab_voxelize(ab_solid(ab_box(0,0,0,1,0.2,0.1)), 0.1) m;
SELECT v.x, v.hits FROM o, LATERAL ab_voxels(ab_denoise(old), threshold => 1) v;
SELECT v.x, v.hits, v.state FROM o, LATERAL ab_voxels(ab_downsample(old), threshold => 1) v;
SELECT voxel, round(max_error::numeric, 6) AS max_error, absolute, relative, relative_linear FROM unnest(ARRAY[0.005, 0.01, 0.02, 0.05, 1]) voxel, LATERAL ab_voxel_accuracy(voxel);

-- joined by boxes; the index answers
CREATE TABLE tiles AS SELECT t AS tile, ab_occupancy_agg(patch, ab_grid(0.05, t)) AS grid FROM ab_tiles(ab_box(-8,-8,-2,8,8,3), 1) t JOIN many ON patch && t GROUP BY t;
CREATE INDEX ON tiles USING gist (grid);
ANALYZE tiles;
SET enable_seqscan = off;
EXPLAIN (COSTS OFF) SELECT count(*) FROM tiles WHERE grid && ab_solid(ab_box(5,0,0,6,1,1));
SELECT count(*) > 0 AS some, count(*) = (SELECT count(*) FROM tiles WHERE _ab_overlaps(grid, ab_solid(ab_box(5,0,0,6,1,1)))) AS same FROM tiles WHERE grid && ab_solid(ab_box(5,0,0,6,1,1));
RESET enable_seqscan;

-- wrong questions
SHOW asbuilt.max_grid_memory;
SET asbuilt.max_grid_memory = '1MB';
\set VERBOSITY sqlstate
SELECT ab_occupancy_agg(patch, ab_grid(0.01)) FROM many;
SELECT ab_voxelize(ab_solid(ab_box(0,0,0,50,50,50)), 0.01);
SELECT ab_state(w, 0, 0, 0) FROM whole;
\set VERBOSITY default
SET asbuilt.max_grid_memory = 12;
RESET asbuilt.max_grid_memory;
SELECT ab_grid(0);
SELECT ab_grid(-0.01);
SELECT ab_grid('NaN');
SELECT ab_grid(0.01, margin => -1);
SELECT ab_grid(0.01, no_return_range => 'NaN');
SELECT ab_grid(0.001, ab_box(0,0,0,2e6,1,1));
SELECT 'voxel=1 tile=nowhere'::ab_grid;
SELECT 'voxel=1 colour=red'::ab_grid;
SELECT ab_occupancy_agg(patch, ab_grid(0.1 * i)) FROM old, generate_series(1, 2) i;
SELECT ab_change(old, ab_occupancy(ab_grid(0.2))) FROM o;
SELECT ab_rollup(old, ab_occupancy(ab_grid(0.1))) FROM o;
SELECT ab_rollup(ab_voxelize(ab_solid(ab_box(0,0,0,1,1,1)), 0.1), ab_occupancy(ab_grid(0.1, margin => 0)));
SELECT ab_rollup(ab_change(old, new), ab_change(old, new, 2)) FROM o;
SELECT ab_rollup(ab_change(old, new, 1), ab_change(old, new, 1)) FROM o;
SELECT ab_change(old, new, 0) FROM o;
SELECT ab_change(old, new, 256) FROM o;
SELECT ab_change(old, new, 3, -1) FROM o;
SELECT ab_change(old, new, 3, 'NaN') FROM o;
SELECT ab_state(old, 'NaN', 0, 0) FROM o;
SELECT ab_state(old, 1e300, 0, 0) FROM o;
SELECT ab_voxels(old, '{full}') FROM o;
SELECT ab_voxels(old, '{unknown}') FROM o;
SELECT ab_voxels(ab_change(old, new), '{gone}') FROM o;
SELECT ab_slice(old, 'w', 0) FROM o;
SELECT ab_components(ab_change(old, new), min_voxels => -1) FROM o;
SELECT ab_components(ab_change(old, new), gap => 7) FROM o;
SELECT ab_summary(ab_change(old, new), NULL, 7) FROM o;
SELECT ab_denoise(old, 27) FROM o;
SELECT ab_downsample(ab_occupancy(ab_grid(0.1, ab_box(0,0,0,0.3,1,1))));
SELECT ab_voxelize(ab_solid(ab_box(0,0,0,1,1,1)), 0.1, 'corner');
SELECT ab_voxelize(ab_solid(ab_box(0,0,0,1,1,1)), 0);
SELECT ab_voxel_accuracy(0);
SELECT ab_tiles(ab_box(0,0,0,1,1,1), 0);
SELECT ab_tiles(ab_box(0,0,0,1e6,1e6,1e6), 0.1);
SELECT 'ab_occupancy:1:00ff'::ab_occupancy;
SELECT 'x'::ab_change;
SELECT ab_box(0,0,0,1,1,1) = ab_box(1,1,1,0,0,0) AS same, ab_box(0,0,0,1,1,1) < ab_box(0,0,0,1,1,2) AS before, count(DISTINCT t) FROM (SELECT t FROM ab_tiles(ab_box(0,0,0,2,2,2), 1) t UNION ALL SELECT t FROM ab_tiles(ab_box(0,0,0,2,1,1), 1) t) u;
DROP TABLE g, old, new, o, many, whole, copied, m, halves, tiles;
