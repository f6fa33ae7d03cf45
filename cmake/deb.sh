#!/bin/bash
# Builds the Debian packages, and has lintian look at them:
#   cmake/deb.sh FOLDER [ARCHITECTURE]
# The packages, and the copy of the sources that they are built in, are then in FOLDER, such as
# build/deb. For another ARCHITECTURE, such as arm64, there is no Python package, and WRITES_PAGES
# names a circumspect of this machine, which writes the man pages.
set -euo pipefail

folder=${1:?usage: cmake/deb.sh FOLDER [ARCHITECTURE]}
architecture=${2:-$(dpkg --print-architecture)}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
version=$(sed -n 's/^project(circumspect VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
packed=$(dpkg-parsechangelog -l "$root/debian/changelog" -S Version)
if [ "${packed%-*}" != "$version" ]; then
  echo "debian/changelog: expected an entry for version $version, found $packed; add one at its top" >&2
  exit 1
fi
rm -rf "$folder"
mkdir -p "$folder/circumspect-$version"
folder=$(realpath "$folder")
sources=$folder/circumspect-$version
tar -C "$root" --exclude=./build --exclude=./.git -c . | tar -C "$sources" -x
cd "$sources"
# debhelper has another home, in which there is no cache of what was compiled before.
export CCACHE_DIR=${CCACHE_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/ccache}
# Debian's own programs and no others that stand before them, as another Python.
export PATH=/usr/sbin:/usr/bin:/sbin:/bin
# Without packages of symbols, what -g adds would be stripped again.
export DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-} noautodbgsym" DEB_CXXFLAGS_STRIP=-g
# The copy is no repository, and `circumspect --version` says of which commit it is.
export CIRCUMSPECT_COMMIT=${CIRCUMSPECT_COMMIT:-$(git -C "$root" describe --always --dirty=-modified --abbrev=12 --exclude='*' 2>/dev/null || true)}
how=(--build=binary --no-sign --jobs="${JOBS:-$(nproc)}")
if [ "$architecture" != "$(dpkg --print-architecture)" ]; then
  export DEB_BUILD_OPTIONS="$DEB_BUILD_OPTIONS nocheck"
  how+=(--host-arch "$architecture" --build-profiles=cross,nopython)
fi
dpkg-buildpackage "${how[@]}"
cd "$folder"  # lintian cannot begin in a folder that is gone
rm -rf "$sources"
lintian --fail-on error "$folder"/*.changes
echo "built, in $folder:"
for package in "$folder"/*.deb; do
  case $package in *-dbgsym_*) continue ;; esac
  printf '  %-45s %5.1f MB, installed %5.1f MB\n' "${package##*/}" \
    "$(stat -c %s "$package" | awk '{ print $1 / 1e6 }')" \
    "$(dpkg-deb -f "$package" Installed-Size | awk '{ print $1 / 1e3 }')"
done
