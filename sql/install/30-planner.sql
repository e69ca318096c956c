-- What ANALYZE and the planner ask.

CREATE FUNCTION _ab_typanalyze(internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_typanalyze' LANGUAGE c STRICT PARALLEL SAFE STABLE;
COMMENT ON FUNCTION _ab_typanalyze(internal) IS
    'ANALYZE of a column of boxes, solids, patches, points or lines: where they lie and how large they are';

CREATE FUNCTION _ab_overlap_sel(internal, oid, internal, integer) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_overlap_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_overlap_sel(internal, oid, internal, integer) IS 'Planner: share of rows that && finds';

CREATE FUNCTION _ab_overlap_join_sel(internal, oid, internal, smallint, internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_overlap_join_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_overlap_join_sel(internal, oid, internal, smallint, internal) IS
    'Planner: share of pairs that && finds';

CREATE FUNCTION _ab_contains_sel(internal, oid, internal, integer) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_contains_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_contains_sel(internal, oid, internal, integer) IS 'Planner: share of rows that @> finds';

CREATE FUNCTION _ab_contains_join_sel(internal, oid, internal, smallint, internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_contains_join_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_contains_join_sel(internal, oid, internal, smallint, internal) IS
    'Planner: share of pairs that @> finds';

CREATE FUNCTION _ab_contained_sel(internal, oid, internal, integer) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_contained_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_contained_sel(internal, oid, internal, integer) IS 'Planner: share of rows that <@ finds';

CREATE FUNCTION _ab_contained_join_sel(internal, oid, internal, smallint, internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_contained_join_sel' LANGUAGE c STABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_contained_join_sel(internal, oid, internal, smallint, internal) IS
    'Planner: share of pairs that <@ finds';

ALTER TYPE ab_box SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_solid SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_scan SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_point SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_line SET (ANALYZE = _ab_typanalyze);
ALTER OPERATOR && (ab_box, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_scan) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_scan) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_scan, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_scan, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_scan, ab_scan) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_point, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_point, ab_point) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_line, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_point) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_line) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_point) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_point, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR @> (ab_box, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_solid, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_solid, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_solid) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_solid) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_scan, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_scan, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_scan) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_scan) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_point, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_point, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_point) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_point) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER TYPE ab_occupancy SET (ANALYZE = _ab_typanalyze);
ALTER TYPE ab_change SET (ANALYZE = _ab_typanalyze);
ALTER OPERATOR && (ab_occupancy, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_occupancy) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_occupancy, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_occupancy) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR @> (ab_occupancy, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_occupancy, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_occupancy) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_occupancy) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR && (ab_change, ab_box) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_box, ab_change) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_change, ab_solid) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR && (ab_solid, ab_change) SET (RESTRICT = _ab_overlap_sel, JOIN = _ab_overlap_join_sel);
ALTER OPERATOR @> (ab_change, ab_box) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_change, ab_box) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
ALTER OPERATOR @> (ab_box, ab_change) SET (RESTRICT = _ab_contains_sel, JOIN = _ab_contains_join_sel);
ALTER OPERATOR <@ (ab_box, ab_change) SET (RESTRICT = _ab_contained_sel, JOIN = _ab_contained_join_sel);
