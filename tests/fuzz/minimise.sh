#!/usr/bin/env bash
# Merges what the long form found (target/attack/fuzz) into the kept corpus, no more than covers what it covers.
# Afterwards: du -sh tests/fuzz/corpus; at most 5 MB stay in the repository.
set -euo pipefail
cd "$(dirname "$0")/../.."
fuzz=target/fuzz/x86_64-unknown-linux-gnu/release/fuzz
for found in target/attack/fuzz/*/; do
  target=$(basename "$found")
  merged=$(mktemp -d)
  ASBUILT_FUZZ_TARGET=$target "$fuzz" -merge=1 -timeout=5 -max_len=2048 "$merged" "tests/fuzz/corpus/$target" "$found" 2>/dev/null || true
  # What an issue reported stays, whether it covers more or not.
  cp "tests/fuzz/corpus/$target"/issue* "$merged/" 2>/dev/null || true
  rm -rf "tests/fuzz/corpus/$target"
  mkdir -p "tests/fuzz/corpus/$target"
  cp "$merged"/* "tests/fuzz/corpus/$target/" 2>/dev/null || true
  rm -rf "$merged"
  echo "$target: $(find "tests/fuzz/corpus/$target" -type f | wc -l) inputs"
done
du -sh tests/fuzz/corpus
