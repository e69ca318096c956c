#!/usr/bin/env bash
# Attacks the installed extension and the built program on private servers; prints what was tried and found.
#
#   scripts/attack.sh --short          the part of make test: fixed rounds, fixed seed
#   MINUTES=n SEED=n scripts/attack.sh the long form
#   … --only=types,functions           pieces: types functions aggregates parallel indexes replication memory hijack files fuzz
set -euo pipefail
cd "$(dirname "$0")/.."
PG_CONFIG=${PG_CONFIG:-/usr/lib/postgresql/15/bin/pg_config}
export PG_CONFIG
PG_BINDIR=${PG_BINDIR:-$("$PG_CONFIG" --bindir)}
ASBUILT=${ASBUILT:-$PWD/target/release/asbuilt}
export PG_BINDIR ASBUILT
exec cargo run --quiet --release -p asbuilt-attack -- "$@"
