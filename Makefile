# asbuilt. On a bare Debian 12 machine with a Rust toolchain, as root or with sudo:
#   make demo                                  install what is missing, build, load a demo building, verify it
#   make demo MODEL=x.ifc SCANS="a.e57 b.e57"  the same on your own files
#   make test                                  every test
#   make attack                                the long attack on what is installed: MINUTES=30 SEED=n
#   make corpus DIR=folder                    every file of a folder, read by asbuilt and by readers of others
#   make install PG_CONFIG=/path/to/pg_config  the extension into a local PostgreSQL, the program into BINDIR

PG_VERSION ?= 15
PG_CONFIG ?= /usr/lib/postgresql/$(PG_VERSION)/bin/pg_config
BINDIR ?= /usr/local/bin
export PG_VERSION PG_CONFIG

MODEL ?=
SCANS ?=
LOA ?=

.PHONY: demo demo-stop test corpus attack installcheck install bench truth lint docs setup setup-test clean

demo: setup
	@scripts/demo.sh "$(MODEL)" "$(SCANS)" "$(LOA)"

demo-stop:
	@scripts/cluster.sh drop $${TMPDIR:-/tmp}/asbuilt-demo-$$(id -u)

test: setup-test
	scripts/test.sh

# Tests against an installed extension and a built program alone.
installcheck:
	scripts/installcheck.sh

# Hostile values, files and users against the installed extension and the program: MINUTES=n SEED=n make attack
attack: setup
	scripts/install.sh
	scripts/attack.sh

corpus: setup
	cargo build --quiet --release -p asbuilt-cli
	scripts/corpus.sh "$(DIR)"

install: setup
	scripts/install.sh
	$$([ -w "$(BINDIR)" ] || echo sudo) install -m 755 target/release/asbuilt "$(BINDIR)/asbuilt"

bench: setup-test
	scripts/bench.sh

# Verdicts, beliefs and intervals against simulated buildings whose truth is known: writes docs/truth.md and its pictures;
# against real buildings under the second scanner, and a real scan: docs/truth-field.md, docs/truth-planted.md;
# in two epochs of real buildings: docs/truth-change.md.
truth: setup
	cargo run --release --quiet -p asbuilt-validation -- --report docs/truth.md
	cargo run --release --quiet -p asbuilt-validation -- --field --report docs/truth-field.md
	cargo run --release --quiet -p asbuilt-validation -- --planted --report docs/truth-planted.md
	cargo run --release --quiet -p asbuilt-validation -- --change --scene 4 --scene 8 --scene 21 --scene 23 --report docs/truth-change.md

lint:
	cargo fmt --all --check
	cargo clippy --workspace --exclude asbuilt --all-targets -- -D warnings
	cargo clippy -p asbuilt --no-default-features --features pg$(PG_VERSION) -- -D warnings

# docs/api.md from the COMMENTs of an installed extension and from docs/examples.
docs: setup
	scripts/api_docs.sh

setup:
	@scripts/setup.sh

# The same with what tests and benches compare against.
setup-test:
	@scripts/setup.sh test

clean:
	cargo clean
