#!/bin/bash
# Makes an archive of the command for any Linux, which needs nothing but a kernel:
#   cmake/dist.sh BUILD FOLDER
# BUILD has been configured with -DCIRCUMSPECT_STATIC=ON and built. FOLDER/circumspect-VERSION-linux-MACHINE.tar.gz
# holds one folder of that name: the command, its man pages and completions, and the licences of all that is in it.
set -euo pipefail

build=${1:?usage: cmake/dist.sh BUILD FOLDER}
folder=${2:?usage: cmake/dist.sh BUILD FOLDER}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

fail() {
  echo "cmake/dist.sh: $1" >&2
  exit 1
}

version=$("$build/bin/circumspect" --version | cut -d' ' -f2)
name=circumspect-$version-linux-$(uname -m)
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --component command --strip --prefix "$work/$name" >/dev/null
if readelf -d "$work/$name/bin/circumspect" | grep -q NEEDED; then
  fail "$build/bin/circumspect: expected no shared library behind it; configure with -DCIRCUMSPECT_STATIC=ON"
fi
cp "$root/LICENSE" "$work/$name/"
mkdir "$work/$name/licences"
# What is linked in, or whose headers are. Debian says of each who wrote it and under which licence.
for package in libgmp-dev libmpfr-dev libcgal-dev libcadical-dev libcli11-dev libexpected-dev libfmt-dev \
  nlohmann-json3-dev libpugixml-dev zlib1g-dev libboost1.74-dev libc6-dev libstdc++-12-dev; do
  file=/usr/share/doc/$package/copyright
  if [ -f "$file" ]; then
    cp -L "$file" "$work/$name/licences/$package"
  else
    fail "expected the licence in $file, found none; the archive is made on Debian 12"
  fi
done
cp -r /usr/share/common-licenses/{GPL-2,GPL-3,LGPL-2.1,LGPL-3,Apache-2.0} "$work/$name/licences/"
cat >"$work/$name/README.txt" <<END
$("$work/$name/bin/circumspect" --version)

bin/circumspect runs where it lies: put it, or a link to it, into a folder of PATH. The man pages are found beside
it (man -M share/man circumspect), and share has completions for bash and zsh.

Circumspect's own licence is in LICENSE, those of the libraries that are linked into the command are in licences/.
GMP, MPFR, CGAL and the C library are under the (L)GPL: "make dist" in Circumspect's sources links the command anew,
with other versions of them if you like.
END
# The same sources make the same bytes: of times there is only that of the last commit (or SOURCE_DATE_EPOCH, as everywhere),
# of owners none, of modes those that do not depend on a umask, and gzip is not told the name and the time.
epoch=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct 2>/dev/null || stat -c %Y "$root/CHANGELOG.md")}
tar -C "$work" --format=gnu --owner=0 --group=0 --numeric-owner --mode=u+rwX,go=rX --sort=name --mtime="@$epoch" \
  -cf - "$name" | gzip -9n >"$folder/$name.tar.gz"
ls -l "$folder/$name.tar.gz" | awk '{ printf "%s: %.1f MB\n", $NF, $5 / 1e6 }'
