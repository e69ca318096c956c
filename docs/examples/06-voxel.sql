-- Voxels and change
-- Space as occupied, empty and unknown, and what became of it between two epochs or against a model.
CREATE TEMP TABLE scan AS         -- a wall 3 m away; in epoch 2 a crate stands before it
SELECT epoch, ab_scan(ARRAY[0, 0, 0], array_agg(ARRAY[x, x * a * 0.02, x * b * 0.02] ORDER BY a, b),
                      0.02, epoch) AS patch
FROM   generate_series(1, 2) epoch, generate_series(-20, 20) a, generate_series(-20, 20) b,
       LATERAL (SELECT CASE WHEN epoch = 2 AND abs(a) <= 6 AND b <= -8 THEN 2.03 ELSE 3.03 END AS x) d GROUP BY epoch;
CREATE TEMP TABLE occupancy AS
SELECT epoch, ab_occupancy_agg(patch, ab_grid(0.1)) AS occupancy FROM scan GROUP BY epoch;
CREATE TEMP TABLE change AS
SELECT ab_change(old.occupancy, new.occupancy, threshold => 1) AS change
FROM   occupancy old, occupancy new WHERE old.epoch = 1 AND new.epoch = 2;

-- ab_grid
SELECT what, grid
FROM   change, occupancy, LATERAL (VALUES ('made', ab_grid(0.05, ab_box(0, -1, -1, 4, 1, 1))),
                                          ('of an occupancy', ab_grid(occupancy)),
                                          ('of a change', ab_grid(change))) v(what, grid)
WHERE  epoch = 1;

-- ab_tiles
SELECT tile FROM ab_tiles(ab_box(0, 0, 0, 9, 4, 3), 5) tile;

-- ab_occupancy_agg
SELECT epoch, ab_state(ab_occupancy_agg(patch, ab_grid(0.1)), 3.05, 0, 0, threshold => 1) AS wall
FROM   scan GROUP BY epoch ORDER BY epoch;

-- ab_occupancy
SELECT ab_state(ab_occupancy(ab_grid(0.1)), 1, 0, 0) AS never_seen;

-- ab_state
SELECT epoch, x, ab_state(occupancy, x, 0.05, -0.45, threshold => 1) AS state
FROM   occupancy, unnest(ARRAY[1, 2.05, 2.5]) x ORDER BY epoch, x;

-- ab_box(ab_occupancy) and ab_box(ab_change)
SELECT ab_box(occupancy) AS of_an_occupancy, ab_box(change) AS of_a_change FROM occupancy, change WHERE epoch = 1;

-- ab_voxels
SELECT v.* FROM occupancy, ab_voxels(occupancy, '{occupied}', threshold => 1) v
WHERE  epoch = 2 ORDER BY x, y, z LIMIT 3;
SELECT v.* FROM change, ab_voxels(change, '{new}') v ORDER BY x, y, z LIMIT 3;

-- ab_slice
-- From above, at the height of the crate, in coarse voxels.
SELECT picture[y:y] AS picture
FROM  (SELECT ab_slice(ab_occupancy_agg(patch, ab_grid(0.5)), 'z', -0.4, threshold => 1) AS picture
       FROM   scan WHERE epoch = 2) s, generate_subscripts(picture, 1) y;

-- ab_summary
SELECT s.occupied, s.ambiguous, s.empty FROM occupancy, ab_summary(occupancy, threshold => 1) s WHERE epoch = 2;
SELECT s.confirmed, s.new, s.disappeared, s.unknown, s.new_m3 FROM change, ab_summary(change) s;

-- ab_denoise
-- A bird, and a wall.
SELECT v.x, v.hits
FROM  (SELECT ab_occupancy_agg(patch, ab_grid(0.1)) AS seen
       FROM   ab_scan(ARRAY[0, 0, 0], ARRAY[[2.05, 0.05, 1.05], [3.05, 0.05, 0.05], [3.05, 0.15, 0.05]], 0.02) patch) o,
       ab_voxels(ab_denoise(seen), threshold => 1) v ORDER BY v.y;

-- ab_downsample
SELECT ab_grid(ab_downsample(occupancy)) AS twice_as_large FROM occupancy WHERE epoch = 1;

-- ab_clip
SELECT s.occupied AS wall_alone, c.new AS new_on_the_left
FROM   occupancy, change, ab_summary(ab_clip(occupancy, ab_box(2.9, -2, -2, 3.2, 2, 2)), threshold => 1) s,
       ab_summary(ab_clip(change, ab_box(0, 0, -2, 4, 2, 2))) c WHERE epoch = 2;

-- ab_rollup
-- Station by station, or tile by tile: it adds up.
SELECT s.occupied AS voxels_of_both, c.new AS new_in_both_halves
FROM   occupancy a, occupancy b, change, ab_summary(ab_rollup(a.occupancy, b.occupancy), threshold => 1) s,
       ab_summary(ab_rollup(ab_clip(change, ab_box(0, -2, -2, 4, 0, 2)),
                            ab_clip(change, ab_box(0, 0, -2, 4, 2, 2)))) c
WHERE  a.epoch = 1 AND b.epoch = 2;

-- ab_rollup_agg
SELECT s.occupied, s.empty
FROM  (SELECT ab_rollup_agg(occupancy) AS both_epochs FROM occupancy) o, ab_summary(both_epochs, threshold => 1) s;
SELECT s.new
FROM  (SELECT ab_rollup_agg(ab_clip(change, tile)) AS tiles
       FROM   change, ab_tiles(ab_box(0, -2, -2, 4, 2, 2), 1) tile) c,
       ab_summary(tiles) s;

-- ab_union(ab_occupancy, ab_occupancy)
SELECT ab_union(a.occupancy, b.occupancy) = ab_rollup(a.occupancy, b.occupancy) AS as_rollup
FROM   occupancy a, occupancy b WHERE a.epoch = 1 AND b.epoch = 2;

-- ab_change
-- The crate is new: the voxels of its front. What it hides of the wall is unknown.
SELECT s.confirmed, s.new, s.disappeared, s.unknown
FROM   occupancy old, occupancy new, ab_summary(ab_change(old.occupancy, new.occupancy, threshold => 1)) s
WHERE  old.epoch = 1 AND new.epoch = 2;

-- ab_components
SELECT c.class, c.voxels, c.volume, ab_min(c.box) AS from_corner, ab_max(c.box) AS to_corner
FROM   change, ab_components(change, min_voxels => 5) c;

-- ab_voxelize
SELECT rule, s.occupied, s.occupied_m3
FROM   unnest(ARRAY['centre', 'cover', 'surface']) rule,
       ab_summary(ab_voxelize(ab_solid(ab_box(0.05, 0.05, 0.05, 0.95, 0.55, 0.25)), 0.1, rule), threshold => 1) s;

-- ab_voxel_accuracy
SELECT voxel, a.* FROM unnest(ARRAY[0.005, 0.01, 0.02]) voxel, ab_voxel_accuracy(voxel) a;
