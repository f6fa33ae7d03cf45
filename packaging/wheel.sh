#!/bin/bash
# Makes the wheel that needs nothing but Python and NumPy, on any Linux that is new enough:
#   packaging/wheel.sh FOLDER VERIFIED [PYTHON…]
# FOLDER/dist has then the archive of the sources, and a wheel for each PYTHON (default:
# /usr/bin/python3): one of 3.11 or later serves all that come after 3.11. The command and VERIFIED,
# circumspect-verified linked with the C library alone, are in it. The wheel's tag names the oldest
# glibc that has all that is asked of it. FOLDER/libraries and FOLDER/build are kept. The same
# sources make the same bytes.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
mkdir -p "${1:?usage: packaging/wheel.sh FOLDER VERIFIED [PYTHON…]}"
folder=$(realpath "$1")
verified=$(realpath "${2:?usage: packaging/wheel.sh FOLDER VERIFIED [PYTHON…]}")
shift 2
[ $# -gt 0 ] || set -- /usr/bin/python3
LARGEST=6000000  # bytes of a wheel

fail() {
  echo "packaging/wheel.sh: $1" >&2
  exit 1
}

quietly() {
  "$@" >"$folder/log" 2>&1 || { tail -n 40 "$folder/log" >&2; fail "failed: $*"; }
}

# What setuptools leaves behind it leaves in a copy. A wheel has the modes of what it is made of:
# these are nobody's own, and anybody may read what root installs.
umask 022
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
tar -C "$root" --exclude=./build --exclude=./.git -c . | tar -C "$copy" -x
chmod -R u+rwX,go=rX "$copy"
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct 2>/dev/null || stat -c %Y "$root/CHANGELOG.md")}
rm -rf "$folder/dist"
mkdir -p "$folder/dist"
cd "$copy"
quietly /usr/bin/python3 -m build --sdist --no-isolation --outdir "$copy/made" "$copy"
# setuptools tells of when and by whom; the archive of `make dist` does not, either.
"$here/same_bytes.sh" "$copy"/made/*.tar.gz "$folder/dist"
[ -z "${CIRCUMSPECT_ONLY_SOURCES:-}" ] || exit 0

"$here/wheel_libraries.sh" "$folder/libraries"
# Their headers are the system's, from the same sources. CGAL looks for them by names of its own.
gmp=$folder/libraries/lib/libgmp.a gmpxx=$folder/libraries/lib/libgmpxx.a mpfr=$folder/libraries/lib/libmpfr.a
archives=(-DCIRCUMSPECT_gmp_gmpxx="$gmpxx" -DCIRCUMSPECT_gmp_gmp="$gmp" -DCIRCUMSPECT_mpfr_mpfr="$mpfr"
          -DGMPXX_LIBRARIES="$gmpxx" -DGMP_LIBRARY_RELEASE="$gmp" -DGMP_LIBRARY_DEBUG="$gmp" -DMPFR_LIBRARIES="$mpfr")
mkdir -p "$copy/build"
install -m 755 "$verified" "$copy/build/circumspect-verified"
for python in "$@"; do
  # The layers are the same for all; what the last Python left in the cache is not. Functions that
  # nobody calls are left out.
  quietly cmake -S "$root" -B "$folder/build" -G Ninja -U 'Python3_*' -U '_Python3_*' -DPython3_EXECUTABLE="$(command -v "$python")" \
    "${archives[@]}" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCIRCUMSPECT_QUICK_BUILD=ON \
    -DCIRCUMSPECT_STATIC=ON -DCIRCUMSPECT_SMALL=ON -DCIRCUMSPECT_BUILD_PYTHON=ON -DCIRCUMSPECT_PYTHON_COMMAND=ON \
    -DCIRCUMSPECT_BUILD_TESTS=OFF -DCIRCUMSPECT_INSTALL=OFF -DCIRCUMSPECT_ZSTD=OFF -DCIRCUMSPECT_LZMA=OFF \
    -DCMAKE_CXX_FLAGS="-ffile-prefix-map=$root=. -ffunction-sections -fdata-sections" \
    -DCMAKE_MODULE_LINKER_FLAGS="-L$folder/libraries/lib -Wl,--gc-sections -static-libstdc++"
  rm -f "$folder"/build/python/circumspect/_core.*.so
  cmake --build "$folder/build" --target circumspect_python -j "${JOBS:-$(nproc)}"

  extension=$(echo "$folder"/build/python/circumspect/_core.*.so)
  needed=$(readelf -d "$extension" "$verified" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' | sort -u | tr '\n' ' ')
  for library in $needed; do
    case $library in
      libc.so.* | libm.so.* | libgcc_s.so.* | libstdc++.so.* | ld-linux-*) ;;
      *) fail "expected a wheel that needs the C library alone, found that it needs $library" ;;
    esac
  done
  if grep -qF "$root/" "$extension" "$verified"; then fail "expected nothing of where the sources lie in $extension, found $root"; fi
  glibc=$({ readelf -V "$extension" "$verified" | grep -o 'GLIBC_2\.[0-9]*'; echo GLIBC_2.17; } | sort -uV | tail -n 1)
  glibc=${glibc#GLIBC_}
  grep -q "glibc $glibc or later" "$root/docs/python.md" ||
    fail "expected a wheel for the glibc that docs/python.md names, found that it needs $glibc"
  CIRCUMSPECT_BUILD=$folder/build CIRCUMSPECT_VERIFIED=$copy/build/circumspect-verified \
    CIRCUMSPECT_PLATFORM=manylinux_${glibc/./_}_$(uname -m) \
    quietly "$python" -m build --wheel --no-isolation --outdir "$folder/dist" "$copy"
  echo "for $("$python" --version): needs $needed"
done
for wheel in "$folder"/dist/*.whl; do
  private=$(/usr/bin/python3 -c 'import sys, zipfile
print(*[file.filename for file in zipfile.ZipFile(sys.argv[1]).infolist() if file.external_attr >> 16 & 0o044 != 0o044])' "$wheel")
  [ -z "$private" ] || fail "expected a wheel that anybody may read, found otherwise: $private"
  size=$(stat -c %s "$wheel")
  awk -v name="${wheel##*/}" -v size="$size" 'BEGIN { printf "%s: %.1f MB\n", name, size / 1e6 }'
  [ "$size" -le $LARGEST ] || fail "expected a wheel of at most $LARGEST bytes, found $size"
done
