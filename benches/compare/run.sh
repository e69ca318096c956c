#!/usr/bin/env bash
# What a user would run today on the same data: cloud-to-mesh distances (CloudCompare, apt) and M3C2 (py4dgeo, PyPI).
# In a database that asbuilt loaded (PG* variables): epoch, and a folder for the files.
#   PGDATABASE=office PYTHON=venv/bin/python benches/compare/run.sh 4 /tmp/compare
set -euo pipefail
epoch=$1 out=$2
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$out"
copy() { psql -XAtq -F ' ' -c "$1"; }
# Files that are there are taken as they are.
[ -e "$out/scan.xyz" ] || copy "SELECT round(point[1]::numeric, 4), round(point[2]::numeric, 4), round(point[3]::numeric, 4)
      FROM scan, LATERAL ab_beams(patch) WHERE epoch = $epoch AND point IS NOT NULL" >"$out/scan.xyz"
[ -e "$out/model.xyz" ] || copy "SELECT round(s.position[1]::numeric, 4), round(s.position[2]::numeric, 4), round(s.position[3]::numeric, 4)
      FROM (SELECT ab_evidence_agg(solid, NULL, ab_evidence_model(spacing => 0.02)) AS evidence FROM building_object GROUP BY id) e,
           LATERAL ab_samples(e.evidence) s" >"$out/model.xyz"
[ -e "$out/model.obj" ] || copy "COPY (SELECT ab_vertices(solid)::text || ';' || ab_triangles(solid)::text FROM building_object) TO STDOUT" | python3 -c "
import sys
offset = 1
for line in sys.stdin:
    vertices, triangles = (eval(part.replace('{', '[').replace('}', ']')) for part in line.split(';'))
    for v in vertices: print('v', *v)
    for t in triangles: print('f', *(i + offset for i in t))
    offset += len(vertices)" >"$out/model.obj"
echo "$(wc -l <"$out/scan.xyz") points, $(grep -c ^f "$out/model.obj") triangles"
start=$(date +%s.%N)
xvfb-run -a CloudCompare -SILENT -AUTO_SAVE OFF -C_EXPORT_FMT BIN -O "$out/scan.xyz" -O "$out/model.obj" -C2M_DIST -MAX_DIST 0.15 2>&1 |
  grep -i "ellapsed\|elapsed\|time\|distance" || true
echo "CloudCompare, reading included: $(echo "$(date +%s.%N) $start" | awk '{printf "%.1f s", $1 - $2}')"
"${PYTHON:-python3}" "$here/m3c2.py" "$out/scan.xyz" "$out/model.xyz" 20000
