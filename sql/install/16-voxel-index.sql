-- Boxes compared, so that rows can be joined and grouped by tile.

CREATE FUNCTION ab_differ(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_box, ab_box) IS 'Not the same numbers';
CREATE FUNCTION ab_hash(box ab_box) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_box_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_box) IS 'Hash of the numbers';
CREATE FUNCTION ab_hash(box ab_box, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_box_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_box, bigint) IS 'Hash of the numbers with a seed';
CREATE OPERATOR = (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_box, ab_box) IS 'Same numbers';
CREATE OPERATOR <> (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_box, ab_box) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_box_hash_ops DEFAULT FOR TYPE ab_box USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_box), FUNCTION 2 ab_hash(ab_box, bigint);
COMMENT ON OPERATOR CLASS ab_box_hash_ops USING hash IS 'Joins and groups by equal numbers';
CREATE FUNCTION ab_lt(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_box, ab_box) IS 'Before in the order of their corners';
CREATE OPERATOR < (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_box, ab_box) IS 'Before in the order of their corners';
CREATE FUNCTION ab_le(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_box, ab_box) IS 'Not after in the order of their corners';
CREATE OPERATOR <= (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_box, ab_box) IS 'Not after in the order of their corners';
CREATE FUNCTION ab_ge(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_box, ab_box) IS 'Not before in the order of their corners';
CREATE OPERATOR >= (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_box, ab_box) IS 'Not before in the order of their corners';
CREATE FUNCTION ab_gt(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_box, ab_box) IS 'After in the order of their corners';
CREATE OPERATOR > (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_box, ab_box) IS 'After in the order of their corners';
CREATE FUNCTION ab_compare(a ab_box, b ab_box) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_box_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_box, ab_box) IS '-1, 0 or 1 in the order of their corners';
CREATE OPERATOR CLASS ab_box_ops DEFAULT FOR TYPE ab_box USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_box, ab_box);
COMMENT ON OPERATOR CLASS ab_box_ops USING btree IS 'Order by their corners';

-- Occupancy and change joined by their boxes with everything that has one.

