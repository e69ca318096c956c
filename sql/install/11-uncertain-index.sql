-- Comparison, hashing and indexes of uncertain objects and masses.

CREATE FUNCTION ab_equal(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_point, ab_point) IS 'Same numbers';

CREATE FUNCTION ab_differ(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_point, ab_point) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(point ab_point) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_point_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_point) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(point ab_point, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_point_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_point, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_point, ab_point) IS 'Same numbers, covariance included';
CREATE OPERATOR <> (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_point, ab_point) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_point_hash_ops DEFAULT FOR TYPE ab_point USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_point), FUNCTION 2 ab_hash(ab_point, bigint);
COMMENT ON OPERATOR CLASS ab_point_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_equal(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_line, ab_line) IS 'Same numbers';

CREATE FUNCTION ab_differ(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_line, ab_line) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(line ab_line) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_line_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_line) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(line ab_line, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_line_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_line, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_line, ab_line) IS 'Same numbers, covariance included';
CREATE OPERATOR <> (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_line, ab_line) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_line_hash_ops DEFAULT FOR TYPE ab_line USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_line), FUNCTION 2 ab_hash(ab_line, bigint);
COMMENT ON OPERATOR CLASS ab_line_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_equal(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_plane, ab_plane) IS 'Same numbers';

CREATE FUNCTION ab_differ(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_plane, ab_plane) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(plane ab_plane) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_plane_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_plane) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(plane ab_plane, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_plane_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_plane, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_plane, ab_plane) IS 'Same numbers, covariance included';
CREATE OPERATOR <> (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_plane, ab_plane) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_plane_hash_ops DEFAULT FOR TYPE ab_plane USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_plane), FUNCTION 2 ab_hash(ab_plane, bigint);
COMMENT ON OPERATOR CLASS ab_plane_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_equal(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_eq' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_equal(ab_pose, ab_pose) IS 'Same numbers';

CREATE FUNCTION ab_differ(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_pose, ab_pose) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(pose ab_pose) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_pose_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_pose) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(pose ab_pose, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_pose_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_pose, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_pose, ab_pose) IS 'Same numbers, covariance included';
CREATE OPERATOR <> (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_pose, ab_pose) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_pose_hash_ops DEFAULT FOR TYPE ab_pose USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_pose), FUNCTION 2 ab_hash(ab_pose, bigint);
COMMENT ON OPERATOR CLASS ab_pose_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_differ(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_ne' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_differ(ab_mass, ab_mass) IS 'Not the same numbers';

CREATE FUNCTION ab_hash(mass ab_mass) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_mass_hash' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_mass) IS 'Hash of the numbers';

CREATE FUNCTION ab_hash(mass ab_mass, seed bigint) RETURNS bigint
    AS 'MODULE_PATHNAME', 'ab_mass_hash_extended' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_hash(ab_mass, bigint) IS 'Hash of the numbers with a seed';

CREATE OPERATOR = (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_equal, COMMUTATOR = =, NEGATOR = <>, RESTRICT = eqsel, JOIN = eqjoinsel, HASHES, MERGES);
COMMENT ON OPERATOR = (ab_mass, ab_mass) IS 'Same numbers';
CREATE OPERATOR <> (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_differ, COMMUTATOR = <>, NEGATOR = =, RESTRICT = neqsel, JOIN = neqjoinsel);
COMMENT ON OPERATOR <> (ab_mass, ab_mass) IS 'Not the same numbers';
CREATE OPERATOR CLASS ab_mass_hash_ops DEFAULT FOR TYPE ab_mass USING hash AS OPERATOR 1 =, FUNCTION 1 ab_hash(ab_mass), FUNCTION 2 ab_hash(ab_mass, bigint);
COMMENT ON OPERATOR CLASS ab_mass_hash_ops USING hash IS 'Joins and groups by equal numbers';

CREATE FUNCTION ab_lt(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_point, ab_point) IS 'Before in the order of x, y, z, covariance';
CREATE OPERATOR < (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_point, ab_point) IS 'Before in the order of x, y, z, covariance';

CREATE FUNCTION ab_le(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_point, ab_point) IS 'Not after in the order of x, y, z, covariance';
CREATE OPERATOR <= (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_point, ab_point) IS 'Not after in the order of x, y, z, covariance';

CREATE FUNCTION ab_ge(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_point, ab_point) IS 'Not before in the order of x, y, z, covariance';
CREATE OPERATOR >= (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_point, ab_point) IS 'Not before in the order of x, y, z, covariance';

CREATE FUNCTION ab_gt(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_point_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_point, ab_point) IS 'After in the order of x, y, z, covariance';
CREATE OPERATOR > (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_point, ab_point) IS 'After in the order of x, y, z, covariance';

CREATE FUNCTION ab_compare(a ab_point, b ab_point) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_point_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_point, ab_point) IS '-1, 0 or 1 in the order of x, y, z, covariance';

