#!/bin/bash
# Installs the wheel into a bare Debian 13 by the words of docs/python.md, and judges there:
#   packaging/wheel_root_test.sh DIST
# DIST is the folder with the wheel that packaging/wheel.sh made.
set -euo pipefail
dist=$(realpath "${1:?usage: packaging/wheel_root_test.sh DIST}")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$here/packaging/bare_root.sh"

wheel=$(ls "$dist"/circumspect-*-cp311-abi3-manylinux*.whl)
make_bare_root trixie
cp -r "$here/corpus/peers/tetgen" "$bare/root/"
cp "$wheel" "$bare/root/"
quietly inside "apt-get update"

# The two commands of the page.
words=$(sed -n '/^sudo apt install python3-venv/,/pip install/p' "$here/docs/python.md" | sed "s/^sudo //; s/apt install/apt-get install -q -y --no-install-recommends/")
[ "$(wc -l <<<"$words")" -eq 2 ] || fail "expected two commands in docs/python.md, found: $words"
start=$(date +%s.%N)
quietly inside "$words"
seconds=$(awk -v a="$start" -v b="$(date +%s.%N)" 'BEGIN { printf "%.1f", b - a }')
inside "! command -v cc c++ gcc g++ cmake" || fail "expected no compiler"
echo "two commands took $seconds s on $(inside 'python3 --version'), without a compiler"

cat >"$bare/root/judge.py" <<'PYTHON'
import subprocess
import sys
import timeit
from fractions import Fraction

import circumspect
import numpy

points = numpy.array([[0, 0], [1, 0], [0, 1], [0.9, 0.9]])
assert circumspect.check(points, numpy.array([[0, 1, 3], [0, 3, 2]]))
wrong = circumspect.check(points, numpy.array([[0, 1, 2], [1, 3, 2]], dtype=numpy.int32))
assert wrong.rules == {"delaunay.facet-not-local": 1} and wrong.violations[0].ball.squared_radius == Fraction(1, 2), wrong
assert "<html" in wrong.to_html()
assert circumspect.orient((0.1, 0.1), (0.2, 0.2), (0.3, 0.3)) == 0
assert not circumspect.campaign(lambda p: [[0, 1, 2]], dimension=2, cases=50)
built = circumspect.delaunay(circumspect.generate("sphere", points=50))
assert built.shape[1] == 4


def least(call, times):
    return min(timeit.repeat(call, number=times, repeat=9)) / times


corners = ((0.0, 0.0), (1.0, 0.25), (0.5, 1.0))
orient = least(lambda: circumspect.orient(*corners), 10000) * 1e6
command = [sys.executable, "-c", "import circumspect"]
nothing = [sys.executable, "-c", "import json"]
imported = (least(lambda: subprocess.run(command, check=True), 1) - least(lambda: subprocess.run(nothing, check=True), 1)) * 1e3
print(f"orient takes {orient:.2f} µs, import {imported:.0f} ms beside Python's start")
assert orient <= 2 and imported <= 30, "expected at most 2 µs and 30 ms"
PYTHON
quietly inside "env/bin/python judge.py"
cat "$work/log"
# What is in the package and in NumPy stays out: the extension alone, by the loader's own word.
inside 'ldd env/lib/python3*/site-packages/circumspect/_core.abi3.so' | awk '{ print $1 }' | sort >"$work/libraries"
if grep -vE '^(linux-vdso|libc|libm|libgcc_s|libstdc\+\+|/lib64/ld-linux-x86-64)\.so' "$work/libraries"; then
  fail "expected an extension that needs the C library alone"
fi

good=tetgen/random-3d-500.1.ele
bad=tetgen/hunted-tetgen-covered-twice-3d.1.ele
for command in env/bin/circumspect "env/bin/python -m circumspect"; do
  quietly inside "$command check $good"
  grep -q "^holds: delaunay $good 500 points 3074 tetrahedra unique canonical" "$work/log" || fail "$command: expected a verdict"
  code=0
  inside "$command check $bad" >"$work/log" 2>&1 || code=$?
  [ $code -eq 1 ] || fail "$command: expected exit code 1, found $code"
  grep -q "^fails: delaunay $bad triangulation.covered-twice" "$work/log" || fail "$command: expected a witness"
