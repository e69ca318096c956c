-- Parts of solids: malformed first.
CREATE TABLE plate AS SELECT ARRAY[[0,0,0],[2,0,0],[2,0,1],[0,0,1]]::float8[] AS v, ARRAY[[0,1,2],[0,2,3]] AS t;
SELECT ab_solid(v, t, ARRAY[0]) FROM plate;
SELECT ab_solid(v, t, ARRAY[0,1,1]) FROM plate;
SELECT ab_solid(v, t, ARRAY[0,-1]) FROM plate;
SELECT ab_solid(v, t, ARRAY[0,65536]) FROM plate;
SELECT ab_solid(v, t, ARRAY[0,NULL]) FROM plate;
SELECT ab_solid(v, t, ARRAY[[0,1],[1,0]]) FROM plate;
SELECT ab_solid(v, t, ARRAY[0,2], transparent => ARRAY[false,true]) FROM plate;
SELECT ab_solid(v, t, ARRAY[0,1], transparent => '{}') FROM plate;
SELECT ab_solid(v, t, ARRAY[0,1], transparent => ARRAY[false,NULL]) FROM plate;
SELECT ab_solid(v, t, ARRAY[0,1], transparent => ARRAY[false,true], movable => ARRAY[true]) FROM plate;
SELECT ab_solid(v, t, ARRAY[0,1], name => ARRAY['a','b','c'], movable => ARRAY[true, false]) FROM plate;
SELECT ab_solid(v, t, ARRAY[0,1], name => ARRAY[repeat('x', 201), 'b']) FROM plate;
SELECT ab_solid(v, t, NULL) IS NULL AS nothing, ab_solid(NULL, t, ARRAY[0,1]) IS NULL AS nothing_either FROM plate;

-- What was given comes back; a part may be without triangles, an empty name is none.
CREATE TABLE window_of AS SELECT ab_solid(v, t, part => ARRAY[0,2], transparent => ARRAY[false,false,true],
    movable => ARRAY[false,true,true], name => ARRAY[NULL,'','pane']) AS solid FROM plate;
SELECT p.* FROM window_of, ab_parts(solid) p;
SELECT ab_triangle_parts(solid), ab_area(solid) FROM window_of;
SELECT p.* FROM plate, ab_parts(ab_solid(v, t)) p;
SELECT ab_triangle_parts(ab_solid(v, t)) FROM plate;
SELECT p.part, p.transparent, p.movable FROM plate, ab_parts(ab_solid(v, t, ARRAY[1,0])) p;

-- Parts of which nothing is told are none: the same bytes as without.
SELECT _ab_solid_send(ab_solid(v, t, ARRAY[0,0], transparent => ARRAY[false])) = _ab_solid_send(ab_solid(v, t)) AS plain FROM plate;

-- Text, binary and comparison.
SELECT solid::text::ab_solid::text = solid::text AS text, solid::text::ab_solid = solid AS equal, solid <> ab_solid(v, t) AS differs
FROM window_of, plate;
\copy window_of TO '/tmp/asbuilt_regress_parts.bin' (FORMAT binary)
CREATE TABLE back (LIKE window_of);
\copy back FROM '/tmp/asbuilt_regress_parts.bin' (FORMAT binary)
\! rm -f /tmp/asbuilt_regress_parts.bin
SELECT p.* FROM window_of JOIN back USING (solid), ab_parts(solid) p;
SELECT count(*) AS kinds FROM (SELECT solid FROM window_of UNION SELECT ab_solid(v, t) FROM plate UNION TABLE back) s;

-- Whatever moves a solid keeps its parts.
SELECT p.part, p.name, p.transparent, p.movable, round(p.area::numeric, 9) AS area
FROM window_of, ab_parts(ab_transform(solid, ab_pose(ARRAY[10, 0, 0], ARRAY[0, 0, 0, 1]))) p;

-- Damage to the parts is told; so is a value that ends before them.
SET client_min_messages = warning;
DROP CAST IF EXISTS (bytea AS ab_solid);
RESET client_min_messages;
CREATE CAST (bytea AS ab_solid) WITHOUT FUNCTION;
\set VERBOSITY sqlstate
SELECT ab_parts(set_byte(b, length(b) - 1, get_byte(b, length(b) - 1) # 1)::ab_solid) FROM (SELECT _ab_solid_send(solid) b FROM window_of) x;
SELECT ab_parts(substr(b, 1, length(_ab_solid_send(ab_solid(v, t))))::ab_solid) FROM (SELECT _ab_solid_send(solid) b, v, t FROM window_of, plate) x;
\set VERBOSITY default
DROP CAST (bytea AS ab_solid);
DROP TABLE plate, window_of, back;
