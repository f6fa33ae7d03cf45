#!/bin/bash
# Compiles for Windows the libraries that Debian does not package for it, from Debian's sources:
#   cmake/windows_libraries.sh FOLDER
# FOLDER/lib has the archives; FOLDER/include has their headers, and links to those of the libraries
# that are headers alone. Nothing outside FOLDER is changed. A second call does nothing unless this
# script has changed.
set -euo pipefail
mkdir -p "${1:?usage: cmake/windows_libraries.sh FOLDER}"
folder=$(realpath "$1")
script=$(realpath "${BASH_SOURCE[0]}")
log=$folder/libraries.log
machine=x86_64-w64-mingw32
jobs=${JOBS:-$(nproc)}
cmp -s "$script" "$folder/.complete" && exit 0
rm -rf "${folder:?}"/{sources,include,lib,.complete}
mkdir -p "$folder"/{sources,include,lib}
: >"$log"
trap 'status=$?; if [ $status -ne 0 ]; then tail -n 30 "$log"; echo "cmake/windows_libraries.sh failed; $log has it all"; fi >&2' EXIT

echo "fetching the sources of GMP, MPFR, pugixml and CaDiCaL from Debian"
"$(dirname "$script")/debian_sources.sh" "$folder" gmp mpfr4 pugixml cadical >>"$log" 2>&1

echo "compiling GMP and MPFR"
cross=(--host=$machine --prefix="$folder" --libdir="$folder/lib" --disable-shared --enable-static CC_FOR_BUILD=gcc
       CC=$machine-gcc-posix CXX=$machine-g++-posix)
mkdir -p "$folder/sources/gmp/doc" && touch "$folder/sources/gmp/doc/Makefile.in"  # Debian leaves the manual out
(cd "$folder/sources/gmp"
 parts=(SUBDIRS="mpn mpz mpq mpf printf scanf rand cxx")
 ./configure "${cross[@]}" --enable-fat --enable-cxx
 make -j "$jobs" "${parts[@]}"
 make "${parts[@]}" install
 cd "$folder/sources/mpfr4"
 # Without -g, which it adds by itself: the program would tell where it was compiled.
 ./configure "${cross[@]}" --with-gmp="$folder" --enable-thread-safe CFLAGS=-O2
 make -j "$jobs" -C src
 make -C src install) >>"$log" 2>&1

echo "compiling pugixml and CaDiCaL"
flags=(-O2 -fno-ipa-ra)  # cmake/settings.cmake says why
(cd "$folder/sources/pugixml"
 $machine-g++-posix "${flags[@]}" -c src/pugixml.cpp -o pugixml.o
 $machine-ar rcs "$folder/lib/libpugixml.a" pugixml.o
 cp src/pugixml.hpp src/pugiconfig.hpp "$folder/include"
 cd "$folder/sources/cadical/src"
 for file in *.cpp; do
   case $file in cadical.cpp | mobical.cpp | ipasir.cpp) continue ;; esac
   echo "$file"
 done | xargs -P "$jobs" -I{} $machine-g++-posix "${flags[@]}" -D__WIN32 -DNBUILD -DNUNLOCKED -DNTRACING -c {} -o {}.o
 $machine-ar rcs "$folder/lib/libcadical.a" ./*.o
 cp cadical.hpp "$folder/include") >>"$log" 2>&1

# Headers alone: links, so that nothing else of the system's is seen.
for headers in boost CGAL CLI fmt nlohmann tl; do
  [ -e "/usr/include/$headers" ] || { echo "expected the headers /usr/include/$headers, found none" >&2; exit 1; }
  ln -sfn "/usr/include/$headers" "$folder/include/$headers"
done
cp "$script" "$folder/.complete"
