-- asbuilt 0.1.0 to 0.2.0.

\echo Use "ALTER EXTENSION asbuilt UPDATE" to load this file. \quit

-- Names of their own for what people do not call; what has other columns or parameters now goes out of the way, for
-- views that were made with it.
ALTER TYPE ab_evidence_model RENAME TO ab_evidence_model_010;
ALTER FUNCTION ab_box_in(cstring) RENAME TO _ab_box_in;
ALTER FUNCTION ab_box_out(ab_box) RENAME TO _ab_box_out;
ALTER FUNCTION ab_box_recv(internal) RENAME TO _ab_box_recv;
ALTER FUNCTION ab_box_send(ab_box) RENAME TO _ab_box_send;
ALTER FUNCTION ab_mass_in(cstring) RENAME TO _ab_mass_in;
ALTER FUNCTION ab_mass_out(ab_mass) RENAME TO _ab_mass_out;
ALTER FUNCTION ab_mass_recv(internal) RENAME TO _ab_mass_recv;
ALTER FUNCTION ab_mass_send(ab_mass) RENAME TO _ab_mass_send;
ALTER FUNCTION ab_solid_in(cstring) RENAME TO _ab_solid_in;
ALTER FUNCTION ab_solid_out(ab_solid) RENAME TO _ab_solid_out;
ALTER FUNCTION ab_solid_recv(internal) RENAME TO _ab_solid_recv;
ALTER FUNCTION ab_solid_send(ab_solid) RENAME TO _ab_solid_send;
ALTER FUNCTION ab_scan_in(cstring) RENAME TO _ab_scan_in;
ALTER FUNCTION ab_scan_out(ab_scan) RENAME TO _ab_scan_out;
ALTER FUNCTION ab_scan_recv(internal) RENAME TO _ab_scan_recv;
ALTER FUNCTION ab_scan_send(ab_scan) RENAME TO _ab_scan_send;
ALTER FUNCTION ab_evidence_model_in(cstring) RENAME TO _ab_evidence_model_in_010;
ALTER FUNCTION ab_evidence_model_out(ab_evidence_model_010) RENAME TO _ab_evidence_model_out_010;
ALTER FUNCTION ab_evidence_model_recv(internal) RENAME TO _ab_evidence_model_recv_010;
ALTER FUNCTION ab_evidence_model_send(ab_evidence_model_010) RENAME TO _ab_evidence_model_send_010;
ALTER FUNCTION ab_evidence_in(cstring) RENAME TO _ab_evidence_in;
ALTER FUNCTION ab_evidence_out(ab_evidence) RENAME TO _ab_evidence_out;
ALTER FUNCTION ab_evidence_recv(internal) RENAME TO _ab_evidence_recv;
ALTER FUNCTION ab_evidence_send(ab_evidence) RENAME TO _ab_evidence_send;
ALTER FUNCTION ab_point_in(cstring) RENAME TO _ab_point_in;
ALTER FUNCTION ab_point_out(ab_point) RENAME TO _ab_point_out;
ALTER FUNCTION ab_point_recv(internal) RENAME TO _ab_point_recv;
ALTER FUNCTION ab_point_send(ab_point) RENAME TO _ab_point_send;
ALTER FUNCTION ab_line_in(cstring) RENAME TO _ab_line_in;
ALTER FUNCTION ab_line_out(ab_line) RENAME TO _ab_line_out;
ALTER FUNCTION ab_line_recv(internal) RENAME TO _ab_line_recv;
ALTER FUNCTION ab_line_send(ab_line) RENAME TO _ab_line_send;
ALTER FUNCTION ab_plane_in(cstring) RENAME TO _ab_plane_in;
ALTER FUNCTION ab_plane_out(ab_plane) RENAME TO _ab_plane_out;
ALTER FUNCTION ab_plane_recv(internal) RENAME TO _ab_plane_recv;
ALTER FUNCTION ab_plane_send(ab_plane) RENAME TO _ab_plane_send;
ALTER FUNCTION ab_pose_in(cstring) RENAME TO _ab_pose_in;
ALTER FUNCTION ab_pose_out(ab_pose) RENAME TO _ab_pose_out;
ALTER FUNCTION ab_pose_recv(internal) RENAME TO _ab_pose_recv;
ALTER FUNCTION ab_pose_send(ab_pose) RENAME TO _ab_pose_send;
ALTER FUNCTION ab_scan(float8[], float8[], float8, bigint, float8) RENAME TO _ab_scan_010;
ALTER FUNCTION ab_loa_class() RENAME TO _ab_loa_class_010;
ALTER FUNCTION ab_tolerance(ab_loa) RENAME TO ab_upper_bound;
ALTER FUNCTION ab_evidence_model(
    ab_loa, text, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8,
    float8) RENAME TO _ab_evidence_model_make_010;
ALTER FUNCTION ab_summary(ab_evidence, ab_loa, float8, float8, float8, float8) RENAME TO _ab_summary_010;
ALTER FUNCTION ab_verdict(ab_evidence, ab_loa, float8, float8, float8, float8) RENAME TO _ab_verdict_010;
ALTER FUNCTION ab_shift(ab_evidence) RENAME TO _ab_shift_010;
ALTER FUNCTION ab_samples(ab_evidence, ab_loa, float8) RENAME TO _ab_samples_010;
ALTER FUNCTION ab_faces(ab_evidence, ab_loa, float8) RENAME TO _ab_faces_010;
ALTER FUNCTION ab_model(ab_evidence) RENAME TO _ab_model_010;
ALTER FUNCTION ab_evidence_accum(internal, ab_solid, ab_scan, ab_evidence_model_010) RENAME TO _ab_evidence_accum_010;
ALTER FUNCTION ab_rollup_accum(internal, ab_evidence) RENAME TO _ab_rollup_accum;
ALTER FUNCTION ab_evidence_combine(internal, internal) RENAME TO _ab_evidence_combine;
ALTER FUNCTION ab_evidence_serial(internal) RENAME TO _ab_evidence_serial;
ALTER FUNCTION ab_evidence_deserial(bytea, internal) RENAME TO _ab_evidence_deserial;
ALTER FUNCTION ab_evidence_final(internal) RENAME TO _ab_evidence_final;
ALTER AGGREGATE ab_evidence_agg(ab_solid, ab_scan, ab_evidence_model_010) RENAME TO _ab_evidence_agg_010;
ALTER FUNCTION ab_equal(ab_box, ab_box) RENAME TO _ab_equal;
ALTER FUNCTION ab_equal(ab_mass, ab_mass) RENAME TO _ab_equal;
ALTER FUNCTION ab_overlaps(ab_box, ab_box) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_box, ab_solid) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_box, ab_scan) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_solid, ab_box) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_solid, ab_solid) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_solid, ab_scan) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_scan, ab_box) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_scan, ab_solid) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_scan, ab_scan) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_gist_consistent(internal, ab_box, smallint, oid, internal) RENAME TO _ab_gist_consistent;
ALTER FUNCTION ab_gist_consistent(internal, ab_solid, smallint, oid, internal) RENAME TO _ab_gist_consistent;
ALTER FUNCTION ab_gist_consistent(internal, ab_scan, smallint, oid, internal) RENAME TO _ab_gist_consistent;
ALTER FUNCTION ab_gist_union(internal, internal) RENAME TO _ab_gist_union;
ALTER FUNCTION ab_gist_scan_compress(internal) RENAME TO _ab_gist_scan_compress;
ALTER FUNCTION ab_gist_solid_compress(internal) RENAME TO _ab_gist_solid_compress;
ALTER FUNCTION ab_gist_penalty(internal, internal, internal) RENAME TO _ab_gist_penalty;
ALTER FUNCTION ab_gist_picksplit(internal, internal) RENAME TO _ab_gist_picksplit;
ALTER FUNCTION ab_gist_same(ab_box, ab_box, internal) RENAME TO _ab_gist_same;
ALTER FUNCTION ab_line(float8[], float8[], float8[]) RENAME TO _ab_line_010;
ALTER FUNCTION ab_plucker(ab_line, float8[]) RENAME TO _ab_plucker_010;
ALTER FUNCTION ab_ellipsoid(ab_point, float8) RENAME TO _ab_ellipsoid_010;
ALTER FUNCTION ab_distance(ab_point, ab_point) RENAME TO _ab_distance_010;
ALTER FUNCTION ab_distance(ab_point, ab_plane) RENAME TO _ab_distance_010;
ALTER FUNCTION ab_distance(ab_point, ab_line) RENAME TO _ab_distance_010;
ALTER FUNCTION ab_distance(ab_line, ab_line) RENAME TO _ab_distance_010;
ALTER FUNCTION ab_points_accum(internal, ab_point) RENAME TO _ab_points_accum;
ALTER FUNCTION ab_points_combine(internal, internal) RENAME TO _ab_points_combine;
ALTER FUNCTION ab_points_serial(internal) RENAME TO _ab_points_serial;
ALTER FUNCTION ab_points_deserial(bytea, internal) RENAME TO _ab_points_deserial;
ALTER FUNCTION ab_line_agg_final(internal) RENAME TO _ab_line_agg_final;
ALTER FUNCTION ab_plane_agg_final(internal) RENAME TO _ab_plane_agg_final;
ALTER FUNCTION ab_test_same(ab_point, ab_point) RENAME TO _ab_test_same_010;
ALTER FUNCTION ab_test_same(ab_plane, ab_plane) RENAME TO _ab_test_same_010;
ALTER FUNCTION ab_test_incident(ab_point, ab_line) RENAME TO _ab_test_incident_010;
ALTER FUNCTION ab_test_incident(ab_point, ab_plane) RENAME TO _ab_test_incident_010;
ALTER FUNCTION ab_test_incident(ab_line, ab_plane) RENAME TO _ab_test_incident_010;
ALTER FUNCTION ab_test_parallel(ab_line, ab_line) RENAME TO _ab_test_parallel_010;
ALTER FUNCTION ab_test_parallel(ab_plane, ab_plane) RENAME TO _ab_test_parallel_010;
ALTER FUNCTION ab_test_parallel(ab_line, ab_plane) RENAME TO _ab_test_parallel_010;
ALTER FUNCTION ab_test_orthogonal(ab_line, ab_line) RENAME TO _ab_test_orthogonal_010;
ALTER FUNCTION ab_test_orthogonal(ab_plane, ab_plane) RENAME TO _ab_test_orthogonal_010;
ALTER FUNCTION ab_test_orthogonal(ab_line, ab_plane) RENAME TO _ab_test_orthogonal_010;
ALTER FUNCTION ab_test_coplanar(ab_line, ab_line) RENAME TO _ab_test_coplanar_010;
ALTER FUNCTION ab_test_incident(ab_line, ab_point) RENAME TO _ab_test_incident_010;
ALTER FUNCTION ab_test_incident(ab_plane, ab_point) RENAME TO _ab_test_incident_010;
ALTER FUNCTION ab_test_incident(ab_plane, ab_line) RENAME TO _ab_test_incident_010;
ALTER FUNCTION ab_test_parallel(ab_plane, ab_line) RENAME TO _ab_test_parallel_010;
ALTER FUNCTION ab_test_orthogonal(ab_plane, ab_line) RENAME TO _ab_test_orthogonal_010;
ALTER FUNCTION ab_distance(ab_plane, ab_point) RENAME TO _ab_distance_010;
ALTER FUNCTION ab_distance(ab_line, ab_point) RENAME TO _ab_distance_010;
ALTER FUNCTION ab_combine_accum(internal, ab_mass) RENAME TO _ab_combine_accum;
ALTER FUNCTION ab_combine_accum(internal, ab_mass, text) RENAME TO _ab_combine_accum;
ALTER FUNCTION ab_combine_accum(internal, ab_mass, text, float8) RENAME TO _ab_combine_accum;
ALTER FUNCTION ab_combine_merge(internal, internal) RENAME TO _ab_combine_merge;
ALTER FUNCTION ab_combine_serial(internal) RENAME TO _ab_combine_serial;
ALTER FUNCTION ab_combine_deserial(bytea, internal) RENAME TO _ab_combine_deserial;
ALTER FUNCTION ab_combine_final(internal) RENAME TO _ab_combine_final;
ALTER FUNCTION ab_convert_belief_linear(float8, float8, float8, float8) RENAME TO _ab_convert_belief_linear_010;
ALTER FUNCTION ab_din18710_class() RENAME TO _ab_din18710_class_010;
ALTER FUNCTION ab_equal(ab_point, ab_point) RENAME TO _ab_equal;
ALTER FUNCTION ab_differ(ab_point, ab_point) RENAME TO _ab_unequal;
ALTER FUNCTION ab_hash(ab_point) RENAME TO _ab_hash;
ALTER FUNCTION ab_hash(ab_point, bigint) RENAME TO _ab_hash;
ALTER FUNCTION ab_equal(ab_line, ab_line) RENAME TO _ab_equal;
ALTER FUNCTION ab_differ(ab_line, ab_line) RENAME TO _ab_unequal;
ALTER FUNCTION ab_hash(ab_line) RENAME TO _ab_hash;
ALTER FUNCTION ab_hash(ab_line, bigint) RENAME TO _ab_hash;
ALTER FUNCTION ab_equal(ab_plane, ab_plane) RENAME TO _ab_equal;
ALTER FUNCTION ab_differ(ab_plane, ab_plane) RENAME TO _ab_unequal;
ALTER FUNCTION ab_hash(ab_plane) RENAME TO _ab_hash;
ALTER FUNCTION ab_hash(ab_plane, bigint) RENAME TO _ab_hash;
ALTER FUNCTION ab_equal(ab_pose, ab_pose) RENAME TO _ab_equal;
ALTER FUNCTION ab_differ(ab_pose, ab_pose) RENAME TO _ab_unequal;
ALTER FUNCTION ab_hash(ab_pose) RENAME TO _ab_hash;
ALTER FUNCTION ab_hash(ab_pose, bigint) RENAME TO _ab_hash;
ALTER FUNCTION ab_differ(ab_mass, ab_mass) RENAME TO _ab_unequal;
ALTER FUNCTION ab_hash(ab_mass) RENAME TO _ab_hash;
ALTER FUNCTION ab_hash(ab_mass, bigint) RENAME TO _ab_hash;
ALTER FUNCTION ab_lt(ab_point, ab_point) RENAME TO _ab_less;
ALTER FUNCTION ab_le(ab_point, ab_point) RENAME TO _ab_less_or_equal;
ALTER FUNCTION ab_ge(ab_point, ab_point) RENAME TO _ab_greater_or_equal;
ALTER FUNCTION ab_gt(ab_point, ab_point) RENAME TO _ab_greater;
ALTER FUNCTION ab_compare(ab_point, ab_point) RENAME TO _ab_compare;
ALTER FUNCTION ab_lt(ab_line, ab_line) RENAME TO _ab_less;
ALTER FUNCTION ab_le(ab_line, ab_line) RENAME TO _ab_less_or_equal;
ALTER FUNCTION ab_ge(ab_line, ab_line) RENAME TO _ab_greater_or_equal;
ALTER FUNCTION ab_gt(ab_line, ab_line) RENAME TO _ab_greater;
ALTER FUNCTION ab_compare(ab_line, ab_line) RENAME TO _ab_compare;
ALTER FUNCTION ab_lt(ab_plane, ab_plane) RENAME TO _ab_less;
ALTER FUNCTION ab_le(ab_plane, ab_plane) RENAME TO _ab_less_or_equal;
ALTER FUNCTION ab_ge(ab_plane, ab_plane) RENAME TO _ab_greater_or_equal;
ALTER FUNCTION ab_gt(ab_plane, ab_plane) RENAME TO _ab_greater;
ALTER FUNCTION ab_compare(ab_plane, ab_plane) RENAME TO _ab_compare;
ALTER FUNCTION ab_lt(ab_pose, ab_pose) RENAME TO _ab_less;
ALTER FUNCTION ab_le(ab_pose, ab_pose) RENAME TO _ab_less_or_equal;
ALTER FUNCTION ab_ge(ab_pose, ab_pose) RENAME TO _ab_greater_or_equal;
ALTER FUNCTION ab_gt(ab_pose, ab_pose) RENAME TO _ab_greater;
ALTER FUNCTION ab_compare(ab_pose, ab_pose) RENAME TO _ab_compare;
ALTER FUNCTION ab_lt(ab_mass, ab_mass) RENAME TO _ab_less;
ALTER FUNCTION ab_le(ab_mass, ab_mass) RENAME TO _ab_less_or_equal;
ALTER FUNCTION ab_ge(ab_mass, ab_mass) RENAME TO _ab_greater_or_equal;
ALTER FUNCTION ab_gt(ab_mass, ab_mass) RENAME TO _ab_greater;
ALTER FUNCTION ab_compare(ab_mass, ab_mass) RENAME TO _ab_compare;
ALTER FUNCTION ab_overlaps(ab_point, ab_box) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_point, ab_point) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_line, ab_box) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_box, ab_point) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_box, ab_line) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_solid, ab_point) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_overlaps(ab_point, ab_solid) RENAME TO _ab_overlaps;
ALTER FUNCTION ab_gist_consistent(internal, ab_point, smallint, oid, internal) RENAME TO _ab_gist_consistent;
ALTER FUNCTION ab_gist_point_compress(internal) RENAME TO _ab_gist_point_compress;
ALTER FUNCTION ab_gist_consistent(internal, ab_line, smallint, oid, internal) RENAME TO _ab_gist_consistent;
ALTER FUNCTION ab_gist_line_compress(internal) RENAME TO _ab_gist_line_compress;
ALTER FUNCTION ab_evidence_accum(
    internal, ab_solid, ab_point, float8[], ab_evidence_model_010) RENAME TO _ab_evidence_accum_010;
