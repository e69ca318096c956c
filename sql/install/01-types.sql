-- Types, their input and output.

CREATE TYPE ab_loa AS ENUM ('LOA10', 'LOA20', 'LOA30', 'LOA40', 'LOA50');
COMMENT ON TYPE ab_loa IS 'USIBD Level of Accuracy, coarsest first; bounds in ab_loa_class()';

-- What ANALYZE and the planner ask.

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

CREATE TYPE ab_box;
CREATE FUNCTION ab_box_in(cstring) RETURNS ab_box AS 'MODULE_PATHNAME', 'ab_box_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_box_out(ab_box) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_box_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_box_recv(internal) RETURNS ab_box AS 'MODULE_PATHNAME', 'ab_box_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_box_send(ab_box) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_box_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box_in(cstring) IS 'Text input of ab_box';
COMMENT ON FUNCTION ab_box_out(ab_box) IS 'Text output of ab_box';
COMMENT ON FUNCTION ab_box_recv(internal) IS 'Binary input of ab_box';
COMMENT ON FUNCTION ab_box_send(ab_box) IS 'Binary output of ab_box';
CREATE TYPE ab_box (INPUT = ab_box_in, OUTPUT = ab_box_out, RECEIVE = ab_box_recv, SEND = ab_box_send, INTERNALLENGTH = 48, ALIGNMENT = double, ANALYZE = ab_typanalyze);
COMMENT ON TYPE ab_box IS 'An axis-aligned box in metres; text BOX3D(x y z,x y z) as PostGIS prints a box3d';

CREATE TYPE ab_mass;
CREATE FUNCTION ab_mass_in(cstring) RETURNS ab_mass AS 'MODULE_PATHNAME', 'ab_mass_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_mass_out(ab_mass) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_mass_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_mass_recv(internal) RETURNS ab_mass AS 'MODULE_PATHNAME', 'ab_mass_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_mass_send(ab_mass) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_mass_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_mass_in(cstring) IS 'Text input of ab_mass';
COMMENT ON FUNCTION ab_mass_out(ab_mass) IS 'Text output of ab_mass';
COMMENT ON FUNCTION ab_mass_recv(internal) IS 'Binary input of ab_mass';
COMMENT ON FUNCTION ab_mass_send(ab_mass) IS 'Binary output of ab_mass';
CREATE TYPE ab_mass (INPUT = ab_mass_in, OUTPUT = ab_mass_out, RECEIVE = ab_mass_recv, SEND = ab_mass_send, INTERNALLENGTH = 24, ALIGNMENT = double);
COMMENT ON TYPE ab_mass IS 'A belief mass on {occupied, empty}: (occupied,empty,unknown), summing to 1; unknown is explicit ignorance. What an unnormalised rule leaves to contradiction stands as a fourth number';

CREATE TYPE ab_solid;
CREATE FUNCTION ab_solid_in(cstring) RETURNS ab_solid AS 'MODULE_PATHNAME', 'ab_solid_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_solid_out(ab_solid) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_solid_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_solid_recv(internal) RETURNS ab_solid AS 'MODULE_PATHNAME', 'ab_solid_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_solid_send(ab_solid) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_solid_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_solid_in(cstring) IS 'Text input of ab_solid';
COMMENT ON FUNCTION ab_solid_out(ab_solid) IS 'Text output of ab_solid';
COMMENT ON FUNCTION ab_solid_recv(internal) IS 'Binary input of ab_solid';
COMMENT ON FUNCTION ab_solid_send(ab_solid) IS 'Binary output of ab_solid';
CREATE TYPE ab_solid (INPUT = ab_solid_in, OUTPUT = ab_solid_out, RECEIVE = ab_solid_recv, SEND = ab_solid_send, INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = extended, ANALYZE = ab_typanalyze);
COMMENT ON TYPE ab_solid IS 'A triangle mesh in world metres with box, area, volume and closedness: the geometry of a building object';

