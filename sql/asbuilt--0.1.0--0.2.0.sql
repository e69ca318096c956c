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
-- Verifying many objects at once.
CREATE FUNCTION ab_verify_table(
    objects text, scans text, model ab_evidence_model DEFAULT NULL, keep_evidence boolean DEFAULT true,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL,
    OUT id bigint, OUT e ab_evidence, OUT verdict text, OUT best_loa ab_loa, OUT samples bigint, OUT coverage float8,
    OUT confirmed float8, OUT refuted float8, OUT open float8, OUT conflict float8,
    OUT deviation float8, OUT deviation_sd float8, OUT shift text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_verify_table' LANGUAGE c STABLE PARALLEL RESTRICTED COST 100000000 ROWS 1000;
COMMENT ON FUNCTION ab_verify_table(text, text, ab_evidence_model, boolean, float8, float8, float8) IS 'Evidence and verdict of every object of one query (id, solid, perhaps its own ab_evidence_model) from the patches of another; every patch is unpacked once for all objects. Uses as many threads as a parallel plan would have processes (max_parallel_workers_per_gather + 1)';

CREATE FUNCTION ab_stations(
    e ab_evidence, OUT station bigint, OUT origin float8[], OUT seen bigint, OUT added bigint) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_stations' LANGUAGE c STABLE PARALLEL SAFE COST 10000000 ROWS 5;
COMMENT ON FUNCTION ab_stations(ab_evidence) IS 'What each station contributed: the samples that it sees by itself, and those that would be unseen without it; origin NULL for moving platforms and points without origin';

CREATE FUNCTION ab_explain(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_explain' LANGUAGE c STABLE PARALLEL SAFE COST 10000000;
COMMENT ON FUNCTION ab_explain(ab_evidence, ab_loa, float8, float8, float8, float8) IS 'Why the verdict is what it is: what was seen, what that says, which threshold decided, why no finer level of accuracy holds';

CREATE FUNCTION ab_sensor(
    sensor text DEFAULT NULL,
    OUT name text, OUT sigma_range float8, OUT sigma_angle float8, OUT sigma_station float8, OUT max_range float8, OUT description text)
    RETURNS SETOF record AS 'MODULE_PATHNAME', 'ab_sensor' LANGUAGE c IMMUTABLE PARALLEL SAFE ROWS 6;
COMMENT ON FUNCTION ab_sensor(text) IS 'Standard uncertainties of a kind of scanner, of the order that field tests by ISO 17123-9 find: phase, hybrid, pulse, compact, handheld or tablet; all without a name. Metres and radians';

CREATE FUNCTION ab_with_sensor(model ab_evidence_model, sensor text) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_with_sensor' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_with_sensor(ab_evidence_model, text) IS 'The same parameters with a sensor''s standard uncertainties: sigma_range, sigma_angle and sigma_station of ab_sensor';

CREATE FUNCTION ab_with_intensity(model ab_evidence_model, reference integer, exponent float8 DEFAULT 1) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_with_intensity' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_with_intensity(ab_evidence_model, integer, float8) IS 'The same parameters with range noise by intensity: sigma_range holds from the reference on (the sensor''s own unit), below it the variance grows by (reference/intensity)^exponent. For patches with intensities; exponent 1 is shot noise';

-- Voxels.

CREATE TYPE ab_grid;
CREATE FUNCTION ab_grid_in(cstring) RETURNS ab_grid AS 'MODULE_PATHNAME', 'ab_grid_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_grid_out(ab_grid) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_grid_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_grid_recv(internal) RETURNS ab_grid AS 'MODULE_PATHNAME', 'ab_grid_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_grid_send(ab_grid) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_grid_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_grid_in(cstring) IS 'Text input of ab_grid';
COMMENT ON FUNCTION ab_grid_out(ab_grid) IS 'Text output of ab_grid';
COMMENT ON FUNCTION ab_grid_recv(internal) IS 'Binary input of ab_grid';
COMMENT ON FUNCTION ab_grid_send(ab_grid) IS 'Binary output of ab_grid';
CREATE TYPE ab_grid (INPUT = ab_grid_in, OUTPUT = ab_grid_out, RECEIVE = ab_grid_recv, SEND = ab_grid_send, INTERNALLENGTH = 80, ALIGNMENT = double);
COMMENT ON TYPE ab_grid IS 'A lattice of voxels and the tile of it that is looked at: see ab_grid()';

CREATE TYPE ab_occupancy;
CREATE FUNCTION ab_occupancy_in(cstring) RETURNS ab_occupancy AS 'MODULE_PATHNAME', 'ab_occupancy_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_occupancy_out(ab_occupancy) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_occupancy_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_occupancy_recv(internal) RETURNS ab_occupancy AS 'MODULE_PATHNAME', 'ab_occupancy_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_occupancy_send(ab_occupancy) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_occupancy_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_occupancy_in(cstring) IS 'Text input of ab_occupancy';
COMMENT ON FUNCTION ab_occupancy_out(ab_occupancy) IS 'Text output of ab_occupancy';
COMMENT ON FUNCTION ab_occupancy_recv(internal) IS 'Binary input of ab_occupancy';
COMMENT ON FUNCTION ab_occupancy_send(ab_occupancy) IS 'Binary output of ab_occupancy';
CREATE TYPE ab_occupancy (INPUT = ab_occupancy_in, OUTPUT = ab_occupancy_out, RECEIVE = ab_occupancy_recv, SEND = ab_occupancy_send, INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = external, ANALYZE = ab_typanalyze);
COMMENT ON TYPE ab_occupancy IS 'What the beams of an epoch say of the voxels of a tile: returns in each, and whether a beam passed; or a drawn model in voxels';

CREATE TYPE ab_change;
CREATE FUNCTION ab_change_in(cstring) RETURNS ab_change AS 'MODULE_PATHNAME', 'ab_change_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_change_out(ab_change) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_change_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_change_recv(internal) RETURNS ab_change AS 'MODULE_PATHNAME', 'ab_change_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_change_send(ab_change) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_change_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_change_in(cstring) IS 'Text input of ab_change';
COMMENT ON FUNCTION ab_change_out(ab_change) IS 'Text output of ab_change';
COMMENT ON FUNCTION ab_change_recv(internal) IS 'Binary input of ab_change';
COMMENT ON FUNCTION ab_change_send(ab_change) IS 'Binary output of ab_change';
CREATE TYPE ab_change (INPUT = ab_change_in, OUTPUT = ab_change_out, RECEIVE = ab_change_recv, SEND = ab_change_send, INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = external, ANALYZE = ab_typanalyze);
COMMENT ON TYPE ab_change IS 'Voxels of a tile that are occupied in at least one of two epochs (or in the model), and what became of them';

CREATE FUNCTION ab_grid(voxel float8 DEFAULT 0.01, tile ab_box DEFAULT NULL, margin float8 DEFAULT 0.01, no_return_range float8 DEFAULT 0, exact boolean DEFAULT false) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_grid_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_grid(float8, ab_box, float8, float8, boolean) IS 'Voxels of an edge (metres) on the lattice of the reference system, those of a tile or all; a beam says empty up to the margin before its return (for noise and registration), without return up to no_return_range; exact: only voxels that a beam itself passes are empty, not those between neighbouring beams of a patch';

CREATE FUNCTION ab_grid(occupancy ab_occupancy) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_occupancy_grid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_grid(ab_occupancy) IS 'Lattice, tile and rules of an occupancy';

CREATE FUNCTION ab_grid(change ab_change) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_change_grid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_grid(ab_change) IS 'Lattice and tile of a change';

CREATE FUNCTION ab_tiles(area ab_box, size float8) RETURNS SETOF ab_box
    AS 'MODULE_PATHNAME', 'ab_tiles' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 100;
COMMENT ON FUNCTION ab_tiles(ab_box, float8) IS 'The boxes of a lattice of tiles (edge in metres) that meet an area: neighbours share no voxel where the edge is a multiple of the voxel';

CREATE FUNCTION ab_box(occupancy ab_occupancy) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box(ab_occupancy) IS 'Box of the blocks of voxels of which something is known; NULL for none';

CREATE FUNCTION ab_box(change ab_change) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box(ab_change) IS 'Box of the blocks of voxels that have a class; NULL for none';


CREATE FUNCTION ab_occupancy_accum(state internal, patch ab_scan, grid ab_grid) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 2000000;
COMMENT ON FUNCTION ab_occupancy_accum(internal, ab_scan, ab_grid) IS 'Transition of ab_occupancy_agg';

CREATE FUNCTION ab_occupancy_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_occupancy_combine(internal, internal) IS 'Combine of ab_occupancy_agg';

CREATE FUNCTION ab_occupancy_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_occupancy_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_occupancy_serial(internal) IS 'Serialisation of ab_occupancy_agg';

CREATE FUNCTION ab_occupancy_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_occupancy_deserial(bytea, internal) IS 'Deserialisation of ab_occupancy_agg';

CREATE FUNCTION ab_occupancy_final(state internal) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_occupancy_final(internal) IS 'Final of ab_occupancy_agg';

CREATE AGGREGATE ab_occupancy_agg(patch ab_scan, grid ab_grid) (
    SFUNC = ab_occupancy_accum, STYPE = internal, SSPACE = 50000000,
    COMBINEFUNC = ab_occupancy_combine, SERIALFUNC = ab_occupancy_serial, DESERIALFUNC = ab_occupancy_deserial,
    FINALFUNC = ab_occupancy_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_occupancy_agg(ab_scan, ab_grid) IS 'Occupancy of the tile of a grid from patches, whatever their order; one grid a group. A NULL patch adds nothing. At most asbuilt.max_grid_memory at a time in every process';

CREATE FUNCTION ab_occupancy_rollup_accum(state internal, occupancy ab_occupancy) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_rollup_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_occupancy_rollup_accum(internal, ab_occupancy) IS 'Transition of ab_rollup_agg';

CREATE AGGREGATE ab_rollup_agg(occupancy ab_occupancy) (
    SFUNC = ab_occupancy_rollup_accum, STYPE = internal, SSPACE = 50000000,
    COMBINEFUNC = ab_occupancy_combine, SERIALFUNC = ab_occupancy_serial, DESERIALFUNC = ab_occupancy_deserial,
    FINALFUNC = ab_occupancy_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_rollup_agg(ab_occupancy) IS 'Adds up occupancy of one lattice: stations of an epoch, neighbouring tiles, solids of a model';

CREATE FUNCTION ab_rollup(o1 ab_occupancy, o2 ab_occupancy) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 400000;
COMMENT ON FUNCTION ab_rollup(ab_occupancy, ab_occupancy) IS 'Adds up two occupancies of one lattice: as if all patches had been aggregated at once; NULL counts as nothing';

CREATE FUNCTION ab_union(o1 ab_occupancy, o2 ab_occupancy) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 400000;
COMMENT ON FUNCTION ab_union(ab_occupancy, ab_occupancy) IS 'The same as ab_rollup';

CREATE FUNCTION ab_occupancy(grid ab_grid, model boolean DEFAULT false) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_empty' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION ab_occupancy(ab_grid, boolean) IS 'An occupancy of which nothing is known: what ab_occupancy_agg of no rows would be, were it not NULL; or a model that fills nothing';

CREATE FUNCTION ab_clip(occupancy ab_occupancy, tile ab_box) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_clip' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_clip(ab_occupancy, ab_box) IS 'The voxels of an occupancy whose centres lie in a box';


CREATE FUNCTION ab_state(occupancy ab_occupancy, x float8, y float8, z float8, threshold integer DEFAULT 3) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_occupancy_state' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_state(ab_occupancy, float8, float8, float8, integer) IS 'State of the voxel that holds a point: occupied (as many returns as the threshold), ambiguous (the same, but beams passed too), empty, unknown';

CREATE FUNCTION ab_voxels(occupancy ab_occupancy, states text[] DEFAULT '{occupied,ambiguous}', threshold integer DEFAULT 3, OUT x float8, OUT y float8, OUT z float8, OUT state text, OUT hits integer) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_occupancy_voxels' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 500000 ROWS 100000;
COMMENT ON FUNCTION ab_voxels(ab_occupancy, text[], integer) IS 'Centres of the voxels of some states, with the returns in each (255 for more)';

CREATE FUNCTION ab_slice(occupancy ab_occupancy, axis text, at float8, threshold integer DEFAULT 3) RETURNS integer[]
    AS 'MODULE_PATHNAME', 'ab_occupancy_slice' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_slice(ab_occupancy, text, float8, integer) IS 'The layer of voxels at a coordinate on an axis (x, y or z) as a picture: 0 unknown, 1 empty, 2 occupied, 3 ambiguous; rows along the later of the other axes, as far as anything is known';

CREATE FUNCTION ab_summary(occupancy ab_occupancy, threshold integer DEFAULT 3, solid ab_solid DEFAULT NULL, OUT occupied bigint, OUT ambiguous bigint, OUT empty bigint, OUT unknown bigint, OUT occupied_m3 float8, OUT ambiguous_m3 float8, OUT empty_m3 float8, OUT unknown_m3 float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_occupancy_summary' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_summary(ab_occupancy, integer, ab_solid) IS 'Voxels and cubic metres of each state, overall or of the voxels that a solid touches; unknown is NULL where neither tile nor solid says of how many';

CREATE FUNCTION ab_denoise(occupancy ab_occupancy, neighbours integer DEFAULT 1, threshold integer DEFAULT 1) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_denoise' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_denoise(ab_occupancy, integer, integer) IS 'Without the returns of voxels that have fewer occupied neighbours than that, of the 26 around';

CREATE FUNCTION ab_downsample(occupancy ab_occupancy) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_downsample' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_downsample(ab_occupancy) IS 'Voxels twice as large: returns added up, passed where one of the eight was passed';

CREATE FUNCTION ab_voxelize(solid ab_solid, voxel float8, rule text DEFAULT 'centre', tile ab_box DEFAULT NULL) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_voxelize' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_voxelize(ab_solid, float8, text, ab_box) IS 'A solid as occupancy of which everything is known: the voxels whose centre lies inside (centre), that it touches (cover), or that its surface passes through (surface; the one rule for open surfaces); those of a tile or all';

CREATE FUNCTION ab_voxel_accuracy(voxel float8, OUT max_error float8, OUT absolute ab_loa, OUT relative ab_loa, OUT relative_linear ab_loa) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_voxel_accuracy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10;
COMMENT ON FUNCTION ab_voxel_accuracy(float8) IS 'What voxels of an edge support: greatest error of a centre, half the diagonal (Meyer 4.1), and the finest levels of accuracy that hold it, for places and for distances (errors added as squares or linearly, 4.4 and 4.5)';


CREATE FUNCTION ab_change(old ab_occupancy, new ab_occupancy, threshold integer DEFAULT 3, tolerance float8 DEFAULT NULL) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_between' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_change(ab_occupancy, ab_occupancy, integer, float8) IS 'Voxels that are occupied in one of two epochs: confirmed, new, disappeared, unknown, ambiguous. A change counts only if the other epoch has nothing occupied within the tolerance (metres; NULL: the margin of the grids; 0: voxel by voxel). A model as old side: new means unmodelled, disappeared absent';

CREATE FUNCTION ab_summary(change ab_change, solid ab_solid DEFAULT NULL, margin float8 DEFAULT NULL, OUT confirmed bigint, OUT new bigint, OUT disappeared bigint, OUT unknown bigint, OUT ambiguous bigint, OUT total bigint, OUT confirmed_m3 float8, OUT new_m3 float8, OUT disappeared_m3 float8, OUT unknown_m3 float8, OUT ambiguous_m3 float8, OUT total_m3 float8, OUT confirmed_share float8, OUT new_share float8, OUT disappeared_share float8, OUT unknown_share float8, OUT ambiguous_share float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_change_summary' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_summary(ab_change, ab_solid, float8) IS 'Voxels, cubic metres and shares of each class (total: occupied in one of the epochs), overall or of the voxels that a solid touches or that lie within the margin of those (metres; NULL: the tolerance of the change); shares are NULL for none';

CREATE FUNCTION ab_voxels(change ab_change, classes text[] DEFAULT NULL, OUT x float8, OUT y float8, OUT z float8, OUT class text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_change_voxels' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000 ROWS 100000;
COMMENT ON FUNCTION ab_voxels(ab_change, text[]) IS 'Centres of the voxels of some classes, or of all';

CREATE FUNCTION ab_components(change ab_change, of_class text DEFAULT NULL, min_voxels integer DEFAULT 10, gap float8 DEFAULT NULL, OUT class text, OUT voxels bigint, OUT volume float8, OUT box ab_box, OUT centroid float8[]) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_change_components' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 500000 ROWS 20;
COMMENT ON FUNCTION ab_components(ab_change, text, integer, float8) IS 'What is new or has disappeared (or is of the class named) as connected things of at least min_voxels, largest first; voxels hang together when the gap between them is less than that (metres; NULL: four voxels)';

CREATE FUNCTION ab_clip(change ab_change, tile ab_box) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_clip' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_clip(ab_change, ab_box) IS 'The voxels of a change whose centres lie in a box: aggregate tiles a little larger than wanted, so that the tolerance sees across their borders, and clip their change';

CREATE FUNCTION ab_rollup(c1 ab_change, c2 ab_change) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_rollup(ab_change, ab_change) IS 'Changes of two tiles as one; NULL counts as nothing';

CREATE AGGREGATE ab_rollup_agg(change ab_change) (SFUNC = ab_rollup, STYPE = ab_change, COMBINEFUNC = ab_rollup, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_rollup_agg(ab_change) IS 'Changes of tiles as one, so that ab_components sees what crosses their borders';

CREATE FUNCTION ab_differ(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_box, ab_box) IS 'Not the same numbers';
CREATE FUNCTION ab_hash(box ab_box) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_box_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_box) IS 'Hash of the numbers';
CREATE FUNCTION ab_hash(box ab_box, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_box_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_box, bigint) IS 'Hash of the numbers with a seed';
CREATE OPERATOR = (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_box, ab_box) IS 'Same numbers';
CREATE OPERATOR <> (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_box, ab_box) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_box_hash_ops DEFAULT FOR TYPE ab_box USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_box), FUNCTION 2 ab_hash(ab_box, bigint);
COMMENT ON OPERATOR CLASS ab_box_hash_ops USING hash IS 'Joins and groups by equal numbers';
CREATE FUNCTION ab_lt(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_box, ab_box) IS 'Before in the order of their corners';
CREATE OPERATOR < (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_box, ab_box) IS 'Before in the order of their corners';
CREATE FUNCTION ab_le(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_box, ab_box) IS 'Not after in the order of their corners';
CREATE OPERATOR <= (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_box, ab_box) IS 'Not after in the order of their corners';
CREATE FUNCTION ab_ge(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_box, ab_box) IS 'Not before in the order of their corners';
CREATE OPERATOR >= (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_box, ab_box) IS 'Not before in the order of their corners';
CREATE FUNCTION ab_gt(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_box, ab_box) IS 'After in the order of their corners';
CREATE OPERATOR > (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_box, ab_box) IS 'After in the order of their corners';
CREATE FUNCTION ab_compare(a ab_box, b ab_box) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_box_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_box, ab_box) IS '-1, 0 or 1 in the order of their corners';
CREATE OPERATOR CLASS ab_box_ops DEFAULT FOR TYPE ab_box USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_box, ab_box);
COMMENT ON OPERATOR CLASS ab_box_ops USING btree IS 'Order by their corners';


CREATE FUNCTION ab_overlaps(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_occupancy, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_occupancy) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_occupancy, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_occupancy, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_occupancy) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_contains(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_contains(ab_occupancy, ab_box) IS 'Does the box of an occupancy hold a box';

CREATE FUNCTION ab_contained(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_contained(ab_occupancy, ab_box) IS 'Does the box of an occupancy lie in a box';

CREATE FUNCTION ab_same(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_same(ab_occupancy, ab_box) IS 'Is the box of an occupancy that box';

CREATE FUNCTION ab_box_distance(a ab_occupancy, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box_distance(ab_occupancy, ab_box) IS 'Least distance of the box of an occupancy from a box, metres';

CREATE FUNCTION ab_box_distance(a ab_occupancy, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box_distance(ab_occupancy, ab_point) IS 'Least distance of the box of an occupancy from a point, metres';

CREATE FUNCTION ab_contains(a ab_box, b ab_occupancy) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN ab_contained(b, a);
COMMENT ON FUNCTION ab_contains(ab_box, ab_occupancy) IS 'Does a box hold the box of an occupancy';

CREATE FUNCTION ab_contained(a ab_box, b ab_occupancy) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN ab_contains(b, a);
COMMENT ON FUNCTION ab_contained(ab_box, ab_occupancy) IS 'Does a box lie in the box of an occupancy';

CREATE OPERATOR && (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_occupancy, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_box, ab_occupancy) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_occupancy, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_occupancy, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_occupancy, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_solid, ab_occupancy) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR @> (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_occupancy, ab_box) IS 'Does the box of an occupancy hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_occupancy, ab_box) IS 'Does the box of an occupancy lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_box, ab_occupancy) IS 'Does a box hold the box of an occupancy';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_box, ab_occupancy) IS 'Does a box lie in the box of an occupancy';
CREATE OPERATOR ~= (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_occupancy, ab_box) IS 'Is the box of an occupancy that box';
CREATE OPERATOR <-> (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_occupancy, ab_box) IS 'Least distance of the box of an occupancy from a box, metres; for nearest first';
CREATE OPERATOR <-> (LEFTARG = ab_occupancy, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_occupancy, ab_point) IS 'Least distance of the box of an occupancy from a point, metres; for nearest first';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_occupancy, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_occupancy, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_occupancy, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_occupancy, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_overlaps(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_change, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_change, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_change, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_contains(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_contains(ab_change, ab_box) IS 'Does the box of a change hold a box';

CREATE FUNCTION ab_contained(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_contained(ab_change, ab_box) IS 'Does the box of a change lie in a box';

CREATE FUNCTION ab_same(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_same(ab_change, ab_box) IS 'Is the box of a change that box';

CREATE FUNCTION ab_box_distance(a ab_change, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box_distance(ab_change, ab_box) IS 'Least distance of the box of a change from a box, metres';

CREATE FUNCTION ab_box_distance(a ab_change, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box_distance(ab_change, ab_point) IS 'Least distance of the box of a change from a point, metres';

CREATE FUNCTION ab_contains(a ab_box, b ab_change) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN ab_contained(b, a);
COMMENT ON FUNCTION ab_contains(ab_box, ab_change) IS 'Does a box hold the box of a change';

CREATE FUNCTION ab_contained(a ab_box, b ab_change) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN ab_contains(b, a);
COMMENT ON FUNCTION ab_contained(ab_box, ab_change) IS 'Does a box lie in the box of a change';

CREATE OPERATOR && (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_change, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_box, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_change, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_change, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_change, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_solid, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR @> (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_change, ab_box) IS 'Does the box of a change hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_change, ab_box) IS 'Does the box of a change lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_box, ab_change) IS 'Does a box hold the box of a change';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_box, ab_change) IS 'Does a box lie in the box of a change';
CREATE OPERATOR ~= (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_change, ab_box) IS 'Is the box of a change that box';
CREATE OPERATOR <-> (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_change, ab_box) IS 'Least distance of the box of a change from a box, metres; for nearest first';
CREATE OPERATOR <-> (LEFTARG = ab_change, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_change, ab_point) IS 'Least distance of the box of a change from a point, metres; for nearest first';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_change, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_change, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_change, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_change, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_tile_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_tile_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_tile_compress(internal) IS 'GiST support';

CREATE OPERATOR CLASS ab_occupancy_gist_ops DEFAULT FOR TYPE ab_occupancy USING gist AS
    OPERATOR 1 && (ab_occupancy, ab_box), OPERATOR 2 && (ab_occupancy, ab_solid),
    OPERATOR 10 @> (ab_occupancy, ab_box), OPERATOR 11 <@ (ab_occupancy, ab_box), OPERATOR 12 ~= (ab_occupancy, ab_box),
    OPERATOR 13 <-> (ab_occupancy, ab_box) FOR ORDER BY float_ops, OPERATOR 14 <-> (ab_occupancy, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 ab_gist_consistent(internal, ab_occupancy, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_tile_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 ab_gist_distance(internal, ab_occupancy, smallint, oid, internal),
    FUNCTION 11 ab_gist_sort(internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_occupancy_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_change_gist_ops DEFAULT FOR TYPE ab_change USING gist AS
    OPERATOR 1 && (ab_change, ab_box), OPERATOR 2 && (ab_change, ab_solid),
    OPERATOR 10 @> (ab_change, ab_box), OPERATOR 11 <@ (ab_change, ab_box), OPERATOR 12 ~= (ab_change, ab_box),
    OPERATOR 13 <-> (ab_change, ab_box) FOR ORDER BY float_ops, OPERATOR 14 <-> (ab_change, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 ab_gist_consistent(internal, ab_change, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_tile_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 ab_gist_distance(internal, ab_change, smallint, oid, internal),
    FUNCTION 11 ab_gist_sort(internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_change_gist_ops USING gist IS 'Joins on && by boxes';

ALTER OPERATOR FAMILY ab_solid_gist_ops USING gist ADD OPERATOR 6 && (ab_solid, ab_occupancy), OPERATOR 7 && (ab_solid, ab_change);
ALTER OPERATOR FAMILY ab_box_gist_ops USING gist ADD OPERATOR 6 && (ab_box, ab_occupancy), OPERATOR 7 && (ab_box, ab_change);

-- Equality, order and hash by bytes, for the types that have no other: a table with such a column can be replicated with
-- REPLICA IDENTITY FULL, compared row by row, and grouped.

-- ab_solid
CREATE FUNCTION _ab_equal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_solid, ab_solid) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_solid, ab_solid) IS 'Of operator <>';
CREATE FUNCTION _ab_less(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less(ab_solid, ab_solid) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less_or_equal(ab_solid, ab_solid) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_solid, ab_solid) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater(ab_solid, ab_solid) IS 'Of operator >';
CREATE FUNCTION _ab_compare(a ab_solid, b ab_solid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_solid, ab_solid) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_solid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_solid) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_solid, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_solid, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_solid, ab_solid) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_solid, ab_solid) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_solid, ab_solid) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_solid, ab_solid) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_solid, ab_solid) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_solid, ab_solid) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_solid_btree_ops DEFAULT FOR TYPE ab_solid USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_solid, ab_solid);
COMMENT ON OPERATOR CLASS ab_solid_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_solid_hash_ops DEFAULT FOR TYPE ab_solid USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_solid), FUNCTION 2 _ab_hash(ab_solid, bigint);
COMMENT ON OPERATOR CLASS ab_solid_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_scan
CREATE FUNCTION _ab_equal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_scan, ab_scan) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_scan, ab_scan) IS 'Of operator <>';
CREATE FUNCTION _ab_less(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less(ab_scan, ab_scan) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less_or_equal(ab_scan, ab_scan) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_scan, ab_scan) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater(ab_scan, ab_scan) IS 'Of operator >';
CREATE FUNCTION _ab_compare(a ab_scan, b ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_scan, ab_scan) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_scan) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_scan, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_scan, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_scan, ab_scan) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_scan, ab_scan) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_scan, ab_scan) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_scan, ab_scan) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_scan, ab_scan) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_scan, ab_scan) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_scan_btree_ops DEFAULT FOR TYPE ab_scan USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_scan, ab_scan);
COMMENT ON OPERATOR CLASS ab_scan_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_scan_hash_ops DEFAULT FOR TYPE ab_scan USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_scan), FUNCTION 2 _ab_hash(ab_scan, bigint);
COMMENT ON OPERATOR CLASS ab_scan_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_evidence
CREATE FUNCTION _ab_equal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_evidence, ab_evidence) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_evidence, ab_evidence) IS 'Of operator <>';
CREATE FUNCTION _ab_less(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less(ab_evidence, ab_evidence) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less_or_equal(ab_evidence, ab_evidence) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_evidence, ab_evidence) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater(ab_evidence, ab_evidence) IS 'Of operator >';
CREATE FUNCTION _ab_compare(a ab_evidence, b ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_evidence, ab_evidence) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_evidence) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_evidence, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_evidence, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_evidence, ab_evidence) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_evidence, ab_evidence) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_evidence, ab_evidence) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_evidence, ab_evidence) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_evidence, ab_evidence) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_evidence, ab_evidence) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_evidence_btree_ops DEFAULT FOR TYPE ab_evidence USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_evidence, ab_evidence);
COMMENT ON OPERATOR CLASS ab_evidence_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_evidence_hash_ops DEFAULT FOR TYPE ab_evidence USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_evidence), FUNCTION 2 _ab_hash(ab_evidence, bigint);
COMMENT ON OPERATOR CLASS ab_evidence_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_occupancy
CREATE FUNCTION _ab_equal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_occupancy, ab_occupancy) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_occupancy, ab_occupancy) IS 'Of operator <>';
CREATE FUNCTION _ab_less(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less(ab_occupancy, ab_occupancy) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less_or_equal(ab_occupancy, ab_occupancy) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_occupancy, ab_occupancy) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater(ab_occupancy, ab_occupancy) IS 'Of operator >';
CREATE FUNCTION _ab_compare(a ab_occupancy, b ab_occupancy) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_occupancy, ab_occupancy) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_occupancy) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_occupancy) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_occupancy, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_occupancy, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_occupancy, ab_occupancy) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_occupancy, ab_occupancy) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_occupancy, ab_occupancy) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_occupancy, ab_occupancy) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_occupancy, ab_occupancy) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_occupancy, ab_occupancy) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_occupancy_btree_ops DEFAULT FOR TYPE ab_occupancy USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_occupancy, ab_occupancy);
COMMENT ON OPERATOR CLASS ab_occupancy_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_occupancy_hash_ops DEFAULT FOR TYPE ab_occupancy USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_occupancy), FUNCTION 2 _ab_hash(ab_occupancy, bigint);
COMMENT ON OPERATOR CLASS ab_occupancy_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_change
CREATE FUNCTION _ab_equal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_change, ab_change) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_change, ab_change) IS 'Of operator <>';
CREATE FUNCTION _ab_less(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less(ab_change, ab_change) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less_or_equal(ab_change, ab_change) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_change, ab_change) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater(ab_change, ab_change) IS 'Of operator >';
CREATE FUNCTION _ab_compare(a ab_change, b ab_change) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_change, ab_change) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_change) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_change) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_change, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_change, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_change, ab_change) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_change, ab_change) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_change, ab_change) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_change, ab_change) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_change, ab_change) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_change, ab_change) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_change_btree_ops DEFAULT FOR TYPE ab_change USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_change, ab_change);
COMMENT ON OPERATOR CLASS ab_change_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_change_hash_ops DEFAULT FOR TYPE ab_change USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_change), FUNCTION 2 _ab_hash(ab_change, bigint);
COMMENT ON OPERATOR CLASS ab_change_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_evidence_model
CREATE FUNCTION _ab_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_evidence_model, ab_evidence_model) IS 'Of operator <>';
CREATE FUNCTION _ab_less(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_evidence_model, ab_evidence_model) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_evidence_model, ab_evidence_model) IS 'Of operator >';
CREATE FUNCTION _ab_compare(a ab_evidence_model, b ab_evidence_model) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_model_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_evidence_model, ab_evidence_model) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_evidence_model) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_model_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_evidence_model) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_evidence_model, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_evidence_model_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_evidence_model, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_evidence_model, ab_evidence_model) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_evidence_model, ab_evidence_model) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_evidence_model, ab_evidence_model) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_evidence_model, ab_evidence_model) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_evidence_model, ab_evidence_model) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_evidence_model, ab_evidence_model) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_evidence_model_btree_ops DEFAULT FOR TYPE ab_evidence_model USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_evidence_model, ab_evidence_model);
COMMENT ON OPERATOR CLASS ab_evidence_model_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_evidence_model_hash_ops DEFAULT FOR TYPE ab_evidence_model USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_evidence_model), FUNCTION 2 _ab_hash(ab_evidence_model, bigint);
COMMENT ON OPERATOR CLASS ab_evidence_model_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_grid
CREATE FUNCTION _ab_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_grid, ab_grid) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_grid, ab_grid) IS 'Of operator <>';
CREATE FUNCTION _ab_less(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_grid, ab_grid) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_grid, ab_grid) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_grid, ab_grid) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_grid, ab_grid) IS 'Of operator >';
CREATE FUNCTION _ab_compare(a ab_grid, b ab_grid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_grid_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_grid, ab_grid) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_grid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_grid_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_grid) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_grid, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_grid_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_grid, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_grid, ab_grid) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_grid, ab_grid) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_grid, ab_grid) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_grid, ab_grid) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_grid, ab_grid) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_grid, ab_grid) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_grid_btree_ops DEFAULT FOR TYPE ab_grid USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_grid, ab_grid);
COMMENT ON OPERATOR CLASS ab_grid_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_grid_hash_ops DEFAULT FOR TYPE ab_grid USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_grid), FUNCTION 2 _ab_hash(ab_grid, bigint);
COMMENT ON OPERATOR CLASS ab_grid_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- What asbuilt takes in this session's process.
CREATE FUNCTION ab_memory(from_now boolean DEFAULT false, OUT live bigint, OUT peak bigint) RETURNS record
    AS 'MODULE_PATHNAME' LANGUAGE c VOLATILE PARALLEL RESTRICTED;
COMMENT ON FUNCTION ab_memory(boolean) IS
    'Bytes that asbuilt''s values and work take in this session''s process now, and the most they ever took; from_now begins the peak anew. What PostgreSQL itself holds of them (rows, results) is not counted';