done
quietly inside "env/bin/circumspect certify $good -o certificate && env/bin/circumspect-verified certificate ${good%.ele}.node $good"
grep -q "^verified: delaunay, 500 points, 3074 tetrahedra, unique, canonical" "$work/log" || fail "expected a verified certificate"
# A campaign runs programs, which is the most that the command does with a process.
code=0
inside "env/bin/circumspect campaign --cases 5 --minimize-runs 20 --families integers --full-dimension --output found -- false {points} {mesh}" \
  >"$work/log" 2>&1 || code=$?
[ $code -eq 1 ] || { cat "$work/log"; fail "expected that a campaign finds a program that fails, found exit code $code"; }
inside "env/bin/circumspect generate uniform --points 2000000 | head -n 1" >"$work/log" 2>&1
if grep -qi traceback "$work/log"; then fail "expected that a closed pipe ends the command as any other"; fi
# GitLab's lines, as its runner runs them in an image of Python; there is no NumPy.
lines() { sed -n "/^  $1:/,/^  [a-z]*:/{s/^    - //p}" "$here/docs/gitlab-ci.yml"; }
quietly inside "apt-get install -q -y --no-install-recommends git pre-commit && python3 -m venv gitlab"
for mesh in $good:0 $bad:1; do
  code=0
  inside "export PATH=/root/gitlab/bin:\$PATH CIRCUMSPECT_WHEEL=\$(ls ./*.whl) CIRCUMSPECT_OUTPUT=report CIRCUMSPECT_ARGUMENTS=${mesh%:*}
    $(lines before_script)
    $(lines script)" >"$work/log" 2>&1 || code=$?
  [ "$code" -eq "${mesh#*:}" ] || { cat "$work/log"; fail "expected that GitLab's lines end with ${mesh#*:}, found $code"; }
done
for file in junit.xml report.sarif page.html; do [ -s "$bare/root/report/$file" ] || fail "expected $file of GitLab's lines"; done
echo "GitLab's lines judge"

# A commit of meshes, which the hook judges; pip may take nothing from an index.
mkdir "$bare/root/meshes"
sed "s|circumspect==[0-9.]*|/root/${wheel##*/}|" "$here/docs/pre-commit-config.yaml" >"$bare/root/meshes/.pre-commit-config.yaml"
# commits MESH: the exit code of git
commits() {
  inside "cd meshes && cp ../tetgen/$(basename "$1" .ele).* . && git add . && export PIP_NO_INDEX=1 PIP_NO_DEPS=1 && git commit -q -m meshes" \
    >"$work/log" 2>&1 && echo 0 || echo $?
}
quietly inside "cd meshes && git init -q && git config user.name n && git config user.email e@example.org && pre-commit install"
[ "$(commits $good)" = 0 ] || { cat "$work/log"; fail "expected that the hook lets a right mesh pass"; }
[ "$(commits $bad)" = 1 ] || { cat "$work/log"; fail "expected that the hook refuses a wrong mesh"; }
grep -q "^fails: delaunay .*triangulation.covered-twice" "$work/log" || { cat "$work/log"; fail "expected that the hook says why"; }
echo "the hook of pre-commit judges"

quietly inside "env/bin/pip show --files circumspect"
for file in licences/libgmp-dev licences/ocaml licences/libcadical-dev py.typed; do
  grep -q "$file" "$work/log" || fail "expected $file in the wheel"
done
quietly inside "env/bin/pip uninstall -q -y circumspect && test -z \"\$(find env -name '*circumspect*')\""
echo "wheel_root_test: ${wheel##*/} judges in a bare Debian 13"
