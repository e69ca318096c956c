#!/usr/bin/env bash
# Writes docs/api.md from the COMMENTs of the installed extension; with --check only says whether it is up to date.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ -z "${PGHOST:-}" ]; then
  cluster=$(mktemp -d "${TMPDIR:-/tmp}/asbuilt-docs-XXXXXX")
  trap 'scripts/cluster.sh drop "$cluster"' EXIT
  rmdir "$cluster"
  scripts/install.sh >/dev/null
  eval "$(scripts/cluster.sh start "$cluster")"
fi
database=asbuilt_docs
dropdb --if-exists $database 2>/dev/null
createdb $database
made=$(psql -XAtq -d $database -c "CREATE EXTENSION asbuilt" -f scripts/api_docs.sql)
dropdb $database
if [ "${1:-}" = --check ]; then
  diff <(echo "$made") docs/api.md || {
    echo "docs/api.md is out of date: make docs" >&2
    exit 1
  }
else
  echo "$made" >docs/api.md
  echo "docs: docs/api.md written"
fi
