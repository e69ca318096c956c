-- Operators: && boxes overlap.

CREATE FUNCTION ab_equal(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_box_equal' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_box, ab_box) IS 'Same box';

CREATE FUNCTION ab_equal(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_equal' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_mass, ab_mass) IS 'Same mass, bit by bit';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_scan, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_overlaps(ab_scan, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_scan, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_overlaps(ab_scan, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE FUNCTION ab_overlaps(a ab_scan, b ab_scan) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_scan_scan' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50;
COMMENT ON FUNCTION ab_overlaps(ab_scan, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_box, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_box, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_scan, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_box, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_solid, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_solid, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_scan, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_solid, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_scan, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_scan, ab_box) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_scan, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_scan, ab_solid) IS 'Boxes overlap; for a scan the hull of its beams counts';
CREATE OPERATOR && (LEFTARG = ab_scan, RIGHTARG = ab_scan, FUNCTION = ab_overlaps, COMMUTATOR = &&,
    RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_scan, ab_scan) IS 'Boxes overlap; for a scan the hull of its beams counts';

CREATE OPERATOR ~= (LEFTARG = ab_box, RIGHTARG = ab_box, FUNCTION = ab_equal, COMMUTATOR = ~=,
    RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_box, ab_box) IS 'Same box';
CREATE OPERATOR ~= (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_equal, COMMUTATOR = ~=,
    RESTRICT = eqsel, JOIN = eqjoinsel);
COMMENT ON OPERATOR ~= (ab_mass, ab_mass) IS 'Same mass, bit by bit';
