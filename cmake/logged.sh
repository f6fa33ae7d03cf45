#!/bin/bash
# Runs a step whose output nobody reads unless it fails:
#   cmake/logged.sh LOG WHAT COMMAND [ARGUMENT...]
# Prints one line with WHAT and how long it took; what the command prints is added to LOG. If the
# command fails, the end of that is printed, and where the rest is; the exit code is the command's.
set -uo pipefail

if [ $# -lt 3 ]; then
  echo "usage: cmake/logged.sh LOG WHAT COMMAND [ARGUMENT...]" >&2
  exit 2
fi
log=$1
what=$2
shift 2
shown=30

mkdir -p "$(dirname "$log")" && touch "$log" || exit 2
before=$(wc -l <"$log")
printf '%s …' "$what"
SECONDS=0
code=0
{
  printf '\n# %s: %s\n' "$what" "$*"
  "$@"
} >>"$log" 2>&1 </dev/null || code=$?
if [ $code -eq 0 ]; then
  printf ' %d s\n' "$SECONDS"
  exit 0
fi
said=$(($(wc -l <"$log") - before - 2))
printf ' failed after %d s (exit code %d). The end of %s:\n\n' "$SECONDS" "$code" "$log"
tail -n "$((said < shown ? said : shown))" "$log"
printf '\n%s failed: %s has all that it printed.\n' "$what" "$log" >&2
exit $code
