-- Uncertain geometry
-- Points, lines, planes and poses with their covariance; constructions, best fits and tests with them.
CREATE TEMP TABLE corner AS       -- corners of a floor, measured to 2 mm
SELECT * FROM (VALUES ('a', ab_point(0, 0, 0, sd => 0.002)), ('b', ab_point(4, 0, 0.001, sd => 0.002)),
                      ('c', ab_point(0, 3, 0.002, sd => 0.002)), ('d', ab_point(4, 3, 0.004, sd => 0.002))) v(name, p);
CREATE TEMP TABLE part AS         -- a floor, a wall on it, the axis of a column, an edge of the floor
SELECT ab_plane(ARRAY[2, 1.5, 0], ARRAY[0, 0, 1], sd_offset => 0.001, sd_tilt => 0.0005) AS floor,
       ab_plane(ARRAY[2, 0, 1.5], ARRAY[0, 1, 0], sd_offset => 0.002, sd_tilt => 0.001) AS wall,
       ab_line(ab_point(1, 1, 0.5, 0.002), ab_point(1.003, 1, 2.5, 0.002)) AS axis,
       ab_line(ab_point(0, 0, 0, 0.002), ab_point(4, 0, 0.001, 0.002)) AS edge;

-- ab_point
SELECT ab_point(1, 2, 0.5) AS exact, ab_point(1, 2, 0.5, sd => 0.5) AS uncertain;

-- ab_line
-- Through two points, between exact places, and as the best fit.
SELECT ab_direction(ab_line(ab_point(0, 0, 0, 0.002), ab_point(4, 0, 0, 0.002))) AS through_two,
       ab_line(ARRAY[0, 0, 0], ARRAY[4, 0, 0]) AS exact,
       ab_direction(ab_line(ARRAY[ab_point(0, 0, 0), ab_point(2, 0, 0), ab_point(4, 0, 0)])) AS best_fit;

-- ab_plane
-- Level with a tilt of 0.5 mrad; through three corners; through an edge and a corner; the best fit to all four.
SELECT ab_normal(ab_plane(ARRAY[2, 1.5, 0], ARRAY[0, 0, 1], sd_offset => 0.001, sd_tilt => 0.0005)) AS stated,
       ab_normal(ab_plane(ab_point(0, 0, 0), ab_point(4, 0, 0), ab_point(0, 3, 0))) AS through_three,
       ab_normal(ab_plane((SELECT edge FROM part), ab_point(0, 3, 0))) AS edge_and_corner,
       ab_normal(ab_plane((SELECT array_agg(p ORDER BY name) FROM corner))) AS best_fit;

-- ab_pose
-- A scanner at (10, 20, 1.6), turned by half a turn about the vertical axis.
SELECT ab_translation(pose) AS translation, ab_rotation(pose) AS rotation
FROM   ab_pose(ARRAY[10, 20, 1.6], ARRAY[0, 0, 0, 1], sd_rotation => 1e-4, sd_translation => 0.002) pose;

-- ab_numbers
SELECT ab_numbers(ab_point(1, 2, 0.5, sd => 0.5)) AS point, array_length(ab_numbers(edge), 1) AS line,
       array_length(ab_numbers(floor), 1) AS plane, array_length(ab_numbers(ab_pose(ARRAY[10, 20, 1.6])), 1) AS pose
FROM   part;

-- ab_point_of
SELECT ab_point_of(ARRAY[1, 2, 0.5]) AS exact,
       ab_point_of(ab_numbers(ab_point(1, 2, 0.5, sd => 0.5))) AS from_all_numbers;

-- ab_line_of
SELECT ab_line_of(ARRAY[0, 0, 0, 4, 0, 0]) AS line;

-- ab_plane_of
SELECT ab_plane_of(ARRAY[2, 1.5, 0, 0, 0, 1]) AS plane;

-- ab_pose_of
-- The quaternion comes first, then translation and scale.
SELECT ab_pose_of(ARRAY[1, 0, 0, 0, 10, 20, 1.6, 1]) AS pose;

