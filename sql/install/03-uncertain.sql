-- Uncertain points, lines, planes and poses: constructors, accessors, constructions, fits, tests of their relations.
-- Objects are independent of each other.

CREATE FUNCTION ab_point(
    x float8, y float8, z float8, sd float8 DEFAULT 0, covariance float8[] DEFAULT NULL) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_point_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_point(float8, float8, float8, float8, float8[]) IS
    'A point, metres, with one standard deviation for every axis or with a 3 x 3 covariance (as 3 x 3 or 9 numbers)';

CREATE FUNCTION ab_line(start float8[], finish float8[], covariance float8[] DEFAULT NULL) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_line(float8[], float8[], float8[]) IS
    'A line between two places, with the 6 x 6 covariance of both ends (none: exact)';

CREATE FUNCTION ab_line(a ab_point, b ab_point) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_join' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_line(ab_point, ab_point) IS 'The line through two points';

CREATE FUNCTION ab_plane(
    point float8[], normal float8[], sd_offset float8 DEFAULT 0, sd_tilt float8 DEFAULT 0,
    covariance float8[] DEFAULT NULL) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_plane(float8[], float8[], float8, float8, float8[]) IS
    'A plane through a place with a normal; standard deviations of its offset (metres) and of its tilt about any '
    'axis in it (radians), or the 4 x 4 covariance of (unit normal, offset)';

CREATE FUNCTION ab_plane(a ab_point, b ab_point, c ab_point) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_join' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plane(ab_point, ab_point, ab_point) IS
    'The plane through three points, its normal by the right hand';

CREATE FUNCTION ab_plane(line ab_line, point ab_point) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_join_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plane(ab_line, ab_point) IS 'The plane through a line and a point';

CREATE FUNCTION ab_pose(
    translation float8[], rotation float8[] DEFAULT '{1,0,0,0}', scale float8 DEFAULT 1, sd_rotation float8 DEFAULT 0,
    sd_translation float8 DEFAULT 0, sd_scale float8 DEFAULT 0, covariance float8[] DEFAULT NULL) RETURNS ab_pose
    AS 'MODULE_PATHNAME', 'ab_pose_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_pose(float8[], float8[], float8, float8, float8, float8, float8[]) IS
    'A transform from a translation, a quaternion w,x,y,z (made a unit) and a scale, with standard deviations '
    '(radians, metres, relative) or the 7 x 7 covariance of (rotation, translation, scale)';

CREATE FUNCTION ab_numbers(point ab_point) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_point_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_numbers(ab_point) IS 'All 9 numbers of the value, as in its text form';

CREATE FUNCTION ab_point_of(numbers float8[]) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_point_from_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_point_of(float8[]) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE FUNCTION ab_covariance(point ab_point) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_point_covariance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_covariance(ab_point) IS '3 x 3, m2';

CREATE FUNCTION ab_numbers(line ab_line) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_line_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_numbers(ab_line) IS 'All 27 numbers of the value, as in its text form';

CREATE FUNCTION ab_line_of(numbers float8[]) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_from_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_line_of(float8[]) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE FUNCTION ab_covariance(line ab_line) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_line_covariance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_covariance(ab_line) IS 'Of (start, end), 6 x 6, m2';

CREATE FUNCTION ab_numbers(plane ab_plane) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_plane_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_numbers(ab_plane) IS 'All 16 numbers of the value, as in its text form';

CREATE FUNCTION ab_plane_of(numbers float8[]) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_from_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plane_of(float8[]) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE FUNCTION ab_covariance(plane ab_plane) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_plane_covariance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_covariance(ab_plane) IS 'Of (normal, offset), 4 x 4';

CREATE FUNCTION ab_numbers(pose ab_pose) RETURNS float8[]
    AS 'MODULE_PATHNAME', 'ab_pose_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_numbers(ab_pose) IS 'All 36 numbers of the value, as in its text form';

CREATE FUNCTION ab_pose_of(numbers float8[]) RETURNS ab_pose
    AS 'MODULE_PATHNAME', 'ab_pose_from_numbers' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_pose_of(float8[]) IS 'From its coordinates alone (exact) or from all its numbers';

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

