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
