#!/usr/bin/env bash
# Reads every file of a folder with asbuilt and with readers that share no code with it, and prints the differences.
#
#   scripts/corpus.sh DIR      E57 by pye57, LAS and LAZ by laspy, IFC by IfcOpenShell, all from PyPI, in an environment of its own
set -euo pipefail
folder=${1:?"the folder whose files to read: make corpus DIR=…"}
[ -d "$folder" ] || { echo "corpus: $folder is no folder" >&2; exit 1; }
folder=$(cd "$folder" && pwd)
cd "$(dirname "$0")/.."
ASBUILT=${ASBUILT:-$PWD/target/release/asbuilt}
venv=target/venv-corpus
[ -x $venv/bin/python ] || python3 -m venv $venv
for package in numpy pye57 laspy lazrs ifcopenshell==0.9.0.post1; do
  $venv/bin/pip install --quiet --disable-pip-version-check $package || echo "SKIPPED: $package cannot be installed from PyPI" >&2
done
$venv/bin/python -c 'import numpy' 2>/dev/null || { echo "SKIPPED: without numpy nothing is compared" >&2; exit 0; }
exec $venv/bin/python tests/oracle/corpus.py "$ASBUILT" "$folder"
