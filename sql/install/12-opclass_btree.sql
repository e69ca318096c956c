-- Btree: an order of every type, for sorting and grouping.

CREATE FUNCTION _ab_compare(a ab_point, b ab_point) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_point_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_point, ab_point) IS '-1, 0 or 1 in the order of x, y, z, covariance';

CREATE OPERATOR CLASS ab_point_ops DEFAULT FOR TYPE ab_point USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_point, ab_point);
COMMENT ON OPERATOR CLASS ab_point_ops USING btree IS 'Order by x, y, z, covariance';

CREATE FUNCTION _ab_compare(a ab_line, b ab_line) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_line_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_line, ab_line) IS '-1, 0 or 1 in the order of start, end, covariance';

CREATE OPERATOR CLASS ab_line_ops DEFAULT FOR TYPE ab_line USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_line, ab_line);
COMMENT ON OPERATOR CLASS ab_line_ops USING btree IS 'Order by start, end, covariance';

CREATE FUNCTION _ab_compare(a ab_plane, b ab_plane) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_plane_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_plane, ab_plane) IS '-1, 0 or 1 in the order of point, normal, covariance';

CREATE OPERATOR CLASS ab_plane_ops DEFAULT FOR TYPE ab_plane USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_plane, ab_plane);
COMMENT ON OPERATOR CLASS ab_plane_ops USING btree IS 'Order by point, normal, covariance';

CREATE FUNCTION _ab_compare(a ab_pose, b ab_pose) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_pose_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_pose, ab_pose) IS
    '-1, 0 or 1 in the order of rotation, translation, scale, covariance';

CREATE OPERATOR CLASS ab_pose_ops DEFAULT FOR TYPE ab_pose USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_pose, ab_pose);
COMMENT ON OPERATOR CLASS ab_pose_ops USING btree IS 'Order by rotation, translation, scale, covariance';

CREATE FUNCTION _ab_compare(a ab_mass, b ab_mass) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_mass_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_mass, ab_mass) IS '-1, 0 or 1 in the order of occupied, empty, unknown';

CREATE OPERATOR CLASS ab_mass_ops DEFAULT FOR TYPE ab_mass USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_mass, ab_mass);
COMMENT ON OPERATOR CLASS ab_mass_ops USING btree IS 'Order by occupied, empty, unknown';

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
