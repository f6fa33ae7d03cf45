#!/bin/bash
# Builds where the project was not developed, and judges there:
#   cmake/ports.sh FOLDER
# In FOLDER/trixie it makes a bare Debian 13, runs the words of README.md's section "Install" there,
# holds what the command prints to the golden bytes, and cross-compiles it for arm64, of which
# nothing is run. FOLDER/ccache is kept, so that a second time is short. Needs root, debootstrap and
# the network; MIRROR names another mirror, and ROOT an existing Debian 13 to be used instead, which
# is kept.
set -euo pipefail

mkdir -p "${1:?usage: cmake/ports.sh FOLDER}"
folder=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mirror=${MIRROR:-http://deb.debian.org/debian}
root=${ROOT:-$folder/trixie}
log=$folder/ports.log
: >"$log"

fail() {
  echo "ports: $1; $log has it all" >&2
  exit 1
}

# step TEXT COMMAND…
step() {
  echo "$1"
  shift
  "$@" >>"$log" 2>&1 || { tail -n 40 "$log" >&2; fail "failed: $*"; }
}

[ "$(id -u)" -eq 0 ] || fail "expected to be root, which chroot needs"
if [ -z "${ROOT:-}" ]; then
  rm -rf --one-file-system "$root"
  step "making a bare Debian 13" debootstrap --variant=minbase trixie "$root" "$mirror"
fi

# Mounts end with the process that needs them.
inside() {
  mkdir -p "$folder/ccache" "$root/ccache"
  unshare --mount --propagation private bash -c \
    'mount -t proc proc "$0/proc" && mount --bind "$1" "$0/ccache" && exec chroot "$0" env -i HOME=/root LANG=C.UTF-8 \
     CCACHE_DIR=/ccache PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive JOBS="$3" bash -euc "$2"' \
    "$root" "$folder/ccache" "cd /root/circumspect; $1" "${JOBS:-$(nproc)}"
}

# Of a root that is kept, the build stays, and no source that has gone since.
mkdir -p "$root/root/circumspect"
find "$root/root/circumspect" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
tar -C "$here" --exclude=./build --exclude=./.git -c . | tar -C "$root/root/circumspect" -x
step "installing what README.md takes for granted, and what only this test needs" inside \
  'apt-get -q update && apt-get install -q -y --no-install-recommends make ccache python3'
step "make" inside 'make JOBS=$JOBS'
inside 'build/release/bin/circumspect --version'
step "the golden bytes, one report in four" inside \
  'CIRCUMSPECT_ONE_INPUT_IN=4 python3 corpus/golden.py build/release/bin/circumspect'
tail -n 1 "$log"

libraries=$(for name in gmp mpfr cadical pugixml tbb fmt cgal boost; do printf 'lib%s-dev:arm64 ' $name; done)
step "installing what compiles for arm64" inside \
  "dpkg --add-architecture arm64 && apt-get -q update &&
   apt-get install -q -y --no-install-recommends g++-aarch64-linux-gnu zlib1g-dev:arm64 $libraries"
cat >"$root/root/circumspect/build/arm64.cmake" <<'END'
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
END
step "cross-compiling for arm64" inside \
  'cmake -S . -B build/arm64 -G Ninja -DCMAKE_TOOLCHAIN_FILE=$PWD/build/arm64.cmake -DCMAKE_BUILD_TYPE=RelWithDebInfo \
     -DCIRCUMSPECT_QUICK_BUILD=ON -DCIRCUMSPECT_BUILD_TESTS=OFF -DCIRCUMSPECT_WRITES_PAGES=$PWD/build/release/bin/circumspect &&
   cmake --build build/arm64 --target circumspect_cli -j "$JOBS" &&
   cmake --install build/arm64 --component command --prefix "$PWD/build/arm64/installed"'
machine=$(readelf -h "$root/root/circumspect/build/arm64/installed/bin/circumspect" | sed -n 's/ *Machine: *//p')
[ "$machine" = AArch64 ] || fail "expected a command for AArch64, found one for $machine"
[ -f "$root/root/circumspect/build/arm64/installed/share/man/man1/circumspect-check.1" ] || fail "expected its man pages"
echo "ports: builds and judges on Debian 13, and compiles for arm64"
