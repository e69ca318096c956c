-- Equality, order and hash by bytes, for the types that have no other: a table with such a column can be replicated with
-- REPLICA IDENTITY FULL, compared row by row, and grouped.

-- ab_solid
CREATE FUNCTION _ab_equal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_solid, ab_solid) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_solid, ab_solid) IS 'Of operator <>';
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
CREATE FUNCTION _ab_compare(a ab_solid, b ab_solid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_solid, ab_solid) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_solid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_solid) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_solid, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_solid, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_solid, ab_solid) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_solid, ab_solid) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_solid, ab_solid) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_solid, ab_solid) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_solid, ab_solid) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_solid, ab_solid) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_solid_btree_ops DEFAULT FOR TYPE ab_solid USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_solid, ab_solid);
COMMENT ON OPERATOR CLASS ab_solid_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_solid_hash_ops DEFAULT FOR TYPE ab_solid USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_solid), FUNCTION 2 _ab_hash(ab_solid, bigint);
COMMENT ON OPERATOR CLASS ab_solid_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_scan
CREATE FUNCTION _ab_equal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_scan, ab_scan) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_scan, ab_scan) IS 'Of operator <>';
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
CREATE FUNCTION _ab_compare(a ab_scan, b ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_scan, ab_scan) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_scan) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_scan) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_scan, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_scan, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_scan, ab_scan) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_scan, ab_scan) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_scan, ab_scan) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_scan, ab_scan) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_scan, ab_scan) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_scan, ab_scan) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_scan_btree_ops DEFAULT FOR TYPE ab_scan USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_scan, ab_scan);
COMMENT ON OPERATOR CLASS ab_scan_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_scan_hash_ops DEFAULT FOR TYPE ab_scan USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_scan), FUNCTION 2 _ab_hash(ab_scan, bigint);
COMMENT ON OPERATOR CLASS ab_scan_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_evidence
CREATE FUNCTION _ab_equal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_evidence, ab_evidence) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_evidence, ab_evidence) IS 'Of operator <>';
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
CREATE FUNCTION _ab_compare(a ab_evidence, b ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_evidence, ab_evidence) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_evidence) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_evidence, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_evidence, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_evidence, ab_evidence) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_evidence, ab_evidence) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_evidence, ab_evidence) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_evidence, ab_evidence) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_evidence, ab_evidence) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_evidence, ab_evidence) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_evidence_btree_ops DEFAULT FOR TYPE ab_evidence USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_evidence, ab_evidence);
COMMENT ON OPERATOR CLASS ab_evidence_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_evidence_hash_ops DEFAULT FOR TYPE ab_evidence USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_evidence), FUNCTION 2 _ab_hash(ab_evidence, bigint);
COMMENT ON OPERATOR CLASS ab_evidence_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_occupancy
CREATE FUNCTION _ab_equal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_occupancy, ab_occupancy) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_occupancy, ab_occupancy) IS 'Of operator <>';
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
CREATE FUNCTION _ab_compare(a ab_occupancy, b ab_occupancy) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_occupancy, ab_occupancy) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_occupancy) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_occupancy) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_occupancy, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_occupancy, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_occupancy, ab_occupancy) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_occupancy, ab_occupancy) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_occupancy, ab_occupancy) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_occupancy, ab_occupancy) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_occupancy, ab_occupancy) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_occupancy, ab_occupancy) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_occupancy_btree_ops DEFAULT FOR TYPE ab_occupancy USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_occupancy, ab_occupancy);
COMMENT ON OPERATOR CLASS ab_occupancy_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_occupancy_hash_ops DEFAULT FOR TYPE ab_occupancy USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_occupancy), FUNCTION 2 _ab_hash(ab_occupancy, bigint);
COMMENT ON OPERATOR CLASS ab_occupancy_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_change
CREATE FUNCTION _ab_equal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_change, ab_change) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_change, ab_change) IS 'Of operator <>';
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
CREATE FUNCTION _ab_compare(a ab_change, b ab_change) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_compare(ab_change, ab_change) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_change) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_bytes_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_change) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_change, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_bytes_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_hash(ab_change, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_change, ab_change) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_change, ab_change) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_change, ab_change) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_change, ab_change) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_change, ab_change) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_change, ab_change) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_change_btree_ops DEFAULT FOR TYPE ab_change USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_change, ab_change);
COMMENT ON OPERATOR CLASS ab_change_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_change_hash_ops DEFAULT FOR TYPE ab_change USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_change), FUNCTION 2 _ab_hash(ab_change, bigint);
COMMENT ON OPERATOR CLASS ab_change_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_evidence_model
CREATE FUNCTION _ab_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_evidence_model, ab_evidence_model) IS 'Of operator <>';
CREATE FUNCTION _ab_less(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_evidence_model, ab_evidence_model) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_evidence_model_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_evidence_model, ab_evidence_model) IS 'Of operator >';
CREATE FUNCTION _ab_compare(a ab_evidence_model, b ab_evidence_model) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_model_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_evidence_model, ab_evidence_model) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_evidence_model) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_model_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_evidence_model) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_evidence_model, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_evidence_model_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_evidence_model, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_evidence_model, ab_evidence_model) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_evidence_model, ab_evidence_model) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_evidence_model, ab_evidence_model) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_evidence_model, ab_evidence_model) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_evidence_model, ab_evidence_model) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_evidence_model, ab_evidence_model) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_evidence_model_btree_ops DEFAULT FOR TYPE ab_evidence_model USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_evidence_model, ab_evidence_model);
COMMENT ON OPERATOR CLASS ab_evidence_model_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_evidence_model_hash_ops DEFAULT FOR TYPE ab_evidence_model USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_evidence_model), FUNCTION 2 _ab_hash(ab_evidence_model, bigint);
COMMENT ON OPERATOR CLASS ab_evidence_model_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- ab_grid
CREATE FUNCTION _ab_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_grid, ab_grid) IS 'Of operator =';
CREATE FUNCTION _ab_unequal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_grid, ab_grid) IS 'Of operator <>';
CREATE FUNCTION _ab_less(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_grid, ab_grid) IS 'Of operator <';
CREATE FUNCTION _ab_less_or_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_grid, ab_grid) IS 'Of operator <=';
CREATE FUNCTION _ab_greater_or_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_grid, ab_grid) IS 'Of operator >=';
CREATE FUNCTION _ab_greater(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_grid_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_grid, ab_grid) IS 'Of operator >';
CREATE FUNCTION _ab_compare(a ab_grid, b ab_grid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_grid_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_compare(ab_grid, ab_grid) IS 'Btree support';
CREATE FUNCTION _ab_hash(a ab_grid) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_grid_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_grid) IS 'Hash support';
CREATE FUNCTION _ab_hash(a ab_grid, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_grid_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_hash(ab_grid, bigint) IS 'Hash support';
CREATE OPERATOR = (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_grid, ab_grid) IS 'Same value, to the byte of the current layout';
CREATE OPERATOR <> (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_grid, ab_grid) IS 'Different values';
CREATE OPERATOR < (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_grid, ab_grid) IS 'Before, in the order of the bytes: for sorting and grouping, without a meaning';
CREATE OPERATOR <= (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_grid, ab_grid) IS 'Before or equal, in the order of the bytes';
CREATE OPERATOR >= (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_grid, ab_grid) IS 'After or equal, in the order of the bytes';
CREATE OPERATOR > (LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_grid, ab_grid) IS 'After, in the order of the bytes';
CREATE OPERATOR CLASS ab_grid_btree_ops DEFAULT FOR TYPE ab_grid USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 _ab_compare(ab_grid, ab_grid);
COMMENT ON OPERATOR CLASS ab_grid_btree_ops USING btree IS 'By bytes, for sorting and grouping';
CREATE OPERATOR CLASS ab_grid_hash_ops DEFAULT FOR TYPE ab_grid USING hash AS
    OPERATOR 1 =, FUNCTION 1 _ab_hash(ab_grid), FUNCTION 2 _ab_hash(ab_grid, bigint);
COMMENT ON OPERATOR CLASS ab_grid_hash_ops USING hash IS 'By bytes, for grouping and joins';

-- What asbuilt takes in this session's process.
CREATE FUNCTION ab_memory(from_now boolean DEFAULT false, OUT live bigint, OUT peak bigint) RETURNS record
    AS 'MODULE_PATHNAME' LANGUAGE c VOLATILE PARALLEL RESTRICTED;
COMMENT ON FUNCTION ab_memory(boolean) IS
    'Bytes that asbuilt''s values and work take in this session''s process now, and the most they ever took; from_now begins the peak anew. What PostgreSQL itself holds of them (rows, results) is not counted';
