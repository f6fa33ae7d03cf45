#!/bin/bash
# Holds circumspect-verified to the first line of each certificate here, and the certificates to
# make.py:  proofs/mutants/check.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
again=$(mktemp -d)
trap 'rm -rf "$again"' EXIT
python3 make.py "$again"
for file in "$again"/*.cert *.cert; do
  case "$(basename "$file")" in large--*) continue ;; esac
  cmp -s "$again/$(basename "$file")" "$(basename "$file")" || {
    echo "$(basename "$file") is not what make.py writes: run proofs/mutants/make.py proofs/mutants" >&2
    exit 1
  }
done
failures=0
for file in "$again"/*.cert; do
  expected=$(head -n 1 "$file" | cut -c 3-)
  found=$("$program" "$file") && code=0 || code=$?
  case "$expected" in
    verified*) wanted=0 ;;
    rejected*) wanted=1 ;;
    *) wanted=3 ;;
  esac
  if [ "$code" -ne "$wanted" ] || [[ "$found" != "$expected"* ]]; then
    echo "$file: expected '$expected', exit $wanted; found '$found', exit $code" >&2
    failures=$((failures + 1))
  fi
done
# The example of Definitions.v, as it stands there.
sed -n '/^<<$/,/^>>$/p' ../Definitions.v | sed '1d;$d' >"$again/triangle"
found=$("$program" "$again/triangle") || true
[ "$found" = "verified: delaunay, 3 points, 1 triangles" ] || {
  echo "the triangle of Definitions.v: found '$found'" >&2
  failures=$((failures + 1))
}
[ "$failures" -eq 0 ]
# Every condition of the checker has a mutant.
sed -n 's/^| `\([a-z-]*\)` |.*/\1/p' ../CERTIFICATE.md | while read -r condition; do
  ls "$condition"*.cert >/dev/null 2>&1 || { echo "no mutant breaks $condition" >&2; exit 1; }
done
echo "mutants: $(ls "$again"/*.cert | wc -l) certificates and refutations answered as expected"
