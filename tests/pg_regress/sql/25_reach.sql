-- Objects that stand farther from their place than beams are added up there.
SELECT ab_evidence_model(reach => -0.1);
SELECT ab_evidence_model(reach => 'infinity');
SELECT ab_evidence_model(reach => 0.5), ab_evidence_model('LOA20', reach => 0.3), 'LOA20 reach=1.5'::ab_evidence_model;
-- What is joined with is grown by as much.
SELECT reach, ab_reach(ab_solid(ab_box(0, 0, 0, 1, 1, 1)), ab_evidence_model(reach => reach)) AS box
FROM unnest(ARRAY[0, 0.3, 1]::float8[]) reach;
CREATE TABLE object (id int, solid ab_solid);
INSERT INTO object VALUES (1, ab_solid(ab_box(5, -1, -0.8, 5.1, 1, 0.8))), (2, ab_solid(ab_box(9, -4, -4, 9.2, 4, 4)));
-- A panel that was built so many millimetres farther away than drawn, before a wall.
CREATE TABLE scan (mm int, patch ab_scan);
INSERT INTO scan
SELECT mm, ab_scan(ARRAY[0,0,0]::float8[], array_agg(ARRAY[x, x * i * 0.01, x * j * 0.01]::float8[]), 0.01, 1)
FROM unnest(ARRAY[-400, -280, -200, -120, -50, 50, 120, 200, 280, 400]) mm, generate_series(-30, 29) i, generate_series(-30, 29) j,
     LATERAL (SELECT 5 + mm * 0.001 AS panel) b,
     LATERAL (SELECT CASE WHEN panel * abs(i * 0.01) <= 1 AND panel * abs(j * 0.01) <= 0.8 THEN panel ELSE 9 END AS x) met GROUP BY mm;
SELECT mm, found.*, joined
FROM scan, LATERAL (
       SELECT verdict, round(deviation::numeric, 3) AS deviation, deviation_sd < 0.005 AS known, deviation_normal[1] AS looks
       FROM ab_verify_table('SELECT id, solid FROM object', format('SELECT patch FROM scan WHERE mm = %s', mm), ab_evidence_model(spacing => 0.04))
       WHERE id = 1) found,
     LATERAL (SELECT patch && ab_reach(solid) AS joined FROM object WHERE id = 1) x ORDER BY mm;
SELECT mm, found.*
FROM scan, LATERAL (
       SELECT verdict, round(deviation::numeric, 3) AS deviation
       FROM ab_verify_table('SELECT id, solid FROM object', format('SELECT patch FROM scan WHERE mm = %s', mm), ab_evidence_model(spacing => 0.04, reach => 1))
       WHERE id = 1) found WHERE abs(mm) >= 280 ORDER BY mm;
-- What is stored says the same, in text, binary and words; rolled up with more it has to be looked for again.
CREATE TABLE kept AS
SELECT evidence FROM ab_verify_table('SELECT id, solid FROM object', 'SELECT patch FROM scan WHERE mm = 200', ab_evidence_model(spacing => 0.04)) WHERE id = 1;
SELECT s.verdict, round(s.deviation::numeric, 3) AS deviation, evidence::text::ab_evidence = evidence AS text,
       ab_model(evidence) = ab_model(ab_rollup(evidence, evidence)) AS model, (ab_summary(ab_rollup(evidence, evidence))).verdict AS again
FROM kept, LATERAL ab_summary(evidence) s;
SELECT ab_explain(evidence) FROM kept;
DROP TABLE object, scan, kept;
