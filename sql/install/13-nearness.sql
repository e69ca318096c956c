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
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_box, ab_box) IS 'Does a box hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
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
CREATE OPERATOR @> (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_solid, ab_box) IS 'Does the box of a solid hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_solid, ab_box) IS 'Does the box of a solid lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_solid, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_box, ab_solid) IS 'Does a box hold the box of a solid';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_solid, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_box, ab_solid) IS 'Does a box lie in the box of a solid';
CREATE OPERATOR ~= (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_solid, ab_box) IS 'Is the box of a solid that box';
CREATE OPERATOR <-> (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_solid, ab_box) IS 'Least distance of the box of a solid from a box, metres; for nearest first';

CREATE FUNCTION ab_contains(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_contains(ab_scan, ab_box) IS 'Does the hull of a patch hold a box';

CREATE FUNCTION ab_contained(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_contained(ab_scan, ab_box) IS 'Does the hull of a patch lie in a box';

CREATE FUNCTION ab_same(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_same(ab_scan, ab_box) IS 'Is the hull of a patch that box';

CREATE FUNCTION ab_box_distance(a ab_scan, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_scan_distance_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_box_distance(ab_scan, ab_box) IS 'Least distance of the box of a patch''s returns from a box, metres; infinite without returns';

CREATE FUNCTION ab_contains(a ab_box, b ab_scan) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN ab_contained(b, a);
COMMENT ON FUNCTION ab_contains(ab_box, ab_scan) IS 'Does a box hold the hull of a patch';

CREATE FUNCTION ab_contained(a ab_box, b ab_scan) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN ab_contains(b, a);
COMMENT ON FUNCTION ab_contained(ab_box, ab_scan) IS 'Does a box lie in the hull of a patch';
CREATE OPERATOR @> (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_scan, ab_box) IS 'Does the hull of a patch hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_scan, ab_box) IS 'Does the hull of a patch lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_scan, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_box, ab_scan) IS 'Does a box hold the hull of a patch';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_scan, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_box, ab_scan) IS 'Does a box lie in the hull of a patch';
CREATE OPERATOR ~= (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_scan, ab_box) IS 'Is the hull of a patch that box';
CREATE OPERATOR <-> (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_scan, ab_box) IS 'Least distance of the box of a patch''s returns from a box, metres; infinite without returns; for nearest first';

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
CREATE OPERATOR @> (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_point, ab_box) IS 'Does the box of a point grown by five standard deviations hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_point, ab_box) IS 'Does the box of a point grown by five standard deviations lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_box, ab_point) IS 'Does a box hold the box of a point grown by five standard deviations';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_box, ab_point) IS 'Does a box lie in the box of a point grown by five standard deviations';
CREATE OPERATOR ~= (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_point, ab_box) IS 'Is the box of a point grown by five standard deviations that box';
CREATE OPERATOR <-> (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_point, ab_box) IS 'Least distance of the box of a point grown by five standard deviations from a box, metres; for nearest first';

CREATE FUNCTION ab_box_distance(a ab_box, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_box_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_box, ab_point) IS 'Least distance of a box from a point, metres';
CREATE OPERATOR <-> (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_box, ab_point) IS 'Least distance of a box from a point, metres; for nearest first';

CREATE FUNCTION ab_box_distance(a ab_solid, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_solid_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_solid, ab_point) IS 'Least distance of the box of a solid from a point, metres';
CREATE OPERATOR <-> (LEFTARG = ab_solid, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_solid, ab_point) IS 'Least distance of the box of a solid from a point, metres; for nearest first';

CREATE FUNCTION ab_box_distance(a ab_scan, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_scan_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_box_distance(ab_scan, ab_point) IS 'Least distance of the box of a patch''s returns from a point, metres; infinite without returns';
CREATE OPERATOR <-> (LEFTARG = ab_scan, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_scan, ab_point) IS 'Least distance of the box of a patch''s returns from a point, metres; infinite without returns; for nearest first';

CREATE FUNCTION ab_box_distance(a ab_point, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_box_distance(ab_point, ab_point) IS 'Least distance of a point from a point, metres; uncertainties do not count';
CREATE OPERATOR <-> (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_point, ab_point) IS 'Least distance of a point from a point, metres; uncertainties do not count; for nearest first';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_box, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_box, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_solid, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_solid, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_scan, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance_lossy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_scan, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_point, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance_lossy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_point, smallint, oid, internal) IS 'GiST support';

ALTER OPERATOR FAMILY ab_box_gist_ops USING gist ADD
    OPERATOR 10 @> (ab_box, ab_box), OPERATOR 11 <@ (ab_box, ab_box), OPERATOR 12 ~= (ab_box, ab_box),
    OPERATOR 13 <-> (ab_box, ab_box) FOR ORDER BY float_ops, OPERATOR 14 <-> (ab_box, ab_point) FOR ORDER BY float_ops,
    FUNCTION 8 (ab_box, ab_box) ab_gist_distance(internal, ab_box, smallint, oid, internal);

ALTER OPERATOR FAMILY ab_solid_gist_ops USING gist ADD
    OPERATOR 10 @> (ab_solid, ab_box), OPERATOR 11 <@ (ab_solid, ab_box), OPERATOR 12 ~= (ab_solid, ab_box),
    OPERATOR 13 <-> (ab_solid, ab_box) FOR ORDER BY float_ops, OPERATOR 14 <-> (ab_solid, ab_point) FOR ORDER BY float_ops,
    FUNCTION 8 (ab_solid, ab_solid) ab_gist_distance(internal, ab_solid, smallint, oid, internal);

ALTER OPERATOR FAMILY ab_scan_gist_ops USING gist ADD
    OPERATOR 10 @> (ab_scan, ab_box), OPERATOR 11 <@ (ab_scan, ab_box), OPERATOR 12 ~= (ab_scan, ab_box),
    OPERATOR 13 <-> (ab_scan, ab_box) FOR ORDER BY float_ops, OPERATOR 14 <-> (ab_scan, ab_point) FOR ORDER BY float_ops,
    FUNCTION 8 (ab_scan, ab_scan) ab_gist_distance(internal, ab_scan, smallint, oid, internal);

ALTER OPERATOR FAMILY ab_point_gist_ops USING gist ADD
    OPERATOR 10 @> (ab_point, ab_box), OPERATOR 11 <@ (ab_point, ab_box), OPERATOR 12 ~= (ab_point, ab_box),
    OPERATOR 13 <-> (ab_point, ab_box) FOR ORDER BY float_ops, OPERATOR 14 <-> (ab_point, ab_point) FOR ORDER BY float_ops,
    FUNCTION 8 (ab_point, ab_point) ab_gist_distance(internal, ab_point, smallint, oid, internal);

-- A sorted build: keys along a Hilbert curve.

CREATE FUNCTION ab_gist_sort(support internal) RETURNS void
    AS 'MODULE_PATHNAME', 'ab_gist_sort' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_sort(internal) IS 'GiST support';

ALTER OPERATOR FAMILY ab_box_gist_ops USING gist ADD FUNCTION 11 (ab_box, ab_box) ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_solid_gist_ops USING gist ADD FUNCTION 11 (ab_solid, ab_solid) ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_scan_gist_ops USING gist ADD FUNCTION 11 (ab_scan, ab_scan) ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_point_gist_ops USING gist ADD FUNCTION 11 (ab_point, ab_point) ab_gist_sort(internal);
ALTER OPERATOR FAMILY ab_line_gist_ops USING gist ADD FUNCTION 11 (ab_line, ab_line) ab_gist_sort(internal);
