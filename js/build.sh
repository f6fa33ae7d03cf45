#!/bin/bash
# Makes the package for npm:
#   js/build.sh FOLDER
# FOLDER/package is what `npm pack` packs, and FOLDER/circumspect-oracle-VERSION.tgz what it makes
# of it. FOLDER/libraries, FOLDER/build and FOLDER/modules are those of `make web`, and are kept, so
# that a second build is short.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/.." && pwd)
mkdir -p "${1:?usage: js/build.sh FOLDER}"
folder=$(realpath "$1")
"$root/command/web/configure.sh" "$folder"
source "$root/command/web/emscripten.sh"
cmake --build "$folder/build" --target circumspect_js -j "${JOBS:-$(nproc)}"
package=$folder/package
rm -rf "$package" && mkdir -p "$package"
cp "$here"/*.mjs "$here"/*.d.ts "$package/"
rm "$package"/*_test.mjs "$package"/{pack,times}.mjs
install -m 644 "$folder/build/js/library.wasm" "$package/circumspect.wasm"
"$root/cmake/licences.sh" page "$folder/licences"
version=$(sed -n 's/^project(circumspect VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
NODE_PATH="$folder/modules/node_modules" node "$here/pack.mjs" "$root" "$package" "$version" "$folder/licences"
chmod -R u+rwX,go=rX "$package" # npm packs what a umask has left of the modes
(cd "$folder" && npm pack --silent ./package)
