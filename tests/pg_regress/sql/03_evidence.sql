-- Evidence and verdict on a wall one metre square, 5 m in front of a scanner.
CREATE TEMP TABLE wall AS SELECT ab_solid(ab_box(5, -0.5, -0.5, 5.2, 0.5, 0.5)) AS solid;

-- What a scanner at the origin sees of a plane x = distance, 2 mrad apart; a hit beyond the wall's edge is the same plane.
CREATE FUNCTION plane(distance float8, lo float8 DEFAULT -0.15, hi float8 DEFAULT 0.15, station bigint DEFAULT 1) RETURNS ab_scan
LANGUAGE sql AS $$
    SELECT ab_scan(ARRAY[0,0,0]::float8[], array_agg(ARRAY[distance, distance * y, distance * z]::float8[] ORDER BY y, z), 0.004, station)
    FROM (SELECT i * 0.004 AS y FROM generate_series((lo / 0.004)::int, (hi / 0.004)::int - 1) i) a,
         (SELECT i * 0.004 AS z FROM generate_series(-26, 26) i) b
$$;

-- Numbers to a tenth of a millimetre.
CREATE FUNCTION rounded(numbers float8[]) RETURNS numeric[] LANGUAGE sql
RETURN (SELECT array_agg(round(v::numeric, 4) ORDER BY i) FROM unnest(numbers) WITH ORDINALITY u(v, i));

CREATE TEMP TABLE cases (id int, what text, patch ab_scan);
INSERT INTO cases VALUES
    (1, 'as drawn',               plane(5.0)),
    (2, '12 mm behind',           plane(5.012)),
    (3, '30 mm behind',           plane(5.03)),
    (4, '30 mm in front',         plane(4.97)),
    (5, 'seen through',           plane(8)),
    (6, 'hidden by a cupboard',   plane(3)),
    (7, 'no patch',               NULL);

SELECT what, verdict, best_loa, samples, round(coverage::numeric, 2) AS coverage, round(confirmed::numeric, 2) AS confirmed,
       round(refuted::numeric, 2) AS refuted, round(open::numeric, 2) AS open,
       round(deviation::numeric, 4) AS deviation, round(deviation_sd::numeric, 4) AS sd, rounded(shift) AS shift, rounded(shift_sd) AS shift_sd
FROM (SELECT id, what, ab_evidence_agg(solid, patch, ab_evidence_model('LOA30')) AS e FROM wall, cases GROUP BY id, what) x,
     LATERAL ab_summary(e)
ORDER BY id;

-- confirmed + refuted + open = 1
SELECT bool_and(abs(confirmed + refuted + open - 1) < 1e-12) AS shares_sum_to_one, count(*) > 4 AS some
FROM (SELECT ab_evidence_agg(solid, patch, ab_evidence_model()) AS e FROM wall, cases GROUP BY id) x, LATERAL ab_summary(e)
WHERE coverage > 0;

-- another question to the same evidence
SELECT ab_verdict(e) AS loa30, ab_verdict(e, 'LOA40') AS loa40, ab_verdict(e, loa => 'LOA20', confidence => 0.9) AS loa20,
       ab_verdict(e, confidence => 0.99) AS beyond_one_station
FROM (SELECT ab_evidence_agg(solid, patch, ab_evidence_model('LOA30')) AS e FROM wall, cases WHERE id = 2) x;

-- points in front and behind on the same face: half the wall displaced
SELECT round(deviation::numeric, 3) AS deviation, count(*) > 20 AS many, min(mass::text) IS NOT NULL AS has_mass,
       bool_and(ab_belief(mass, 'occupied') + ab_belief(mass, 'empty') <= 1 + 1e-12) AS is_mass
FROM (SELECT ab_evidence_agg(solid, patch, ab_evidence_model(spacing => 0.05)) AS e
      FROM wall, (VALUES (plane(5.0, -0.1, 0)), (plane(5.02, 0, 0.1))) v(patch)) x, LATERAL ab_samples(e) s
WHERE normal[1] < -0.9 AND beams > 10 AND abs("position"[2]) > 0.1 AND abs("position"[2]) < 0.4 AND abs("position"[3]) < 0.4
GROUP BY 1 ORDER BY 1;

-- a station split over many patches and calls is one body of evidence: bit by bit
WITH split AS (
    SELECT solid, patch FROM wall, (VALUES (plane(5.01, -0.15, -0.05)), (plane(5.01, -0.05, 0.06)), (plane(5.01, 0.06, 0.15))) v(patch)
), one AS (SELECT ab_evidence_agg(solid, patch, ab_evidence_model(spacing => 0.05)) AS e FROM split),
parts AS (SELECT ab_evidence_agg(solid, patch, ab_evidence_model(spacing => 0.05)) AS e FROM split GROUP BY patch::text),
backwards AS (SELECT ab_evidence_agg(solid, patch, ab_evidence_model(spacing => 0.05) ORDER BY patch::text DESC) AS e FROM split)
SELECT (SELECT ab_rollup_agg(e) FROM parts)::text = one.e::text AS rolled_up, backwards.e::text = one.e::text AS order_free,
       ab_rollup(one.e, NULL)::text = one.e::text AS null_adds_nothing, ab_station_count(one.e) AS stations
FROM one, backwards;

-- an open surface is judged from both sides
SELECT side, verdict, round(deviation::numeric, 3) AS deviation FROM (
    SELECT side, ab_evidence_agg(ab_solid(ARRAY[[5,-0.5,-0.5],[5,0.5,-0.5],[5,0.5,0.5],[5,-0.5,0.5]]::float8[], tri), plane(5.004), ab_evidence_model()) AS e
    FROM (VALUES ('front', ARRAY[[0,2,1],[0,3,2]]), ('back', ARRAY[[0,1,2],[0,2,3]])) v(side, tri) GROUP BY side) x, LATERAL ab_summary(e)
ORDER BY side DESC;

-- nulls
SELECT * FROM ab_summary(NULL::ab_evidence);
SELECT count(*) FROM ab_samples(NULL);
SELECT count(*) FROM ab_faces(NULL);
SELECT ab_verdict(NULL) IS NULL AS verdict, ab_evidence_agg(NULL, plane(5), ab_evidence_model()) IS NULL AS no_solid;
SELECT ab_verdict(ab_evidence_agg(solid, NULL, NULL)) FROM wall;

-- the rigid offset: only along the normal of the one face that was seen; NULL as a whole where nothing was
SELECT rounded(shift) AS shift, rounded(shift_sd) AS shift_sd
FROM (SELECT ab_evidence_agg(solid, patch, ab_evidence_model()) AS e FROM wall, cases WHERE id = 2) w, LATERAL ab_shift(e);
SELECT s.shift, s.shift_sd FROM (SELECT ab_evidence_agg(solid, NULL, ab_evidence_model()) AS e FROM wall) w, ab_shift(e) s;
SELECT * FROM ab_shift(NULL);

-- the faces
SELECT normal, seen > 0 AS seen, pierced FROM (SELECT ab_evidence_agg(solid, patch, ab_evidence_model()) AS e FROM wall, cases WHERE id = 1) w,
    LATERAL ab_faces(e) ORDER BY normal;
DROP FUNCTION plane, rounded;
