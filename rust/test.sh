#!/bin/bash
# Tests the crate against an installed copy of the C library, with Debian's cargo and crates:
#   rust/test.sh PREFIX
set -euo pipefail
prefix=$(realpath "${1:?usage: rust/test.sh PREFIX}")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$here"/. "$work/circumspect"
cd "$work/circumspect"
export CIRCUMSPECT_PREFIX=$prefix CARGO_HOME=$work/cargo CARGO_NET_OFFLINE=true PATH=/usr/bin:/bin
mkdir -p .cargo
printf '[source.crates-io]\nreplace-with = "debian"\n[source.debian]\ndirectory = "/usr/share/cargo/registry"\n' >.cargo/config.toml
if [ -d /usr/share/cargo/registry ] && compgen -G '/usr/share/cargo/registry/proptest-*' >/dev/null; then
  cargo test --quiet --all-features
else
  echo "without proptest (Debian: librust-proptest+std-dev), strategies are not tested"
  sed -i -e '/^\[features\]/,$d' Cargo.toml
  cargo test --quiet
fi
# In a project that has the crate, the test of README.md; the name of the prefix is a strange one.
ln -s "$prefix" "$work/a strange+place"
mkdir -p "$work/project/src" "$work/project/tests"
touch "$work/project/src/lib.rs"
printf '[package]\nname = "project"\nversion = "0.1.0"\nedition = "2021"\n[dev-dependencies]\ncircumspect = { path = "../circumspect" }\n' \
  >"$work/project/Cargo.toml"
{ sed -n '/^```rust$/,/^```$/{/^```/!p}' README.md
  echo 'fn my_triangulation(_: &[[f64; 2]]) -> [[usize; 3]; 2] { [[0, 1, 2], [0, 2, 3]] }'; } >"$work/project/tests/square.rs"
(cd "$work/project" && CIRCUMSPECT_PREFIX="$work/a strange+place" cargo test --quiet --test square) | tee "$work/log"
grep -q "1 passed" "$work/log"
# As docs.rs does it, where there is no C library.
CIRCUMSPECT_PREFIX=$work DOCS_RS=1 CARGO_TARGET_DIR=$work/documented cargo doc --quiet --no-deps
cargo package --quiet --list --allow-dirty | grep -q src/lib.rs
