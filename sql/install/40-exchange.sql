-- Exchange with other systems.

CREATE FUNCTION ab_solid_from_ewkb(ewkb bytea) RETURNS ab_solid
    AS 'MODULE_PATHNAME', 'ab_solid_from_ewkb' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_solid_from_ewkb(bytea) IS
    'A solid from WKB or EWKB of a POLYHEDRALSURFACE Z, TIN Z, MULTIPOLYGON Z, POLYGON Z or TRIANGLE Z in metres, as '
    'ST_AsEWKB gives it; faces of more than three corners are cut into triangles, the SRID is dropped';

CREATE FUNCTION ab_as_ewkb(solid ab_solid, tin boolean DEFAULT false) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_solid_as_ewkb' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000;
COMMENT ON FUNCTION ab_as_ewkb(ab_solid, boolean) IS
    'EWKB of a solid as POLYHEDRALSURFACE Z, or as TIN Z; one face a triangle, no SRID';
