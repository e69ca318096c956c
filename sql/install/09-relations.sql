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
