#!/bin/bash
# What the GitHub Action (action.yml) does:
#   CIRCUMSPECT_RUN=check CIRCUMSPECT_ARGUMENTS='mesh.1.ele' CIRCUMSPECT_OUTPUT=report action/run.sh
# The command is CIRCUMSPECT_COMMAND, or is in the archive CIRCUMSPECT_TARBALL, or is built from
# these sources. The exit code is the command's. CIRCUMSPECT_OUTPUT gets junit.xml and report.sarif;
# a campaign also puts its findings there.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
run=${CIRCUMSPECT_RUN:-check}
output=${CIRCUMSPECT_OUTPUT:-circumspect-report}
command=${CIRCUMSPECT_COMMAND:-}
tarball=${CIRCUMSPECT_TARBALL:-}

fail() {
  echo "::error title=circumspect::$1"
  exit 2
}

case $run in
  check | campaign) ;;
  *) fail "expected 'check' or 'campaign' for the input 'run', found '$run'" ;;
esac

if [ -z "$command" ] && [ -n "$tarball" ]; then
  unpacked=${RUNNER_TEMP:-/tmp}/circumspect-unpacked
  rm -rf "$unpacked"
  mkdir -p "$unpacked"
  case $tarball in
    https://*) curl --fail --silent --show-error --location "$tarball" | tar -xz -C "$unpacked" ;;
    *) tar -xzf "$tarball" -C "$unpacked" ;;
  esac
  command=$(echo "$unpacked"/*/bin/circumspect)
elif [ -z "$command" ]; then
  echo "::group::Building circumspect"
  make -C "$here/.." build
  echo "::endgroup::"
  command=$here/../build/release/bin/circumspect
fi
[ -x "$command" ] || fail "expected the command at $command, found none"

# The user's own words, as a shell splits them, and nothing that they could start: no $ and no ` is
# looked at.
words=$(xargs -r -n1 printf '%s\n' <<<"${CIRCUMSPECT_ARGUMENTS:-}") ||
  fail "expected words and whole quotes in the input 'arguments', found: ${CIRCUMSPECT_ARGUMENTS:-}"
[ -n "$words" ] || fail "expected what stands behind 'circumspect $run' in the input 'arguments', found nothing"
mapfile -t arguments <<<"$words"

mkdir -p "$output"
echo "::add-matcher::$here/problem-matcher.json"
code=0
if [ "$run" = campaign ]; then
  "$command" campaign --output "$output" --junit "$output/junit.xml" --sarif "$output/report.sarif" \
    --html "$output/page.html" --annotations "${arguments[@]}" >"$output/log.txt" || code=$?
else
  "$command" check --junit "$output/junit.xml" --sarif "$output/report.sarif" "${arguments[@]}" \
    >"$output/log.txt" || code=$?
fi
# What a mesh or a program is called gives the runner no commands.
token=$(head -c 16 /dev/urandom | od -An -tx1 | tr -d ' ')
echo "::stop-commands::$token"
grep -v '^::error ' "$output/log.txt" || true
echo "::$token::"
grep '^::error ' "$output/log.txt" || true
verdict=$(tail -n 1 "$output/log.txt")
{
  echo "exit-code=$code"
  echo "verdict=$verdict"
} >>"${GITHUB_OUTPUT:-/dev/null}"
# The verdicts, where the summary of the job shows them; a name of a file cannot end the block.
{
  echo "### circumspect $run"
  printf '~~~~~~~~\n%s\n~~~~~~~~\n' "$(grep -E '^(holds|fails|undecided): ' "$output/log.txt" || true)"
} >>"${GITHUB_STEP_SUMMARY:-/dev/null}"
exit "$code"
