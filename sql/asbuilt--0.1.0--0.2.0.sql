-- asbuilt 0.1.0 to 0.2.0.

\echo Use "ALTER EXTENSION asbuilt UPDATE" to load this file. \quit

DROP FUNCTION ab_scan(float8[], float8[], float8, bigint, float8);
DROP FUNCTION ab_beams(ab_scan);
CREATE FUNCTION ab_typanalyze(internal) RETURNS boolean AS 'MODULE_PATHNAME', 'ab_typanalyze' LANGUAGE c STRICT PARALLEL SAFE STABLE;
COMMENT ON FUNCTION ab_typanalyze(internal) IS 'ANALYZE of a column of boxes, solids, patches, points or lines: where they lie and how large they are';
CREATE FUNCTION ab_overlap_sel(internal, oid, internal, integer) RETURNS float8 AS 'MODULE_PATHNAME', 'ab_overlap_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_overlap_sel(internal, oid, internal, integer) IS 'Planner: share of rows that && finds';
CREATE FUNCTION ab_overlap_join_sel(internal, oid, internal, smallint, internal) RETURNS float8 AS 'MODULE_PATHNAME', 'ab_overlap_join_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_overlap_join_sel(internal, oid, internal, smallint, internal) IS 'Planner: share of pairs that && finds';
CREATE FUNCTION ab_contains_sel(internal, oid, internal, integer) RETURNS float8 AS 'MODULE_PATHNAME', 'ab_contains_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_contains_sel(internal, oid, internal, integer) IS 'Planner: share of rows that @> finds';
CREATE FUNCTION ab_contains_join_sel(internal, oid, internal, smallint, internal) RETURNS float8 AS 'MODULE_PATHNAME', 'ab_contains_join_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_contains_join_sel(internal, oid, internal, smallint, internal) IS 'Planner: share of pairs that @> finds';
CREATE FUNCTION ab_contained_sel(internal, oid, internal, integer) RETURNS float8 AS 'MODULE_PATHNAME', 'ab_contained_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_contained_sel(internal, oid, internal, integer) IS 'Planner: share of rows that <@ finds';
CREATE FUNCTION ab_contained_join_sel(internal, oid, internal, smallint, internal) RETURNS float8 AS 'MODULE_PATHNAME', 'ab_contained_join_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_contained_join_sel(internal, oid, internal, smallint, internal) IS 'Planner: share of pairs that <@ finds';
ALTER TYPE ab_box SET (ANALYZE = ab_typanalyze);
ALTER TYPE ab_solid SET (ANALYZE = ab_typanalyze);
ALTER TYPE ab_scan SET (ANALYZE = ab_typanalyze);
ALTER TYPE ab_point SET (ANALYZE = ab_typanalyze);
ALTER TYPE ab_line SET (ANALYZE = ab_typanalyze);
CREATE FUNCTION ab_scan(origin float8[], points float8[], step float8 DEFAULT NULL, station bigint DEFAULT 0, quantum float8 DEFAULT 0.0001, intensity integer[] DEFAULT NULL, colour integer[] DEFAULT NULL, no_return float8[] DEFAULT NULL) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_make' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_scan(float8[], float8[], float8, bigint, float8, integer[], integer[], float8[]) IS 'A patch from at most 4096 points (n x 3, world metres) seen from one origin, or each from its own (n x 3: a moving platform); step is the angle between neighbouring beams in radians (estimated when NULL), intensity 0 to 65535 and colour (n x 3, 0 to 255) are kept beside them; no_return are directions (n x 3) in which nothing came back';
CREATE FUNCTION ab_cloud(points float8[], spacing float8 DEFAULT NULL, station bigint DEFAULT 0, quantum float8 DEFAULT 0.0001, intensity integer[] DEFAULT NULL, colour integer[] DEFAULT NULL) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_cloud' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_cloud(float8[], float8, bigint, float8, integer[], integer[]) IS 'A patch from at most 4096 points (n x 3, world metres) whose origin nobody knows: they say where something is, never that a place is empty; spacing is the distance between neighbours in metres (estimated when NULL)';
CREATE OR REPLACE FUNCTION ab_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_return_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_returns' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_origin(patch ab_scan) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_scan_origin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_origin(ab_scan) IS 'Where the beams start, world metres; NULL where they do not start at one place (ab_beams tells each)';
CREATE OR REPLACE FUNCTION ab_station(patch ab_scan) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_scan_station' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_box(ab_scan) IS 'Hull of the beams, origin included, grown by 0.25 m: the box that && compares';
CREATE OR REPLACE FUNCTION ab_point_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_rollup(e1 ab_evidence, e2 ab_evidence) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
CREATE OR REPLACE FUNCTION ab_summary(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL,
    OUT verdict text, OUT best_loa ab_loa, OUT samples bigint, OUT coverage float8,
    OUT confirmed float8, OUT refuted float8, OUT open float8, OUT conflict float8,
    OUT deviation float8, OUT deviation_sd float8, OUT shift text) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_summary' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