-- ab_covariance
SELECT ab_covariance(p) AS of_a_point, array_length(ab_covariance(ab_line(p, p2)), 1) AS rows_of_a_line,
       array_length(ab_covariance(floor), 1) AS of_a_plane,
       array_length(ab_covariance(ab_pose(ARRAY[1, 2, 3])), 1) AS of_a_pose
FROM   ab_point(1, 2, 0.5, sd => 0.5) p, ab_point(2, 2, 0.5) p2, part;

-- ab_x
SELECT ab_x(ab_point(1, 2, 0.5)) AS x;

-- ab_y
SELECT ab_y(ab_point(1, 2, 0.5)) AS y;

-- ab_z
SELECT ab_z(ab_point(1, 2, 0.5)) AS z;

-- ab_position
SELECT ab_position(ab_point(1, 2, 0.5, sd => 0.002)) AS of_a_point, ab_position(floor) AS of_a_plane FROM part;

-- ab_sd
SELECT ab_sd(ab_point(1, 2, 0.5, covariance => '{{4e-6,0,0},{0,9e-6,0},{0,0,1e-6}}')) AS along_x_y_z;

-- ab_ellipsoid
SELECT e.* FROM ab_ellipsoid(ab_point(1, 2, 0.5, covariance => '{{4e-6,0,0},{0,9e-6,0},{0,0,1e-6}}'), 0.95) e;

-- ab_box(ab_point, float8) and ab_box(ab_line, float8)
SELECT ab_min(ab_box(ab_point(1, 2, 0.5, sd => 0.002), 0.99)) AS around_a_point, ab_max(ab_box(edge)) AS around_a_line
FROM   part;

-- ab_reach
SELECT ab_reach(ab_point(1, 2, 0.5, sd => 0.25), 3) AS three_sigma, ab_reach(ab_solid(ab_box(0, 0, 0, 4, 0.2, 2.5))) AS what_evidence_looks_at;

-- ab_normal
SELECT ab_normal(floor) AS up FROM part;

-- ab_start
SELECT ab_start(ab_line(ARRAY[0, 0, 0], ARRAY[4, 0, 0])) AS point;

-- ab_end
SELECT ab_end(ab_line(ARRAY[0, 0, 0], ARRAY[4, 0, 0])) AS point;

-- ab_direction
SELECT ab_direction(axis) AS up FROM part;

-- ab_plucker
SELECT p.line, array_length(p.covariance, 1) AS rows_of_covariance
FROM   ab_plucker(ab_line(ARRAY[1, 2, 0], ARRAY[5, 3, 2]), ARRAY[1, 1, 1]) p;

-- ab_translation
SELECT ab_translation(ab_pose(ARRAY[10, 20, 1.6])) AS metres;

-- ab_rotation
SELECT ab_rotation(ab_pose(ARRAY[10, 20, 1.6], ARRAY[2, 0, 0, 2])) AS quaternion;

-- ab_scale
SELECT ab_scale(ab_pose(ARRAY[0, 0, 0], scale => 0.9996)) AS of_a_map_grid;

-- ab_transform
-- What stands at (1, 0, 0) before the scanner, and a pose after a pose.
SELECT ab_position(ab_transform(ab_point(1, 0, 0, 0.002), pose)) AS point,
       ab_direction(ab_transform(axis, pose)) AS axis, ab_normal(ab_transform(wall, pose)) AS wall,
       ab_translation(ab_transform(ab_pose(ARRAY[1, 0, 0]), pose)) AS pose
FROM   part, ab_pose(ARRAY[10, 20, 1.6], ARRAY[0, 0, 0, 1], sd_translation => 0.003) pose;

-- ab_inverse
-- Into the scanner's own frame.
SELECT ab_position(ab_transform(ab_point(13, 21, 2.1), ab_inverse(pose))) AS seen_from_it
FROM   ab_pose(ARRAY[10, 20, 1.5], ARRAY[0, 0, 0, 1]) pose;

-- ab_midpoint
SELECT ab_position(m) AS middle, ab_sd(m) AS sd, ab_position(ab_midpoint(edge)) AS of_the_edge
FROM   part, ab_midpoint(ab_point(0, 0, 0, 0.002), ab_point(4, 0, 0, 0.002)) m;