CREATE TYPE ab_scan;
CREATE FUNCTION ab_scan_in(cstring) RETURNS ab_scan AS 'MODULE_PATHNAME', 'ab_scan_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_scan_out(ab_scan) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_scan_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_scan_recv(internal) RETURNS ab_scan AS 'MODULE_PATHNAME', 'ab_scan_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_scan_send(ab_scan) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_scan_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_in(cstring) IS 'Text input of ab_scan';
COMMENT ON FUNCTION ab_scan_out(ab_scan) IS 'Text output of ab_scan';
COMMENT ON FUNCTION ab_scan_recv(internal) IS 'Binary input of ab_scan';
COMMENT ON FUNCTION ab_scan_send(ab_scan) IS 'Binary output of ab_scan';
CREATE TYPE ab_scan (INPUT = ab_scan_in, OUTPUT = ab_scan_out, RECEIVE = ab_scan_recv, SEND = ab_scan_send, INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = external, ANALYZE = ab_typanalyze);
COMMENT ON TYPE ab_scan IS 'A patch of at most 4096 neighbouring laser beams from one origin, packed to 0.1 mm; box and cone are readable without the beams';

CREATE TYPE ab_evidence_model;
CREATE FUNCTION ab_evidence_model_in(cstring) RETURNS ab_evidence_model AS 'MODULE_PATHNAME', 'ab_evidence_model_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_evidence_model_out(ab_evidence_model) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_evidence_model_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_evidence_model_recv(internal) RETURNS ab_evidence_model AS 'MODULE_PATHNAME', 'ab_evidence_model_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_evidence_model_send(ab_evidence_model) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_evidence_model_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_evidence_model_in(cstring) IS 'Text input of ab_evidence_model';
COMMENT ON FUNCTION ab_evidence_model_out(ab_evidence_model) IS 'Text output of ab_evidence_model';
COMMENT ON FUNCTION ab_evidence_model_recv(internal) IS 'Binary input of ab_evidence_model';
COMMENT ON FUNCTION ab_evidence_model_send(ab_evidence_model) IS 'Binary output of ab_evidence_model';
CREATE TYPE ab_evidence_model (INPUT = ab_evidence_model_in, OUTPUT = ab_evidence_model_out, RECEIVE = ab_evidence_model_recv, SEND = ab_evidence_model_send, INTERNALLENGTH = 112, ALIGNMENT = double);
COMMENT ON TYPE ab_evidence_model IS 'Parameters of evidence and verdict: see ab_evidence_model()';

CREATE TYPE ab_evidence;
CREATE FUNCTION ab_evidence_in(cstring) RETURNS ab_evidence AS 'MODULE_PATHNAME', 'ab_evidence_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_evidence_out(ab_evidence) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_evidence_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_evidence_recv(internal) RETURNS ab_evidence AS 'MODULE_PATHNAME', 'ab_evidence_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_evidence_send(ab_evidence) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_evidence_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_evidence_in(cstring) IS 'Text input of ab_evidence';
COMMENT ON FUNCTION ab_evidence_out(ab_evidence) IS 'Text output of ab_evidence';
COMMENT ON FUNCTION ab_evidence_recv(internal) IS 'Binary input of ab_evidence';
COMMENT ON FUNCTION ab_evidence_send(ab_evidence) IS 'Binary output of ab_evidence';
CREATE TYPE ab_evidence (INPUT = ab_evidence_in, OUTPUT = ab_evidence_out, RECEIVE = ab_evidence_recv, SEND = ab_evidence_send, INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = external);
COMMENT ON TYPE ab_evidence IS 'What the beams of many stations say about one solid, per sample and station; add up with ab_rollup, ask with ab_summary';

CREATE TYPE ab_point;
CREATE FUNCTION ab_point_in(cstring) RETURNS ab_point AS 'MODULE_PATHNAME', 'ab_point_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_point_out(ab_point) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_point_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_point_recv(internal) RETURNS ab_point AS 'MODULE_PATHNAME', 'ab_point_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_point_send(ab_point) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_point_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_point_in(cstring) IS 'Text input of ab_point';
COMMENT ON FUNCTION ab_point_out(ab_point) IS 'Text output of ab_point';
COMMENT ON FUNCTION ab_point_recv(internal) IS 'Binary input of ab_point';
COMMENT ON FUNCTION ab_point_send(ab_point) IS 'Binary output of ab_point';
CREATE TYPE ab_point (INPUT = ab_point_in, OUTPUT = ab_point_out, RECEIVE = ab_point_recv, SEND = ab_point_send, INTERNALLENGTH = 72, ALIGNMENT = double, ANALYZE = ab_typanalyze);
COMMENT ON TYPE ab_point IS 'A point in metres with its 3 x 3 covariance: (x,y,z;xx,xy,xz,yy,yz,zz)';

