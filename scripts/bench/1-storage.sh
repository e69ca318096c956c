# Ten million beams: size and load, beside pgPointcloud and LAZ on the same scan.
# shellcheck shell=bash disable=SC2154
load=$(timed "$asbuilt" load $data/10m.e57 --epoch 10)
beams=$(ask "SELECT sum(ab_count(patch)) FROM scan WHERE epoch = 10")
row "load $beams beams from E57 ($(stat -c %s $data/10m.e57 | awk '{printf "%.0f MB", $1 / 1e6}')), whole program" "$load s, $(echo "$beams $load" | awk '{printf "%.2f M beams/s", $1 / $2 / 1e6}')"
ask "VACUUM FULL scan"
row "scan table with TOAST and index" "$(ask "SELECT round(pg_total_relation_size('scan')::numeric / sum(ab_count(patch)), 2) || ' bytes a beam; ' || count(*) || ' patches, index ' || pg_size_pretty(pg_relation_size('scan_patch_idx')) FROM scan")"
ask "CREATE TABLE ready (LIKE scan); CREATE INDEX ready_gist ON ready USING gist (patch)"
psql -XAtqc "COPY (SELECT * FROM scan WHERE epoch = 10) TO STDOUT (FORMAT binary)" >$data/ready.copy
copy_ready() { ask "TRUNCATE ready; COPY ready FROM STDIN (FORMAT binary)" <$data/ready.copy; }
row "COPY of the ready patches with their index, every one checked" "$(timed copy_ready | awk -v n="$beams" '{printf "%.2f s, %.2f M beams/s", $1, n / $1 / 1e6}')"
rm $data/ready.copy
ask "DROP TABLE ready"

# What comes out of a query for points in a thin box, and what is unpacked for it: the floor, 4 cm thick.
floor="ab_box(-1, -1, -0.02, 40, 40, 0.02)"
row "points on the floor (4 cm): returned, in patches unpacked for it, in patches whose header is read" "$(ask "SELECT format('%s; %s (%s times); %s', r, u, round(u / r, 2), h) FROM (
  SELECT sum(ab_count(ab_filter(patch, b)))::numeric AS r, sum(ab_count(patch)) FILTER (WHERE ab_point_box(patch) && b) AS u, sum(ab_count(patch)) AS h
  FROM scan, $floor b WHERE epoch = 10 AND patch && b) x")"

# pgPointcloud with the same points in the same patches at the same 0.1 mm, dimensional compression (Debian builds it
# without LAZ), its envelope index as its manual says.
if [ "$(ask "SELECT count(*) FROM pg_available_extensions WHERE name IN ('pointcloud', 'pointcloud_postgis')")" -lt 2 ]; then
  row "SKIPPED: pgPointcloud is not installed" ""
  return 0
fi
ask "SET client_min_messages = error; CREATE EXTENSION asbuilt_pointcloud CASCADE; CREATE EXTENSION pointcloud_postgis CASCADE"
dimension() { echo "<pc:dimension><pc:position>$1</pc:position><pc:size>4</pc:size><pc:name>$2</pc:name><pc:interpretation>int32_t</pc:interpretation><pc:scale>0.0001</pc:scale></pc:dimension>"; }
ask "INSERT INTO pointcloud_formats VALUES (1, 0, '<?xml version=\"1.0\" encoding=\"UTF-8\"?><pc:PointCloudSchema xmlns:pc=\"http://pointcloud.org/schemas/PC/1.1\">$(dimension 1 X)$(dimension 2 Y)$(dimension 3 Z)<pc:metadata><Metadata name=\"compression\">dimensional</Metadata></pc:metadata></pc:PointCloudSchema>')"
row "the same scan to pgPointcloud patches by ab_pcpatch" "$(timed ask "DROP TABLE IF EXISTS pc; CREATE TABLE pc AS SELECT ab_pcpatch(patch, 1)::pcpatch(1) AS pa FROM scan WHERE epoch = 10") s"
points=$(ask "SELECT sum(PC_NumPoints(pa)) FROM pc")
ask "COPY pc TO STDOUT" >$data/pc.copy
ask "TRUNCATE pc; CREATE INDEX pc_envelope ON pc USING gist (PC_EnvelopeGeometry(pa))"
copy_pc() { ask "TRUNCATE pc; COPY pc FROM STDIN" <$data/pc.copy; }
load=$(timed copy_pc)
row "pgPointcloud: COPY of the $points ready points with their index" "$load s, $(echo "$points $load" | awk '{printf "%.2f M points/s", $1 / $2 / 1e6}')"
ask "VACUUM FULL pc"
row "pgPointcloud: table with TOAST and index, dimensional" "$(ask "SELECT round(pg_total_relation_size('pc')::numeric / $points, 2) || ' bytes a point'")"
row "pgPointcloud: points on the floor (4 cm) by its envelope index: candidates" "$(ask "SELECT sum(PC_NumPoints(pa)) FROM pc WHERE PC_EnvelopeGeometry(pa) && ST_MakeEnvelope(-1, -1, 40, 40)")"
rm $data/pc.copy
ask "DROP TABLE pc"
cargo run --release --quiet -p asbuilt-cli --example e57_to_laz -- $data/10m.e57 $data/10m.laz
row "LAZ of the same scan at 0.1 mm, a file without origins and beams without return" "$(echo "$(stat -c %s $data/10m.laz) $points" | awk '{printf "%.2f bytes a point", $1 / $2}')"
