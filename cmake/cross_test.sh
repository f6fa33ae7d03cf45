#!/bin/bash
# Configures for another machine, and reads in the build's commands that none of what it compiles is
# run here:
#   cmake/cross_test.sh
# The compiler is this machine's: nothing is built. `make ports` cross-compiles and links for arm64.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "cross_test: $1" >&2
  exit 1
}

printf 'set(CMAKE_SYSTEM_NAME Linux)\nset(CMAKE_SYSTEM_PROCESSOR elsewhere)\n' >"$work/elsewhere.cmake"

# runs ARGUMENT…: the programs of the build itself that it runs when it makes the command, one a
# line
runs() {
  rm -rf "$work/build"
  cmake -S "$root" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCIRCUMSPECT_BUILD_TESTS=OFF \
    -DCIRCUMSPECT_QUICK_BUILD=ON "$@" >"$work/log" 2>&1 || { cat "$work/log"; fail "cmake failed"; }
  ninja -C "$work/build" -t commands circumspect_cli circumspect_archive | tr '&' '\n' |
    grep -oE "^ *[^ ]+ command-pages" | sed 's/^ *//; s/ .*//; s|.*/build/||' || true
}

[ "$(runs)" = bin/circumspect ] || fail "expected that a command for this machine writes its man pages, found $(runs)"
elsewhere=-DCMAKE_TOOLCHAIN_FILE=$work/elsewhere.cmake
[ -z "$(runs "$elsewhere")" ] || fail "expected that nothing of another machine is run, found $(runs "$elsewhere")"
grep -q "No man pages and no completions" "$work/log" || fail "expected to be told that there are no man pages"
! grep -q "share/man" "$work/build/command/cmake_install.cmake" || fail "expected that no man pages are installed"
[ "$(runs "$elsewhere" -DCIRCUMSPECT_WRITES_PAGES=/usr/bin/circumspect)" = /usr/bin/circumspect ] ||
  fail "expected that the named command writes the man pages"
grep -q "share/man" "$work/build/command/cmake_install.cmake" || fail "expected that these are installed"
runs "$elsewhere" -DCMAKE_CROSSCOMPILING_EMULATOR=/usr/bin/emulator >/dev/null
grep -q "/usr/bin/emulator [^ ]*bin/circumspect command-pages" "$work/build/build.ninja" ||
  fail "expected that the emulator runs the command"
echo "cross_test: what is compiled for another machine is not run"
