# Occupancy and change, beside OctoMap on the same returns (apt install liboctomap-dev g++).
# shellcheck shell=bash disable=SC2154
[ "$(ask "SELECT count(*) FROM scan WHERE epoch = 10")" -gt 0 ] || "$asbuilt" load $data/10m.e57 --epoch 10 2>/dev/null
[ "$(ask "SELECT count(*) FROM scan WHERE epoch = 1")" -gt 0 ] || "$asbuilt" load $data/1m.e57 --epoch 1 2>/dev/null
occupancy() { # epoch, voxel, workers, more of ab_grid
  echo "SET min_parallel_table_scan_size = 0; SET asbuilt.max_grid_memory = '8GB'; SET max_parallel_workers_per_gather = $3; SELECT length(_ab_occupancy_send(ab_occupancy_agg(patch, ab_grid($2${4:-})))) FROM scan WHERE epoch = $1"
}
per_second() { awk -v n="$1" -v s="$2" 'BEGIN { printf "%.2f s, %.2f M beams/s", s, n / s / 1e6 }'; }
for epoch in 1 10; do
  n=$(ask "SELECT sum(ab_count(patch)) FROM scan WHERE epoch = $epoch")
  for voxel in 0.02 0.01; do
    for workers in 0 2; do
      row "ab_occupancy_agg, $n beams at $voxel m, $((workers > 0 ? 2 : 1)) core(s)" "$(per_second "$n" "$(timed ask "$(occupancy $epoch $voxel $workers)")")"
    done
    ask "DROP TABLE IF EXISTS grown; CREATE TABLE grown AS SELECT ab_occupancy_agg(patch, ab_grid($voxel)) AS g FROM (SELECT patch FROM scan WHERE epoch = $epoch) s"
    row "stored, $n beams at $voxel m" "$(ask "SELECT pg_size_pretty(pg_column_size(g)::bigint) || ', ' || round(pg_column_size(g)::numeric / (occupied + ambiguous + empty), 3) || ' bytes a known voxel, ' || occupied + ambiguous || ' occupied, ' || round(100.0 * ambiguous / (occupied + ambiguous)) || ' % of them passed too, ' || empty || ' empty' FROM grown, LATERAL ab_summary(g, 1)")"
  done
  row "the same at 0.02 m, exact, one core" "$(per_second "$n" "$(timed ask "$(occupancy $epoch 0.02 0 ', exact => true')")")"
done
if [ -e /usr/include/octomap/octomap.h ] && command -v g++ >/dev/null; then
  g++ -O3 -o $data/octomap benches/octomap/insert.cpp -loctomap -loctomath
  for epoch in 1 10; do
    psql -XAtqc "COPY (SELECT s.station_id, b.origin[1], b.origin[2], b.origin[3], b.point[1], b.point[2], b.point[3] FROM scan s, LATERAL ab_beams(s.patch) b WHERE epoch = $epoch AND b.point IS NOT NULL ORDER BY s.station_id) TO STDOUT (DELIMITER ' ')" >$data/returns.txt
    row "OctoMap $(dpkg-query -W -f='${Version}' liboctomap-dev), lazy and discretised, the same returns at 0.02 m, one core" "$($data/octomap 0.02 <$data/returns.txt)"
    [ $epoch = 10 ] || row "the same at 0.01 m" "$($data/octomap 0.01 <$data/returns.txt)"
  done
  rm -f $data/returns.txt
else
  row "OctoMap" "not measured: liboctomap-dev or g++ is missing"
fi
ask "DROP TABLE IF EXISTS old_grid, new_grid; CREATE TABLE old_grid AS SELECT ab_occupancy_agg(patch, ab_grid(0.01)) AS g FROM scan WHERE epoch = 10; CREATE TABLE new_grid AS SELECT ab_occupancy_agg(patch, ab_grid(0.01)) AS g FROM scan WHERE epoch = 1"
row "ab_change of the two at 0.01 m, read and written" "$(timed ask "SELECT length(_ab_change_send(ab_change(o.g, n.g, 1))) FROM old_grid o, new_grid n") s"
ask "DROP TABLE IF EXISTS changed; CREATE TABLE changed AS SELECT ab_change(o.g, n.g, 1) AS c FROM old_grid o, new_grid n"
row "ab_summary of that, and by object ($(ask "SELECT count(*) FROM building_object") objects)" "$(timed ask "SELECT s FROM changed, LATERAL ab_summary(c) s") s, $(timed ask "SELECT sum(s.total) FROM changed JOIN building_object o ON c && o.solid, LATERAL ab_summary(c, o.solid) s") s"
row "ab_components of that" "$(timed ask "SELECT count(*) FROM changed, LATERAL ab_components(c)") s"
row "ab_voxelize of $(ask "SELECT count(*) FROM building_object") objects at 0.01 m, centre / cover" "$(timed ask "SELECT count(ab_voxelize(solid, 0.01)) FROM building_object") s / $(timed ask "SELECT count(ab_voxelize(solid, 0.01, 'cover')) FROM building_object") s"
late_after() { # what, query: the worst of timeouts spread over its run
  row "timeout during $1, worst of 15 times" "+$(worst "$2") ms"
}
late_after "ab_occupancy_agg over 10 M beams at 0.01 m" "SET max_parallel_workers_per_gather = 0; $(occupancy 10 0.01 0)"
late_after "ab_change of two epochs at 0.01 m" "SELECT length(_ab_change_send(ab_change(o.g, n.g, 1))) FROM old_grid o, new_grid n"
late_after "ab_voxelize of a cube of 12 m at 0.01 m" "SET asbuilt.max_grid_memory = '8GB'; SELECT length(_ab_occupancy_send(ab_voxelize(ab_solid(ab_box(0.003, 0.003, 0.003, 12, 12, 12)), 0.01, 'cover')))"
late_after "ab_components" "SELECT count(*) FROM changed, LATERAL ab_components(c, 'confirmed', 1, 0.08)"
ask "DROP TABLE grown, old_grid, new_grid, changed"
