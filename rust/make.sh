#!/bin/bash
# Builds the C library, shared and as an archive, and tests the crate against both:
#   rust/make.sh FOLDER
# The libraries are then in FOLDER/shared and FOLDER/static.
set -euo pipefail
mkdir -p "${1:?usage: rust/make.sh FOLDER}"
folder=$(realpath "$1")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
for kind in shared static; do
  cmake -S "$root" -B "$folder/$kind-build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCIRCUMSPECT_QUICK_BUILD=ON \
    -DBUILD_SHARED_LIBS=$([ $kind = shared ] && echo ON || echo OFF) -DCIRCUMSPECT_BUILD_TESTS=OFF \
    -DCIRCUMSPECT_BUILD_COMMAND=OFF >"$folder/$kind.log" || { cat "$folder/$kind.log"; exit 1; }
  cmake --build "$folder/$kind-build" --target circumspect_archive -j "${JOBS:-$(nproc)}"
  cmake --install "$folder/$kind-build" --component harness --prefix "$folder/$kind" >/dev/null
  echo "the crate, with the C library $kind"
  CIRCUMSPECT_STATIC=$([ $kind = static ] && echo 1 || echo 0) "$root/rust/test.sh" "$folder/$kind"
done
