#!/bin/bash
# Makes an archive of the programs for any Linux, which needs nothing but a kernel:
#   cmake/dist.sh BUILD FOLDER [VERIFIED]
# BUILD has been configured with -DCIRCUMSPECT_STATIC=ON and built; VERIFIED is
# circumspect-verified, linked in the same way: without it, the command is alone in the archive.
# FOLDER/circumspect-VERSION-linux-MACHINE.tar.gz holds one folder of that name: the programs, man
# pages and completions, and the licences of all that is in them. EMULATOR runs programs of another
# machine. The same programs make the same bytes.
set -euo pipefail

build=${1:?usage: cmake/dist.sh BUILD FOLDER [VERIFIED]}
folder=${2:?usage: cmake/dist.sh BUILD FOLDER [VERIFIED]}
verified=${3:-}
emulator=${EMULATOR:-}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

fail() {
  echo "cmake/dist.sh: $1" >&2
  exit 1
}

about=$($emulator "$build/bin/circumspect" --version)
version=$(cut -d' ' -f2 <<<"$about")
machine=$(LC_ALL=C readelf -h "$build/bin/circumspect" 2>/dev/null | sed -n 's/ *Machine: *//p' || true)
case $machine in
  AArch64) machine=aarch64 ;;
  IBM*390) machine=s390x ;;
  *) machine=$(uname -m) ;;
esac
name=circumspect-$version-linux-$machine
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --component command --strip --prefix "$work/$name" >/dev/null
programs=(circumspect)
contents="command"
if [ -n "$verified" ]; then
  install -s "$verified" "$work/$name/bin/circumspect-verified"
  programs+=(circumspect-verified)
  contents="archive"
fi
for program in "${programs[@]}"; do
  if readelf -d "$work/$name/bin/$program" | grep -q NEEDED; then
    fail "$program: expected no shared library behind it; build the command with -DCIRCUMSPECT_STATIC=ON"
  fi
  # Another folder makes the same bytes.
  if grep -qF "$root/" "$work/$name/bin/$program"; then
    fail "$program: expected nothing of where its sources lie, found $root; build it with -ffile-prefix-map=$root=."
  fi
done
cp "$root/LICENSE" "$work/$name/"
"$root/cmake/licences.sh" $contents "$work/$name/licences"
cat >"$work/$name/README.txt" <<END
$about

What is in bin runs where it lies: put it, or links to it, into a folder of PATH.
share has man pages (man -M share/man circumspect), and completions for bash and zsh.

Circumspect's own licence is in LICENSE, those of the libraries that are linked into the programs are in licences/.
GMP, MPFR, CGAL, OCaml's and the C library are under the (L)GPL: "make dist" in Circumspect's sources links the
programs anew, with other versions of them if you like.
END
# The same sources make the same bytes: of times there is only that of the last commit (or
# SOURCE_DATE_EPOCH, as everywhere), of owners none, of modes those that do not depend on a umask,
# and gzip is not told the name and the time.
epoch=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct 2>/dev/null || stat -c %Y "$root/CHANGELOG.md")}
tar -C "$work" --format=gnu --owner=0 --group=0 --numeric-owner --mode=u+rwX,go=rX --sort=name --mtime="@$epoch" \
  -cf - "$name" | gzip -9n >"$folder/$name.tar.gz"
ls -l "$folder/$name.tar.gz" | awk '{ printf "%s: %.1f MB\n", $NF, $5 / 1e6 }'
