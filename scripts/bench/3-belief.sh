# Belief and uncertain geometry, one core, tables in memory.
# shellcheck shell=bash disable=SC2154
ask "CREATE UNLOGGED TABLE mass AS SELECT ab_mass(0.3 * random(), 0.3 * random()) AS m FROM generate_series(1, 10000000)"
ask "CREATE UNLOGGED TABLE point AS SELECT ab_point(random() * 10, random() * 10, random() * 0.01, 0.003) AS p FROM generate_series(1, 2000000)"
ask "VACUUM ANALYZE mass"
ask "VACUUM ANALYZE point"
rate() { # rows, query
  timed psql -Xq -c "SET max_parallel_workers_per_gather = 0; $2" | awk -v n="$1" '{printf "%.2f s, %.1f M/s", $1, n / $1 / 1e6}'
}
row "ab_combine_agg over 10 M masses" "$(rate 10000000 "SELECT ab_combine_agg(m) FROM mass")"
row "ab_is_incident of 2 M points and a plane" "$(rate 2000000 "SELECT count(*) FROM point WHERE ab_is_incident(p, ab_plane(ARRAY[5, 5, 0], ARRAY[0, 0, 1], 0.002, 0.0001))")"
row "ab_test_incident of the same" "$(rate 2000000 "SELECT count(*) FROM point, ab_test_incident(p, ab_plane(ARRAY[5, 5, 0], ARRAY[0, 0, 1], 0.002, 0.0001)) t WHERE t.p_value > 0.05")"
