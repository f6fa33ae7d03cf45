#!/bin/bash
# Configures what is compiled to WebAssembly: the page, and the package for npm.
#   command/web/configure.sh FOLDER
# FOLDER/libraries has what it is linked with, FOLDER/modules what packs it, and FOLDER/build is the
# folder to build in.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
folder=$(realpath "${1:?usage: command/web/configure.sh FOLDER}")
"$here/libraries.sh" "$folder/libraries"
"$root/oracle/picture/page/modules.sh" "$folder/modules"
source "$here/emscripten.sh"
# Eight sources at a time, as in a quick build, but without precompiled headers. What is made does
# not tell where the sources lie.
[ -f "$folder/build/build.ninja" ] ||
  emcmake cmake -S "$root" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="-O2 -ffile-prefix-map=$folder/libraries=libraries -ffile-prefix-map=$root=." \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8 -DCIRCUMSPECT_CCACHE= -DCIRCUMSPECT_BUILD_TESTS=OFF \
    -DCIRCUMSPECT_INSTALL=OFF -DCIRCUMSPECT_WEB_LIBRARIES="$folder/libraries" >"$folder/configure.log" 2>&1 ||
  { rm -f "$folder/build/build.ninja"; cat "$folder/configure.log" >&2; exit 1; }
