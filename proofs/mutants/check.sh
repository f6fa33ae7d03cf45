#!/bin/bash
# Holds circumspect-verified to the first line of each certificate here, and the certificates to
# make.py:  proofs/mutants/check.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
again=$(mktemp -d)
trap 'rm -rf "$again"' EXIT
python3 -B make.py "$again"
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
[ "$found" = "verified: delaunay, 3 points, 1 triangle" ] || {
  echo "the triangle of Definitions.v: found '$found'" >&2
  failures=$((failures + 1))
}
# The same triangle as its user's own files, and as files of other meshes.
cd "$again"
users() {  # what is expected, then options, MESH.node and MESH.ele
  local expected=$1 found
  shift
  found=$("$program" triangle "$@") || true
  if [[ "$found" != $expected ]]; then
    echo "circumspect-verified triangle $*: expected '$expected', found '$found'" >&2
    failures=$((failures + 1))
  fi
}
printf '3 2 1 1\n7 0 0 9 1\n8 1 0 9 1 # a comment\n9 0 5e-1 9 1\n' >own.node
printf '1 3\n1 9 7 8\n' >own.ele
users "verified: delaunay, 3 points, 1 triangle: own.node own.ele" own.node own.ele
sed 's/5e-1/1\/2/' own.node >fraction.node
users "verified*" fraction.node own.ele
sed 's/5e-1/0.50000000000000001/' own.node >nearest.node
users "verified*" nearest.node own.ele
users "rejected: another mesh, nearest.node:4: *coordinate 2 of point 9" --coordinates decimal nearest.node own.ele
users "verified*" --coordinates decimal own.node own.ele
sed 's/^8 1 0/8 1 1/' own.node >moved.node
users "rejected: another mesh, moved.node:3: *coordinate 2 of point 8" moved.node own.ele
sed 's/^8/6/' own.node >index.node
users "rejected: another mesh, index.node:3: found point 6, *" index.node own.ele
sed 's/^8/7/' own.node >twice.node
users "rejected: another mesh, twice.node:3: found point 7 twice" twice.node own.ele
sed '1s/3/2/;4d' own.node >fewer.node
users "rejected: another mesh, fewer.node:*expected 3 points, found 2" fewer.node own.ele
sed '1s/3/4/' own.node >cut.node
users "malformed: cut.node:*" cut.node own.ele
sed 's/5e-1/5e/' own.node >number.node
users "malformed: number.node:4: expected a decimal or a fraction, found '5e'" number.node own.ele
sed 's/9 7 8/9 7 7/' own.ele >other.ele
users "rejected: another mesh, other.ele:2: found another simplex 1" own.node other.ele
printf '2 3\n1 9 7 8\n2 9 7 8\n' >more.ele
users "rejected: another mesh, more.ele:3: found more simplices than 1" own.node more.ele
printf '0 3\n' >none.ele
users "rejected: another mesh, none.ele:1: expected 1 simplices, found 0" own.node none.ele
users "malformed: cannot read absent.ele*" own.node absent.ele
[ "$failures" -eq 0 ]
cd - >/dev/null
# Every condition of the checker has a mutant.
sed -n 's/^| `\([a-z-]*\)` |.*/\1/p' ../CERTIFICATE.md | while read -r condition; do
  ls "$condition"*.cert >/dev/null 2>&1 || { echo "no mutant breaks $condition" >&2; exit 1; }
done
echo "mutants: $(ls "$again"/*.cert | wc -l) certificates and refutations answered as expected"
