#!/bin/bash
# The demonstration: judges meshes of this corpus, good ones and broken ones, made by TetGen, Gmsh,
# Qhull, CGAL and us, builds references and judges them, and lets a campaign loose on TetGen. Exit 0
# if every verdict was the expected one. CAMPAIGN_TIME=2s makes the campaign shorter;
# CAMPAIGN_OUTPUT=FOLDER keeps what it finds.
set -uo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
command=${CIRCUMSPECT:-$root/build/release/bin/circumspect}
case $command in
  /*) ;;
  */*) command=$PWD/$command ;;
esac
cd "$root" || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

runs=0
surprises=0

# say TEXT...: what the next mesh is.
say() {
  printf '\n'
  printf '# %s\n' "$@"
}

# expect EXIT_CODE START ARGUMENT...: runs the command and shows it; its last line has to begin with
# START.
expect() {
  local code=$1 start=$2 output status
  shift 2
  printf '$ circumspect'
  printf ' %s' "$@"
  printf '\n'
  output=$("$command" "$@" 2>&1)
  status=$?
  printf '%s\n' "$output"
  runs=$((runs + 1))
  if [[ $status -ne $code || $(tail -n 1 <<<"$output") != "$start"* ]]; then
    printf '!!! expected exit code %d and a verdict "%s", found exit code %d\n' "$code" "$start" "$status"
    surprises=$((surprises + 1))
  fi
}

# holds CLAIM ARGUMENT... MESH
holds() {
  local claim=$1
  shift
  expect 0 "holds: $claim ${*: -1}" check "$@"
}

# fails RULE ARGUMENT... MESH: one witness is shown.
fails() {
  local rule=$1
  shift
  expect 1 "fails: delaunay ${*: -1} $rule" check --max-errors 1 "$@"
}

say 'TetGen, 500 random points: a Delaunay triangulation.'
holds delaunay corpus/peers/tetgen/random-3d-500.1.ele

say 'CGAL, 48 points on one sphere: Delaunay, one of many possible answers.'
holds delaunay corpus/peers/cgal/cospherical-3d-48.ele

say 'TetGen, six points that are coplanar but for roundoff. Its boundary is closed and locally convex,' \
    'every facet is matched, and part of space is covered twice.'
fails triangulation.covered-twice corpus/peers/tetgen/hunted-tetgen-covered-twice-3d.1.ele

say 'TetGen, six points close to a line and two more: not Delaunay. The witness is a ball and a point in it.'
fails delaunay.facet-not-local corpus/peers/tetgen/hunted-tetgen-not-delaunay-3d.1.ele

say 'Qhull (Qt), seven points with coordinates from 0 to 3: one tetrahedron of exactly zero volume.'
fails simplex.degenerate corpus/peers/qhull/hunted-qhull-flat-3d.qhull-i

say 'Qhull (QJ), four points of the plane, two of them 1e-13 apart: the joggled answer folds over.'
fails complex.overlap corpus/peers/qhull/hunted-qhull-joggled-overlap-2d--joggled.qhull-i

say 'CGAL with the inexact kernel that its manual warns of, 40 doubles near the unit circle.'
fails delaunay.facet-not-local corpus/peers/cgal/circle-2d--inexact-kernel.ele

say 'Ours: the book'"'"'s Figure 4.1, the better-looking triangulation. It is one, but not Delaunay.'
holds triangulation --claim triangulation corpus/accept/figure-4-1-two-tetrahedra.ele
fails delaunay.facet-not-local corpus/accept/figure-4-1-two-tetrahedra.ele

say 'Ours: a hull sliver as thin as one unit in the last place is missing.'
fails triangulation.hull-not-convex corpus/reject/triangulation.hull-not-convex--one-ulp-sliver-missing.ele

say 'Ours: coordinates 1e300 beside 1e-300, where products of doubles overflow and underflow.'
holds delaunay corpus/accept/huge-beside-tiny.ele

