# The index at project size: a million patches, twenty thousand objects.
# shellcheck shell=bash disable=SC2154
ask "SELECT setseed(0.5); CREATE UNLOGGED TABLE project_patch (id int, patch ab_scan); INSERT INTO project_patch
  SELECT i, ab_scan(ARRAY[x, y, z], ARRAY[[x + dx, y + dy, z + dz], [x + dx, y + dy + 0.3, z + dz + 0.3]], 0.01)
  FROM (SELECT i, 500 * random() x, 500 * random() y, 30 * random() z, 3 * random() + 0.5 AS dx, 2 * random() - 1 AS dy, random() dz FROM generate_series(1, 1000000) i) q" >/dev/null
ask "CREATE UNLOGGED TABLE project_object AS SELECT i AS id, ab_solid(ab_box(x, y, z, x + 3 * random(), y + 0.3, z + 2.5)) AS solid
  FROM (SELECT i, 500 * random() x, 500 * random() y, 30 * random() z FROM generate_series(1, 20000) i) q"
row "GiST index on 1 M patches, sorted along a Hilbert curve" "$(timed ask "DROP INDEX IF EXISTS project_patch_gist; CREATE INDEX project_patch_gist ON project_patch USING gist (patch)") s, $(ask "SELECT pg_size_pretty(pg_relation_size('project_patch_gist'))")"
row "ANALYZE of 1 M patches" "$(timed ask "ANALYZE project_patch") s"
ask "VACUUM ANALYZE project_patch"
ask "ANALYZE project_object"
join="SELECT o.id, count(*) FROM project_object o JOIN project_patch p ON p.patch && o.solid GROUP BY o.id"
measured() { # query: its time, and the buffers hit and read
  psql -XAtqc "EXPLAIN (ANALYZE, BUFFERS, TIMING OFF) $1" | awk '
    /Buffers: shared/ && !found { found = 1; for (i = 1; i <= NF; i++) if ($i ~ /(hit|read)=/) { split($i, part, "="); buffers += part[2] } }
    /Execution Time/ { print $3 " ms, " buffers " buffers" }'
}
psql -Xqc "$join" >/dev/null
row "1 M patches x 20 000 objects by &&: $(ask "SELECT sum(n) FROM (SELECT count(*) AS n FROM project_object o JOIN project_patch p ON p.patch && o.solid) x") pairs, plan of PostgreSQL's own choice" "$(measured "$join")"
row "the same on one core" "$(psql -XAtqc "SET max_parallel_workers_per_gather = 0" -c "EXPLAIN (ANALYZE, TIMING OFF) $join" | awk '/Execution Time/ {print $3 " ms"}')"
row "10 nearest of 1 M patches to a point, and to 1000 points one after the other" "$(measured "SELECT id FROM project_patch ORDER BY patch <-> ab_point(250, 250, 15) LIMIT 10"); $(measured "SELECT count(k.id) FROM generate_series(1, 1000) i, LATERAL (SELECT id FROM project_patch ORDER BY patch <-> ab_point(0.5 * i, 250, 15) LIMIT 10) k")"
ask "DROP TABLE project_patch, project_object"
