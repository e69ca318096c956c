-- Hash: joins and groups by equal values, on every type but the rows.

CREATE FUNCTION _ab_hash(point ab_point) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_point_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_point) IS 'Hash of the numbers';

CREATE FUNCTION _ab_hash(point ab_point, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_point_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_point, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR CLASS ab_point_hash_ops DEFAULT FOR TYPE ab_point USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_point), FUNCTION 2 _ab_hash(ab_point, bigint);
COMMENT ON OPERATOR CLASS ab_point_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION _ab_hash(line ab_line) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_line_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_line) IS 'Hash of the numbers';

CREATE FUNCTION _ab_hash(line ab_line, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_line_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_line, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR CLASS ab_line_hash_ops DEFAULT FOR TYPE ab_line USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_line), FUNCTION 2 _ab_hash(ab_line, bigint);
COMMENT ON OPERATOR CLASS ab_line_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION _ab_hash(plane ab_plane) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_plane_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_plane) IS 'Hash of the numbers';

CREATE FUNCTION _ab_hash(plane ab_plane, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_plane_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_plane, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR CLASS ab_plane_hash_ops DEFAULT FOR TYPE ab_plane USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_plane), FUNCTION 2 _ab_hash(ab_plane, bigint);
COMMENT ON OPERATOR CLASS ab_plane_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION _ab_hash(pose ab_pose) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_pose_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_pose) IS 'Hash of the numbers';

CREATE FUNCTION _ab_hash(pose ab_pose, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_pose_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_pose, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR CLASS ab_pose_hash_ops DEFAULT FOR TYPE ab_pose USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_pose), FUNCTION 2 _ab_hash(ab_pose, bigint);
COMMENT ON OPERATOR CLASS ab_pose_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION _ab_hash(mass ab_mass) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_mass_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_mass) IS 'Hash of the numbers';

CREATE FUNCTION _ab_hash(mass ab_mass, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_mass_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_mass, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR CLASS ab_mass_hash_ops DEFAULT FOR TYPE ab_mass USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_mass), FUNCTION 2 _ab_hash(ab_mass, bigint);
COMMENT ON OPERATOR CLASS ab_mass_hash_ops USING hash IS 'Joins and groups by equal numbers';

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
