#!/usr/bin/env bash
# Every test: units of the core (with overflow checks), of the program, then SQL and end-to-end tests on a private cluster.
set -euo pipefail
cd "$(dirname "$0")/.."
echo "test: core"
cargo test --quiet -p asbuilt-core
echo "test: simulator and truth (short form)"
cargo test --quiet --release -p asbuilt-simulate -p asbuilt-fieldscan -p asbuilt-validation
cargo run --quiet --release -p asbuilt-validation -- --short
echo "test: program"
cargo test --quiet --release -p asbuilt-read -p asbuilt-cli
scripts/install.sh
scripts/installcheck.sh
echo "test: attack (short form)"
cargo test --quiet -p asbuilt-fuzz-targets
scripts/attack.sh --short
