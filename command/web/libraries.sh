#!/bin/bash
# Compiles for WebAssembly the libraries that Debian does not package for it, from Debian's own
# sources:
#   command/web/libraries.sh FOLDER
# FOLDER/include has their headers, and links to those of the libraries that are headers alone;
# FOLDER/lib has the archives. Neither the package sources of the system nor anything else outside
# FOLDER is changed. A second call does nothing unless this script has changed.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "${1:?usage: command/web/libraries.sh FOLDER}"
folder=$(realpath "$1")
log=$folder/libraries.log
cmp -s "$here/libraries.sh" "$folder/.complete" && exit 0
rm -rf "$folder"/{sources,include,lib,.complete}
mkdir -p "$folder"/{sources,include,lib}
: >"$log"
trap 'status=$?; if [ $status -ne 0 ]; then tail -n 30 "$log"; echo "command/web/libraries.sh failed; $log has it all"; fi >&2' EXIT
source "$here/emscripten.sh"

echo "fetching the sources of GMP, MPFR, zlib, pugixml and CaDiCaL from Debian"
"$here/../../cmake/debian_sources.sh" "$folder" gmp mpfr4 zlib pugixml cadical >>"$log" 2>&1

# The compiler is told nothing of the machine that it runs on.
cross=(--host=none --disable-shared --enable-static --prefix="$folder" CC_FOR_BUILD=gcc)
echo "compiling GMP"
(cd "$folder/sources/gmp"
 mkdir -p doc && touch doc/Makefile.in  # Debian leaves the manual out, whose licence is not free
 parts=(SUBDIRS="mpn mpz mpq mpf printf scanf rand cxx")
 emconfigure ./configure "${cross[@]}" --disable-assembly --enable-cxx CFLAGS=-O3 CXXFLAGS=-O3
 emmake make -j "$(nproc)" "${parts[@]}"
 emmake make "${parts[@]}" install) >>"$log" 2>&1
echo "compiling MPFR"
(cd "$folder/sources/mpfr4"
 emconfigure ./configure "${cross[@]}" --with-gmp="$folder" --disable-thread-safe CFLAGS=-O2
 emmake make -j "$(nproc)" -C src
 emmake make -C src install) >>"$log" 2>&1
echo "compiling zlib, pugixml and CaDiCaL"
(cd "$folder/sources/zlib"
 for file in adler32 compress crc32 deflate infback inffast inflate inftrees trees uncompr zutil; do
   emcc -O2 -c $file.c -o $file.o
 done
 emar rcs "$folder/lib/libz.a" ./*.o
 cp zlib.h zconf.h "$folder/include"
 cd "$folder/sources/pugixml"
 em++ -O2 -fwasm-exceptions -c src/pugixml.cpp -o pugixml.o
 emar rcs "$folder/lib/libpugixml.a" pugixml.o
 cp src/pugixml.hpp src/pugiconfig.hpp "$folder/include"
 cd "$folder/sources/cadical/src"
 for file in *.cpp; do
   case $file in cadical.cpp | mobical.cpp | ipasir.cpp) continue ;; esac
   echo "$file"
 done | xargs -P "$(nproc)" -I{} em++ -O2 -std=c++14 -fwasm-exceptions -DNBUILD -DNUNLOCKED -DNTRACING -c {} -o {}.o
 emar rcs "$folder/lib/libcadical.a" ./*.o
 cp cadical.hpp "$folder/include") >>"$log" 2>&1

# Headers alone: links, so that nothing else of the system's is seen.
for headers in boost CGAL CLI fmt nlohmann tl; do
  [ -e "/usr/include/$headers" ] || { echo "expected the headers /usr/include/$headers, found none" >&2; exit 1; }
  ln -sfn "/usr/include/$headers" "$folder/include/$headers"
done
cp "$here/libraries.sh" "$folder/.complete"
