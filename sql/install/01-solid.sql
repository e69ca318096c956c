-- Boxes and solids.

CREATE FUNCTION ab_box(xmin float8, ymin float8, zmin float8, xmax float8, ymax float8, zmax float8) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_box_make' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box(float8, float8, float8, float8, float8, float8) IS
    'A box between two corners, given in any order; metres';

CREATE FUNCTION ab_min(box ab_box) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_box_min' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_min(ab_box) IS 'Lower corner of a box';

CREATE FUNCTION ab_max(box ab_box) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_box_max' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_max(ab_box) IS 'Upper corner of a box';

CREATE FUNCTION ab_expand(box ab_box, margin float8) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_box_expand' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_expand(ab_box, float8) IS 'The box grown by a margin on every side; metres';

CREATE FUNCTION ab_volume(box ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_box_volume' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_volume(ab_box) IS 'Volume of a box, m3';

CREATE FUNCTION ab_solid(vertices float8[], triangles integer[]) RETURNS ab_solid
    AS 'MODULE_PATHNAME', 'ab_solid_make' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_solid(float8[], integer[]) IS
    'A solid from vertices (n x 3, metres) and triangles (n x 3, vertex numbers from 0, counter-clockwise seen from '
    'outside); a closed one that is inside out is turned';

CREATE FUNCTION ab_solid(box ab_box) RETURNS ab_solid
    AS 'MODULE_PATHNAME', 'ab_solid_from_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION ab_solid(ab_box) IS 'A cuboid';

CREATE FUNCTION ab_box(solid ab_solid) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_solid_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box(ab_solid) IS 'Box of a solid';

CREATE FUNCTION ab_area(solid ab_solid) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_solid_area' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_area(ab_solid) IS 'Surface area, m2';

CREATE FUNCTION ab_volume(solid ab_solid) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_solid_volume' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_volume(ab_solid) IS 'Enclosed volume, m3; an error for an open surface';

CREATE FUNCTION ab_closedness(solid ab_solid) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_solid_closedness' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_closedness(ab_solid) IS
    'closed, closed but for T-junctions, or open surface: by the balance of its edges';

CREATE FUNCTION ab_vertices(solid ab_solid) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_solid_vertices' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_vertices(ab_solid) IS 'Vertices of a solid, n x 3, metres';

CREATE FUNCTION ab_triangles(solid ab_solid) RETURNS integer[]
    AS 'MODULE_PATHNAME', 'ab_solid_triangles' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_triangles(ab_solid) IS 'Triangles of a solid, n x 3, vertex numbers from 0';
