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
"$here/configure.sh" "$folder"
source "$here/emscripten.sh"
cmake --build "$folder/build" --target circumspect_cli -j "${JOBS:-$(nproc)}"
"$root/cmake/licences.sh" page "$folder/licences"
cp "$folder"/build/bin/circumspect.{js,wasm} "$folder/"
NODE_PATH="$folder/modules/node_modules" node "$here/bundle.mjs" "$folder" "$folder/index.html"
