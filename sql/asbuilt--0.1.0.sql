-- asbuilt 0.1.0, as released: kept to test upgrades from it.

-- Types, their input and output.

CREATE TYPE ab_loa AS ENUM ('LOA10', 'LOA20', 'LOA30', 'LOA40', 'LOA50');
COMMENT ON TYPE ab_loa IS 'USIBD Level of Accuracy, coarsest first; bounds in ab_loa_class()';

CREATE TYPE ab_box;
CREATE FUNCTION ab_box_in(cstring) RETURNS ab_box AS 'MODULE_PATHNAME', 'ab_box_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_box_out(ab_box) RETURNS cstring AS 'MODULE_PATHNAME', 'ab_box_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_box_recv(internal) RETURNS ab_box AS 'MODULE_PATHNAME', 'ab_box_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
CREATE FUNCTION ab_box_send(ab_box) RETURNS bytea AS 'MODULE_PATHNAME', 'ab_box_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box_in(cstring) IS 'Text input of ab_box';
COMMENT ON FUNCTION ab_box_out(ab_box) IS 'Text output of ab_box';
COMMENT ON FUNCTION ab_box_recv(internal) IS 'Binary input of ab_box';
COMMENT ON FUNCTION ab_box_send(ab_box) IS 'Binary output of ab_box';
CREATE TYPE ab_box (INPUT = ab_box_in, OUTPUT = ab_box_out, RECEIVE = ab_box_recv, SEND = ab_box_send, INTERNALLENGTH = 48, ALIGNMENT = double);
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
CREATE TYPE ab_solid (INPUT = ab_solid_in, OUTPUT = ab_solid_out, RECEIVE = ab_solid_recv, SEND = ab_solid_send, INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = extended);
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
CREATE TYPE ab_scan (INPUT = ab_scan_in, OUTPUT = ab_scan_out, RECEIVE = ab_scan_recv, SEND = ab_scan_send, INTERNALLENGTH = VARIABLE, ALIGNMENT = int4, STORAGE = external);
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
CREATE TYPE ab_point (INPUT = ab_point_in, OUTPUT = ab_point_out, RECEIVE = ab_point_recv, SEND = ab_point_send, INTERNALLENGTH = 72, ALIGNMENT = double);
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
CREATE TYPE ab_line (INPUT = ab_line_in, OUTPUT = ab_line_out, RECEIVE = ab_line_recv, SEND = ab_line_send, INTERNALLENGTH = 216, ALIGNMENT = double);
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

-- Boxes and solids.

CREATE FUNCTION ab_box(xmin float8, ymin float8, zmin float8, xmax float8, ymax float8, zmax float8) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_box_make' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box(float8, float8, float8, float8, float8, float8) IS 'A box between two corners, given in any order; metres';

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
COMMENT ON FUNCTION ab_solid(float8[], integer[]) IS 'A solid from vertices (n x 3, metres) and triangles (n x 3, vertex numbers from 0, counter-clockwise seen from outside); a closed one that is inside out is turned';

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
COMMENT ON FUNCTION ab_closedness(ab_solid) IS 'closed, closed but for T-junctions, or open surface: by the balance of its edges';

CREATE FUNCTION ab_vertices(solid ab_solid) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_solid_vertices' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_vertices(ab_solid) IS 'Vertices of a solid, n x 3, metres';

CREATE FUNCTION ab_triangles(solid ab_solid) RETURNS integer[]
    AS 'MODULE_PATHNAME', 'ab_solid_triangles' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_triangles(ab_solid) IS 'Triangles of a solid, n x 3, vertex numbers from 0';

-- Scan patches. All but the constructor read the header alone.

CREATE FUNCTION ab_scan(origin float8[], points float8[], step float8 DEFAULT NULL, station bigint DEFAULT 0, quantum float8 DEFAULT 0.0001) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_make' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_scan(float8[], float8[], float8, bigint, float8) IS 'A patch from at most 4096 points (n x 3, world metres) seen from one origin; step is the angle between neighbouring beams in radians (estimated when NULL)';

CREATE FUNCTION ab_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_count(ab_scan) IS 'Number of beams, those without return included';

