#!/bin/bash
# Configures, builds and runs a project that has the sources of Circumspect inside, as their users
# would:
#   examples/inside_test.sh            configures it, and looks at what it would build
#   examples/inside_test.sh --build    and builds and runs it, which compiles everything once more
# The project around sets no build type, and demands more of its own code than Circumspect does.
set -euo pipefail
[ $# -eq 0 ] || [ "$*" = --build ] || { echo "usage: examples/inside_test.sh [--build]" >&2; exit 2; }

examples=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$examples")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "inside_test: $1" >&2
  exit 1
}

# Output only of what fails.
quietly() {
  "$@" >"$work/log" 2>&1 || { cat "$work/log"; fail "failed: $*"; }
}

mkdir "$work/around"
cp -r "$examples/judge" "$work/around/judge"
cp "$examples"/triangulate.[ch]pp "$work/around/"
cp -r "$examples/fuzz" "$work/around/fuzz"
# A module that has the name of one of ours, as any project may have.
mkdir "$work/around/cmake"
echo 'message(FATAL_ERROR "the settings of the project around were included")' >"$work/around/cmake/settings.cmake"
cat >"$work/around/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(around LANGUAGES CXX)
list(APPEND CMAKE_MODULE_PATH "${CMAKE_SOURCE_DIR}/cmake")
enable_testing()
# The targets are made in a folder of this one, and have to be seen here.
add_subdirectory(judge)
add_executable(replay fuzz/triangulate_fuzz.cpp fuzz/replay.cpp triangulate.cpp)
target_link_libraries(replay PRIVATE circumspect::harness)
get_property(default_type CACHE CMAKE_BUILD_TYPE PROPERTY VALUE)
file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/asked-of-users" CONTENT "\
type=${CMAKE_BUILD_TYPE}${default_type}
check-options=$<TARGET_PROPERTY:judge_arrays,COMPILE_OPTIONS>$<TARGET_GENEX_EVAL:judge_arrays,$<TARGET_PROPERTY:circumspect::check,INTERFACE_COMPILE_OPTIONS>>
harness-options=$<TARGET_PROPERTY:circumspect::harness,INTERFACE_COMPILE_OPTIONS>
command=$<TARGET_EXISTS:circumspect::command>
")
END

echo "inside another project: targets, and nothing that was not asked for"
quietly cmake -S "$work/around" -B "$work/build" -G Ninja -DCIRCUMSPECT="$root" -DCIRCUMSPECT_QUICK_BUILD=ON \
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
cat >"$work/expected" <<'END'
type=
check-options=
harness-options=
command=0
END
diff "$work/expected" "$work/build/asked-of-users" || fail "the project asks too much of its users"
ctest --test-dir "$work/build" -N >"$work/tests" 2>&1
grep -q "Total Tests: 0" "$work/tests" || fail "expected no tests of Circumspect"
flags=$(grep -h '"command":.*judge_arrays\.cpp' "$work/build/compile_commands.json")
for leaked in -Wall -Wextra -Wconversion -Wshadow -ffp-contract -O3 "-I$root "; do
  case $flags in *"$leaked"*) fail "its users' code is compiled with $leaked" ;; esac
done
# Without an install rule of ours, `cmake --install` of the project around installs nothing of ours.
quietly cmake --install "$work/build" --prefix "$work/installed"
[ -z "$(find "$work/installed" -type f 2>/dev/null)" ] || fail "expected nothing of Circumspect to be installed"

echo "the default target builds what is linked to, and no more"
ninja -C "$work/build" -t inputs all >"$work/inputs"
! grep -q -e optimality -e command "$work/inputs" || fail "expected no command in the default target"

echo "doubles are doubles, and assertions are on, whatever the project around asks for"
quietly cmake -S "$work/around" -B "$work/released" -G Ninja -DCIRCUMSPECT="$root" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
flags=$(grep -h '"command":.*oracle/judge/points/delaunay\.cpp' "$work/released/compile_commands.json")
case $flags in *"-DNDEBUG"*"-UNDEBUG"*"-ffp-contract=off"* | *"-DNDEBUG"*"-ffp-contract=off"*"-UNDEBUG"*) ;;
  *) fail "expected assertions and -ffp-contract=off in: $flags" ;; esac
cp -r "$work/around" "$work/hurried"
sed -i '/^project/a add_compile_options(-ffast-math)' "$work/hurried/CMakeLists.txt"
if cmake -S "$work/hurried" -B "$work/fast" -G Ninja -DCIRCUMSPECT="$root" >"$work/log" 2>&1; then
  fail "expected -ffast-math to be refused"
fi
grep -q "The compiler flags contain -ffast-math" "$work/log" || { cat "$work/log"; fail "expected the reason"; }

echo "without RapidCheck, which only the tests need, there are judge and harness"
quietly cmake -S "$work/around" -B "$work/judging" -G Ninja -DCIRCUMSPECT="$root" -DCMAKE_DISABLE_FIND_PACKAGE_rapidcheck=ON
ninja -C "$work/judging" -t inputs all >"$work/inputs"
for library in libcircumspect-check.a libcircumspect-harness.a; do
  grep -q "$library" "$work/inputs" || fail "expected $library"
done

[ "${1:-}" = --build ] || exit 0

echo "judge and harness, built and run"
quietly cmake --build "$work/build" --target judge_arrays
"$work/build/judge/judge_arrays"
quietly cmake --build "$work/build"
printf '\0\0\0\0\0\0\1\0\0\0\0\0\1\0\0' >"$work/seed"
"$work/build/replay" "$work/seed"
