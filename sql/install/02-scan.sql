-- Scan patches: made, taken apart, filtered, moved, joined; from rows. Accessors read the header alone.

CREATE FUNCTION ab_scan(
    origin float8[], points float8[], step float8 DEFAULT NULL, station bigint DEFAULT 0, quantum float8 DEFAULT 0.0001,
    intensity integer[] DEFAULT NULL, colour integer[] DEFAULT NULL, no_return float8[] DEFAULT NULL) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_make' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_scan(float8[], float8[], float8, bigint, float8, integer[], integer[], float8[]) IS
    'A patch from at most 4096 points (n x 3, world metres) seen from one origin, or each from its own (n x 3: a '
    'moving platform); step is the angle between neighbouring beams in radians (estimated when NULL), intensity 0 to '
    '65535 and colour (n x 3, 0 to 255) are kept beside them; no_return are directions (n x 3) in which nothing '
    'came back';

CREATE FUNCTION ab_cloud(
    points float8[], spacing float8 DEFAULT NULL, station bigint DEFAULT 0, quantum float8 DEFAULT 0.0001,
    intensity integer[] DEFAULT NULL, colour integer[] DEFAULT NULL) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_cloud' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_cloud(float8[], float8, bigint, float8, integer[], integer[]) IS
    'A patch from at most 4096 points (n x 3, world metres) whose origin nobody knows: they say where something is, '
    'never that a place is empty; spacing is the distance between neighbours in metres (estimated when NULL)';

CREATE FUNCTION ab_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_count(ab_scan) IS 'Number of beams, those without return included';

CREATE FUNCTION ab_return_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_returns' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_return_count(ab_scan) IS 'Number of beams with a return';

CREATE FUNCTION ab_origin(patch ab_scan) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_scan_origin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_origin(ab_scan) IS
    'Where the beams start, world metres; NULL where they do not start at one place (ab_beams tells each)';

CREATE FUNCTION ab_station(patch ab_scan) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_scan_station' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_station(ab_scan) IS 'The number of the scanner position';

CREATE FUNCTION ab_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_box(ab_scan) IS 'Hull of the beams, origin included, grown by 0.25 m: the box that && compares';

CREATE FUNCTION ab_point_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_point_box(ab_scan) IS 'Box of the returns alone';

-- Patches taken apart, filtered, thinned, moved, joined.
CREATE TYPE ab_cone_row AS (axis float8[], half_angle float8);
COMMENT ON TYPE ab_cone_row IS 'The cone that holds the beams of a patch';
COMMENT ON COLUMN ab_cone_row.axis IS
    'Its axis from the origin outward: a unit vector along the axes of the world; NULL where the beams do not start '
    'at one place';
COMMENT ON COLUMN ab_cone_row.half_angle IS 'Angle between axis and mantle, radians; NULL where the axis is';

CREATE FUNCTION ab_cone(patch ab_scan) RETURNS ab_cone_row
    AS 'MODULE_PATHNAME', 'ab_scan_cone' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_cone(ab_scan) IS
    'Directions of a patch: the axis of its cone and the half-angle, radians; NULL where the beams do not start at '
    'one place';

CREATE TYPE ab_range_row AS (nearest float8, farthest float8);
COMMENT ON TYPE ab_range_row IS 'How far the returns of a patch are from where their beams start';
COMMENT ON COLUMN ab_range_row.nearest IS 'Least range, metres; NULL where nothing returned or nobody knows the origin';
COMMENT ON COLUMN ab_range_row.farthest IS 'Greatest range, metres; NULL where nearest is';

CREATE FUNCTION ab_range(patch ab_scan) RETURNS ab_range_row
    AS 'MODULE_PATHNAME', 'ab_scan_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_range(ab_scan) IS
    'Least and greatest range of its returns, metres; NULL where nothing returned or nobody knows the origin';

CREATE TYPE ab_beam_row AS (
    origin float8[], point float8[], direction float8[], range float8, intensity integer, colour integer[]);
COMMENT ON TYPE ab_beam_row IS 'A beam of a patch';
COMMENT ON COLUMN ab_beam_row.origin IS 'Where it starts: x, y, z, world metres; NULL where nobody knows';
COMMENT ON COLUMN ab_beam_row.point IS 'Its return: x, y, z, world metres; NULL where nothing came back';
COMMENT ON COLUMN ab_beam_row.direction IS
    'Unit vector from the origin outward along the axes of the world; NULL where nobody knows the origin';
COMMENT ON COLUMN ab_beam_row.range IS 'From origin to return, metres; NULL where one of them is';
COMMENT ON COLUMN ab_beam_row.intensity IS
    'Intensity of the return in the sensor''s own unit, 0 to 65535; NULL where the patch has none';
