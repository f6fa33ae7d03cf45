#!/bin/bash
# Installs the Debian packages that a purpose needs and that are missing:
#   cmake/packages.sh
#   build|demo|verified|docs|proofs|test|coverage|mutants|browser|web|wheel|rust|deb|ports|hunt
#   |windows|bench...
# When nothing is missing it touches neither the network nor the system. A|B is the first of the two
# that this release of Debian has; with a question mark behind it, what it does not have is left
# out.
set -euo pipefail

# Whatever compiles the command compiles it with these.
libraries() {
  cat <<'END'
cmake                 configures the build
ninja-build           runs the build
libgmp-dev            exact integers and rationals
libmpfr-dev           correctly rounded decimals
libexpected-dev       a value, or why there is none (tl::expected)
libcli11-dev          command-line arguments
libfmt-dev            formatted text
nlohmann-json3-dev    JSON
libpugixml-dev        XML, in which VTK writes meshes
zlib1g-dev            their compressed arrays
libzstd-dev           files that zstd packed
liblzma-dev           arrays that LZMA compressed, in files of VTK
libcadical-dev        decides whether a triangulation exists (a SAT solver)
libcgal-dev           exact intersections (its LGPL kernel); in tests, a second opinion
libtbb-dev            threads of the fast judge (oneTBB)
libboost-dev          spatial indexes, and headers that CGAL includes
END
}

needed_for() {
  case "$1" in
    build) cat <<'END'
g++                   compiles the command
END
      libraries
      ;;
    demo) cat <<'END'
clang                 compiles the command in half the time, since nothing is optimized
tetgen                a program to put to the test, at the end of the demonstration
END
      libraries
      ;;
    test) cat <<'END'
doctest-dev           runs the tests
librapidcheck-dev     tries properties on random arguments
tetgen                a program to put to the test
libtet1.5-dev         TetGen as a function, put to the test
libqhull-dev          Qhull as a function, put to the test
qhull-bin             Qhull as a program, run again on what it was wrong on
libopenmpi-dev        compiles circumspect-mpi
openmpi-bin           starts its ranks
topcom                a second opinion on the number of triangulations, in tests only
pkg-config            tests the installed circumspect.pc
clang-format-14?      checks the layout of the sources, which is that of this version
clang                 compiles the fuzz targets
libclang-rt-14-dev|libclang-rt-dev  libFuzzer and Clang's sanitizers
python3-dev           compiles the Python module (the file Python.h)
python3-numpy         arrays, which the Python package takes
python3-setuptools    makes a wheel of it (PEP 517)
python3-wheel         the same
python3-build         the same, from the command line
python3-pip           installs the wheel into a clean environment
python3-venv          makes that environment
python3-pytest        runs the tests of the Python package, and has its plugin
python3-hypothesis    draws inputs by its strategies
python3-scipy         its Delaunay triangulations are judged in memory
python3-matplotlib    the same of its triangulations of the plane
python3-meshio        reads meshes for `python3 -m circumspect`
ccache                makes a second build quick
mold                  links the tests quickly
nodejs                bundles what the pages of --html are made of
npm                   fetches the modules for that, as package-lock.json names them
END
      ;;
    coverage) cat <<'END'
llvm                  says which lines and arms of conditions the tests run
END
      ;;
    mutants) cat <<'END'
python3-clang-14|python3-clang  finds the places that mutants change
END
      ;;
    browser) cat <<'END'
chromium              opens the pages of --html as their readers do
END
      ;;
    web) cat <<'END'
emscripten            compiles the command for browsers (WebAssembly)
dpkg-dev              unpacks the sources of GMP and MPFR, which are compiled for them as well
make                  compiles these
gcc                   compiles programs that make tables for GMP
chromium              opens the page as its readers do
nodejs                bundles the page, and runs its tests
npm                   fetches the modules for that, as package-lock.json names them
END
      ;;
    wheel) cat <<'END'
g++                   compiles the Python module
python3-dev           its interface (the file Python.h)
python3-setuptools    makes a wheel of it (PEP 517)
python3-wheel         the same
python3-build         the same, from the command line
python3-venv          makes an environment to install it into
dpkg-dev              unpacks the sources of GMP and MPFR, which are compiled for it as well
m4                    writes GMP's assembly
make                  compiles these
debootstrap           makes the bare Debian in which the wheel is tried
END
      libraries
      ;;
    rust) cat <<'END'
cargo                 compiles the crate
librust-proptest+std-dev  draws from its strategies, in tests
pkg-config            finds the C library
END
      ;;
    verified) cat <<'END'
coq                   checks the proofs and extracts the certificate checker
ocaml-nox             compiles it
libzarith-ocaml-dev   its integers
END
      ;;
    proofs) needed_for verified; cat <<'END'
