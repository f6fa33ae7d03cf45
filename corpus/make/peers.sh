#!/bin/sh
# Runs TetGen, Qhull and CGAL on corpus/peers/inputs/*.node and keeps what they write, unchanged.
# Running it again, with the same versions, gives the same files. Where a program makes no mesh,
# NAME.failed holds its exit code and the last thing it said.
#
#   corpus/make/peers.sh        needs: apt-get install tetgen qhull-bin libcgal-dev cmake g++
#
# Made with tetgen 1.5.0-5, qhull-bin 2020.2-5 and libcgal-dev 5.5.1-2 of Debian 12 on amd64.
set -eu

peers=$(cd "$(dirname "$0")/../peers" && pwd)
cgal_sources=$(cd "$(dirname "$0")/cgal" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# run FILE COMMAND...: its output goes to FILE; a failure is noted in NAME.failed.
run() {
  output=$1
  shift
  status=0
  timeout 10 "$@" >"$output" 2>"$work/stderr" || status=$?
  return $status
}

note_failure() {  # FILE STATUS: the last line that says something, without addresses that differ from run to run
  { echo "exit code $2"; cat "$work/stderr" "$work/output" | grep -E 'rror|terminate|Assert' | head -1 | sed 's/0x[0-9a-f]*//g'; } >"$1"
}

tetgen_run() {  # NAME
  cp "$peers/inputs/$1.node" .
  status=0
  run output tetgen -n "$1.node" || status=$?
  if [ -s "$1.1.ele" ]; then
    cp "$1.1.node" "$1.1.ele" "$1.1.neigh" "$peers/tetgen/"
  else
    note_failure "$peers/tetgen/$1.failed" $status
  fi
}

qhull_run() {  # NAME OPTIONS SUFFIX
  awk '{ sub(/#.*/, "") } NF == 0 { next } !n { n = $1; d = $2; print d; print n; next }
       { line = $2; for (i = 3; i <= d + 1; ++i) line = line " " $i; print line }' \
    "$peers/inputs/$1.node" >points
  status=0
  run output qdelaunay $2 i <points || status=$?
  if [ $status -eq 0 ]; then
    cp points "$peers/qhull/$1$3.qhull"
    cp output "$peers/qhull/$1$3.qhull-i"
  else
    note_failure "$peers/qhull/$1$3.failed" $status
  fi
}

cgal_run() {  # NAME DIMENSION [--inexact SUFFIX]
  rm -f out.ele
  status=0
  run output "$work/build/delaunay_$2" ${3:-} "$peers/inputs/$1.node" out.ele || status=$?
  if [ $status -eq 0 ]; then
    cp "$peers/inputs/$1.node" "$peers/cgal/$1${4:-}.node"
    cp out.ele "$peers/cgal/$1${4:-}.ele"
  else
    note_failure "$peers/cgal/$1${4:-}.failed" $status
  fi
}

cmake -S "$cgal_sources" -B "$work/build" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$work/build" >/dev/null
rm -rf "$peers/tetgen" "$peers/qhull" "$peers/cgal"
mkdir -p "$peers/tetgen" "$peers/qhull" "$peers/cgal"

for input in "$peers"/inputs/*.node; do
  name=$(basename "$input" .node)
  dimension=$(awk 'NR == 1 { print $2 }' "$input")
  if [ "$dimension" = 3 ]; then tetgen_run "$name"; fi
  qhull_run "$name" Qt ""
  qhull_run "$name" "Qt Qz" --point-at-infinity
  qhull_run "$name" QJ --joggled
  if [ "$dimension" -le 3 ]; then
    cgal_run "$name" "$dimension"
    cgal_run "$name" "$dimension" --inexact --inexact-kernel
  fi
done
