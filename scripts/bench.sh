#!/usr/bin/env bash
# Measure size and speed on simulated scans (and on ../shared/data/hall where it is there). Prints a table in Markdown
# for docs/BENCHMARK.md, the parts in scripts/bench (or those of PARTS). Medians of three runs on a private cluster; nothing else should run on the machine.
set -euo pipefail
shopt -s inherit_errexit
cd "$(dirname "$0")/.."
scripts/install.sh >/dev/null
asbuilt=$PWD/target/release/asbuilt
cluster=$(mktemp -d "${TMPDIR:-/tmp}/asbuilt-bench-XXXXXX")
trap 'scripts/cluster.sh drop "$cluster"' EXIT
rmdir "$cluster"
eval "$(scripts/cluster.sh start "$cluster")"
createdb bench
export PGDATABASE=bench
data=target/bench
mkdir -p $data

now() { date +%s.%N; }
# Median of three timings of a command, seconds; a command that fails ends the bench with what it said.
timed() {
  for _ in 1 2 3; do
    local start
    start=$(now)
    "$@" >/dev/null 2>"$data/said" || {
      echo "bench: $* failed: $(cat "$data/said")" >&2
      return 1
    }
    echo "$(now) $start" | awk '{printf "%.2f\n", $1 - $2}'
  done | sort -n | sed -n 2p
}
ask() { psql -XAtq -v ON_ERROR_STOP=1 -c "$1"; }
# How long after a timeout the query is over, psql's start and connection included: the worst of three.
late() { # query, timeout in ms
  for _ in 1 2 3; do
    local start
    start=$(now)
    psql -Xq -c "SET statement_timeout = $2; $1" >/dev/null 2>&1 || true
    echo "$(now) $start $2" | awk '{printf "%.0f\n", ($1 - $2) * 1000 - $3}'
  done | sort -n | tail -1
}
# The same for the latest of timeouts spread over its run.
worst() { # query: the latest of timeouts spread over its run
  local start total
  start=$(now)
  psql -Xq -c "$1" >/dev/null
  total=$(echo "$(now) $start" | awk '{printf "%d", ($1 - $2) * 1000}')
  for k in $(seq 1 15); do
    late "$1" $((total * k / 16 + 1))
  done | sort -n | tail -1
}
row() { echo "| $1 | $2 |"; }

[ -e $data/10m.e57 ] || "$asbuilt" simulate demo/pavilion.ifc --stations demo/stations.txt --built demo/changes.json --step-mrad 2.55 --out $data/10m.e57
[ -e $data/1m.e57 ] || "$asbuilt" simulate demo/pavilion.ifc --stations demo/stations.txt --built demo/changes.json --step-mrad 8 --out $data/1m.e57

echo "machine: $(nproc) cores, $(awk -F: '/model name/{print $2; exit}' /proc/cpuinfo | xargs), $("${PG_CONFIG:-/usr/lib/postgresql/15/bin/pg_config}" --version), $(rustc --version)"
echo
echo "| what | measured |"
echo "| --- | --- |"
"$asbuilt" load demo/pavilion.ifc 2>/dev/null
for part in ${PARTS:-scripts/bench/*.sh}; do
  # shellcheck source=/dev/null
  . "$part"
done