ALTER AGGREGATE ab_evidence_agg(ab_solid, ab_point, float8[], ab_evidence_model_010) RENAME TO _ab_evidence_agg_010;
ALTER FUNCTION ab_cone(ab_scan) RENAME TO _ab_cone_010;
ALTER FUNCTION ab_range(ab_scan) RENAME TO _ab_range_010;
ALTER FUNCTION ab_beams(ab_scan) RENAME TO _ab_beams_010;
ALTER FUNCTION ab_scan_accum(internal, float8, float8, float8, float8[], bigint) RENAME TO _ab_scan_accum;
ALTER FUNCTION ab_scan_combine(internal, internal) RENAME TO _ab_scan_combine;
ALTER FUNCTION ab_scan_serial(internal) RENAME TO _ab_scan_serial;
ALTER FUNCTION ab_scan_deserial(bytea, internal) RENAME TO _ab_scan_deserial;
ALTER FUNCTION ab_scan_final(internal) RENAME TO _ab_scan_final;
ALTER FUNCTION ab_contains(ab_box, ab_box) RENAME TO _ab_contains;
ALTER FUNCTION ab_contained(ab_box, ab_box) RENAME TO _ab_contained;
ALTER FUNCTION ab_box_distance(ab_box, ab_box) RENAME TO _ab_box_distance;
ALTER FUNCTION ab_contains(ab_solid, ab_box) RENAME TO _ab_contains;
ALTER FUNCTION ab_contained(ab_solid, ab_box) RENAME TO _ab_contained;
ALTER FUNCTION ab_same(ab_solid, ab_box) RENAME TO _ab_same;
ALTER FUNCTION ab_box_distance(ab_solid, ab_box) RENAME TO _ab_box_distance;
ALTER FUNCTION ab_contains(ab_box, ab_solid) RENAME TO _ab_contains;
ALTER FUNCTION ab_contained(ab_box, ab_solid) RENAME TO _ab_contained;
ALTER FUNCTION ab_contains(ab_scan, ab_box) RENAME TO _ab_contains;
ALTER FUNCTION ab_contained(ab_scan, ab_box) RENAME TO _ab_contained;
ALTER FUNCTION ab_same(ab_scan, ab_box) RENAME TO _ab_same;
ALTER FUNCTION ab_box_distance(ab_scan, ab_box) RENAME TO _ab_box_distance;
ALTER FUNCTION ab_contains(ab_box, ab_scan) RENAME TO _ab_contains;
ALTER FUNCTION ab_contained(ab_box, ab_scan) RENAME TO _ab_contained;
ALTER FUNCTION ab_contains(ab_point, ab_box) RENAME TO _ab_contains;
ALTER FUNCTION ab_contained(ab_point, ab_box) RENAME TO _ab_contained;
ALTER FUNCTION ab_same(ab_point, ab_box) RENAME TO _ab_same;
ALTER FUNCTION ab_box_distance(ab_point, ab_box) RENAME TO _ab_box_distance;
ALTER FUNCTION ab_contains(ab_box, ab_point) RENAME TO _ab_contains;
ALTER FUNCTION ab_contained(ab_box, ab_point) RENAME TO _ab_contained;
ALTER FUNCTION ab_gist_distance(internal, ab_box, smallint, oid, internal) RENAME TO _ab_gist_distance;
ALTER FUNCTION ab_gist_distance(internal, ab_solid, smallint, oid, internal) RENAME TO _ab_gist_distance;
ALTER FUNCTION ab_gist_distance(internal, ab_scan, smallint, oid, internal) RENAME TO _ab_gist_distance;
ALTER FUNCTION ab_gist_distance(internal, ab_point, smallint, oid, internal) RENAME TO _ab_gist_distance;

-- Parameters that were called e. Their functions stay what they are, for indexes and columns that are made with them.
UPDATE pg_catalog.pg_proc p SET proargnames = pg_catalog.array_replace(p.proargnames, 'e', 'evidence')
FROM   pg_catalog.pg_depend d JOIN pg_catalog.pg_extension x ON x.oid = d.refobjid
WHERE  d.refclassid = 'pg_catalog.pg_extension'::pg_catalog.regclass
AND    d.classid = 'pg_catalog.pg_proc'::pg_catalog.regclass AND d.deptype = 'e' AND d.objid = p.oid
AND    x.extname = 'asbuilt' AND 'e' = ANY (p.proargnames) AND p.proname !~ '_010$';

-- What open surfaces have no longer raises an error.
COMMENT ON FUNCTION ab_volume(ab_solid) IS
    'Enclosed volume, m3; NULL for an open surface, which encloses none: ab_closedness says why';

-- 00-types
CREATE TYPE ab_evidence_model;
CREATE FUNCTION _ab_evidence_model_in(cstring) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_model_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_evidence_model_out(ab_evidence_model) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_model_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_evidence_model_recv(internal) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_model_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_evidence_model_send(ab_evidence_model) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_model_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_in(cstring) IS 'Text input of ab_evidence_model';
COMMENT ON FUNCTION _ab_evidence_model_out(ab_evidence_model) IS 'Text output of ab_evidence_model';
COMMENT ON FUNCTION _ab_evidence_model_recv(internal) IS 'Binary input of ab_evidence_model';
COMMENT ON FUNCTION _ab_evidence_model_send(ab_evidence_model) IS 'Binary output of ab_evidence_model';
CREATE TYPE ab_evidence_model (
    INPUT = _ab_evidence_model_in, OUTPUT = _ab_evidence_model_out, RECEIVE = _ab_evidence_model_recv,
    SEND = _ab_evidence_model_send, INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = extended);
COMMENT ON TYPE ab_evidence_model IS
    'Parameters of evidence and verdict that were given, as words name=value; the others have their defaults: see '
    'ab_evidence_model()';
CREATE TYPE ab_grid;
CREATE FUNCTION _ab_grid_in(cstring) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_grid_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_grid_out(ab_grid) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_grid_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_grid_recv(internal) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_grid_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_grid_send(ab_grid) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_grid_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_grid_in(cstring) IS 'Text input of ab_grid';
COMMENT ON FUNCTION _ab_grid_out(ab_grid) IS 'Text output of ab_grid';
COMMENT ON FUNCTION _ab_grid_recv(internal) IS 'Binary input of ab_grid';
COMMENT ON FUNCTION _ab_grid_send(ab_grid) IS 'Binary output of ab_grid';
CREATE TYPE ab_grid (
    INPUT = _ab_grid_in, OUTPUT = _ab_grid_out, RECEIVE = _ab_grid_recv, SEND = _ab_grid_send,
    INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = extended);
COMMENT ON TYPE ab_grid IS 'A lattice of voxels and the tile of it that is looked at: see ab_grid()';
CREATE TYPE ab_occupancy;
CREATE FUNCTION _ab_occupancy_in(cstring) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_occupancy_out(ab_occupancy) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_occupancy_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_occupancy_recv(internal) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_occupancy_send(ab_occupancy) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_occupancy_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_occupancy_in(cstring) IS 'Text input of ab_occupancy';
COMMENT ON FUNCTION _ab_occupancy_out(ab_occupancy) IS 'Text output of ab_occupancy';
COMMENT ON FUNCTION _ab_occupancy_recv(internal) IS 'Binary input of ab_occupancy';
COMMENT ON FUNCTION _ab_occupancy_send(ab_occupancy) IS 'Binary output of ab_occupancy';
CREATE TYPE ab_occupancy (
    INPUT = _ab_occupancy_in, OUTPUT = _ab_occupancy_out, RECEIVE = _ab_occupancy_recv, SEND = _ab_occupancy_send,
    INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = external);
COMMENT ON TYPE ab_occupancy IS
    'What the beams of an epoch say of the voxels of a tile: returns in each, and whether a beam passed; or a drawn '
    'model in voxels';
CREATE TYPE ab_change;
CREATE FUNCTION _ab_change_in(cstring) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_change_out(ab_change) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_change_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_change_recv(internal) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_change_send(ab_change) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_change_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_change_in(cstring) IS 'Text input of ab_change';
COMMENT ON FUNCTION _ab_change_out(ab_change) IS 'Text output of ab_change';
COMMENT ON FUNCTION _ab_change_recv(internal) IS 'Binary input of ab_change';
COMMENT ON FUNCTION _ab_change_send(ab_change) IS 'Binary output of ab_change';
CREATE TYPE ab_change (
    INPUT = _ab_change_in, OUTPUT = _ab_change_out, RECEIVE = _ab_change_recv, SEND = _ab_change_send,
    INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = external);
COMMENT ON TYPE ab_change IS
    'Voxels of a tile that are occupied in at least one of two epochs (or in the model), and what became of them';

-- 02-scan
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
CREATE OR REPLACE FUNCTION ab_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_return_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_returns' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_origin(patch ab_scan) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_scan_origin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_origin(ab_scan) IS
    'Where the beams start, world metres; NULL where they do not start at one place (ab_beams tells each)';
CREATE OR REPLACE FUNCTION ab_station(patch ab_scan) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_scan_station' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_box(ab_scan) IS 'Hull of the beams, origin included, grown by 0.25 m: the box that && compares';
CREATE OR REPLACE FUNCTION ab_point_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
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
CREATE OR REPLACE FUNCTION ab_sees(patch ab_scan, box ab_box, margin float8 DEFAULT 0) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_sees' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION ab_filter(patch ab_scan, box ab_box) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
CREATE OR REPLACE FUNCTION ab_filter(
    patch ab_scan, min_range float8, max_range float8 DEFAULT 'infinity') RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_filter(ab_scan, float8, float8) IS
    'The returns from min_range to max_range metres away; NULL where there is none; an error for points without '
    'origin';
CREATE OR REPLACE FUNCTION ab_thin(patch ab_scan, spacing float8) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_thin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_thin(ab_scan, float8) IS
    'One return for every cube of this side, metres; beams without return are kept. Its step is that of what is left: '
    'the square root of the solid angle that a beam has, over the patch';
CREATE OR REPLACE FUNCTION ab_transform(patch ab_scan, pose ab_pose) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_transform_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
CREATE FUNCTION ab_union(patches ab_scan[]) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_union' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_union(ab_scan[]) IS
    'Patches of one station and origin as one patch of at most 4096 beams, at the finest quantum of all; a plane '
    'that one of them lacks is dropped; NULL for none';
CREATE AGGREGATE ab_union(patch ab_scan) (
    SFUNC = array_append, STYPE = ab_scan[], FINALFUNC = ab_union, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_union(ab_scan) IS 'Patches of one station and origin as one patch of at most 4096 beams';
CREATE OR REPLACE FUNCTION ab_retile(patches ab_scan[]) RETURNS SETOF ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_retile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20000 ROWS 10;
COMMENT ON FUNCTION ab_retile(ab_scan[]) IS
    'The beams of patches of one station cut anew into tiles of at most 4096 neighbours: by direction where they '
    'have one origin (a beam of length zero has none, and is dropped), else by place';
CREATE FUNCTION _ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[]) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_scan_accum(internal, float8, float8, float8, float8[]) IS 'Transition of ab_scan_agg';
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
CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[]) (
    SFUNC = _ab_scan_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_scan_combine,
    SERIALFUNC = _ab_scan_serial, DESERIALFUNC = _ab_scan_deserial, FINALFUNC = _ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[]) IS
    'Patches from rows of returns (world metres), of station 0: one origin makes angular tiles, an origin a row a '
    'moving platform. Rows that come ordered pack best; unnest() makes rows of the array. A row with a NULL adds '
    'nothing, nor does a return at its own origin';
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

-- 03-uncertain
CREATE FUNCTION ab_line(start float8[], finish float8[], covariance float8[] DEFAULT NULL) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_line(float8[], float8[], float8[]) IS
    'A line between two places, with the 6 x 6 covariance of both ends (none: exact)';
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
CREATE TYPE ab_plucker_row AS (line float8[], covariance float8[]);
COMMENT ON TYPE ab_plucker_row IS 'A line in homogeneous coordinates';
COMMENT ON COLUMN ab_plucker_row.line IS
    'Six numbers: direction Y - X, metres, and moment X x Y about the reference, square metres; axes of the world';
