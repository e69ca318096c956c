# Many objects from table to table: speed, workers, linearity, memory, leaks, cancelling.
# A storey of 24 rooms with screeds: 202 objects.
# shellcheck shell=bash disable=SC2154
python3 demo/make_model.py office >$data/office.ifc
for i in 0 1 2 3 4 5; do
  for j in 0 1 2 3; do
    [ $(((i + j) % 2)) = 1 ] || awk -v i=$i -v j=$j 'BEGIN {print i * 3.6 + 1.9, j * 4.2 + 1.4, 1.6}'
  done
done >$data/office-stations.txt
createdb office
export PGDATABASE=office
"$asbuilt" load $data/office.ifc 2>/dev/null
ask "INSERT INTO building_object (global_id, ifc_class, name, loa, properties, source, solid)
     SELECT global_id || '-screed', 'IfcCovering', name || ' screed', loa, '{}', 'bench',
            ab_solid(ab_box(lo[1], lo[2], -0.06, hi[1], hi[2], 0))
     FROM (SELECT *, ab_min(ab_box(solid)) AS lo, ab_max(ab_box(solid)) AS hi FROM building_object WHERE name LIKE 'floor%') f"
epoch=0
for step in 12.53 8.86 6.26 4.43 2.44; do
  epoch=$((epoch + 1))
  scan=$data/office-$step.e57
  [ -e $scan ] || "$asbuilt" simulate $data/office.ifc --stations $data/office-stations.txt --step-mrad $step --out $scan 2>/dev/null
  "$asbuilt" load $scan --epoch $epoch 2>/dev/null
done
objects=$(ask "SELECT count(*) FROM building_object")

verify() { # epoch, spacing: the query
  echo "SELECT * FROM ab_verify_table('SELECT id, solid FROM building_object', 'SELECT patch FROM scan WHERE epoch = $1', ab_evidence_model('LOA30', spacing => $2), keep_evidence => false)"
}
to_table() { # epoch, workers, spacing: the statement
  echo "SET max_parallel_workers_per_gather = $2; CREATE TEMP TABLE verdict AS $(verify "$1" "$3")"
}
by_aggregate="SET max_parallel_workers_per_gather = 0; CREATE TEMP TABLE verdict AS SELECT o.id, s.* FROM (SELECT o.id, ab_evidence_agg(o.solid, s.patch, ab_evidence_model('LOA30')) AS e FROM building_object o LEFT JOIN scan s ON s.epoch = 4 AND s.patch && o.solid GROUP BY o.id) o, LATERAL ab_summary(o.e) s"
beams() { ask "SELECT sum(ab_count(patch)) FROM scan WHERE epoch = $1"; }
samples() { ask "SELECT round(sum(ab_area(solid)) / $1 / $1) FROM building_object"; }

for workers in 0 1 2; do
  row "ab_verify_table, table to table: $objects objects, $(samples 0.02) samples (2 cm), $(beams 4) beams, max_parallel_workers_per_gather $workers" "$(timed psql -Xq -c "$(to_table 4 $workers 0.02)") s"
done
row "the same by ab_evidence_agg and ab_summary on one core (a patch is unpacked for every object)" "$(timed psql -Xq -c "$by_aggregate") s"
row "M's scenario 1: $(beams 5) beams, $(samples 0.0902) samples, two cores" "$(timed psql -Xq -c "$(to_table 5 1 0.0902)") s"
for epoch in 1 2 3 4; do
  row "linear in beams: $(beams $epoch) beams, 2 cm, one core" "$(timed psql -Xq -c "$(to_table $epoch 0 0.02)") s"
done
for spacing in 0.0566 0.04 0.0283 0.02; do
  row "linear in samples: $(samples $spacing) samples, $(beams 4) beams, one core" "$(timed psql -Xq -c "$(to_table 4 0 $spacing)") s"
done

status() { echo "SELECT substring(pg_read_file('/proc/self/status', 0, 4000) FROM '$1:\s+(\d+)')::int / 1024 || ' MB'"; }
row "peak memory of the process before and after the 10 M beams at 2 cm" "$(psql -XAtq -c "$(status VmHWM)" -c "$(to_table 4 0 0.02)" -c "$(status VmHWM)" | paste -sd' ')"
row "sample-stations in that evidence (samples times stations that saw the object)" "$(ask "SELECT sum(ab_count(evidence)::bigint * ab_station_count(evidence)) FROM ab_verify_table('SELECT id, solid FROM building_object', 'SELECT patch FROM scan WHERE epoch = 4')")"
some="ab_verify_table('SELECT id, solid FROM building_object WHERE name LIKE ''wall x1%''', 'SELECT patch FROM scan WHERE epoch = 1 LIMIT 20', ab_evidence_model(spacing => 0.1))"
for workers in 0 1; do
  row "resident memory in one session after 100 calls and after 1000, workers $workers" "$(psql -XAtq -c "SET max_parallel_workers_per_gather = $workers" -c "$(for _ in $(seq 100); do echo "SELECT FROM $some;"; done)" -c "$(status VmRSS)" -c "$(for _ in $(seq 900); do echo "SELECT FROM $some;"; done)" -c "$(status VmRSS)" | grep MB | paste -sd' ')"
  for after in 100 1000 3000 5000; do
    row "statement_timeout $after ms during ab_verify_table over 10 M beams, workers $workers: over after (worst of three, connection included)" "+$(late "$(to_table 4 $workers 0.02)" $after) ms"
  done
done
export PGDATABASE=bench
