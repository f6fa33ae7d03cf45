#!/bin/bash
# Packs the sources as `python3 -m build --sdist` does, and looks whether the archive has all that
# compiles the module:
#   python/sdist_test.sh BUILD [PYTHON]
# BUILD has built circumspect_python, as build/release has, and so knows which files that read. With
# --build, the module is compiled from the archive, which takes minutes, and installed.
set -euo pipefail

build=$(realpath "${1:?usage: python/sdist_test.sh BUILD [PYTHON] [--build]}")
python=${2:-python3}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

quietly() {
  "$@" >"$work/log" 2>&1 || { cat "$work/log"; echo "sdist_test: failed: $*" >&2; exit 1; }
}

# What setuptools leaves behind it leaves in a copy, which has what a clone has.
mkdir "$work/sources"
cd "$root"
find . -path ./build -prune -o -path ./.git -prune -o -type f -print0 | xargs -0 cp --parents -t "$work/sources"
cd "$work/sources"
quietly "$python" -m build --sdist --no-isolation --outdir "$work/archives" .
tar -xzf "$work"/archives/*.tar.gz -C "$work"
unpacked=$(echo "$work"/circumspect-*/)

"$python" - "$build" "$root" "$unpacked" <<'PYTHON'
import pathlib
import subprocess
import sys

build, root, unpacked = map(pathlib.Path, sys.argv[1:])


def ninja(*arguments):
    return subprocess.run(["ninja", "-C", build, *arguments], capture_output=True, text=True, check=True).stdout


made_of = set(ninja("-t", "inputs", "circumspect_python", "circumspect_cli").split("\n"))
files, reads = {name for name in made_of if name}, False
for line in ninja("-t", "deps").split("\n"):
    if not line.startswith(" "):
        reads = line.partition(":")[0] in made_of
    elif reads:
        files.add(line.strip())
paths = {(build / file).resolve() for file in files}
needed = {path.relative_to(root) for path in paths
          if path.is_relative_to(root) and not path.is_relative_to(build) and path.is_file()}
assert len(needed) > 300, len(needed)
missing = sorted(str(path) for path in needed if not (unpacked / path).is_file())
assert not missing, f"expected them in the archive of the sources, found them missing: {missing}"
print(f"the archive has all {len(needed)} files that compile the module")
PYTHON

cd "$unpacked"
quietly cmake -S . -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPython3_EXECUTABLE="$(command -v "$python")" \
  -DCIRCUMSPECT_QUICK_BUILD=ON -DCIRCUMSPECT_BUILD_PYTHON=ON -DCIRCUMSPECT_BUILD_TESTS=OFF -DCIRCUMSPECT_PYTHON_COMMAND=ON
[ "${3:-}" = --build ] || exit 0
quietly "$python" -m venv --system-site-packages "$work/clean"
quietly "$work/clean/bin/python" -m pip install --no-build-isolation "$work"/archives/*.tar.gz
cd "$work"
"$work/clean/bin/python" -c 'import circumspect; print(circumspect.check([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]))'
