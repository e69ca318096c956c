# Evidence, verdicts, and how soon they are cancelled.
# shellcheck shell=bash disable=SC2154
[ "$(ask "SELECT count(*) FROM scan WHERE epoch = 10")" -gt 0 ] || "$asbuilt" load $data/10m.e57 --epoch 10 2>/dev/null
"$asbuilt" load $data/1m.e57 --epoch 1 2>/dev/null

evidence() { # epoch, workers
  echo "SET max_parallel_workers_per_gather = $2; SELECT count(e) FROM (SELECT ab_evidence_agg(o.solid, s.patch, ab_evidence_model(loa => 'LOA30')) AS e FROM building_object o LEFT JOIN scan s ON s.epoch = $1 AND s.patch && o.solid GROUP BY o.id) x"
}
objects=$(ask "SELECT count(*) FROM building_object")
samples=$(ask "SELECT round(sum(ab_area(solid)) / 4e-4) FROM building_object")
for epoch in 1 10; do
  n=$(ask "SELECT sum(ab_count(patch)) FROM scan WHERE epoch = $epoch")
  row "evidence, $objects objects ($samples samples at 2 cm) over $n beams, one core" "$(timed psql -Xq -c "$(evidence $epoch 0)") s"
done
row "asbuilt verify, the same over epoch 1 (evidence, summary, best LOA; planner's own choice of workers)" "$(timed "$asbuilt" verify --epoch 1) s"

if [ -e ../shared/data/hall/epoch1.e57 ]; then
  createdb hall
  export PGDATABASE=hall
  "$asbuilt" load ../shared/data/hall/model.ifc ../shared/data/hall/epoch1.e57 2>/dev/null
  row "evidence, all hall objects ($(ask "SELECT round(sum(ab_area(solid)) / 4e-4) FROM building_object") samples at 2 cm) over $(ask "SELECT sum(ab_count(patch)) FROM scan") beams, one core" "$(timed psql -Xq -c "$(evidence 1 0)") s"
  export PGDATABASE=bench
fi

# Cancel: how long after the timeout the query is over.
row "statement_timeout 300 ms during evidence over 10 M beams: over after (worst of three, connection included)" "+$(late "$(evidence 10 0)" 300) ms"
row "statement_timeout 100 ms while 4.4 M samples are spread on one solid" "+$(late "SELECT ab_count(ab_evidence_agg(ab_solid(ab_box(0, 0, 0, 20, 20, 2)), NULL, ab_evidence_model(spacing => 0.0152)))" 100) ms"
ask "CREATE TABLE evidence AS SELECT ab_evidence_agg(o.solid, s.patch, ab_evidence_model()) AS e FROM building_object o JOIN scan s ON s.epoch = 10 AND s.patch && o.solid GROUP BY o.id"
row "statement_timeout 300 ms during ab_summary of all objects" "+$(late "SELECT count(s) FROM evidence, generate_series(1, 9), LATERAL ab_summary(e) s" 300) ms"
row "stored evidence" "$(ask "SELECT round(sum(pg_column_size(e))::numeric / sum(ab_count(e)), 1) || ' bytes a sample (4 stations)' FROM evidence")"
# The same on one object of two million triangles, and on one of five million samples: the slowest steps at many times.
ask "CREATE TABLE huge AS SELECT ab_solid(
  (SELECT array_agg(ARRAY[i * 0.02, j * 0.02, 0.01 * sin(i * 0.3) * cos(j * 0.2)] ORDER BY i, j) FROM generate_series(0, 1000) i, generate_series(0, 1000) j),
  (SELECT array_agg(t ORDER BY i, j, k) FROM generate_series(0, 999) i, generate_series(0, 999) j,
     LATERAL (VALUES (1, ARRAY[i * 1001 + j, i * 1001 + j + 1001, i * 1001 + j + 1]), (2, ARRAY[i * 1001 + j + 1, i * 1001 + j + 1001, i * 1001 + j + 1002])) v(k, t))) AS solid"
ask "CREATE TABLE wide AS SELECT ab_evidence_agg(ab_solid(ab_box(0, 0, 0, 47, 47, 0.3)), patch, ab_evidence_model()) AS e FROM (
  SELECT ab_scan(ARRAY[23.5 + st, 23.5, 20], (SELECT array_agg(ARRAY[i * 1.28 + a * 0.02, j * 1.28 + b * 0.02, 0.3]) FROM generate_series(0, 63) a, generate_series(0, 63) b), NULL, st) AS patch
  FROM generate_series(1, 2) st, generate_series(0, 36) i, generate_series(0, 36) j) p"
ask "ALTER TABLE wide ALTER e SET STORAGE external"
row "timeout during ab_evidence_agg on 2 M triangles, worst of 15 times" "+$(worst "SELECT ab_count(ab_evidence_agg(solid, NULL, NULL)) FROM huge") ms"
row "timeout during ab_summary of 5 M samples, two stations, worst of 15 times" "+$(worst "SELECT s FROM wide, ab_summary(e) s") ms"
row "timeout during the text form of the same ($(ask "SELECT pg_size_pretty(pg_column_size(e)::bigint) FROM wide")), worst of 15 times" "+$(worst "SELECT _ab_evidence_out(e) IS NULL FROM wide") ms"
row "timeout during ab_rollup of the same with itself, worst of 15 times" "+$(worst "SELECT ab_count(ab_rollup(e, e)) FROM wide") ms"
