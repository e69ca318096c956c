#!/usr/bin/env bash
# SQL tests (pg_regress) and client tests against the installed extension, on a private cluster of their own.
set -euo pipefail
cd "$(dirname "$0")/.."
PG_CONFIG=${PG_CONFIG:-/usr/lib/postgresql/15/bin/pg_config}
cluster=$(mktemp -d "${TMPDIR:-/tmp}/asbuilt-test-XXXXXX")
trap 'scripts/cluster.sh drop "$cluster"' EXIT
rmdir "$cluster"
eval "$(scripts/cluster.sh start "$cluster")"

echo "test: SQL"
results=target/pg_regress
mkdir -p $results
regress=$(dirname "$("$PG_CONFIG" --pgxs)")/../../src/test/regress/pg_regress
tests=$(cd tests/pg_regress/sql && ls ./*.sql | sed 's|./||; s|\.sql$||' | sort)
# shellcheck disable=SC2086  # a list of tests
"$regress" --host="$PGHOST" --user=postgres --dbname=asbuilt_regress --inputdir=tests/pg_regress --outputdir=$results \
  --bindir="$("$PG_CONFIG" --bindir)" --load-extension=asbuilt $tests || {
  cat $results/regression.diffs >&2
  exit 1
}

echo "test: documents"
scripts/api_docs.sh --check

echo "test: IFC geometry against IfcOpenShell"
scripts/ifc_oracle.sh

[ -d ../shared/data ] || echo "SKIPPED: ../shared/data is not there; the hall, the real room and the files of others are not tested"
for other in postgis pointcloud; do
  [ -e "$("$PG_CONFIG" --sharedir)/extension/$other.control" ] || echo "SKIPPED: $other is not installed in this PostgreSQL; its bridge is not tested"
done
echo "test: clients"
ASBUILT=$PWD/target/release/asbuilt PG_BINDIR=$("$PG_CONFIG" --bindir) cargo test --release -p asbuilt-client-tests -- --test-threads=2
