-- GiST: keys are boxes from outside, as && sees them; strategy numbers say the right-hand type.

CREATE FUNCTION _ab_gist_consistent(
    entry internal, query ab_box, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_consistent(internal, ab_box, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_consistent(
    entry internal, query ab_solid, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_consistent(internal, ab_solid, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_consistent(
    entry internal, query ab_scan, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_consistent(internal, ab_scan, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_union(entries internal, size internal) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_gist_union' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_union(internal, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_scan_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_scan_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_scan_compress(internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_solid_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_solid_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_solid_compress(internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_penalty(key internal, entry internal, result internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_penalty' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_penalty(internal, internal, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_picksplit(entries internal, result internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_picksplit' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_picksplit(internal, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_same(a ab_box, b ab_box, result internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_same(ab_box, ab_box, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_consistent(
    entry internal, query ab_point, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_consistent(internal, ab_point, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_point_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_point_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_point_compress(internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_consistent(
    entry internal, query ab_line, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_consistent(internal, ab_line, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_line_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_line_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_line_compress(internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_distance(
    entry internal, query ab_box, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_distance(internal, ab_box, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_distance(
    entry internal, query ab_solid, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_distance(internal, ab_solid, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_distance(
    entry internal, query ab_scan, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance_lossy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_distance(internal, ab_scan, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_distance(
    entry internal, query ab_point, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance_lossy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_distance(internal, ab_point, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_sort(support internal) RETURNS void
    AS 'MODULE_PATHNAME', 'ab_gist_sort' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_sort(internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_consistent(
    entry internal, query ab_occupancy, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_consistent(internal, ab_occupancy, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_distance(
    entry internal, query ab_occupancy, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_distance(internal, ab_occupancy, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_consistent(
    entry internal, query ab_change, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_consistent(internal, ab_change, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_distance(
    entry internal, query ab_change, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_distance(internal, ab_change, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION _ab_gist_tile_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_tile_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_gist_tile_compress(internal) IS 'GiST support';

CREATE OPERATOR CLASS ab_box_gist_ops DEFAULT FOR TYPE ab_box USING gist AS
    OPERATOR 1 && (ab_box, ab_box), OPERATOR 2 && (ab_box, ab_solid), OPERATOR 3 && (ab_box, ab_scan),
    OPERATOR 6 && (ab_box, ab_occupancy), OPERATOR 7 && (ab_box, ab_change), OPERATOR 10 @> (ab_box, ab_box),
    OPERATOR 11 <@ (ab_box, ab_box), OPERATOR 12 ~= (ab_box, ab_box),
    OPERATOR 13 <-> (ab_box, ab_box) FOR ORDER BY float_ops, OPERATOR 14 <-> (ab_box, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 _ab_gist_consistent(internal, ab_box, smallint, oid, internal),
    FUNCTION 2 _ab_gist_union(internal, internal), FUNCTION 5 _ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 _ab_gist_picksplit(internal, internal), FUNCTION 7 _ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 (ab_box, ab_box) _ab_gist_distance(internal, ab_box, smallint, oid, internal),
    FUNCTION 11 (ab_box, ab_box) _ab_gist_sort(internal);
COMMENT ON OPERATOR CLASS ab_box_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_solid_gist_ops DEFAULT FOR TYPE ab_solid USING gist AS
    OPERATOR 1 && (ab_solid, ab_box), OPERATOR 2 && (ab_solid, ab_solid), OPERATOR 3 && (ab_solid, ab_scan),
    OPERATOR 6 && (ab_solid, ab_occupancy), OPERATOR 7 && (ab_solid, ab_change), OPERATOR 10 @> (ab_solid, ab_box),
    OPERATOR 11 <@ (ab_solid, ab_box), OPERATOR 12 ~= (ab_solid, ab_box),
    OPERATOR 13 <-> (ab_solid, ab_box) FOR ORDER BY float_ops,
    OPERATOR 14 <-> (ab_solid, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 _ab_gist_consistent(internal, ab_solid, smallint, oid, internal),
    FUNCTION 2 _ab_gist_union(internal, internal), FUNCTION 3 _ab_gist_solid_compress(internal),
    FUNCTION 5 _ab_gist_penalty(internal, internal, internal), FUNCTION 6 _ab_gist_picksplit(internal, internal),
    FUNCTION 7 _ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 (ab_solid, ab_solid) _ab_gist_distance(internal, ab_solid, smallint, oid, internal),
    FUNCTION 11 (ab_solid, ab_solid) _ab_gist_sort(internal), STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_solid_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_scan_gist_ops DEFAULT FOR TYPE ab_scan USING gist AS
    OPERATOR 1 && (ab_scan, ab_box), OPERATOR 2 && (ab_scan, ab_solid), OPERATOR 3 && (ab_scan, ab_scan),
    OPERATOR 10 @> (ab_scan, ab_box), OPERATOR 11 <@ (ab_scan, ab_box), OPERATOR 12 ~= (ab_scan, ab_box),
    OPERATOR 13 <-> (ab_scan, ab_box) FOR ORDER BY float_ops,
    OPERATOR 14 <-> (ab_scan, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 _ab_gist_consistent(internal, ab_scan, smallint, oid, internal),
    FUNCTION 2 _ab_gist_union(internal, internal), FUNCTION 3 _ab_gist_scan_compress(internal),
    FUNCTION 5 _ab_gist_penalty(internal, internal, internal), FUNCTION 6 _ab_gist_picksplit(internal, internal),
    FUNCTION 7 _ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 (ab_scan, ab_scan) _ab_gist_distance(internal, ab_scan, smallint, oid, internal),
    FUNCTION 11 (ab_scan, ab_scan) _ab_gist_sort(internal), STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_scan_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_point_gist_ops DEFAULT FOR TYPE ab_point USING gist AS
    OPERATOR 1 && (ab_point, ab_box), OPERATOR 4 && (ab_point, ab_point), OPERATOR 5 && (ab_point, ab_solid),
    OPERATOR 10 @> (ab_point, ab_box), OPERATOR 11 <@ (ab_point, ab_box), OPERATOR 12 ~= (ab_point, ab_box),
    OPERATOR 13 <-> (ab_point, ab_box) FOR ORDER BY float_ops,
    OPERATOR 14 <-> (ab_point, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 _ab_gist_consistent(internal, ab_point, smallint, oid, internal),
    FUNCTION 2 _ab_gist_union(internal, internal), FUNCTION 3 _ab_gist_point_compress(internal),
    FUNCTION 5 _ab_gist_penalty(internal, internal, internal), FUNCTION 6 _ab_gist_picksplit(internal, internal),
    FUNCTION 7 _ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 (ab_point, ab_point) _ab_gist_distance(internal, ab_point, smallint, oid, internal),
    FUNCTION 11 (ab_point, ab_point) _ab_gist_sort(internal), STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_point_gist_ops USING gist IS 'Joins on && by boxes grown by five standard deviations';

CREATE OPERATOR CLASS ab_line_gist_ops DEFAULT FOR TYPE ab_line USING gist AS
    OPERATOR 1 && (ab_line, ab_box), FUNCTION 1 _ab_gist_consistent(internal, ab_line, smallint, oid, internal),
    FUNCTION 2 _ab_gist_union(internal, internal), FUNCTION 3 _ab_gist_line_compress(internal),
    FUNCTION 5 _ab_gist_penalty(internal, internal, internal), FUNCTION 6 _ab_gist_picksplit(internal, internal),
    FUNCTION 7 _ab_gist_same(ab_box, ab_box, internal), FUNCTION 11 (ab_line, ab_line) _ab_gist_sort(internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_line_gist_ops USING gist IS 'Joins on && by boxes grown by five standard deviations';

CREATE OPERATOR CLASS ab_occupancy_gist_ops DEFAULT FOR TYPE ab_occupancy USING gist AS
    OPERATOR 1 && (ab_occupancy, ab_box), OPERATOR 2 && (ab_occupancy, ab_solid), OPERATOR 10 @> (ab_occupancy, ab_box),
    OPERATOR 11 <@ (ab_occupancy, ab_box), OPERATOR 12 ~= (ab_occupancy, ab_box),
    OPERATOR 13 <-> (ab_occupancy, ab_box) FOR ORDER BY float_ops,
    OPERATOR 14 <-> (ab_occupancy, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 _ab_gist_consistent(internal, ab_occupancy, smallint, oid, internal),
    FUNCTION 2 _ab_gist_union(internal, internal), FUNCTION 3 _ab_gist_tile_compress(internal),
    FUNCTION 5 _ab_gist_penalty(internal, internal, internal), FUNCTION 6 _ab_gist_picksplit(internal, internal),
    FUNCTION 7 _ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 _ab_gist_distance(internal, ab_occupancy, smallint, oid, internal), FUNCTION 11 _ab_gist_sort(internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_occupancy_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_change_gist_ops DEFAULT FOR TYPE ab_change USING gist AS
    OPERATOR 1 && (ab_change, ab_box), OPERATOR 2 && (ab_change, ab_solid), OPERATOR 10 @> (ab_change, ab_box),
    OPERATOR 11 <@ (ab_change, ab_box), OPERATOR 12 ~= (ab_change, ab_box),
    OPERATOR 13 <-> (ab_change, ab_box) FOR ORDER BY float_ops,
    OPERATOR 14 <-> (ab_change, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 _ab_gist_consistent(internal, ab_change, smallint, oid, internal),
    FUNCTION 2 _ab_gist_union(internal, internal), FUNCTION 3 _ab_gist_tile_compress(internal),
    FUNCTION 5 _ab_gist_penalty(internal, internal, internal), FUNCTION 6 _ab_gist_picksplit(internal, internal),
    FUNCTION 7 _ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 _ab_gist_distance(internal, ab_change, smallint, oid, internal), FUNCTION 11 _ab_gist_sort(internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_change_gist_ops USING gist IS 'Joins on && by boxes';