CREATE OPERATOR CLASS ab_point_ops DEFAULT FOR TYPE ab_point USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_point, ab_point);
COMMENT ON OPERATOR CLASS ab_point_ops USING btree IS 'Order by x, y, z, covariance';

CREATE FUNCTION ab_lt(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_line, ab_line) IS 'Before in the order of start, end, covariance';
CREATE OPERATOR < (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_line, ab_line) IS 'Before in the order of start, end, covariance';

CREATE FUNCTION ab_le(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_line, ab_line) IS 'Not after in the order of start, end, covariance';
CREATE OPERATOR <= (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_line, ab_line) IS 'Not after in the order of start, end, covariance';

CREATE FUNCTION ab_ge(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_line, ab_line) IS 'Not before in the order of start, end, covariance';
CREATE OPERATOR >= (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_line, ab_line) IS 'Not before in the order of start, end, covariance';

CREATE FUNCTION ab_gt(a ab_line, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_line_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_line, ab_line) IS 'After in the order of start, end, covariance';
CREATE OPERATOR > (LEFTARG = ab_line, RIGHTARG = ab_line, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_line, ab_line) IS 'After in the order of start, end, covariance';

CREATE FUNCTION ab_compare(a ab_line, b ab_line) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_line_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_line, ab_line) IS '-1, 0 or 1 in the order of start, end, covariance';

CREATE OPERATOR CLASS ab_line_ops DEFAULT FOR TYPE ab_line USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_line, ab_line);
COMMENT ON OPERATOR CLASS ab_line_ops USING btree IS 'Order by start, end, covariance';

CREATE FUNCTION ab_lt(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_plane, ab_plane) IS 'Before in the order of point, normal, covariance';
CREATE OPERATOR < (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_plane, ab_plane) IS 'Before in the order of point, normal, covariance';

CREATE FUNCTION ab_le(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_plane, ab_plane) IS 'Not after in the order of point, normal, covariance';
CREATE OPERATOR <= (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_plane, ab_plane) IS 'Not after in the order of point, normal, covariance';

CREATE FUNCTION ab_ge(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_plane, ab_plane) IS 'Not before in the order of point, normal, covariance';
CREATE OPERATOR >= (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_plane, ab_plane) IS 'Not before in the order of point, normal, covariance';

CREATE FUNCTION ab_gt(a ab_plane, b ab_plane) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_plane_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_plane, ab_plane) IS 'After in the order of point, normal, covariance';
CREATE OPERATOR > (LEFTARG = ab_plane, RIGHTARG = ab_plane, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_plane, ab_plane) IS 'After in the order of point, normal, covariance';

CREATE FUNCTION ab_compare(a ab_plane, b ab_plane) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_plane_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_plane, ab_plane) IS '-1, 0 or 1 in the order of point, normal, covariance';

CREATE OPERATOR CLASS ab_plane_ops DEFAULT FOR TYPE ab_plane USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_plane, ab_plane);
COMMENT ON OPERATOR CLASS ab_plane_ops USING btree IS 'Order by point, normal, covariance';

CREATE FUNCTION ab_lt(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_pose, ab_pose) IS 'Before in the order of rotation, translation, scale, covariance';
CREATE OPERATOR < (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_pose, ab_pose) IS 'Before in the order of rotation, translation, scale, covariance';

