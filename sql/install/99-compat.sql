-- What 0.1.0 had under other names or with other columns: views and functions that were made with it go on, also after
-- dump and restore. Not for new use; C symbols in src/compat.rs.

CREATE TYPE ab_evidence_model_010;
CREATE FUNCTION _ab_evidence_model_in_010(cstring) RETURNS ab_evidence_model_010
    AS 'MODULE_PATHNAME', 'ab_evidence_model_in' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_in_010(cstring) IS
    '_ab_evidence_model_in as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_evidence_model_out_010(ab_evidence_model_010) RETURNS cstring
    AS 'MODULE_PATHNAME', 'ab_evidence_model_out' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_out_010(ab_evidence_model_010) IS
    '_ab_evidence_model_out as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_evidence_model_recv_010(internal) RETURNS ab_evidence_model_010
    AS 'MODULE_PATHNAME', 'ab_evidence_model_recv' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_recv_010(internal) IS
    '_ab_evidence_model_recv as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_evidence_model_send_010(ab_evidence_model_010) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_evidence_model_send' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_evidence_model_send_010(ab_evidence_model_010) IS
    '_ab_evidence_model_send as it was in 0.1.0: for what was made with it';
CREATE TYPE ab_evidence_model_010 (
    INPUT = _ab_evidence_model_in_010, OUTPUT = _ab_evidence_model_out_010, RECEIVE = _ab_evidence_model_recv_010,
    SEND = _ab_evidence_model_send_010, INTERNALLENGTH = 112, ALIGNMENT = double);
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

CREATE FUNCTION _ab_scan_010(
    origin float8[], points float8[], step float8 DEFAULT NULL, station bigint DEFAULT 0,
    quantum float8 DEFAULT 0.0001) RETURNS ab_scan
    AS 'MODULE_PATHNAME', 'ab_scan_make' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION _ab_scan_010(float8[], float8[], float8, bigint, float8) IS
    'ab_scan as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_loa_class_010(
    OUT loa ab_loa, OUT lower float8, OUT upper float8, OUT sigma float8, OUT source text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_loa_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION _ab_loa_class_010() IS 'ab_loa_class as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_evidence_model_make_010(
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

CREATE FUNCTION _ab_summary_010(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL, OUT verdict text, OUT best_loa ab_loa,
    OUT samples bigint, OUT coverage float8, OUT confirmed float8, OUT refuted float8, OUT open float8,
    OUT conflict float8, OUT deviation float8, OUT deviation_sd float8, OUT shift text) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_summary' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION _ab_summary_010(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'ab_summary as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_verdict_010(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_verdict' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION _ab_verdict_010(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'ab_verdict as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_shift_010(
    e ab_evidence, OUT x float8, OUT y float8, OUT z float8, OUT x_sd float8, OUT y_sd float8,
    OUT z_sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_shift' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION _ab_shift_010(ab_evidence) IS 'ab_shift as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_samples_010(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, OUT "position" float8[],
    OUT normal float8[], OUT mass ab_mass, OUT deviation float8, OUT deviation_sd float8,
    OUT beams integer) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_samples' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 10000;
COMMENT ON FUNCTION _ab_samples_010(ab_evidence, ab_loa, float8) IS
    'ab_samples as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_faces_010(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, OUT normal float8[], OUT samples bigint,
    OUT seen bigint, OUT confirmed bigint, OUT refuted bigint, OUT open bigint, OUT pierced bigint,
    OUT deviation float8, OUT deviation_sd float8) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_faces' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 20;
COMMENT ON FUNCTION _ab_faces_010(ab_evidence, ab_loa, float8) IS
    'ab_faces as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_model_010(e ab_evidence) RETURNS ab_evidence_model_010
    AS 'MODULE_PATHNAME', 'ab_evidence_get_model' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_model_010(ab_evidence) IS 'ab_model as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_evidence_accum_010(
    state internal, solid ab_solid, patch ab_scan, model ab_evidence_model_010) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_evidence_accum_010(internal, ab_solid, ab_scan, ab_evidence_model_010) IS
    '_ab_evidence_accum as it was in 0.1.0: for what was made with it';

CREATE AGGREGATE _ab_evidence_agg_010(solid ab_solid, patch ab_scan, model ab_evidence_model_010) (
    SFUNC = _ab_evidence_accum_010, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_evidence_combine,
    SERIALFUNC = _ab_evidence_serial, DESERIALFUNC = _ab_evidence_deserial, FINALFUNC = _ab_evidence_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE _ab_evidence_agg_010(ab_solid, ab_scan, ab_evidence_model_010) IS
    'ab_evidence_agg as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_line_010(start float8[], "end" float8[], covariance float8[] DEFAULT NULL) RETURNS ab_line
    AS 'MODULE_PATHNAME', 'ab_line_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_line_010(float8[], float8[], float8[]) IS
    'ab_line as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_plucker_010(
    line ab_line, reference float8[] DEFAULT '{0,0,0}', OUT line float8[], OUT covariance float8[]) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_line_plucker' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_plucker_010(ab_line, float8[]) IS 'ab_plucker as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_ellipsoid_010(
    point ab_point, probability float8 DEFAULT 0.95, OUT half_axis float8, OUT direction float8[]) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_point_ellipsoid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 3;
