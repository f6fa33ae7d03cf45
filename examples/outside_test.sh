#!/bin/bash
# Installs into a fresh folder, builds the examples against that copy as their users would, and runs
# them:
#   examples/outside_test.sh BUILD
# BUILD is a build of the project, such as build/release.
set -euo pipefail

build=${1:?usage: examples/outside_test.sh BUILD}
examples=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "outside_test: $1" >&2
  exit 1
}

# What is linked here is not measured: mold takes a fifth of the time.
if command -v mold >/dev/null; then export LDFLAGS=-fuse-ld=mold; fi

# Output only of what fails.
quietly() {
  "$@" >"$work/log" 2>&1 || { cat "$work/log"; fail "failed: $*"; }
}

# What is installed is among what `make build` builds.
make -n -C "$(dirname "$examples")" build >"$work/make" 2>/dev/null || fail "make -n build failed"
grep -q "cmake --build.* circumspect_archive" "$work/make" ||
  fail "expected make build to build circumspect_archive, which cmake --install installs"
quietly cmake --install "$build" --prefix "$work/installed" --component harness
# The copy stands alone: nothing of it names this tree.
! grep -rIl -e "$examples" -e "$(dirname "$examples")/" "$work/installed" ||
  fail "an installed file names the folder of the sources"
cp -r "$examples" "$work/examples"

echo "the command, as README.md installs it"
quietly cmake --install "$build" --component command --prefix "$work/local"
"$work/local/bin/circumspect" --version >/dev/null || fail "the installed command does not run"
# Its section "Believe nobody" runs with what its section "Install" installs, where that has been
# built.
verified=$(sed -n 's/^CIRCUMSPECT_VERIFIED:FILEPATH=//p' "$build/CMakeCache.txt")
grep -q "^make verified" "$examples/../README.md" || fail "expected that README.md builds circumspect-verified by make verified"
make -n -C "$(dirname "$examples")" verified >"$work/make" 2>/dev/null || fail "make -n verified failed"
grep -q "build/proofs/circumspect-verified" "$work/make" ||
  fail "expected make verified to build what cmake --install installs"
if [ -x "$verified" ]; then
  mkdir "$work/believes"
  ln -s "$(dirname "$examples")/corpus" "$work/believes/corpus"
  awk '/^### Believe nobody/ { found = 1; next } /^##/ { found = 0 } found && sub(/^\$ /, "")' "$examples/../README.md" >"$work/commands"
  [ "$(wc -l <"$work/commands")" -ge 2 ] || fail "expected two commands in README.md, Believe nobody"
  quietly env -C "$work/believes" PATH="$work/local/bin:/usr/bin:/bin" bash -euc "$(cat "$work/commands")"
  grep -q "^verified: delaunay" "$work/log" || fail "expected a verified certificate from README.md's own words"
fi

echo "judge, by find_package"
quietly cmake -S "$work/examples/judge" -B "$work/judge" -DCMAKE_PREFIX_PATH="$work/installed"
quietly cmake --build "$work/judge"
"$work/judge/judge_arrays" >/dev/null || fail "the judge of arrays was wrong"

echo "properties, by find_package"
# The compiler reads the headers once for both: the properties as they stand, and where doubles
# are rounded.
sed -n '/^CIRCUMSPECT_DELAUNAY_PROPERTIES/,$ { s/"triangulate"/"rounded"/; /\.families/!p }' \
  "$examples/properties/triangulate_test.cpp" >>"$work/examples/properties/triangulate_test.cpp"