COMMENT ON COLUMN ab_beam_row.colour IS 'Red, green, blue of the return, 0 to 255; NULL where the patch has none';

CREATE FUNCTION ab_beams(patch ab_scan) RETURNS SETOF ab_beam_row
    AS 'MODULE_PATHNAME', 'ab_patch_beams' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50000 ROWS 4000;
COMMENT ON FUNCTION ab_beams(ab_scan) IS
    'Every beam: where it starts, its return (NULL where nothing came back), its unit direction and range, metres; '
    'intensity and colour (red, green, blue) where the patch has them';

CREATE FUNCTION ab_sees(patch ab_scan, box ab_box, margin float8 DEFAULT 0) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_sees' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_sees(ab_scan, ab_box, float8) IS
    'May a beam of the patch come within the margin (metres) of a box? By cone and range, from the header alone; '
    'never false where one does. A sharper second look after &&';

CREATE FUNCTION ab_filter(patch ab_scan, box ab_box) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_filter(ab_scan, ab_box) IS 'The returns inside a box; NULL where there is none';

CREATE FUNCTION ab_filter(patch ab_scan, min_range float8, max_range float8 DEFAULT 'infinity') RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_filter(ab_scan, float8, float8) IS
    'The returns from min_range to max_range metres away; NULL where there is none; an error for points without '
    'origin';

CREATE FUNCTION ab_thin(patch ab_scan, spacing float8) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_thin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_thin(ab_scan, float8) IS
    'One return for every cube of this side, metres; beams without return are kept. Its step is that of what is left: '
    'the square root of the solid angle that a beam has, over the patch';

CREATE FUNCTION ab_transform(patch ab_scan, pose ab_pose) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_transform_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_transform(ab_scan, ab_pose) IS 'The patch through a pose; a patch carries no covariance';

CREATE FUNCTION ab_union(patches ab_scan[]) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_union' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_union(ab_scan[]) IS
    'Patches of one station and origin as one patch of at most 4096 beams, at the finest quantum of all; a plane '
    'that one of them lacks is dropped; NULL for none';

CREATE AGGREGATE ab_union(patch ab_scan) (
    SFUNC = array_append, STYPE = ab_scan[], FINALFUNC = ab_union, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_union(ab_scan) IS 'Patches of one station and origin as one patch of at most 4096 beams';

CREATE FUNCTION ab_retile(patches ab_scan[]) RETURNS SETOF ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_retile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000 ROWS 10;
COMMENT ON FUNCTION ab_retile(ab_scan[]) IS
    'The beams of patches of one station cut anew into tiles of at most 4096 neighbours: by direction where they '
    'have one origin (a beam of length zero has none, and is dropped), else by place';

-- Patches from rows.
CREATE FUNCTION _ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[]) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_scan_accum(internal, float8, float8, float8, float8[]) IS 'Transition of ab_scan_agg';

CREATE FUNCTION _ab_scan_accum(
    state internal, x float8, y float8, z float8, origin float8[], station bigint) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_scan_accum(internal, float8, float8, float8, float8[], bigint) IS 'Transition of ab_scan_agg';

CREATE FUNCTION _ab_scan_accum(
    state internal, x float8, y float8, z float8, origin float8[], station bigint, intensity integer) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_scan_accum(internal, float8, float8, float8, float8[], bigint, integer) IS
    'Transition of ab_scan_agg';

CREATE FUNCTION _ab_scan_accum(
    state internal, x float8, y float8, z float8, origin float8[], station bigint, intensity integer,
    colour integer[]) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_scan_accum(internal, float8, float8, float8, float8[], bigint, integer, integer[]) IS
    'Transition of ab_scan_agg';

CREATE FUNCTION _ab_scan_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_scan_combine(internal, internal) IS 'Combine of ab_scan_agg';

CREATE FUNCTION _ab_scan_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_scan_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_scan_serial(internal) IS 'Serialisation of ab_scan_agg';

CREATE FUNCTION _ab_scan_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_scan_deserial(bytea, internal) IS 'Deserialisation of ab_scan_agg';

CREATE FUNCTION _ab_scan_final(state internal) RETURNS ab_scan[]
    AS 'MODULE_PATHNAME', 'ab_scan_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_scan_final(internal) IS 'Final of ab_scan_agg';

CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[]) (
    SFUNC = _ab_scan_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_scan_combine,
    SERIALFUNC = _ab_scan_serial, DESERIALFUNC = _ab_scan_deserial, FINALFUNC = _ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[]) IS
    'Patches from rows of returns (world metres), of station 0: one origin makes angular tiles, an origin a row a '
    'moving platform. Rows that come ordered pack best; unnest() makes rows of the array. A row with a NULL adds '
    'nothing, nor does a return at its own origin';

CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[], station bigint) (
    SFUNC = _ab_scan_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_scan_combine,
    SERIALFUNC = _ab_scan_serial, DESERIALFUNC = _ab_scan_deserial, FINALFUNC = _ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[], bigint) IS
    'Patches from rows of returns (world metres), of one station, so GROUP BY it: one origin makes angular tiles, an '
    'origin a row a moving platform. Rows that come ordered pack best; unnest() makes rows of the array. A row with '
    'a NULL adds nothing, nor does a return at its own origin';

CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[], station bigint, intensity integer) (
    SFUNC = _ab_scan_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_scan_combine,
    SERIALFUNC = _ab_scan_serial, DESERIALFUNC = _ab_scan_deserial, FINALFUNC = _ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[], bigint, integer) IS
    'Patches from rows of returns (world metres), with intensity, 0 to 65535. Rows that come ordered pack best; '
    'unnest() makes rows of the array. A row with a NULL adds nothing, nor does a return at its own origin';

CREATE AGGREGATE ab_scan_agg(
    x float8, y float8, z float8, origin float8[], station bigint, intensity integer, colour integer[]) (
    SFUNC = _ab_scan_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_scan_combine,
    SERIALFUNC = _ab_scan_serial, DESERIALFUNC = _ab_scan_deserial, FINALFUNC = _ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[], bigint, integer, integer[]) IS
    'Patches from rows of returns (world metres), with intensity and colour (red, green, blue; 0 to 255). Rows that '
    'come ordered pack best; unnest() makes rows of the array. A row with a NULL adds nothing, nor does a return at '
    'its own origin';

-- The same where nobody knows the origins.
CREATE FUNCTION _ab_cloud_accum(state internal, x float8, y float8, z float8) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_cloud_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_cloud_accum(internal, float8, float8, float8) IS 'Transition of ab_cloud_agg';

CREATE AGGREGATE ab_cloud_agg(x float8, y float8, z float8) (
    SFUNC = _ab_cloud_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_scan_combine,
    SERIALFUNC = _ab_scan_serial, DESERIALFUNC = _ab_scan_deserial, FINALFUNC = _ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_cloud_agg(float8, float8, float8) IS
    'Patches from rows of points (world metres) whose origin nobody knows, of station 0: they say where something '
    'is, never that a place is empty. A row with a NULL adds nothing';

CREATE FUNCTION _ab_cloud_accum(state internal, x float8, y float8, z float8, station bigint) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_cloud_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_cloud_accum(internal, float8, float8, float8, bigint) IS 'Transition of ab_cloud_agg';

CREATE AGGREGATE ab_cloud_agg(x float8, y float8, z float8, station bigint) (
    SFUNC = _ab_cloud_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_scan_combine,
    SERIALFUNC = _ab_scan_serial, DESERIALFUNC = _ab_scan_deserial, FINALFUNC = _ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_cloud_agg(float8, float8, float8, bigint) IS
    'Patches from rows of points (world metres) whose origin nobody knows, of one station: they say where something '
    'is, never that a place is empty. A row with a NULL adds nothing';

CREATE FUNCTION _ab_cloud_accum(
    state internal, x float8, y float8, z float8, station bigint, intensity integer) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_cloud_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_cloud_accum(internal, float8, float8, float8, bigint, integer) IS 'Transition of ab_cloud_agg';

CREATE AGGREGATE ab_cloud_agg(x float8, y float8, z float8, station bigint, intensity integer) (
    SFUNC = _ab_cloud_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_scan_combine,
    SERIALFUNC = _ab_scan_serial, DESERIALFUNC = _ab_scan_deserial, FINALFUNC = _ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_cloud_agg(float8, float8, float8, bigint, integer) IS
    'Patches from rows of points (world metres) whose origin nobody knows, with intensity, 0 to 65535: they say '
    'where something is, never that a place is empty. A row with a NULL adds nothing';

CREATE FUNCTION _ab_cloud_accum(
    state internal, x float8, y float8, z float8, station bigint, intensity integer, colour integer[]) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_cloud_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_cloud_accum(internal, float8, float8, float8, bigint, integer, integer[]) IS
    'Transition of ab_cloud_agg';

CREATE AGGREGATE ab_cloud_agg(x float8, y float8, z float8, station bigint, intensity integer, colour integer[]) (
    SFUNC = _ab_cloud_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_scan_combine,
    SERIALFUNC = _ab_scan_serial, DESERIALFUNC = _ab_scan_deserial, FINALFUNC = _ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_cloud_agg(float8, float8, float8, bigint, integer, integer[]) IS
    'Patches from rows of points (world metres) whose origin nobody knows, with intensity and colour (red, green, '
    'blue; 0 to 255): they say where something is, never that a place is empty. A row with a NULL adds nothing';
