-- Evidence and verdicts
-- What the beams say about a building object, stored as a value and asked as often as you like.
CREATE TEMP TABLE building_object (id bigint, name text, solid ab_solid);
INSERT INTO building_object VALUES (1, 'wall', ab_solid(ab_box(5, -2, 0, 5.2, 2, 2))),
                                   (2, 'column', ab_solid(ab_box(3, 0.5, 0, 3.2, 0.7, 2))),
                                   (3, 'store', ab_solid(ab_box(7, -1, 0, 8, 1, 2)));
CREATE TEMP TABLE scan AS         -- two stations see the wall, 8 mm behind its place; the column was never built
SELECT unnest(ab_scan_agg(5.008, y + (5.008 * a) * 0.005, 1 + (5.008 * b) * 0.005, ARRAY[0, y, 1], station)) AS patch
FROM  (VALUES (1, -0.5), (2, 1)) s(station, y), generate_series(-70, 70) a, generate_series(-39, 39) b
GROUP  BY station;
CREATE TEMP TABLE evidence AS
SELECT o.id, o.name, ab_evidence_agg(o.solid, s.patch, ab_evidence_model('LOA30', spacing => 0.05)) AS evidence
FROM   building_object o LEFT JOIN scan s ON s.patch && ab_reach(o.solid) GROUP BY o.id, o.name;

-- ab_evidence_model
SELECT ab_evidence_model() AS by_default, ab_evidence_model('LOA40', spacing => 0.02, sigma_range => 0.001) AS stated;

-- ab_sensor
SELECT name, sigma_range, sigma_angle, sigma_station, max_range FROM ab_sensor();

-- ab_with_sensor
SELECT ab_with_sensor(ab_evidence_model('LOA30'), 'phase') AS model;

-- ab_with_intensity
SELECT ab_with_intensity(ab_evidence_model('LOA30'), reference => 1000) AS model;

-- ab_evidence_agg
-- From scans, and from tie points of photographs that two cameras took.
SELECT name, ab_verdict(evidence) AS verdict
FROM  (SELECT o.id, o.name, ab_evidence_agg(o.solid, s.patch, ab_evidence_model('LOA30', spacing => 0.05)) AS evidence
       FROM   building_object o LEFT JOIN scan s ON s.patch && ab_reach(o.solid) GROUP BY o.id, o.name) e ORDER BY id;
SELECT ab_verdict(ab_evidence_agg(solid, ab_point(5, a * 0.05, 1 + b * 0.05, 0.002), ARRAY[[0, 0, 1], [0, 1, 1]],
                                  ab_evidence_model(spacing => 0.05))) AS by_tie_points
FROM   building_object, generate_series(-39, 39) a, generate_series(-19, 19) b WHERE id = 1;

-- ab_summary(ab_evidence, ab_loa, float8, float8, float8, float8)
SELECT name, s.verdict, s.best_loa, round(s.coverage::numeric, 2) AS coverage,
       round(s.confirmed::numeric, 2) AS confirmed, round(s.refuted::numeric, 2) AS refuted,
       round(s.deviation::numeric, 4) AS deviation, round(s.shift[1]::numeric, 4) AS along_x
FROM   evidence, ab_summary(evidence) s ORDER BY id;

-- ab_verdict
SELECT name, ab_verdict(evidence) AS loa30, ab_verdict(evidence, loa => 'LOA40') AS loa40 FROM evidence ORDER BY id;

-- ab_explain
SELECT ab_explain(evidence) FROM evidence WHERE id = 1;

-- ab_shift
-- Only along x: a wall that is seen from the front says nothing about the other directions.
SELECT round(s.shift[1]::numeric, 4) AS along_x, s.shift[2] AS along_y, round(s.shift_sd[1]::numeric, 4) AS sd
FROM   evidence, ab_shift(evidence) s WHERE id = 1;

