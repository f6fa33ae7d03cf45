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
cargo package --quiet --list --allow-dirty | grep -q src/lib.rs
