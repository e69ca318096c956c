-- What became of objects between two epochs: malformed input first.
CREATE TABLE object (id int, name text, solid ab_solid);
INSERT INTO object VALUES
    (1, 'wall', ab_solid(ab_box(5, -1.2, -1.2, 5.2, 1.2, 1.2))),
    (2, 'panel', ab_solid(ab_box(4.8, -1.2, -1.2, 4.85, 1.2, 1.2))),
    (3, 'behind', ab_solid(ab_box(8, -1, -1, 8.2, 1, 1))),
    (4, 'no geometry', NULL);
CREATE TABLE scan (epoch int, patch ab_scan);
-- A panel before a wall; gone; half of it; moved by 12 mm; the same, registered 1 mm otherwise.
INSERT INTO scan
SELECT epoch, ab_scan(ARRAY[0,0,0]::float8[], array_agg(ARRAY[x, x * i * 0.007, x * j * 0.007]::float8[]), 0.007, epoch)
FROM generate_series(1, 5) epoch, generate_series(-30, 29) i, generate_series(-30, 29) j,
     LATERAL (SELECT CASE epoch WHEN 1 THEN 4.8 WHEN 2 THEN 5 WHEN 3 THEN CASE WHEN i < 0 THEN 4.8 ELSE 5 END
                                WHEN 4 THEN 4.788 ELSE 4.801 END AS x) met GROUP BY epoch;
SELECT * FROM ab_change_table(NULL, 'TABLE object', 'TABLE object');
SELECT * FROM ab_change_table('SELECT id, solid FROM object', NULL, 'SELECT patch FROM scan');
SELECT * FROM ab_change_table('SELECT id, solid FROM object', 'SELECT patch FROM scan', NULL);
SELECT * FROM ab_change_table('SELECT name, solid FROM object', 'SELECT patch FROM scan', 'SELECT patch FROM scan');
SELECT * FROM ab_change_table('SELECT id, solid FROM object', 'TABLE object', 'SELECT patch FROM scan');
SELECT * FROM ab_change_table('SELECT id, solid FROM object', 'SELECT patch FROM scan', 'TABLE object');
SELECT * FROM ab_change_table('SELECT id, solid FROM object', 'SELECT patch FROM scan', 'DELETE FROM scan RETURNING patch');
SELECT * FROM ab_change_table('SELECT id, solid FROM object', 'SELECT patch FROM scan', 'SELECT patch FROM nowhere');
SET asbuilt.max_evidence_memory = '1MB';
\set VERBOSITY sqlstate
SELECT * FROM ab_change_table('SELECT id, solid FROM object', 'SELECT patch FROM scan', 'SELECT patch FROM scan', ab_evidence_model(spacing => 0.005));
\set VERBOSITY default
RESET asbuilt.max_evidence_memory;
SELECT enum_range(NULL::ab_change_class);

-- Every class. What hides an object, or was hidden, is not comparable; without a solid there is nothing to compare.
CREATE VIEW changes AS
SELECT old, new, o.name, c.* FROM generate_series(1, 5) old, generate_series(1, 5) new,
     LATERAL ab_change_table('SELECT id, solid FROM object', format('SELECT patch FROM scan WHERE epoch = %s', old),
                             format('SELECT patch FROM scan WHERE epoch = %s', new), ab_evidence_model(spacing => 0.04)) c
     JOIN object o USING (id);
SELECT new, id, name, change, round(seen_in_both::numeric, 2) AS seen, round(shift[1]::numeric, 4) AS x, round(shift_sd[1]::numeric, 4) AS sd,
       shift[2], round(in_both::numeric, 2) AS in_both, round(only_in_old::numeric, 2) AS only_in_old,
       round(only_in_new::numeric, 2) AS only_in_new, round(in_neither::numeric, 2) AS in_neither
FROM changes WHERE old = 1 ORDER BY new, id;
-- Old and new exchanged.
SELECT count(*) AS pairs, count(*) FILTER (WHERE a.change = b.change) AS same,
       count(*) FILTER (WHERE a.change = 'gone' AND b.change = 'appeared') AS gone_and_appeared, max(abs(a.shift[1] + b.shift[1])) < 1e-6 AS reversed
FROM changes a JOIN changes b ON (a.old, a.new, a.id) = (b.new, b.old, b.id) WHERE a.old < a.new;
-- Workers, and a survey of the new epoch that knows less: 8 mm are within its registration.
SET max_parallel_workers_per_gather = 0;
CREATE TEMP TABLE alone AS SELECT * FROM changes WHERE old = 1 AND new = 4;
SET max_parallel_workers_per_gather = 2;
SELECT count(*) AS different FROM (TABLE alone EXCEPT SELECT * FROM changes WHERE old = 1 AND new = 4) x;
RESET max_parallel_workers_per_gather;
SELECT name, change, round(shift_sd[1]::numeric, 4) AS sd
FROM ab_change_table('SELECT id, solid FROM object WHERE id < 3', 'SELECT patch FROM scan WHERE epoch = 1', 'SELECT patch FROM scan WHERE epoch = 4',
                     ab_evidence_model(spacing => 0.04), ab_evidence_model(sigma_station => 0.01)) JOIN object USING (id) ORDER BY id;
SELECT id, change FROM ab_change_table('SELECT id, solid FROM object WHERE id > 2', 'SELECT NULL::ab_scan', 'SELECT patch FROM scan') ORDER BY id;
DROP VIEW changes;
DROP TABLE object, scan;
