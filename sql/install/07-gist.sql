-- GiST operator classes. Keys are boxes; strategy numbers say the right-hand type.

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_box, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_box, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_solid, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_solid, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_consistent(entry internal, query ab_scan, strategy smallint, subtype oid, recheck internal) RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_gist_consistent' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_consistent(internal, ab_scan, smallint, oid, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_union(entries internal, size internal) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_gist_union' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_union(internal, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_scan_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_scan_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_scan_compress(internal) IS 'GiST support';

CREATE FUNCTION ab_gist_solid_compress(entry internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_solid_compress' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_solid_compress(internal) IS 'GiST support';

CREATE FUNCTION ab_gist_penalty(key internal, entry internal, result internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_penalty' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_penalty(internal, internal, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_picksplit(entries internal, result internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_picksplit' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_picksplit(internal, internal) IS 'GiST support';

CREATE FUNCTION ab_gist_same(a ab_box, b ab_box, result internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_gist_same' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_gist_same(ab_box, ab_box, internal) IS 'GiST support';

CREATE OPERATOR CLASS ab_box_gist_ops DEFAULT FOR TYPE ab_box USING gist AS
    OPERATOR 1 && (ab_box, ab_box), OPERATOR 2 && (ab_box, ab_solid), OPERATOR 3 && (ab_box, ab_scan),
    FUNCTION 1 ab_gist_consistent(internal, ab_box, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal);
COMMENT ON OPERATOR CLASS ab_box_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_solid_gist_ops DEFAULT FOR TYPE ab_solid USING gist AS
    OPERATOR 1 && (ab_solid, ab_box), OPERATOR 2 && (ab_solid, ab_solid), OPERATOR 3 && (ab_solid, ab_scan),
    FUNCTION 1 ab_gist_consistent(internal, ab_solid, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_solid_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_solid_gist_ops USING gist IS 'Joins on && by boxes';

CREATE OPERATOR CLASS ab_scan_gist_ops DEFAULT FOR TYPE ab_scan USING gist AS
    OPERATOR 1 && (ab_scan, ab_box), OPERATOR 2 && (ab_scan, ab_solid), OPERATOR 3 && (ab_scan, ab_scan),
    FUNCTION 1 ab_gist_consistent(internal, ab_scan, smallint, oid, internal),
    FUNCTION 2 ab_gist_union(internal, internal),
    FUNCTION 3 ab_gist_scan_compress(internal),
    FUNCTION 5 ab_gist_penalty(internal, internal, internal),
    FUNCTION 6 ab_gist_picksplit(internal, internal),
    FUNCTION 7 ab_gist_same(ab_box, ab_box, internal),
    STORAGE ab_box;
COMMENT ON OPERATOR CLASS ab_scan_gist_ops USING gist IS 'Joins on && by boxes';
