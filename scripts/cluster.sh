#!/usr/bin/env bash
# A private PostgreSQL cluster: never the machine's own one, no TCP port, gone without a trace when stopped.
#
#   scripts/cluster.sh start DIR    make it if need be, start it, print the environment that reaches it
#   scripts/cluster.sh stop DIR     stop it (data stays for the next start)
#   scripts/cluster.sh drop DIR     stop it and remove it
set -euo pipefail

PG_VERSION=${PG_VERSION:-15}
bin=${PG_CONFIG:+$("$PG_CONFIG" --bindir)}
bin=${bin:-/usr/lib/postgresql/$PG_VERSION/bin}
command=${1:?start, stop or drop}
dir=${2:?directory of the cluster}

# PostgreSQL refuses to run as root; then user postgres runs it.
as_server() {
  if [ "$(id -u)" -eq 0 ]; then runuser -u postgres -- "$@"; else "$@"; fi
}

running() { as_server "$bin/pg_ctl" -D "$dir/data" status >/dev/null 2>&1; }

case $command in
start)
  if [ ! -e "$dir/data/PG_VERSION" ]; then
    rm -rf "$dir"
    mkdir -p -m 700 "$dir"
    [ "$(id -u)" -ne 0 ] || chown postgres: "$dir"
    as_server "$bin/initdb" -D "$dir/data" -U postgres -A trust -E UTF8 --locale=C.UTF-8 --no-sync >/dev/null
    # Small machine, throw-away data: no fsync; room for two parallel workers and for wide rows while they load.
    as_server tee -a "$dir/data/postgresql.conf" >/dev/null <<CONF
listen_addresses = ''
unix_socket_directories = '$dir'
fsync = off
synchronous_commit = off
full_page_writes = off
wal_level = minimal
max_wal_senders = 0
max_wal_size = 4GB
shared_buffers = 512MB
work_mem = 64MB
maintenance_work_mem = 256MB
max_parallel_workers_per_gather = 2
jit = off
CONF
  fi
  # As whoever debugs a server has it: no backtrace may reach a client all the same.
  running || as_server env RUST_BACKTRACE=1 "$bin/pg_ctl" -D "$dir/data" -l "$dir/server.log" -w -s start
  echo "export PGHOST=$dir PGUSER=postgres PGDATABASE=postgres; unset PGPORT PGPASSWORD PGSERVICE"
  ;;
stop) ! running || as_server "$bin/pg_ctl" -D "$dir/data" -m fast -w -s stop ;;
drop)
  ! running || as_server "$bin/pg_ctl" -D "$dir/data" -m immediate -w -s stop
  rm -rf "$dir"
  ;;
*)
  echo "cluster.sh: unknown command '$command'" >&2
  exit 2
  ;;
esac
