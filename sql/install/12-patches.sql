-- Patches taken apart, filtered, thinned, moved, joined.

CREATE FUNCTION ab_cone(patch ab_scan, OUT axis float8[], OUT half_angle float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_cone' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_cone(ab_scan) IS 'Directions of a patch: the axis of its cone and the half-angle, radians; NULL where the beams do not start at one place';

CREATE FUNCTION ab_range(patch ab_scan, OUT nearest float8, OUT farthest float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_range(ab_scan) IS 'Least and greatest range of its returns, metres; NULL where nothing returned or nobody knows the origin';

CREATE FUNCTION ab_beams(patch ab_scan, OUT origin float8[], OUT point float8[], OUT direction float8[], OUT range float8, OUT intensity integer, OUT colour integer[]) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_scan_beams' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50000 ROWS 4000;
COMMENT ON FUNCTION ab_beams(ab_scan) IS 'Every beam: where it starts, its return (NULL where nothing came back), its unit direction and range, metres; intensity and colour (red, green, blue) where the patch has them';

CREATE FUNCTION ab_sees(patch ab_scan, box ab_box, margin float8 DEFAULT 0) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_sees' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_sees(ab_scan, ab_box, float8) IS 'May a beam of the patch come within the margin (metres) of a box? By cone and range, from the header alone; never false where one does. A sharper second look after &&';

CREATE FUNCTION ab_filter(patch ab_scan, box ab_box) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_filter(ab_scan, ab_box) IS 'The returns inside a box; NULL where there is none';

CREATE FUNCTION ab_filter(patch ab_scan, min_range float8, max_range float8 DEFAULT 'infinity') RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_filter(ab_scan, float8, float8) IS 'The returns from min_range to max_range metres away; NULL where there is none; an error for points without origin';

CREATE FUNCTION ab_thin(patch ab_scan, spacing float8) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_thin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_thin(ab_scan, float8) IS 'One return for every cube of this side, metres; beams without return are kept';

CREATE FUNCTION ab_transform(patch ab_scan, pose ab_pose) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_transform_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_transform(ab_scan, ab_pose) IS 'The patch through a pose; a patch carries no covariance';

CREATE FUNCTION ab_union(patches ab_scan[]) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_union' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_union(ab_scan[]) IS 'Patches of one station and origin as one patch of at most 4096 beams, at the finest quantum of all; a plane that one of them lacks is dropped; NULL for none';

CREATE AGGREGATE ab_union(patch ab_scan) (SFUNC = array_append, STYPE = ab_scan[], FINALFUNC = ab_union, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_union(ab_scan) IS 'Patches of one station and origin as one patch of at most 4096 beams';

CREATE FUNCTION ab_retile(patches ab_scan[]) RETURNS SETOF ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_retile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000 ROWS 10;
COMMENT ON FUNCTION ab_retile(ab_scan[]) IS 'The beams of patches of one station cut anew into tiles of at most 4096 neighbours: by direction where they have one origin (a beam of length zero has none, and is dropped), else by place';

-- Patches from rows.

CREATE FUNCTION ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[]) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_accum(internal, float8, float8, float8, float8[]) IS 'Transition of ab_scan_agg';

CREATE FUNCTION ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[], station bigint) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_accum(internal, float8, float8, float8, float8[], bigint) IS 'Transition of ab_scan_agg';

CREATE FUNCTION ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[], station bigint, intensity integer) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_accum(internal, float8, float8, float8, float8[], bigint, integer) IS 'Transition of ab_scan_agg';

CREATE FUNCTION ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[], station bigint, intensity integer, colour integer[]) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_accum(internal, float8, float8, float8, float8[], bigint, integer, integer[]) IS 'Transition of ab_scan_agg';

CREATE FUNCTION ab_scan_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_combine(internal, internal) IS 'Combine of ab_scan_agg';

CREATE FUNCTION ab_scan_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_scan_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_serial(internal) IS 'Serialisation of ab_scan_agg';

CREATE FUNCTION ab_scan_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_deserial(bytea, internal) IS 'Deserialisation of ab_scan_agg';