-- ab_intersection
-- Where the axis meets the floor, the line of floor and wall, and the corner that three planes make.
SELECT ab_position(ab_intersection(axis, floor)) AS foot_of_the_column,
       ab_direction(ab_intersection(floor, wall)) AS skirting,
       ab_position(ab_intersection(floor, wall, ab_plane(ARRAY[4, 0, 0], ARRAY[1, 0, 0]))) AS corner
FROM   part;

-- ab_foot
SELECT ab_position(ab_foot(p, floor)) AS on_the_floor, ab_position(ab_foot(p, edge)) AS on_the_edge
FROM   part, ab_point(1, 1, 2.5) p;

-- ab_distance
SELECT between.distance, between.sd, d.distance AS above_the_floor, d.sd AS its_sd,
       ab_distance(axis, edge) AS of_two_lines
FROM   part, ab_distance(ab_point(0, 0, 0, 0.002), ab_point(3, 4, 0, 0.002)) between,
       ab_distance(ab_point(1, 1, 2.5, 0.002), floor) d;

-- ab_line_agg
SELECT ab_direction(ab_line_agg(ab_point(i, 2, 0.5, 0.002))) AS direction FROM generate_series(0, 10) i;

-- ab_plane_agg
SELECT ab_position(ab_plane_agg(p)) AS centre, ab_normal(ab_plane_agg(p)) AS normal FROM corner;

-- ab_mahalanobis
-- 6 mm apart, each with 2 mm: the difference has 2.83 mm.
SELECT ab_mahalanobis(ab_point(1, 2, 0.5, 0.002), ab_point(1.006, 2, 0.5, 0.002)) AS sigmas;

-- ab_test_same
SELECT t.* FROM ab_test_same(ab_point(1, 2, 0.5, 0.002), ab_point(1.006, 2, 0.5, 0.002)) t;

-- ab_is_same
SELECT ab_is_same(ab_point(1, 2, 0.5, 0.002), ab_point(1.006, 2, 0.5, 0.002)) AS points,
       ab_is_same(floor, ab_plane(ARRAY[2, 1.5, 0.02], ARRAY[0, 0, 1], 0.001, 0.0005)) AS floor_20_mm_higher
FROM   part;

-- ab_test_incident
-- Does the third corner lie on the floor?
SELECT t.* FROM part, ab_test_incident(ab_point(0, 3, 0.004, 0.002), floor) t;

-- ab_is_incident
SELECT ab_is_incident(ab_point(0, 3, 0.004, 0.002), floor) AS point_on_floor,
       ab_is_incident(ab_point(2, 0, 0.02, 0.002), edge) AS point_on_edge,
       ab_is_incident(edge, floor) AS edge_in_floor, ab_is_incident(axis, floor) AS axis_in_floor
FROM   part;

-- ab_test_parallel
SELECT t.* FROM part, ab_test_parallel(edge, floor) t;

-- ab_is_parallel
SELECT ab_is_parallel(axis, edge) AS lines, ab_is_parallel(floor, wall) AS planes,
       ab_is_parallel(edge, floor) AS line_and_plane
FROM   part;

-- ab_test_orthogonal
-- Is the column plumb on the floor?
SELECT t.* FROM part, ab_test_orthogonal(axis, floor) t;

-- ab_is_orthogonal
SELECT ab_is_orthogonal(axis, edge) AS lines, ab_is_orthogonal(floor, wall) AS planes,
       ab_is_orthogonal(axis, floor) AS line_and_plane
FROM   part;

-- ab_test_coplanar
SELECT t.* FROM part, ab_test_coplanar(edge, ab_line(ab_point(0, 3, 0, 0.002), ab_point(4, 3, 0.002, 0.002))) t;

-- ab_is_coplanar
SELECT ab_is_coplanar(axis, edge) AS skew, ab_is_coplanar(edge, opposite) AS two_edges
FROM   part, ab_line(ab_point(0, 3, 0, 0.002), ab_point(4, 3, 0.002, 0.002)) opposite;
