#!/bin/bash
# Holds logged.sh, and `make demo`, which runs its first steps with it, to what they promise:
#   cmake/logged_test.sh
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "logged_test: $1" >&2
  exit 1
}

echo "a step that succeeds is one line, whatever it prints"
"$root/cmake/logged.sh" "$work/new/log" "a loud step" bash -c 'seq 1000; seq 500 >&2' >"$work/out" 2>"$work/err"
[ "$(wc -l <"$work/out")" -eq 1 ] || fail "expected one line, found $(cat "$work/out")"
[ ! -s "$work/err" ] || fail "expected nothing on stderr"
grep -q "^a loud step … [0-9]* s$" "$work/out" || fail "expected the step and its time"
[ "$(grep -c '^[0-9]' "$work/new/log")" -eq 1500 ] || fail "expected all that it printed in the log"

echo "a step that fails shows the end of its own output, says where the rest is, and keeps its exit code"
code=0
"$root/cmake/logged.sh" "$work/new/log" "a bad step" bash -c 'seq 2000 2099; echo the reason >&2; exit 7' \
  >"$work/out" 2>"$work/err" || code=$?
[ $code -eq 7 ] || fail "expected exit code 7, found $code"
grep -q "failed after" "$work/out" || fail "expected to be told that it failed"
[ "$(tail -n 1 "$work/out")" = "the reason" ] || fail "expected the end of what it printed"
[ "$(wc -l <"$work/out")" -lt 40 ] || fail "expected only the end of what it printed"
grep -q "$work/new/log" "$work/err" || fail "expected the name of the log"
"$root/cmake/logged.sh" "$work/new/log" "a short step" bash -c 'echo short; exit 1' >"$work/out" 2>&1 || true
! grep -q "the reason" "$work/out" || fail "expected nothing of the step before"

echo "make demo: a step that fails ends it, in few lines"
mkdir "$work/bin"
printf '#!/bin/sh\nseq 300\necho "no such compiler" >&2\nexit 1\n' >"$work/bin/cmake"
chmod +x "$work/bin/cmake"
cp -r "$root/Makefile" "$root/cmake" "$work/"
code=0
PATH="$work/bin:$PATH" env -u MAKEFLAGS -u MAKELEVEL make -C "$work" --no-print-directory demo >"$work/out" 2>&1 || code=$?
[ $code -ne 0 ] || fail "expected make demo to fail"
grep -q "no such compiler" "$work/out" || { cat "$work/out"; fail "expected the reason"; }
grep -q "build/demo.log" "$work/out" || fail "expected the name of the log"
[ "$(wc -l <"$work/out")" -lt 45 ] || { cat "$work/out"; fail "expected few lines"; }
