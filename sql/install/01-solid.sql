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
COMMENT ON FUNCTION ab_volume(ab_solid) IS 'Enclosed volume, m3; NULL for an open surface, which encloses none: ab_closedness says why';

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

CREATE FUNCTION ab_solid(
    vertices float8[], triangles integer[], part integer[], transparent boolean[] DEFAULT NULL,
    movable boolean[] DEFAULT NULL, name text[] DEFAULT NULL) RETURNS ab_solid
    AS 'MODULE_PATHNAME', 'ab_solid_make_parts' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_solid(float8[], integer[], integer[], boolean[], boolean[], text[]) IS
    'A solid of parts: part has a number from 0 for each triangle; transparent (most beams pass it: glass), movable (it '
    'may stand elsewhere than drawn: a leaf, a sash) and name have an element for each part';

CREATE TYPE ab_part_row AS (
    part integer, name text, area float8, transparent boolean, movable boolean, triangles integer);
COMMENT ON TYPE ab_part_row IS 'A part of a solid';
COMMENT ON COLUMN ab_part_row.part IS 'Its number, from 0';
COMMENT ON COLUMN ab_part_row.name IS
    'What it is called; of a model that was loaded, its shape aspect, style or material; NULL where nobody knows';
COMMENT ON COLUMN ab_part_row.area IS 'Area of its triangles, square metres';
COMMENT ON COLUMN ab_part_row.transparent IS 'Whether most beams pass it and return from behind';
COMMENT ON COLUMN ab_part_row.movable IS 'Whether it may stand elsewhere than drawn without being built wrongly';
COMMENT ON COLUMN ab_part_row.triangles IS 'Number of its triangles, 0 or more';

CREATE FUNCTION ab_parts(solid ab_solid) RETURNS SETOF ab_part_row
    AS 'MODULE_PATHNAME', 'ab_solid_parts' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 4;
COMMENT ON FUNCTION ab_parts(ab_solid) IS
    'The parts of a solid by their numbers; a solid without parts is a single one, neither transparent nor movable';

CREATE FUNCTION ab_triangle_parts(solid ab_solid) RETURNS integer[]
    AS 'MODULE_PATHNAME', 'ab_solid_triangle_parts' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_triangle_parts(ab_solid) IS
    'For each triangle the number of its part, from 0, in the order of ab_triangles';
