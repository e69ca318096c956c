-- Exchange
-- Solids as EWKB, as PostGIS and others write and read it, without PostGIS.

-- ab_as_ewkb
-- The first bytes tell the byte order and the kind of geometry; then come the twelve triangles.
SELECT encode(substr(g, 1, 5), 'hex') AS surface, encode(substr(ab_as_ewkb(s, tin => true), 1, 5), 'hex') AS tin,
       length(g) AS bytes
FROM   ab_solid(ab_box(0, 0, 0, 4, 0.2, 2.5)) s, ab_as_ewkb(s) g;

-- ab_solid_from_ewkb
SELECT ab_box(s) AS box, ab_volume(s) AS volume
FROM   ab_solid_from_ewkb(ab_as_ewkb(ab_solid(ab_box(0, 0, 0, 4, 0.2, 2.5)))) s;
