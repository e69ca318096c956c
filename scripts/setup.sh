#!/usr/bin/env bash
# Install what a bare Debian 12 machine lacks to build and test asbuilt: Debian packages, cargo-pgrx,
# and pgrx's knowledge of PostgreSQL. Every step looks first and does nothing when it is already done.
#
#   setup.sh [test]   with `test`, also PostGIS and pgPointcloud, which the bridges and benches are tested with
#   PG_VERSION        PostgreSQL major version, default 15 (Debian 12's own)
set -euo pipefail

PGRX_VERSION=0.18.1
PG_VERSION=${PG_VERSION:-15}
PG_CONFIG=${PG_CONFIG:-/usr/lib/postgresql/$PG_VERSION/bin/pg_config}
# A PostgreSQL that is there says its version itself.
[ ! -x "$PG_CONFIG" ] || PG_VERSION=$("$PG_CONFIG" --version | sed -E 's/^PostgreSQL ([0-9]+).*/\1/')

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; elif command -v sudo >/dev/null; then sudo "$@"; else
    echo "setup: '$*' needs root; install sudo or run 'make' as root" >&2
    exit 1
  fi
}

packages=(build-essential pkg-config clang libclang-dev libssl-dev bison flex perl python3 python3-venv)
# One's own build of PostgreSQL brings its headers; Debian's does when asked.
if [ ! -e "$("$PG_CONFIG" --includedir-server 2>/dev/null)/postgres.h" ]; then
  packages+=("postgresql-$PG_VERSION" "postgresql-server-dev-$PG_VERSION" postgresql-common)
fi
# Into one's own build of PostgreSQL one installs them oneself; without them the bridges' tests are skipped, loudly.
if [ "${1:-}" = test ] && [[ $PG_CONFIG == /usr/lib/postgresql/* ]]; then
  packages+=("postgresql-$PG_VERSION-postgis-3" "postgresql-$PG_VERSION-pointcloud")
fi
missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  echo "setup: installing Debian packages: ${missing[*]}"
  as_root apt-get update -q
  # No cluster of the machine's own is made or started on our account: ours is private (scripts/cluster.sh).
  as_root mkdir -p /etc/postgresql-common
  [ -e /etc/postgresql-common/createcluster.conf ] ||
    echo "create_main_cluster = false" | as_root tee /etc/postgresql-common/createcluster.conf >/dev/null
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
fi

command -v cargo >/dev/null || {
  echo "setup: no cargo on PATH; install the Rust toolchain first, see https://rustup.rs" >&2
  exit 1
}

if [ "$(cargo pgrx --version 2>/dev/null | awk '{print $NF}')" != "$PGRX_VERSION" ]; then
  echo "setup: installing cargo-pgrx $PGRX_VERSION (about 6 minutes on two cores, once)"
  cargo install cargo-pgrx --version "$PGRX_VERSION" --locked --quiet
fi

pgrx_config=${PGRX_HOME:-$HOME/.pgrx}/config.toml
if ! grep -qs "^pg$PG_VERSION *= *\"$PG_CONFIG\"" "$pgrx_config"; then
  echo "setup: telling pgrx of PostgreSQL $PG_VERSION ($PG_CONFIG)"
  cargo pgrx init "--pg$PG_VERSION" "$PG_CONFIG"
fi