CREATE FUNCTION ab_scan_final(state internal) RETURNS ab_scan[]
    AS 'MODULE_PATHNAME', 'ab_scan_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_scan_final(internal) IS 'Final of ab_scan_agg';

CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[]) (
    SFUNC = ab_scan_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[]) IS
    'Patches from rows of returns (world metres), of station 0: one origin makes angular tiles, an origin a row a moving platform. Rows that come ordered pack best; unnest() makes rows of the array. A row with a NULL adds nothing, nor does a return at its own origin';

CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[], station bigint) (
    SFUNC = ab_scan_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[], bigint) IS
    'Patches from rows of returns (world metres), of one station, so GROUP BY it: one origin makes angular tiles, an origin a row a moving platform. Rows that come ordered pack best; unnest() makes rows of the array. A row with a NULL adds nothing, nor does a return at its own origin';

CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[], station bigint, intensity integer) (
    SFUNC = ab_scan_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[], bigint, integer) IS
    'Patches from rows of returns (world metres), with intensity, 0 to 65535. Rows that come ordered pack best; unnest() makes rows of the array. A row with a NULL adds nothing, nor does a return at its own origin';

CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[], station bigint, intensity integer, colour integer[]) (
    SFUNC = ab_scan_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[], bigint, integer, integer[]) IS
    'Patches from rows of returns (world metres), with intensity and colour (red, green, blue; 0 to 255). Rows that come ordered pack best; unnest() makes rows of the array. A row with a NULL adds nothing, nor does a return at its own origin';

-- The same where nobody knows the origins.

CREATE FUNCTION ab_cloud_accum(state internal, x float8, y float8, z float8) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_cloud_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_cloud_accum(internal, float8, float8, float8) IS 'Transition of ab_cloud_agg';

CREATE AGGREGATE ab_cloud_agg(x float8, y float8, z float8) (
    SFUNC = ab_cloud_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_cloud_agg(float8, float8, float8) IS 'Patches from rows of points (world metres) whose origin nobody knows, of station 0: they say where something is, never that a place is empty. A row with a NULL adds nothing';

CREATE FUNCTION ab_cloud_accum(state internal, x float8, y float8, z float8, station bigint) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_cloud_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_cloud_accum(internal, float8, float8, float8, bigint) IS 'Transition of ab_cloud_agg';

CREATE AGGREGATE ab_cloud_agg(x float8, y float8, z float8, station bigint) (
    SFUNC = ab_cloud_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_cloud_agg(float8, float8, float8, bigint) IS 'Patches from rows of points (world metres) whose origin nobody knows, of one station: they say where something is, never that a place is empty. A row with a NULL adds nothing';

CREATE FUNCTION ab_cloud_accum(state internal, x float8, y float8, z float8, station bigint, intensity integer) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_cloud_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_cloud_accum(internal, float8, float8, float8, bigint, integer) IS 'Transition of ab_cloud_agg';

CREATE AGGREGATE ab_cloud_agg(x float8, y float8, z float8, station bigint, intensity integer) (
    SFUNC = ab_cloud_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_cloud_agg(float8, float8, float8, bigint, integer) IS 'Patches from rows of points (world metres) whose origin nobody knows, with intensity, 0 to 65535: they say where something is, never that a place is empty. A row with a NULL adds nothing';

CREATE FUNCTION ab_cloud_accum(state internal, x float8, y float8, z float8, station bigint, intensity integer, colour integer[]) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_cloud_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_cloud_accum(internal, float8, float8, float8, bigint, integer, integer[]) IS 'Transition of ab_cloud_agg';

CREATE AGGREGATE ab_cloud_agg(x float8, y float8, z float8, station bigint, intensity integer, colour integer[]) (
    SFUNC = ab_cloud_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_cloud_agg(float8, float8, float8, bigint, integer, integer[]) IS 'Patches from rows of points (world metres) whose origin nobody knows, with intensity and colour (red, green, blue; 0 to 255): they say where something is, never that a place is empty. A row with a NULL adds nothing';
