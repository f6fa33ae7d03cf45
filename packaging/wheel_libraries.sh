#!/bin/bash
# Compiles GMP and MPFR for shared libraries, which Debian's archives are not, from Debian's
# sources:
#   packaging/wheel_libraries.sh FOLDER
# FOLDER/lib has the archives and FOLDER/include the headers. GMP chooses its code when it runs, so
# that every processor will do. Nothing outside FOLDER is changed. A second call does nothing unless
# this script has changed.
set -euo pipefail
mkdir -p "${1:?usage: packaging/wheel_libraries.sh FOLDER}"
folder=$(realpath "$1")
script=$(realpath "${BASH_SOURCE[0]}")
log=$folder/libraries.log
cmp -s "$script" "$folder/.complete" && exit 0
rm -rf "${folder:?}"/{sources,include,lib,.complete}
mkdir -p "$folder/sources"
: >"$log"
trap 'status=$?; if [ $status -ne 0 ]; then tail -n 30 "$log"; echo "packaging/wheel_libraries.sh failed; $log has it all"; fi >&2' EXIT

echo "fetching the sources of GMP and MPFR from Debian"
"$(dirname "$script")/../cmake/debian_sources.sh" "$folder" gmp mpfr4 >>"$log" 2>&1

echo "compiling GMP and MPFR"
mkdir -p "$folder/sources/gmp/doc" && touch "$folder/sources/gmp/doc/Makefile.in"  # Debian leaves the manual out
own=(--prefix="$folder" --libdir="$folder/lib" --disable-shared --enable-static --with-pic)
(cd "$folder/sources/gmp"
 parts=(SUBDIRS="mpn mpz mpq mpf printf scanf rand cxx")
 ./configure "${own[@]}" --enable-fat --enable-cxx
 make -j "${JOBS:-$(nproc)}" "${parts[@]}"
 make "${parts[@]}" install
 cd "$folder/sources/mpfr4"
 ./configure "${own[@]}" --with-gmp="$folder" --enable-thread-safe
 make -j "${JOBS:-$(nproc)}" -C src
 make -C src install) >>"$log" 2>&1
cp "$script" "$folder/.complete"
