-- Scan patches. All but the constructors read the header alone.

CREATE FUNCTION ab_scan(origin float8[], points float8[], step float8 DEFAULT NULL, station bigint DEFAULT 0, quantum float8 DEFAULT 0.0001, intensity integer[] DEFAULT NULL, colour integer[] DEFAULT NULL, no_return float8[] DEFAULT NULL) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_make' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_scan(float8[], float8[], float8, bigint, float8, integer[], integer[], float8[]) IS 'A patch from at most 4096 points (n x 3, world metres) seen from one origin, or each from its own (n x 3: a moving platform); step is the angle between neighbouring beams in radians (estimated when NULL), intensity 0 to 65535 and colour (n x 3, 0 to 255) are kept beside them; no_return are directions (n x 3) in which nothing came back';

CREATE FUNCTION ab_cloud(points float8[], spacing float8 DEFAULT NULL, station bigint DEFAULT 0, quantum float8 DEFAULT 0.0001, intensity integer[] DEFAULT NULL, colour integer[] DEFAULT NULL) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_cloud' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_cloud(float8[], float8, bigint, float8, integer[], integer[]) IS 'A patch from at most 4096 points (n x 3, world metres) whose origin nobody knows: they say where something is, never that a place is empty; spacing is the distance between neighbours in metres (estimated when NULL)';

CREATE FUNCTION ab_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_count(ab_scan) IS 'Number of beams, those without return included';

CREATE FUNCTION ab_return_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_returns' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_return_count(ab_scan) IS 'Number of beams with a return';

CREATE FUNCTION ab_origin(patch ab_scan) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_scan_origin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_origin(ab_scan) IS 'Where the beams start, world metres; NULL where they do not start at one place (ab_beams tells each)';

CREATE FUNCTION ab_station(patch ab_scan) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_scan_station' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_station(ab_scan) IS 'The number of the scanner position';

CREATE FUNCTION ab_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_box(ab_scan) IS 'Hull of the beams, origin included, grown by 0.25 m: the box that && compares';

CREATE FUNCTION ab_point_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_point_box(ab_scan) IS 'Box of the returns alone';
