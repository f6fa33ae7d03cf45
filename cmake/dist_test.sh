#!/bin/bash
# Is the archive of `make dist` the same, byte for byte, whoever makes it and when?
#   cmake/dist_test.sh
# Instead of the command, which takes minutes to link, a script that knows its version is packed;
# instead of circumspect-verified a program that does nothing.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo 'int main(void) { return 0; }' | cc -static -x c -o "$work/verified" -

# made_by FOLDER UMASK [TEXT]: builds a command that has TEXT in it, packs it under this umask, and
# prints the archive's checksum.
made_by() {
  (
    umask "$2"
    build=$work/$1/build
    mkdir -p "$build/bin" "$build/share"
    printf '#!/bin/sh\necho circumspect 1.2.3\n# %s\n' "${3:-}" >"$build/bin/circumspect"
    chmod +x "$build/bin/circumspect"
    echo 'a page' >"$build/share/page"
    cat >"$build/cmake_install.cmake" <<END
file(INSTALL DESTINATION "\${CMAKE_INSTALL_PREFIX}/bin" TYPE PROGRAM FILES "$build/bin/circumspect")
file(INSTALL DESTINATION "\${CMAKE_INSTALL_PREFIX}/share" TYPE FILE FILES "$build/share/page")
END
    "$here/dist.sh" "$build" "$work/$1/dist" "$work/verified" >"$work/$1/said" 2>&1
    sha256sum <"$(echo "$work/$1"/dist/circumspect-1.2.3-linux-*.tar.gz)"
  )
}

first=$(made_by first 022)
sleep 1.1 # the next second, for gzip and tar
second=$(made_by second 077)
if [ "$first" != "$second" ]; then
  echo "cmake/dist_test.sh: expected the same archive twice, found $first and $second" >&2
  exit 1
fi
# Nor does where the sources lie change it.
if made_by third 022 "$(dirname "$here")/command/main.cpp" >"$work/third.sum" 2>&1 || ! grep -q "expected nothing of where" "$work/third/said"; then
  echo "cmake/dist_test.sh: expected that a command with the folder of its sources in it is refused" >&2
  exit 1
fi