CREATE FUNCTION ab_le(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_pose, ab_pose) IS 'Not after in the order of rotation, translation, scale, covariance';
CREATE OPERATOR <= (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_pose, ab_pose) IS 'Not after in the order of rotation, translation, scale, covariance';

CREATE FUNCTION ab_ge(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_pose, ab_pose) IS 'Not before in the order of rotation, translation, scale, covariance';
CREATE OPERATOR >= (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_pose, ab_pose) IS 'Not before in the order of rotation, translation, scale, covariance';

CREATE FUNCTION ab_gt(a ab_pose, b ab_pose) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_pose_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_pose, ab_pose) IS 'After in the order of rotation, translation, scale, covariance';
CREATE OPERATOR > (LEFTARG = ab_pose, RIGHTARG = ab_pose, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_pose, ab_pose) IS 'After in the order of rotation, translation, scale, covariance';

CREATE FUNCTION ab_compare(a ab_pose, b ab_pose) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_pose_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_pose, ab_pose) IS '-1, 0 or 1 in the order of rotation, translation, scale, covariance';

CREATE OPERATOR CLASS ab_pose_ops DEFAULT FOR TYPE ab_pose USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_pose, ab_pose);
COMMENT ON OPERATOR CLASS ab_pose_ops USING btree IS 'Order by rotation, translation, scale, covariance';

CREATE FUNCTION ab_lt(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_lt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lt(ab_mass, ab_mass) IS 'Before in the order of occupied, empty, unknown';
CREATE OPERATOR < (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_lt, COMMUTATOR = >, NEGATOR = >=, RESTRICT = scalarltsel, JOIN = scalarltjoinsel);
COMMENT ON OPERATOR < (ab_mass, ab_mass) IS 'Before in the order of occupied, empty, unknown';

CREATE FUNCTION ab_le(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_le' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_le(ab_mass, ab_mass) IS 'Not after in the order of occupied, empty, unknown';
CREATE OPERATOR <= (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_le, COMMUTATOR = >=, NEGATOR = >, RESTRICT = scalarlesel, JOIN = scalarlejoinsel);
COMMENT ON OPERATOR <= (ab_mass, ab_mass) IS 'Not after in the order of occupied, empty, unknown';

CREATE FUNCTION ab_ge(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_ge' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ge(ab_mass, ab_mass) IS 'Not before in the order of occupied, empty, unknown';
CREATE OPERATOR >= (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_ge, COMMUTATOR = <=, NEGATOR = <, RESTRICT = scalargesel, JOIN = scalargejoinsel);
COMMENT ON OPERATOR >= (ab_mass, ab_mass) IS 'Not before in the order of occupied, empty, unknown';

CREATE FUNCTION ab_gt(a ab_mass, b ab_mass) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_mass_gt' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gt(ab_mass, ab_mass) IS 'After in the order of occupied, empty, unknown';
CREATE OPERATOR > (LEFTARG = ab_mass, RIGHTARG = ab_mass, FUNCTION = ab_gt, COMMUTATOR = <, NEGATOR = <=, RESTRICT = scalargtsel, JOIN = scalargtjoinsel);
COMMENT ON OPERATOR > (ab_mass, ab_mass) IS 'After in the order of occupied, empty, unknown';

CREATE FUNCTION ab_compare(a ab_mass, b ab_mass) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_mass_compare' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_compare(ab_mass, ab_mass) IS '-1, 0 or 1 in the order of occupied, empty, unknown';

CREATE OPERATOR CLASS ab_mass_ops DEFAULT FOR TYPE ab_mass USING btree AS
    OPERATOR 1 <, OPERATOR 2 <=, OPERATOR 3 =, OPERATOR 4 >=, OPERATOR 5 >, FUNCTION 1 ab_compare(ab_mass, ab_mass);
COMMENT ON OPERATOR CLASS ab_mass_ops USING btree IS 'Order by occupied, empty, unknown';

CREATE FUNCTION ab_reach(point ab_point, sigmas float8) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_point_reach' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_reach(ab_point, float8) IS 'The box of a point grown by this many standard deviations along every axis; at most 5';

CREATE FUNCTION ab_overlaps(a ab_point, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_point_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_point, ab_box) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_point, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_point_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_point, ab_point) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_line, b ab_box) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_line_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_line, ab_box) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_point) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_box, b ab_line) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_box_line' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_box, ab_line) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_point, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_point, ab_box) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_point, RIGHTARG = ab_point, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_point, ab_point) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_line, RIGHTARG = ab_box, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_line, ab_box) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_point, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_box, ab_point) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_box, RIGHTARG = ab_line, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_box, ab_line) IS 'Boxes overlap; for a point or line the one grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_solid, b ab_point) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_solid_point' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_solid, ab_point) IS 'Does a solid, grown by 0.25 m as for scans, meet the box of a point grown by five standard deviations';