CREATE FUNCTION ab_box(point ab_point, probability float8 DEFAULT 0.95) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 300;
COMMENT ON FUNCTION ab_box(ab_point, float8) IS
    'The box around the ellipsoid that holds the true point with this probability';

CREATE FUNCTION ab_box(line ab_line, probability float8 DEFAULT 0.95) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_line_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 300;
COMMENT ON FUNCTION ab_box(ab_line, float8) IS 'The box around the confidence ellipsoids of both ends';

CREATE FUNCTION ab_mahalanobis(a ab_point, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_mahalanobis' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_mahalanobis(ab_point, ab_point) IS
    'Mahalanobis distance of two points; infinite where they differ in a direction without variance';

-- Constructions.
CREATE FUNCTION ab_midpoint(a ab_point, b ab_point) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_midpoint_points' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_midpoint(ab_point, ab_point) IS 'The point halfway';

CREATE FUNCTION ab_midpoint(line ab_line) RETURNS ab_point
    AS 'MODULE_PATHNAME', 'ab_midpoint_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_midpoint(ab_line) IS 'The point halfway between the ends';

CREATE FUNCTION ab_intersection(a ab_plane, b ab_plane) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_intersection_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_intersection(ab_plane, ab_plane) IS
    'The line in which two planes meet, one metre long, near their points; uncertain across itself';

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
CREATE FUNCTION _ab_points_accum(state internal, point ab_point) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_points_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_points_accum(internal, ab_point) IS 'Transition of ab_line_agg and ab_plane_agg';

CREATE FUNCTION _ab_points_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_points_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_points_combine(internal, internal) IS 'Combine of ab_line_agg and ab_plane_agg';

CREATE FUNCTION _ab_points_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_points_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_points_serial(internal) IS 'Serialisation of ab_line_agg and ab_plane_agg';

CREATE FUNCTION _ab_points_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_points_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_points_deserial(bytea, internal) IS 'Deserialisation of ab_line_agg and ab_plane_agg';

CREATE FUNCTION _ab_line_agg_final(state internal) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_fit' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION _ab_line_agg_final(internal) IS 'Final of ab_line_agg';

CREATE FUNCTION _ab_plane_agg_final(state internal) RETURNS ab_plane
    AS 'MODULE_PATHNAME', 'ab_plane_fit' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION _ab_plane_agg_final(internal) IS 'Final of ab_plane_agg';

CREATE AGGREGATE ab_line_agg(point ab_point) (
    SFUNC = _ab_points_accum, STYPE = internal, SSPACE = 100000, COMBINEFUNC = _ab_points_combine,
    SERIALFUNC = _ab_points_serial, DESERIALFUNC = _ab_points_deserial, FINALFUNC = _ab_line_agg_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_line_agg(ab_point) IS
    'The line that fits the points best, by maximum likelihood with their own covariances. Points without any give '
    'it by their residuals, used as if known: few points make it too sure';

CREATE FUNCTION ab_line(points ab_point[]) RETURNS ab_line
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN (SELECT ab_line_agg(p) FROM unnest(points) p);
COMMENT ON FUNCTION ab_line(ab_point[]) IS 'The line that fits the points best';

CREATE AGGREGATE ab_plane_agg(point ab_point) (
    SFUNC = _ab_points_accum, STYPE = internal, SSPACE = 100000, COMBINEFUNC = _ab_points_combine,
    SERIALFUNC = _ab_points_serial, DESERIALFUNC = _ab_points_deserial, FINALFUNC = _ab_plane_agg_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_plane_agg(ab_point) IS
    'The plane that fits the points best, by maximum likelihood with their own covariances. Points without any give '
    'it by their residuals, used as if known: few points make it too sure';

CREATE FUNCTION ab_plane(points ab_point[]) RETURNS ab_plane
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN (SELECT ab_plane_agg(p) FROM unnest(points) p);
COMMENT ON FUNCTION ab_plane(ab_point[]) IS 'The plane that fits the points best';

-- Statistical tests of relations between uncertain, independent objects.
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

CREATE FUNCTION ab_is_same(a ab_point, b ab_point, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_same_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_same(ab_point, ab_point, float8) IS
    'Are two points the same? True unless rejected at this significance';

CREATE FUNCTION ab_test_same(a ab_plane, b ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_same_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_same(ab_plane, ab_plane) IS
    'Are two planes the same, whichever way they face? 3 degrees of freedom. Chi-square statistic, degrees of '
    'freedom (the rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_same(a ab_plane, b ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_same_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_same(ab_plane, ab_plane, float8) IS
    'Are two planes the same, whichever way they face? True unless rejected at this significance';

CREATE FUNCTION ab_test_incident(point ab_point, line ab_line) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_point_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_incident(ab_point, ab_line) IS
    'Does a point lie on an endless line? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank '
    'of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_incident(point ab_point, line ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_point_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_incident(ab_point, ab_line, float8) IS
    'Does a point lie on an endless line? True unless rejected at this significance';

CREATE FUNCTION ab_test_incident(point ab_point, plane ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_point_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_incident(ab_point, ab_plane) IS
    'Does a point lie on a plane? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_incident(point ab_point, plane ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_point_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_incident(ab_point, ab_plane, float8) IS
    'Does a point lie on a plane? True unless rejected at this significance';

CREATE FUNCTION ab_test_incident(line ab_line, plane ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_incident(ab_line, ab_plane) IS
    'Does a line lie in a plane? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_incident(line ab_line, plane ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_incident(ab_line, ab_plane, float8) IS
    'Does a line lie in a plane? True unless rejected at this significance';

CREATE FUNCTION ab_test_parallel(a ab_line, b ab_line) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_parallel_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_parallel(ab_line, ab_line) IS
    'Are two lines parallel? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_parallel(a ab_line, b ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_parallel_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_parallel(ab_line, ab_line, float8) IS
    'Are two lines parallel? True unless rejected at this significance';

CREATE FUNCTION ab_test_parallel(a ab_plane, b ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_parallel_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_parallel(ab_plane, ab_plane) IS
    'Are two planes parallel? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_parallel(a ab_plane, b ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_parallel_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_parallel(ab_plane, ab_plane, float8) IS
    'Are two planes parallel? True unless rejected at this significance';

CREATE FUNCTION ab_test_parallel(line ab_line, plane ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_parallel_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_parallel(ab_line, ab_plane) IS
    'Is a line parallel to a plane? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_parallel(line ab_line, plane ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_parallel_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_parallel(ab_line, ab_plane, float8) IS
    'Is a line parallel to a plane? True unless rejected at this significance';

CREATE FUNCTION ab_test_orthogonal(a ab_line, b ab_line) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_orthogonal(ab_line, ab_line) IS
    'Are two lines, perhaps skew, orthogonal? 1 degree of freedom. Chi-square statistic, degrees of freedom (the '
    'rank of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_orthogonal(a ab_line, b ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_orthogonal_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_orthogonal(ab_line, ab_line, float8) IS
    'Are two lines, perhaps skew, orthogonal? True unless rejected at this significance';

CREATE FUNCTION ab_test_orthogonal(a ab_plane, b ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_orthogonal(ab_plane, ab_plane) IS
    'Are two planes orthogonal? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank of the '
    'covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_orthogonal(a ab_plane, b ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_orthogonal_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_orthogonal(ab_plane, ab_plane, float8) IS
    'Are two planes orthogonal? True unless rejected at this significance';

CREATE FUNCTION ab_test_orthogonal(line ab_line, plane ab_plane) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_orthogonal(ab_line, ab_plane) IS
    'Is a line orthogonal to a plane? 2 degrees of freedom. Chi-square statistic, degrees of freedom (the rank of '
    'the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_orthogonal(line ab_line, plane ab_plane, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_orthogonal_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_orthogonal(ab_line, ab_plane, float8) IS
    'Is a line orthogonal to a plane? True unless rejected at this significance';

CREATE FUNCTION ab_test_coplanar(a ab_line, b ab_line) RETURNS ab_test_row
    AS 'MODULE_PATHNAME', 'ab_test_coplanar_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_test_coplanar(ab_line, ab_line) IS
    'Do two endless lines lie in one plane? 1 degree of freedom. Chi-square statistic, degrees of freedom (the rank '
    'of the covariance: fewer where it is singular), probability of one as large where it is so';

CREATE FUNCTION ab_is_coplanar(a ab_line, b ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_coplanar_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_coplanar(ab_line, ab_line, float8) IS
    'Do two endless lines lie in one plane? True unless rejected at this significance';

-- The same with the arguments the other way round.
CREATE FUNCTION ab_test_incident(line ab_line, point ab_point) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_incident(point, line);
COMMENT ON FUNCTION ab_test_incident(ab_line, ab_point) IS
    'Does a point lie on an endless line? 2 degrees of freedom, arguments the other way round';

CREATE FUNCTION ab_is_incident(line ab_line, point ab_point, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_incident(point, line, significance);
COMMENT ON FUNCTION ab_is_incident(ab_line, ab_point, float8) IS
    'Does a point lie on an endless line? Arguments the other way round';

CREATE FUNCTION ab_test_incident(plane ab_plane, point ab_point) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_incident(point, plane);
COMMENT ON FUNCTION ab_test_incident(ab_plane, ab_point) IS
    'Does a point lie on a plane? 1 degree of freedom, arguments the other way round';

CREATE FUNCTION ab_is_incident(plane ab_plane, point ab_point, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_incident(point, plane, significance);
COMMENT ON FUNCTION ab_is_incident(ab_plane, ab_point, float8) IS
    'Does a point lie on a plane? Arguments the other way round';

CREATE FUNCTION ab_test_incident(plane ab_plane, line ab_line) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_incident(line, plane);
COMMENT ON FUNCTION ab_test_incident(ab_plane, ab_line) IS
    'Does a line lie in a plane? 2 degrees of freedom, arguments the other way round';

CREATE FUNCTION ab_is_incident(plane ab_plane, line ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_incident(line, plane, significance);
COMMENT ON FUNCTION ab_is_incident(ab_plane, ab_line, float8) IS
    'Does a line lie in a plane? Arguments the other way round';

CREATE FUNCTION ab_test_parallel(plane ab_plane, line ab_line) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_parallel(line, plane);
COMMENT ON FUNCTION ab_test_parallel(ab_plane, ab_line) IS
    'Is a line parallel to a plane? 1 degree of freedom, arguments the other way round';

CREATE FUNCTION ab_is_parallel(plane ab_plane, line ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_parallel(line, plane, significance);
COMMENT ON FUNCTION ab_is_parallel(ab_plane, ab_line, float8) IS
    'Is a line parallel to a plane? Arguments the other way round';

CREATE FUNCTION ab_test_orthogonal(plane ab_plane, line ab_line) RETURNS ab_test_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_test_orthogonal(line, plane);
COMMENT ON FUNCTION ab_test_orthogonal(ab_plane, ab_line) IS
    'Is a line orthogonal to a plane? 2 degrees of freedom, arguments the other way round';

CREATE FUNCTION ab_is_orthogonal(plane ab_plane, line ab_line, significance float8 DEFAULT 0.05) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_is_orthogonal(line, plane, significance);
COMMENT ON FUNCTION ab_is_orthogonal(ab_plane, ab_line, float8) IS
    'Is a line orthogonal to a plane? Arguments the other way round';

CREATE FUNCTION ab_distance(plane ab_plane, point ab_point) RETURNS ab_distance_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_distance(point, plane);
COMMENT ON FUNCTION ab_distance(ab_plane, ab_point) IS 'As ab_distance(point, plane)';

CREATE FUNCTION ab_distance(line ab_line, point ab_point) RETURNS ab_distance_row
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_distance(point, line);
COMMENT ON FUNCTION ab_distance(ab_line, ab_point) IS 'As ab_distance(point, line)';

CREATE FUNCTION ab_intersection(plane ab_plane, line ab_line) RETURNS ab_point
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    RETURN ab_intersection(line, plane);
COMMENT ON FUNCTION ab_intersection(ab_plane, ab_line) IS 'As ab_intersection(line, plane)';

CREATE FUNCTION ab_reach(point ab_point, sigmas float8) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_point_reach' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_reach(ab_point, float8) IS
    'The box of a point grown by this many standard deviations along every axis; at most 5';
