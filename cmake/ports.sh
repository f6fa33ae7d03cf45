#!/bin/bash
# Builds where the project was not developed, and judges there:
#   cmake/ports.sh FOLDER
# In FOLDER/trixie it makes a bare Debian 13, runs the words of README.md's section "Install" there,
# and holds what the command prints to the golden bytes. For arm64 it makes the archive, whose
# command judges under qemu; for s390x, whose bytes are in the other order, the command alone; then
# the Debian packages for arm64, which it installs. Those and the archive are then in FOLDER/arm64.
# FOLDER/ccache is kept, so that a second time is short. Needs root, debootstrap and the network;
# MIRROR names another mirror, and ROOT an existing Debian 13 to be used instead, which is kept.
# PARTS names some of debian-13 arm64 s390x arm64-packages; the others need what the first makes.
set -euo pipefail

mkdir -p "${1:?usage: cmake/ports.sh FOLDER}"
folder=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mirror=${MIRROR:-http://deb.debian.org/debian}
commit=$(git -C "$here" describe --always --abbrev=12 --exclude='*' --dirty=-modified 2>/dev/null || echo unknown)
epoch=${SOURCE_DATE_EPOCH:-$(git -C "$here" log -1 --format=%ct 2>/dev/null || stat -c %Y "$here/CHANGELOG.md")}
root=${ROOT:-$folder/trixie}
parts=${PARTS:-debian-13 arm64 s390x arm64-packages}
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
  echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io"  # no fsync for each file of a root that goes
fi

# Mounts end with the process that needs them.
inside() {
  mkdir -p "$folder/ccache" "$root/ccache"
  unshare --mount --propagation private bash -c \
    'mount -t proc proc "$0/proc" && mount --bind "$1" "$0/ccache" && exec chroot "$0" env -i HOME=/root LANG=C.UTF-8 \
     CCACHE_DIR=/ccache PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive JOBS="$3" SOURCE_DATE_EPOCH="$4" \
     CIRCUMSPECT_COMMIT="$5" bash -euc "$2"' \
    "$root" "$folder/ccache" "cd /root/circumspect; $1" "${JOBS:-$(nproc)}" "$epoch" "$commit"
}

# Of a root that is kept, the build stays, and no source that has gone since.
mkdir -p "$root/root/circumspect"
find "$root/root/circumspect" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
tar -C "$here" --exclude=./build --exclude=./.git -c . | tar -C "$root/root/circumspect" -x
step "installing what README.md takes for granted, and what only this test needs" inside \
  'apt-get -q update && apt-get install -q -y --no-install-recommends make ccache python3'

# archive_for ARCHITECTURE GNU [ARGUMENT…]: build/ARCHITECTURE, configured with ARGUMENT, has the
# command, linked without any shared library, and build/dist what cmake/dist.sh makes of it.
archive_for() {
  local processor=${2%%-*}
  cat >"$root/root/circumspect/build/$1.cmake" <<END
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR $processor)
set(CMAKE_CXX_COMPILER $2-g++)
set(CMAKE_LIBRARY_ARCHITECTURE $2)
END
  step "the archive for $1" inside \
    "cmake -S . -B build/$1 -G Ninja -DCMAKE_TOOLCHAIN_FILE=\$PWD/build/$1.cmake -DCMAKE_BUILD_TYPE=RelWithDebInfo \
       -DCIRCUMSPECT_QUICK_BUILD=ON -DCIRCUMSPECT_STATIC=ON -DCIRCUMSPECT_BUILD_TESTS=OFF -DCMAKE_CXX_FLAGS=-ffile-prefix-map=\$PWD=. \
       -DCIRCUMSPECT_WRITES_PAGES=\$PWD/build/release/bin/circumspect -DCIRCUMSPECT_COMMIT=\$CIRCUMSPECT_COMMIT ${*:3} &&
     cmake --build build/$1 --target circumspect_cli -j \$JOBS &&
     EMULATOR=qemu-$processor cmake/dist.sh build/$1 build/dist"
  step "no fused multiply-add where the filters' bounds forbid it" inside \
    "cmake/contraction_test.sh --archives $2-objdump build/$1/libcircumspect_*.a"
}

# judges COMMAND MACHINE PROCESSOR ROWS…: COMMAND is for MACHINE, by readelf's word, and prints the
# golden bytes.
judges() {
  local machine
  machine=$(readelf -h "$root$1" | sed -n 's/ *Machine: *//p')
  [ "$machine" = "$2" ] || fail "expected a command for $2 in $1, found one for $machine"
  # shellcheck disable=SC2016
  printf '#!/bin/sh\nexec qemu-%s %s "$@"\n' "$3" "$1" >"$root/root/circumspect/build/by-qemu"
  chmod +x "$root/root/circumspect/build/by-qemu"
  step "the golden bytes of $1 on $3" inside \
    "CIRCUMSPECT_ONE_INPUT_IN=${ONE_INPUT_IN:-4} python3 corpus/golden.py build/by-qemu ${*:4}"
  tail -n 1 "$log"
}

