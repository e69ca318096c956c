# A whole building: four storeys of the office of demo/models, more samples than one batch holds.
# shellcheck shell=bash disable=SC2154
python3 demo/make_model.py office --storeys 4 --stations $data/storeys-stations.txt $data/storeys.ifc
# 3.6 million beams: a sphere less the cone around the tripod is 16.45 / step² directions, the step in radians.
step=$(awk '!/^#/ { n++ } END { printf "%.2f", 1000 * sqrt(16.45 * n / 3.6e6) }' $data/storeys-stations.txt)
[ $data/storeys.e57 -nt demo/models/office.ifc ] || "$asbuilt" simulate $data/storeys.ifc --stations $data/storeys-stations.txt --step-mrad "$step" --out $data/storeys.e57 2>/dev/null
createdb storeys
export PGDATABASE=storeys
"$asbuilt" load $data/storeys.ifc $data/storeys.e57 2>/dev/null

storeys() { # workers, memory: the statement
  echo "SET max_parallel_workers_per_gather = $1; SET asbuilt.max_evidence_memory = '$2'; CREATE TEMP TABLE verdict AS SELECT * FROM ab_verify_table('SELECT id, solid FROM building_object WHERE solid IS NOT NULL', 'SELECT patch FROM scan', ab_evidence_model('LOA30', spacing => 0.02), keep_evidence => false)"
}
what="$(ask "SELECT format('%s objects, %s samples (2 cm)', count(*), round(sum(ab_area(solid)) / 4e-4)) FROM building_object WHERE solid IS NOT NULL"), $(ask "SELECT format('%s beams of %s stations', sum(ab_count(patch)), count(DISTINCT station_id)) FROM scan")"
row "ab_verify_table, an office of four storeys: $what, two cores" "$(timed psql -Xq -v ON_ERROR_STOP=1 -c "$(storeys 1 2GB)") s"
row "the same, one core" "$(timed psql -Xq -v ON_ERROR_STOP=1 -c "$(storeys 0 2GB)") s"
row "the same with asbuilt.max_evidence_memory at a quarter (512 MB), two cores" "$(timed psql -Xq -v ON_ERROR_STOP=1 -c "$(storeys 1 512MB)") s"
# What a limit of memory changes in the verdicts: nothing, when objects know each other across batches.
digest() { # memory
  psql -XAtq -v ON_ERROR_STOP=1 -c "$(storeys 1 "$1")" -c "SELECT md5(string_agg(v::text, ' ' ORDER BY v.id)) FROM verdict v"
}
row "verdicts with 2 GB and with 512 MB" "$([ "$(digest 2GB)" = "$(digest 512MB)" ] && echo "the same to the byte" || echo "differ")"
export PGDATABASE=bench