gappa                 proves the error bounds of the floating-point filters
python3               makes the mutants of certificates; in tests, runs tidy/tidy.py
END
      ;;
    deb) cat <<'END'
debhelper             makes Debian packages
dpkg-dev              the same
fakeroot              the same, for who is not root
dh-python             puts the Python package where Debian's Python looks
pybuild-plugin-pyproject  reads its pyproject.toml
python3-dev           compiles the Python module (the file Python.h)
python3-setuptools    makes a wheel of it
python3-wheel         the same
lintian               looks for faults in the packages
debootstrap           makes the bare Debian in which they are tried (make soak)
END
      ;;
    ports) cat <<'END'
debootstrap           makes the bare Debian in which the project is built
binutils              reads for which machine a program is
END
      ;;
    windows) cat <<'END'
g++-mingw-w64-x86-64-posix  compiles for Windows
libz-mingw-w64-dev    zlib for Windows
dpkg-dev              unpacks the sources of the libraries that Debian has not for Windows
wine64                runs what was compiled
wine                  calls it by its name
END
      ;;
    docs) cat <<'END'
mkdocs-material       makes a site of the pages in docs
python3               checks the links of all pages
END
      ;;
    hunt) cat <<'END'
libboost-dev          Boost.Polygon: this and all below are hunted (hunt)
libgts-dev            GTS
libjts-java           JTS
octave                its delaunay
default-jdk-headless  compiles the adapter of JTS
pkg-config            finds GTS
python3-matplotlib    its triangulation of the plane
python3-netgen        Netgen's mesher of volumes
python3-opencv        Subdiv2D
python3-scipy         its Delaunay triangulations
python3-shapely       GEOS
python3-vtk9          vtkDelaunay2D and vtkDelaunay3D
r-cran-deldir         for R
r-cran-geometry       for R
r-cran-interp         for R
nodejs                runs the libraries that npm installs
npm                   installs them
END
      ;;
    bench) cat <<'END'
tetgen                its own check is timed beside ours, on the meshes that it makes
python3-dev           compiles the Python module (the file Python.h)
python3-scipy         triangulates points, whose meshes are judged in memory
libopenmpi-dev        compiles circumspect-mpi
openmpi-bin           starts its ranks
nodejs                runs the package for npm, if it was built
python3-meshio        reads meshes beside ours
python3-vtk9?         the same
python3-gmsh?         the same
END
      ;;
    *) echo "cmake/packages.sh: unknown purpose '$1'; give build, demo, verified, docs, proofs, test, coverage, mutants, browser, web, wheel, rust, deb, ports, hunt, windows or bench" >&2; exit 2 ;;
  esac
}

list=""
for purpose in "$@"; do
  list+=$(needed_for "$purpose")$'\n'
done

if ! command -v dpkg-query >/dev/null; then
  echo "This is not a Debian system; the build goes on and needs what these packages contain:"
  echo "$list"
  exit 0
fi

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

# Does this release of Debian have it? apt's lists say so, if there are any yet.
is_known() {
  apt-cache policy "$1" 2>/dev/null | grep 'Candidate: [^(]' >/dev/null
}

# name_missing PACKAGE WHY
name_missing() {
  [ ${#missing[@]} -gt 0 ] || echo "Missing packages, which are installed now:"
  printf '  %-20s  %s\n' "${1%%|*}" "$2"
  missing+=("$1")
}

missing=()
if_known=()
while read -r package why; do
  [ -n "$package" ] || continue
  # Node that is not Debian's has npm in it, and Debian's npm does not go with it.
  if [ "$package" = npm ] && command -v npm >/dev/null; then continue; fi
  for one in $(tr '|' ' ' <<<"${package%\?}"); do
    if is_installed "$one"; then continue 2; fi
  done
  if [[ $package != *\? ]]; then
    name_missing "$package" "$why"
  elif is_known "${package%\?}"; then
    name_missing "${package%\?}" "$why"
  else
    if_known+=("${package%\?}")
  fi
done <<<"$list"
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "error: installing packages needs root or sudo. As root, run:" >&2
    echo "  apt-get update && apt-get install -y --no-install-recommends ${missing[*]%%|*}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
     apt-get -q -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300)
"${apt[@]}" update
chosen=()
for package in "${missing[@]}"; do
  name=${package%%|*}
  for one in $(tr '|' ' ' <<<"$package"); do
    if is_known "$one"; then name=$one; break; fi
  done
  chosen+=("$name")
done
for package in ${if_known[@]+"${if_known[@]}"}; do
  if is_known "$package"; then chosen+=("$package"); fi
done
"${apt[@]}" install -y --no-install-recommends "${chosen[@]}"