COMMENT ON COLUMN ab_plucker_row.covariance IS 'Their 6 x 6 covariance, in the squares of these units';
CREATE FUNCTION ab_plucker(line ab_line, reference float8[] DEFAULT '{0,0,0}') RETURNS ab_plucker_row
    AS 'MODULE_PATHNAME', 'ab_line_plucker' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plucker(ab_line, float8[]) IS
    'Homogeneous Pluecker line (Y - X, X x Y) about a reference point and its 6 x 6 covariance; choose the reference '
    'near the line';
CREATE TYPE ab_ellipsoid_row AS (half_axis float8, direction float8[]);
COMMENT ON TYPE ab_ellipsoid_row IS 'A half-axis of an ellipsoid';
COMMENT ON COLUMN ab_ellipsoid_row.half_axis IS 'Its length, metres';
COMMENT ON COLUMN ab_ellipsoid_row.direction IS
    'Its direction: a unit vector along the axes of the world, of either sign';
CREATE FUNCTION ab_ellipsoid(point ab_point, probability float8 DEFAULT 0.95) RETURNS SETOF ab_ellipsoid_row
    AS 'MODULE_PATHNAME', 'ab_point_ellipsoid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 3;
COMMENT ON FUNCTION ab_ellipsoid(ab_point, float8) IS
    'The ellipsoid that holds the true point with this probability: half-axes by falling length, metres, with their '
    'directions';
CREATE OR REPLACE FUNCTION ab_box(point ab_point, probability float8 DEFAULT 0.95) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 300;
CREATE OR REPLACE FUNCTION ab_box(line ab_line, probability float8 DEFAULT 0.95) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_line_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 300;
CREATE TYPE ab_distance_row AS (distance float8, sd float8);
COMMENT ON TYPE ab_distance_row IS 'A distance with its uncertainty';
COMMENT ON COLUMN ab_distance_row.distance IS
    'The distance, metres; from a plane + on the side of its normal, - behind it; else 0 or more';
COMMENT ON COLUMN ab_distance_row.sd IS 'Its standard deviation, metres';
CREATE FUNCTION ab_distance(a ab_point, b ab_point) RETURNS ab_distance_row
    AS 'MODULE_PATHNAME', 'ab_distance_points' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_distance(ab_point, ab_point) IS
    'Distance with its standard deviation, metres; where it is nought, that of the most uncertain direction';
CREATE FUNCTION ab_distance(point ab_point, plane ab_plane) RETURNS ab_distance_row
    AS 'MODULE_PATHNAME', 'ab_distance_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_distance(ab_point, ab_plane) IS
    'Height in front of a plane (negative behind) with its standard deviation, metres';
CREATE FUNCTION ab_distance(point ab_point, line ab_line) RETURNS ab_distance_row
    AS 'MODULE_PATHNAME', 'ab_distance_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_distance(ab_point, ab_line) IS
    'Distance from an endless line with its standard deviation, metres';
CREATE FUNCTION ab_distance(a ab_line, b ab_line) RETURNS ab_distance_row
    AS 'MODULE_PATHNAME', 'ab_distance_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_distance(ab_line, ab_line) IS
    'Distance of two endless lines with its standard deviation, metres';
CREATE TYPE ab_test_row AS (statistic float8, dof integer, p_value float8);
COMMENT ON TYPE ab_test_row IS 'The outcome of a statistical test';
COMMENT ON COLUMN ab_test_row.statistic IS 'Chi-square statistic, without unit, 0 or more';
COMMENT ON COLUMN ab_test_row.dof IS 'Degrees of freedom: the rank of the covariance';
COMMENT ON COLUMN ab_test_row.p_value IS 'Probability of a statistic as large where the relation holds, 0 to 1';
CREATE FUNCTION ab_test_same(a ab_point, b ab_point) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_same_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_same(ab_point, ab_point) IS
    'Are two points the same? 3 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_same(a ab_plane, b ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_same_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_same(ab_plane, ab_plane) IS
    'Are two planes the same, whichever way they face? 3 degrees of freedom. Chi-square statistic, degrees of '
    'freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_incident(point ab_point, line ab_line) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_point_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_incident(ab_point, ab_line) IS
    'Does a point lie on an endless line? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank '
    'of the covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_incident(point ab_point, plane ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_point_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_incident(ab_point, ab_plane) IS
    'Does a point lie on a plane? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_incident(line ab_line, plane ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_incident(ab_line, ab_plane) IS
    'Does a line lie in a plane? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_parallel(a ab_line, b ab_line) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_parallel_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_parallel(ab_line, ab_line) IS
    'Are two lines parallel? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_parallel(a ab_plane, b ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_parallel_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_parallel(ab_plane, ab_plane) IS
    'Are two planes parallel? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_parallel(line ab_line, plane ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_parallel_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_parallel(ab_line, ab_plane) IS
    'Is a line parallel to a plane? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_orthogonal(a ab_line, b ab_line) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_orthogonal(ab_line, ab_line) IS
    'Are two lines, perhaps skew, orthogonal? 1 degree of freedom. Chi-square statistic, degrees of freedom (the '
    'rank of the covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_orthogonal(a ab_plane, b ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_orthogonal(ab_plane, ab_plane) IS
    'Are two planes orthogonal? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_orthogonal(line ab_line, plane ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_orthogonal(ab_line, ab_plane) IS
    'Is a line orthogonal to a plane? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of '
    'the covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_coplanar(a ab_line, b ab_line) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_coplanar_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_coplanar(ab_line, ab_line) IS
    'Do two endless lines lie in one plane? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank '
    'of the covariance: fewer where it is singular), probability of one as large where it is so';
CREATE FUNCTION ab_test_incident(line ab_line, point ab_point) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_incident(point, line);
COMMENT ON FUNCTION ab_test_incident(ab_line, ab_point) IS
    'Does a point lie on an endless line? 2 degrees of freedom, arguments the other way round';
CREATE FUNCTION ab_test_incident(plane ab_plane, point ab_point) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_incident(point, plane);
COMMENT ON FUNCTION ab_test_incident(ab_plane, ab_point) IS
    'Does a point lie on a plane? 1 degree of freedom, arguments the other way round';
CREATE FUNCTION ab_test_incident(plane ab_plane, line ab_line) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_incident(line, plane);
COMMENT ON FUNCTION ab_test_incident(ab_plane, ab_line) IS
    'Does a line lie in a plane? 2 degrees of freedom, arguments the other way round';
CREATE FUNCTION ab_test_parallel(plane ab_plane, line ab_line) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_parallel(line, plane);
COMMENT ON FUNCTION ab_test_parallel(ab_plane, ab_line) IS
    'Is a line parallel to a plane? 1 degree of freedom, arguments the other way round';
CREATE FUNCTION ab_test_orthogonal(plane ab_plane, line ab_line) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_orthogonal(line, plane);
COMMENT ON FUNCTION ab_test_orthogonal(ab_plane, ab_line) IS
    'Is a line orthogonal to a plane? 2 degrees of freedom, arguments the other way round';
CREATE FUNCTION ab_distance(plane ab_plane, point ab_point) RETURNS ab_distance_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_distance(point, plane);
COMMENT ON FUNCTION ab_distance(ab_plane, ab_point) IS 'As ab_distance(point, plane)';
CREATE FUNCTION ab_distance(line ab_line, point ab_point) RETURNS ab_distance_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_distance(point, line);
COMMENT ON FUNCTION ab_distance(ab_line, ab_point) IS 'As ab_distance(point, line)';

-- 04-belief
CREATE TYPE ab_loa_class_row AS (loa ab_loa, lower float8, upper float8, sigma float8, source text);
COMMENT ON TYPE ab_loa_class_row IS 'A level of accuracy with its bounds';
COMMENT ON COLUMN ab_loa_class_row.loa IS 'The level';
COMMENT ON COLUMN ab_loa_class_row.lower IS 'Lower bound of the deviations at 95 %, metres';
COMMENT ON COLUMN ab_loa_class_row.upper IS 'Upper bound of the deviations at 95 %, metres: the tolerance of a verdict';
COMMENT ON COLUMN ab_loa_class_row.sigma IS 'Standard deviation that belongs to the upper bound, half of it, metres';
COMMENT ON COLUMN ab_loa_class_row.source IS 'Where the bounds come from';
CREATE FUNCTION ab_loa_class() RETURNS SETOF ab_loa_class_row
    AS 'MODULE_PATHNAME', 'ab_loa_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION ab_loa_class() IS
    'Bounds of the levels of accuracy, metres, held by 95 % (2 sigma) of deviations; sigma is upper/2';
CREATE TYPE ab_converted_belief_row AS (belief_to float8, capped boolean);
COMMENT ON TYPE ab_converted_belief_row IS 'A belief at another accuracy';
COMMENT ON COLUMN ab_converted_belief_row.belief_to IS 'The belief within the other standard deviation, 0 to 1';
COMMENT ON COLUMN ab_converted_belief_row.capped IS 'Whether the formula gave more than 1, which belief_to then is';
CREATE FUNCTION ab_convert_belief_linear(
    belief float8, sigma float8, sigma_to float8,
    divisor float8 DEFAULT 0.682689492137086) RETURNS ab_converted_belief_row
    AS 'MODULE_PATHNAME', 'ab_convert_belief_linear' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief_linear(float8, float8, float8, float8) IS
    'The published linear form, for comparison: can exceed 1 and is then capped and marked. Meyer 2022 divides by 2 '
    'Phi(1) - 1 in eq. 5.24 and by 0.95 in table 5.4';
CREATE TYPE ab_din18710_class_row AS (class text, lower float8, upper float8, source text);
COMMENT ON TYPE ab_din18710_class_row IS 'A class of positional accuracy with its bounds';
COMMENT ON COLUMN ab_din18710_class_row.class IS 'The class, L1 to L5';
COMMENT ON COLUMN ab_din18710_class_row.lower IS 'Lower bound of one standard deviation, metres';
COMMENT ON COLUMN ab_din18710_class_row.upper IS 'Upper bound of one standard deviation, metres';
COMMENT ON COLUMN ab_din18710_class_row.source IS 'Where the bounds come from';
CREATE FUNCTION ab_din18710_class() RETURNS SETOF ab_din18710_class_row
    AS 'MODULE_PATHNAME', 'ab_din18710_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION ab_din18710_class() IS
    'DIN 18710-1 classes of positional accuracy: bounds of ONE standard deviation, metres. Not levels of accuracy, '
    'which bound two';

-- 05-evidence
CREATE FUNCTION ab_evidence_model(
    loa ab_loa DEFAULT 'LOA30', model text DEFAULT 'surface', spacing float8 DEFAULT NULL,
    sigma_range float8 DEFAULT NULL, sigma_angle float8 DEFAULT NULL, sigma_station float8 DEFAULT NULL,
    sigma_model float8 DEFAULT NULL, confidence float8 DEFAULT NULL, reliability float8 DEFAULT NULL,
    max_incidence float8 DEFAULT NULL, no_return_range float8 DEFAULT NULL, no_return_weight float8 DEFAULT NULL,
    kappa float8 DEFAULT NULL, lambda float8 DEFAULT NULL, c float8 DEFAULT NULL, reach float8 DEFAULT NULL)
    RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_model_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_evidence_model(
    ab_loa, text, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8,
    float8, float8) IS
    'Parameters of evidence and verdict; what is not given keeps the default of a current terrestrial scanner. '
    'model: surface or meyer2022; lengths in metres, angles in radians. reach: how far from its drawn place '
    'ab_verify_table looks for an object that is not there, 0.3 m where it is not given';
CREATE OR REPLACE FUNCTION ab_rollup(e1 ab_evidence, e2 ab_evidence) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
CREATE FUNCTION ab_reach(solid ab_solid, model ab_evidence_model DEFAULT NULL) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_model_reach' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_reach(ab_solid, ab_evidence_model) IS
    'Box of a solid grown by as far as evidence looks around it: what to join patches with (patch && ab_reach(solid))';

CREATE TYPE ab_summary_row AS (
    verdict text, best_loa ab_loa, samples bigint, coverage float8, confirmed float8, refuted float8, open float8,
    conflict float8, deviation float8, deviation_sd float8, shift float8[], shift_sd float8[],
    deviation_normal float8[], deviation_face integer, reason text, reason_shares float8[], hidden_by text);
COMMENT ON TYPE ab_summary_row IS 'A verdict with the numbers that led to it';
COMMENT ON COLUMN ab_summary_row.verdict IS
    'confirmed, deviating, absent, unobserved or conflicting, at the level of accuracy that was asked';
COMMENT ON COLUMN ab_summary_row.best_loa IS
    'Finest level of accuracy that 95 % of every well-seen surface keeps, proven at the confidence; NULL for none';
COMMENT ON COLUMN ab_summary_row.samples IS
    'Number of samples on the surface of the solid; of leaves and panes those that were seen';
COMMENT ON COLUMN ab_summary_row.coverage IS 'Share of the samples that were seen, 0 to 1';
COMMENT ON COLUMN ab_summary_row.confirmed IS
    'Share of the seen samples at which belief in "built here" reaches the confidence, 0 to 1; NULL where none was '
    'seen';
COMMENT ON COLUMN ab_summary_row.refuted IS
    'Share of the seen samples at which belief in "not built here" reaches it, 0 to 1; NULL where none was seen';
COMMENT ON COLUMN ab_summary_row.open IS
    'Share of the seen samples that are neither, 0 to 1; with confirmed and refuted 1; NULL where none was seen';
COMMENT ON COLUMN ab_summary_row.conflict IS
    'Mean conflict between stations over the seen samples, 0 to 1; NULL where none was seen';
COMMENT ON COLUMN ab_summary_row.deviation IS
    'Median deviation of the face meant along its outward normal, metres, + in front of it (outside): of the largest '
    'face that is certainly off, else of the largest; NULL where no face is seen';
COMMENT ON COLUMN ab_summary_row.deviation_sd IS 'Standard deviation of deviation, metres';
COMMENT ON COLUMN ab_summary_row.shift IS
    'Rigid offset of the built object from the drawn one: three elements along the world''s x, y, z, metres, + along '
    'the axis; an element is NULL where the seen faces do not determine that axis to 6 degrees; NULL where none is';
COMMENT ON COLUMN ab_summary_row.shift_sd IS 'Standard deviation of each element of shift, metres; NULL where that is';
COMMENT ON COLUMN ab_summary_row.deviation_normal IS
    'Outward unit normal of the face that deviation is of, along the axes of the world; NULL where that is';
COMMENT ON COLUMN ab_summary_row.deviation_face IS
    'Number of that face, in the order of ab_faces, from 1; the same in every epoch in which it is well seen';
COMMENT ON COLUMN ab_summary_row.reason IS
    'Why it is unobserved, by the largest share: hidden_by_object, hidden_by_other, too_few, too_steep, not_looked_at, '
    'no_return or shared_face; NULL for other verdicts, and where only ab_evidence_agg looked';