COMMENT ON FUNCTION _ab_ellipsoid_010(ab_point, float8) IS 'ab_ellipsoid as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_distance_010(a ab_point, b ab_point, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_points' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_distance_010(ab_point, ab_point) IS 'ab_distance as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_distance_010(point ab_point, plane ab_plane, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_distance_010(ab_point, ab_plane) IS 'ab_distance as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_distance_010(point ab_point, line ab_line, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_distance_010(ab_point, ab_line) IS 'ab_distance as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_distance_010(a ab_line, b ab_line, OUT distance float8, OUT sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_distance_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_distance_010(ab_line, ab_line) IS 'ab_distance as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_same_010(
    a ab_point, b ab_point, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_same_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_same_010(ab_point, ab_point) IS
    'ab_test_same as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_same_010(
    a ab_plane, b ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_same_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_same_010(ab_plane, ab_plane) IS
    'ab_test_same as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_incident_010(
    point ab_point, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_point_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_incident_010(ab_point, ab_line) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_incident_010(
    point ab_point, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_point_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_incident_010(ab_point, ab_plane) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_incident_010(
    line ab_line, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_incident_010(ab_line, ab_plane) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_parallel_010(
    a ab_line, b ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_parallel_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_parallel_010(ab_line, ab_line) IS
    'ab_test_parallel as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_parallel_010(
    a ab_plane, b ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_parallel_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_parallel_010(ab_plane, ab_plane) IS
    'ab_test_parallel as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_parallel_010(
    line ab_line, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_parallel_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_parallel_010(ab_line, ab_plane) IS
    'ab_test_parallel as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_orthogonal_010(
    a ab_line, b ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_orthogonal_010(ab_line, ab_line) IS
    'ab_test_orthogonal as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_orthogonal_010(
    a ab_plane, b ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_planes' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_orthogonal_010(ab_plane, ab_plane) IS
    'ab_test_orthogonal as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_orthogonal_010(
    line ab_line, plane ab_plane, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_orthogonal_line_plane' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_orthogonal_010(ab_line, ab_plane) IS
    'ab_test_orthogonal as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_coplanar_010(
    a ab_line, b ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_test_coplanar_lines' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_test_coplanar_010(ab_line, ab_line) IS
    'ab_test_coplanar as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_incident_010(
    line ab_line, point ab_point, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_incident_010(point, line) t; END;
COMMENT ON FUNCTION _ab_test_incident_010(ab_line, ab_point) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_incident_010(
    plane ab_plane, point ab_point, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_incident_010(point, plane) t; END;
COMMENT ON FUNCTION _ab_test_incident_010(ab_plane, ab_point) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_incident_010(
    plane ab_plane, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_incident_010(line, plane) t; END;
COMMENT ON FUNCTION _ab_test_incident_010(ab_plane, ab_line) IS
    'ab_test_incident as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_parallel_010(
    plane ab_plane, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_parallel_010(line, plane) t; END;
COMMENT ON FUNCTION _ab_test_parallel_010(ab_plane, ab_line) IS
    'ab_test_parallel as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_test_orthogonal_010(
    plane ab_plane, line ab_line, OUT statistic float8, OUT dof integer, OUT p_value float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.statistic, t.dof, t.p_value FROM _ab_test_orthogonal_010(line, plane) t; END;
COMMENT ON FUNCTION _ab_test_orthogonal_010(ab_plane, ab_line) IS
    'ab_test_orthogonal as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_distance_010(plane ab_plane, point ab_point, OUT distance float8, OUT sd float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.distance, t.sd FROM _ab_distance_010(point, plane) t; END;
COMMENT ON FUNCTION _ab_distance_010(ab_plane, ab_point) IS 'ab_distance as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_distance_010(line ab_line, point ab_point, OUT distance float8, OUT sd float8) RETURNS record
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT
    BEGIN ATOMIC SELECT t.distance, t.sd FROM _ab_distance_010(point, line) t; END;
COMMENT ON FUNCTION _ab_distance_010(ab_line, ab_point) IS 'ab_distance as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_convert_belief_linear_010(
    belief float8, sigma float8, sigma_to float8, divisor float8 DEFAULT 0.682689492137086, OUT belief_to float8,
    OUT capped boolean) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_convert_belief_linear' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_convert_belief_linear_010(float8, float8, float8, float8) IS
    'ab_convert_belief_linear as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_din18710_class_010(
    OUT class text, OUT lower float8, OUT upper float8, OUT source text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_din18710_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION _ab_din18710_class_010() IS 'ab_din18710_class as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_evidence_accum_010(
    state internal, solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model_010) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_accum_point' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 2000;
COMMENT ON FUNCTION _ab_evidence_accum_010(internal, ab_solid, ab_point, float8[], ab_evidence_model_010) IS
    '_ab_evidence_accum as it was in 0.1.0: for what was made with it';

CREATE AGGREGATE _ab_evidence_agg_010(solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model_010) (
    SFUNC = _ab_evidence_accum_010, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_evidence_combine,
    SERIALFUNC = _ab_evidence_serial, DESERIALFUNC = _ab_evidence_deserial, FINALFUNC = _ab_evidence_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE _ab_evidence_agg_010(ab_solid, ab_point, float8[], ab_evidence_model_010) IS
    'ab_evidence_agg as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_cone_010(patch ab_scan, OUT axis float8[], OUT half_angle float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_cone' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_cone_010(ab_scan) IS 'ab_cone as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_range_010(patch ab_scan, OUT nearest float8, OUT farthest float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_scan_range' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_range_010(ab_scan) IS 'ab_range as it was in 0.1.0: for what was made with it';

CREATE FUNCTION _ab_beams_010(
    patch ab_scan, OUT origin float8[], OUT point float8[], OUT direction float8[],
    OUT range float8) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_scan_beams' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5000 ROWS 4000;
COMMENT ON FUNCTION _ab_beams_010(ab_scan) IS 'ab_beams as it was in 0.1.0: for what was made with it';
