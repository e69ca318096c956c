#!/usr/bin/env bash
# Build the extension and the program `asbuilt`, install the extension into the PostgreSQL of PG_CONFIG.
set -euo pipefail
cd "$(dirname "$0")/.."
PG_CONFIG=${PG_CONFIG:-/usr/lib/postgresql/15/bin/pg_config}
version=$("$PG_CONFIG" --version | sed -E 's/^PostgreSQL ([0-9]+).*/\1/')

sudo=
[ -w "$("$PG_CONFIG" --pkglibdir)" ] || sudo=--sudo
log=target/install.log
mkdir -p target
echo "install: building the extension for PostgreSQL $version"
if ! cargo pgrx install --release $sudo --pg-config "$PG_CONFIG" --no-default-features --features "pg$version" >$log 2>&1; then
  cat $log >&2
  exit 1
fi
# The bridges are SQL alone; so are the scripts of earlier releases, which cargo pgrx leaves behind.
extensions=$("$PG_CONFIG" --sharedir)/extension
current=$(sed -n '/^version/{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
earlier=$(find sql -maxdepth 1 -name 'asbuilt--*.sql' ! -name "asbuilt--$current.sql")
# shellcheck disable=SC2086  # a list of files
${sudo:+sudo} install -m 644 postgis/asbuilt_postgis* pointcloud/asbuilt_pointcloud* $earlier "$extensions"
echo "install: building the program asbuilt"
cargo build --release --quiet -p asbuilt-cli
echo "install: done; in psql: CREATE EXTENSION asbuilt; the program is target/release/asbuilt"
