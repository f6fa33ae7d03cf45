#!/bin/bash
# Runs fuzz targets on their seeds and on so many new inputs each (0: until the time is over), the same on
# every run:
#   fuzz/targets/run.sh TARGET-OR-FOLDER RUNS [MAX_SECONDS]
# TARGET is a fuzzer, FOLDER one that has them all, such as build/sanitize/fuzz. Exits 1 at the first
# finding, which stays in a folder that is named, and says how to repeat it. SEED=… draws other inputs.
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
  work=$(mktemp -d)
  mkdir "$work/corpus"
  dictionary=()
  [ ! -f "$sources/$name.dict" ] || dictionary=("-dict=$sources/$name.dict")
  status=0
  # New inputs go to the first folder; the seeds stay as they are. Whatever a seed, a run is at most 25 s.
  "$target" -runs="$runs" -seed="${SEED:-20260101}" -max_total_time="$seconds" -timeout=25 -rss_limit_mb=2048 \
    -artifact_prefix="$work/" -print_final_stats=1 "${dictionary[@]}" "$work/corpus" \
    "$sources/seeds/$name" >"$work/log" 2>&1 || status=$?
  if [ "$status" -ne 0 ]; then
    tail -n 60 "$work/log"
    echo "fuzz/targets/run.sh: $name failed; its input is in $work. To repeat it: $target $work/crash-*" >&2
    exit 1
  fi
  echo "$name: $(grep -o 'stat::number_of_executed_units: *[0-9]*' "$work/log" | grep -o '[0-9]*$')" \
       "inputs, $(grep -c . < <(ls "$work/corpus")) new ones kept, nothing found"
  rm -rf "$work"
done
