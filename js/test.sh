#!/bin/bash
# Tests the package that js/build.sh made:
#   js/test.sh FOLDER
# As its users ask it; installed in a project of its own, with the programs that it tests there; and
# in Chromium.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(realpath "${1:?usage: js/test.sh FOLDER}")

fail() {
  echo "js/test.sh: $1" >&2
  exit 1
}

packed=$(ls "$folder"/circumspect-oracle-*.tgz)
size=$(stat -c %s "$packed")
[ "$size" -le 2000000 ] || fail "expected a package of at most 2 MB, found $size bytes"
if tar -tvzf "$packed" | grep -v '^-rw-r--r-- '; then fail "expected modes that depend on nobody's umask"; fi
CIRCUMSPECT_PACKAGE=$folder/package node --test "$here/oracle_test.mjs"

project=$(mktemp -d)
trap 'rm -rf "$project"' EXIT
cp "$packed" "$project/circumspect-oracle.tgz"
cp -r "$here/example" "$project/example"
cd "$project/example"
npm install --ignore-scripts --no-audit --no-fund --loglevel=error
for file in package.json LICENSES.txt README.md circumspect.wasm; do
  [ -s "node_modules/circumspect-oracle/$file" ] || fail "expected $file in the package"
done
npx tsc --noEmit
# The first tests pass, and the other finds what is wrong with Delaunator, with a witness.
if npx vitest run >vitest.log 2>&1; then
  cat vitest.log >&2
  fail "expected a fault of Delaunator, found none"
fi
for expected in '2 passed' '1 failed' 'Shrunk' 'fails: triangulation mesh'; do
  grep -q "$expected" vitest.log || { cat vitest.log >&2; fail "expected '$expected' in what vitest prints"; }
done
echo "vitest: Delaunator's fault was found, $(grep -o 'fails: triangulation mesh [a-z.-]*' vitest.log | head -n 1)"
npx jest >jest.log 2>&1 || { cat jest.log >&2; fail "expected Jest's tests to pass"; }
grep -q 'Tests: .* 3 passed, 3 total' jest.log || { cat jest.log >&2; fail "expected three tests of Jest's"; }
echo "jest: 3 passed"
NODE_PATH="$folder/modules/node_modules" node "$here/browser_test.mjs" "$folder/package"
