-- Values, and their round trips through text and binary.
SELECT ab_box(4, 5, 6, 1, 2, 3), ab_min(ab_box(4, 5, 6, 1, 2, 3)), ab_max(ab_box(4, 5, 6, 1, 2, 3));
SELECT 'box3d( 1 2 3 , 4e-7 5 600000.123456789 )'::ab_box;
SELECT ab_volume(ab_box(0, 0, 0, 2, 3, 4)), ab_expand(ab_box(0, 0, 0, 1, 1, 1), 0.5), ab_box(0,0,0,1,1,1) ~= ab_box(1,1,1,0,0,0) AS same;

SELECT ab_mass(0.6, 0.1), ab_belief(ab_mass(0.6, 0.1), 'occupied'), ab_plausibility(ab_mass(0.6, 0.1), 'empty');
-- Shafer by hand: (.6,0,.4) with (.5,.2,.3)
SELECT ab_combine(ab_mass(0.6, 0), ab_mass(0.5, 0.2)), ab_conflict(ab_mass(0.6, 0), ab_mass(0.5, 0.2));
SELECT ab_combine(m, ab_mass(0, 0)) ~= m AS vacuous_is_neutral FROM (SELECT ab_mass(0.3, 0.2) m) x;

SELECT * FROM ab_loa_class();
SELECT ab_upper_bound('LOA30'), 'LOA10'::ab_loa < 'LOA50'::ab_loa AS coarser_is_less;

SELECT ab_closedness(s), ab_volume(s), ab_area(s), ab_box(s) FROM (SELECT ab_solid(ab_box(0, 0, 0, 1, 2, 3)) s) x;
SELECT ab_closedness(s), ab_area(s), ab_volume(s) IS NULL AS has_none FROM (SELECT ab_solid(ARRAY[[0,0,0],[1,0,0],[0,1,0]]::float8[], ARRAY[[0,1,2]]) s) x;
-- a tetrahedron one edge of which is split on one side only
SELECT ab_closedness(s), round(ab_volume(s)::numeric, 6) FROM (SELECT ab_solid(
    ARRAY[[0,0,0],[1,0,0],[0,1,0],[0,0,1],[0.5,0,0]]::float8[],
    ARRAY[[0,2,4],[4,2,1],[0,1,3],[0,3,2],[1,2,3]]) s) x;
-- inside out is turned
SELECT ab_volume(ab_solid(ab_vertices(s), (SELECT array_agg(ARRAY[t[i][1], t[i][3], t[i][2]]) FROM generate_subscripts(t, 1) i)))
FROM (SELECT s, ab_triangles(s) t FROM (SELECT ab_solid(ab_box(0, 0, 0, 1, 2, 3)) s) x) y;

CREATE TEMP TABLE patch AS
SELECT ab_scan(ARRAY[600000, 5300000, 500]::float8[],
               array_agg(ARRAY[600005, 5300000 + y * 0.01, 500 + z * 0.01]::float8[] ORDER BY y, z), station => 7) AS p
FROM generate_series(-20, 20) y, generate_series(-20, 20) z;
SELECT ab_count(p), ab_return_count(p), ab_origin(p), ab_station(p), ab_point_box(p), ab_box(p) FROM patch;

-- round trips: text and binary give back the same bytes
SELECT p::text::ab_scan::text = p::text AS scan_text FROM patch;
SELECT s::text::ab_solid::text = s::text AS solid_text FROM (SELECT ab_solid(ab_box(0, 0, 0, 1, 2, 3)) s) x;
SELECT m::text::ab_evidence_model::text = m::text AS model_text FROM (SELECT ab_evidence_model('LOA40', 'meyer2022', sigma_range => 0.1::float8 + 0.2) m) x;
CREATE TEMP TABLE everything AS
SELECT ab_box(0.1, 0.2, 0.3, 1e-9, 5e6, 7) AS b, ab_mass(0.1, 0.3) AS m, ab_solid(ab_box(0, 0, 0, 1, 2, 3)) AS s, p,
       ab_evidence_model(spacing => 0.5) AS model, 'LOA40'::ab_loa AS l,
       (SELECT ab_evidence_agg(ab_solid(ab_box(600005, 5300000, 500, 600006, 5300001, 501)), p, ab_evidence_model(spacing => 0.05)) FROM patch) AS e
FROM patch;
SELECT ab_count(e) AS samples, ab_station_count(e), ab_box(e) FROM everything;
\copy everything TO '/tmp/asbuilt_regress_round_trip.bin' (FORMAT binary)
CREATE TEMP TABLE back (LIKE everything);
\copy back FROM '/tmp/asbuilt_regress_round_trip.bin' (FORMAT binary)
\! rm -f /tmp/asbuilt_regress_round_trip.bin
SELECT a.b ~= b.b AND a.m ~= b.m AND a.s::text = b.s::text AND a.p::text = b.p::text AND a.model::text = b.model::text
       AND a.l = b.l AND a.e::text = b.e::text AS binary_round_trip
FROM everything a, back b;
SELECT e::text::ab_evidence::text = e::text AS evidence_text FROM everything;