CREATE FUNCTION ab_overlaps(a ab_point, b ab_solid) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_overlaps_point_solid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 5;
COMMENT ON FUNCTION ab_overlaps(ab_point, ab_solid) IS 'Does a solid, grown by 0.25 m as for scans, meet the box of a point grown by five standard deviations';
CREATE OPERATOR && (LEFTARG = ab_solid, RIGHTARG = ab_point, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_solid, ab_point) IS 'A point may be of a solid: its box of five standard deviations meets the solid''s, grown by 0.25 m';
CREATE OPERATOR && (LEFTARG = ab_point, RIGHTARG = ab_solid, FUNCTION = ab_overlaps, COMMUTATOR = &&, RESTRICT = ab_overlap_sel, JOIN = ab_overlap_join_sel);
COMMENT ON OPERATOR && (ab_point, ab_solid) IS 'A point may be of a solid: its box of five standard deviations meets the solid''s, grown by 0.25 m';

CREATE FUNCTION ab_within(a ab_point, b ab_point, sigmas float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE COST 200
    RETURN a && ab_reach(b, sigmas) AND ab_mahalanobis(a, b) <= sigmas;
COMMENT ON FUNCTION ab_within(ab_point, ab_point, float8) IS 'Are two points within this many standard deviations (at most 5) of each other: Mahalanobis distance. An index on the first one serves it';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_point, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_point, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_point_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_point_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_point_compress(internal) IS 'GiST support';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_line, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_line, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_line_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_line_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_line_compress(internal) IS 'GiST support';

CREATE OPERATOR CLASS ab_point_gist_ops DEFAULT FOR TYPE ab_point USING gist AS
    OPERATOR 1 && (ab_point, ab_box), OPERATOR 4 && (ab_point, ab_point), OPERATOR 5 && (ab_point, ab_solid),
    FUNCTION 1 ab_gist_consistent(internal, ab_point, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_point_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_point_gist_ops USING gist IS 'Joins on && by boxes grown by five standard deviations';

CREATE OPERATOR CLASS ab_line_gist_ops DEFAULT FOR TYPE ab_line USING gist AS
    OPERATOR 1 && (ab_line, ab_box),
    FUNCTION 1 ab_gist_consistent(internal, ab_line, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_line_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_line_gist_ops USING gist IS 'Joins on && by boxes grown by five standard deviations';

-- Evidence from tie points.

CREATE FUNCTION ab_evidence_accum(state internal, solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_accum_point' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 2000;
COMMENT ON FUNCTION ab_evidence_accum(internal, ab_solid, ab_point, float8[], ab_evidence_model) IS 'Transition of ab_evidence_agg over tie points';

CREATE AGGREGATE ab_evidence_agg(solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model) (
    SFUNC = ab_evidence_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_evidence_combine, SERIALFUNC = ab_evidence_serial, DESERIALFUNC = ab_evidence_deserial,
    FINALFUNC = ab_evidence_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_evidence_agg(ab_solid, ab_point, float8[], ab_evidence_model) IS
    'What tie points say about one solid: a surface at each point, once, with the point''s own covariance, and empty space along the rays from its cameras (n x 3, metres). Choose spacing near the distance of the points; join the objects that the rays may have pierced too, not only those near the points. The model meyer2022 takes every ray as a source of its own, without covariance. A NULL point keeps the object';
