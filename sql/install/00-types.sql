-- Types, their input and output.

CREATE TYPE ab_loa AS ENUM ('LOA10', 'LOA20', 'LOA30', 'LOA40', 'LOA50');
COMMENT ON TYPE ab_loa IS 'USIBD Level of Accuracy, coarsest first; bounds in ab_loa_class()';

CREATE TYPE ab_box;
CREATE FUNCTION _ab_box_in(cstring) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_box_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_box_out(ab_box) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_box_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_box_recv(internal) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_box_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_box_send(ab_box) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_box_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_box_in(cstring) IS 'Text input of ab_box';
COMMENT ON FUNCTION _ab_box_out(ab_box) IS 'Text output of ab_box';
COMMENT ON FUNCTION _ab_box_recv(internal) IS 'Binary input of ab_box';
COMMENT ON FUNCTION _ab_box_send(ab_box) IS 'Binary output of ab_box';
CREATE TYPE ab_box (
    INPUT = _ab_box_in, OUTPUT = _ab_box_out, RECEIVE = _ab_box_recv, SEND = _ab_box_send, INTERNALLENGTH = 48,
    ALIGNMENT = double);
COMMENT ON TYPE ab_box IS 'An axis-aligned box in metres; text BOX3D(x y z,x y z) as PostGIS prints a box3d';

CREATE TYPE ab_mass;
CREATE FUNCTION _ab_mass_in(cstring) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_mass_out(ab_mass) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_mass_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_mass_recv(internal) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_mass_send(ab_mass) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_mass_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_mass_in(cstring) IS 'Text input of ab_mass';
COMMENT ON FUNCTION _ab_mass_out(ab_mass) IS 'Text output of ab_mass';
COMMENT ON FUNCTION _ab_mass_recv(internal) IS 'Binary input of ab_mass';
COMMENT ON FUNCTION _ab_mass_send(ab_mass) IS 'Binary output of ab_mass';
CREATE TYPE ab_mass (
    INPUT = _ab_mass_in, OUTPUT = _ab_mass_out, RECEIVE = _ab_mass_recv, SEND = _ab_mass_send, INTERNALLENGTH = 24,
    ALIGNMENT = double);
COMMENT ON TYPE ab_mass IS
    'A belief mass on {occupied, empty}: (occupied,empty,unknown), summing to 1; unknown is explicit ignorance. What '
    'an unnormalised rule leaves to contradiction stands as a fourth number';

CREATE TYPE ab_solid;
CREATE FUNCTION _ab_solid_in(cstring) RETURNS ab_solid
    AS 'MODULE_PATHNAME', 'ab_solid_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_solid_out(ab_solid) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_solid_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_solid_recv(internal) RETURNS ab_solid
    AS 'MODULE_PATHNAME', 'ab_solid_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_solid_send(ab_solid) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_solid_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_solid_in(cstring) IS 'Text input of ab_solid';
COMMENT ON FUNCTION _ab_solid_out(ab_solid) IS 'Text output of ab_solid';
COMMENT ON FUNCTION _ab_solid_recv(internal) IS 'Binary input of ab_solid';
COMMENT ON FUNCTION _ab_solid_send(ab_solid) IS 'Binary output of ab_solid';
CREATE TYPE ab_solid (
    INPUT = _ab_solid_in, OUTPUT = _ab_solid_out, RECEIVE = _ab_solid_recv, SEND = _ab_solid_send,
    INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = extended);
COMMENT ON TYPE ab_solid IS
    'A triangle mesh in world metres with box, area, volume and closedness: the geometry of a building object';

CREATE TYPE ab_scan;
CREATE FUNCTION _ab_scan_in(cstring) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_scan_out(ab_scan) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_scan_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_scan_recv(internal) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_scan_send(ab_scan) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_scan_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_scan_in(cstring) IS 'Text input of ab_scan';
COMMENT ON FUNCTION _ab_scan_out(ab_scan) IS 'Text output of ab_scan';
COMMENT ON FUNCTION _ab_scan_recv(internal) IS 'Binary input of ab_scan';
COMMENT ON FUNCTION _ab_scan_send(ab_scan) IS 'Binary output of ab_scan';
CREATE TYPE ab_scan (
    INPUT = _ab_scan_in, OUTPUT = _ab_scan_out, RECEIVE = _ab_scan_recv, SEND = _ab_scan_send,
    INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = external);
COMMENT ON TYPE ab_scan IS
    'A patch of at most 4096 neighbouring laser beams from one origin, packed to 0.1 mm; box and cone are readable '
    'without the beams';

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

CREATE TYPE ab_evidence;
CREATE FUNCTION _ab_evidence_in(cstring) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_evidence_out(ab_evidence) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_evidence_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_evidence_recv(internal) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_evidence_send(ab_evidence) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_evidence_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_in(cstring) IS 'Text input of ab_evidence';
COMMENT ON FUNCTION _ab_evidence_out(ab_evidence) IS 'Text output of ab_evidence';
COMMENT ON FUNCTION _ab_evidence_recv(internal) IS 'Binary input of ab_evidence';
COMMENT ON FUNCTION _ab_evidence_send(ab_evidence) IS 'Binary output of ab_evidence';
CREATE TYPE ab_evidence (
    INPUT = _ab_evidence_in, OUTPUT = _ab_evidence_out, RECEIVE = _ab_evidence_recv, SEND = _ab_evidence_send,
    INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = external);