COMMENT ON COLUMN ab_summary_row.reason_shares IS
    'Share of the samples for each reason: hidden by another drawn object, hidden by what nobody drew, too few beams, '
    'beams too steep, not looked at, nothing returned, on a face that another object shares; each 0 to 1, in sum 1; NULL '
    'where reason is';
COMMENT ON COLUMN ab_summary_row.hidden_by IS
    'Always NULL: evidence does not know the names of others; see ab_verify_table';
CREATE FUNCTION ab_summary(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS ab_summary_row
    AS 'MODULE_PATHNAME', 'ab_evidence_summary' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION ab_summary(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'Verdict with the numbers that led to it: coverage is seen/all samples; confirmed, refuted and open are shares '
    'of the seen ones; deviation is the median of the face meant along its outward normal, metres; shift '
    'is the rigid offset along the directions that the seen faces determine';
CREATE FUNCTION ab_verdict(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_verdict' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION ab_verdict(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'confirmed, deviating, absent, unobserved or conflicting; at another level of accuracy or confidence than the '
    'evidence was made for, if asked';
CREATE TYPE ab_shift_row AS (shift float8[], shift_sd float8[]);
COMMENT ON TYPE ab_shift_row IS 'A rigid offset';
COMMENT ON COLUMN ab_shift_row.shift IS
    'Rigid offset of the built object from the drawn one: three elements along the world''s x, y, z, metres, + along '
    'the axis; an element is NULL where the seen faces do not determine that axis to 6 degrees; NULL where none is';
COMMENT ON COLUMN ab_shift_row.shift_sd IS 'Standard deviation of each element of shift, metres; NULL where that is';
CREATE FUNCTION ab_shift(evidence ab_evidence) RETURNS ab_shift_row
    AS 'MODULE_PATHNAME', 'ab_evidence_shift' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION ab_shift(ab_evidence) IS
    'Rigid offset of the built object against the drawn one, metres; NULL along axes that the seen faces do not '
    'determine';
CREATE TYPE ab_sample_row AS (
    "position" float8[], normal float8[], mass ab_mass, deviation float8, deviation_sd float8, beams integer);
COMMENT ON TYPE ab_sample_row IS 'A sample on the surface of a solid, and what is believed there';
COMMENT ON COLUMN ab_sample_row."position" IS 'Where it is drawn: x, y, z, world metres';
COMMENT ON COLUMN ab_sample_row.normal IS 'Outward unit normal of its face along the axes of the world';
COMMENT ON COLUMN ab_sample_row.mass IS 'Belief that the object is built here (occupied) or is not (empty)';
COMMENT ON COLUMN ab_sample_row.deviation IS
    'Distance of the built surface along the normal, metres, + in front of the face (outside); NULL where no surface '
    'was met';
COMMENT ON COLUMN ab_sample_row.deviation_sd IS 'Standard deviation of deviation, metres';
COMMENT ON COLUMN ab_sample_row.beams IS 'Number of beams that say something of it';
CREATE FUNCTION ab_samples(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL) RETURNS SETOF ab_sample_row
    AS 'MODULE_PATHNAME', 'ab_samples' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 10000;
COMMENT ON FUNCTION ab_samples(ab_evidence, ab_loa, float8) IS
    'Every sample with its belief and its signed deviation (+ in front of the face); for heat maps';
CREATE TYPE ab_face_row AS (
    normal float8[], samples bigint, seen bigint, confirmed bigint, refuted bigint, open bigint, pierced bigint,
    deviation float8, deviation_sd float8);
COMMENT ON TYPE ab_face_row IS 'A face of a solid, and its share in the verdict';
COMMENT ON COLUMN ab_face_row.normal IS 'Outward unit normal along the axes of the world';
COMMENT ON COLUMN ab_face_row.samples IS 'Number of its samples';
COMMENT ON COLUMN ab_face_row.seen IS
    'Of these: of which enough beams say something; confirmed, refuted and open add up to them';
COMMENT ON COLUMN ab_face_row.confirmed IS 'Seen samples at which belief in "built here" reaches the confidence';
COMMENT ON COLUMN ab_face_row.refuted IS
    'Seen samples at which belief in "not built here" reaches it, or that share the displacement of the face';
COMMENT ON COLUMN ab_face_row.open IS 'Seen samples that are neither';
COMMENT ON COLUMN ab_face_row.pierced IS 'Of the refuted: through which beams passed';
COMMENT ON COLUMN ab_face_row.deviation IS
    'Median deviation along the normal, metres, + in front of the face (outside); NULL where no surface was met';
COMMENT ON COLUMN ab_face_row.deviation_sd IS 'Standard deviation of deviation, metres';
CREATE FUNCTION ab_faces(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL) RETURNS SETOF ab_face_row
    AS 'MODULE_PATHNAME', 'ab_faces' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 20;
COMMENT ON FUNCTION ab_faces(ab_evidence, ab_loa, float8) IS 'Every face of the solid with its share in the verdict';
CREATE FUNCTION ab_model(evidence ab_evidence) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_model_of_evidence' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_model(ab_evidence) IS 'The parameters that the evidence was made with';
CREATE FUNCTION _ab_evidence_accum(
    state internal, solid ab_solid, patch ab_scan, model ab_evidence_model) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_model_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_evidence_accum(internal, ab_solid, ab_scan, ab_evidence_model) IS
    'Transition of ab_evidence_agg';
CREATE OR REPLACE FUNCTION _ab_rollup_accum(state internal, evidence ab_evidence) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_rollup_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 500000;
CREATE OR REPLACE FUNCTION _ab_evidence_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
CREATE OR REPLACE FUNCTION _ab_evidence_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_evidence_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
CREATE OR REPLACE FUNCTION _ab_evidence_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
CREATE OR REPLACE FUNCTION _ab_evidence_final(state internal) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
CREATE AGGREGATE ab_evidence_agg(solid ab_solid, patch ab_scan, model ab_evidence_model) (
    SFUNC = _ab_evidence_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_evidence_combine,
    SERIALFUNC = _ab_evidence_serial, DESERIALFUNC = _ab_evidence_deserial, FINALFUNC = _ab_evidence_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_evidence_agg(ab_solid, ab_scan, ab_evidence_model) IS
    'What the beams of all patches say about one solid. A NULL patch adds nothing but keeps the object: it comes out '
    'as unobserved';
CREATE TYPE ab_verdict_row AS (
    id bigint, evidence ab_evidence, verdict text, best_loa ab_loa, samples bigint, coverage float8, confirmed float8,
    refuted float8, open float8, conflict float8, deviation float8, deviation_sd float8, shift float8[],
    shift_sd float8[], deviation_normal float8[], deviation_face integer, reason text, reason_shares float8[],
    hidden_by text, drawn_twice text);
COMMENT ON TYPE ab_verdict_row IS
    'An object that was verified: its evidence, its verdict and the numbers that led to it';
COMMENT ON COLUMN ab_verdict_row.id IS 'The object''s id, from the query of objects';
COMMENT ON COLUMN ab_verdict_row.evidence IS
    'What the beams say of it; NULL where it is not kept, or the object has no solid';
COMMENT ON COLUMN ab_verdict_row.verdict IS
    'confirmed, deviating, absent, unobserved or conflicting, at the level of accuracy that was asked; NULL without '
    'a solid';
COMMENT ON COLUMN ab_verdict_row.best_loa IS
    'Finest level of accuracy that 95 % of every well-seen surface keeps, proven at the confidence; NULL for none';
COMMENT ON COLUMN ab_verdict_row.samples IS
    'Number of samples on the surface of the solid, of leaves and panes those that were seen; NULL without a solid';
COMMENT ON COLUMN ab_verdict_row.coverage IS 'Share of the samples that were seen, 0 to 1; NULL without a solid';
COMMENT ON COLUMN ab_verdict_row.confirmed IS
    'Share of the seen samples at which belief in "built here" reaches the confidence, 0 to 1; NULL where none was '
    'seen';
COMMENT ON COLUMN ab_verdict_row.refuted IS
    'Share of the seen samples at which belief in "not built here" reaches it, 0 to 1; NULL where none was seen';
COMMENT ON COLUMN ab_verdict_row.open IS
    'Share of the seen samples that are neither, 0 to 1; with confirmed and refuted 1; NULL where none was seen';
COMMENT ON COLUMN ab_verdict_row.conflict IS
    'Mean conflict between stations over the seen samples, 0 to 1; NULL where none was seen';
COMMENT ON COLUMN ab_verdict_row.deviation IS
    'Median deviation of the face meant along its outward normal, metres, + in front of it (outside): of the largest '
    'face that is certainly off, else of the largest; NULL where no face is seen';
COMMENT ON COLUMN ab_verdict_row.deviation_sd IS 'Standard deviation of deviation, metres';
COMMENT ON COLUMN ab_verdict_row.shift IS
    'Rigid offset of the built object from the drawn one: three elements along the world''s x, y, z, metres, + along '
    'the axis; an element is NULL where the seen faces do not determine that axis to 6 degrees; NULL where none is';
COMMENT ON COLUMN ab_verdict_row.shift_sd IS 'Standard deviation of each element of shift, metres; NULL where that is';
COMMENT ON COLUMN ab_verdict_row.deviation_normal IS
    'Outward unit normal of the face that deviation is of, along the axes of the world; NULL where that is';
COMMENT ON COLUMN ab_verdict_row.deviation_face IS
    'Number of that face, in the order of ab_faces, from 1; the same in every epoch in which it is well seen';
COMMENT ON COLUMN ab_verdict_row.reason IS
    'Why it is unobserved, by the largest share: hidden_by_object, hidden_by_other, too_few, too_steep, not_looked_at, '
    'no_return or shared_face; NULL for other verdicts, and where only ab_evidence_agg looked';
COMMENT ON COLUMN ab_verdict_row.reason_shares IS
    'Share of the samples for each reason: hidden by another drawn object, hidden by what nobody drew, too few beams, '
    'beams too steep, not looked at, nothing returned, on a face that another object shares; each 0 to 1, in sum 1; NULL '
    'where reason is';
COMMENT ON COLUMN ab_verdict_row.hidden_by IS
    'Id of the object that hides most of what drawn objects hide of an unobserved one; NULL where none does';
COMMENT ON COLUMN ab_verdict_row.drawn_twice IS
    'Id of another object that is drawn at the same place, 95 % of the surface of each within 10 mm of the other: the '
    'same body in two models, judged as one; NULL where none is';
CREATE FUNCTION ab_verify_table(
    objects text, scans text, model ab_evidence_model DEFAULT NULL, keep_evidence boolean DEFAULT true,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL,
    max_conflict float8 DEFAULT NULL) RETURNS SETOF ab_verdict_row
    AS 'MODULE_PATHNAME', 'ab_verify_table' LANGUAGE c STABLE PARALLEL RESTRICTED COST 100000000 ROWS 1000;
COMMENT ON FUNCTION ab_verify_table(text, text, ab_evidence_model, boolean, float8, float8, float8) IS
    'Evidence and verdict of every object of one query (id, solid, perhaps its own ab_evidence_model) from the '
    'patches of another; every patch is unpacked once for all objects. Uses as many threads as a parallel plan would '
    'have processes (max_parallel_workers_per_gather + 1)';
CREATE TYPE ab_change_class AS ENUM ('unchanged', 'appeared', 'gone', 'moved', 'partly', 'not_comparable');
COMMENT ON TYPE ab_change_class IS
    'What became of an object between two epochs: it stands as before (or in neither of them), it appeared, it is '
    'gone, it stands elsewhere than before, part of it appeared or is gone, or too little of it was seen in both';

-- What became of objects.
CREATE TYPE ab_object_change_row AS (
    id bigint, change ab_change_class, seen_in_both float8, shift float8[], shift_sd float8[], shift_chance float8,
    samples bigint, in_both float8, only_in_old float8, only_in_new float8, in_neither float8);
COMMENT ON TYPE ab_object_change_row IS 'What became of an object between two epochs, and the numbers that say so';
COMMENT ON COLUMN ab_object_change_row.id IS 'The object''s id, from the query of objects';
COMMENT ON COLUMN ab_object_change_row.change IS 'What became of it; NULL without a solid';
COMMENT ON COLUMN ab_object_change_row.seen_in_both IS
    'Share of the samples on its surface that both epochs saw, 0 to 1; NULL without a solid';
COMMENT ON COLUMN ab_object_change_row.shift IS
    'Offset of the object in the new epoch against the old one: three elements along the world''s x, y, z, metres, + '
    'along the axis; an element is NULL where the faces that both epochs saw do not determine that axis to 6 degrees; '
    'NULL where none does, and where the object appeared, is gone or is not comparable';
COMMENT ON COLUMN ab_object_change_row.shift_sd IS
    'Standard deviation of each element of shift, the registrations of both epochs included, metres; NULL where that '
    'is';
COMMENT ON COLUMN ab_object_change_row.shift_chance IS
    'Probability of so long a shift by chance if the object did not move, 0 to 1; NULL where shift is';
COMMENT ON COLUMN ab_object_change_row.samples IS 'Number of samples on the surface of the solid; NULL without a solid';
COMMENT ON COLUMN ab_object_change_row.in_both IS
    'Share of the samples that both epochs saw that show the object in both, 0 to 1; NULL where there are none. With '
    'the next three less than 1: what hides it, or is not sure, says nothing';
COMMENT ON COLUMN ab_object_change_row.only_in_old IS
    'Share of them that show it in the old epoch, and its place empty in the new one, 0 to 1; NULL where there are '
    'none';
COMMENT ON COLUMN ab_object_change_row.only_in_new IS
    'Share of them that show its place empty in the old epoch, and it in the new one, 0 to 1; NULL where there are '
    'none';
COMMENT ON COLUMN ab_object_change_row.in_neither IS
    'Share of them that show its place empty in both, 0 to 1; NULL where there are none';

CREATE FUNCTION ab_change_table(
    objects text, old_scans text, new_scans text, model ab_evidence_model DEFAULT NULL,
    new_model ab_evidence_model DEFAULT NULL) RETURNS SETOF ab_object_change_row
    AS 'MODULE_PATHNAME', 'ab_change_table' LANGUAGE c STABLE PARALLEL RESTRICTED COST 200000000 ROWS 1000;
COMMENT ON FUNCTION ab_change_table(text, text, text, ab_evidence_model, ab_evidence_model) IS
    'What became of every object of one query (id, solid, perhaps its own ab_evidence_model) between the patches of a '
    'second and of a third one, where it is drawn; objects know each other as in ab_verify_table. new_model: how the '
    'new epoch was surveyed (standard deviations, incidence, beams without return), for all objects; NULL for as the '
    'old one. Threads as in ab_verify_table';

CREATE TYPE ab_station_row AS (station bigint, origin float8[], seen bigint, added bigint);
COMMENT ON TYPE ab_station_row IS 'What a station contributed to evidence';
COMMENT ON COLUMN ab_station_row.station IS 'Number of the station';
COMMENT ON COLUMN ab_station_row.origin IS
    'Where its beams start: x, y, z, world metres; NULL for moving platforms and points without origin';
COMMENT ON COLUMN ab_station_row.seen IS 'Number of samples that it sees by itself';
COMMENT ON COLUMN ab_station_row.added IS 'Number of samples that would be unseen without it';
CREATE FUNCTION ab_stations(evidence ab_evidence) RETURNS SETOF ab_station_row
    AS 'MODULE_PATHNAME', 'ab_stations' LANGUAGE c STABLE PARALLEL SAFE COST 10000000 ROWS 5;
COMMENT ON FUNCTION ab_stations(ab_evidence) IS
    'What each station contributed: the samples that it sees by itself, and those that would be unseen without it; '
    'origin NULL for moving platforms and points without origin';
CREATE FUNCTION ab_explain(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_explain' LANGUAGE c STABLE PARALLEL SAFE COST 10000000;
COMMENT ON FUNCTION ab_explain(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'Why the verdict is what it is: what was seen, what that says, which threshold decided, why no finer level of '
    'accuracy holds';
CREATE TYPE ab_sensor_row AS (
    name text, sigma_range float8, sigma_angle float8, sigma_station float8, max_range float8, description text);
COMMENT ON TYPE ab_sensor_row IS 'Standard uncertainties of a kind of scanner';
COMMENT ON COLUMN ab_sensor_row.name IS 'The name that ab_with_sensor takes';
COMMENT ON COLUMN ab_sensor_row.sigma_range IS 'Standard deviation of a range, metres';
COMMENT ON COLUMN ab_sensor_row.sigma_angle IS 'Standard deviation of an angle, radians';
COMMENT ON COLUMN ab_sensor_row.sigma_station IS
    'Standard deviation of a station''s registration along an axis, metres';
COMMENT ON COLUMN ab_sensor_row.max_range IS 'Farthest that it measures, metres';
COMMENT ON COLUMN ab_sensor_row.description IS 'What kind of scanner it is';
CREATE FUNCTION ab_sensor(sensor text DEFAULT NULL) RETURNS SETOF ab_sensor_row
    AS 'MODULE_PATHNAME', 'ab_sensor' LANGUAGE c IMMUTABLE PARALLEL SAFE ROWS 6;
COMMENT ON FUNCTION ab_sensor(text) IS
    'Standard uncertainties of a kind of scanner, of the order that field tests by ISO 17123-9 find: phase, hybrid, '
    'pulse, compact, handheld or tablet; all without a name. Metres and radians';
CREATE FUNCTION ab_with_sensor(model ab_evidence_model, sensor text) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_with_sensor' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_with_sensor(ab_evidence_model, text) IS
    'The same parameters with a sensor''s standard uncertainties: sigma_range, sigma_angle and sigma_station of '
    'ab_sensor';
CREATE FUNCTION ab_with_intensity(
    model ab_evidence_model, reference integer, exponent float8 DEFAULT 1) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_with_intensity' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_with_intensity(ab_evidence_model, integer, float8) IS
    'The same parameters with range noise by intensity: sigma_range holds from the reference on (the sensor''s own '
    'unit), below it the variance grows by (reference/intensity)^exponent. For patches with intensities; exponent 1 '
    'is shot noise';
CREATE FUNCTION _ab_evidence_accum(
    state internal, solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_model_accum_point' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 2000;
COMMENT ON FUNCTION _ab_evidence_accum(internal, ab_solid, ab_point, float8[], ab_evidence_model) IS
    'Transition of ab_evidence_agg over tie points';
CREATE AGGREGATE ab_evidence_agg(solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model) (
    SFUNC = _ab_evidence_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_evidence_combine,
    SERIALFUNC = _ab_evidence_serial, DESERIALFUNC = _ab_evidence_deserial, FINALFUNC = _ab_evidence_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_evidence_agg(ab_solid, ab_point, float8[], ab_evidence_model) IS
    'What tie points say about one solid: a surface at each point, once, with the point''s own covariance, and empty '
    'space along the rays from its cameras (n x 3, metres). Choose spacing near the distance of the points; join '
    'the objects that the rays may have pierced too, not only those near the points. The model meyer2022 takes every '
    'ray as a source of its own, without covariance. A NULL point keeps the object';

-- 06-voxel
CREATE FUNCTION ab_grid(
    voxel float8 DEFAULT 0.01, tile ab_box DEFAULT NULL, margin float8 DEFAULT 0.01, no_return_range float8 DEFAULT 0,
    exact boolean DEFAULT false) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_grid_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_grid(float8, ab_box, float8, float8, boolean) IS
    'Voxels of an edge (metres) on the lattice of the reference system, those of a tile or all; a beam says empty up '
    'to the margin before its return (for noise and registration), without return up to no_return_range; exact: '
    'only voxels that a beam itself passes are empty, not those between neighbouring beams of a patch';
CREATE FUNCTION ab_grid(occupancy ab_occupancy) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_occupancy_grid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_grid(ab_occupancy) IS 'Lattice, tile and rules of an occupancy';
CREATE FUNCTION ab_grid(change ab_change) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_change_grid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_grid(ab_change) IS 'Lattice and tile of a change';
CREATE FUNCTION ab_tiles(area ab_box, size float8) RETURNS SETOF ab_box
    AS 'MODULE_PATHNAME', 'ab_tiles' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 100;
COMMENT ON FUNCTION ab_tiles(ab_box, float8) IS
    'The boxes of a lattice of tiles (edge in metres) that meet an area: neighbours share no voxel where the edge is '
    'a multiple of the voxel';
CREATE FUNCTION ab_box(occupancy ab_occupancy) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box(ab_occupancy) IS 'Box of the blocks of voxels of which something is known; NULL for none';
CREATE FUNCTION ab_box(change ab_change) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box(ab_change) IS 'Box of the blocks of voxels that have a class; NULL for none';
CREATE FUNCTION _ab_occupancy_accum(state internal, patch ab_scan, grid ab_grid) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 2000000;
COMMENT ON FUNCTION _ab_occupancy_accum(internal, ab_scan, ab_grid) IS 'Transition of ab_occupancy_agg';
CREATE FUNCTION _ab_occupancy_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_occupancy_combine(internal, internal) IS 'Combine of ab_occupancy_agg';
CREATE FUNCTION _ab_occupancy_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_occupancy_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_occupancy_serial(internal) IS 'Serialisation of ab_occupancy_agg';
CREATE FUNCTION _ab_occupancy_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_occupancy_deserial(bytea, internal) IS 'Deserialisation of ab_occupancy_agg';
CREATE FUNCTION _ab_occupancy_final(state internal) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_occupancy_final(internal) IS 'Final of ab_occupancy_agg';
CREATE AGGREGATE ab_occupancy_agg(patch ab_scan, grid ab_grid) (
    SFUNC = _ab_occupancy_accum, STYPE = internal, SSPACE = 50000000, COMBINEFUNC = _ab_occupancy_combine,
    SERIALFUNC = _ab_occupancy_serial, DESERIALFUNC = _ab_occupancy_deserial, FINALFUNC = _ab_occupancy_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_occupancy_agg(ab_scan, ab_grid) IS
    'Occupancy of the tile of a grid from patches, whatever their order; one grid a group. A NULL patch adds '
    'nothing. At most asbuilt.max_grid_memory at a time in every process';
CREATE FUNCTION _ab_occupancy_rollup_accum(state internal, occupancy ab_occupancy) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_rollup_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION _ab_occupancy_rollup_accum(internal, ab_occupancy) IS 'Transition of ab_rollup_agg';
CREATE AGGREGATE ab_rollup_agg(occupancy ab_occupancy) (
    SFUNC = _ab_occupancy_rollup_accum, STYPE = internal, SSPACE = 50000000, COMBINEFUNC = _ab_occupancy_combine,
    SERIALFUNC = _ab_occupancy_serial, DESERIALFUNC = _ab_occupancy_deserial, FINALFUNC = _ab_occupancy_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_rollup_agg(ab_occupancy) IS
    'Adds up occupancy of one lattice: stations of an epoch, neighbouring tiles, solids of a model';
CREATE FUNCTION ab_rollup(o1 ab_occupancy, o2 ab_occupancy) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 400000;
COMMENT ON FUNCTION ab_rollup(ab_occupancy, ab_occupancy) IS
    'Adds up two occupancies of one lattice: as if all patches had been aggregated at once; NULL counts as nothing';
CREATE FUNCTION ab_union(o1 ab_occupancy, o2 ab_occupancy) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 400000;
COMMENT ON FUNCTION ab_union(ab_occupancy, ab_occupancy) IS 'The same as ab_rollup';
CREATE FUNCTION ab_occupancy(grid ab_grid, model boolean DEFAULT false) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_empty' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION ab_occupancy(ab_grid, boolean) IS
    'An occupancy of which nothing is known: what ab_occupancy_agg of no rows would be, were it not NULL; or a model '
    'that fills nothing';
CREATE FUNCTION ab_clip(occupancy ab_occupancy, tile ab_box) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_clip' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_clip(ab_occupancy, ab_box) IS 'The voxels of an occupancy whose centres lie in a box';
CREATE FUNCTION ab_state(occupancy ab_occupancy, x float8, y float8, z float8, threshold integer DEFAULT 3) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_occupancy_state' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_state(ab_occupancy, float8, float8, float8, integer) IS
    'State of the voxel that holds a point: occupied (as many returns as the threshold), ambiguous (the same, but '
    'beams passed too), empty, unknown';
CREATE TYPE ab_voxel_row AS (x float8, y float8, z float8, state text, hits integer);
COMMENT ON TYPE ab_voxel_row IS 'A voxel of an occupancy';
COMMENT ON COLUMN ab_voxel_row.x IS 'Centre, world metres';
COMMENT ON COLUMN ab_voxel_row.y IS 'Centre, world metres';
COMMENT ON COLUMN ab_voxel_row.z IS 'Centre, world metres';
COMMENT ON COLUMN ab_voxel_row.state IS 'occupied, ambiguous or empty';
COMMENT ON COLUMN ab_voxel_row.hits IS 'Number of returns in it, 255 for more';
CREATE FUNCTION ab_voxels(
    occupancy ab_occupancy, states text[] DEFAULT '{occupied,ambiguous}',
    threshold integer DEFAULT 3) RETURNS SETOF ab_voxel_row
    AS 'MODULE_PATHNAME', 'ab_occupancy_voxels' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 500000 ROWS 100000;
COMMENT ON FUNCTION ab_voxels(ab_occupancy, text[], integer) IS
    'Centres of the voxels of some states, with the returns in each (255 for more)';
CREATE FUNCTION ab_slice(occupancy ab_occupancy, axis text, at float8, threshold integer DEFAULT 3) RETURNS integer[]
    AS 'MODULE_PATHNAME', 'ab_occupancy_slice' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_slice(ab_occupancy, text, float8, integer) IS
    'The layer of voxels at a coordinate on an axis (x, y or z) as a picture: 0 unknown, 1 empty, 2 occupied, 3 '
    'ambiguous; rows along the later of the other axes, as far as anything is known';
CREATE TYPE ab_occupancy_summary_row AS (
    occupied bigint, ambiguous bigint, empty bigint, unknown bigint, occupied_m3 float8, ambiguous_m3 float8,
    empty_m3 float8, unknown_m3 float8);
COMMENT ON TYPE ab_occupancy_summary_row IS 'Voxels of an occupancy by state';
COMMENT ON COLUMN ab_occupancy_summary_row.occupied IS 'Number of occupied voxels';
COMMENT ON COLUMN ab_occupancy_summary_row.ambiguous IS 'Number of ambiguous voxels';
COMMENT ON COLUMN ab_occupancy_summary_row.empty IS 'Number of empty voxels';
COMMENT ON COLUMN ab_occupancy_summary_row.unknown IS
    'Number of unknown voxels; NULL where neither tile nor solid says of how many';
COMMENT ON COLUMN ab_occupancy_summary_row.occupied_m3 IS 'Volume of the occupied voxels, cubic metres';
COMMENT ON COLUMN ab_occupancy_summary_row.ambiguous_m3 IS 'Volume of the ambiguous voxels, cubic metres';
COMMENT ON COLUMN ab_occupancy_summary_row.empty_m3 IS 'Volume of the empty voxels, cubic metres';
COMMENT ON COLUMN ab_occupancy_summary_row.unknown_m3 IS
    'Volume of the unknown voxels, cubic metres; NULL where unknown is';
CREATE FUNCTION ab_summary(
    occupancy ab_occupancy, threshold integer DEFAULT 3, solid ab_solid DEFAULT NULL) RETURNS ab_occupancy_summary_row
    AS 'MODULE_PATHNAME', 'ab_occupancy_summary' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_summary(ab_occupancy, integer, ab_solid) IS
    'Voxels and cubic metres of each state, overall or of the voxels that a solid touches; unknown is NULL where '
    'neither tile nor solid says of how many';
CREATE FUNCTION ab_denoise(
    occupancy ab_occupancy, neighbours integer DEFAULT 1, threshold integer DEFAULT 1) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_denoise' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_denoise(ab_occupancy, integer, integer) IS
    'Without the returns of voxels that have fewer occupied neighbours than that, of the 26 around';
CREATE FUNCTION ab_downsample(occupancy ab_occupancy) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_downsample' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_downsample(ab_occupancy) IS
    'Voxels twice as large: returns added up, passed where one of the eight was passed';
CREATE FUNCTION ab_voxelize(
    solid ab_solid, voxel float8, rule text DEFAULT 'centre', tile ab_box DEFAULT NULL) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_voxelize' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_voxelize(ab_solid, float8, text, ab_box) IS
    'A solid as occupancy of which everything is known: the voxels whose centre lies inside (centre), that it '
    'touches (cover), or that its surface passes through (surface; the one rule for open surfaces); those of a tile '
    'or all';
CREATE TYPE ab_voxel_accuracy_row AS (max_error float8, absolute ab_loa, relative ab_loa, relative_linear ab_loa);
COMMENT ON TYPE ab_voxel_accuracy_row IS 'What voxels of an edge support';
COMMENT ON COLUMN ab_voxel_accuracy_row.max_error IS
    'Greatest distance of a point in a voxel from its centre, half the diagonal, metres';
COMMENT ON COLUMN ab_voxel_accuracy_row.absolute IS 'Finest level of accuracy that places keep; NULL for none';
COMMENT ON COLUMN ab_voxel_accuracy_row.relative IS
    'Finest level that distances keep, errors added as squares; NULL for none';
COMMENT ON COLUMN ab_voxel_accuracy_row.relative_linear IS
    'Finest level that distances keep, errors added linearly; NULL for none';
CREATE FUNCTION ab_voxel_accuracy(voxel float8) RETURNS ab_voxel_accuracy_row
    AS 'MODULE_PATHNAME', 'ab_voxel_accuracy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10;
COMMENT ON FUNCTION ab_voxel_accuracy(float8) IS
    'What voxels of an edge support: greatest error of a centre, half the diagonal (Meyer 4.1), and the finest '
    'levels of accuracy that hold it, for places and for distances (errors added as squares or linearly, 4.4 and '
    '4.5)';
CREATE FUNCTION ab_change(
    old ab_occupancy, new ab_occupancy, threshold integer DEFAULT 3, tolerance float8 DEFAULT NULL) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_between' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_change(ab_occupancy, ab_occupancy, integer, float8) IS
    'Voxels that are occupied in one of two epochs: confirmed, new, disappeared, unknown, ambiguous. A change counts '
    'only if the other epoch has nothing occupied within the tolerance (metres; NULL: the margin of the grids; 0: '
    'voxel by voxel). A model as old side: new means unmodelled, disappeared absent';
CREATE TYPE ab_change_summary_row AS (
    confirmed bigint, new bigint, disappeared bigint, unknown bigint, ambiguous bigint, total bigint,
    confirmed_m3 float8, new_m3 float8, disappeared_m3 float8, unknown_m3 float8, ambiguous_m3 float8, total_m3 float8,
    confirmed_share float8, new_share float8, disappeared_share float8, unknown_share float8, ambiguous_share float8);
COMMENT ON TYPE ab_change_summary_row IS 'Voxels of a change by class';
COMMENT ON COLUMN ab_change_summary_row.confirmed IS 'Number of confirmed voxels';
COMMENT ON COLUMN ab_change_summary_row.new IS 'Number of new voxels';
COMMENT ON COLUMN ab_change_summary_row.disappeared IS 'Number of disappeared voxels';
COMMENT ON COLUMN ab_change_summary_row.unknown IS 'Number of unknown voxels';
COMMENT ON COLUMN ab_change_summary_row.ambiguous IS 'Number of ambiguous voxels';
COMMENT ON COLUMN ab_change_summary_row.total IS 'Number of voxels that are occupied in one of the epochs';
COMMENT ON COLUMN ab_change_summary_row.confirmed_m3 IS 'Volume of the confirmed voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.new_m3 IS 'Volume of the new voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.disappeared_m3 IS 'Volume of the disappeared voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.unknown_m3 IS 'Volume of the unknown voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.ambiguous_m3 IS 'Volume of the ambiguous voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.total_m3 IS 'Volume of all of them, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.confirmed_share IS
    'Share of the confirmed voxels in all of them, 0 to 1; NULL for none';
COMMENT ON COLUMN ab_change_summary_row.new_share IS 'Share of the new voxels in all of them, 0 to 1; NULL for none';
COMMENT ON COLUMN ab_change_summary_row.disappeared_share IS
    'Share of the disappeared voxels in all of them, 0 to 1; NULL for none';
COMMENT ON COLUMN ab_change_summary_row.unknown_share IS
    'Share of the unknown voxels in all of them, 0 to 1; NULL for none';
COMMENT ON COLUMN ab_change_summary_row.ambiguous_share IS
    'Share of the ambiguous voxels in all of them, 0 to 1; NULL for none';
CREATE FUNCTION ab_summary(
    change ab_change, solid ab_solid DEFAULT NULL, margin float8 DEFAULT NULL) RETURNS ab_change_summary_row
    AS 'MODULE_PATHNAME', 'ab_change_summary' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_summary(ab_change, ab_solid, float8) IS
    'Voxels, cubic metres and shares of each class (total: occupied in one of the epochs), overall or of the voxels '
    'that a solid touches or that lie within the margin of those (metres; NULL: the tolerance of the change); shares '
    'are NULL for none';
CREATE TYPE ab_changed_voxel_row AS (x float8, y float8, z float8, class text);
COMMENT ON TYPE ab_changed_voxel_row IS 'A voxel of a change';
COMMENT ON COLUMN ab_changed_voxel_row.x IS 'Centre, world metres';
COMMENT ON COLUMN ab_changed_voxel_row.y IS 'Centre, world metres';
COMMENT ON COLUMN ab_changed_voxel_row.z IS 'Centre, world metres';
COMMENT ON COLUMN ab_changed_voxel_row.class IS
    'confirmed, new, disappeared, unknown or ambiguous; against a model unmodelled for new, absent for disappeared';
CREATE FUNCTION ab_voxels(change ab_change, classes text[] DEFAULT NULL) RETURNS SETOF ab_changed_voxel_row
    AS 'MODULE_PATHNAME', 'ab_change_voxels' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000 ROWS 100000;
COMMENT ON FUNCTION ab_voxels(ab_change, text[]) IS 'Centres of the voxels of some classes, or of all';
CREATE TYPE ab_component_row AS (class text, voxels bigint, volume float8, box ab_box, centroid float8[]);
COMMENT ON TYPE ab_component_row IS 'Voxels of a change that hang together';
COMMENT ON COLUMN ab_component_row.class IS
    'Their class: new or disappeared, or the one that was asked for; against a model unmodelled, absent';
COMMENT ON COLUMN ab_component_row.voxels IS 'How many they are';
COMMENT ON COLUMN ab_component_row.volume IS 'Their volume, cubic metres';
COMMENT ON COLUMN ab_component_row.box IS 'Box around them, world metres';
COMMENT ON COLUMN ab_component_row.centroid IS 'Mean of their centres: x, y, z, world metres';
CREATE FUNCTION ab_components(
    change ab_change, of_class text DEFAULT NULL, min_voxels integer DEFAULT 10,
    gap float8 DEFAULT NULL) RETURNS SETOF ab_component_row
    AS 'MODULE_PATHNAME', 'ab_change_components' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 500000 ROWS 20;
COMMENT ON FUNCTION ab_components(ab_change, text, integer, float8) IS
    'What is new or has disappeared (or is of the class named) as connected things of at least min_voxels, largest '
    'first; voxels hang together when the gap between them is less than that (metres; NULL: four voxels)';
CREATE FUNCTION ab_clip(change ab_change, tile ab_box) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_clip' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_clip(ab_change, ab_box) IS
    'The voxels of a change whose centres lie in a box: aggregate tiles a little larger than wanted, so that the '
    'tolerance sees across their borders, and clip their change';
CREATE FUNCTION ab_rollup(c1 ab_change, c2 ab_change) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_rollup(ab_change, ab_change) IS 'Changes of two tiles as one; NULL counts as nothing';
CREATE AGGREGATE ab_rollup_agg(change ab_change) (
    SFUNC = ab_rollup, STYPE = ab_change, COMBINEFUNC = ab_rollup, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_rollup_agg(ab_change) IS
    'Changes of tiles as one, so that ab_components sees what crosses their borders';

-- 10-operators
CREATE OR REPLACE FUNCTION _ab_overlaps(a ab_box, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION _ab_overlaps(a ab_solid, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION _ab_overlaps(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION _ab_overlaps(a ab_scan, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION _ab_overlaps(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE FUNCTION _ab_overlaps(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_occupancy, ab_box) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE FUNCTION _ab_overlaps(a ab_box, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_box, ab_occupancy) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE FUNCTION _ab_overlaps(a ab_occupancy, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_occupancy, ab_solid) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE FUNCTION _ab_overlaps(a ab_solid, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_solid, ab_occupancy) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_occupancy, ab_box) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_box, ab_occupancy) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_occupancy, RIGHTARG = ab_solid, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_occupancy, ab_solid) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_occupancy, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_solid, ab_occupancy) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE FUNCTION _ab_overlaps(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_change, ab_box) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE FUNCTION _ab_overlaps(a ab_box, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_box, ab_change) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE FUNCTION _ab_overlaps(a ab_change, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_change, ab_solid) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE FUNCTION _ab_overlaps(a ab_solid, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_solid, ab_change) IS
    'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_change, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_box, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_change, RIGHTARG = ab_solid, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_change, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_change, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_solid, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OR REPLACE FUNCTION _ab_contains(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE OR REPLACE FUNCTION _ab_contained(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
CREATE FUNCTION _ab_contains(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_contains(ab_occupancy, ab_box) IS 'Does the box of an occupancy hold a box';
CREATE FUNCTION _ab_contained(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_contained(ab_occupancy, ab_box) IS 'Does the box of an occupancy lie in a box';
CREATE FUNCTION _ab_contains(a ab_box, b ab_occupancy) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN _ab_contained(b, a);
COMMENT ON FUNCTION _ab_contains(ab_box, ab_occupancy) IS 'Does a box hold the box of an occupancy';
CREATE FUNCTION _ab_contained(a ab_box, b ab_occupancy) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN _ab_contains(b, a);
COMMENT ON FUNCTION _ab_contained(ab_box, ab_occupancy) IS 'Does a box lie in the box of an occupancy';
CREATE OPERATOR @> (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_occupancy, ab_box) IS 'Does the box of an occupancy hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_occupancy, ab_box) IS 'Does the box of an occupancy lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_box, ab_occupancy) IS 'Does a box hold the box of an occupancy';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_box, ab_occupancy) IS 'Does a box lie in the box of an occupancy';
CREATE FUNCTION _ab_contains(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_contains(ab_change, ab_box) IS 'Does the box of a change hold a box';
CREATE FUNCTION _ab_contained(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_contained(ab_change, ab_box) IS 'Does the box of a change lie in a box';
CREATE FUNCTION _ab_contains(a ab_box, b ab_change) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN _ab_contained(b, a);
COMMENT ON FUNCTION _ab_contains(ab_box, ab_change) IS 'Does a box hold the box of a change';
CREATE FUNCTION _ab_contained(a ab_box, b ab_change) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN _ab_contains(b, a);
COMMENT ON FUNCTION _ab_contained(ab_box, ab_change) IS 'Does a box lie in the box of a change';
CREATE OPERATOR @> (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_change, ab_box) IS 'Does the box of a change hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_change, ab_box) IS 'Does the box of a change lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_box, ab_change) IS 'Does a box hold the box of a change';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_box, ab_change) IS 'Does a box lie in the box of a change';
CREATE FUNCTION _ab_unequal(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_box, ab_box) IS 'Not the same numbers';
CREATE OPERATOR = (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_box, ab_box) IS 'Same numbers';
CREATE OPERATOR <> (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_box, ab_box) IS 'Not the same numbers';
CREATE FUNCTION _ab_equal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_solid, ab_solid) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_solid, ab_solid) IS 'Of operator <>';
CREATE OPERATOR = (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_solid, ab_solid) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_solid, ab_solid) IS 'Different values';
CREATE FUNCTION _ab_equal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_scan, ab_scan) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_scan, ab_scan) IS 'Of operator <>';
CREATE OPERATOR = (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_scan, ab_scan) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_scan, ab_scan) IS 'Different values';
CREATE FUNCTION _ab_equal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_evidence, ab_evidence) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_evidence, ab_evidence) IS 'Of operator <>';
CREATE OPERATOR = (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_evidence, ab_evidence) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =,
    RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_evidence, ab_evidence) IS 'Different values';
CREATE FUNCTION _ab_equal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_occupancy, ab_occupancy) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_occupancy, ab_occupancy) IS 'Of operator <>';
CREATE OPERATOR = (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>,
    RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_occupancy, ab_occupancy) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =,
    RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_occupancy, ab_occupancy) IS 'Different values';
