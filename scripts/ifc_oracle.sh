#!/usr/bin/env bash
# Compares the loader's solids with IfcOpenShell's (PyPI), in an environment of its own. Skipped, loudly, where PyPI
# cannot be reached.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=target/venv
if ! { [ -x $venv/bin/python ] && $venv/bin/python -c 'import ifcopenshell, numpy' 2>/dev/null; }; then
  python3 -m venv $venv
  if ! $venv/bin/pip install --quiet --disable-pip-version-check 'ifcopenshell==0.9.0.post1' numpy; then
    echo "SKIPPED: IfcOpenShell cannot be installed from PyPI" >&2
    exit 0
  fi
fi
models=(demo/pavilion.ifc demo/models/*.ifc)
for folder in hall real-room ifc-duplex ifc-fzk-haus ifc-bimwhale ifc-tiny schependomlaan; do
  for file in ../shared/data/$folder/*.ifc; do
    if [ -e "$file" ]; then models+=("$file"); else echo "SKIPPED: $file is not there" >&2; fi
  done
done
dropdb --if-exists asbuilt_oracle 2>/dev/null
createdb asbuilt_oracle
PGDATABASE=asbuilt_oracle $venv/bin/python tests/oracle/ifc_oracle.py target/release/asbuilt "${models[@]}"
dropdb asbuilt_oracle
