#!/bin/bash
# Builds the wheel, installs it into a clean virtual environment, and judges there as a stranger
# would:
#   python/wheel_test.sh BUILD [PYTHON]
# BUILD has the module circumspect_python, as build/release has.
set -euo pipefail

build=$(realpath "${1:?usage: python/wheel_test.sh BUILD [PYTHON]}")
python=${2:-python3}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

quietly() {
  "$@" >"$work/log" 2>&1 || { cat "$work/log"; echo "wheel_test: failed: $*" >&2; exit 1; }
}

# What setuptools leaves behind it leaves in a copy.
mkdir "$work/sources"
cp -r "$root/python" "$root/pyproject.toml" "$root/setup.py" "$root/README.md" "$root/LICENSE" "$root/CMakeLists.txt" \
  "$work/sources/"
mkdir -p "$work/sources/cmake" "$work/sources/oracle/picture/page"
cp "$root/cmake/licences.sh" "$work/sources/cmake/"
cp "$root/oracle/picture/page/page.built.html" "$work/sources/oracle/picture/page/"
export CIRCUMSPECT_BUILD=$build
unset PYTHONPATH  # what is installed is asked, and nothing else
cd "$work/sources"
quietly "$python" -m build --wheel --no-isolation --outdir "$work/wheels" .
quietly "$python" -m venv --system-site-packages --without-pip "$work/clean"
quietly "$python" -m pip --python "$work/clean/bin/python" install --no-index --no-deps "$work"/wheels/*.whl

# As the first page of the documentation says, where another python3 comes first on the path, as
# pyenv and conda put theirs.
line=$(grep -o '`[^`]*pip install --no-build-isolation \.`' "$root/README.md" | tr -d '`')
mkdir "$work/other"
printf '#!/bin/sh\necho "this python3 has no packages" >&2\nexit 1\n' >"$work/other/python3"
chmod +x "$work/other/python3"
PATH=$work/other:$PATH quietly bash -c "$line"
env/bin/python -c 'import circumspect; circumspect.assert_delaunay([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])'

cd "$work"
"$work/clean/bin/python" - <<'PYTHON'
import importlib.metadata
import pathlib
import re

import circumspect
import scipy.spatial

assert pathlib.Path(circumspect.__file__).is_relative_to(pathlib.Path.cwd() / "clean"), circumspect.__file__
assert importlib.metadata.version("circumspect") == circumspect.__version__
files = {file.name for file in importlib.metadata.files("circumspect")}
assert {"py.typed", "_core.pyi", "__main__.py"} <= files, files
licences = {file.name for file in importlib.metadata.files("circumspect") if "licences" in file.parts}
assert {"libgmp-dev", "libmpfr-dev", "libcgal-dev", "libfmt-dev", "nlohmann-json3-dev", "GPL-3", "LGPL-3", "three.js"} <= licences, licences
assert "LICENSE" in files, files
scripts = {point.name: point.value for point in importlib.metadata.distribution("circumspect").entry_points
           if point.group == "console_scripts"}
assert set(scripts) == {"circumspect", "circumspect-verified"}, scripts
about = importlib.metadata.metadata("circumspect")
relative = re.findall(r"\]\((?!https://)[^)]*\)", about.get_payload() or about["Description"])
assert not relative, f"expected links that an index can follow, found {relative}"
assert about["Requires-Python"] == ">=3.11" and len(about.get_all("Classifier")) > 8, about.items()
assert "circumspect.pytest_plugin" in {point.value for point in importlib.metadata.entry_points(group="pytest11")}
print(circumspect.check(scipy.spatial.Delaunay(circumspect.generate("uniform", points=100))))
PYTHON
ls -l "$work"/wheels/*.whl | awk '{ printf "%s: %.1f MB\n", $NF, $5 / 1e6 }' | sed 's|.*/||'
