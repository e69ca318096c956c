-- Patches of pgPointcloud as scans of asbuilt, and back. Bodies are standard SQL: bound to their functions here and now.

\echo Use "CREATE EXTENSION asbuilt_pointcloud" to load this file. \quit

CREATE FUNCTION ab_pc_dimensions(pcid integer) RETURNS text[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE COST 1000
    RETURN (SELECT array_agg(d.name ORDER BY d.position)
            FROM pointcloud_formats f,
                 XMLTABLE('//*[local-name()="dimension"]' PASSING (f.schema::xml)
                          COLUMNS position integer PATH '*[local-name()="position"]', name text PATH '*[local-name()="name"]') d
            WHERE f.pcid = ab_pc_dimensions.pcid);
COMMENT ON FUNCTION ab_pc_dimensions(integer) IS 'Names of the dimensions of a schema of pgPointcloud, in their order';

CREATE FUNCTION ab_scans(patch pcpatch, origin float8[] DEFAULT NULL, station bigint DEFAULT 0) RETURNS SETOF ab_scan
    LANGUAGE sql STABLE PARALLEL SAFE COST 500000 ROWS 4
BEGIN ATOMIC
    WITH dimension AS (
        SELECT array_position(d, 'x') AS x, array_position(d, 'y') AS y, array_position(d, 'z') AS z,
               array_position(d, 'intensity') AS intensity
        FROM (SELECT lower(ab_pc_dimensions(PC_PCId(patch))::text)::text[] AS d) n),
    point AS (SELECT v[d.x] AS x, v[d.y] AS y, v[d.z] AS z, v[d.intensity]::integer AS intensity
              FROM dimension d, (SELECT PC_Get(PC_Explode(patch)) AS v) p)
    SELECT unnest(CASE
        WHEN origin IS NULL AND (SELECT intensity FROM dimension) IS NULL THEN (SELECT ab_cloud_agg(x, y, z, station) FROM point)
        WHEN origin IS NULL THEN (SELECT ab_cloud_agg(x, y, z, station, intensity) FROM point)
        WHEN (SELECT intensity FROM dimension) IS NULL THEN (SELECT ab_scan_agg(x, y, z, origin, station) FROM point)
        ELSE (SELECT ab_scan_agg(x, y, z, origin, station, intensity) FROM point) END);
END;
COMMENT ON FUNCTION ab_scans(pcpatch, float8[], bigint) IS 'The points of a patch of pgPointcloud as patches of asbuilt, seen from one origin (world metres) or, where that is NULL, from nobody knows where; with intensity where the schema has it, without colour. To cut a whole scan into angular tiles, give ab_scan_agg its exploded points instead';

CREATE FUNCTION _ab_no_such_schema(pcid integer) RETURNS pcpatch
    LANGUAGE plpgsql STABLE PARALLEL SAFE AS $$
BEGIN
    RAISE EXCEPTION 'pgPointcloud has no schema %', pcid
        USING ERRCODE = 'invalid_parameter_value', HINT = 'SELECT pcid FROM pointcloud_formats shows those it has.';
END $$;
COMMENT ON FUNCTION _ab_no_such_schema(integer) IS 'The error of ab_pcpatch';

CREATE FUNCTION ab_pcpatch(patch ab_scan, pcid integer) RETURNS pcpatch
    LANGUAGE sql STABLE STRICT PARALLEL SAFE COST 200000
    RETURN CASE WHEN ab_pc_dimensions(pcid) IS NULL THEN _ab_no_such_schema(pcid) ELSE
           (SELECT PC_MakePatch(pcid, array_agg(CASE lower(d.name)
                WHEN 'x' THEN b.point[1] WHEN 'y' THEN b.point[2] WHEN 'z' THEN b.point[3] WHEN 'range' THEN b.range
                WHEN 'intensity' THEN b.intensity WHEN 'red' THEN b.colour[1] WHEN 'green' THEN b.colour[2] WHEN 'blue' THEN b.colour[3]
                ELSE 0 END::float8 ORDER BY b.n, d.k))
            FROM ROWS FROM (ab_beams(patch)) WITH ORDINALITY b (origin, point, direction, range, intensity, colour, n),
                 unnest(ab_pc_dimensions(pcid)) WITH ORDINALITY d (name, k)
            WHERE b.point IS NOT NULL) END;
COMMENT ON FUNCTION ab_pcpatch(ab_scan, integer) IS 'The returns of a patch as a patch of pgPointcloud of the schema pcid: X, Y, Z, Range, Intensity, Red, Green, Blue by name, other dimensions 0; NULL without returns, an error for an unknown schema. Origin and beams without return are lost';