CREATE FUNCTION _ab_equal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_change, ab_change) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_change, ab_change) IS 'Of operator <>';
CREATE OPERATOR = (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_change, ab_change) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_change, ab_change) IS 'Different values';
CREATE FUNCTION _ab_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_evidence_model, ab_evidence_model) IS 'Of operator <>';
CREATE OPERATOR = (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>,
    RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_evidence_model, ab_evidence_model) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =,
    RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_evidence_model, ab_evidence_model) IS 'Different values';
CREATE FUNCTION _ab_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_grid, ab_grid) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_grid, ab_grid) IS 'Of operator <>';
CREATE OPERATOR = (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_grid, ab_grid) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_grid, ab_grid) IS 'Different values';
ALTER OPERATOR ~= (ab_solid, ab_box) SET (RESTRICT = eqsel, JOIN = eqjoinsel);
CREATE OR REPLACE FUNCTION _ab_same(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
ALTER OPERATOR ~= (ab_scan, ab_box) SET (RESTRICT = eqsel, JOIN = eqjoinsel);
ALTER OPERATOR ~= (ab_point, ab_box) SET (RESTRICT = eqsel, JOIN = eqjoinsel);
CREATE FUNCTION _ab_same(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_same(ab_occupancy, ab_box) IS 'Is the box of an occupancy that box';
CREATE OPERATOR ~= (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_occupancy, ab_box) IS 'Is the box of an occupancy that box';
CREATE FUNCTION _ab_same(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_same(ab_change, ab_box) IS 'Is the box of a change that box';
CREATE OPERATOR ~= (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_change, ab_box) IS 'Is the box of a change that box';
CREATE OR REPLACE FUNCTION _ab_box_distance(a ab_scan, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_scan_distance_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_box_distance(ab_scan, ab_box) IS
    'Least distance of the box of a patch''s returns from a box, metres; infinite without returns';
COMMENT ON OPERATOR <-> (ab_scan, ab_box) IS
    'Least distance of the box of a patch''s returns from a box, metres; infinite without returns; for nearest first';
CREATE FUNCTION _ab_box_distance(a ab_box, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_box_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_box_distance(ab_box, ab_point) IS 'Least distance of a box from a point, metres';
CREATE OPERATOR <-> (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_box, ab_point) IS 'Least distance of a box from a point, metres; for nearest first';
CREATE FUNCTION _ab_box_distance(a ab_solid, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_solid_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_box_distance(ab_solid, ab_point) IS 'Least distance of the box of a solid from a point, metres';
CREATE OPERATOR <-> (LEFTARG = ab_solid, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_solid, ab_point) IS
    'Least distance of the box of a solid from a point, metres; for nearest first';
CREATE FUNCTION _ab_box_distance(a ab_scan, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_scan_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_box_distance(ab_scan, ab_point) IS
    'Least distance of the box of a patch''s returns from a point, metres; infinite without returns';
CREATE OPERATOR <-> (LEFTARG = ab_scan, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_scan, ab_point) IS
    'Least distance of the box of a patch''s returns from a point, metres; infinite without returns; for nearest '
    'first';
CREATE FUNCTION _ab_box_distance(a ab_point, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_box_distance(ab_point, ab_point) IS
    'Least distance of a point from a point, metres; uncertainties do not count';
CREATE OPERATOR <-> (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_point, ab_point) IS
    'Least distance of a point from a point, metres; uncertainties do not count; for nearest first';
CREATE FUNCTION _ab_box_distance(a ab_occupancy, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_box_distance(ab_occupancy, ab_box) IS
    'Least distance of the box of an occupancy from a box, metres';
CREATE FUNCTION _ab_box_distance(a ab_occupancy, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_box_distance(ab_occupancy, ab_point) IS
    'Least distance of the box of an occupancy from a point, metres';
CREATE OPERATOR <-> (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_occupancy, ab_box) IS
    'Least distance of the box of an occupancy from a box, metres; for nearest first';
CREATE OPERATOR <-> (LEFTARG = ab_occupancy, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_occupancy, ab_point) IS
    'Least distance of the box of an occupancy from a point, metres; for nearest first';
CREATE FUNCTION _ab_box_distance(a ab_change, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_box_distance(ab_change, ab_box) IS 'Least distance of the box of a change from a box, metres';
CREATE FUNCTION _ab_box_distance(a ab_change, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_box_distance(ab_change, ab_point) IS
    'Least distance of the box of a change from a point, metres';
CREATE OPERATOR <-> (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_change, ab_box) IS
    'Least distance of the box of a change from a box, metres; for nearest first';
CREATE OPERATOR <-> (LEFTARG = ab_change, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_change, ab_point) IS
    'Least distance of the box of a change from a point, metres; for nearest first';
CREATE FUNCTION _ab_less(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_box, ab_box) IS 'Before in the order of their corners';
CREATE OPERATOR < (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_box, ab_box) IS 'Before in the order of their corners';
CREATE FUNCTION _ab_less_or_equal(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_box, ab_box) IS 'Not after in the order of their corners';
CREATE OPERATOR <= (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_box, ab_box) IS 'Not after in the order of their corners';
CREATE FUNCTION _ab_greater_or_equal(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_box, ab_box) IS 'Not before in the order of their corners';
CREATE OPERATOR >= (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_box, ab_box) IS 'Not before in the order of their corners';
CREATE FUNCTION _ab_greater(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_box, ab_box) IS 'After in the order of their corners';
CREATE OPERATOR > (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel,
    JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_box, ab_box) IS 'After in the order of their corners';
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
CREATE OPERATOR < (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_solid, ab_solid) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_solid, ab_solid) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_solid, ab_solid) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_solid, ab_solid) IS 'After, in the order of the bytes';
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
CREATE OPERATOR < (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_scan, ab_scan) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_scan, ab_scan) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_scan, ab_scan) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel,
    JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_scan, ab_scan) IS 'After, in the order of the bytes';
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
CREATE OPERATOR < (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=,
    RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_evidence, ab_evidence) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_evidence, ab_evidence) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_evidence, ab_evidence) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_evidence, ab_evidence) IS 'After, in the order of the bytes';
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
CREATE OPERATOR < (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=,
    RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_occupancy, ab_occupancy) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_occupancy, ab_occupancy) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_occupancy, ab_occupancy) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_occupancy, ab_occupancy) IS 'After, in the order of the bytes';
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
CREATE OPERATOR < (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=,
    RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_change, ab_change) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_change, ab_change) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_change, ab_change) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_change, ab_change) IS 'After, in the order of the bytes';
