-- Scan patches
-- Patches of up to 4096 beams: made, taken apart, filtered, moved, joined; from rows of points.
CREATE TEMP TABLE reading AS       -- what a scanner at (0, 0, 1.5) sees of a wall 5 m away, a beam every 10 mrad
SELECT 5 AS x, 5 * a * 0.01 AS y, 1.5 + 5 * b * 0.01 AS z, 100 + b AS intensity, ARRAY[200, 190, 180] AS colour
FROM   generate_series(-30, 30) a, generate_series(-20, 20) b ORDER BY a, b;
CREATE TEMP TABLE scan AS SELECT unnest(ab_scan_agg(x, y, z, ARRAY[0, 0, 1.5], 7)) AS patch FROM reading;

-- ab_scan
-- Three beams with a return, and one into the sky.
SELECT ab_count(p) AS beams, ab_return_count(p) AS returns, ab_box(p) AS box
FROM   ab_scan(ARRAY[0, 0, 1.5], ARRAY[[5, 0, 1.25], [5, 0, 1.5], [5, 0, 1.75]], station => 7,
               no_return => ARRAY[[0, 0, 1]]) p;

-- ab_cloud
-- Points from photographs: nobody knows where they were seen from.
SELECT ab_count(p) AS points, ab_origin(p) AS origin FROM ab_cloud(ARRAY[[5, 0, 1.25], [5, 0, 1.5], [5, 0, 1.75]]) p;

-- ab_scan_agg
-- Of one station, with intensity and colour; fewer arguments leave these out.
SELECT ab_count(p) AS beams, ab_station(p) AS station, ab_point_box(p) AS box
FROM  (SELECT unnest(ab_scan_agg(x, y, z, ARRAY[0, 0, 1.5], 7, intensity, colour)) AS p FROM reading) s;

-- ab_cloud_agg
SELECT ab_count(p) AS points, ab_station(p) AS station
FROM  (SELECT unnest(ab_cloud_agg(x, y, z, 7)) AS p FROM reading WHERE z < 1.5) s;

-- ab_count(ab_scan)
SELECT ab_count(patch) AS beams FROM scan;

-- ab_return_count
SELECT ab_count(p) AS beams, ab_return_count(p) AS returns
FROM   ab_scan(ARRAY[0, 0, 1.5], ARRAY[[5, 0, 1.5]], 0.01, no_return => ARRAY[[0, 0, 1], [0, 1, 1]]) p;

-- ab_origin
SELECT ab_origin(patch) AS scanner FROM scan;

-- ab_station
SELECT ab_station(patch) AS station FROM scan;

-- ab_box(ab_scan)
-- The beams from the scanner to the wall, and 0.25 m more on every side.
SELECT ab_box(patch) AS box FROM scan;

-- ab_point_box
SELECT ab_point_box(patch) AS wall FROM scan;

-- ab_cone
SELECT c.axis[1] AS along_x, degrees(c.half_angle) AS degrees FROM scan, ab_cone(patch) c;

-- ab_range
SELECT r.* FROM scan, ab_range(patch) r;

-- ab_beams
SELECT b.origin, b.point, b.range FROM scan, ab_beams(patch) b ORDER BY b.point LIMIT 3;

-- ab_sees
SELECT ab_sees(patch, ab_box(2, -0.1, 1.5, 2.2, 0.1, 1.7)) AS before_the_wall,
       ab_sees(patch, ab_box(-3, -1, 0, -2, 1, 2)) AS behind_the_scanner
FROM   scan;

-- ab_filter
SELECT ab_count(ab_filter(patch, ab_box(4, -2, 0, 6, 2, 1.22))) AS low, ab_count(ab_filter(patch, 5, 5.12)) AS near
FROM   scan;

-- ab_thin
SELECT ab_count(patch) AS beams, ab_count(ab_thin(patch, 0.25)) AS one_every_25_cm FROM scan;

-- ab_transform(ab_scan, ab_pose)
SELECT ab_origin(ab_transform(patch, ab_pose(ARRAY[100, 200, 0], ARRAY[1, 0, 0, 1]))) AS scanner FROM scan;

-- ab_union(ab_scan[]) and ab_union(ab_scan)
-- The lower and the upper half of the patch joined again: from an array, and as an aggregate.
SELECT ab_count(ab_union(array_agg(half))) AS from_an_array, ab_count(ab_union(half)) AS aggregated
FROM   scan, LATERAL (VALUES (ab_filter(patch, ab_box(4, -2, 0, 6, 2, 1.48))),
                             (ab_filter(patch, ab_box(4, -2, 1.48, 6, 2, 4)))) h(half);

-- ab_retile
-- Many small patches, one for every column of the raster, become as few as a table wants.
SELECT (SELECT count(DISTINCT y) FROM reading) AS before, count(*) AS after, sum(ab_count(tile)) AS beams
FROM  (SELECT ab_retile(array_agg(p)) AS tile
       FROM  (SELECT unnest(ab_scan_agg(x, y, z, ARRAY[0, 0, 1.5], 7)) AS p FROM reading GROUP BY y) c) t;
