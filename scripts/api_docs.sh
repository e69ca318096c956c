#!/usr/bin/env bash
# Writes docs/api.md from the COMMENTs of the installed extension and from docs/examples, every one of which it runs.
# In which release a function came, the SQL of the earlier releases tells (sql/asbuilt--VERSION.sql): each is installed.
# With --check it only says whether docs/api.md is what would be written.
set -euo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C
work=$(mktemp -d "${TMPDIR:-/tmp}/asbuilt-docs-XXXXXX")
own=
trap '[ -z "$own" ] || scripts/cluster.sh drop "$work/cluster"; rm -rf "$work"' EXIT
if [ -z "${PGHOST:-}" ]; then
  scripts/install.sh >/dev/null
  chmod 711 "$work"
  own=yes
  eval "$(scripts/cluster.sh start "$work/cluster")"
fi
export PGDATABASE=asbuilt_docs PGCLIENTENCODING=UTF8 PGTZ=UTC PGDATESTYLE=ISO
# Six digits of a float8: the same on every machine, and short.
export PGOPTIONS="-c extra_float_digits=-9"
dropdb --if-exists asbuilt_docs 2>/dev/null
createdb -T template0 -E UTF8 --locale=C asbuilt_docs
for script in sql/asbuilt--*.sql; do
  release=$(basename "$script" .sql)
  release=${release#asbuilt--}
  [ "${release#*--}" = "$release" ] || continue # from one release to the next
  psql -Xq -v ON_ERROR_STOP=1 -c "CREATE EXTENSION asbuilt VERSION '$release'"
  psql -XAtq -v ON_ERROR_STOP=1 -v "release=$release" -f scripts/api_docs_release.sql
  psql -Xq -v ON_ERROR_STOP=1 -c "DROP EXTENSION asbuilt"
done >"$work/releases.sql"
psql -Xq -v ON_ERROR_STOP=1 -c "CREATE EXTENSION asbuilt"

# Every file in a session of its own. Heads become marks in the output, line by line, so that errors name the line.
for file in docs/examples/*.sql; do
  topic=$(basename "$file" .sql)
  sed -E 's/^-- (ab_[a-z0-9_]+(\([^)]*\))?( and ab_[a-z0-9_]+(\([^)]*\))?)*)$/\\qecho @@ \1/' "$file" |
    psql -Xq -v ON_ERROR_STOP=1 -P pager=off -P border=1 -P linestyle=ascii -P footer=off -P null=NULL -f - \
      >"$work/$topic.out" 2>"$work/errors" && [ ! -s "$work/errors" ] || {
    sed "s|^psql:<stdin>|$file|" "$work/errors" >&2
    echo "docs: an example of $file failed" >&2
    exit 1
  }
  # shellcheck disable=SC2016  # psql's backquotes
  printf '\\set source `cat %s`\n\\set result `cat %s`\n' "'$file'" "'$work/$topic.out'"
  echo "INSERT INTO file VALUES ('$topic', :'source', :'result');"
done >"$work/files.sql"
{
  echo "CREATE TEMP TABLE file (topic text, source text, result text);"
  echo "CREATE TEMP TABLE released (release text, kind text, name text, arguments text);"
  cat "$work/releases.sql" "$work/files.sql" scripts/api_docs.sql
} | psql -XAtq -v ON_ERROR_STOP=1 -P pager=off -f - >"$work/api.md"
dropdb asbuilt_docs

if [ "${1:-}" = --check ]; then
  diff docs/api.md "$work/api.md" || {
    echo "docs/api.md is out of date: make docs" >&2
    exit 1
  }
else
  cat "$work/api.md" >docs/api.md
  echo "docs: docs/api.md written"
fi
