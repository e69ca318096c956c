-- Many objects at once: the evidence and the verdicts of ab_verify_table, and why.
-- A wall, its neighbour across it (whose end face the wall covers by 60 mm), a wall that is missing, and one without geometry.
CREATE TABLE object (id int, name text, solid ab_solid, loa ab_loa DEFAULT 'LOA30');
INSERT INTO object VALUES
    (1, 'wall', ab_solid(ab_box(5, -2, -1, 5.12, 2, 1))),
    (2, 'neighbour', ab_solid(ab_box(5.06, -0.1, -0.5, 5.5, 0.1, 0.5))),
    (3, 'missing', ab_solid(ab_box(3, 0.5, -1, 3.1, 1.0, 1))),
    (4, 'no geometry', NULL);
-- What a scanner at the origin sees: the wall as drawn, 4 mrad apart.
CREATE TABLE scan (patch ab_scan);
INSERT INTO scan
SELECT ab_scan(ARRAY[0,0,0]::float8[], array_agg(ARRAY[5, 5 * (a * 0.2 + i * 0.004), 5 * (b * 0.2 + j * 0.004)]::float8[]), 0.004, 1)
FROM generate_series(-2, 1) a, generate_series(-1, 0) b, generate_series(0, 49) i, generate_series(0, 49) j GROUP BY a, b;

-- Alone, the neighbour's end face is met 60 mm in front of where it is drawn; together, the wall explains that.
SELECT o.name, alone.verdict AS alone, t.verdict AS together, t.best_loa, t.samples, round(t.coverage::numeric, 2) AS coverage
FROM object o JOIN ab_verify_table('SELECT id, solid FROM object', 'SELECT patch FROM scan', ab_evidence_model('LOA30')) t USING (id)
     LEFT JOIN (SELECT o.id, (ab_summary(ab_evidence_agg(o.solid, s.patch, ab_evidence_model('LOA30')))).verdict
                FROM object o, scan s WHERE o.solid IS NOT NULL GROUP BY o.id) alone USING (id)
ORDER BY id;

-- The evidence is the aggregate's where no neighbour explains anything, to the last byte but the one that tells that the
-- neighbours are known (and the header's checksum), with any number of workers.
CREATE TABLE result (workers int, id bigint, evidence ab_evidence, verdict text, shift float8[]);
DO $$ BEGIN
    FOR workers IN 0..2 LOOP
        PERFORM set_config('max_parallel_workers_per_gather', workers::text, true);
        INSERT INTO result SELECT workers, id, evidence, verdict, shift
        FROM ab_verify_table('SELECT id, solid, ab_evidence_model(loa) FROM object', 'TABLE scan');
    END LOOP;
END $$;
SELECT count(*) AS rows, count(DISTINCT (id, evidence, verdict, shift)) AS different FROM result;
SELECT o.name, substr(a.e, 23, 16) || substr(a.e, 47) = substr(r.evidence::text, 23, 16) || substr(r.evidence::text, 47) AS same
FROM object o JOIN result r ON r.id = o.id AND workers = 0
JOIN (SELECT o.id, ab_evidence_agg(o.solid, s.patch, ab_evidence_model())::text AS e FROM object o, scan s GROUP BY o.id) a ON a.id = o.id
WHERE o.name IN ('wall', 'missing') ORDER BY 1;
SELECT count(evidence) AS kept, count(verdict) AS judged FROM ab_verify_table('SELECT id, solid FROM object', 'TABLE scan', keep_evidence => false);
SELECT verdict FROM ab_verify_table('SELECT id, solid FROM object WHERE id = 1', 'SELECT NULL::ab_scan');
SELECT count(*) FROM ab_verify_table('SELECT id, solid FROM object', NULL);
SELECT ab_with_sensor(ab_evidence_model(), NULL);

-- A station added tomorrow: as if all had been there at once, and visible by itself.
INSERT INTO scan
SELECT ab_scan(ARRAY[0,1,0]::float8[], array_agg(ARRAY[5, 5 * i * 0.004, 5 * j * 0.004]::float8[]), 0.004, 2)
FROM generate_series(-25, 24) i, generate_series(-25, 24) j;
SELECT ab_rollup(a.evidence, b.evidence) = c.evidence AS as_if_at_once,
       round((ab_summary(b.evidence)).coverage::numeric, 2) AS added, ab_station_count(c.evidence) AS stations
FROM ab_verify_table('SELECT 1, solid FROM object WHERE id = 1', 'SELECT patch FROM scan WHERE ab_station(patch) = 1') a,
     ab_verify_table('SELECT 1, solid FROM object WHERE id = 1', 'SELECT patch FROM scan WHERE ab_station(patch) = 2') b,
     ab_verify_table('SELECT 1, solid FROM object WHERE id = 1', 'TABLE scan') c;
-- What each contributed: all that the second sees, the first saw, too.
SELECT s.* FROM ab_verify_table('SELECT 1, solid FROM object WHERE id = 1', 'TABLE scan') c, ab_stations(c.evidence) s;
SELECT count(*) FROM ab_stations(NULL);

-- What else may be given is refused, and says what was found.
SELECT * FROM ab_verify_table('SELECT id FROM object', 'TABLE scan');
SELECT * FROM ab_verify_table('SELECT id, name FROM object', 'TABLE scan');
SELECT * FROM ab_verify_table('SELECT name, solid FROM object', 'TABLE scan');
SELECT * FROM ab_verify_table('SELECT id, solid FROM object', 'TABLE object');
SELECT * FROM ab_verify_table('DELETE FROM object', 'TABLE scan');
SELECT * FROM ab_verify_table('', 'TABLE scan');
SELECT * FROM ab_verify_table('SELECT id, solid FROM nowhere', 'TABLE scan');
SELECT * FROM ab_verify_table('SELECT id, solid FROM object', 'TABLE scan', min_confirmed => 2);
SET asbuilt.max_evidence_memory = '1MB';
\set VERBOSITY sqlstate
SELECT * FROM ab_verify_table('SELECT id, solid, ab_evidence_model(spacing => 0.005) FROM object', 'TABLE scan');
\set VERBOSITY default
RESET asbuilt.max_evidence_memory;

-- Why.
SELECT ab_explain(evidence) FROM result WHERE id = 1 AND workers = 0;
SELECT ab_explain(evidence, 'LOA50') FROM result WHERE id = 1 AND workers = 0;
SELECT ab_explain(evidence) FROM result WHERE id = 3 AND workers = 0;
SELECT ab_explain(ab_evidence_agg(solid, NULL, NULL)) FROM object WHERE id = 1;
SELECT ab_explain(NULL) IS NULL AS null;

-- Sensors.
SELECT * FROM ab_sensor();
SELECT ab_with_sensor(ab_evidence_model('LOA40'), 'phase');
SELECT * FROM ab_sensor('theodolite');
DROP TABLE object, scan, result;
SELECT ab_with_intensity(ab_evidence_model('LOA40'), 1200, 1.5);
SELECT ab_with_intensity(ab_evidence_model(), 70000);
SELECT ab_with_intensity(ab_evidence_model(), 100, 9);
SELECT 'loa=LOA30 intensity=12'::ab_evidence_model;

-- Errors inside a query say in which of the two.
SELECT count(*) FROM ab_verify_table('SELECT id, solid FROM nowhere', 'SELECT NULL::ab_scan');
SELECT count(*) FROM ab_verify_table('SELECT 1, NULL::ab_solid', 'SELECT ab_scan(ARRAY[0, 0, 0]::float8[], ARRAY[[1 / (i - 2), 0, 0]]::float8[]) FROM generate_series(1, 3) i');