CREATE FUNCTION ab_overlaps(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_occupancy, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_occupancy) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_occupancy, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_occupancy, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_occupancy) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_contains(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_contains(ab_occupancy, ab_box) IS 'Does the box of an occupancy hold a box';

CREATE FUNCTION ab_contained(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_contained(ab_occupancy, ab_box) IS 'Does the box of an occupancy lie in a box';

CREATE FUNCTION ab_same(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_same(ab_occupancy, ab_box) IS 'Is the box of an occupancy that box';

CREATE FUNCTION ab_box_distance(a ab_occupancy, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box_distance(ab_occupancy, ab_box) IS 'Least distance of the box of an occupancy from a box, metres';

CREATE FUNCTION ab_box_distance(a ab_occupancy, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box_distance(ab_occupancy, ab_point) IS 'Least distance of the box of an occupancy from a point, metres';

CREATE FUNCTION ab_contains(a ab_box, b ab_occupancy) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN ab_contained(b, a);
COMMENT ON FUNCTION ab_contains(ab_box, ab_occupancy) IS 'Does a box hold the box of an occupancy';

CREATE FUNCTION ab_contained(a ab_box, b ab_occupancy) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN ab_contains(b, a);
COMMENT ON FUNCTION ab_contained(ab_box, ab_occupancy) IS 'Does a box lie in the box of an occupancy';

CREATE OPERATOR && (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_occupancy, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_box, ab_occupancy) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_occupancy, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_occupancy, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_occupancy, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_solid, ab_occupancy) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR @> (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_occupancy, ab_box) IS 'Does the box of an occupancy hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_occupancy, ab_box) IS 'Does the box of an occupancy lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_box, ab_occupancy) IS 'Does a box hold the box of an occupancy';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_box, ab_occupancy) IS 'Does a box lie in the box of an occupancy';
CREATE OPERATOR ~= (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_occupancy, ab_box) IS 'Is the box of an occupancy that box';
CREATE OPERATOR <-> (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_occupancy, ab_box) IS 'Least distance of the box of an occupancy from a box, metres; for nearest first';
CREATE OPERATOR <-> (LEFTARG = ab_occupancy, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_occupancy, ab_point) IS 'Least distance of the box of an occupancy from a point, metres; for nearest first';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_occupancy, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_occupancy, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_occupancy, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_occupancy, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_overlaps(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_change, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_change, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_change, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION ab_contains(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_contains(ab_change, ab_box) IS 'Does the box of a change hold a box';

CREATE FUNCTION ab_contained(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_contained(ab_change, ab_box) IS 'Does the box of a change lie in a box';

CREATE FUNCTION ab_same(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_same(ab_change, ab_box) IS 'Is the box of a change that box';

CREATE FUNCTION ab_box_distance(a ab_change, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box_distance(ab_change, ab_box) IS 'Least distance of the box of a change from a box, metres';

CREATE FUNCTION ab_box_distance(a ab_change, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box_distance(ab_change, ab_point) IS 'Least distance of the box of a change from a point, metres';

CREATE FUNCTION ab_contains(a ab_box, b ab_change) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN ab_contained(b, a);
COMMENT ON FUNCTION ab_contains(ab_box, ab_change) IS 'Does a box hold the box of a change';

CREATE FUNCTION ab_contained(a ab_box, b ab_change) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN ab_contains(b, a);
COMMENT ON FUNCTION ab_contained(ab_box, ab_change) IS 'Does a box lie in the box of a change';

CREATE OPERATOR && (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_change, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_box, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_change, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_change, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_change, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_solid, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';
CREATE OPERATOR @> (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_change, ab_box) IS 'Does the box of a change hold a box';
CREATE OPERATOR <@ (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_change, ab_box) IS 'Does the box of a change lie in a box';
CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = ab_contains, COMMUTATOR = <@, RESTRICT = ab_contains_sel, JOIN = ab_contains_join_sel);
COMMENT ON OPERATOR @> (ab_box, ab_change) IS 'Does a box hold the box of a change';
CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = ab_contained, COMMUTATOR = @>, RESTRICT = ab_contained_sel, JOIN = ab_contained_join_sel);
COMMENT ON OPERATOR <@ (ab_box, ab_change) IS 'Does a box lie in the box of a change';
CREATE OPERATOR ~= (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_change, ab_box) IS 'Is the box of a change that box';
CREATE OPERATOR <-> (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_change, ab_box) IS 'Least distance of the box of a change from a box, metres; for nearest first';
CREATE OPERATOR <-> (LEFTARG = ab_change, RIGHTARG = ab_point, FUNCTION = ab_box_distance);
COMMENT ON OPERATOR <-> (ab_change, ab_point) IS 'Least distance of the box of a change from a point, metres; for nearest first';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_change, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_change, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_distance(entry internal, query ab_change, strategy smallint, subtype oid, recheck internal) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_gist_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_distance(internal, ab_change, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_tile_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_tile_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_tile_compress(internal) IS 'GiST support';

CREATE OPERATOR CLASS ab_occupancy_gist_ops DEFAULT FOR TYPE ab_occupancy USING gist AS
    OPERATOR 1 && (ab_occupancy, ab_box), OPERATOR 2 && (ab_occupancy, ab_solid),
    OPERATOR 10 @> (ab_occupancy, ab_box), OPERATOR 11 <@ (ab_occupancy, ab_box), OPERATOR 12 ~= (ab_occupancy, ab_box),
    OPERATOR 13 <-> (ab_occupancy, ab_box) FOR ORDER BY float_ops, OPERATOR 14 <-> (ab_occupancy, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 ab_gist_consistent(internal, ab_occupancy, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_tile_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 ab_gist_distance(internal, ab_occupancy, smallint, oid, internal),
    FUNCTION 11 ab_gist_sort(internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_occupancy_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_change_gist_ops DEFAULT FOR TYPE ab_change USING gist AS
    OPERATOR 1 && (ab_change, ab_box), OPERATOR 2 && (ab_change, ab_solid),
    OPERATOR 10 @> (ab_change, ab_box), OPERATOR 11 <@ (ab_change, ab_box), OPERATOR 12 ~= (ab_change, ab_box),
    OPERATOR 13 <-> (ab_change, ab_box) FOR ORDER BY float_ops, OPERATOR 14 <-> (ab_change, ab_point) FOR ORDER BY float_ops,
    FUNCTION 1 ab_gist_consistent(internal, ab_change, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_tile_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    FUNCTION 8 ab_gist_distance(internal, ab_change, smallint, oid, internal),
    FUNCTION 11 ab_gist_sort(internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_change_gist_ops USING gist IS 'Joins on && by boxes';

ALTER OPERATOR FAMILY ab_solid_gist_ops USING gist ADD OPERATOR 6 && (ab_solid, ab_occupancy), OPERATOR 7 && (ab_solid, ab_change);
ALTER OPERATOR FAMILY ab_box_gist_ops USING gist ADD OPERATOR 6 && (ab_box, ab_occupancy), OPERATOR 7 && (ab_box, ab_change);