CREATE FUNCTION _ab_less(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less(ab_evidence_model, ab_evidence_model) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less_or_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater(ab_evidence_model, ab_evidence_model) IS 'Of operator >';
CREATE OPERATOR < (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=,
    RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_evidence_model, ab_evidence_model) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=,
    NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_evidence_model, ab_evidence_model) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=,
    NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_evidence_model, ab_evidence_model) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_evidence_model, ab_evidence_model) IS 'After, in the order of the bytes';
CREATE FUNCTION _ab_less(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less(ab_grid, ab_grid) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less_or_equal(ab_grid, ab_grid) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_grid, ab_grid) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater(ab_grid, ab_grid) IS 'Of operator >';
CREATE OPERATOR < (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_grid, ab_grid) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_grid, ab_grid) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_grid, ab_grid) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel,
    JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_grid, ab_grid) IS 'After, in the order of the bytes';

-- 11-opclass_gist
CREATE OR REPLACE FUNCTION _ab_gist_distance(
    entry internal, query ab_scan, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance_lossy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE OR REPLACE FUNCTION _ab_gist_distance(
    entry internal, query ab_point, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance_lossy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_gist_sort(support internal) RETURNS void
    AS 'MODULE_PATHNAME', 'ab_gist_sort' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_sort(internal) IS 'GiST support';
CREATE FUNCTION _ab_gist_consistent(
    entry internal, query ab_occupancy, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_consistent(internal, ab_occupancy, smallint, oid, internal) IS 'GiST support';
CREATE FUNCTION _ab_gist_distance(
    entry internal, query ab_occupancy, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_distance(internal, ab_occupancy, smallint, oid, internal) IS 'GiST support';
CREATE FUNCTION _ab_gist_consistent(
    entry internal, query ab_change, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_consistent(internal, ab_change, smallint, oid, internal) IS 'GiST support';
CREATE FUNCTION _ab_gist_distance(
    entry internal, query ab_change, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_distance(internal, ab_change, smallint, oid, internal) IS 'GiST support';
CREATE FUNCTION _ab_gist_tile_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_tile_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_tile_compress(internal) IS 'GiST support';
ALTER OPERATOR FAMILY ab_box_gist_ops USING gist ADD
    OPERATOR 6 && (ab_box, ab_occupancy), OPERATOR 7 && (ab_box, ab_change),
    OPERATOR 14 <-> (ab_box, ab_point) FOR ORDER BY float_ops, FUNCTION 11 (ab_box, ab_box) _ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_solid_gist_ops USING gist ADD
    OPERATOR 6 && (ab_solid, ab_occupancy), OPERATOR 7 && (ab_solid, ab_change),
    OPERATOR 14 <-> (ab_solid, ab_point) FOR ORDER BY float_ops,
    FUNCTION 11 (ab_solid, ab_solid) _ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_scan_gist_ops USING gist ADD
    OPERATOR 14 <-> (ab_scan, ab_point) FOR ORDER BY float_ops, FUNCTION 11 (ab_scan, ab_scan) _ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_point_gist_ops USING gist ADD
    OPERATOR 14 <-> (ab_point, ab_point) FOR ORDER BY float_ops,
    FUNCTION 11 (ab_point, ab_point) _ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_line_gist_ops USING gist ADD
    FUNCTION 11 (ab_line, ab_line) _ab_gist_sort(internal);
CREATE OPERATOR CLASS ab_occupancy_gist_ops DEFAULT FOR TYPE ab_occupancy USING gist AS
    OPERATOR 1 && (ab_occupancy, ab_box), OPERATOR 2 && (ab_occupancy, ab_solid), OPERATOR 10 @> (ab_occupancy, ab_box),
    OPERATOR 11 <@ (ab_occupancy, ab_box), OPERATOR 12 ~= (ab_occupancy, ab_box),
    OPERATOR 13 <-> (ab_occupancy, ab_box) FOR ORDER BY float_ops,
    OPERATOR 14 <-> (ab_occupancy, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 _ab_gist_consistent(internal, ab_occupancy, smallint, oid, internal),
    FUNCTION 2 _ab_gist_union(internal, internal), FUNCTION 3 _ab_gist_tile_compress(internal),
    FUNCTION 5 _ab_gist_penalty(internal, internal, internal), FUNCTION 6 _ab_gist_picksplit(internal, internal),
    FUNCTION 7 _ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 _ab_gist_distance(internal, ab_occupancy, smallint, oid, internal), FUNCTION 11 _ab_gist_sort(internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_occupancy_gist_ops USING gist IS 'Joins on && by boxes';
CREATE OPERATOR CLASS ab_change_gist_ops DEFAULT FOR TYPE ab_change USING gist AS
    OPERATOR 1 && (ab_change, ab_box), OPERATOR 2 && (ab_change, ab_solid), OPERATOR 10 @> (ab_change, ab_box),
    OPERATOR 11 <@ (ab_change, ab_box), OPERATOR 12 ~= (ab_change, ab_box),
    OPERATOR 13 <-> (ab_change, ab_box) FOR ORDER BY float_ops,
    OPERATOR 14 <-> (ab_change, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 _ab_gist_consistent(internal, ab_change, smallint, oid, internal),
    FUNCTION 2 _ab_gist_union(internal, internal), FUNCTION 3 _ab_gist_tile_compress(internal),
    FUNCTION 5 _ab_gist_penalty(internal, internal, internal), FUNCTION 6 _ab_gist_picksplit(internal, internal),
    FUNCTION 7 _ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 _ab_gist_distance(internal, ab_change, smallint, oid, internal), FUNCTION 11 _ab_gist_sort(internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_change_gist_ops USING gist IS 'Joins on && by boxes';

-- 12-opclass_btree
CREATE FUNCTION _ab_compare(a ab_box, b ab_box) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_box_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_box, ab_box) IS '-1, 0 or 1 in the order of their corners';
CREATE OPERATOR CLASS ab_box_ops DEFAULT FOR TYPE ab_box USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_box, ab_box);
COMMENT ON OPERATOR CLASS ab_box_ops USING btree IS 'Order by their corners';
CREATE FUNCTION _ab_compare(a ab_solid, b ab_solid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_solid, ab_solid) IS 'Btree support';
CREATE OPERATOR CLASS ab_solid_btree_ops DEFAULT FOR TYPE ab_solid USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_solid, ab_solid);
COMMENT ON OPERATOR CLASS ab_solid_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE FUNCTION _ab_compare(a ab_scan, b ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_scan, ab_scan) IS 'Btree support';
CREATE OPERATOR CLASS ab_scan_btree_ops DEFAULT FOR TYPE ab_scan USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_scan, ab_scan);
COMMENT ON OPERATOR CLASS ab_scan_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE FUNCTION _ab_compare(a ab_evidence, b ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_evidence, ab_evidence) IS 'Btree support';
CREATE OPERATOR CLASS ab_evidence_btree_ops DEFAULT FOR TYPE ab_evidence USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >,
    FUNCTION 1 _ab_compare(ab_evidence, ab_evidence);
COMMENT ON OPERATOR CLASS ab_evidence_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE FUNCTION _ab_compare(a ab_occupancy, b ab_occupancy) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_occupancy, ab_occupancy) IS 'Btree support';
CREATE OPERATOR CLASS ab_occupancy_btree_ops DEFAULT FOR TYPE ab_occupancy USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >,
    FUNCTION 1 _ab_compare(ab_occupancy, ab_occupancy);
COMMENT ON OPERATOR CLASS ab_occupancy_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE FUNCTION _ab_compare(a ab_change, b ab_change) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_change, ab_change) IS 'Btree support';
CREATE OPERATOR CLASS ab_change_btree_ops DEFAULT FOR TYPE ab_change USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >,
    FUNCTION 1 _ab_compare(ab_change, ab_change);
COMMENT ON OPERATOR CLASS ab_change_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE FUNCTION _ab_compare(a ab_evidence_model, b ab_evidence_model) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_evidence_model, ab_evidence_model) IS 'Btree support';
CREATE OPERATOR CLASS ab_evidence_model_btree_ops DEFAULT FOR TYPE ab_evidence_model USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >,
    FUNCTION 1 _ab_compare(ab_evidence_model, ab_evidence_model);
COMMENT ON OPERATOR CLASS ab_evidence_model_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE FUNCTION _ab_compare(a ab_grid, b ab_grid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_grid, ab_grid) IS 'Btree support';
CREATE OPERATOR CLASS ab_grid_btree_ops DEFAULT FOR TYPE ab_grid USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_grid, ab_grid);
COMMENT ON OPERATOR CLASS ab_grid_btree_ops USING btree IS 'By bytes, for sorting and grouping';

-- 13-opclass_hash
CREATE FUNCTION _ab_hash(box ab_box) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_box_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_box) IS 'Hash of the numbers';
CREATE FUNCTION _ab_hash(box ab_box, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_box_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_box, bigint) IS 'Hash of the numbers with a seed';
CREATE OPERATOR CLASS ab_box_hash_ops DEFAULT FOR TYPE ab_box USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_box), FUNCTION 2 _ab_hash(ab_box, bigint);
COMMENT ON OPERATOR CLASS ab_box_hash_ops USING hash IS 'Joins and groups by equal numbers';
CREATE FUNCTION _ab_hash(a ab_solid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_solid) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_solid, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_solid, bigint) IS 'Hash support';
CREATE OPERATOR CLASS ab_solid_hash_ops DEFAULT FOR TYPE ab_solid USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_solid), FUNCTION 2 _ab_hash(ab_solid, bigint);
COMMENT ON OPERATOR CLASS ab_solid_hash_ops USING hash IS 'By bytes, for grouping and joins';
CREATE FUNCTION _ab_hash(a ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_scan) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_scan, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_scan, bigint) IS 'Hash support';
CREATE OPERATOR CLASS ab_scan_hash_ops DEFAULT FOR TYPE ab_scan USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_scan), FUNCTION 2 _ab_hash(ab_scan, bigint);
COMMENT ON OPERATOR CLASS ab_scan_hash_ops USING hash IS 'By bytes, for grouping and joins';
CREATE FUNCTION _ab_hash(a ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_evidence) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_evidence, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_evidence, bigint) IS 'Hash support';
CREATE OPERATOR CLASS ab_evidence_hash_ops DEFAULT FOR TYPE ab_evidence USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_evidence), FUNCTION 2 _ab_hash(ab_evidence, bigint);
COMMENT ON OPERATOR CLASS ab_evidence_hash_ops USING hash IS 'By bytes, for grouping and joins';
CREATE FUNCTION _ab_hash(a ab_occupancy) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_occupancy) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_occupancy, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_occupancy, bigint) IS 'Hash support';
CREATE OPERATOR CLASS ab_occupancy_hash_ops DEFAULT FOR TYPE ab_occupancy USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_occupancy), FUNCTION 2 _ab_hash(ab_occupancy, bigint);
COMMENT ON OPERATOR CLASS ab_occupancy_hash_ops USING hash IS 'By bytes, for grouping and joins';
CREATE FUNCTION _ab_hash(a ab_change) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_change) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_change, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_change, bigint) IS 'Hash support';
CREATE OPERATOR CLASS ab_change_hash_ops DEFAULT FOR TYPE ab_change USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_change), FUNCTION 2 _ab_hash(ab_change, bigint);
COMMENT ON OPERATOR CLASS ab_change_hash_ops USING hash IS 'By bytes, for grouping and joins';
CREATE FUNCTION _ab_hash(a ab_evidence_model) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_evidence_model) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_evidence_model, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_evidence_model, bigint) IS 'Hash support';
CREATE OPERATOR CLASS ab_evidence_model_hash_ops DEFAULT FOR TYPE ab_evidence_model USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_evidence_model), FUNCTION 2 _ab_hash(ab_evidence_model, bigint);
COMMENT ON OPERATOR CLASS ab_evidence_model_hash_ops USING hash IS 'By bytes, for grouping and joins';
CREATE FUNCTION _ab_hash(a ab_grid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_grid) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_grid, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_grid, bigint) IS 'Hash support';
CREATE OPERATOR CLASS ab_grid_hash_ops DEFAULT FOR TYPE ab_grid USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_grid), FUNCTION 2 _ab_hash(ab_grid, bigint);
COMMENT ON OPERATOR CLASS ab_grid_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- 30-planner
CREATE FUNCTION _ab_typanalyze(internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_typanalyze' LANGUAGE c STRICT PARALLEL SAFE STABLE;
COMMENT ON FUNCTION _ab_typanalyze(internal) IS
    'ANALYZE of a column of boxes, solids, patches, points or lines: where they lie and how large they are';
CREATE FUNCTION _ab_overlap_sel(internal, oid, internal, integer) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_overlap_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_overlap_sel(internal, oid, internal, integer) IS 'Planner: share of rows that && finds';
CREATE FUNCTION _ab_overlap_join_sel(internal, oid, internal, smallint, internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_overlap_join_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_overlap_join_sel(internal, oid, internal, smallint, internal) IS
    'Planner: share of pairs that && finds';
CREATE FUNCTION _ab_contains_sel(internal, oid, internal, integer) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_contains_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_contains_sel(internal, oid, internal, integer) IS 'Planner: share of rows that @> finds';
CREATE FUNCTION _ab_contains_join_sel(internal, oid, internal, smallint, internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_contains_join_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_contains_join_sel(internal, oid, internal, smallint, internal) IS
    'Planner: share of pairs that @> finds';
CREATE FUNCTION _ab_contained_sel(internal, oid, internal, integer) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_contained_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_contained_sel(internal, oid, internal, integer) IS 'Planner: share of rows that <@ finds';
CREATE FUNCTION _ab_contained_join_sel(internal, oid, internal, smallint, internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_contained_join_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_contained_join_sel(internal, oid, internal, smallint, internal) IS
    'Planner: share of pairs that <@ finds';
ALTER TYPE ab_box SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_solid SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_scan SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_point SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_line SET (ANALYZE = _ab_typanalyze);
ALTER OPERATOR && (ab_box, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_scan) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_scan) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_scan, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_scan, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_scan, ab_scan) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_point, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_point, ab_point) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_line, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_point) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_line) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_point) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_point, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR @> (ab_box, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_solid, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_solid, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_solid) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_solid) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_scan, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_scan, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_scan) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_scan) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_point, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_point, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_point) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_point) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER TYPE ab_occupancy SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_change SET (ANALYZE = _ab_typanalyze);
ALTER OPERATOR && (ab_occupancy, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_occupancy) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_occupancy, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_occupancy) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR @> (ab_occupancy, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_occupancy, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_occupancy) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_occupancy) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR && (ab_change, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_change) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_change, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_change) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR @> (ab_change, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_change, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_change) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_change) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);

