#!/bin/bash
# Makes a bare Debian 12 in a folder, and judges there as strangers would:
#   debian/fresh_root_test.sh PACKAGES ARCHIVE
# ARCHIVE is what `make dist` made: it has to run before anything is installed. PACKAGES is the
# folder in which `make deb` left its packages: the command, a C program, a C++ program and Python
# then judge by them.
set -euo pipefail

packages=$(realpath "${1:?usage: debian/fresh_root_test.sh PACKAGES ARCHIVE}")
archive=$(realpath "${2:?usage: debian/fresh_root_test.sh PACKAGES ARCHIVE}")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$here/packaging/bare_root.sh"
quietly "$here/cmake/packages.sh" deb
make_bare_root bookworm

cp -r "$here/corpus/peers/tetgen" "$here/examples/c" "$here/examples/judge" "$bare/root/"
good=tetgen/random-3d-500.1.ele
bad=tetgen/hunted-tetgen-covered-twice-3d.1.ele

# judges COMMAND WHAT
judges() {
  echo "$2"
  quietly inside "$1 check $good"
  grep -q "^holds: delaunay $good 500 points 3074 tetrahedra unique canonical" "$work/log" || fail "$2: expected a verdict"
  if inside "$1 check $bad" >"$work/log" 2>&1; then fail "$2: expected that $bad fails"; fi
  grep -q "^fails: delaunay $bad triangulation.covered-twice" "$work/log" || fail "$2: expected a witness"
}

tar -C "$bare/root" -xzf "$archive"
folder=$(basename "$archive" .tar.gz)
[ -f "$bare/root/$folder/share/man/man1/circumspect-check.1" ] || fail "expected man pages in the archive"
[ -f "$bare/root/$folder/licences/libgmp-dev" ] || fail "expected licences in the archive"
judges "$folder/bin/circumspect" "the archive, with nothing installed"
quietly inside "$folder/bin/circumspect certify $good -o certificate && $folder/bin/circumspect-verified certificate ${good%.ele}.node $good"
grep -q "^verified: delaunay, 500 points, 3074 tetrahedra, unique, canonical" "$work/log" || fail "expected a verified certificate"

cp "$packages"/*.deb "$bare/root/"
rm -f "$bare"/root/*-dbgsym_*.deb
quietly inside "apt-get install -q -y --no-install-recommends ./*.deb gcc g++ libc6-dev pkg-config man-db"
judges circumspect "the command"
quietly inside "circumspect --version"
grep -q ", commit [0-9a-f]" "$work/log" || fail "expected the commit in: $(cat "$work/log")"
quietly inside "man -w circumspect-check"
quietly inside "test -f /usr/share/bash-completion/completions/circumspect -a -f /usr/share/zsh/vendor-completions/_circumspect"

echo "the C library"
quietly inside 'gcc -o judge-in-c c/check.c $(pkg-config --cflags --libs circumspect-c) && ./judge-in-c'
grep -q "^delaunay.facet-not-local: vertex 3 in a ball of squared radius 1/2" "$work/log" || fail "expected a witness from C"

echo "the C++ archive"
quietly inside 'g++ -std=c++20 -o judge-in-cpp judge/judge_arrays.cpp $(pkg-config --cflags --libs circumspect-check) && ./judge-in-cpp'

echo "Python"
cat >"$bare/root/judge.py" <<'PYTHON'
import circumspect
import numpy

points = numpy.array([[0, 0], [1, 0], [0, 1], [0.9, 0.9]])
print(circumspect.check(points, numpy.array([[0, 1, 3], [0, 3, 2]])))
print(circumspect.check(points, numpy.array([[0, 1, 2], [1, 3, 2]])).rules)
print(circumspect.generate("uniform", points=5).shape)
PYTHON
quietly inside "python3 judge.py"
grep -q "^holds: delaunay mesh 4 points 2 triangles unique canonical" "$work/log" || fail "expected a verdict from Python"
grep -q "^{'delaunay.facet-not-local': 1}" "$work/log" || fail "expected a broken rule from Python"

echo "the tests of the Python package, with VTK itself"
mkdir "$bare/root/python"
cp "$here"/python/{package,domains}_test.py "$bare/root/python/"
quietly inside "apt-get install -q -y --no-install-recommends python3-pytest python3-vtk9"
quietly inside "python3 -m pytest -q -rs -p no:cacheprovider -k 'not pages and not files_of_meshio' python/package_test.py python/domains_test.py"
if grep -q "SKIPPED.*vtk" "$work/log"; then fail "expected data sets of VTK to be judged"; fi

echo "Rust and Octave, as Debian has them"
cp -r "$here/examples/rust" "$here/examples/octave" "$bare/root/"
quietly inside "apt-get install -q -y --no-install-recommends rustc octave octave-dev"
quietly inside "rustc --edition 2021 -l circumspect rust/check.rs && ./check"
grep -q "^refused: expected finite coordinates, found nan" "$work/log" || fail "expected that Rust is told what is wrong"
quietly inside "cd octave && mkoctfile circumspect_check.cc -lcircumspect && octave --quiet check.m"
grep -q "^fails: delaunay mesh delaunay.facet-not-local" "$work/log" || fail "expected a witness in Octave"

quietly inside "dpkg --purge circumspect libcircumspect-dev python3-circumspect libcircumspect0"
left=$(inside "find /usr /etc -name '*circumspect*'")
[ -z "$left" ] || fail "expected nothing to be left, found $left"
echo "fresh_root_test: packages and archive judge in a bare Debian 12"
