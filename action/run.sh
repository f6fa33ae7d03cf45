#!/bin/bash
# What the GitHub Action (action.yml) does:
#   CIRCUMSPECT_RUN=check CIRCUMSPECT_ARGUMENTS='mesh.1.ele' CIRCUMSPECT_OUTPUT=report action/run.sh
# The command is CIRCUMSPECT_COMMAND, or is in the archive CIRCUMSPECT_TARBALL, or is in what pip
# installs for CIRCUMSPECT_WHEEL, into a folder that a runner keeps: nothing is compiled. The exit
# code is the command's. CIRCUMSPECT_OUTPUT gets junit.xml, report.sarif and page.html; a campaign
# also puts its findings there.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
run=${CIRCUMSPECT_RUN:-check}
output=${CIRCUMSPECT_OUTPUT:-circumspect-report}
command=${CIRCUMSPECT_COMMAND:-}
tarball=${CIRCUMSPECT_TARBALL:-}
wheel=${CIRCUMSPECT_WHEEL:-}

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
elif [ -z "$command" ] && [ -n "$wheel" ]; then
  # Another wheel of the same name is another folder. The command needs no NumPy.
  key=$({ printf '%s\n' "$wheel"; if [ -f "$wheel" ]; then cat "$wheel"; fi; } | sha256sum | cut -c 1-16)
  installed=${RUNNER_TOOL_CACHE:-${RUNNER_TEMP:-/tmp}}/circumspect-$key
  if [ ! -x "$installed/bin/circumspect" ]; then
    echo "::group::Installing $wheel"
    mkdir -p "$installed/bin"
    python3 -m pip install --quiet --disable-pip-version-check --no-deps --target "$installed/lib" -- "$wheel" ||
      { rm -rf "$installed"; fail "expected a wheel that pip installs, found none for '$wheel': give its path or address as \`wheel\`, or an archive as \`tarball\`"; }
    # What the programs of a campaign import is none of ours: no PYTHONPATH.
    printf "#!/bin/sh\nexec python3 -c \"import sys; sys.path.insert(0, '%s/lib'); from circumspect.__main__ import run; run()\" \"\$@\"\n" \
      "$installed" >"$installed/bin/circumspect"
    chmod +x "$installed/bin/circumspect"
    echo "::endgroup::"
  fi
  command=$installed/bin/circumspect
elif [ -z "$command" ]; then
  fail "expected a wheel, a tarball or a command to judge by, found none"
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
  "$command" check --junit "$output/junit.xml" --sarif "$output/report.sarif" --html "$output/page.html" \
    "${arguments[@]}" >"$output/log.txt" || code=$?
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
