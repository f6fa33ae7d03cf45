#!/bin/bash
# Builds the command for browsers:
#   command/web/build.sh FOLDER
# FOLDER/index.html is the page, which needs no other file; circumspect.js and circumspect.wasm
# beside it are for the tests. FOLDER/libraries, FOLDER/build and FOLDER/modules are kept, so that a
# second build is short.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
mkdir -p "${1:?usage: command/web/build.sh FOLDER}"
folder=$(realpath "$1")
"$here/libraries.sh" "$folder/libraries"
"$root/oracle/picture/page/modules.sh" "$folder/modules"
source "$here/emscripten.sh"
# Eight sources at a time, as in a quick build, but without precompiled headers.
[ -f "$folder/build/build.ninja" ] ||
  emcmake cmake -S "$root" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2 \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8 -DCIRCUMSPECT_CCACHE= -DCIRCUMSPECT_BUILD_TESTS=OFF \
    -DCIRCUMSPECT_INSTALL=OFF -DCIRCUMSPECT_WEB_LIBRARIES="$folder/libraries" >"$folder/configure.log" 2>&1 ||
  { rm -f "$folder/build/build.ninja"; cat "$folder/configure.log" >&2; exit 1; }
cmake --build "$folder/build" --target circumspect_cli -j "${JOBS:-$(nproc)}"
"$root/cmake/licences.sh" page "$folder/licences"
cp "$folder"/build/bin/circumspect.{js,wasm} "$folder/"
NODE_PATH="$folder/modules/node_modules" node "$here/bundle.mjs" "$folder" "$folder/index.html"