COMMENT ON TYPE ab_evidence IS
    'What the beams of many stations say about one solid, per sample and station; add up with ab_rollup, ask with '
    'ab_summary';

CREATE TYPE ab_point;
CREATE FUNCTION _ab_point_in(cstring) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_point_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_point_out(ab_point) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_point_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_point_recv(internal) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_point_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_point_send(ab_point) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_point_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_point_in(cstring) IS 'Text input of ab_point';
COMMENT ON FUNCTION _ab_point_out(ab_point) IS 'Text output of ab_point';
COMMENT ON FUNCTION _ab_point_recv(internal) IS 'Binary input of ab_point';
COMMENT ON FUNCTION _ab_point_send(ab_point) IS 'Binary output of ab_point';
CREATE TYPE ab_point (
    INPUT = _ab_point_in, OUTPUT = _ab_point_out, RECEIVE = _ab_point_recv, SEND = _ab_point_send, INTERNALLENGTH = 72,
    ALIGNMENT = double);
COMMENT ON TYPE ab_point IS 'A point in metres with its 3 x 3 covariance: (x,y,z;xx,xy,xz,yy,yz,zz)';

CREATE TYPE ab_line;
CREATE FUNCTION _ab_line_in(cstring) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_line_out(ab_line) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_line_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_line_recv(internal) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_line_send(ab_line) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_line_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_line_in(cstring) IS 'Text input of ab_line';
COMMENT ON FUNCTION _ab_line_out(ab_line) IS 'Text output of ab_line';
COMMENT ON FUNCTION _ab_line_recv(internal) IS 'Binary input of ab_line';
COMMENT ON FUNCTION _ab_line_send(ab_line) IS 'Binary output of ab_line';
CREATE TYPE ab_line (
    INPUT = _ab_line_in, OUTPUT = _ab_line_out, RECEIVE = _ab_line_recv, SEND = _ab_line_send, INTERNALLENGTH = 216,
    ALIGNMENT = double);
COMMENT ON TYPE ab_line IS
    'A line as a segment between two uncertain points, with their joint 6 x 6 covariance: (x,y,z,x,y,z;upper '
    'triangle)';

CREATE TYPE ab_plane;
CREATE FUNCTION _ab_plane_in(cstring) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_plane_out(ab_plane) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_plane_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_plane_recv(internal) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_plane_send(ab_plane) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_plane_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_plane_in(cstring) IS 'Text input of ab_plane';
COMMENT ON FUNCTION _ab_plane_out(ab_plane) IS 'Text output of ab_plane';
COMMENT ON FUNCTION _ab_plane_recv(internal) IS 'Binary input of ab_plane';
COMMENT ON FUNCTION _ab_plane_send(ab_plane) IS 'Binary output of ab_plane';
CREATE TYPE ab_plane (
    INPUT = _ab_plane_in, OUTPUT = _ab_plane_out, RECEIVE = _ab_plane_recv, SEND = _ab_plane_send, INTERNALLENGTH = 128,
    ALIGNMENT = double);
COMMENT ON TYPE ab_plane IS
    'A plane in centroid form: point, unit normal and the 4 x 4 covariance of (normal, offset along it): '
    '(x,y,z,nx,ny,nz;upper triangle)';

CREATE TYPE ab_pose;
CREATE FUNCTION _ab_pose_in(cstring) RETURNS ab_pose
    AS 'MODULE_PATHNAME', 'ab_pose_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_pose_out(ab_pose) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_pose_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_pose_recv(internal) RETURNS ab_pose
    AS 'MODULE_PATHNAME', 'ab_pose_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION _ab_pose_send(ab_pose) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_pose_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_pose_in(cstring) IS 'Text input of ab_pose';
COMMENT ON FUNCTION _ab_pose_out(ab_pose) IS 'Text output of ab_pose';
COMMENT ON FUNCTION _ab_pose_recv(internal) IS 'Binary input of ab_pose';
COMMENT ON FUNCTION _ab_pose_send(ab_pose) IS 'Binary output of ab_pose';
CREATE TYPE ab_pose (
    INPUT = _ab_pose_in, OUTPUT = _ab_pose_out, RECEIVE = _ab_pose_recv, SEND = _ab_pose_send, INTERNALLENGTH = 288,
    ALIGNMENT = double);
COMMENT ON TYPE ab_pose IS
    'A rigid or similarity transform x -> scale*R*x + t: unit quaternion w,x,y,z, translation, scale and the 7 x 7 '
    'covariance of (rotation about the target axes in radians, translation, relative scale)';

-- Space in voxels: lattice, occupancy of an epoch, change between two.
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
