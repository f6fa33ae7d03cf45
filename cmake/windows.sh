#!/bin/bash
# Builds the command and the C library for Windows, and has them judge under wine:
#   cmake/windows.sh FOLDER
# FOLDER/libraries, FOLDER/build and FOLDER/wine are kept, so that a second time is short.
# ONE_ROW_IN=8 compares one golden row in eight. CXXFLAGS_RELEASE may have other flags than -O2.
set -euo pipefail

mkdir -p "${1:?usage: cmake/windows.sh FOLDER}"
folder=$(realpath "$1")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$folder/build
log=$folder/windows.log
: >"$log"

fail() {
  echo "windows: $1" >&2
  exit 1
}

# step TEXT COMMAND…
step() {
  echo "$1"
  shift
  "$@" >>"$log" 2>&1 || { tail -n 40 "$log" >&2; fail "failed: $*; $log has it all"; }
}

"$root/cmake/windows_libraries.sh" "$folder/libraries"
step "configuring" cmake -S "$root" -B "$build" -G Ninja \
  -DCMAKE_TOOLCHAIN_FILE="$root/cmake/windows.cmake" -DCIRCUMSPECT_WINDOWS_LIBRARIES="$folder/libraries" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="${CXXFLAGS_RELEASE:--O2}" -DCIRCUMSPECT_QUICK_BUILD=ON -DCIRCUMSPECT_BUILD_TESTS=OFF \
  -DCMAKE_CXX_FLAGS="-ffile-prefix-map=$folder/libraries=. -ffile-prefix-map=$root=."
step "compiling" cmake --build "$build" --target circumspect_cli circumspect_c_library -j "${JOBS:-$(nproc)}"

# Nothing but what every Windows has stands behind them, and they do not tell where they were built.
for file in bin/circumspect.exe libcircumspect.dll; do
  others=$(x86_64-w64-mingw32-objdump -p "$build/$file" | sed -n 's/.*DLL Name: //p' |
    grep -viE '^(advapi32|bcrypt|kernel32|msvcrt|psapi|shell32|user32|ws2_32)\.dll$' || true)
  [ -z "$others" ] || fail "$file: expected no library but those of Windows, found $others"
  for place in "$folder" "$root"; do
    if grep -qF "$place/" "$build/$file"; then fail "$file: expected nothing of where its sources lie, found $place"; fi
  done
done

export WINEPREFIX=$folder/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml="
unset DISPLAY
[ -d "$WINEPREFIX" ] || step "setting wine up" wineboot -i
command=$folder/by-wine
printf '#!/bin/sh\nexec wine "%s" "$@"\n' "$build/bin/circumspect.exe" >"$command"
chmod +x "$command"
step "the version" "$command" --version
tail -n 1 "$log"
step "the golden bytes, one row in ${ONE_ROW_IN:-8}" python3 "$root/corpus/golden.py" "$command" --one-in "${ONE_ROW_IN:-8}"
tail -n 1 "$log"
step "what is different on Windows" "$root/cmake/windows_test.sh" "$command" "$folder/scratch"
tail -n 1 "$log"
step "a C program" x86_64-w64-mingw32-gcc-posix -I "$root/include" -o "$build/judge.exe" "$root/examples/c/check.c" \
  -L "$build" -lcircumspect
step "what it says" wine "$build/judge.exe"
grep -q "^delaunay.facet-not-local: vertex 3 in a ball of squared radius 1/2" "$log" || fail "expected a witness from C"
echo "windows: command and C library judge under wine"
