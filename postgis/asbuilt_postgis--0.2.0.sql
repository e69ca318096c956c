-- Solids, points and boxes of asbuilt as PostGIS geometries, and back. Bodies are standard SQL: they are bound to their
-- functions here and now, in whatever schemas these are, and do not depend on the search path later. asbuilt keeps no
-- SRID: ST_SetSRID puts it on.

\echo Use "CREATE EXTENSION asbuilt_postgis" to load this file. \quit

-- Solids.

CREATE FUNCTION ab_solid(geom geometry) RETURNS ab_solid
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 2000
    RETURN ab_solid_from_ewkb(ST_AsEWKB(geom));
COMMENT ON FUNCTION ab_solid(geometry) IS 'A solid from a POLYHEDRALSURFACE Z, TIN Z, MULTIPOLYGON Z, POLYGON Z or TRIANGLE Z in metres';
CREATE CAST (geometry AS ab_solid) WITH FUNCTION ab_solid(geometry);
COMMENT ON CAST (geometry AS ab_solid) IS 'See the function';

CREATE FUNCTION ab_geometry(solid ab_solid) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 2000
    RETURN ST_GeomFromEWKB(ab_as_ewkb(solid));
COMMENT ON FUNCTION ab_geometry(ab_solid) IS 'A solid as POLYHEDRALSURFACE Z';
CREATE CAST (ab_solid AS geometry) WITH FUNCTION ab_geometry(ab_solid);
COMMENT ON CAST (ab_solid AS geometry) IS 'See the function';

CREATE FUNCTION ab_tin(solid ab_solid) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 2000
    RETURN ST_GeomFromEWKB(ab_as_ewkb(solid, true));
COMMENT ON FUNCTION ab_tin(ab_solid) IS 'A solid as TIN Z';

-- Points: a geometry is exact, so the standard deviation goes beside it.

CREATE FUNCTION ab_point(geom geometry) RETURNS ab_point
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN ab_point(ST_X(geom), ST_Y(geom), ST_Z(geom));
COMMENT ON FUNCTION ab_point(geometry) IS 'An exact point from a POINT Z in metres; NULL without Z';
CREATE CAST (geometry AS ab_point) WITH FUNCTION ab_point(geometry);
COMMENT ON CAST (geometry AS ab_point) IS 'See the function';

CREATE FUNCTION ab_point(geom geometry, sd float8) RETURNS ab_point
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN ab_point(ST_X(geom), ST_Y(geom), ST_Z(geom), sd);
COMMENT ON FUNCTION ab_point(geometry, float8) IS 'An uncertain point from a POINT Z in metres, with one standard deviation for every axis; NULL without Z';

CREATE FUNCTION ab_geometry(point ab_point) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN ST_MakePoint(ab_x(point), ab_y(point), ab_z(point));
COMMENT ON FUNCTION ab_geometry(ab_point) IS 'The place of an uncertain point as POINT Z; its covariance is lost';
CREATE CAST (ab_point AS geometry) WITH FUNCTION ab_geometry(ab_point);
COMMENT ON CAST (ab_point AS geometry) IS 'See the function';

-- Boxes.

CREATE FUNCTION ab_box(box box3d) RETURNS ab_box
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN ab_box(ST_XMin(box), ST_YMin(box), ST_ZMin(box), ST_XMax(box), ST_YMax(box), ST_ZMax(box));
COMMENT ON FUNCTION ab_box(box3d) IS 'A box from a box3d';
CREATE CAST (box3d AS ab_box) WITH FUNCTION ab_box(box3d);
COMMENT ON CAST (box3d AS ab_box) IS 'See the function';

CREATE FUNCTION ab_box3d(box ab_box) RETURNS box3d
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN ST_3DMakeBox(ST_MakePoint((ab_min(box))[1], (ab_min(box))[2], (ab_min(box))[3]),
                        ST_MakePoint((ab_max(box))[1], (ab_max(box))[2], (ab_max(box))[3]));
COMMENT ON FUNCTION ab_box3d(ab_box) IS 'A box as box3d';
CREATE CAST (ab_box AS box3d) WITH FUNCTION ab_box3d(ab_box);
COMMENT ON CAST (ab_box AS box3d) IS 'See the function';

CREATE FUNCTION ab_geometry(box ab_box) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN ab_box3d(box)::geometry;
COMMENT ON FUNCTION ab_geometry(ab_box) IS 'A box as geometry: POLYHEDRALSURFACE Z, or a polygon, line or point Z where it is flat';
CREATE CAST (ab_box AS geometry) WITH FUNCTION ab_geometry(ab_box);
COMMENT ON CAST (ab_box AS geometry) IS 'See the function';

CREATE FUNCTION ab_footprint(box ab_box, srid integer DEFAULT 0) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN ST_MakeEnvelope((ab_min(box))[1], (ab_min(box))[2], (ab_max(box))[1], (ab_max(box))[2], srid);
COMMENT ON FUNCTION ab_footprint(ab_box, integer) IS 'A box from above as POLYGON: a layer for QGIS';

-- Samples of evidence.

CREATE FUNCTION ab_samples_geometry(evidence ab_evidence, loa ab_loa DEFAULT NULL) RETURNS geometry
    LANGUAGE sql STABLE PARALLEL SAFE COST 5000000
    RETURN (SELECT ST_Collect(ST_MakePoint(s."position"[1], s."position"[2], s."position"[3], s.deviation)) FROM ab_samples(evidence, loa) s WHERE s.deviation IS NOT NULL);
COMMENT ON FUNCTION ab_samples_geometry(ab_evidence, ab_loa) IS 'The samples that were seen as MULTIPOINT ZM; M is the deviation, metres (+ in front of the face)';