CREATE OR REPLACE FUNCTION ab_verdict(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_verdict' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
CREATE OR REPLACE FUNCTION ab_samples(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    OUT "position" float8[], OUT normal float8[], OUT mass ab_mass,
    OUT deviation float8, OUT deviation_sd float8, OUT beams integer) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_samples' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 10000;
CREATE OR REPLACE FUNCTION ab_faces(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    OUT normal float8[], OUT samples bigint, OUT seen bigint, OUT confirmed bigint, OUT refuted bigint,
    OUT open bigint, OUT pierced bigint, OUT deviation float8, OUT deviation_sd float8) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_faces' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 20;
CREATE OR REPLACE FUNCTION ab_evidence_accum(state internal, solid ab_solid, patch ab_scan, model ab_evidence_model) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
CREATE OR REPLACE FUNCTION ab_rollup_accum(state internal, e ab_evidence) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_rollup_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 500000;
CREATE OR REPLACE FUNCTION ab_evidence_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
CREATE OR REPLACE FUNCTION ab_evidence_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_evidence_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
CREATE OR REPLACE FUNCTION ab_evidence_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
CREATE OR REPLACE FUNCTION ab_evidence_final(state internal) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
CREATE OR REPLACE FUNCTION ab_overlaps(a ab_box, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_overlaps(a ab_solid, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_overlaps(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_overlaps(a ab_scan, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_overlaps(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
ALTER OPERATOR && (ab_box, ab_box) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_solid) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_scan) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_box) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_solid) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_scan) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_scan, ab_box) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_scan, ab_solid) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_scan, ab_scan) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
CREATE OR REPLACE FUNCTION ab_box(point ab_point, probability float8 DEFAULT 0.95) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 300;
CREATE OR REPLACE FUNCTION ab_box(line ab_line, probability float8 DEFAULT 0.95) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_line_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 300;
ALTER OPERATOR && (ab_point, ab_box) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_point, ab_point) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_line, ab_box) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_point) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_line) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_point) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
ALTER OPERATOR && (ab_point, ab_solid) SET (RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
CREATE OR REPLACE FUNCTION ab_cone(patch ab_scan, OUT axis float8[], OUT half_angle float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_cone' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_cone(ab_scan) IS 'Directions of a patch: the axis of its cone and the half-angle, radians; NULL where the beams do not start at one place';
CREATE OR REPLACE FUNCTION ab_range(patch ab_scan, OUT nearest float8, OUT farthest float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_range(ab_scan) IS 'Least and greatest range of its returns, metres; NULL where nothing returned or nobody knows the origin';
CREATE FUNCTION ab_beams(patch ab_scan, OUT origin float8[], OUT point float8[], OUT direction float8[], OUT range float8, OUT intensity integer, OUT colour integer[]) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_scan_beams' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50000 ROWS 4000;
COMMENT ON FUNCTION ab_beams(ab_scan) IS 'Every beam: where it starts, its return (NULL where nothing came back), its unit direction and range, metres; intensity and colour (red, green, blue) where the patch has them';
CREATE OR REPLACE FUNCTION ab_sees(patch ab_scan, box ab_box, margin float8 DEFAULT 0) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_sees' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_filter(patch ab_scan, box ab_box) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
CREATE OR REPLACE FUNCTION ab_filter(patch ab_scan, min_range float8, max_range float8 DEFAULT 'infinity') RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_filter(ab_scan, float8, float8) IS 'The returns from min_range to max_range metres away; NULL where there is none; an error for points without origin';
CREATE OR REPLACE FUNCTION ab_thin(patch ab_scan, spacing float8) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_thin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
CREATE OR REPLACE FUNCTION ab_transform(patch ab_scan, pose ab_pose) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_transform_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
CREATE FUNCTION ab_union(patches ab_scan[]) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_union' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_union(ab_scan[]) IS 'Patches of one station and origin as one patch of at most 4096 beams, at the finest quantum of all; a plane that one of them lacks is dropped; NULL for none';
CREATE AGGREGATE ab_union(patch ab_scan) (SFUNC = array_append, STYPE = ab_scan[], FINALFUNC = ab_union, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_union(ab_scan) IS 'Patches of one station and origin as one patch of at most 4096 beams';
CREATE OR REPLACE FUNCTION ab_retile(patches ab_scan[]) RETURNS SETOF ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_retile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000 ROWS 10;
COMMENT ON FUNCTION ab_retile(ab_scan[]) IS 'The beams of patches of one station cut anew into tiles of at most 4096 neighbours: by direction where they have one origin (a beam of length zero has none, and is dropped), else by place';
CREATE FUNCTION ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[]) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_accum(internal, float8, float8, float8, float8[]) IS 'Transition of ab_scan_agg';
CREATE FUNCTION ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[], station bigint, intensity integer) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_accum(internal, float8, float8, float8, float8[], bigint, integer) IS 'Transition of ab_scan_agg';
CREATE FUNCTION ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[], station bigint, intensity integer, colour integer[]) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_accum(internal, float8, float8, float8, float8[], bigint, integer, integer[]) IS 'Transition of ab_scan_agg';
CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[]) (
    SFUNC = ab_scan_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[]) IS
    'Patches from rows of returns (world metres), of station 0: one origin makes angular tiles, an origin a row a moving platform. Rows that come ordered pack best; unnest() makes rows of the array. A row with a NULL adds nothing, nor does a return at its own origin';
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
ALTER OPERATOR @> (ab_box, ab_box) SET (RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_box) SET (RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
ALTER OPERATOR @> (ab_solid, ab_box) SET (RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
ALTER OPERATOR <@ (ab_solid, ab_box) SET (RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_solid) SET (RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_solid) SET (RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
ALTER OPERATOR ~= (ab_solid, ab_box) SET (RESTRICT = eqsel, JOIN = eqjoinsel);
CREATE OR REPLACE FUNCTION ab_contains(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_contained(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_same(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_box_distance(a ab_scan, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_scan_distance_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_box_distance(ab_scan, ab_box) IS 'Least distance of the box of a patch''s returns from a box, metres; infinite without returns';
ALTER OPERATOR @> (ab_scan, ab_box) SET (RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
ALTER OPERATOR <@ (ab_scan, ab_box) SET (RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_scan) SET (RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_scan) SET (RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
ALTER OPERATOR ~= (ab_scan, ab_box) SET (RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR <-> (ab_scan, ab_box) IS 'Least distance of the box of a patch''s returns from a box, metres; infinite without returns; for nearest first';
ALTER OPERATOR @> (ab_point, ab_box) SET (RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
ALTER OPERATOR <@ (ab_point, ab_box) SET (RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_point) SET (RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_point) SET (RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
ALTER OPERATOR ~= (ab_point, ab_box) SET (RESTRICT = eqsel, JOIN = eqjoinsel);
CREATE FUNCTION ab_box_distance(a ab_box, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_box_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_box, ab_point) IS 'Least distance of a box from a point, metres';
CREATE OPERATOR <-> (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_box, ab_point) IS 'Least distance of a box from a point, metres; for nearest first';
CREATE FUNCTION ab_box_distance(a ab_solid, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_solid_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_solid, ab_point) IS 'Least distance of the box of a solid from a point, metres';
CREATE OPERATOR <-> (LEFTARG = ab_solid, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_solid, ab_point) IS 'Least distance of the box of a solid from a point, metres; for nearest first';
CREATE FUNCTION ab_box_distance(a ab_scan, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_scan_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_box_distance(ab_scan, ab_point) IS 'Least distance of the box of a patch''s returns from a point, metres; infinite without returns';
CREATE OPERATOR <-> (LEFTARG = ab_scan, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_scan, ab_point) IS 'Least distance of the box of a patch''s returns from a point, metres; infinite without returns; for nearest first';
CREATE FUNCTION ab_box_distance(a ab_point, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_point, ab_point) IS 'Least distance of a point from a point, metres; uncertainties do not count';
CREATE OPERATOR <-> (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_point, ab_point) IS 'Least distance of a point from a point, metres; uncertainties do not count; for nearest first';
CREATE OR REPLACE FUNCTION ab_gist_distance(entry internal, query ab_scan, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance_lossy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE OR REPLACE FUNCTION ab_gist_distance(entry internal, query ab_point, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance_lossy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
ALTER OPERATOR FAMILY ab_box_gist_ops USING gist ADD OPERATOR 14 <-> (ab_box, ab_point) FOR ORDER BY float_ops;
ALTER OPERATOR FAMILY ab_solid_gist_ops USING gist ADD OPERATOR 14 <-> (ab_solid, ab_point) FOR ORDER BY float_ops;
ALTER OPERATOR FAMILY ab_scan_gist_ops USING gist ADD OPERATOR 14 <-> (ab_scan, ab_point) FOR ORDER BY float_ops;
ALTER OPERATOR FAMILY ab_point_gist_ops USING gist ADD OPERATOR 14 <-> (ab_point, ab_point) FOR ORDER BY float_ops;
CREATE FUNCTION ab_gist_sort(support internal) RETURNS void
    AS 'MODULE_PATHNAME', 'ab_gist_sort' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_sort(internal) IS 'GiST support';
ALTER OPERATOR FAMILY ab_box_gist_ops USING gist ADD FUNCTION 11 (ab_box, ab_box) ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_solid_gist_ops USING gist ADD FUNCTION 11 (ab_solid, ab_solid) ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_scan_gist_ops USING gist ADD FUNCTION 11 (ab_scan, ab_scan) ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_point_gist_ops USING gist ADD FUNCTION 11 (ab_point, ab_point) ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_line_gist_ops USING gist ADD FUNCTION 11 (ab_line, ab_line) ab_gist_sort(internal);
CREATE FUNCTION ab_solid_from_ewkb(ewkb bytea) RETURNS ab_solid
    AS 'MODULE_PATHNAME', 'ab_solid_from_ewkb' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_solid_from_ewkb(bytea) IS 'A solid from WKB or EWKB of a POLYHEDRALSURFACE Z, TIN Z, MULTIPOLYGON Z, POLYGON Z or TRIANGLE Z in metres, as ST_AsEWKB gives it; faces of more than three corners are cut into triangles, the SRID is dropped';
CREATE FUNCTION ab_as_ewkb(solid ab_solid, tin boolean DEFAULT false) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_solid_as_ewkb' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_as_ewkb(ab_solid, boolean) IS 'EWKB of a solid as POLYHEDRALSURFACE Z, or as TIN Z; one face a triangle, no SRID';
