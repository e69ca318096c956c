#!/usr/bin/env bash
# Load a building and its scans into a private cluster and print the verdicts.
#   scripts/demo.sh [MODEL.ifc] [SCANS…] [LOA]     without a model: the demo building, its scans simulated
set -euo pipefail
cd "$(dirname "$0")/.."
model=${1:-} scans=${2:-} loa=${3:-}

scripts/install.sh
asbuilt=$PWD/target/release/asbuilt
cluster=${TMPDIR:-/tmp}/asbuilt-demo-$(id -u)
eval "$(scripts/cluster.sh start "$cluster")"
dropdb --if-exists --force asbuilt_demo 2>/dev/null || true
createdb asbuilt_demo
export PGDATABASE=asbuilt_demo

if [ -z "$model" ]; then
  model=demo/pavilion.ifc
  scans=target/demo-scan.e57
  echo "demo: simulating a laser scan of demo/pavilion.ifc, built as demo/changes.json says"
  "$asbuilt" simulate $model --stations demo/stations.txt --built demo/changes.json --step-mrad 4 --seed 1 --out $scans
elif [ -z "$scans" ]; then
  echo "demo: MODEL is given, but no SCANS; try: make demo MODEL=$model SCANS=\"a.e57 b.e57\"" >&2
  exit 2
fi

echo "demo: loading"
# shellcheck disable=SC2086  # SCANS is a list
"$asbuilt" load "$model" $scans
echo "demo: verifying"
"$asbuilt" verify ${loa:+--loa "$loa"}
cat <<END

The cluster is still running. To ask it yourself:
  export PGHOST=$cluster PGUSER=postgres PGDATABASE=asbuilt_demo
  psql -c "SELECT name, storey, ab_volume(solid) FROM building_object"
Stop and remove it: make demo-stop
END
