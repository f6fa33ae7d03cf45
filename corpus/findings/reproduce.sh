#!/bin/sh
# Runs a program again on an input on which it was wrong, and judges what it writes:
#
#     corpus/findings/reproduce.sh              the names
#     corpus/findings/reproduce.sh NAME
#
# Needs `circumspect` (or CIRCUMSPECT=…) and the program; `peer` and `checked_by` are made by the
# tests and found in build/release/tests; libraries that hunt calls are looked for in the folder
# BUILDS. Exit code 0 would mean that the fault is gone.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
PATH=$PATH:$here/../../build/release/bin:$here/../../build/release/tests
if [ $# -ne 1 ]; then
  cut -f 1-3 "$here/expected.tsv"
  exit 2
fi
row=$(awk -F '\t' -v name="$1" '$1 == name' "$here/expected.tsv")
if [ -z "$row" ]; then
  echo "$1: expected a name of expected.tsv" >&2
  exit 2
fi
field() { printf '%s\n' "$row" | cut -f "$1"; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
input=$(field 4)
cp "$here/${input%.*}".* .
given=$(field 5)
[ "$given" = - ] || case $(field 6) in *" -rCC "*) ;; *) rm -f "$given" ;; esac

command=$(field 6)
echo "$command"
case $command in
  hunt.py*)
    : "${BUILDS:?expected BUILDS to be the folder with the libraries, as hunt/README.md tells}"
    command="python3 $here/../../hunt/$command --builds $BUILDS"
    memory=unlimited seconds=120
    ;;
  *) memory=4194304 seconds=10 ;;
esac
code=0
# -k: the program itself gets a signal that ends it, and so does whatever the shell started besides.
(ulimit -v $memory; timeout -k 1 $seconds sh -c "$command") || code=$?
[ $code -eq 0 ] || { echo "it ended with exit code $code; found: $(field 3)"; exit 1; }
set -- $(field 2)
claim=$1
case $claim in
  delaunay | convex-hull) of="--points $input" ;;
  voronoi) of="--points $input --within $2" ;;
  *) of="--domain $input --domain-kind ${2:-enclosed}" ;;
esac
exec "${CIRCUMSPECT:-circumspect}" check "$given" --claim "$claim" $of