-- ab_samples
SELECT s.position, round(ab_belief(s.mass)::numeric, 2) AS built_here,
       round(s.deviation::numeric, 4) AS deviation, s.beams
FROM   evidence, ab_samples(evidence) s WHERE id = 1 AND s.beams > 0 ORDER BY s.position LIMIT 3;

-- ab_faces
SELECT f.normal, f.samples, f.seen, f.confirmed, round(f.deviation::numeric, 4) AS deviation
FROM   evidence, ab_faces(evidence) f WHERE id = 1 ORDER BY f.normal;

-- ab_box(ab_evidence)
SELECT name, ab_box(evidence) AS box FROM evidence ORDER BY id;

-- ab_count(ab_evidence)
SELECT name, ab_count(evidence) AS samples FROM evidence ORDER BY id;

-- ab_station_count
SELECT name, ab_station_count(evidence) AS stations FROM evidence ORDER BY id;

-- ab_stations
SELECT s.* FROM evidence, ab_stations(evidence) s WHERE id = 1 ORDER BY s.station;

-- ab_model
SELECT string_to_table(ab_model(evidence)::text, ' ') AS made_with FROM evidence WHERE id = 1;

-- ab_rollup(ab_evidence, ab_evidence)
-- Tomorrow's scan is added to today's evidence: exactly as if both had been there at once.
SELECT ab_rollup(today.evidence, tomorrow.evidence) = both_days.evidence AS as_at_once
FROM  (SELECT ab_evidence_agg(solid, patch, ab_evidence_model('LOA30', spacing => 0.05)) AS evidence
       FROM   building_object, scan WHERE id = 1 AND ab_station(patch) = 1) today,
      (SELECT ab_evidence_agg(solid, patch, ab_evidence_model('LOA30', spacing => 0.05)) AS evidence
       FROM   building_object, scan WHERE id = 1 AND ab_station(patch) = 2) tomorrow,
       evidence both_days WHERE both_days.id = 1;

-- ab_rollup_agg(ab_evidence)
SELECT ab_station_count(ab_rollup_agg(evidence)) AS stations
FROM  (SELECT ab_evidence_agg(solid, patch, ab_evidence_model('LOA30', spacing => 0.05)) AS evidence
       FROM   building_object, scan WHERE id = 1 GROUP BY ab_station(patch)) by_station;

-- ab_verify_table
SELECT o.name, v.verdict, v.best_loa, round(v.coverage::numeric, 2) AS coverage,
       round(v.deviation::numeric, 4) AS deviation
FROM   ab_verify_table('SELECT id, solid FROM building_object', 'SELECT patch FROM scan',
                       ab_evidence_model('LOA30', spacing => 0.05)) v
JOIN   building_object o USING (id) ORDER BY id;

-- ab_change_table
-- Later the column stands, and the wall was moved by 12 mm; it still hides the store.
CREATE TEMP TABLE later_scan AS
SELECT unnest(ab_scan_agg(x, y + x * a * 0.005, 1 + x * b * 0.005, ARRAY[0, y, 1], station)) AS patch
FROM  (VALUES (1, -0.5), (2, 1)) s(station, y), generate_series(-70, 70) a, generate_series(-39, 39) b,
       LATERAL (SELECT CASE WHEN y + 3 * a * 0.005 BETWEEN 0.5 AND 0.7 THEN 3 ELSE 4.996 END AS x) met
GROUP  BY station;
SELECT o.name, c.change, round(c.seen_in_both::numeric, 2) AS seen_in_both, round(c.shift[1]::numeric, 4) AS along_x,
       round(c.shift_sd[1]::numeric, 4) AS sd
FROM   ab_change_table('SELECT id, solid FROM building_object', 'SELECT patch FROM scan',
                       'SELECT patch FROM later_scan', ab_evidence_model('LOA30', spacing => 0.05)) c
JOIN   building_object o USING (id) ORDER BY id;