-- 40-exchange
CREATE FUNCTION ab_solid_from_ewkb(ewkb bytea) RETURNS ab_solid
    AS 'MODULE_PATHNAME', 'ab_solid_from_ewkb' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_solid_from_ewkb(bytea) IS
    'A solid from WKB or EWKB of a POLYHEDRALSURFACE Z, TIN Z, MULTIPOLYGON Z, POLYGON Z or TRIANGLE Z in metres, as '
    'ST_AsEWKB gives it; faces of more than three corners are cut into triangles, the SRID is dropped';
CREATE FUNCTION ab_as_ewkb(solid ab_solid, tin boolean DEFAULT false) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_solid_as_ewkb' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_as_ewkb(ab_solid, boolean) IS
    'EWKB of a solid as POLYHEDRALSURFACE Z, or as TIN Z; one face a triangle, no SRID';

-- 50-session
CREATE TYPE ab_memory_row AS (live bigint, peak bigint);
COMMENT ON TYPE ab_memory_row IS 'What asbuilt takes in a session';
COMMENT ON COLUMN ab_memory_row.live IS 'Bytes now';
COMMENT ON COLUMN ab_memory_row.peak IS 'Most bytes ever, or since from_now';
CREATE FUNCTION ab_memory(from_now boolean DEFAULT false) RETURNS ab_memory_row
    AS 'MODULE_PATHNAME' LANGUAGE c VOLATILE PARALLEL RESTRICTED;
