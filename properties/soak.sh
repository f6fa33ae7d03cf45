#!/bin/bash
# A soak for as long as one likes: every property and every soak test, round after round, each round
# on inputs that no run has seen before, until the minutes are over or one of them fails.
#
#     properties/soak.sh BUILD_FOLDER [MINUTES]        by default 30; `make soak` builds first
#
# What runs: the tests that `ctest` labels `property` or `soak`, those for soaking last, so that a
# short soak sees every property once. Each round draws a seed and gives it to RapidCheck
# (RC_PARAMS), as many tests as there are processors run at a time, and a round begins when the last
# test of the one before has been started. When the time is up, the tests that are running are
# stopped and count as cut off, neither passed nor failed; their cases so far count as cases.
#
# A property may insist that some kind of input occurs (`occurs` in properties/arguments/run.hpp).
# That is a fact about the fixed inputs of `make test`; CIRCUMSPECT_SOAK in the environment takes
# the question back.
#
# Exit 0: the time is up and nothing failed. Exit 1: something failed; its output, its seed and the
# command that repeats it are printed. Exit 2: wrong usage, nothing to run.
#
# This script is not a test of ctest's: `ctest -L soak` (or `--preset soak`) runs each soak test
# once, at its full length of some minutes, which is a long run by itself and has an end of its own.
set -uo pipefail

usage() {
  echo "usage: properties/soak.sh BUILD_FOLDER [MINUTES], $1" >&2
  exit 2
}

[[ $# -eq 1 || $# -eq 2 ]] || usage "found $# arguments"
build=$1
minutes=${2:-30}
[[ -f $build/CTestTestfile.cmake ]] || usage "and '$build' holds no build with tests"
[[ $minutes =~ ^[0-9]+$ && $((10#$minutes)) -gt 0 ]] || usage "expected whole minutes, found '$minutes'"
minutes=$((10#$minutes))
processors=$(nproc)

# One line a test: its seconds at most, its name, its command, separated by tabs. The limits of
# ctest are for a quarter of the inputs (CIRCUMSPECT_ONE_INPUT_IN); here all are tried.
list_tests() {
  ctest --test-dir "$build" --show-only=json-v1 -L '^(property|soak)$' | python3 -c '
import json, sys
lines = []
for test in json.load(sys.stdin)["tests"]:
    facts = {fact["name"]: fact["value"] for fact in test["properties"]}
    line = "\t".join([str(4 * round(facts["TIMEOUT"])), test["name"], *test["command"]])
    lines.append(("soak" in facts["LABELS"], line))
for _, line in sorted(lines, key=lambda pair: pair[0]):
    print(line)'
}

mapfile -t tests < <(list_tests)
[[ ${#tests[@]} -gt 0 ]] || usage "and '$build' holds no property and no soak test"

logs=$(mktemp -d)
declare -A running=()  # process -> "seed name", one of each test under way
alarm=
# Each test leads a process group (timeout sees to that), so that what it has started ends with it.
stop_everything() {
  local process
  for process in "${!running[@]}"; do kill -TERM -- "-$process" 2>/dev/null; done
  [[ -z $alarm ]] || kill "$alarm" 2>/dev/null
  wait 2>/dev/null
}
trap 'stop_everything; rm -rf "$logs"' EXIT
trap 'echo "soak: interrupted" >&2; exit 130' INT TERM

rounds=0
next=${#tests[@]}  # the test to start; past the last one: a new round
seed=
passed=0
cases=0

# RapidCheck's verbose progress is a dot for each case that held; x is a discarded one.
count_cases() { cases=$((cases + $(grep -xE '[.x]+' "$1" | tr -cd . | wc -c))); }

start_test() {
  local seconds name command
  if [[ $next -ge ${#tests[@]} ]]; then
    next=0
    rounds=$((rounds + 1))
    seed=$(od -An -N8 -tu8 /dev/urandom | tr -d ' ')
    printf 'soak: round %d, seed %s, after %d s\n' "$rounds" "$seed" "$SECONDS"
  fi
  IFS=$'\t' read -r -a command <<<"${tests[next]}"
  seconds=${command[0]}
  name=${command[1]}
  TMPDIR=$logs CIRCUMSPECT_SOAK=1 RC_PARAMS="seed=$seed verbose_progress=1" \
    nice timeout "$seconds" "${command[@]:2}" >"$logs/$seed ${name//\//:}" 2>&1 &
  running[$!]="$seed $name"
  next=$((next + 1))
}

# end_test PROCESS STATUS: one test has ended; does not come back if it failed.
end_test() {
  local seed=${running[$1]%% *} name=${running[$1]#* } log why
  log="$logs/$seed ${name//\//:}"
  unset "running[$1]"
  count_cases "$log"
  # A file in which no test case ran has tested nothing, as in cmake/layers.cmake; 124 is timeout's.
  case $2 in
    0) grep -qE 'test cases: +0 ' "$log" && why="ran no test case" ;;
    124) why="ran out of time" ;;
    *) why="exit code $2" ;;
  esac
  if [[ -z ${why-} ]]; then
    passed=$((passed + 1))
    rm "$log"
    return
  fi
  grep -vxE '[.x]+' "$log"
  printf '\nsoak: FAILED: %s, %s, seed %s\n' "$name" "$why" "$seed"
  printf 'soak: again: CIRCUMSPECT_SOAK=1 RC_PARAMS=seed=%s ctest --test-dir %q -R '\''^%s$'\'' --output-on-failure\n' \
    "$seed" "$build" "$name"
  summary
  exit 1
}

summary() {
  printf 'soak: %d rounds begun, %d test runs passed, %d RapidCheck cases, %d minutes %d seconds\n' \
    "$rounds" "$passed" "$cases" $((SECONDS / 60)) $((SECONDS % 60))
}

printf 'soak: %d tests, %d at a time, for %d minutes\n' "${#tests[@]}" "$processors" "$minutes"
SECONDS=0
sleep $((minutes * 60)) &
alarm=$!
while true; do
  while [[ ${#running[@]} -lt $processors ]]; do start_test; done
  wait -n -p ended "$alarm" "${!running[@]}"
  status=$?
  [[ $ended -ne $alarm ]] || break
  end_test "$ended" "$status"
done
alarm=

# The time is up. What has failed at this very moment has failed all the same.
cut=0
for process in "${!running[@]}"; do
  kill -TERM -- "-$process" 2>/dev/null
  wait "$process"
  status=$?
  if [[ $status -eq 143 || $status -eq 124 ]]; then
    count_cases "$logs/${running[$process]//\//:}"
    unset "running[$process]"
    cut=$((cut + 1))
  else
    end_test "$process" "$status"
  fi
done
summary
printf 'soak: nothing failed; %d tests were cut off by the end of the time\n' "$cut"
