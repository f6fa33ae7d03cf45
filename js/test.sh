#!/bin/bash
# Tests the package that js/build.sh made:
#   js/test.sh FOLDER
# As its users ask it; installed in a project of its own, with the programs that it tests there; and in Chromium.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(realpath "${1:?usage: js/test.sh FOLDER}")
packed=$(ls "$folder"/circumspect-oracle-*.tgz)
size=$(stat -c %s "$packed")
[ "$size" -le 2000000 ] || { echo "js/test.sh: expected a package of at most 2 MB, found $size bytes" >&2; exit 1; }
CIRCUMSPECT_PACKAGE=$folder/package node --test "$here/oracle_test.mjs"

project=$(mktemp -d)
trap 'rm -rf "$project"' EXIT
cp "$packed" "$project/circumspect-oracle.tgz"
mkdir "$project/example"
cp "$here"/example/* "$project/example/"
cd "$project/example"
npm install --ignore-scripts --no-audit --no-fund --loglevel=error
npx tsc --noEmit --strict --module nodenext --moduleResolution nodenext --skipLibCheck types.ts
# The first test passes, and the other finds what is wrong with Delaunator, with a witness.
if npx vitest run >vitest.log 2>&1; then
  cat vitest.log >&2
  echo "js/test.sh: expected a fault of Delaunator, found none" >&2
  exit 1
fi
for expected in '2 passed' '1 failed' 'Shrunk' 'fails: triangulation mesh'; do
  grep -q "$expected" vitest.log || { cat vitest.log >&2; echo "js/test.sh: expected '$expected' in what vitest prints" >&2; exit 1; }
done
echo "example: Delaunator's fault was found, $(grep -o 'fails: triangulation mesh [a-z.-]*' vitest.log | head -n 1)"
NODE_PATH="$folder/modules/node_modules" node "$here/browser_test.mjs" "$folder/package"