CREATE TYPE ab_line;
CREATE FUNCTION ab_line_in(cstring) RETURNS ab_line AS 'MODULE_PATHNAME', 'ab_line_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_line_out(ab_line) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_line_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_line_recv(internal) RETURNS ab_line AS 'MODULE_PATHNAME', 'ab_line_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_line_send(ab_line) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_line_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_line_in(cstring) IS 'Text input of ab_line';
COMMENT ON FUNCTION ab_line_out(ab_line) IS 'Text output of ab_line';
COMMENT ON FUNCTION ab_line_recv(internal) IS 'Binary input of ab_line';
COMMENT ON FUNCTION ab_line_send(ab_line) IS 'Binary output of ab_line';
CREATE TYPE ab_line (INPUT = ab_line_in, OUTPUT = ab_line_out, RECEIVE = ab_line_recv, SEND = ab_line_send, INTERNALLENGTH = 216, ALIGNMENT = double, ANALYZE = ab_typanalyze);
COMMENT ON TYPE ab_line IS 'A line as a segment between two uncertain points, with their joint 6 x 6 covariance: (x,y,z,x,y,z;upper triangle)';

CREATE TYPE ab_plane;
CREATE FUNCTION ab_plane_in(cstring) RETURNS ab_plane AS 'MODULE_PATHNAME', 'ab_plane_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_plane_out(ab_plane) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_plane_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_plane_recv(internal) RETURNS ab_plane AS 'MODULE_PATHNAME', 'ab_plane_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_plane_send(ab_plane) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_plane_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plane_in(cstring) IS 'Text input of ab_plane';
COMMENT ON FUNCTION ab_plane_out(ab_plane) IS 'Text output of ab_plane';
COMMENT ON FUNCTION ab_plane_recv(internal) IS 'Binary input of ab_plane';
COMMENT ON FUNCTION ab_plane_send(ab_plane) IS 'Binary output of ab_plane';
CREATE TYPE ab_plane (INPUT = ab_plane_in, OUTPUT = ab_plane_out, RECEIVE = ab_plane_recv, SEND = ab_plane_send, INTERNALLENGTH = 128, ALIGNMENT = double);
COMMENT ON TYPE ab_plane IS 'A plane in centroid form: point, unit normal and the 4 x 4 covariance of (normal, offset along it): (x,y,z,nx,ny,nz;upper triangle)';

CREATE TYPE ab_pose;
CREATE FUNCTION ab_pose_in(cstring) RETURNS ab_pose AS 'MODULE_PATHNAME', 'ab_pose_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_pose_out(ab_pose) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_pose_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_pose_recv(internal) RETURNS ab_pose AS 'MODULE_PATHNAME', 'ab_pose_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_pose_send(ab_pose) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_pose_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_pose_in(cstring) IS 'Text input of ab_pose';
COMMENT ON FUNCTION ab_pose_out(ab_pose) IS 'Text output of ab_pose';
COMMENT ON FUNCTION ab_pose_recv(internal) IS 'Binary input of ab_pose';
COMMENT ON FUNCTION ab_pose_send(ab_pose) IS 'Binary output of ab_pose';
CREATE TYPE ab_pose (INPUT = ab_pose_in, OUTPUT = ab_pose_out, RECEIVE = ab_pose_recv, SEND = ab_pose_send, INTERNALLENGTH = 288, ALIGNMENT = double);
COMMENT ON TYPE ab_pose IS 'A rigid or similarity transform x -> scale*R*x + t: unit quaternion w,x,y,z, translation, scale and the 7 x 7 covariance of (rotation about the target axes in radians, translation, relative scale)';
