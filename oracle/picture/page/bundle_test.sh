#!/bin/bash
# Are page.built.html and docs/images what the sources give?
#   bundle_test.sh FOLDER COMMAND      with the modules in FOLDER/node_modules
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
export NODE_PATH="$1/node_modules"
node "$here/bundle.mjs" "$1/page.built.html"
"$here/images.sh" "$2" "$1/images"
if ! cmp "$1/page.built.html" "$here/page.built.html" || ! diff -rq "$1/images" "$here/../../../docs/images"; then
  echo "what is committed is not what its sources give: run 'make page'" >&2
  exit 1
fi
