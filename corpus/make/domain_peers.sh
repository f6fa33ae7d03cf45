#!/bin/sh
# Runs TetGen on corpus/domains/*.poly and surfaces/*.off, Gmsh on *.geo, and keeps what they write,
# unchanged.
# Running it again, with the same versions, gives the same files. Where a program makes no mesh,
# NAME.failed holds its exit code and the last thing it said.
#
#   corpus/make/domain_peers.sh        needs: apt-get install tetgen gmsh
#
# Made with tetgen 1.5.0-5 and gmsh 4.8.4 of Debian 12 on amd64.
set -eu

domains=$(cd "$(dirname "$0")/../domains" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir -p "$domains/tetgen" "$domains/gmsh"
rm -f "$domains/tetgen/"* "$domains/gmsh/"*

note_failure() {  # FILE STATUS: without addresses and times, which differ from run to run
  { echo "exit code $2"; grep -iE 'error|assert|terminate' log | head -1 | sed 's/0x[0-9a-f]*//g'; } >"$1"
}

run_tetgen() {  # OPTION FILE KEPT
  input=$3.${2##*.}
  cp "$domains/$2" "$input"
  status=0
  timeout 10 tetgen "$1" "$input" >log 2>&1 || status=$?
  if [ -s "$3.1.ele" ]; then
    cp "$3.1.node" "$3.1.ele" "$3.1.face" "$3.1.edge" "$domains/tetgen/"
  else
    note_failure "$domains/tetgen/$3.failed" $status
  fi
}

run_gmsh() {  # NAME KEPT OPTION...
  name=$1 kept=$2
  shift 2
  status=0
  timeout 30 gmsh -3 -nt 1 "$@" -format mesh -o mesh.mesh "$domains/$name.geo" >log 2>&1 || status=$?
  if [ $status -eq 0 ]; then
    mv mesh.mesh "$domains/gmsh/$kept.mesh"
  else
    note_failure "$domains/gmsh/$kept.failed" $status
  fi
}

for path in "$domains"/*.poly; do
  name=$(basename "$path" .poly)
  [ "$(awk '!/^#/ { print $2; exit }' "$path")" = 3 ] || continue
  run_tetgen -p "$name.poly" "$name"
done
for name in joint pig; do
  run_tetgen -p "surfaces/$name.off" "$name"
done
for name in figure-4-10-schonhardt fan-of-rooms hollow-cube internal-square l-prism one-segment slits tunnel two-rooms; do
  run_tetgen -pq1.4 "$name.poly" "$name--quality"
done
run_tetgen -pq1.4O0 one-segment.poly one-segment--unoptimized
for name in dangling-square figure-4-10-schonhardt l-prism tunnel; do
  run_tetgen -pc "$name.poly" "$name--hull"
done

for path in "$domains"/*.geo; do
  name=$(basename "$path" .geo)
  run_gmsh "$name" "$name"
done
run_gmsh l-prism l-prism--finer -clmax 2
run_gmsh tunnel tunnel--finer -clmax 2
run_gmsh two-rooms two-rooms--finer -clmax 1
run_gmsh thin-wedge thin-wedge--tolerance -setnumber Mesh.AngleToleranceFacetOverlap 0.001
