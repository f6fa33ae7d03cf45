#!/bin/bash
# Certifies the meshes of corpus that are judged as complexes, and those that are convex hulls or
# Delaunay surfaces or that a lattice repeats, and has circumspect-verified read what proves the
# verdict:
#   proofs/alone.sh CIRCUMSPECT CIRCUMSPECT_VERIFIED
set -euo pipefail
circumspect=$(realpath "$1")
verified=$(realpath "$2")
cd "$(dirname "${BASH_SOURCE[0]}")/../corpus"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
accepted=0
refuted=0
hulls=0
surfaces=0
while IFS=$'\t' read -r mesh claim verdict; do
  if [ "${claim%% *}" = convex-hull ] && [[ "$verdict" =~ ^(holds|hull.facet-not-supporting|hull.uncovered)$ ]]; then
    expected="verified: not convex-hull, $verdict: "
    if [ "$verdict" = holds ]; then expected="verified: convex-hull, "; fi
    "$circumspect" certify "$mesh" --claim convex-hull --quiet -o "$scratch/certificate" || [ "$verdict" != holds ]
    found=$("$verified" "$scratch/certificate" "${mesh%.ele}.node" "$mesh") || true
    [[ "$found" == "$expected"* ]] || { echo "$mesh: expected '$expected', found '$found'" >&2; exit 1; }
    hulls=$((hulls + 1))
  fi
  [ "$claim" = complex ] || [ "$claim" = surface-delaunay ] || continue
  code=0
  "$circumspect" certify "$mesh" --claim "$claim" --quiet -o "$scratch/certificate" || code=$?
  expected="verified: not $claim, $verdict: "
  if [ "$verdict" = holds ]; then expected="verified: $claim, "; fi
  found=$("$verified" "$scratch/certificate" "${mesh%.ele}.node" "$mesh") || true
  if [ "$code" -ne "$([ "$verdict" = holds ]; echo $?)" ] || [[ "$found" != "$expected"* ]]; then
    echo "$mesh: expected '$expected', found '$found', and exit code $code of certify" >&2
    exit 1
  fi
  if [ "$claim" = surface-delaunay ]; then surfaces=$((surfaces + 1))
  elif [ "$verdict" = holds ]; then accepted=$((accepted + 1)); else refuted=$((refuted + 1)); fi
done <expected.tsv
periodic=0
while IFS=$'\t' read -r mesh options verdict _; do
  # None is written that shows these: docs/certificates.md.
  case $verdict in triangulation.unknown-vertex | simplex.wrong-dimension | simplex.orientation | complex.overlap) continue ;; esac
  code=0
  # The options are several words.
  # shellcheck disable=SC2086
  "$circumspect" certify "periodic/$mesh" --claim periodic-delaunay $options --quiet -o "$scratch/certificate" || code=$?
  expected="verified: not periodic-delaunay, *"
  if [ "$verdict" = holds ]; then expected="verified: periodic-delaunay, *"; fi
  found=$("$verified" "$scratch/certificate" "periodic/${mesh%.ele}.node" "periodic/$mesh") || true
  if [ "$code" -ne "$([ "$verdict" = holds ]; echo $?)" ] || [[ "$found" != $expected ]]; then
    echo "$mesh: expected '$expected', found '$found', and exit code $code of certify" >&2
    exit 1
  fi
  periodic=$((periodic + 1))
done < <(grep -v '^#' periodic/expected.tsv)
echo "$accepted certificates and $refuted refutations of meshes alone verified, $hulls of hulls, $surfaces of surfaces, $periodic that a lattice repeats"
[ "$accepted" -ge 6 ] && [ "$refuted" -ge 7 ] && [ "$hulls" -ge 12 ] && [ "$surfaces" -ge 5 ] && [ "$periodic" -ge 13 ]
