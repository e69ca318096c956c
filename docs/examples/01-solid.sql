-- Boxes and solids
-- Building objects as closed meshes, and the boxes around them.

-- ab_box
SELECT ab_box(0, 0, 0, 4, 0.2, 2.5) AS wall, ab_box(ab_solid(ab_box(0, 0, 0, 4, 0.2, 2.5))) AS of_a_solid;

-- ab_min
SELECT ab_min(ab_box(0, 0, 0, 4, 0.2, 2.5)) AS corner;

-- ab_max
SELECT ab_max(ab_box(0, 0, 0, 4, 0.2, 2.5)) AS corner;

-- ab_expand
SELECT ab_expand(ab_box(0, 0, 0, 4, 0.2, 2.5), 0.05) AS with_a_margin;

-- ab_volume
SELECT ab_volume(b) AS of_the_box, ab_volume(ab_solid(b)) AS of_the_solid FROM ab_box(0, 0, 0, 4, 0.2, 2.5) b;

-- ab_solid
-- A roof of four faces, and a wall from its box.
SELECT ab_volume(ab_solid(ARRAY[[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 2]],
                          ARRAY[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])) AS roof,
       ab_volume(ab_solid(ab_box(0, 0, 0, 4, 0.2, 2.5))) AS wall;

-- ab_area
SELECT ab_area(ab_solid(ab_box(0, 0, 0, 4, 0.2, 2.5))) AS m2;

-- ab_closedness
SELECT ab_closedness(ab_solid(ab_box(0, 0, 0, 4, 0.2, 2.5))) AS wall,
       ab_closedness(ab_solid(ARRAY[[0, 0, 0], [4, 0, 0], [0, 0, 2.5]], ARRAY[[0, 1, 2]])) AS sheet;

-- ab_vertices
SELECT v AS corners, array_length(v, 1) AS how_many
FROM   ab_vertices(ab_solid(ARRAY[[0, 0, 0], [4, 0, 0], [0, 0, 2.5]], ARRAY[[0, 1, 2]])) v;

-- ab_triangles
SELECT t AS triangles, array_length(ab_triangles(ab_solid(ab_box(0, 0, 0, 4, 0.2, 2.5))), 1) AS of_a_cuboid
FROM   ab_triangles(ab_solid(ARRAY[[0, 0, 0], [4, 0, 0], [0, 0, 2.5]], ARRAY[[0, 1, 2]])) t;

-- ab_parts
-- A pane in a frame of which only the front is drawn.
SELECT part, name, area, transparent, triangles
FROM   ab_parts(ab_solid(ARRAY[[0, 0, 0], [1, 0, 0], [1, 0, 2], [0, 0, 2], [0.1, 0, 0.1], [0.9, 0, 0.1], [0.9, 0, 1.9],
                               [0.1, 0, 1.9]],
                         ARRAY[[0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7],
                               [4, 5, 6], [4, 6, 7]],
                         part => ARRAY[0, 0, 0, 0, 0, 0, 0, 0, 1, 1], transparent => ARRAY[false, true],
                         name => ARRAY['frame', 'pane']));

-- ab_triangle_parts
SELECT ab_triangle_parts(ab_solid(ARRAY[[0, 0, 0], [4, 0, 0], [4, 0, 2], [0, 0, 2]], ARRAY[[0, 1, 2], [0, 2, 3]],
                                  part => ARRAY[0, 1], movable => ARRAY[false, true])) AS numbers;

-- ab_transform(ab_solid, ab_pose)
-- Half a turn about the vertical axis, then 10 m along x.
SELECT ab_box(ab_transform(ab_solid(ab_box(1, 0, 0, 5, 2, 2.5)), pose)) AS turned
FROM   ab_pose(ARRAY[10, 0, 0], ARRAY[0, 0, 0, 1]) pose;
