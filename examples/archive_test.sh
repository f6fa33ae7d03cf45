#!/bin/bash
# Builds the libraries as others pack them, and uses them as their users would:
#   examples/archive_test.sh FOLDER [BUILD]
# From sources without git, as archives, with neither oneTBB nor what only the command needs; then
# installed by DESTDIR for a prefix that is nowhere else, moved, and linked by CMake, pkg-config and
# Meson. Compiles for minutes; FOLDER/build is kept. BUILD names another build with
# BUILD_SHARED_LIBS=OFF, which is then used.
set -euo pipefail

mkdir -p "${1:?usage: examples/archive_test.sh FOLDER}"
folder=$(realpath "$1")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "archive_test: $1" >&2
  exit 1
}

# Output only of what fails.
quietly() {
  "$@" >"$work/log" 2>&1 || { cat "$work/log"; fail "failed: $*"; }
}

# tar keeps the times of what it copies, so that a second time compiles little.
build=${2:-$folder/build}
if [ $# -lt 2 ]; then
  mkdir -p "$folder/sources"
  tar -C "$root" --exclude=./build --exclude=./.git -c . | tar -C "$folder/sources" -x
  echo "archives, from sources without git"
  quietly cmake -S "$folder/sources" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCIRCUMSPECT_QUICK_BUILD=ON \
    -DBUILD_SHARED_LIBS=OFF -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON -DCIRCUMSPECT_BUILD_TESTS=OFF \
    -DCIRCUMSPECT_BUILD_COMMAND=OFF
  cmake --build "$folder/build" --target circumspect_archive -j "${JOBS:-$(nproc)}"
fi

echo "installed by DESTDIR, and moved"
quietly env DESTDIR="$work/stage" cmake --install "$build" --prefix /opt/strange+place --component harness
mv "$work/stage/opt/strange+place" "$work/moved"
! grep -rIl -e "$folder" -e "$root/" -e strange "$work/moved" || fail "an installed file names a folder of the build"
find "$work/moved" -name '*.so*' | grep -q . && fail "expected archives alone, found a shared library"
archive=$(find "$work/moved" -name libcircumspect.a)
strange=$(readelf -sW "$archive" | awk '$5 == "GLOBAL" && $6 == "DEFAULT" && $7 != "UND" && $8 !~ /^circumspect_/ { print $8 }' | sort -u)
[ -z "$strange" ] || fail "expected hidden symbols but for circumspect_*, found $strange"

# judged PROGRAM: it says what examples/c/check.c is to say.
judged() {
  "$1" >"$work/said" || fail "the C library was wrong: $1"
  grep -q "^delaunay.facet-not-local: vertex 3 in a ball of squared radius 1/2" "$work/said" || fail "expected a witness"
}

echo "CMake, in C alone and in C++"
cp -r "$root/examples" "$work/examples"
quietly cmake -S "$work/examples/c" -B "$work/c" -DCMAKE_PREFIX_PATH="$work/moved"
quietly cmake --build "$work/c"
judged "$work/c/check"
quietly cmake -S "$work/examples/judge" -B "$work/judge" -DCMAKE_PREFIX_PATH="$work/moved"
quietly cmake --build "$work/judge"
"$work/judge/judge_arrays" >/dev/null || fail "the judge of arrays was wrong"

echo "a library that is missing is named"
where=$(dirname "$(gcc -print-file-name=libgmp.so)")
if cmake -S "$work/examples/c" -B "$work/bare" -DCMAKE_PREFIX_PATH="$work/moved" \
  -DCMAKE_IGNORE_PATH="$(realpath "$where");/lib/$(basename "$(realpath "$where")")" >"$work/log" 2>&1; then
  fail "expected that a missing GMP is noticed"
fi
grep -q "expected the library gmpxx" "$work/log" || { cat "$work/log"; fail "expected that a missing GMP is named"; }

echo "pkg-config"
pkg=$(dirname "$(find "$work/moved" -name circumspect-c.pc)")
flags=$(PKG_CONFIG_PATH=$pkg pkg-config --static --cflags --libs circumspect-c)
# shellcheck disable=SC2086
quietly gcc -std=c99 -Wall -Wextra -Wpedantic -Werror -o "$work/by-pkg-config" "$root/examples/c/check.c" $flags
judged "$work/by-pkg-config"

if command -v meson >/dev/null; then
  echo "Meson"
  quietly meson setup --default-library static --pkg-config-path "$pkg" "$work/meson" "$work/examples/c"
  quietly meson compile -C "$work/meson"
  judged "$work/meson/check"
fi

echo "doctest, and other frameworks as far as they are installed"
quietly cmake -S "$work/examples/properties" -B "$work/properties" -DCMAKE_PREFIX_PATH="$work/moved"
quietly cmake --build "$work/properties"
quietly ctest --test-dir "$work/properties" --output-on-failure
sed -i '/\.families/d; s/, {"integers", "grid"})/)/' "$work"/examples/properties/*.cpp
quietly cmake --build "$work/properties"
for program in "$work"/properties/triangulate_*; do
  [ -f "$program" ] || continue
  if "$program" >"$work/log" 2>&1; then fail "expected a finding of ${program##*/}, found none"; fi
  grep -q "delaunay.facet-not-local" "$work/log" || { cat "$work/log"; fail "expected a broken rule from ${program##*/}"; }
  echo "  ${program##*/} finds what rounding breaks"
done