domains=corpus/domains

say 'TetGen -p, a cube with a square tunnel: a constrained Delaunay triangulation of that domain.'
expect 0 "holds: cdt $domains/tetgen/tunnel.1.ele" \
  check --domain "$domains/tunnel.poly" "$domains/tetgen/tunnel.1.ele"

say 'Gmsh, the same domain: a triangulation of it with further vertices, and no more is claimed.'
expect 0 "holds: steiner-triangulation $domains/gmsh/tunnel--finer.mesh" \
  check --domain "$domains/tunnel.poly" --claim steiner-triangulation "$domains/gmsh/tunnel--finer.mesh"

say 'TetGen -p, Schonhardt'"'"'s polyhedron, which needs Steiner points: rounded to doubles they are off their segments.'
expect 1 "fails: steiner-cdt $domains/tetgen/figure-4-10-schonhardt.1.ele domain.segment-missing" \
  check --max-errors 1 --domain "$domains/figure-4-10-schonhardt.poly" "$domains/tetgen/figure-4-10-schonhardt.1.ele"

say 'Ours: two rooms, the square between them cut along one diagonal from the left and the other from the right.'
expect 1 "fails: cdt $domains/reject/complex.overlap--both-sides-differ.ele complex.overlap" \
  check --max-errors 1 --domain "$domains/reject/complex.overlap--both-sides-differ.poly" \
  "$domains/reject/complex.overlap--both-sides-differ.ele"

say 'A cube with one corner one unit in the last place off: the input is at fault, not the mesh.'
expect 3 "circumspect: $domains/invalid/plc.polygon-not-planar--one-ulp.poly:14: expected a piecewise linear complex" \
  check --domain "$domains/invalid/plc.polygon-not-planar--one-ulp.poly" "$domains/tetgen/cube.1.ele"

say 'Schonhardt'"'"'s polyhedron has no triangulation; with Steiner points a reference is built, then judged.'
expect 0 "inspected: $domains/figure-4-10-schonhardt.poly" inspect "$domains/figure-4-10-schonhardt.poly"
expect 0 'built: steiner-cdt' build steiner-cdt "$domains/figure-4-10-schonhardt.poly" -o "$work/schonhardt.ele"
expect 0 "holds: steiner-cdt $work/schonhardt.ele" \
  check --domain "$domains/figure-4-10-schonhardt.poly" "$work/schonhardt.ele"

say 'A reference: the canonical Delaunay triangulation of the twelve points of Figure 4.4, then judged.'
expect 0 'built: delaunay' build delaunay corpus/accept/figure-4-4-two-cubes.node -o "$work/two-cubes.ele"
holds delaunay --points corpus/accept/figure-4-4-two-cubes.node "$work/two-cubes.ele"

say 'TetGen itself, for ten seconds, on inputs made to break it: every mesh judged, one of each failure made small.'
program=$(type -P tetgen)
if [[ -n $program ]]; then
  arguments=(campaign --time "${CAMPAIGN_TIME:-10s}" --seed 1 --mesh x.1.ele --full-dimension --families
             sphere,grid,circle,ulp-clusters,mixed-exponents --minimize-time 5s
             --output "${CAMPAIGN_OUTPUT:-$work/campaign}" -- tetgen -JQ '{points}')
  printf '$ circumspect %s\n' "${arguments[*]}"
  "$command" "${arguments[@]}"
  status=$?
  printf '(exit code %d)\n' "$status"
  runs=$((runs + 1))
  if [[ $status -ne 1 ]]; then
    surprises=$((surprises + 1))
    printf 'unexpected: expected exit code 1, for something found\n'
  fi
else
  printf 'tetgen is not installed: left out\n'
fi

printf '\n'
if [[ $surprises -gt 0 ]]; then
  printf 'demo: %d of %d verdicts were not the expected ones\n' "$surprises" "$runs"
  exit 1
fi
printf 'demo: all %d verdicts were the expected ones\n' "$runs"
