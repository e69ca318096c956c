-- Operators and the functions behind them. Of a patch the hull of its beams counts, of <-> its returns; of voxels the
-- blocks of which something is known. What the planner asks of them: 30-planner.sql.

-- &&: boxes overlap.
CREATE FUNCTION _ab_overlaps(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_box, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION _ab_overlaps(a ab_box, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_box, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION _ab_overlaps(a ab_box, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_overlaps(ab_box, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION _ab_overlaps(a ab_solid, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_solid, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION _ab_overlaps(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_solid, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION _ab_overlaps(a ab_solid, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_overlaps(ab_solid, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION _ab_overlaps(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_overlaps(ab_scan, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION _ab_overlaps(a ab_scan, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_overlaps(ab_scan, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION _ab_overlaps(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_overlaps(ab_scan, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_box, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_solid, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_box, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_scan, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_box, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_solid, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_solid, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_scan, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_solid, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_scan, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_scan, RIGHTARG = ab_solid, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_scan, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_scan, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION _ab_overlaps(a ab_point, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_point, ab_box) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION _ab_overlaps(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_point_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_point, ab_point) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION _ab_overlaps(a ab_line, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_line_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_line, ab_box) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION _ab_overlaps(a ab_box, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_box, ab_point) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION _ab_overlaps(a ab_box, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_box, ab_line) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE OPERATOR && (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_point, ab_box) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE OPERATOR && (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_point, ab_point) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE OPERATOR && (LEFTARG = ab_line, RIGHTARG = ab_box, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_line, ab_box) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_box, ab_point) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_line, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_box, ab_line) IS
    'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION _ab_overlaps(a ab_solid, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_solid, ab_point) IS
    'Does a solid, grown by 0.25 m as for scans, meet the box of a point grown by five standard deviations';

CREATE FUNCTION _ab_overlaps(a ab_point, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_point_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_overlaps(ab_point, ab_solid) IS
    'Does a solid, grown by 0.25 m as for scans, meet the box of a point grown by five standard deviations';

CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_point, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_solid, ab_point) IS
    'A point may be of a solid: its box of five standard deviations meets the solid''s, grown by 0.25 m';

CREATE OPERATOR && (LEFTARG = ab_point, RIGHTARG = ab_solid, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_point, ab_solid) IS
    'A point may be of a solid: its box of five standard deviations meets the solid''s, grown by 0.25 m';

CREATE FUNCTION _ab_overlaps(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_occupancy, ab_box) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION _ab_overlaps(a ab_box, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_box, ab_occupancy) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION _ab_overlaps(a ab_occupancy, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_occupancy, ab_solid) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION _ab_overlaps(a ab_solid, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_solid, ab_occupancy) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE OPERATOR && (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_occupancy, ab_box) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_box, ab_occupancy) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE OPERATOR && (LEFTARG = ab_occupancy, RIGHTARG = ab_solid, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_occupancy, ab_solid) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_occupancy, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_solid, ab_occupancy) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION _ab_overlaps(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_change, ab_box) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION _ab_overlaps(a ab_box, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_box, ab_change) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION _ab_overlaps(a ab_change, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_tile_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_change, ab_solid) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE FUNCTION _ab_overlaps(a ab_solid, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_tile' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_overlaps(ab_solid, ab_change) IS
    'Boxes overlap; of voxels the blocks count of which something is known';

CREATE OPERATOR && (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_change, ab_box) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_box, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE OPERATOR && (LEFTARG = ab_change, RIGHTARG = ab_solid, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_change, ab_solid) IS 'Boxes overlap; of voxels the blocks count of which something is known';

CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_change, FUNCTION = _ab_overlaps, COMMUTATOR = &&);
COMMENT ON OPERATOR && (ab_solid, ab_change) IS 'Boxes overlap; of voxels the blocks count of which something is known';

-- @> and <@: one box holds the other.
CREATE FUNCTION _ab_contains(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_contains(ab_box, ab_box) IS 'Does a box hold a box';

CREATE FUNCTION _ab_contained(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_contained(ab_box, ab_box) IS 'Does a box lie in a box';

CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_box, ab_box) IS 'Does a box hold a box';

CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_box, ab_box) IS 'Does a box lie in a box';

CREATE FUNCTION _ab_contains(a ab_solid, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_solid_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_contains(ab_solid, ab_box) IS 'Does the box of a solid hold a box';

CREATE FUNCTION _ab_contained(a ab_solid, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_solid_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_contained(ab_solid, ab_box) IS 'Does the box of a solid lie in a box';

CREATE FUNCTION _ab_contains(a ab_box, b ab_solid) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN _ab_contained(b, a);
COMMENT ON FUNCTION _ab_contains(ab_box, ab_solid) IS 'Does a box hold the box of a solid';

CREATE FUNCTION _ab_contained(a ab_box, b ab_solid) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN _ab_contains(b, a);
COMMENT ON FUNCTION _ab_contained(ab_box, ab_solid) IS 'Does a box lie in the box of a solid';

CREATE OPERATOR @> (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_solid, ab_box) IS 'Does the box of a solid hold a box';

CREATE OPERATOR <@ (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_solid, ab_box) IS 'Does the box of a solid lie in a box';

CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_solid, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_box, ab_solid) IS 'Does a box hold the box of a solid';

CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_solid, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_box, ab_solid) IS 'Does a box lie in the box of a solid';

CREATE FUNCTION _ab_contains(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_contains(ab_scan, ab_box) IS 'Does the hull of a patch hold a box';

CREATE FUNCTION _ab_contained(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_contained(ab_scan, ab_box) IS 'Does the hull of a patch lie in a box';

CREATE FUNCTION _ab_contains(a ab_box, b ab_scan) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN _ab_contained(b, a);
COMMENT ON FUNCTION _ab_contains(ab_box, ab_scan) IS 'Does a box hold the hull of a patch';

CREATE FUNCTION _ab_contained(a ab_box, b ab_scan) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN _ab_contains(b, a);
COMMENT ON FUNCTION _ab_contained(ab_box, ab_scan) IS 'Does a box lie in the hull of a patch';

CREATE OPERATOR @> (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_scan, ab_box) IS 'Does the hull of a patch hold a box';

CREATE OPERATOR <@ (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_scan, ab_box) IS 'Does the hull of a patch lie in a box';

CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_scan, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_box, ab_scan) IS 'Does a box hold the hull of a patch';

CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_scan, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_box, ab_scan) IS 'Does a box lie in the hull of a patch';

CREATE FUNCTION _ab_contains(a ab_point, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_contains(ab_point, ab_box) IS
    'Does the box of a point grown by five standard deviations hold a box';

CREATE FUNCTION _ab_contained(a ab_point, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_contained(ab_point, ab_box) IS
    'Does the box of a point grown by five standard deviations lie in a box';

CREATE FUNCTION _ab_contains(a ab_box, b ab_point) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN _ab_contained(b, a);
COMMENT ON FUNCTION _ab_contains(ab_box, ab_point) IS
    'Does a box hold the box of a point grown by five standard deviations';

CREATE FUNCTION _ab_contained(a ab_box, b ab_point) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 5
    RETURN _ab_contains(b, a);
COMMENT ON FUNCTION _ab_contained(ab_box, ab_point) IS
    'Does a box lie in the box of a point grown by five standard deviations';

CREATE OPERATOR @> (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_point, ab_box) IS 'Does the box of a point grown by five standard deviations hold a box';

CREATE OPERATOR <@ (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_point, ab_box) IS 'Does the box of a point grown by five standard deviations lie in a box';

CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_box, ab_point) IS 'Does a box hold the box of a point grown by five standard deviations';

CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_box, ab_point) IS 'Does a box lie in the box of a point grown by five standard deviations';

CREATE FUNCTION _ab_contains(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_contains(ab_occupancy, ab_box) IS 'Does the box of an occupancy hold a box';

CREATE FUNCTION _ab_contained(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_contained(ab_occupancy, ab_box) IS 'Does the box of an occupancy lie in a box';

CREATE FUNCTION _ab_contains(a ab_box, b ab_occupancy) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN _ab_contained(b, a);
COMMENT ON FUNCTION _ab_contains(ab_box, ab_occupancy) IS 'Does a box hold the box of an occupancy';

CREATE FUNCTION _ab_contained(a ab_box, b ab_occupancy) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN _ab_contains(b, a);
COMMENT ON FUNCTION _ab_contained(ab_box, ab_occupancy) IS 'Does a box lie in the box of an occupancy';

CREATE OPERATOR @> (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_occupancy, ab_box) IS 'Does the box of an occupancy hold a box';

CREATE OPERATOR <@ (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_occupancy, ab_box) IS 'Does the box of an occupancy lie in a box';

CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_box, ab_occupancy) IS 'Does a box hold the box of an occupancy';

CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_occupancy, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_box, ab_occupancy) IS 'Does a box lie in the box of an occupancy';

CREATE FUNCTION _ab_contains(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contains' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_contains(ab_change, ab_box) IS 'Does the box of a change hold a box';

CREATE FUNCTION _ab_contained(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_contained' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_contained(ab_change, ab_box) IS 'Does the box of a change lie in a box';

CREATE FUNCTION _ab_contains(a ab_box, b ab_change) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN _ab_contained(b, a);
COMMENT ON FUNCTION _ab_contains(ab_box, ab_change) IS 'Does a box hold the box of a change';

CREATE FUNCTION _ab_contained(a ab_box, b ab_change) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE STRICT COST 20
    RETURN _ab_contains(b, a);
COMMENT ON FUNCTION _ab_contained(ab_box, ab_change) IS 'Does a box lie in the box of a change';

CREATE OPERATOR @> (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_change, ab_box) IS 'Does the box of a change hold a box';

CREATE OPERATOR <@ (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_change, ab_box) IS 'Does the box of a change lie in a box';

CREATE OPERATOR @> (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = _ab_contains, COMMUTATOR = <@);
COMMENT ON OPERATOR @> (ab_box, ab_change) IS 'Does a box hold the box of a change';

CREATE OPERATOR <@ (LEFTARG = ab_box, RIGHTARG = ab_change, FUNCTION = _ab_contained, COMMUTATOR = @>);
COMMENT ON OPERATOR <@ (ab_box, ab_change) IS 'Does a box lie in the box of a change';

-- = and <>.
CREATE FUNCTION _ab_equal(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_equal' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_box, ab_box) IS 'Same box';

CREATE FUNCTION _ab_equal(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_equal' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_mass, ab_mass) IS 'Same mass, bit by bit';

CREATE FUNCTION _ab_equal(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_point, ab_point) IS 'Same numbers';

CREATE FUNCTION _ab_unequal(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_point, ab_point) IS 'Not the same numbers';

CREATE OPERATOR = (
    LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_point, ab_point) IS 'Same numbers, covariance included';

CREATE OPERATOR <> (
    LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_point, ab_point) IS 'Not the same numbers';

CREATE FUNCTION _ab_equal(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_line, ab_line) IS 'Same numbers';

CREATE FUNCTION _ab_unequal(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_line, ab_line) IS 'Not the same numbers';

CREATE OPERATOR = (
    LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_line, ab_line) IS 'Same numbers, covariance included';

CREATE OPERATOR <> (
    LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_line, ab_line) IS 'Not the same numbers';

CREATE FUNCTION _ab_equal(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_plane, ab_plane) IS 'Same numbers';

CREATE FUNCTION _ab_unequal(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_plane, ab_plane) IS 'Not the same numbers';

CREATE OPERATOR = (
    LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_plane, ab_plane) IS 'Same numbers, covariance included';

CREATE OPERATOR <> (
    LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_plane, ab_plane) IS 'Not the same numbers';

CREATE FUNCTION _ab_equal(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_equal(ab_pose, ab_pose) IS 'Same numbers';

CREATE FUNCTION _ab_unequal(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_pose, ab_pose) IS 'Not the same numbers';

CREATE OPERATOR = (
    LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_pose, ab_pose) IS 'Same numbers, covariance included';

CREATE OPERATOR <> (
    LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_pose, ab_pose) IS 'Not the same numbers';

CREATE FUNCTION _ab_unequal(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_mass, ab_mass) IS 'Not the same numbers';

CREATE OPERATOR = (
    LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_mass, ab_mass) IS 'Same numbers';

CREATE OPERATOR <> (
    LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_mass, ab_mass) IS 'Not the same numbers';

CREATE FUNCTION _ab_unequal(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_unequal(ab_box, ab_box) IS 'Not the same numbers';

CREATE OPERATOR = (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_box, ab_box) IS 'Same numbers';

CREATE OPERATOR <> (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_box, ab_box) IS 'Not the same numbers';

CREATE FUNCTION _ab_equal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_solid, ab_solid) IS 'Of operator =';

CREATE FUNCTION _ab_unequal(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_solid, ab_solid) IS 'Of operator <>';

CREATE OPERATOR = (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_solid, ab_solid) IS 'Same value, to the byte of the current layout';

CREATE OPERATOR <> (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_solid, ab_solid) IS 'Different values';

CREATE FUNCTION _ab_equal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_scan, ab_scan) IS 'Of operator =';

CREATE FUNCTION _ab_unequal(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_scan, ab_scan) IS 'Of operator <>';

CREATE OPERATOR = (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_scan, ab_scan) IS 'Same value, to the byte of the current layout';

CREATE OPERATOR <> (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_scan, ab_scan) IS 'Different values';

CREATE FUNCTION _ab_equal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_evidence, ab_evidence) IS 'Of operator =';

CREATE FUNCTION _ab_unequal(a ab_evidence, b ab_evidence) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_evidence, ab_evidence) IS 'Of operator <>';

CREATE OPERATOR = (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_evidence, ab_evidence) IS 'Same value, to the byte of the current layout';

CREATE OPERATOR <> (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =,
    RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_evidence, ab_evidence) IS 'Different values';

CREATE FUNCTION _ab_equal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_occupancy, ab_occupancy) IS 'Of operator =';

CREATE FUNCTION _ab_unequal(a ab_occupancy, b ab_occupancy) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_occupancy, ab_occupancy) IS 'Of operator <>';

CREATE OPERATOR = (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>,
    RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_occupancy, ab_occupancy) IS 'Same value, to the byte of the current layout';

CREATE OPERATOR <> (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =,
    RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_occupancy, ab_occupancy) IS 'Different values';

CREATE FUNCTION _ab_equal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_change, ab_change) IS 'Of operator =';

CREATE FUNCTION _ab_unequal(a ab_change, b ab_change) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_change, ab_change) IS 'Of operator <>';

CREATE OPERATOR = (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_change, ab_change) IS 'Same value, to the byte of the current layout';

CREATE OPERATOR <> (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_change, ab_change) IS 'Different values';

CREATE FUNCTION _ab_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator =';

CREATE FUNCTION _ab_unequal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_evidence_model, ab_evidence_model) IS 'Of operator <>';

CREATE OPERATOR = (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>,
    RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_evidence_model, ab_evidence_model) IS 'Same value, to the byte of the current layout';

CREATE OPERATOR <> (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =,
    RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_evidence_model, ab_evidence_model) IS 'Different values';

CREATE FUNCTION _ab_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_equal(ab_grid, ab_grid) IS 'Of operator =';

CREATE FUNCTION _ab_unequal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_unequal(ab_grid, ab_grid) IS 'Of operator <>';

CREATE OPERATOR = (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel,
    JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_grid, ab_grid) IS 'Same value, to the byte of the current layout';

CREATE OPERATOR <> (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_unequal, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel,
    JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_grid, ab_grid) IS 'Different values';

-- ~=: the same box, or the same numbers.
CREATE OPERATOR ~= (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_equal, COMMUTATOR = ~=, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_box, ab_box) IS 'Same box';

CREATE OPERATOR ~= (
    LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = _ab_equal, COMMUTATOR = ~=, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_mass, ab_mass) IS 'Same mass, bit by bit';

CREATE FUNCTION _ab_same(a ab_solid, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_solid_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_same(ab_solid, ab_box) IS 'Is the box of a solid that box';

CREATE OPERATOR ~= (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = _ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_solid, ab_box) IS 'Is the box of a solid that box';

CREATE FUNCTION _ab_same(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_scan_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_same(ab_scan, ab_box) IS 'Is the hull of a patch that box';

CREATE OPERATOR ~= (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = _ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_scan, ab_box) IS 'Is the hull of a patch that box';

CREATE FUNCTION _ab_same(a ab_point, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_same(ab_point, ab_box) IS 'Is the box of a point grown by five standard deviations that box';

CREATE OPERATOR ~= (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = _ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_point, ab_box) IS 'Is the box of a point grown by five standard deviations that box';

CREATE FUNCTION _ab_same(a ab_occupancy, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_same(ab_occupancy, ab_box) IS 'Is the box of an occupancy that box';

CREATE OPERATOR ~= (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_occupancy, ab_box) IS 'Is the box of an occupancy that box';

CREATE FUNCTION _ab_same(a ab_change, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_tile_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_same(ab_change, ab_box) IS 'Is the box of a change that box';

CREATE OPERATOR ~= (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_same, RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_change, ab_box) IS 'Is the box of a change that box';

-- <->: least distance of boxes, metres; for nearest first.
CREATE FUNCTION _ab_box_distance(a ab_box, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_box_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_box_distance(ab_box, ab_box) IS 'Least distance of a box from a box, metres';

CREATE OPERATOR <-> (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_box, ab_box) IS 'Least distance of a box from a box, metres; for nearest first';

CREATE FUNCTION _ab_box_distance(a ab_solid, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_solid_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_box_distance(ab_solid, ab_box) IS 'Least distance of the box of a solid from a box, metres';

CREATE OPERATOR <-> (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_solid, ab_box) IS
    'Least distance of the box of a solid from a box, metres; for nearest first';

CREATE FUNCTION _ab_box_distance(a ab_scan, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_scan_distance_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_box_distance(ab_scan, ab_box) IS
    'Least distance of the box of a patch''s returns from a box, metres; infinite without returns';

CREATE OPERATOR <-> (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_scan, ab_box) IS
    'Least distance of the box of a patch''s returns from a box, metres; infinite without returns; for nearest first';

CREATE FUNCTION _ab_box_distance(a ab_point, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_box_distance(ab_point, ab_box) IS
    'Least distance of the box of a point grown by five standard deviations from a box, metres';

CREATE OPERATOR <-> (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_point, ab_box) IS
    'Least distance of the box of a point grown by five standard deviations from a box, metres; for nearest first';

CREATE FUNCTION _ab_box_distance(a ab_box, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_box_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_box_distance(ab_box, ab_point) IS 'Least distance of a box from a point, metres';

CREATE OPERATOR <-> (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_box, ab_point) IS 'Least distance of a box from a point, metres; for nearest first';

CREATE FUNCTION _ab_box_distance(a ab_solid, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_solid_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_box_distance(ab_solid, ab_point) IS 'Least distance of the box of a solid from a point, metres';

CREATE OPERATOR <-> (LEFTARG = ab_solid, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_solid, ab_point) IS
    'Least distance of the box of a solid from a point, metres; for nearest first';

CREATE FUNCTION _ab_box_distance(a ab_scan, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_scan_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION _ab_box_distance(ab_scan, ab_point) IS
    'Least distance of the box of a patch''s returns from a point, metres; infinite without returns';

CREATE OPERATOR <-> (LEFTARG = ab_scan, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_scan, ab_point) IS
    'Least distance of the box of a patch''s returns from a point, metres; infinite without returns; for nearest '
    'first';

CREATE FUNCTION _ab_box_distance(a ab_point, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_point_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION _ab_box_distance(ab_point, ab_point) IS
    'Least distance of a point from a point, metres; uncertainties do not count';

CREATE OPERATOR <-> (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_point, ab_point) IS
    'Least distance of a point from a point, metres; uncertainties do not count; for nearest first';

CREATE FUNCTION _ab_box_distance(a ab_occupancy, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_box_distance(ab_occupancy, ab_box) IS
    'Least distance of the box of an occupancy from a box, metres';

CREATE FUNCTION _ab_box_distance(a ab_occupancy, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_box_distance(ab_occupancy, ab_point) IS
    'Least distance of the box of an occupancy from a point, metres';

CREATE OPERATOR <-> (LEFTARG = ab_occupancy, RIGHTARG = ab_box, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_occupancy, ab_box) IS
    'Least distance of the box of an occupancy from a box, metres; for nearest first';

CREATE OPERATOR <-> (LEFTARG = ab_occupancy, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_occupancy, ab_point) IS
    'Least distance of the box of an occupancy from a point, metres; for nearest first';

CREATE FUNCTION _ab_box_distance(a ab_change, b ab_box) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_box_distance(ab_change, ab_box) IS 'Least distance of the box of a change from a box, metres';

CREATE FUNCTION _ab_box_distance(a ab_change, b ab_point) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tile_distance_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION _ab_box_distance(ab_change, ab_point) IS
    'Least distance of the box of a change from a point, metres';

CREATE OPERATOR <-> (LEFTARG = ab_change, RIGHTARG = ab_box, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_change, ab_box) IS
    'Least distance of the box of a change from a box, metres; for nearest first';

CREATE OPERATOR <-> (LEFTARG = ab_change, RIGHTARG = ab_point, FUNCTION = _ab_box_distance);
COMMENT ON OPERATOR <-> (ab_change, ab_point) IS
    'Least distance of the box of a change from a point, metres; for nearest first';

-- <, <=, >= and >: an order for sorting and grouping.
CREATE FUNCTION _ab_less(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_point, ab_point) IS 'Before in the order of x, y, z, covariance';

CREATE OPERATOR < (
    LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_point, ab_point) IS 'Before in the order of x, y, z, covariance';

CREATE FUNCTION _ab_less_or_equal(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_point, ab_point) IS 'Not after in the order of x, y, z, covariance';

CREATE OPERATOR <= (
    LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_point, ab_point) IS 'Not after in the order of x, y, z, covariance';

CREATE FUNCTION _ab_greater_or_equal(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_point, ab_point) IS 'Not before in the order of x, y, z, covariance';

CREATE OPERATOR >= (
    LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_point, ab_point) IS 'Not before in the order of x, y, z, covariance';

CREATE FUNCTION _ab_greater(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_point, ab_point) IS 'After in the order of x, y, z, covariance';

CREATE OPERATOR > (
    LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_point, ab_point) IS 'After in the order of x, y, z, covariance';

CREATE FUNCTION _ab_less(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_line, ab_line) IS 'Before in the order of start, end, covariance';

CREATE OPERATOR < (
    LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_line, ab_line) IS 'Before in the order of start, end, covariance';

CREATE FUNCTION _ab_less_or_equal(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_line, ab_line) IS 'Not after in the order of start, end, covariance';

CREATE OPERATOR <= (
    LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_line, ab_line) IS 'Not after in the order of start, end, covariance';

CREATE FUNCTION _ab_greater_or_equal(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_line, ab_line) IS 'Not before in the order of start, end, covariance';

CREATE OPERATOR >= (
    LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_line, ab_line) IS 'Not before in the order of start, end, covariance';

CREATE FUNCTION _ab_greater(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_line, ab_line) IS 'After in the order of start, end, covariance';

CREATE OPERATOR > (
    LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel,
    JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_line, ab_line) IS 'After in the order of start, end, covariance';

CREATE FUNCTION _ab_less(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_plane, ab_plane) IS 'Before in the order of point, normal, covariance';

CREATE OPERATOR < (
    LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_plane, ab_plane) IS 'Before in the order of point, normal, covariance';

CREATE FUNCTION _ab_less_or_equal(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_plane, ab_plane) IS 'Not after in the order of point, normal, covariance';

CREATE OPERATOR <= (
    LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_plane, ab_plane) IS 'Not after in the order of point, normal, covariance';

CREATE FUNCTION _ab_greater_or_equal(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_plane, ab_plane) IS 'Not before in the order of point, normal, covariance';

CREATE OPERATOR >= (
    LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_plane, ab_plane) IS 'Not before in the order of point, normal, covariance';

CREATE FUNCTION _ab_greater(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_plane, ab_plane) IS 'After in the order of point, normal, covariance';

CREATE OPERATOR > (
    LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_plane, ab_plane) IS 'After in the order of point, normal, covariance';

CREATE FUNCTION _ab_less(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_pose, ab_pose) IS 'Before in the order of rotation, translation, scale, covariance';

CREATE OPERATOR < (
    LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_pose, ab_pose) IS 'Before in the order of rotation, translation, scale, covariance';

CREATE FUNCTION _ab_less_or_equal(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_pose, ab_pose) IS
    'Not after in the order of rotation, translation, scale, covariance';

CREATE OPERATOR <= (
    LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_pose, ab_pose) IS 'Not after in the order of rotation, translation, scale, covariance';

CREATE FUNCTION _ab_greater_or_equal(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_pose, ab_pose) IS
    'Not before in the order of rotation, translation, scale, covariance';

CREATE OPERATOR >= (
    LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_pose, ab_pose) IS 'Not before in the order of rotation, translation, scale, covariance';

CREATE FUNCTION _ab_greater(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_pose, ab_pose) IS 'After in the order of rotation, translation, scale, covariance';

CREATE OPERATOR > (
    LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel,
    JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_pose, ab_pose) IS 'After in the order of rotation, translation, scale, covariance';

CREATE FUNCTION _ab_less(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_mass, ab_mass) IS 'Before in the order of occupied, empty, unknown';

CREATE OPERATOR < (
    LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_mass, ab_mass) IS 'Before in the order of occupied, empty, unknown';

CREATE FUNCTION _ab_less_or_equal(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_mass, ab_mass) IS 'Not after in the order of occupied, empty, unknown';

CREATE OPERATOR <= (
    LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_mass, ab_mass) IS 'Not after in the order of occupied, empty, unknown';

CREATE FUNCTION _ab_greater_or_equal(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_mass, ab_mass) IS 'Not before in the order of occupied, empty, unknown';

CREATE OPERATOR >= (
    LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_mass, ab_mass) IS 'Not before in the order of occupied, empty, unknown';

CREATE FUNCTION _ab_greater(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_mass, ab_mass) IS 'After in the order of occupied, empty, unknown';

CREATE OPERATOR > (
    LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel,
    JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_mass, ab_mass) IS 'After in the order of occupied, empty, unknown';

CREATE FUNCTION _ab_less(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less(ab_box, ab_box) IS 'Before in the order of their corners';

CREATE OPERATOR < (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_box, ab_box) IS 'Before in the order of their corners';

CREATE FUNCTION _ab_less_or_equal(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_less_or_equal(ab_box, ab_box) IS 'Not after in the order of their corners';

CREATE OPERATOR <= (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_box, ab_box) IS 'Not after in the order of their corners';

CREATE FUNCTION _ab_greater_or_equal(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_box, ab_box) IS 'Not before in the order of their corners';

CREATE OPERATOR >= (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_box, ab_box) IS 'Not before in the order of their corners';

CREATE FUNCTION _ab_greater(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_greater(ab_box, ab_box) IS 'After in the order of their corners';

CREATE OPERATOR > (
    LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel,
    JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_box, ab_box) IS 'After in the order of their corners';

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

CREATE OPERATOR < (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_solid, ab_solid) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';

CREATE OPERATOR <= (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_solid, ab_solid) IS 'Before or equal, in the order of the bytes';

CREATE OPERATOR >= (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_solid, ab_solid) IS 'After or equal, in the order of the bytes';

CREATE OPERATOR > (
    LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_solid, ab_solid) IS 'After, in the order of the bytes';

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

CREATE OPERATOR < (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_scan, ab_scan) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';

CREATE OPERATOR <= (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_scan, ab_scan) IS 'Before or equal, in the order of the bytes';

CREATE OPERATOR >= (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_scan, ab_scan) IS 'After or equal, in the order of the bytes';

CREATE OPERATOR > (
    LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel,
    JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_scan, ab_scan) IS 'After, in the order of the bytes';

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

CREATE OPERATOR < (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=,
    RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_evidence, ab_evidence) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';

CREATE OPERATOR <= (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_evidence, ab_evidence) IS 'Before or equal, in the order of the bytes';

CREATE OPERATOR >= (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_evidence, ab_evidence) IS 'After or equal, in the order of the bytes';

CREATE OPERATOR > (
    LEFTARG = ab_evidence, RIGHTARG = ab_evidence, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_evidence, ab_evidence) IS 'After, in the order of the bytes';

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

CREATE OPERATOR < (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=,
    RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_occupancy, ab_occupancy) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';

CREATE OPERATOR <= (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_occupancy, ab_occupancy) IS 'Before or equal, in the order of the bytes';

CREATE OPERATOR >= (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_occupancy, ab_occupancy) IS 'After or equal, in the order of the bytes';

CREATE OPERATOR > (
    LEFTARG = ab_occupancy, RIGHTARG = ab_occupancy, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_occupancy, ab_occupancy) IS 'After, in the order of the bytes';

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

CREATE OPERATOR < (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=,
    RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_change, ab_change) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';

CREATE OPERATOR <= (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_change, ab_change) IS 'Before or equal, in the order of the bytes';

CREATE OPERATOR >= (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_change, ab_change) IS 'After or equal, in the order of the bytes';

CREATE OPERATOR > (
    LEFTARG = ab_change, RIGHTARG = ab_change, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_change, ab_change) IS 'After, in the order of the bytes';

CREATE FUNCTION _ab_less(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less(ab_evidence_model, ab_evidence_model) IS 'Of operator <';

CREATE FUNCTION _ab_less_or_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less_or_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator <=';

CREATE FUNCTION _ab_greater_or_equal(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_evidence_model, ab_evidence_model) IS 'Of operator >=';

CREATE FUNCTION _ab_greater(a ab_evidence_model, b ab_evidence_model) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater(ab_evidence_model, ab_evidence_model) IS 'Of operator >';

CREATE OPERATOR < (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=,
    RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_evidence_model, ab_evidence_model) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';

CREATE OPERATOR <= (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=,
    NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_evidence_model, ab_evidence_model) IS 'Before or equal, in the order of the bytes';

CREATE OPERATOR >= (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=,
    NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_evidence_model, ab_evidence_model) IS 'After or equal, in the order of the bytes';

CREATE OPERATOR > (
    LEFTARG = ab_evidence_model, RIGHTARG = ab_evidence_model, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=,
    RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_evidence_model, ab_evidence_model) IS 'After, in the order of the bytes';

CREATE FUNCTION _ab_less(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less(ab_grid, ab_grid) IS 'Of operator <';

CREATE FUNCTION _ab_less_or_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_less_or_equal(ab_grid, ab_grid) IS 'Of operator <=';

CREATE FUNCTION _ab_greater_or_equal(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater_or_equal(ab_grid, ab_grid) IS 'Of operator >=';

CREATE FUNCTION _ab_greater(a ab_grid, b ab_grid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_bytes_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION _ab_greater(ab_grid, ab_grid) IS 'Of operator >';

CREATE OPERATOR < (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_less, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel,
    JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_grid, ab_grid) IS
    'Before, in the order of the bytes: for sorting and grouping, without a meaning';

CREATE OPERATOR <= (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_less_or_equal, COMMUTATOR = >=, NEGATOR = >,
    RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_grid, ab_grid) IS 'Before or equal, in the order of the bytes';

CREATE OPERATOR >= (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_greater_or_equal, COMMUTATOR = <=, NEGATOR = <,
    RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_grid, ab_grid) IS 'After or equal, in the order of the bytes';

CREATE OPERATOR > (
    LEFTARG = ab_grid, RIGHTARG = ab_grid, FUNCTION = _ab_greater, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel,
    JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_grid, ab_grid) IS 'After, in the order of the bytes';

-- A search that an operator serves.
CREATE FUNCTION ab_within(a ab_point, b ab_point, sigmas float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE COST 200
    RETURN a && ab_reach(b, sigmas) AND ab_mahalanobis(a, b) <= sigmas;
COMMENT ON FUNCTION ab_within(ab_point, ab_point, float8) IS
    'Are two points within this many standard deviations (at most 5) of each other: Mahalanobis distance. An index '
    'on the first one serves it';
