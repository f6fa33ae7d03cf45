#!/bin/bash
# Runs fuzz targets on their seeds and on so many new inputs each (0: until the time is over), the
# same on every run:
#   fuzz/targets/run.sh TARGET-OR-FOLDER RUNS [MAX_SECONDS]
# TARGET is a fuzzer, FOLDER one that has them all, such as build/sanitize/fuzz. Exits 1 at the
# first finding, which stays in a folder that is named, and says how to repeat it. SEED=… draws
# other inputs. TOTALS=FILE adds to a table, a line for each target of each build: inputs run so far
# in all, and the most edges and features that a run came across. CORPUS=FOLDER begins with the
# inputs that former runs kept there, and leaves there a smallest set that covers as much.
set -euo pipefail

[ $# -ge 2 ] || { echo "usage: fuzz/targets/run.sh TARGET-OR-FOLDER RUNS [MAX_SECONDS]" >&2; exit 2; }
runs=$2
seconds=${3:-60}
sources=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
if [ -d "$1" ]; then
  targets=("$1"/*_fuzz)
else
  targets=("$1")
fi

[ "$runs" -gt 0 ] || runs=-1  # libFuzzer's word for any number
for target in "${targets[@]}"; do
  [ -x "$target" ] || { echo "fuzz/targets/run.sh: expected a fuzz target, found $target" >&2; exit 2; }
  name=$(basename "$target")
  build=$(basename "$(dirname "$(dirname "$(realpath "$target")")")")  # build/sanitize/fuzz/NAME is of `sanitize`
  work=$(mktemp -d)
  mkdir "$work/corpus"
  kept=${CORPUS:+$CORPUS/$name}
  [ -z "$kept" ] || { mkdir -p "$kept" && cp -R "$kept/." "$work/corpus/"; }
  dictionary=()
  [ ! -f "$sources/$name.dict" ] || dictionary=("-dict=$sources/$name.dict")
  status=0
  # New inputs go to the first folder; the seeds stay as they are. Whatever a seed, a run is at most
  # 25 s.
  "$target" -runs="$runs" -seed="${SEED:-20260101}" -max_total_time="$seconds" -timeout=25 -rss_limit_mb=2048 \
    -artifact_prefix="$work/" -print_final_stats=1 "${dictionary[@]}" "$work/corpus" \
    "$sources/seeds/$name" >"$work/log" 2>&1 || status=$?
  if [ "$status" -ne 0 ]; then
    tail -n 60 "$work/log"
    echo "fuzz/targets/run.sh: $name failed; its input is in $work. To repeat it: $target $work/crash-*" >&2
    exit 1
  fi
  inputs=$(grep -o 'stat::number_of_executed_units: *[0-9]*' "$work/log" | grep -o '[0-9]*$')
  edges=$(grep -o 'cov: [0-9]*' "$work/log" | tail -n 1 | grep -o '[0-9]*$' || echo 0)
  features=$(grep -o 'ft: [0-9]*' "$work/log" | tail -n 1 | grep -o '[0-9]*$' || echo 0)
  if [ -n "${TOTALS:-}" ]; then
    [ -f "$TOTALS" ] || printf '# What make soak-fuzz has run: target, build, inputs, edges, features\n' >"$TOTALS"
    awk -F '\t' -v OFS='\t' -v CONVFMT='%.0f' -v OFMT='%.0f' -v name="$name" -v build="$build" -v inputs="$inputs" -v edges="$edges" \
        -v features="$features" '
      $1 == name && $2 == build {
        $3 += inputs; if (edges + 0 > $4) $4 = edges; if (features + 0 > $5) $5 = features; found = 1
      }
      { print }
      END { if (!found) print name, build, inputs, edges, features }' "$TOTALS" >"$work/totals"
    cat "$work/totals" >"$TOTALS"
  fi
  if [ -n "$kept" ]; then
    mkdir "$work/smallest"
    "$target" -merge=1 -timeout=25 -rss_limit_mb=2048 "$work/smallest" "$work/corpus" >"$work/log" 2>&1
    rm -rf "$kept" && cp -R "$work/smallest" "$kept"
  fi
  echo "$name: $inputs inputs, $edges edges, $(grep -c . < <(ls "$work/corpus")) inputs kept, nothing found"
  rm -rf "$work"
done