debian-13() {
  step "make" inside 'make JOBS=$JOBS'
  # This compiler sees references to what is gone, which the one of Debian 12 does not.
  if grep -m 1 -F -e -Wdangling "$log" >&2; then fail "expected no reference that dangles"; fi
  inside 'build/release/bin/circumspect --version'
  step "the golden bytes, one report in four" inside \
    'CIRCUMSPECT_ONE_INPUT_IN=4 python3 corpus/golden.py build/release/bin/circumspect'
  tail -n 1 "$log"
}

compiler_for_arm64() {
  local libraries
  libraries=$(for name in gmp mpfr cadical pugixml tbb fmt cgal boost; do printf 'lib%s-dev:arm64 ' $name; done)
  step "installing what compiles for arm64, and qemu" inside \
    "dpkg --add-architecture arm64 && apt-get -q update &&
     apt-get install -q -y --no-install-recommends g++-aarch64-linux-gnu zlib1g-dev:arm64 libzstd-dev:arm64 liblzma-dev:arm64 $libraries qemu-user"
}

# What was made is asked where it was unpacked.
arm64() {
  compiler_for_arm64
  archive_for arm64 aarch64-linux-gnu -DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2  # strip would take -g away again
  cp "$root"/root/circumspect/build/dist/*-aarch64.tar.gz "$folder/arm64/"
  inside 'rm -rf /root/arm64 && mkdir /root/arm64 && tar -C /root/arm64 --strip-components=1 -xzf build/dist/*-aarch64.tar.gz'
  [ -f "$root/root/arm64/share/man/man1/circumspect-check.1" ] || fail "expected man pages in the archive for arm64"
  judges /root/arm64/bin/circumspect AArch64 aarch64
}

# Nobody is given this one. The filters are optimized all the same, and the rest compiles in less
# time. Archives and headers are unpacked beside the cross-compiler's own C library. To install them
# takes one of the same version as amd64's, and zlib's has to be: a mirror may lack either.
s390x() {
  step "installing what compiles for s390x, and qemu" inside \
    'dpkg --add-architecture s390x && sed "s/^deb /deb-src /" /etc/apt/sources.list >/etc/apt/sources.list.d/sources.list &&
     apt-get -q update && apt-get install -q -y --no-install-recommends g++-s390x-linux-gnu dpkg-dev qemu-user &&
     rm -rf build/for-s390x && mkdir -p build/for-s390x && cd build/for-s390x &&
     apt-get download lib{gmp,mpfr,cadical,pugixml,fmt,zstd,cgal}-dev:s390x &&
     for package in *.deb; do dpkg-deb -x "$package" /; done &&
     apt-get source -q --download-only --tar-only zlib && mkdir zlib && tar -C zlib --strip-components=1 -xf zlib_*.orig.tar.*'
  step "zlib for s390x, from its sources" inside \
    'cd build/for-s390x/zlib &&
     CHOST=s390x-linux-gnu ./configure --static && make libz.a &&
     cp libz.a /usr/lib/s390x-linux-gnu/ && cp zconf.h /usr/include/s390x-linux-gnu/'
  archive_for s390x s390x-linux-gnu -DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1
  judges /root/circumspect/build/s390x/bin/circumspect "IBM S/390" s390x --one-in 8
}

arm64-packages() {
  compiler_for_arm64
  step "installing what makes Debian packages" inside \
    'apt-get install -q -y --no-install-recommends build-essential debhelper dpkg-dev fakeroot lintian'
  step "the Debian packages for arm64" inside \
    'WRITES_PAGES=$PWD/build/release/bin/circumspect cmake/deb.sh build/deb arm64'
  cp "$root"/root/circumspect/build/deb/*_arm64.deb "$folder/arm64/"
  step "installing the Debian packages for arm64" inside \
    'apt-get install -q -y --no-install-recommends ./build/deb/circumspect_*_arm64.deb ./build/deb/libcircumspect{0,-dev}_*_arm64.deb'
  judges /usr/bin/circumspect AArch64 aarch64 --one-in 8
  step "a C program on arm64" inside \
    'aarch64-linux-gnu-gcc -o build/judge examples/c/check.c -lcircumspect -lm && qemu-aarch64 build/judge'
  grep -q "^delaunay.facet-not-local: vertex 3 in a ball of squared radius 1/2" "$log" || fail "expected a witness from C on arm64"
}

# Of one commit: those of another would be taken for its own.
[ "$(cat "$folder/arm64/COMMIT" 2>/dev/null)" = "$commit" ] || rm -rf "$folder/arm64"
mkdir -p "$folder/arm64"
echo "$commit" >"$folder/arm64/COMMIT"
for part in $parts; do
  declare -F "$part" >/dev/null || fail "expected debian-13, arm64, s390x or arm64-packages in PARTS, found $part"
  "$part"
done
echo "ports: passed: $parts"