CREATE FUNCTION ab_return_count(patch ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_scan_returns' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_return_count(ab_scan) IS 'Number of beams with a return';

CREATE FUNCTION ab_origin(patch ab_scan) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_scan_origin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_origin(ab_scan) IS 'Where the beams start, world metres; NULL for points without origin';

CREATE FUNCTION ab_station(patch ab_scan) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_scan_station' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_station(ab_scan) IS 'The number of the scanner position';

CREATE FUNCTION ab_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box(ab_scan) IS 'Hull of the beams, origin included, grown by 0.15 m: the box that && compares';

CREATE FUNCTION ab_point_box(patch ab_scan) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_scan_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_point_box(ab_scan) IS 'Box of the returns alone';

-- Levels of accuracy and belief masses.

CREATE FUNCTION ab_loa_class(OUT loa ab_loa, OUT lower float8, OUT upper float8, OUT sigma float8, OUT source text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_loa_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION ab_loa_class() IS 'Bounds of the levels of accuracy, metres, held by 95 % (2 sigma) of deviations; sigma is upper/2';

CREATE FUNCTION ab_tolerance(loa ab_loa) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tolerance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_tolerance(ab_loa) IS 'Upper bound of a level of accuracy, metres: the tolerance of a verdict';

CREATE FUNCTION ab_mass(occupied float8, empty float8) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_make' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_mass(float8, float8) IS 'A belief mass; what is left of 1 is unknown';

CREATE FUNCTION ab_belief(mass ab_mass, hypothesis text DEFAULT 'occupied') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_belief' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_belief(ab_mass, text) IS 'Belief in ''occupied'' or ''empty''';

CREATE FUNCTION ab_plausibility(mass ab_mass, hypothesis text DEFAULT 'occupied') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_plausibility' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plausibility(ab_mass, text) IS 'Plausibility of ''occupied'' or ''empty'': belief plus the unknown mass';

CREATE FUNCTION ab_combine(m1 ab_mass, m2 ab_mass) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_combine' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine(ab_mass, ab_mass) IS 'Dempster''s rule for distinct sources; an error when they are in total conflict';

CREATE FUNCTION ab_conflict(m1 ab_mass, m2 ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_conflict' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_conflict(ab_mass, ab_mass) IS 'Mass that two sources put on contradictory hypotheses';

CREATE FUNCTION ab_ray_mass(origin float8[], point float8[], query float8[], kappa float8 DEFAULT 20000, lambda float8 DEFAULT 600, c float8 DEFAULT 3) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_ray_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ray_mass(float8[], float8[], float8[], float8, float8, float8) IS 'What one laser beam says at a query point, by the published ray model (Meyer 2022, 5.4 to 5.10, errata corrected)';

-- Evidence about a solid, and what follows from it.

CREATE FUNCTION ab_evidence_model(
    loa ab_loa DEFAULT 'LOA30', model text DEFAULT 'surface',
    spacing float8 DEFAULT NULL, sigma_range float8 DEFAULT NULL, sigma_angle float8 DEFAULT NULL, sigma_station float8 DEFAULT NULL,
    sigma_model float8 DEFAULT NULL, confidence float8 DEFAULT NULL, reliability float8 DEFAULT NULL, max_incidence float8 DEFAULT NULL,
    no_return_range float8 DEFAULT NULL, no_return_weight float8 DEFAULT NULL, kappa float8 DEFAULT NULL, lambda float8 DEFAULT NULL, c float8 DEFAULT NULL) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_evidence_model_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_evidence_model(ab_loa, text, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8) IS 'Parameters of evidence and verdict; what is not given keeps the default of a current terrestrial scanner. model: surface or meyer2022; lengths in metres, angles in radians';

CREATE FUNCTION ab_rollup(e1 ab_evidence, e2 ab_evidence) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_rollup(ab_evidence, ab_evidence) IS 'Adds up evidence about the same solid, exactly: as if all patches had been aggregated at once';

CREATE FUNCTION ab_summary(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL,
    OUT verdict text, OUT best_loa ab_loa, OUT samples bigint, OUT coverage float8,
    OUT confirmed float8, OUT refuted float8, OUT open float8, OUT conflict float8,
    OUT deviation float8, OUT deviation_sd float8, OUT shift text) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_summary' LANGUAGE c STABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_summary(ab_evidence, ab_loa, float8, float8, float8, float8) IS 'Verdict with the numbers that led to it: coverage is seen/all samples; confirmed, refuted and open are shares of the seen ones; deviation is the median of the worst well-seen face along its outward normal, metres; shift is the rigid offset along the directions that the seen faces determine';

CREATE FUNCTION ab_verdict(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_verdict' LANGUAGE c STABLE PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION ab_verdict(ab_evidence, ab_loa, float8, float8, float8, float8) IS 'confirmed, deviating, absent, unobserved or conflicting; at another level of accuracy or confidence than the evidence was made for, if asked';

CREATE FUNCTION ab_shift(
    e ab_evidence,
    OUT x float8, OUT y float8, OUT z float8, OUT x_sd float8, OUT y_sd float8, OUT z_sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_shift' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION ab_shift(ab_evidence) IS 'Rigid offset of the built object against the drawn one, metres; NULL along axes that the seen faces do not determine';

CREATE FUNCTION ab_samples(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    OUT "position" float8[], OUT normal float8[], OUT mass ab_mass,
    OUT deviation float8, OUT deviation_sd float8, OUT beams integer) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_samples' LANGUAGE c STABLE PARALLEL SAFE COST 100000 ROWS 10000;
COMMENT ON FUNCTION ab_samples(ab_evidence, ab_loa, float8) IS 'Every sample with its belief and its signed deviation (+ in front of the face); for heat maps';

CREATE FUNCTION ab_faces(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    OUT normal float8[], OUT samples bigint, OUT seen bigint, OUT confirmed bigint, OUT refuted bigint,
    OUT open bigint, OUT pierced bigint, OUT deviation float8, OUT deviation_sd float8) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_faces' LANGUAGE c STABLE PARALLEL SAFE COST 100000 ROWS 20;
COMMENT ON FUNCTION ab_faces(ab_evidence, ab_loa, float8) IS 'Every face of the solid with its share in the verdict';

CREATE FUNCTION ab_box(e ab_evidence) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_evidence_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box(ab_evidence) IS 'Box of the solid that the evidence is about';

CREATE FUNCTION ab_count(e ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_count(ab_evidence) IS 'Number of samples';

CREATE FUNCTION ab_station_count(e ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_station_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_station_count(ab_evidence) IS 'Number of stations that spoke';

CREATE FUNCTION ab_model(e ab_evidence) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_evidence_get_model' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_model(ab_evidence) IS 'The parameters that the evidence was made with';

-- Transition and its kin of the aggregates; not for direct use.

CREATE FUNCTION ab_evidence_accum(state internal, solid ab_solid, patch ab_scan, model ab_evidence_model) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION ab_evidence_accum(internal, ab_solid, ab_scan, ab_evidence_model) IS 'Transition of ab_evidence_agg';

CREATE FUNCTION ab_rollup_accum(state internal, e ab_evidence) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_rollup_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_rollup_accum(internal, ab_evidence) IS 'Transition of ab_rollup_agg';

CREATE FUNCTION ab_evidence_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_evidence_combine(internal, internal) IS 'Combine of ab_evidence_agg';

CREATE FUNCTION ab_evidence_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_evidence_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_evidence_serial(internal) IS 'Serialisation of ab_evidence_agg';

CREATE FUNCTION ab_evidence_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_evidence_deserial(bytea, internal) IS 'Deserialisation of ab_evidence_agg';

CREATE FUNCTION ab_evidence_final(state internal) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_evidence_final(internal) IS 'Final of ab_evidence_agg';

CREATE AGGREGATE ab_evidence_agg(solid ab_solid, patch ab_scan, model ab_evidence_model) (
    SFUNC = ab_evidence_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_evidence_combine, SERIALFUNC = ab_evidence_serial, DESERIALFUNC = ab_evidence_deserial,
    FINALFUNC = ab_evidence_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_evidence_agg(ab_solid, ab_scan, ab_evidence_model) IS
    'What the beams of all patches say about one solid. A NULL patch adds nothing but keeps the object: it comes out as unobserved';

CREATE AGGREGATE ab_rollup_agg(e ab_evidence) (
    SFUNC = ab_rollup_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_evidence_combine, SERIALFUNC = ab_evidence_serial, DESERIALFUNC = ab_evidence_deserial,
    FINALFUNC = ab_evidence_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_rollup_agg(ab_evidence) IS 'Adds up evidence about the same solid, exactly';

-- Operators: && boxes overlap.

CREATE FUNCTION ab_equal(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_equal' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_box, ab_box) IS 'Same box';

CREATE FUNCTION ab_equal(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_equal' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_mass, ab_mass) IS 'Same mass, bit by bit';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_scan, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_scan, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_scan, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_scan, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_box, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_box, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_scan, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_box, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_solid, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_solid, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_scan, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_solid, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_scan, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_scan, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_scan, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_scan, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR ~= (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_equal, COMMUTATOR = ~=,
    RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_box, ab_box) IS 'Same box';
CREATE OPERATOR ~= (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_equal, COMMUTATOR = ~=,
    RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_mass, ab_mass) IS 'Same mass, bit by bit';

-- GiST operator classes. Keys are boxes; strategy numbers say the right-hand type.

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_box, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_box, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_solid, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_solid, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_scan, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_scan, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_union(entries internal, size internal) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_gist_union' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_union(internal, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_scan_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_scan_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_scan_compress(internal) IS 'GiST support';

CREATE FUNCTION ab_gist_solid_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_solid_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_solid_compress(internal) IS 'GiST support';

CREATE FUNCTION ab_gist_penalty(key internal, entry internal, result internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_penalty' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_penalty(internal, internal, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_picksplit(entries internal, result internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_picksplit' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_picksplit(internal, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_same(a ab_box, b ab_box, result internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_same(ab_box, ab_box, internal) IS 'GiST support';

CREATE OPERATOR CLASS ab_box_gist_ops DEFAULT FOR TYPE ab_box USING gist AS
    OPERATOR 1 && (ab_box, ab_box), OPERATOR 2 && (ab_box, ab_solid), OPERATOR 3 && (ab_box, ab_scan),
    FUNCTION 1 ab_gist_consistent(internal, ab_box, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal);
COMMENT ON OPERATOR CLASS ab_box_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_solid_gist_ops DEFAULT FOR TYPE ab_solid USING gist AS
    OPERATOR 1 && (ab_solid, ab_box), OPERATOR 2 && (ab_solid, ab_solid), OPERATOR 3 && (ab_solid, ab_scan),
    FUNCTION 1 ab_gist_consistent(internal, ab_solid, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_solid_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_solid_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_scan_gist_ops DEFAULT FOR TYPE ab_scan USING gist AS
    OPERATOR 1 && (ab_scan, ab_box), OPERATOR 2 && (ab_scan, ab_solid), OPERATOR 3 && (ab_scan, ab_scan),
    FUNCTION 1 ab_gist_consistent(internal, ab_scan, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_scan_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_scan_gist_ops USING gist IS 'Joins on && by boxes';

-- Uncertain points, lines, planes and poses: constructors, accessors, constructions. Independent objects.

CREATE FUNCTION ab_point(x float8, y float8, z float8, sd float8 DEFAULT 0, covariance float8[] DEFAULT NULL) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_point_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_point(float8, float8, float8, float8, float8[]) IS 'A point, metres, with one standard deviation for every axis or with a 3 x 3 covariance (as 3 x 3 or 9 numbers)';

CREATE FUNCTION ab_line(start float8[], "end" float8[], covariance float8[] DEFAULT NULL) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_line(float8[], float8[], float8[]) IS 'A line between two places, with the 6 x 6 covariance of both ends (none: exact)';

CREATE FUNCTION ab_line(a ab_point, b ab_point) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_join' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_line(ab_point, ab_point) IS 'The line through two points';

CREATE FUNCTION ab_plane(point float8[], normal float8[], sd_offset float8 DEFAULT 0, sd_tilt float8 DEFAULT 0, covariance float8[] DEFAULT NULL) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_plane(float8[], float8[], float8, float8, float8[]) IS 'A plane through a place with a normal; standard deviations of its offset (metres) and of its tilt about any axis in it (radians), or the 4 x 4 covariance of (unit normal, offset)';

CREATE FUNCTION ab_plane(a ab_point, b ab_point, c ab_point) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_join' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plane(ab_point, ab_point, ab_point) IS 'The plane through three points, its normal by the right hand';

CREATE FUNCTION ab_plane(line ab_line, point ab_point) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_join_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plane(ab_line, ab_point) IS 'The plane through a line and a point';

CREATE FUNCTION ab_pose(translation float8[], rotation float8[] DEFAULT '{1,0,0,0}', scale float8 DEFAULT 1, sd_rotation float8 DEFAULT 0, sd_translation float8 DEFAULT 0, sd_scale float8 DEFAULT 0, covariance float8[] DEFAULT NULL) RETURNS ab_pose
    AS 'MODULE_PATHNAME', 'ab_pose_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_pose(float8[], float8[], float8, float8, float8, float8, float8[]) IS 'A transform from a translation, a quaternion w,x,y,z (made a unit) and a scale, with standard deviations (radians, metres, relative) or the 7 x 7 covariance of (rotation, translation, scale)';

CREATE FUNCTION ab_numbers(point ab_point) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_point_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_numbers(ab_point) IS 'All 9 numbers of the value, as in its text form';

CREATE FUNCTION ab_point_of(numbers float8[]) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_point_from_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_point_of(float8[]) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE CAST (ab_point AS float8[]) WITH FUNCTION ab_numbers(ab_point);
COMMENT ON CAST (ab_point AS float8[]) IS 'All its numbers';
CREATE CAST (float8[] AS ab_point) WITH FUNCTION ab_point_of(float8[]);
COMMENT ON CAST (float8[] AS ab_point) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE FUNCTION ab_covariance(point ab_point) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_point_covariance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_covariance(ab_point) IS '3 x 3, m2';

CREATE FUNCTION ab_numbers(line ab_line) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_line_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_numbers(ab_line) IS 'All 27 numbers of the value, as in its text form';

CREATE FUNCTION ab_line_of(numbers float8[]) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_from_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_line_of(float8[]) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE CAST (ab_line AS float8[]) WITH FUNCTION ab_numbers(ab_line);
COMMENT ON CAST (ab_line AS float8[]) IS 'All its numbers';
CREATE CAST (float8[] AS ab_line) WITH FUNCTION ab_line_of(float8[]);
COMMENT ON CAST (float8[] AS ab_line) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE FUNCTION ab_covariance(line ab_line) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_line_covariance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_covariance(ab_line) IS 'Of (start, end), 6 x 6, m2';

CREATE FUNCTION ab_numbers(plane ab_plane) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_plane_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_numbers(ab_plane) IS 'All 16 numbers of the value, as in its text form';

CREATE FUNCTION ab_plane_of(numbers float8[]) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_from_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plane_of(float8[]) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE CAST (ab_plane AS float8[]) WITH FUNCTION ab_numbers(ab_plane);
COMMENT ON CAST (ab_plane AS float8[]) IS 'All its numbers';
CREATE CAST (float8[] AS ab_plane) WITH FUNCTION ab_plane_of(float8[]);
COMMENT ON CAST (float8[] AS ab_plane) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE FUNCTION ab_covariance(plane ab_plane) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_plane_covariance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_covariance(ab_plane) IS 'Of (normal, offset), 4 x 4';

CREATE FUNCTION ab_numbers(pose ab_pose) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_pose_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_numbers(ab_pose) IS 'All 36 numbers of the value, as in its text form';

CREATE FUNCTION ab_pose_of(numbers float8[]) RETURNS ab_pose
    AS 'MODULE_PATHNAME', 'ab_pose_from_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_pose_of(float8[]) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE CAST (ab_pose AS float8[]) WITH FUNCTION ab_numbers(ab_pose);
COMMENT ON CAST (ab_pose AS float8[]) IS 'All its numbers';
CREATE CAST (float8[] AS ab_pose) WITH FUNCTION ab_pose_of(float8[]);
COMMENT ON CAST (float8[] AS ab_pose) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE FUNCTION ab_covariance(pose ab_pose) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_pose_covariance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_covariance(ab_pose) IS 'Of (rotation, translation, scale), 7 x 7';

CREATE FUNCTION ab_x(point ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_x' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_x(ab_point) IS 'First coordinate, metres';

CREATE FUNCTION ab_y(point ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_y' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_y(ab_point) IS 'Second coordinate, metres';

CREATE FUNCTION ab_z(point ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_z' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_z(ab_point) IS 'Third coordinate, metres';

CREATE FUNCTION ab_position(point ab_point) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_point_position' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_position(ab_point) IS 'Coordinates, metres';

CREATE FUNCTION ab_position(plane ab_plane) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_plane_position' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_position(ab_plane) IS 'The point where offset and tilt of the plane are uncorrelated, metres';

CREATE FUNCTION ab_normal(plane ab_plane) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_plane_normal' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_normal(ab_plane) IS 'Unit normal';

CREATE FUNCTION ab_start(line ab_line) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_line_start' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_start(ab_line) IS 'First end with its covariance';

CREATE FUNCTION ab_end(line ab_line) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_line_end' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_end(ab_line) IS 'Second end with its covariance';

CREATE FUNCTION ab_direction(line ab_line) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_line_direction' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_direction(ab_line) IS 'Unit vector from start to end';

CREATE FUNCTION ab_plucker(line ab_line, reference float8[] DEFAULT '{0,0,0}', OUT line float8[], OUT covariance float8[]) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_line_plucker' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plucker(ab_line, float8[]) IS 'Homogeneous Pluecker line (Y - X, X x Y) about a reference point and its 6 x 6 covariance; choose the reference near the line';

CREATE FUNCTION ab_translation(pose ab_pose) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_pose_translation' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_translation(ab_pose) IS 'Translation, metres';

CREATE FUNCTION ab_rotation(pose ab_pose) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_pose_rotation' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_rotation(ab_pose) IS 'Unit quaternion w,x,y,z';

CREATE FUNCTION ab_scale(pose ab_pose) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_pose_scale' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_scale(ab_pose) IS 'Scale';

CREATE FUNCTION ab_sd(point ab_point) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_point_sd' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_sd(ab_point) IS 'Standard deviation along each axis, metres';

CREATE FUNCTION ab_ellipsoid(point ab_point, probability float8 DEFAULT 0.95, OUT half_axis float8, OUT direction float8[]) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_point_ellipsoid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 3;
COMMENT ON FUNCTION ab_ellipsoid(ab_point, float8) IS 'The ellipsoid that holds the true point with this probability: half-axes by falling length, metres, with their directions';

CREATE FUNCTION ab_box(point ab_point, probability float8 DEFAULT 0.95) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box(ab_point, float8) IS 'The box around the ellipsoid that holds the true point with this probability';

CREATE FUNCTION ab_box(line ab_line, probability float8 DEFAULT 0.95) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_line_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box(ab_line, float8) IS 'The box around the confidence ellipsoids of both ends';

CREATE FUNCTION ab_mahalanobis(a ab_point, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_mahalanobis' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_mahalanobis(ab_point, ab_point) IS 'Mahalanobis distance of two points; infinite where they differ in a direction without variance';

-- Constructions.

CREATE FUNCTION ab_midpoint(a ab_point, b ab_point) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_midpoint_points' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_midpoint(ab_point, ab_point) IS 'The point halfway';

CREATE FUNCTION ab_midpoint(line ab_line) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_midpoint_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_midpoint(ab_line) IS 'The point halfway between the ends';

CREATE FUNCTION ab_intersection(a ab_plane, b ab_plane) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_intersection_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_intersection(ab_plane, ab_plane) IS 'The line in which two planes meet, one metre long, near their points; uncertain across itself';

CREATE FUNCTION ab_intersection(a ab_plane, b ab_plane, c ab_plane) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_intersection_three' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_intersection(ab_plane, ab_plane, ab_plane) IS 'The point in which three planes meet';

CREATE FUNCTION ab_intersection(line ab_line, plane ab_plane) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_intersection_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_intersection(ab_line, ab_plane) IS 'The point in which a line, endless, meets a plane';

CREATE FUNCTION ab_foot(point ab_point, plane ab_plane) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_foot_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_foot(ab_point, ab_plane) IS 'The point of a plane nearest to a point';

CREATE FUNCTION ab_foot(point ab_point, line ab_line) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_foot_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_foot(ab_point, ab_line) IS 'The point of an endless line nearest to a point';

CREATE FUNCTION ab_distance(a ab_point, b ab_point, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_points' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_distance(ab_point, ab_point) IS 'Distance with its standard deviation, metres; where it is nought, that of the most uncertain direction';

CREATE FUNCTION ab_distance(point ab_point, plane ab_plane, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_distance(ab_point, ab_plane) IS 'Height in front of a plane (negative behind) with its standard deviation, metres';

CREATE FUNCTION ab_distance(point ab_point, line ab_line, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_distance(ab_point, ab_line) IS 'Distance from an endless line with its standard deviation, metres';

CREATE FUNCTION ab_distance(a ab_line, b ab_line, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_distance(ab_line, ab_line) IS 'Distance of two endless lines with its standard deviation, metres';

CREATE FUNCTION ab_transform(point ab_point, pose ab_pose) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_transform_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_transform(ab_point, ab_pose) IS 'Its image, with the covariances of both';

CREATE FUNCTION ab_transform(line ab_line, pose ab_pose) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_transform_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_transform(ab_line, ab_pose) IS 'Its image, with the covariances of both';

CREATE FUNCTION ab_transform(plane ab_plane, pose ab_pose) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_transform_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_transform(ab_plane, ab_pose) IS 'Its image, with the covariances of both';

CREATE FUNCTION ab_transform(first ab_pose, pose ab_pose) RETURNS ab_pose
    AS 'MODULE_PATHNAME', 'ab_transform_pose' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_transform(ab_pose, ab_pose) IS 'One transform after the other, with the covariances of both';

CREATE FUNCTION ab_transform(solid ab_solid, pose ab_pose) RETURNS ab_solid
    AS 'MODULE_PATHNAME', 'ab_transform_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_transform(ab_solid, ab_pose) IS 'Its image; a solid carries no covariance';

CREATE FUNCTION ab_inverse(pose ab_pose) RETURNS ab_pose
    AS 'MODULE_PATHNAME', 'ab_pose_inverse' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_inverse(ab_pose) IS 'The transform back, with covariance';

-- Best fits. Points without any uncertainty weigh alike and give it by their residuals.

CREATE FUNCTION ab_points_accum(state internal, point ab_point) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_points_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_points_accum(internal, ab_point) IS 'Transition of ab_line_agg and ab_plane_agg';

CREATE FUNCTION ab_points_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_points_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_points_combine(internal, internal) IS 'Combine of ab_line_agg and ab_plane_agg';

CREATE FUNCTION ab_points_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_points_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_points_serial(internal) IS 'Serialisation of ab_line_agg and ab_plane_agg';

CREATE FUNCTION ab_points_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_points_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_points_deserial(bytea, internal) IS 'Deserialisation of ab_line_agg and ab_plane_agg';

CREATE FUNCTION ab_line_agg_final(state internal) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_fit' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_line_agg_final(internal) IS 'Final of ab_line_agg';

CREATE FUNCTION ab_plane_agg_final(state internal) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_fit' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION ab_plane_agg_final(internal) IS 'Final of ab_plane_agg';

CREATE AGGREGATE ab_line_agg(point ab_point) (
    SFUNC = ab_points_accum, STYPE = internal, SSPACE = 100000,
    COMBINEFUNC = ab_points_combine, SERIALFUNC = ab_points_serial, DESERIALFUNC = ab_points_deserial,
    FINALFUNC = ab_line_agg_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_line_agg(ab_point) IS 'The line that fits the points best, by maximum likelihood with their own covariances. Points without any give it by their residuals, used as if known: few points make it too sure';

CREATE FUNCTION ab_line(points ab_point[]) RETURNS ab_line
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN (SELECT ab_line_agg(p) FROM unnest(points) p);
COMMENT ON FUNCTION ab_line(ab_point[]) IS 'The line that fits the points best';

CREATE AGGREGATE ab_plane_agg(point ab_point) (
    SFUNC = ab_points_accum, STYPE = internal, SSPACE = 100000,
    COMBINEFUNC = ab_points_combine, SERIALFUNC = ab_points_serial, DESERIALFUNC = ab_points_deserial,
    FINALFUNC = ab_plane_agg_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_plane_agg(ab_point) IS 'The plane that fits the points best, by maximum likelihood with their own covariances. Points without any give it by their residuals, used as if known: few points make it too sure';

CREATE FUNCTION ab_plane(points ab_point[]) RETURNS ab_plane
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN (SELECT ab_plane_agg(p) FROM unnest(points) p);
COMMENT ON FUNCTION ab_plane(ab_point[]) IS 'The plane that fits the points best';

-- Statistical tests of relations between uncertain, independent objects.

CREATE FUNCTION ab_test_same(a ab_point, b ab_point, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_same_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_same(ab_point, ab_point) IS 'Are two points the same? 3 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_same(a ab_point, b ab_point, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_same_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_same(ab_point, ab_point, float8) IS 'Are two points the same? True unless rejected at this significance';

CREATE FUNCTION ab_test_same(a ab_plane, b ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_same_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_same(ab_plane, ab_plane) IS 'Are two planes the same, whichever way they face? 3 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_same(a ab_plane, b ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_same_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_same(ab_plane, ab_plane, float8) IS 'Are two planes the same, whichever way they face? True unless rejected at this significance';

CREATE FUNCTION ab_test_incident(point ab_point, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_point_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_incident(ab_point, ab_line) IS 'Does a point lie on an endless line? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_incident(point ab_point, line ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_point_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_incident(ab_point, ab_line, float8) IS 'Does a point lie on an endless line? True unless rejected at this significance';

CREATE FUNCTION ab_test_incident(point ab_point, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_point_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_incident(ab_point, ab_plane) IS 'Does a point lie on a plane? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_incident(point ab_point, plane ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_point_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_incident(ab_point, ab_plane, float8) IS 'Does a point lie on a plane? True unless rejected at this significance';

CREATE FUNCTION ab_test_incident(line ab_line, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_incident(ab_line, ab_plane) IS 'Does a line lie in a plane? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_incident(line ab_line, plane ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_incident(ab_line, ab_plane, float8) IS 'Does a line lie in a plane? True unless rejected at this significance';

CREATE FUNCTION ab_test_parallel(a ab_line, b ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_parallel_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_parallel(ab_line, ab_line) IS 'Are two lines parallel? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_parallel(a ab_line, b ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_parallel_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_parallel(ab_line, ab_line, float8) IS 'Are two lines parallel? True unless rejected at this significance';

CREATE FUNCTION ab_test_parallel(a ab_plane, b ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_parallel_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_parallel(ab_plane, ab_plane) IS 'Are two planes parallel? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_parallel(a ab_plane, b ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_parallel_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_parallel(ab_plane, ab_plane, float8) IS 'Are two planes parallel? True unless rejected at this significance';

CREATE FUNCTION ab_test_parallel(line ab_line, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_parallel_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_parallel(ab_line, ab_plane) IS 'Is a line parallel to a plane? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_parallel(line ab_line, plane ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_parallel_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_parallel(ab_line, ab_plane, float8) IS 'Is a line parallel to a plane? True unless rejected at this significance';

CREATE FUNCTION ab_test_orthogonal(a ab_line, b ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_orthogonal(ab_line, ab_line) IS 'Are two lines, perhaps skew, orthogonal? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_orthogonal(a ab_line, b ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_orthogonal_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_orthogonal(ab_line, ab_line, float8) IS 'Are two lines, perhaps skew, orthogonal? True unless rejected at this significance';

CREATE FUNCTION ab_test_orthogonal(a ab_plane, b ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_orthogonal(ab_plane, ab_plane) IS 'Are two planes orthogonal? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_orthogonal(a ab_plane, b ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_orthogonal_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_orthogonal(ab_plane, ab_plane, float8) IS 'Are two planes orthogonal? True unless rejected at this significance';

CREATE FUNCTION ab_test_orthogonal(line ab_line, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_orthogonal(ab_line, ab_plane) IS 'Is a line orthogonal to a plane? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_orthogonal(line ab_line, plane ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_orthogonal_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_orthogonal(ab_line, ab_plane, float8) IS 'Is a line orthogonal to a plane? True unless rejected at this significance';

CREATE FUNCTION ab_test_coplanar(a ab_line, b ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_coplanar_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_coplanar(ab_line, ab_line) IS 'Do two endless lines lie in one plane? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_coplanar(a ab_line, b ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_coplanar_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_coplanar(ab_line, ab_line, float8) IS 'Do two endless lines lie in one plane? True unless rejected at this significance';

-- The same with the arguments the other way round.

CREATE FUNCTION ab_test_incident(line ab_line, point ab_point, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM ab_test_incident(point, line) t; END;
COMMENT ON FUNCTION ab_test_incident(ab_line, ab_point) IS 'Does a point lie on an endless line? 2 degrees of freedom, arguments the other way round';

CREATE FUNCTION ab_is_incident(line ab_line, point ab_point, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_incident(point, line, significance);
COMMENT ON FUNCTION ab_is_incident(ab_line, ab_point, float8) IS 'Does a point lie on an endless line? Arguments the other way round';

CREATE FUNCTION ab_test_incident(plane ab_plane, point ab_point, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM ab_test_incident(point, plane) t; END;
COMMENT ON FUNCTION ab_test_incident(ab_plane, ab_point) IS 'Does a point lie on a plane? 1 degree of freedom, arguments the other way round';

CREATE FUNCTION ab_is_incident(plane ab_plane, point ab_point, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_incident(point, plane, significance);
COMMENT ON FUNCTION ab_is_incident(ab_plane, ab_point, float8) IS 'Does a point lie on a plane? Arguments the other way round';

CREATE FUNCTION ab_test_incident(plane ab_plane, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM ab_test_incident(line, plane) t; END;
COMMENT ON FUNCTION ab_test_incident(ab_plane, ab_line) IS 'Does a line lie in a plane? 2 degrees of freedom, arguments the other way round';

CREATE FUNCTION ab_is_incident(plane ab_plane, line ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_incident(line, plane, significance);
COMMENT ON FUNCTION ab_is_incident(ab_plane, ab_line, float8) IS 'Does a line lie in a plane? Arguments the other way round';

CREATE FUNCTION ab_test_parallel(plane ab_plane, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM ab_test_parallel(line, plane) t; END;
COMMENT ON FUNCTION ab_test_parallel(ab_plane, ab_line) IS 'Is a line parallel to a plane? 1 degree of freedom, arguments the other way round';

CREATE FUNCTION ab_is_parallel(plane ab_plane, line ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_parallel(line, plane, significance);
COMMENT ON FUNCTION ab_is_parallel(ab_plane, ab_line, float8) IS 'Is a line parallel to a plane? Arguments the other way round';

CREATE FUNCTION ab_test_orthogonal(plane ab_plane, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM ab_test_orthogonal(line, plane) t; END;
COMMENT ON FUNCTION ab_test_orthogonal(ab_plane, ab_line) IS 'Is a line orthogonal to a plane? 2 degrees of freedom, arguments the other way round';

CREATE FUNCTION ab_is_orthogonal(plane ab_plane, line ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_orthogonal(line, plane, significance);
COMMENT ON FUNCTION ab_is_orthogonal(ab_plane, ab_line, float8) IS 'Is a line orthogonal to a plane? Arguments the other way round';

CREATE FUNCTION ab_distance(plane ab_plane, point ab_point, OUT distance float8, OUT sd float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.distance, t.sd FROM ab_distance(point, plane) t; END;
COMMENT ON FUNCTION ab_distance(ab_plane, ab_point) IS 'As ab_distance(point, plane)';

CREATE FUNCTION ab_distance(line ab_line, point ab_point, OUT distance float8, OUT sd float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.distance, t.sd FROM ab_distance(point, line) t; END;
COMMENT ON FUNCTION ab_distance(ab_line, ab_point) IS 'As ab_distance(point, line)';

CREATE FUNCTION ab_intersection(plane ab_plane, line ab_line) RETURNS ab_point
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_intersection(line, plane);
COMMENT ON FUNCTION ab_intersection(ab_plane, ab_line) IS 'As ab_intersection(line, plane)';

-- The belief calculus: rules, measures, sensors, accuracy.

CREATE FUNCTION ab_combine(m1 ab_mass, m2 ab_mass, rule text) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_combine_by' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine(ab_mass, ab_mass, text) IS 'Two sources by a rule: dempster, conjunctive, disjunctive, yager, dubois_prade (as yager on two hypotheses), pcr6, murphy or cautious';

CREATE FUNCTION ab_contradiction(mass ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_contradiction' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_contradiction(ab_mass) IS 'Mass of the empty set: what the conjunctive rule leaves to contradiction';

CREATE FUNCTION ab_discount(mass ab_mass, reliability float8) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_discount' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_discount(ab_mass, float8) IS 'The mass of a source that is reliable with this probability: the rest goes to unknown';

CREATE FUNCTION ab_pignistic(mass ab_mass, hypothesis text DEFAULT 'occupied') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_pignistic' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_pignistic(ab_mass, text) IS 'Pignistic probability: the unknown mass shared out, contradiction divided out';

CREATE FUNCTION ab_nonspecificity(mass ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_nonspecificity' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_nonspecificity(ab_mass) IS 'Nonspecificity, bits: how much is not known';

CREATE FUNCTION ab_discord(mass ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_discord' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_discord(ab_mass) IS 'Discord, bits (Klir and Ramer 1990): how much the mass contradicts itself';

CREATE FUNCTION ab_decide(mass ab_mass, criterion text DEFAULT 'belief', threshold float8 DEFAULT 0.95) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_mass_decide' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_decide(ab_mass, text, float8) IS 'occupied, empty or unknown: the hypothesis whose belief, plausibility or pignistic probability reaches the threshold and exceeds the other ones';

-- Any number of sources.

CREATE FUNCTION ab_combine_accum(state internal, mass ab_mass) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_accum(internal, ab_mass) IS 'Transition of ab_combine_agg';

CREATE FUNCTION ab_combine_accum(state internal, mass ab_mass, rule text) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_accum_by' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_accum(internal, ab_mass, text) IS 'Transition of ab_combine_agg with a rule';

CREATE FUNCTION ab_combine_accum(state internal, mass ab_mass, rule text, reliability float8) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_accum_by' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_accum(internal, ab_mass, text, float8) IS 'Transition of ab_combine_agg with a rule and reliabilities';

CREATE FUNCTION ab_combine_merge(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_merge' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_merge(internal, internal) IS 'Combine of ab_combine_agg';

CREATE FUNCTION ab_combine_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_combine_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_serial(internal) IS 'Serialisation of ab_combine_agg';

CREATE FUNCTION ab_combine_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_deserial(bytea, internal) IS 'Deserialisation of ab_combine_agg';

CREATE FUNCTION ab_combine_final(state internal) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_combine_final' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_final(internal) IS 'Final of ab_combine_agg';

CREATE AGGREGATE ab_combine_agg(mass ab_mass) (
    SFUNC = ab_combine_accum, STYPE = internal, SSPACE = 200,
    COMBINEFUNC = ab_combine_merge, SERIALFUNC = ab_combine_serial, DESERIALFUNC = ab_combine_deserial,
    FINALFUNC = ab_combine_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_combine_agg(ab_mass) IS 'Dempsters rule over any number of distinct sources, in any order and by parallel workers';

CREATE AGGREGATE ab_combine_agg(mass ab_mass, rule text) (
    SFUNC = ab_combine_accum, STYPE = internal, SSPACE = 200,
    COMBINEFUNC = ab_combine_merge, SERIALFUNC = ab_combine_serial, DESERIALFUNC = ab_combine_deserial,
    FINALFUNC = ab_combine_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_combine_agg(ab_mass, text) IS 'Any number of sources by a rule, all at once and in any order: all rules but pcr6, which needs every combination of its sources; for it combine two by two with ab_combine, in an order you state. A row with a NULL adds nothing';

CREATE AGGREGATE ab_combine_agg(mass ab_mass, rule text, reliability float8) (
    SFUNC = ab_combine_accum, STYPE = internal, SSPACE = 200,
    COMBINEFUNC = ab_combine_merge, SERIALFUNC = ab_combine_serial, DESERIALFUNC = ab_combine_deserial,
    FINALFUNC = ab_combine_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_combine_agg(ab_mass, text, float8) IS 'The same, every source discounted by its reliability';

-- Sensors: what one observation says at a query point.

CREATE FUNCTION ab_kappa(spacing float8) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_kappa' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_kappa(float8) IS 'Decay across a ray, 1/m2, for which the kernel halves one point spacing (m) away: ln 2/spacing2';

CREATE FUNCTION ab_lambda(sigma float8, c float8 DEFAULT 3) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_lambda' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lambda(float8, float8) IS 'Steepness along a ray, 1/m, for which the occupied band is 2 sigma (m) thick on either side: c/(2 sigma)';

CREATE FUNCTION ab_image_mass(origin float8[], point float8[], query float8[], kappa float8 DEFAULT 15000, lambda float8 DEFAULT 800, c float8 DEFAULT 5) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_ray_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_image_mass(float8[], float8[], float8[], float8, float8, float8) IS 'What an image ray to a point says at a query point: the ray model with its settings for images';

CREATE FUNCTION ab_tie_point_mass(origin float8[], point ab_point, query float8[], kappa float8 DEFAULT 15000, lambda float8 DEFAULT 800, c float8 DEFAULT 5) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_tie_point_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_tie_point_mass(float8[], ab_point, float8[], float8, float8, float8) IS 'What a tie point with its covariance, seen from a camera at origin, says at a query point: the ray model widened by the points own uncertainty along and across the ray';

CREATE FUNCTION ab_dense_mass(point float8[], normal float8[], query float8[], kappa float8 DEFAULT 6000, lambda float8 DEFAULT 1200, c float8 DEFAULT 5) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_dense_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_dense_mass(float8[], float8[], float8[], float8, float8, float8) IS 'What a point of a dense cloud with a face normal says at a query point: occupied or unknown (Meyer 2022, 5.12, 5.13)';

CREATE FUNCTION ab_surface_mass(deviation float8, sd float8, tolerance float8, coverage float8 DEFAULT 1, hit_share float8 DEFAULT 1, reliability float8 DEFAULT 0.99) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_surface_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_surface_mass(float8, float8, float8, float8, float8, float8) IS 'Mass that the built surface lies within the tolerance of the face, from a mean deviation (metres, + in front) with its standard deviation: the model surface';

-- Accuracy.

CREATE FUNCTION ab_loa_confidence(loa ab_loa, within float8) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_loa_confidence' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_loa_confidence(ab_loa, float8) IS 'Probability that a model of this level lies within this distance, metres';

CREATE FUNCTION ab_convert_belief(belief float8, sigma float8, sigma_to float8) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_convert_belief' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief(float8, float8, float8) IS 'A belief that holds within one standard deviation, as what it is worth within another, by quantiles';

CREATE FUNCTION ab_convert_belief(belief float8, sigma float8, loa ab_loa) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_convert_belief_loa' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief(float8, float8, ab_loa) IS 'The same for a level of accuracy: its standard deviation is half its upper bound';

CREATE FUNCTION ab_convert_belief_linear(belief float8, sigma float8, sigma_to float8, divisor float8 DEFAULT 0.682689492137086, OUT belief_to float8, OUT capped boolean) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_convert_belief_linear' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief_linear(float8, float8, float8, float8) IS 'The published linear form, for comparison: can exceed 1 and is then capped and marked. Meyer 2022 divides by 2 Phi(1) - 1 in eq. 5.24 and by 0.95 in table 5.4';

CREATE FUNCTION ab_relative_tolerance(t1 float8, t2 float8, rule text DEFAULT 'squared') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_relative_tolerance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_relative_tolerance(float8, float8, text) IS 'Tolerance of one object against another, from theirs: squared or linear';

CREATE FUNCTION ab_is_fit(sigma float8, tolerance float8, purpose text DEFAULT 'loa') RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_fit' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_fit(float8, float8, text) IS 'Is a sensor of this standard deviation fit: at most a fifth of the tolerance to tell levels of accuracy (loa), a fifteenth to prove a tolerance (proof)';

CREATE FUNCTION ab_din18710_class(OUT class text, OUT lower float8, OUT upper float8, OUT source text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_din18710_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION ab_din18710_class() IS 'DIN 18710-1 classes of positional accuracy: bounds of ONE standard deviation, metres. Not levels of accuracy, which bound two';

-- Comparison, hashing and indexes of uncertain objects and masses.

CREATE FUNCTION ab_equal(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_point, ab_point) IS 'Same numbers';

CREATE FUNCTION ab_differ(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_point, ab_point) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(point ab_point) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_point_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_point) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(point ab_point, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_point_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_point, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_point, ab_point) IS 'Same numbers, covariance included';
CREATE OPERATOR <> (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_point, ab_point) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_point_hash_ops DEFAULT FOR TYPE ab_point USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_point), FUNCTION 2 ab_hash(ab_point, bigint);
COMMENT ON OPERATOR CLASS ab_point_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_equal(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_line, ab_line) IS 'Same numbers';

CREATE FUNCTION ab_differ(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_line, ab_line) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(line ab_line) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_line_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_line) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(line ab_line, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_line_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_line, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_line, ab_line) IS 'Same numbers, covariance included';
CREATE OPERATOR <> (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_line, ab_line) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_line_hash_ops DEFAULT FOR TYPE ab_line USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_line), FUNCTION 2 ab_hash(ab_line, bigint);
COMMENT ON OPERATOR CLASS ab_line_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_equal(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_plane, ab_plane) IS 'Same numbers';

CREATE FUNCTION ab_differ(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_plane, ab_plane) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(plane ab_plane) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_plane_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_plane) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(plane ab_plane, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_plane_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_plane, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_plane, ab_plane) IS 'Same numbers, covariance included';
CREATE OPERATOR <> (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_plane, ab_plane) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_plane_hash_ops DEFAULT FOR TYPE ab_plane USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_plane), FUNCTION 2 ab_hash(ab_plane, bigint);
COMMENT ON OPERATOR CLASS ab_plane_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_equal(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_pose, ab_pose) IS 'Same numbers';

CREATE FUNCTION ab_differ(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_pose, ab_pose) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(pose ab_pose) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_pose_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_pose) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(pose ab_pose, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_pose_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_pose, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_pose, ab_pose) IS 'Same numbers, covariance included';
CREATE OPERATOR <> (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_pose, ab_pose) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_pose_hash_ops DEFAULT FOR TYPE ab_pose USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_pose), FUNCTION 2 ab_hash(ab_pose, bigint);
COMMENT ON OPERATOR CLASS ab_pose_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_differ(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_mass, ab_mass) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(mass ab_mass) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_mass_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_mass) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(mass ab_mass, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_mass_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_mass, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_mass, ab_mass) IS 'Same numbers';
CREATE OPERATOR <> (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_mass, ab_mass) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_mass_hash_ops DEFAULT FOR TYPE ab_mass USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_mass), FUNCTION 2 ab_hash(ab_mass, bigint);
COMMENT ON OPERATOR CLASS ab_mass_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_lt(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_point, ab_point) IS 'Before in the order of x, y, z, covariance';
CREATE OPERATOR < (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_point, ab_point) IS 'Before in the order of x, y, z, covariance';

CREATE FUNCTION ab_le(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_point, ab_point) IS 'Not after in the order of x, y, z, covariance';
CREATE OPERATOR <= (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_point, ab_point) IS 'Not after in the order of x, y, z, covariance';

CREATE FUNCTION ab_ge(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_point, ab_point) IS 'Not before in the order of x, y, z, covariance';
CREATE OPERATOR >= (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_point, ab_point) IS 'Not before in the order of x, y, z, covariance';

CREATE FUNCTION ab_gt(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_point, ab_point) IS 'After in the order of x, y, z, covariance';
CREATE OPERATOR > (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_point, ab_point) IS 'After in the order of x, y, z, covariance';

CREATE FUNCTION ab_compare(a ab_point, b ab_point) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_point_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_point, ab_point) IS '-1, 0 or 1 in the order of x, y, z, covariance';

CREATE OPERATOR CLASS ab_point_ops DEFAULT FOR TYPE ab_point USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_point, ab_point);
COMMENT ON OPERATOR CLASS ab_point_ops USING btree IS 'Order by x, y, z, covariance';

CREATE FUNCTION ab_lt(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_line, ab_line) IS 'Before in the order of start, end, covariance';
CREATE OPERATOR < (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_line, ab_line) IS 'Before in the order of start, end, covariance';

CREATE FUNCTION ab_le(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_line, ab_line) IS 'Not after in the order of start, end, covariance';
CREATE OPERATOR <= (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_line, ab_line) IS 'Not after in the order of start, end, covariance';

CREATE FUNCTION ab_ge(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_line, ab_line) IS 'Not before in the order of start, end, covariance';
CREATE OPERATOR >= (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_line, ab_line) IS 'Not before in the order of start, end, covariance';

CREATE FUNCTION ab_gt(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_line, ab_line) IS 'After in the order of start, end, covariance';
CREATE OPERATOR > (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_line, ab_line) IS 'After in the order of start, end, covariance';

CREATE FUNCTION ab_compare(a ab_line, b ab_line) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_line_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_line, ab_line) IS '-1, 0 or 1 in the order of start, end, covariance';

CREATE OPERATOR CLASS ab_line_ops DEFAULT FOR TYPE ab_line USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_line, ab_line);
COMMENT ON OPERATOR CLASS ab_line_ops USING btree IS 'Order by start, end, covariance';

CREATE FUNCTION ab_lt(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_plane, ab_plane) IS 'Before in the order of point, normal, covariance';
CREATE OPERATOR < (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_plane, ab_plane) IS 'Before in the order of point, normal, covariance';

CREATE FUNCTION ab_le(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_plane, ab_plane) IS 'Not after in the order of point, normal, covariance';
CREATE OPERATOR <= (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_plane, ab_plane) IS 'Not after in the order of point, normal, covariance';

CREATE FUNCTION ab_ge(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_plane, ab_plane) IS 'Not before in the order of point, normal, covariance';
CREATE OPERATOR >= (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_plane, ab_plane) IS 'Not before in the order of point, normal, covariance';

CREATE FUNCTION ab_gt(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_plane, ab_plane) IS 'After in the order of point, normal, covariance';
CREATE OPERATOR > (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_plane, ab_plane) IS 'After in the order of point, normal, covariance';

CREATE FUNCTION ab_compare(a ab_plane, b ab_plane) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_plane_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_plane, ab_plane) IS '-1, 0 or 1 in the order of point, normal, covariance';

CREATE OPERATOR CLASS ab_plane_ops DEFAULT FOR TYPE ab_plane USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_plane, ab_plane);
COMMENT ON OPERATOR CLASS ab_plane_ops USING btree IS 'Order by point, normal, covariance';

CREATE FUNCTION ab_lt(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_pose, ab_pose) IS 'Before in the order of rotation, translation, scale, covariance';
CREATE OPERATOR < (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_pose, ab_pose) IS 'Before in the order of rotation, translation, scale, covariance';

CREATE FUNCTION ab_le(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_pose, ab_pose) IS 'Not after in the order of rotation, translation, scale, covariance';
CREATE OPERATOR <= (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_pose, ab_pose) IS 'Not after in the order of rotation, translation, scale, covariance';

CREATE FUNCTION ab_ge(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_pose, ab_pose) IS 'Not before in the order of rotation, translation, scale, covariance';
CREATE OPERATOR >= (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_pose, ab_pose) IS 'Not before in the order of rotation, translation, scale, covariance';

CREATE FUNCTION ab_gt(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_pose, ab_pose) IS 'After in the order of rotation, translation, scale, covariance';
CREATE OPERATOR > (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_pose, ab_pose) IS 'After in the order of rotation, translation, scale, covariance';

CREATE FUNCTION ab_compare(a ab_pose, b ab_pose) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_pose_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_pose, ab_pose) IS '-1, 0 or 1 in the order of rotation, translation, scale, covariance';

CREATE OPERATOR CLASS ab_pose_ops DEFAULT FOR TYPE ab_pose USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_pose, ab_pose);
COMMENT ON OPERATOR CLASS ab_pose_ops USING btree IS 'Order by rotation, translation, scale, covariance';

CREATE FUNCTION ab_lt(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_mass, ab_mass) IS 'Before in the order of occupied, empty, unknown';
CREATE OPERATOR < (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_mass, ab_mass) IS 'Before in the order of occupied, empty, unknown';

CREATE FUNCTION ab_le(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_mass, ab_mass) IS 'Not after in the order of occupied, empty, unknown';
CREATE OPERATOR <= (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_mass, ab_mass) IS 'Not after in the order of occupied, empty, unknown';

CREATE FUNCTION ab_ge(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_mass, ab_mass) IS 'Not before in the order of occupied, empty, unknown';
CREATE OPERATOR >= (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_mass, ab_mass) IS 'Not before in the order of occupied, empty, unknown';

CREATE FUNCTION ab_gt(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_mass, ab_mass) IS 'After in the order of occupied, empty, unknown';
CREATE OPERATOR > (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_mass, ab_mass) IS 'After in the order of occupied, empty, unknown';

CREATE FUNCTION ab_compare(a ab_mass, b ab_mass) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_mass_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_mass, ab_mass) IS '-1, 0 or 1 in the order of occupied, empty, unknown';

CREATE OPERATOR CLASS ab_mass_ops DEFAULT FOR TYPE ab_mass USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_mass, ab_mass);
COMMENT ON OPERATOR CLASS ab_mass_ops USING btree IS 'Order by occupied, empty, unknown';

CREATE FUNCTION ab_reach(point ab_point, sigmas float8) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_point_reach' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_reach(ab_point, float8) IS 'The box of a point grown by this many standard deviations along every axis; at most 5';

CREATE FUNCTION ab_overlaps(a ab_point, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_point, ab_box) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_point_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_point, ab_point) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_line, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_line_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_line, ab_box) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_point) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_line) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_point, ab_box) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_point, ab_point) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_line, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_line, ab_box) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_box, ab_point) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_line, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_box, ab_line) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_point) IS 'Does a solid, grown by 0.25 m as for scans, meet the box of a point grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_point, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_point_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_point, ab_solid) IS 'Does a solid, grown by 0.25 m as for scans, meet the box of a point grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_point, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_solid, ab_point) IS 'A point may be of a solid: its box of five standard deviations meets the solid''s, grown by 0.25 m';
CREATE OPERATOR && (LEFTARG = ab_point, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = areasel, JOIN = areajoinsel);
COMMENT ON OPERATOR && (ab_point, ab_solid) IS 'A point may be of a solid: its box of five standard deviations meets the solid''s, grown by 0.25 m';

CREATE FUNCTION ab_within(a ab_point, b ab_point, sigmas float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE COST 200
    RETURN a && ab_reach(b, sigmas) AND ab_mahalanobis(a, b) <= sigmas;
COMMENT ON FUNCTION ab_within(ab_point, ab_point, float8) IS 'Are two points within this many standard deviations (at most 5) of each other: Mahalanobis distance. An index on the first one serves it';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_point, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_point, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_point_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_point_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_point_compress(internal) IS 'GiST support';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_line, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_line, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_line_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_line_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_line_compress(internal) IS 'GiST support';

CREATE OPERATOR CLASS ab_point_gist_ops DEFAULT FOR TYPE ab_point USING gist AS
    OPERATOR 1 && (ab_point, ab_box), OPERATOR 4 && (ab_point, ab_point), OPERATOR 5 && (ab_point, ab_solid),
    FUNCTION 1 ab_gist_consistent(internal, ab_point, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_point_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_point_gist_ops USING gist IS 'Joins on && by boxes grown by five standard deviations';

CREATE OPERATOR CLASS ab_line_gist_ops DEFAULT FOR TYPE ab_line USING gist AS
    OPERATOR 1 && (ab_line, ab_box),
    FUNCTION 1 ab_gist_consistent(internal, ab_line, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_line_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_line_gist_ops USING gist IS 'Joins on && by boxes grown by five standard deviations';

-- Evidence from tie points.

CREATE FUNCTION ab_evidence_accum(state internal, solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_accum_point' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 2000;
COMMENT ON FUNCTION ab_evidence_accum(internal, ab_solid, ab_point, float8[], ab_evidence_model) IS 'Transition of ab_evidence_agg over tie points';

CREATE AGGREGATE ab_evidence_agg(solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model) (
    SFUNC = ab_evidence_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_evidence_combine, SERIALFUNC = ab_evidence_serial, DESERIALFUNC = ab_evidence_deserial,
    FINALFUNC = ab_evidence_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_evidence_agg(ab_solid, ab_point, float8[], ab_evidence_model) IS
    'What tie points say about one solid: a surface at each point, once, with the point''s own covariance, and empty space along the rays from its cameras (n x 3, metres). Choose spacing near the distance of the points; join the objects that the rays may have pierced too, not only those near the points. The model meyer2022 takes every ray as a source of its own, without covariance. A NULL point keeps the object';

-- Patches taken apart, filtered, thinned, moved, joined.

CREATE FUNCTION ab_cone(patch ab_scan, OUT axis float8[], OUT half_angle float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_cone' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_cone(ab_scan) IS 'Directions of a patch: the axis of its cone and the half-angle, radians; NULL for points without origin';

CREATE FUNCTION ab_range(patch ab_scan, OUT nearest float8, OUT farthest float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_range(ab_scan) IS 'Least and greatest range of its returns, metres';

CREATE FUNCTION ab_beams(patch ab_scan, OUT origin float8[], OUT point float8[], OUT direction float8[], OUT range float8) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_scan_beams' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5000 ROWS 4000;
COMMENT ON FUNCTION ab_beams(ab_scan) IS 'Every beam: where it starts, its return (NULL where nothing came back), its unit direction and range, metres';

CREATE FUNCTION ab_sees(patch ab_scan, box ab_box, margin float8 DEFAULT 0) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_sees' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10;
COMMENT ON FUNCTION ab_sees(ab_scan, ab_box, float8) IS 'May a beam of the patch come within the margin (metres) of a box? By cone and range, from the header alone; never false where one does. A sharper second look after &&';

CREATE FUNCTION ab_filter(patch ab_scan, box ab_box) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5000;
COMMENT ON FUNCTION ab_filter(ab_scan, ab_box) IS 'The returns inside a box; NULL where there is none';

CREATE FUNCTION ab_filter(patch ab_scan, min_range float8, max_range float8 DEFAULT 'infinity') RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_filter_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5000;
COMMENT ON FUNCTION ab_filter(ab_scan, float8, float8) IS 'The returns from min_range to max_range metres away; NULL where there is none';

CREATE FUNCTION ab_thin(patch ab_scan, spacing float8) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_thin' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5000;
COMMENT ON FUNCTION ab_thin(ab_scan, float8) IS 'One return for every cube of this side, metres; beams without return are kept';

CREATE FUNCTION ab_transform(patch ab_scan, pose ab_pose) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_transform_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5000;
COMMENT ON FUNCTION ab_transform(ab_scan, ab_pose) IS 'The patch through a pose; a patch carries no covariance';

CREATE FUNCTION ab_retile(patches ab_scan[]) RETURNS SETOF ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_retile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 10;
COMMENT ON FUNCTION ab_retile(ab_scan[]) IS 'The beams of patches of one station cut anew into tiles of at most 4096 neighbours';

-- Patches from rows.

CREATE FUNCTION ab_scan_accum(state internal, x float8, y float8, z float8, origin float8[], station bigint) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_scan_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_scan_accum(internal, float8, float8, float8, float8[], bigint) IS 'Transition of ab_scan_agg';

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

CREATE AGGREGATE ab_scan_agg(x float8, y float8, z float8, origin float8[], station bigint) (
    SFUNC = ab_scan_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_scan_combine, SERIALFUNC = ab_scan_serial, DESERIALFUNC = ab_scan_deserial,
    FINALFUNC = ab_scan_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_scan_agg(float8, float8, float8, float8[], bigint) IS
    'Patches from rows of returns (world metres) of one station: GROUP BY it. Rows keep their order inside a patch where they come ordered, which packs best; unnest() makes rows of the array. A row with a NULL adds nothing';

-- Containment, equality and nearness of boxes, and the operator classes that serve them. Keys are boxes, from outside as && sees them.

CREATE FUNCTION ab_contains(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_contains(ab_box, ab_box) IS 'Does a box hold a box';

CREATE FUNCTION ab_contained(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_contained(ab_box, ab_box) IS 'Does a box lie in a box';

CREATE FUNCTION ab_box_distance(a ab_box, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_box_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_box, ab_box) IS 'Least distance of a box from a box, metres';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR @> (ab_box, ab_box) IS 'Does a box hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR <@ (ab_box, ab_box) IS 'Does a box lie in a box';
CREATE OPERATOR <-> (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_box, ab_box) IS 'Least distance of a box from a box, metres; for nearest first';

CREATE FUNCTION ab_contains(a ab_solid, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_solid_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_contains(ab_solid, ab_box) IS 'Does the box of a solid hold a box';

CREATE FUNCTION ab_contained(a ab_solid, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_solid_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_contained(ab_solid, ab_box) IS 'Does the box of a solid lie in a box';

CREATE FUNCTION ab_same(a ab_solid, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_solid_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_same(ab_solid, ab_box) IS 'Is the box of a solid that box';

CREATE FUNCTION ab_box_distance(a ab_solid, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_solid_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_solid, ab_box) IS 'Least distance of the box of a solid from a box, metres';

CREATE FUNCTION ab_contains(a ab_box, b ab_solid) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN ab_contained(b, a);
COMMENT ON FUNCTION ab_contains(ab_box, ab_solid) IS 'Does a box hold the box of a solid';

CREATE FUNCTION ab_contained(a ab_box, b ab_solid) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN ab_contains(b, a);
COMMENT ON FUNCTION ab_contained(ab_box, ab_solid) IS 'Does a box lie in the box of a solid';
CREATE OPERATOR @> (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR @> (ab_solid, ab_box) IS 'Does the box of a solid hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR <@ (ab_solid, ab_box) IS 'Does the box of a solid lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_solid, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR @> (ab_box, ab_solid) IS 'Does a box hold the box of a solid';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_solid, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR <@ (ab_box, ab_solid) IS 'Does a box lie in the box of a solid';
CREATE OPERATOR ~= (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR ~= (ab_solid, ab_box) IS 'Is the box of a solid that box';
CREATE OPERATOR <-> (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_solid, ab_box) IS 'Least distance of the box of a solid from a box, metres; for nearest first';

CREATE FUNCTION ab_contains(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_contains(ab_scan, ab_box) IS 'Does the hull of a patch hold a box';

CREATE FUNCTION ab_contained(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_contained(ab_scan, ab_box) IS 'Does the hull of a patch lie in a box';

CREATE FUNCTION ab_same(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_same(ab_scan, ab_box) IS 'Is the hull of a patch that box';

CREATE FUNCTION ab_box_distance(a ab_scan, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_scan_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_scan, ab_box) IS 'Least distance of the hull of a patch from a box, metres';

CREATE FUNCTION ab_contains(a ab_box, b ab_scan) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN ab_contained(b, a);
COMMENT ON FUNCTION ab_contains(ab_box, ab_scan) IS 'Does a box hold the hull of a patch';

CREATE FUNCTION ab_contained(a ab_box, b ab_scan) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN ab_contains(b, a);
COMMENT ON FUNCTION ab_contained(ab_box, ab_scan) IS 'Does a box lie in the hull of a patch';
CREATE OPERATOR @> (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR @> (ab_scan, ab_box) IS 'Does the hull of a patch hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR <@ (ab_scan, ab_box) IS 'Does the hull of a patch lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_scan, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR @> (ab_box, ab_scan) IS 'Does a box hold the hull of a patch';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_scan, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR <@ (ab_box, ab_scan) IS 'Does a box lie in the hull of a patch';
CREATE OPERATOR ~= (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR ~= (ab_scan, ab_box) IS 'Is the hull of a patch that box';
CREATE OPERATOR <-> (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_scan, ab_box) IS 'Least distance of the hull of a patch from a box, metres; for nearest first';

CREATE FUNCTION ab_contains(a ab_point, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_contains(ab_point, ab_box) IS 'Does the box of a point grown by five standard deviations hold a box';

CREATE FUNCTION ab_contained(a ab_point, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_contained(ab_point, ab_box) IS 'Does the box of a point grown by five standard deviations lie in a box';

CREATE FUNCTION ab_same(a ab_point, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_same(ab_point, ab_box) IS 'Is the box of a point grown by five standard deviations that box';

CREATE FUNCTION ab_box_distance(a ab_point, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_point, ab_box) IS 'Least distance of the box of a point grown by five standard deviations from a box, metres';

CREATE FUNCTION ab_contains(a ab_box, b ab_point) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN ab_contained(b, a);
COMMENT ON FUNCTION ab_contains(ab_box, ab_point) IS 'Does a box hold the box of a point grown by five standard deviations';

CREATE FUNCTION ab_contained(a ab_box, b ab_point) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN ab_contains(b, a);
COMMENT ON FUNCTION ab_contained(ab_box, ab_point) IS 'Does a box lie in the box of a point grown by five standard deviations';
CREATE OPERATOR @> (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR @> (ab_point, ab_box) IS 'Does the box of a point grown by five standard deviations hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR <@ (ab_point, ab_box) IS 'Does the box of a point grown by five standard deviations lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR @> (ab_box, ab_point) IS 'Does a box hold the box of a point grown by five standard deviations';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR <@ (ab_box, ab_point) IS 'Does a box lie in the box of a point grown by five standard deviations';
CREATE OPERATOR ~= (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = contsel, JOIN = contjoinsel);
COMMENT ON OPERATOR ~= (ab_point, ab_box) IS 'Is the box of a point grown by five standard deviations that box';
CREATE OPERATOR <-> (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_point, ab_box) IS 'Least distance of the box of a point grown by five standard deviations from a box, metres; for nearest first';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_box, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_box, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_solid, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_solid, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_scan, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_scan, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_point, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_point, smallint, oid, internal) IS 'GiST support';

ALTER OPERATOR FAMILY ab_box_gist_ops USING gist ADD
    OPERATOR 10 @> (ab_box, ab_box), OPERATOR 11 <@ (ab_box, ab_box), OPERATOR 12 ~= (ab_box, ab_box),
    OPERATOR 13 <-> (ab_box, ab_box) FOR ORDER BY float_ops,
    FUNCTION 8 (ab_box, ab_box) ab_gist_distance(internal, ab_box, smallint, oid, internal);

ALTER OPERATOR FAMILY ab_solid_gist_ops USING gist ADD
    OPERATOR 10 @> (ab_solid, ab_box), OPERATOR 11 <@ (ab_solid, ab_box), OPERATOR 12 ~= (ab_solid, ab_box),
    OPERATOR 13 <-> (ab_solid, ab_box) FOR ORDER BY float_ops,
    FUNCTION 8 (ab_solid, ab_solid) ab_gist_distance(internal, ab_solid, smallint, oid, internal);

ALTER OPERATOR FAMILY ab_scan_gist_ops USING gist ADD
    OPERATOR 10 @> (ab_scan, ab_box), OPERATOR 11 <@ (ab_scan, ab_box), OPERATOR 12 ~= (ab_scan, ab_box),
    OPERATOR 13 <-> (ab_scan, ab_box) FOR ORDER BY float_ops,
    FUNCTION 8 (ab_scan, ab_scan) ab_gist_distance(internal, ab_scan, smallint, oid, internal);

ALTER OPERATOR FAMILY ab_point_gist_ops USING gist ADD
    OPERATOR 10 @> (ab_point, ab_box), OPERATOR 11 <@ (ab_point, ab_box), OPERATOR 12 ~= (ab_point, ab_box),
    OPERATOR 13 <-> (ab_point, ab_box) FOR ORDER BY float_ops,
    FUNCTION 8 (ab_point, ab_point) ab_gist_distance(internal, ab_point, smallint, oid, internal);