COMMENT ON FUNCTION ab_memory(boolean) IS
    'Bytes that asbuilt''s values and work take in this session''s process now, and the most they ever took; '
    'from_now begins the peak anew. What PostgreSQL itself holds of them (rows, results) is not counted';

CREATE FUNCTION _ab_declared() RETURNS SETOF text
    AS 'MODULE_PATHNAME', 'ab_declared' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_declared() IS
    'The C functions of asbuilt, each with the parameter types that it reads; ? where NULL is a value';

-- 99-compat
CREATE OR REPLACE FUNCTION _ab_evidence_model_in_010(cstring) RETURNS ab_evidence_model_010
    AS 'MODULE_PATHNAME', 'ab_evidence_model_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_in_010(cstring) IS
    '_ab_evidence_model_in as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_evidence_model_out_010(ab_evidence_model_010) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_evidence_model_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_out_010(ab_evidence_model_010) IS
    '_ab_evidence_model_out as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_evidence_model_recv_010(internal) RETURNS ab_evidence_model_010
    AS 'MODULE_PATHNAME', 'ab_evidence_model_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_recv_010(internal) IS
    '_ab_evidence_model_recv as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_evidence_model_send_010(ab_evidence_model_010) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_evidence_model_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_send_010(ab_evidence_model_010) IS
    '_ab_evidence_model_send as it was in 0.1.0: for what was made with it';
COMMENT ON TYPE ab_evidence_model_010 IS
    'ab_evidence_model as it was in 0.1.0: for columns that were made then; becomes one of today where that is asked '
    'for';
CREATE FUNCTION _ab_evidence_model_renewed_010(model ab_evidence_model_010) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_evidence_model_renewed' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_renewed_010(ab_evidence_model_010) IS
    'Of the cast: all parameters count as given';
CREATE CAST (ab_evidence_model_010 AS ab_evidence_model)
    WITH FUNCTION _ab_evidence_model_renewed_010(ab_evidence_model_010) AS IMPLICIT;
COMMENT ON CAST (ab_evidence_model_010 AS ab_evidence_model) IS 'Columns of 0.1.0 go on';
CREATE OR REPLACE FUNCTION _ab_scan_010(
    origin float8[], points float8[], step float8 DEFAULT NULL, station bigint DEFAULT 0,
    quantum float8 DEFAULT 0.0001) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_make' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION _ab_scan_010(float8[], float8[], float8, bigint, float8) IS
    'ab_scan as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_loa_class_010(
    OUT loa ab_loa, OUT lower float8, OUT upper float8, OUT sigma float8, OUT source text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_loa_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION _ab_loa_class_010() IS 'ab_loa_class as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_evidence_model_make_010(
    loa ab_loa DEFAULT 'LOA30', model text DEFAULT 'surface', spacing float8 DEFAULT NULL,
    sigma_range float8 DEFAULT NULL, sigma_angle float8 DEFAULT NULL, sigma_station float8 DEFAULT NULL,
    sigma_model float8 DEFAULT NULL, confidence float8 DEFAULT NULL, reliability float8 DEFAULT NULL,
    max_incidence float8 DEFAULT NULL, no_return_range float8 DEFAULT NULL, no_return_weight float8 DEFAULT NULL,
    kappa float8 DEFAULT NULL, lambda float8 DEFAULT NULL, c float8 DEFAULT NULL) RETURNS ab_evidence_model_010
    AS 'MODULE_PATHNAME', 'ab_evidence_model_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_make_010(
    ab_loa, text, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8,
    float8) IS
    'ab_evidence_model as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_summary_010(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL, OUT verdict text, OUT best_loa ab_loa,
    OUT samples bigint, OUT coverage float8, OUT confirmed float8, OUT refuted float8, OUT open float8,
    OUT conflict float8, OUT deviation float8, OUT deviation_sd float8, OUT shift text) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_summary' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION _ab_summary_010(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'ab_summary as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_verdict_010(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_verdict' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION _ab_verdict_010(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'ab_verdict as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_shift_010(
    e ab_evidence, OUT x float8, OUT y float8, OUT z float8, OUT x_sd float8, OUT y_sd float8,
    OUT z_sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_shift' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION _ab_shift_010(ab_evidence) IS 'ab_shift as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_samples_010(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, OUT "position" float8[],
    OUT normal float8[], OUT mass ab_mass, OUT deviation float8, OUT deviation_sd float8,
    OUT beams integer) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_samples' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 10000;
COMMENT ON FUNCTION _ab_samples_010(ab_evidence, ab_loa, float8) IS
    'ab_samples as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_faces_010(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, OUT normal float8[], OUT samples bigint,
    OUT seen bigint, OUT confirmed bigint, OUT refuted bigint, OUT open bigint, OUT pierced bigint,
    OUT deviation float8, OUT deviation_sd float8) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_faces' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 20;
COMMENT ON FUNCTION _ab_faces_010(ab_evidence, ab_loa, float8) IS
    'ab_faces as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_model_010(e ab_evidence) RETURNS ab_evidence_model_010
    AS 'MODULE_PATHNAME', 'ab_evidence_get_model' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_model_010(ab_evidence) IS 'ab_model as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_evidence_accum_010(
    state internal, solid ab_solid, patch ab_scan, model ab_evidence_model_010) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_evidence_accum_010(internal, ab_solid, ab_scan, ab_evidence_model_010) IS
    '_ab_evidence_accum as it was in 0.1.0: for what was made with it';
COMMENT ON AGGREGATE _ab_evidence_agg_010(ab_solid, ab_scan, ab_evidence_model_010) IS
    'ab_evidence_agg as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_line_010(
    start float8[], "end" float8[], covariance float8[] DEFAULT NULL) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_line_010(float8[], float8[], float8[]) IS
    'ab_line as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_plucker_010(
    line ab_line, reference float8[] DEFAULT '{0,0,0}', OUT line float8[], OUT covariance float8[]) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_line_plucker' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_plucker_010(ab_line, float8[]) IS 'ab_plucker as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_ellipsoid_010(
    point ab_point, probability float8 DEFAULT 0.95, OUT half_axis float8, OUT direction float8[]) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_point_ellipsoid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 3;
COMMENT ON FUNCTION _ab_ellipsoid_010(ab_point, float8) IS 'ab_ellipsoid as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_distance_010(a ab_point, b ab_point, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_points' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_distance_010(ab_point, ab_point) IS 'ab_distance as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_distance_010(
    point ab_point, plane ab_plane, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_distance_010(ab_point, ab_plane) IS 'ab_distance as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_distance_010(
    point ab_point, line ab_line, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_distance_010(ab_point, ab_line) IS 'ab_distance as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_distance_010(a ab_line, b ab_line, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_distance_010(ab_line, ab_line) IS 'ab_distance as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_same_010(
    a ab_point, b ab_point, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_same_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_same_010(ab_point, ab_point) IS
    'ab_test_same as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_same_010(
    a ab_plane, b ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_same_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_same_010(ab_plane, ab_plane) IS
    'ab_test_same as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_incident_010(
    point ab_point, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_point_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_incident_010(ab_point, ab_line) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_incident_010(
    point ab_point, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_point_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_incident_010(ab_point, ab_plane) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_incident_010(
    line ab_line, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_incident_010(ab_line, ab_plane) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_parallel_010(
    a ab_line, b ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_parallel_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_parallel_010(ab_line, ab_line) IS
    'ab_test_parallel as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_parallel_010(
    a ab_plane, b ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_parallel_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_parallel_010(ab_plane, ab_plane) IS
    'ab_test_parallel as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_parallel_010(
    line ab_line, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_parallel_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_parallel_010(ab_line, ab_plane) IS
    'ab_test_parallel as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_orthogonal_010(
    a ab_line, b ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_orthogonal_010(ab_line, ab_line) IS
    'ab_test_orthogonal as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_orthogonal_010(
    a ab_plane, b ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_orthogonal_010(ab_plane, ab_plane) IS
    'ab_test_orthogonal as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_orthogonal_010(
    line ab_line, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_orthogonal_010(ab_line, ab_plane) IS
    'ab_test_orthogonal as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_coplanar_010(
    a ab_line, b ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_coplanar_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_coplanar_010(ab_line, ab_line) IS
    'ab_test_coplanar as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_incident_010(
    line ab_line, point ab_point, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_incident_010(point, line) t; END;
COMMENT ON FUNCTION _ab_test_incident_010(ab_line, ab_point) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_incident_010(
    plane ab_plane, point ab_point, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_incident_010(point, plane) t; END;
COMMENT ON FUNCTION _ab_test_incident_010(ab_plane, ab_point) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_incident_010(
    plane ab_plane, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_incident_010(line, plane) t; END;
COMMENT ON FUNCTION _ab_test_incident_010(ab_plane, ab_line) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_parallel_010(
    plane ab_plane, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_parallel_010(line, plane) t; END;
COMMENT ON FUNCTION _ab_test_parallel_010(ab_plane, ab_line) IS
    'ab_test_parallel as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_test_orthogonal_010(
    plane ab_plane, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_orthogonal_010(line, plane) t; END;
COMMENT ON FUNCTION _ab_test_orthogonal_010(ab_plane, ab_line) IS
    'ab_test_orthogonal as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_distance_010(
    plane ab_plane, point ab_point, OUT distance float8, OUT sd float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.distance, t.sd FROM _ab_distance_010(point, plane) t; END;
COMMENT ON FUNCTION _ab_distance_010(ab_plane, ab_point) IS 'ab_distance as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_distance_010(
    line ab_line, point ab_point, OUT distance float8, OUT sd float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.distance, t.sd FROM _ab_distance_010(point, line) t; END;
COMMENT ON FUNCTION _ab_distance_010(ab_line, ab_point) IS 'ab_distance as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_convert_belief_linear_010(
    belief float8, sigma float8, sigma_to float8, divisor float8 DEFAULT 0.682689492137086, OUT belief_to float8,
    OUT capped boolean) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_convert_belief_linear' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_convert_belief_linear_010(float8, float8, float8, float8) IS
    'ab_convert_belief_linear as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_din18710_class_010(
    OUT class text, OUT lower float8, OUT upper float8, OUT source text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_din18710_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION _ab_din18710_class_010() IS 'ab_din18710_class as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_evidence_accum_010(
    state internal, solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model_010) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_accum_point' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 2000;
COMMENT ON FUNCTION _ab_evidence_accum_010(internal, ab_solid, ab_point, float8[], ab_evidence_model_010) IS
    '_ab_evidence_accum as it was in 0.1.0: for what was made with it';
COMMENT ON AGGREGATE _ab_evidence_agg_010(ab_solid, ab_point, float8[], ab_evidence_model_010) IS
    'ab_evidence_agg as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_cone_010(patch ab_scan, OUT axis float8[], OUT half_angle float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_cone' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_cone_010(ab_scan) IS 'ab_cone as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_range_010(patch ab_scan, OUT nearest float8, OUT farthest float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_range_010(ab_scan) IS 'ab_range as it was in 0.1.0: for what was made with it';
CREATE OR REPLACE FUNCTION _ab_beams_010(
    patch ab_scan, OUT origin float8[], OUT point float8[], OUT direction float8[],
    OUT range float8) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_scan_beams' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5000 ROWS 4000;
COMMENT ON FUNCTION _ab_beams_010(ab_scan) IS 'ab_beams as it was in 0.1.0: for what was made with it';
