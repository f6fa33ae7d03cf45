#!/bin/bash
# Is page.built.html what bundle.mjs makes of the sources?
#   bundle_test.sh FOLDER      with the modules in FOLDER/node_modules
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
NODE_PATH="$1/node_modules" node "$here/bundle.mjs" "$1/page.built.html"
cmp "$1/page.built.html" "$here/page.built.html" ||
  { echo "page.built.html is not what its sources give: run 'make page'" >&2; exit 1; }