quietly cmake -S "$work/examples/properties" -B "$work/properties" -DCMAKE_PREFIX_PATH="$work/installed" -DCMAKE_CXX_FLAGS=-O1
quietly cmake --build "$work/properties" --target triangulate_test  # archive_test.sh builds the others
"$work/properties/triangulate_test" --test-case-exclude='rounded*'
! grep -q "rapidcheck" "$work"/judge/CMakeFiles/*.dir/link.txt "$work/properties/CMakeFiles/triangulate_test.dir/link.txt" ||
  fail "expected judge and harness to do without RapidCheck"

echo "properties fail where doubles are rounded"
if "$work/properties/triangulate_test" --test-case="rounded: claim" >"$work/log" 2>&1; then fail "expected a finding, found none"; fi
grep -q "circumspect generate" "$work/log" || fail "expected a line that makes the input again"

echo "fuzz, without libFuzzer"
quietly cmake -S "$work/examples/fuzz" -B "$work/replay" -DCMAKE_PREFIX_PATH="$work/installed"
quietly cmake --build "$work/replay"
printf '\0\0\0\0\0\0\1\0\0\0\0\0\1\0\0' >"$work/seed"
"$work/replay/triangulate_fuzz" "$work/seed"

if command -v clang++ >/dev/null; then
  echo "fuzz, with libFuzzer"
  quietly cmake -S "$work/examples/fuzz" -B "$work/fuzz" -DCMAKE_PREFIX_PATH="$work/installed" \
    -DCMAKE_CXX_COMPILER=clang++
  quietly cmake --build "$work/fuzz"
  if "$work/fuzz/triangulate_fuzz" -seed=1 -runs=200000 -max_total_time=60 \
    -artifact_prefix="$work/" >"$work/log" 2>&1; then
    fail "expected a finding, found none"
  fi
  grep -m1 "^delaunay: " "$work/log" || { tail -n 40 "$work/log"; fail "expected a broken rule"; }
fi

echo "pkg-config"
if command -v pkg-config >/dev/null; then
  flags=$(PKG_CONFIG_PATH=$(dirname "$(find "$work/installed" -name circumspect.pc)") \
    pkg-config --cflags --libs circumspect)
  # What CMake has compiled above: the flags of the next program are those of the compiler as well.
  # shellcheck disable=SC2046,SC2086
  quietly g++ ${LDFLAGS:-} -o "$work/by-pkg-config" $(find "$work/replay" -path '*triangulate_fuzz.dir*' -name '*.o') $flags
  "$work/by-pkg-config" "$work/seed"
  flags=$(PKG_CONFIG_PATH=$(dirname "$(find "$work/installed" -name circumspect-check.pc)") \
    pkg-config --cflags --libs circumspect-check)
  # shellcheck disable=SC2086
  quietly g++ ${LDFLAGS:-} -std=c++20 -o "$work/judge-by-pkg-config" "$examples/judge/judge_arrays.cpp" $flags
  "$work/judge-by-pkg-config" >/dev/null || fail "the judge of arrays was wrong"
  flags=$(PKG_CONFIG_PATH=$(dirname "$(find "$work/installed" -name circumspect-c.pc)") \
    pkg-config --cflags --libs circumspect-c)
  # shellcheck disable=SC2086
  quietly gcc -std=c99 -Wall -Wextra -Wpedantic -Werror -o "$work/c-by-pkg-config" "$examples/c/check.c" $flags
  if command -v meson >/dev/null; then
    quietly meson setup --pkg-config-path "$(dirname "$(find "$work/installed" -name circumspect-c.pc)")" "$work/meson" "$work/examples/c"
    quietly meson compile -C "$work/meson"
  fi
fi

echo "the C library, from C and from ctypes"
library=$(find "$work/installed" -name libcircumspect.so)
export LD_LIBRARY_PATH=${library%/*}
quietly cmake -S "$work/examples/c" -B "$work/c" -DCMAKE_PREFIX_PATH="$work/installed"
quietly cmake --build "$work/c"
for program in "$work/c/check" "$work/c-by-pkg-config" "$work/meson/check"; do
  [ -x "$program" ] || continue  # without pkg-config, or Meson
  "$program" >"$work/said" || fail "the C library was wrong"
  grep -q "^delaunay.facet-not-local: vertex 3 in a ball of squared radius 1/2" "$work/said" || fail "expected a witness"
done
if "$work/c/square" >"$work/said"; then fail "expected that the wrong diagonal is found"; fi
grep -q "^fails: delaunay mesh delaunay.facet-not-local 1 face 1 2 vertex 3" "$work/said" || fail "expected a witness, found $(cat "$work/said")"
python3 "$examples/c/check.py" >"$work/said" || fail "the C library was wrong, called by ctypes"
if command -v rustc >/dev/null; then  # no package that make test installs: debian/fresh_root_test.sh has it
  echo "the C library, from Rust"
  quietly rustc --edition 2021 -o "$work/check-in-rust" -L "${library%/*}" -l circumspect "$examples/rust/check.rs"
  "$work/check-in-rust" >"$work/said" || fail "the C library was wrong, called from Rust"
  grep -q "^refused: expected finite coordinates, found nan" "$work/said" || fail "expected that Rust is told what is wrong"
fi
readelf -d "$library" | grep -q "soname: \[libcircumspect.so.0\]" || fail "expected the soname libcircumspect.so.0"
readelf -d "$library" | grep -q "rapidcheck" && fail "expected no RapidCheck behind the C library"
strange=$(nm -D --defined-only "$library" | grep -v -e " circumspect_[a-z_]*@@CIRCUMSPECT_0$" -e " A CIRCUMSPECT_0$" || true)
[ -z "$strange" ] || fail "the C library shows more than its own symbols: $strange"
for function in $(grep -o "circumspect_[a-z_]*(" "$work/installed/include/circumspect/circumspect.h" | tr -d '(' | sort -u); do
  nm -D --defined-only "$library" | grep -q " $function@@" || fail "the C library has no $function"
done
